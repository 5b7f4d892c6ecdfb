// What the measuring programs share: their command line, a scene ready to be timed, frames of two kinds in turn and how
// these compare. Called by every main here; knows nothing of what is measured. Times are CPU times of all threads,
// because software OpenGL draws in this process.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <initializer_list>
#include <string>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "filters/reference/measure/interleaved.h"

namespace boxprobe::bench {

/// Of a program that draws a scene.
struct FrameOptions {
  std::string scene;  ///< path
  std::string size = "1280x720";
  std::string camera;  ///< empty: "main", else the first
  int samples = 4;     ///< a pixel
  int frames = 40;     ///< pairs of frames
};

/// SCENE, --size, --samples and the flag of the pairs, their defaults those of `options`.
void addFrameOptions(CLI::App& program, FrameOptions& options, const std::string& pairsFlag = "--frames");
/// --camera, which not every program offers.
void addCameraOption(CLI::App& program, FrameOptions& options);

/// A window as the options ask for; VTK's errors are printed.
OffscreenSettings windowSettings(const CLI::App& program, const FrameOptions& options);
/// A window for passes that draw into targets of their own.
OffscreenSettings smallWindowSettings(const CLI::App& program);

/// Shows `scene` from the camera of that name and makes its captures. Throws WorkError where that fails.
void prepare(OffscreenScene& drawn, const Scene& scene, const OffscreenScene::Models& models,
             const std::string& camera = {});
/// Of scenes in one window, the next frame is of `one` alone.
void drawOnly(const OffscreenScene& one, std::initializer_list<OffscreenScene*> all);

struct Comparison {
  Samples samples;               ///< seconds
  double first = 0, second = 0;  ///< medians, milliseconds
  Ratio ratio;                   ///< of the first over the second
  /// "ratio 1.102, 95 % interval 1.095 to 1.110"
  std::string ratioText() const;
};

/// `warmUp` times both, which compiles programs and fills caches, then `pairs` times both in turn. Each returns its
/// seconds.
Comparison compare(int warmUp, int pairs, const std::function<double()>& first, const std::function<double()>& second);

/// "PATH: 1280 x 720, 4 samples per pixel, 40 pairs of frames, CPU milliseconds", samples as the driver offers them.
void printHeader(const FrameOptions& options, const OffscreenScene& drawn);

/// Reads the command line, runs, and gives the exit status: an error is one line on stderr.
int runProgram(CLI::App& program, int argc, char** argv, const std::function<void()>& run);

}  // namespace boxprobe::bench
