// bench_shadow: CPU time of a frame with a light's shadows by coverage over that of the same frame without, drawn in
// turn in one process and window, and beside it the same light with a shadow map, drawn again each frame, of everything
// in the scene. CPU time of all threads: software OpenGL draws in this process.
#include <cstdio>
#include <string>

#include "filters/vtk/gl/cpu_time.h"
#include "tests/bench/harness.h"

namespace {

using namespace boxprobe;

/// A scene of its own in the common window.
struct Way {
  Way(const char* n, vtkOpenGLRenderWindow* window, const LoadedScene& loaded, Scene s, const std::string& camera)
      : name(n), scene(std::move(s)), drawn(window) {
    bench::prepare(drawn, scene, loaded.models, camera);
  }
  const char* name;
  Scene scene;
  OffscreenScene drawn;
  bool mapEachFrame = false;
};

void run(const CLI::App& program, const bench::FrameOptions& options) {
  const LoadedScene loaded = loadScene(options.scene);
  const auto window = openOffscreenWindow(windowSettings(program, options));
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
    bench::drawOnly(way.drawn, {&none.drawn, &coverage.drawn, &map.drawn});
    const double start = processCpuSeconds();
    Changes moved;
    moved.objects = true;
    if (way.mapEachFrame) way.drawn.renderer().sync(way.scene, moved);
    way.drawn.timedFrame();
    return processCpuSeconds() - start;
  };
  for (int i = 0; i < 3; ++i) {
    for (Way* way : {&none, &coverage, &map}) frame(*way);  // compiles
  }
  bench::printHeader(options, none.drawn);
  for (Way* way : {&coverage, &map}) {
    const bench::Comparison result = bench::compare(
        0, options.frames, [&] { return frame(*way); }, [&] { return frame(none); });
    way->drawn.requireHealthy();
    const Counters& counters = way->drawn.renderer().counters();
    std::printf("  %-28s median %8.2f over %8.2f without: %s; %llu draws look the coverage up, %llu maps drawn\n",
                way->name, result.first, result.second, result.ratioText().c_str(),
                static_cast<unsigned long long>(counters.drawsWithCoverage),
                static_cast<unsigned long long>(counters.shadowMapsDrawn));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of a frame: shadows by coverage over none, and a shadow map", "bench_shadow");
  bench::FrameOptions options;
  options.scene = BOXPROBE_DATA_DIR "/scenes/windows.boxprobe.json";
  options.frames = 60;
  addFrameOptions(program, options);
  addCameraOption(program, options);
  return bench::runProgram(program, argc, argv, [&] { run(program, options); });
}
