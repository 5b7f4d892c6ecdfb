// bench_mirrors: CPU time of a frame with planar mirrors over the same frame without, drawn in turn in one process:
// with things moving in their view, with all of them out of it (no picture is drawn, the program looks), and with
// nothing that moves in the scene at all (the programs are those of a scene without mirrors).
#include <cstdio>
#include <string>

#include "tests/bench/harness.h"

namespace {

using namespace boxprobe;

/// Each of the two in a window of its own.
void compare(const CLI::App& program, const char* what, const LoadedScene& loaded, const Scene& with,
             const bench::FrameOptions& options) {
  Scene without = with;
  without.mirrors.clear();
  OffscreenScene a(windowSettings(program, options)), b(windowSettings(program, options));
  bench::prepare(a, with, loaded.models, options.camera);
  bench::prepare(b, without, loaded.models, options.camera);
  const bench::Comparison result = bench::compare(
      2, options.frames, [&] { return a.timedFrame(); }, [&] { return b.timedFrame(); });
  a.requireHealthy();
  const MirrorCounters& mirrors = a.renderer().counters().mirrors;
  std::printf("  %-24s %llu pictures, %8llu texels: %7.2f ms against %7.2f ms, %s\n", what,
              static_cast<unsigned long long>(mirrors.drawn), static_cast<unsigned long long>(mirrors.texels),
              result.first, result.second, result.ratioText().c_str());
}

void run(const CLI::App& program, const bench::FrameOptions& options) {
  const LoadedScene loaded = loadScene(options.scene);
  std::printf("%s: camera %s, %s, %d samples per pixel, %d pairs of frames, median CPU time\n", options.scene.c_str(),
              options.camera.c_str(), options.size.c_str(), options.samples, options.frames);
  const auto measure = [&](const std::string& what, const Scene& scene) {
    compare(program, what.c_str(), loaded, scene, options);
  };
  measure("all mirrors", loaded.scene);
  for (const auto& [node, mirror] : loaded.scene.mirrors) {
    Scene one = loaded.scene;
    one.mirrors = {{node, mirror}};
    measure(node + " alone", one);
  }
  Scene away = loaded.scene, still = loaded.scene;
  for (auto& [node, object] : away.objects) {
    if (object.dynamic) object.translation.y -= 100.0;
  }
  for (auto& [node, object] : still.objects) object.dynamic = false;
  measure("what moves out of view", away);
  measure("nothing moves", still);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of a frame with planar mirrors over the same frame without", "bench_mirrors");
  bench::FrameOptions options;
  options.scene = BOXPROBE_DATA_DIR "/scenes/mirror-hall.boxprobe.json";
  options.camera = "main";
  options.frames = 30;
  addFrameOptions(program, options);
  addCameraOption(program, options);
  return bench::runProgram(program, argc, argv, [&] { run(program, options); });
}
