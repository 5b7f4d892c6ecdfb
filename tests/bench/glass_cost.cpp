// bench_glass: CPU time of a frame whose glass is drawn in each form against the same frame with the same surfaces
// opaque, in turn in one process and window.
#include <vtkOpenGLRenderWindow.h>

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
#include "filters/vtk/scene_renderer.h"
#include "tests/bench/exit_status.h"

namespace {

using namespace boxprobe;

struct BenchOptions {
  std::string scene = BOXPROBE_DATA_DIR "/scenes/glass.boxprobe.json";
  std::string camera = "main";
  std::string size = "1280x720";
  int samples = 4;
  int frames = 40;
};

/// A window of its own for each side: both keep their programs.
struct Side {
  Side(const LoadedScene& loaded, const Scene& scene, const BenchOptions& options, const FrameSize& size)
      : window(makeOffscreenWindow(size.width, size.height, options.samples)), renderer(window) {
    renderer.setModels(loaded.models);
    renderer.sync(scene, Changes::all());
    renderer.applyCamera(chooseCamera(scene, options.camera));
    renderer.finishWork();
    frame();
    frame();
  }
  ~Side() { renderer.releaseGraphics(); }
  double frame() {
    const double start = processCpuSeconds();
    window->Render();
    window->WaitForCompletion();
    return processCpuSeconds() - start;
  }
  vtkSmartPointer<vtkOpenGLRenderWindow> window;
  SceneRenderer renderer;
};

void run(const BenchOptions& options) {
  const FrameSize size = parseFrameSize(options.size);
  LoadedScene loaded = loadScene(options.scene);
  requireDisplay("bench_glass");
  installVtkMessages(false, true);
  const auto sceneOf = [&](bool glass, GlassForm form) {
    Scene scene = loaded.scene;
    for (const auto& model : loaded.models) {
      for (const Material& material : model->materials) {
        if (!material.transmits()) continue;
        if (!glass) scene.materials[material.name].transmission = 0.0f;
        scene.materials[material.name].glass = form;
      }
    }
    return scene;
  };
  Side opaque(loaded, sceneOf(false, GlassForm::Automatic), options, size);
  std::printf("%s: %d x %d, %d samples a pixel, %d pairs of frames, CPU milliseconds\n", options.scene.c_str(),
              size.width, size.height, std::max(opaque.window->GetMultiSamples(), 1), options.frames);
  const std::pair<const char*, GlassForm> forms[] = {{"one-pass", GlassForm::OnePass},
                                                     {"two-pass", GlassForm::TwoPass},
                                                     {"two-interface", GlassForm::TwoInterface},
                                                     {"auto", GlassForm::Automatic}};
  for (const auto& [name, form] : forms) {
    Side glass(loaded, sceneOf(true, form), options, size);
    const bench::Samples samples = bench::interleave(
        options.frames, [&] { return glass.frame(); }, [&] { return opaque.frame(); });
    const bench::Ratio ratio = bench::ratioOfMedians(samples);
    const Counters& counters = glass.renderer.counters();
    std::printf("  %-13s %llu objects in %llu passes: %7.2f against %7.2f opaque, ratio %.3f (95 %%: %.3f to %.3f)\n",
                name, static_cast<unsigned long long>(counters.glassDraws),
                static_cast<unsigned long long>(counters.glassPasses), 1e3 * bench::median(samples.a),
                1e3 * bench::median(samples.b), ratio.value, ratio.low, ratio.high);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of a frame with glass, form by form, over the same frame without", "bench_glass");
  BenchOptions options;
  program.add_option("SCENE", options.scene, "Scene file")->capture_default_str();
  program.add_option("--camera", options.camera, "Camera of the scene")->capture_default_str();
  program.add_option("--size", options.size, "Pixels")->capture_default_str();
  program.add_option("--samples", options.samples, "Samples a pixel")->capture_default_str();
  program.add_option("--frames", options.frames, "Pairs of frames")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  CLI11_PARSE(program, argc, argv);
  return exitStatusOf([&] { run(options); });
}
