// bench_glass: CPU time of a frame whose glass is drawn in each form against the same frame with the same surfaces
// opaque, in turn in one process and window.
#include <cstdio>
#include <string>

#include "tests/bench/harness.h"

namespace {

using namespace boxprobe;

void run(const CLI::App& program, const bench::FrameOptions& options) {
  const LoadedScene loaded = loadScene(options.scene);
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
  // A window of its own for each side: both keep their programs.
  OffscreenScene opaque(windowSettings(program, options));
  bench::prepare(opaque, sceneOf(false, GlassForm::Automatic), loaded.models, options.camera);
  bench::printHeader(options, opaque);
  const std::pair<const char*, GlassForm> forms[] = {{"one-pass", GlassForm::OnePass},
                                                     {"two-pass", GlassForm::TwoPass},
                                                     {"two-interface", GlassForm::TwoInterface},
                                                     {"auto", GlassForm::Automatic}};
  for (const auto& [name, form] : forms) {
    OffscreenScene glass(windowSettings(program, options));
    bench::prepare(glass, sceneOf(true, form), loaded.models, options.camera);
    const bench::Comparison result = bench::compare(
        2, options.frames, [&] { return glass.timedFrame(); }, [&] { return opaque.timedFrame(); });
    glass.requireHealthy();
    const Counters& counters = glass.renderer().counters();
    std::printf("  %-13s %llu objects in %llu passes: %7.2f against %7.2f opaque, %s\n", name,
                static_cast<unsigned long long>(counters.glassDraws),
                static_cast<unsigned long long>(counters.glassPasses), result.first, result.second,
                result.ratioText().c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of a frame with glass, form by form, over the same frame without", "bench_glass");
  bench::FrameOptions options;
  options.scene = BOXPROBE_DATA_DIR "/scenes/glass.boxprobe.json";
  options.camera = "main";
  addFrameOptions(program, options);
  addCameraOption(program, options);
  return bench::runProgram(program, argc, argv, [&] { run(program, options); });
}
