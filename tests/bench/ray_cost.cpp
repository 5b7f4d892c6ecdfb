// bench_rays: CPU time of what the pointer's move costs in the debug view (a point on the surface, its rays, their new
// picture, the explanation of the pixel) against a frame of the scene without it, in turn in one process and window.
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "app/cli/options/render_options.h"
#include "app/session/display_check.h"
#include "app/session/load_scene.h"
#include "app/session/offscreen_window.h"
#include "app/session/vtk_messages.h"
#include "filters/reference/measure/interleaved.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/rays/ray_layer.h"
#include "filters/vtk/rays/ray_sources.h"
#include "filters/vtk/rays/vtkProjectionRays.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/bench/exit_status.h"

namespace {

using namespace boxprobe;

struct BenchOptions {
  std::string scene = BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json";
  std::string size = "1280x720";
  int samples = 4;
  int frames = 40;
};

void run(const BenchOptions& options) {
  const FrameSize size = parseFrameSize(options.size);
  LoadedScene loaded = loadScene(options.scene);
  requireDisplay("bench_rays");
  installVtkMessages(false, true);
  const auto window = makeOffscreenWindow(size.width, size.height, options.samples);
  SceneRenderer renderer(window);
  renderer.setModels(loaded.models);
  renderer.sync(loaded.scene, Changes::all());
  const Camera camera = chooseCamera(loaded.scene, "");
  renderer.applyCamera(camera);
  renderer.finishWork();

  RaySources sources(loaded.models, loaded.scene);
  const PixelRays pixels(renderer.renderer()->GetActiveCamera(), size.width, size.height);
  vtkNew<vtkProjectionRays> filter;
  filter->SetProbes(loaded.scene.probes);
  filter->SetSceneData(sources.triangles());
  filter->SetEye(camera.position.x, camera.position.y, camera.position.z);
  RayLayer layer(renderer.renderer());

  const auto draw = [&] {
    const double start = processCpuSeconds();
    window->Render();
    window->WaitForCompletion();
    return processCpuSeconds() - start;
  };
  int move = 0;
  double pointerSeconds = 0.0;
  const auto moved = [&](int columns, int rows, bool explain) {
    const double start = processCpuSeconds();
    std::vector<RaySample> samples;
    if (columns == 1) {
      ++move;
      const int x = 100 + 37 * move % (size.width - 200), y = 100 + 23 * move % (size.height - 200);
      if (auto s = sources.under(pixels.through(x, y))) samples.push_back(*s);
      if (explain) renderer.explain(x, y, size.width, size.height);
    } else {
      samples = sources.screenGrid(pixels, columns, rows);
    }
    filter->SetInputData(rayPoints(samples));
    filter->Update();
    layer.setRays(filter->GetOutput());
    pointerSeconds += processCpuSeconds() - start;
  };
  const struct {
    const char* name;
    int columns, rows;
    bool explain;
  } cases[] = {{"one point, the pointer's", 1, 1, false},
               {"the same and its card", 1, 1, true},
               {"a grid of 16 x 9 points", 16, 9, false},
               {"a grid of 40 x 24 points", 40, 24, false}};
  std::printf("%s: %d x %d, %d samples a pixel, %d pairs of frames, CPU milliseconds\n", options.scene.c_str(),
              size.width, size.height, std::max(window->GetMultiSamples(), 1), options.frames);
  for (const auto& c : cases) {
    const auto with = [&] {
      const double start = processCpuSeconds();
      layer.setVisible(true);
      moved(c.columns, c.rows, c.explain);
      draw();
      return processCpuSeconds() - start;
    };
    const auto without = [&] {
      layer.setVisible(false);
      return draw();
    };
    // The first card of each object compiles its program: not part of following the pointer.
    for (int i = 0; i < (c.explain ? 80 : 2); ++i) {
      with();
      without();
    }
    pointerSeconds = 0.0;
    const bench::Samples samples = bench::interleave(options.frames, with, without);
    const bench::Ratio ratio = bench::ratioOfMedians(samples);
    std::printf(
        "  %-26s %6lld lines: %7.2f against %7.2f without, ratio %.3f (95 %%: %.3f to %.3f); of it before "
        "the drawing %.3f\n",
        c.name, static_cast<long long>(filter->GetOutput()->GetNumberOfCells()), 1e3 * bench::median(samples.a),
        1e3 * bench::median(samples.b), ratio.value, ratio.low, ratio.high, 1e3 * pointerSeconds / options.frames);
  }
  layer.setVisible(false);
  renderer.releaseGraphics();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of projection rays that follow the pointer, over a frame without them", "bench_rays");
  BenchOptions options;
  program.add_option("SCENE", options.scene, "Scene file")->capture_default_str();
  program.add_option("--size", options.size, "Pixels")->capture_default_str();
  program.add_option("--samples", options.samples, "Samples a pixel")->capture_default_str();
  program.add_option("--frames", options.frames, "Pairs of frames")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  CLI11_PARSE(program, argc, argv);
  return exitStatusOf([&] { run(options); });
}
