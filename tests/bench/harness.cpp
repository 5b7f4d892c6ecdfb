// See harness.h.
#include "tests/bench/harness.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "app/cli/options/render_options.h"
#include "app/session/messages.h"
#include "filters/core/base/errors.h"

namespace boxprobe::bench {

void addFrameOptions(CLI::App& program, FrameOptions& options, const std::string& pairsFlag) {
  program.add_option("SCENE", options.scene, "Scene file")->capture_default_str();
  program.add_option("--size", options.size, "Pixels")->capture_default_str();
  program.add_option("--samples", options.samples, "Samples per pixel")->capture_default_str();
  // Fewer than 2 have no interval.
  program.add_option(pairsFlag, options.frames, "Pairs of frames")->check(CLI::Range(2, 100000))->capture_default_str();
}

void addCameraOption(CLI::App& program, FrameOptions& options) {
  program.add_option("--camera", options.camera, "Camera of the scene (default: main, or else the first)");
}

OffscreenSettings windowSettings(const CLI::App& program, const FrameOptions& options) {
  const FrameSize size = parseFrameSize(options.size);
  return {program.get_name(), size.width, size.height, options.samples, false, true};
}

OffscreenSettings smallWindowSettings(const CLI::App& program) {
  return {program.get_name(), 16, 16, 1, false, true};
}

void prepare(OffscreenScene& drawn, const Scene& scene, const OffscreenScene::Models& models,
             const std::string& camera) {
  drawn.show(scene, models, {chooseCamera(scene, camera)});
  drawn.capture();
  drawn.requireHealthy();
}

void drawOnly(const OffscreenScene& one, std::initializer_list<OffscreenScene*> all) {
  for (OffscreenScene* scene : all) scene->setDrawn(scene == &one);
}

std::string Comparison::ratioText() const {
  char text[96];
  std::snprintf(text, sizeof text, "ratio %.3f, 95 %% interval %.3f to %.3f", ratio.value, ratio.low, ratio.high);
  return text;
}

Comparison compare(int warmUp, int pairs, const std::function<double()>& first, const std::function<double()>& second) {
  for (int i = 0; i < warmUp; ++i) {
    first();
    second();
  }
  Comparison result;
  result.samples = interleave(pairs, first, second);
  result.first = 1e3 * median(result.samples.a);
  result.second = 1e3 * median(result.samples.b);
  result.ratio = ratioOfMedians(result.samples);
  return result;
}

void printHeader(const FrameOptions& options, const OffscreenScene& drawn) {
  const int* size = drawn.window()->GetSize();
  std::printf("%s: %d x %d, %d samples per pixel, %d pairs of frames, CPU milliseconds\n", options.scene.c_str(),
              size[0], size[1], std::max(drawn.window()->GetMultiSamples(), 1), options.frames);
}

int runProgram(CLI::App& program, int argc, char** argv, const std::function<void()>& run) {
  try {
    program.parse(argc, argv);
    run();
    return 0;
  } catch (const CLI::ParseError& error) {
    return program.exit(error);
  } catch (const Error& error) {
    printError(error.what());
    return error.exitStatus();
  } catch (const std::exception& error) {
    printError(error.what());
    return 1;
  }
}

}  // namespace boxprobe::bench
