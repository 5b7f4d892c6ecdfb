// bench_rays: CPU time of what the pointer's move costs in the debug view (a point on the surface, its rays, their new
// picture, the explanation of the pixel) against a frame of the scene without it, in turn in one process and window.
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <cstdio>
#include <string>

#include "app/cli/options/render_options.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/rays/ray_layer.h"
#include "filters/vtk/rays/ray_sources.h"
#include "filters/vtk/rays/vtkProjectionRays.h"
#include "tests/bench/harness.h"

namespace {

using namespace boxprobe;

void run(const CLI::App& program, const bench::FrameOptions& options) {
  const FrameSize size = parseFrameSize(options.size);
  const LoadedScene loaded = loadScene(options.scene);
  OffscreenScene drawn(windowSettings(program, options));
  bench::prepare(drawn, loaded.scene, loaded.models);
  SceneRenderer& renderer = drawn.renderer();
  const Camera camera = renderer.currentCamera();

  RaySources sources(loaded.models, loaded.scene);
  const PixelRays pixels(renderer.renderer()->GetActiveCamera(), size.width, size.height);
  vtkNew<vtkProjectionRays> filter;
  filter->SetProbes(loaded.scene.probes);
  filter->SetSceneData(sources.triangles());
  filter->SetEye(camera.position.x, camera.position.y, camera.position.z);
  RayLayer layer(renderer.renderer());

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
  bench::printHeader(options, drawn);
  for (const auto& c : cases) {
    const auto with = [&] {
      const double start = processCpuSeconds();
      layer.setVisible(true);
      moved(c.columns, c.rows, c.explain);
      drawn.timedFrame();
      return processCpuSeconds() - start;
    };
    const auto without = [&] {
      layer.setVisible(false);
      return drawn.timedFrame();
    };
    // The first card of each object compiles its program: not part of following the pointer.
    for (int i = 0; i < (c.explain ? 80 : 2); ++i) {
      with();
      without();
    }
    pointerSeconds = 0.0;
    const bench::Comparison result = bench::compare(0, options.frames, with, without);
    std::printf("  %-26s %6lld lines: %7.2f against %7.2f without, %s; of it before the drawing %.3f\n", c.name,
                static_cast<long long>(filter->GetOutput()->GetNumberOfCells()), result.first, result.second,
                result.ratioText().c_str(), 1e3 * pointerSeconds / options.frames);
  }
  layer.setVisible(false);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of projection rays that follow the pointer, over a frame without them", "bench_rays");
  bench::FrameOptions options;
  options.scene = BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json";
  addFrameOptions(program, options);
  return bench::runProgram(program, argc, argv, [&] { run(program, options); });
}
