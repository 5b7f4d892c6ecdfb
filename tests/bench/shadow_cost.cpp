// bench_shadow: CPU time of a frame with a light's shadows by coverage over that of the same frame without, drawn in
// turn in one process and window, and beside it the same light with a shadow map, drawn anew each frame, of everything
// in the scene. CPU time of all threads: software OpenGL draws in this process.
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <CLI/CLI.hpp>
#include <algorithm>
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

struct BenchOptions {
  std::string scene = BOXPROBE_DATA_DIR "/scenes/windows.boxprobe.json";
  std::string size = "1280x720";
  std::string camera;
  int samples = 4;
  int frames = 60;
};

/// A scene in a renderer of its own in the common window.
struct Way {
  Way(const char* n, vtkOpenGLRenderWindow* window, const LoadedScene& loaded, Scene s, const std::string& camera)
      : name(n), scene(std::move(s)), renderer(window) {
    renderer.setModels(loaded.models);
    renderer.sync(scene, Changes::all());
    renderer.applyCamera(chooseCamera(scene, camera));
    renderer.finishWork();
  }
  const char* name;
  Scene scene;
  SceneRenderer renderer;
  bool mapEachFrame = false;
};

void run(const BenchOptions& options) {
  const FrameSize size = parseFrameSize(options.size);
  const LoadedScene loaded = loadScene(options.scene);
  requireDisplay("bench_shadow");
  installVtkMessages(false, true);
  const auto window = makeOffscreenWindow(size.width, size.height, options.samples);
  const auto with = [&](LightShadows shadows) {
    Scene scene = loaded.scene;
    for (Light& light : scene.lights) light.shadows = shadows;
    return scene;
  };
  Scene mapped = with(LightShadows::CoverageAndMap);
  for (const auto& model : loaded.models) {
    for (const Instance& instance : model->instances) mapped.objects[instance.node].dynamic = true;
  }
  Way none("no shadows", window, loaded, with(LightShadows::None), options.camera);
  Way coverage("by coverage", window, loaded, with(LightShadows::Coverage), options.camera);
  Way map("by coverage and a map of all", window, loaded, mapped, options.camera);
  map.mapEachFrame = true;
  const auto frame = [&](Way& way) {
    for (Way* other : {&none, &coverage, &map}) other->renderer.renderer()->SetDraw(other == &way ? 1 : 0);
    const double start = processCpuSeconds();
    Changes moved;
    moved.objects = true;
    if (way.mapEachFrame) way.renderer.sync(way.scene, moved);
    window->Render();
    window->WaitForCompletion();
    return processCpuSeconds() - start;
  };
  for (int i = 0; i < 3; ++i) {
    for (Way* way : {&none, &coverage, &map}) frame(*way);  // compiles
  }
  std::printf("%s: %d x %d, %d samples a pixel, %d pairs of frames, CPU milliseconds\n", options.scene.c_str(),
              size.width, size.height, std::max(window->GetMultiSamples(), 1), options.frames);
  for (Way* way : {&coverage, &map}) {
    const bench::Samples samples = bench::interleave(
        options.frames, [&] { return frame(*way); }, [&] { return frame(none); });
    if (!way->renderer.error().empty()) throw WorkError(way->renderer.error());
    const bench::Ratio ratio = bench::ratioOfMedians(samples);
    std::printf(
        "  %-28s median %8.2f over %8.2f without: ratio %.3f, 95 %% interval %.3f to %.3f; %llu draws look the "
        "coverage up, %llu maps drawn\n",
        way->name, 1e3 * bench::median(samples.a), 1e3 * bench::median(samples.b), ratio.value, ratio.low, ratio.high,
        static_cast<unsigned long long>(way->renderer.counters().drawsWithCoverage),
        static_cast<unsigned long long>(way->renderer.counters().shadowMapsDrawn));
  }
  for (Way* way : {&none, &coverage, &map}) way->renderer.releaseGraphics();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of a frame: shadows by coverage over none, and a shadow map", "bench_shadow");
  BenchOptions options;
  program.add_option("SCENE", options.scene, "Scene file")->capture_default_str();
  program.add_option("--size", options.size, "Pixels")->capture_default_str();
  program.add_option("--camera", options.camera, "Camera of the scene; its first if left out");
  program.add_option("--samples", options.samples, "Samples a pixel")->capture_default_str();
  program.add_option("--frames", options.frames, "Pairs of frames")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  CLI11_PARSE(program, argc, argv);
  return exitStatusOf([&] { run(options); });
}
