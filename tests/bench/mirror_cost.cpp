// bench_mirrors: CPU time of a frame with planar mirrors over the same frame without, drawn in turn in one process:
// with things moving in their view, with all of them out of it (no picture is drawn, the program looks), and with
// nothing that moves in the scene at all (the programs are those of a scene without mirrors).
#include <vtkOpenGLRenderWindow.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "app/cli/options/render_options.h"
#include "app/session/display_check.h"
#include "app/session/load_scene.h"
#include "app/session/offscreen_window.h"
#include "app/session/vtk_messages.h"
#include "filters/core/base/errors.h"
#include "filters/reference/measure/interleaved.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/bench/exit_status.h"

namespace {

using namespace boxprobe;

struct MirrorBench {
  std::string scene = BOXPROBE_DATA_DIR "/scenes/mirror-hall.boxprobe.json";
  std::string size = "1280x720";
  std::string camera = "main";
  int samples = 4;
  int frames = 30;
};

/// A window of its own with one variant of the scene.
struct Drawn {
  Drawn(const LoadedScene& loaded, const Scene& scene, const MirrorBench& options)
      : window(makeOffscreenWindow(parseFrameSize(options.size).width, parseFrameSize(options.size).height,
                                   options.samples)),
        renderer(window) {
    renderer.setModels(loaded.models);
    renderer.sync(scene, Changes::all());
    renderer.applyCamera(chooseCamera(scene, options.camera));
    renderer.finishWork();
    for (int i = 0; i < 2; ++i) frame();
    if (!renderer.error().empty()) throw WorkError(renderer.error());
  }
  ~Drawn() { renderer.releaseGraphics(); }
  double frame() {
    window->MakeCurrent();
    const double start = processCpuSeconds();
    window->Render();
    window->WaitForCompletion();
    return processCpuSeconds() - start;
  }
  vtkSmartPointer<vtkOpenGLRenderWindow> window;
  SceneRenderer renderer;
};

void compare(const char* what, const LoadedScene& loaded, const Scene& with, const MirrorBench& options) {
  Scene without = with;
  without.mirrors.clear();
  Drawn a(loaded, with, options), b(loaded, without, options);
  const bench::Samples samples = bench::interleave(
      options.frames, [&] { return a.frame(); }, [&] { return b.frame(); });
  const bench::Ratio ratio = bench::ratioOfMedians(samples);
  const MirrorCounters& mirrors = a.renderer.counters().mirrors;
  std::printf(
      "  %-24s %llu pictures, %8llu texels: %7.2f ms against %7.2f ms, ratio %.3f, 95 %% interval %.3f to %.3f\n", what,
      static_cast<unsigned long long>(mirrors.drawn), static_cast<unsigned long long>(mirrors.texels),
      1e3 * bench::median(samples.a), 1e3 * bench::median(samples.b), ratio.value, ratio.low, ratio.high);
}

void run(const MirrorBench& options) {
  const LoadedScene loaded = loadScene(options.scene);
  requireDisplay("bench_mirrors");
  installVtkMessages(false, true);
  std::printf("%s: camera %s, %s, %d samples a pixel, %d pairs of frames, median CPU time\n", options.scene.c_str(),
              options.camera.c_str(), options.size.c_str(), options.samples, options.frames);
  compare("all mirrors", loaded, loaded.scene, options);
  for (const auto& [node, mirror] : loaded.scene.mirrors) {
    Scene one = loaded.scene;
    one.mirrors = {{node, mirror}};
    compare((node + " alone").c_str(), loaded, one, options);
  }
  Scene away = loaded.scene, still = loaded.scene;
  for (auto& [node, object] : away.objects) {
    if (object.dynamic) object.translation.y -= 100.0;
  }
  for (auto& [node, object] : still.objects) object.dynamic = false;
  compare("what moves out of view", loaded, away, options);
  compare("nothing moves", loaded, still, options);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of a frame with planar mirrors over the same frame without", "bench_mirrors");
  MirrorBench options;
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
