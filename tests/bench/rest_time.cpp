// bench_rest: how long a view that rests takes to its final picture. Mirrors get their texels and frames are drawn as
// in the window, from the technique's own until nothing more is added, and each is compared with a picture of more rays
// than they end with.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/render_options.h"
#include "filters/io/image/image_file.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/gl/window_pixels.h"
#include "tests/bench/harness.h"

namespace {

using namespace boxprobe;

struct RestOptions {
  bench::FrameOptions frame;
  std::string technique;  ///< of all probes; empty: as the scene has them
  std::string sheet;      ///< a picture of eight frames on the way; empty: none
  int rays = RefineSettings::kRays;
};

/// The root of the mean squared difference, in steps of 8 bits.
double difference(const ImageRgba8& a, const ImageRgba8& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double apart = static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]);
    squares += apart * apart;
  }
  return std::sqrt(squares / (0.75 * static_cast<double>(a.pixels.size())));  // alpha is 255 in both
}

double meanOf(const ImageRgba8& image) {
  double sum = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) sum += i % 4 == 3 ? 0.0 : image.pixels[i];
  return sum / (0.75 * static_cast<double>(image.pixels.size()));
}

/// Four in a row.
ImageRgba8 sheetOf(const std::vector<ImageRgba8>& pictures) {
  constexpr std::size_t kColumns = 4, kGap = 4;
  const auto width = static_cast<std::size_t>(pictures[0].width), height = static_cast<std::size_t>(pictures[0].height);
  const std::size_t rows = (pictures.size() + kColumns - 1) / kColumns, across = kColumns * (width + kGap) - kGap;
  ImageRgba8 sheet{static_cast<int>(across), static_cast<int>(rows * (height + kGap) - kGap), {}, {}};
  sheet.pixels.assign(across * static_cast<std::size_t>(sheet.height) * 4, 255);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (std::size_t y = 0; y < height; ++y) {
      const std::size_t to = ((i / kColumns * (height + kGap) + y) * across + i % kColumns * (width + kGap)) * 4;
      std::copy_n(pictures[i].pixels.begin() + static_cast<std::ptrdiff_t>(y * width * 4), width * 4,
                  sheet.pixels.begin() + static_cast<std::ptrdiff_t>(to));
    }
  }
  return sheet;
}

/// Median CPU time of a frame while the camera moves.
double movedFrame(OffscreenScene& drawn) {
  constexpr int kFrames = 41;
  SceneRenderer& renderer = drawn.renderer();
  const Camera rest = renderer.currentCamera();
  std::vector<double> seconds;
  for (int i = 0; i < kFrames; ++i) {
    Camera camera = rest;
    camera.position.x += 0.002 * (i % 7);
    renderer.applyCamera(camera);
    seconds.push_back(drawn.timedFrame());
  }
  renderer.applyCamera(rest);
  std::nth_element(seconds.begin(), seconds.begin() + kFrames / 2, seconds.end());
  return seconds[kFrames / 2];
}

RefineSettings endingAt(int rays) {
  RefineSettings settings;
  settings.rays = rays;
  return settings;
}

void run(const CLI::App& program, const RestOptions& options) {
  LoadedScene loaded = loadScene(options.frame.scene);
  for (Probe& probe : loaded.scene.probes) {
    if (!options.technique.empty()) probe.technique = options.technique;
  }
  OffscreenScene drawn(bench::windowSettings(program, options.frame));
  SceneRenderer& renderer = drawn.renderer();
  bench::prepare(drawn, loaded.scene, loaded.models, options.frame.camera);

  drawn.capture();
  const double movedBefore = movedFrame(drawn);
  const int rows = drawn.window()->GetSize()[1];
  // The picture that all others are compared with; it also compiles the programs, which a view does once.
  renderer.refine(endingAt(4 * options.rays));
  drawn.capture();
  renderer.sharpenMirrors(rows);
  drawn.capture();
  do {
    drawn.timedFrame();
  } while (renderer.frameCount().more());
  drawn.timedFrame();
  const ImageRgba8 truth = windowPixels(drawn.window());
  renderer.refine({});
  renderer.sharpenMirrors(0);
  double own = 0.0;
  for (int i = 0; i < 3; ++i) own = drawn.timedFrame();

  renderer.refine(endingAt(options.rays));
  std::vector<ImageRgba8> pictures;
  std::vector<double> seconds, errors;
  drawn.window()->MakeCurrent();
  const double before = processCpuSeconds();
  renderer.sharpenMirrors(rows);
  while (renderer.workPending()) renderer.step();
  const double sharpened = processCpuSeconds() - before;
  double spent = sharpened, step = 0.0, light = 0.0;
  bool more = true;
  while (more) {
    spent += drawn.timedFrame();
    more = renderer.frameCount().more();
    pictures.push_back(windowPixels(drawn.window()));
    seconds.push_back(spent);
    errors.push_back(difference(pictures.back(), truth));
    const double mean = meanOf(pictures.back());
    if (pictures.size() > 1) step = std::max(step, std::abs(mean / light - 1.0));
    light = mean;
    drawn.requireHealthy();
  }
  renderer.refine({});
  renderer.sharpenMirrors(0);
  const double movedAfter = movedFrame(drawn);
  std::size_t reached = errors.size() - 1;
  while (reached > 0 && errors[reached - 1] <= 1.2 * errors.back()) --reached;
  std::printf(
      "%s: %zu frames, %.2f s of CPU (mirrors %.2f s, a frame of the technique's own %.3f s), RMS in steps of 8 bits "
      "%.2f to %.2f; within 1.2 of it after frame %zu, %.2f s; largest step of the mean %.4f; a frame while moving "
      "%.4f s, "
      "%.3f of that before anything was refined\n",
      options.frame.scene.c_str(), pictures.size(), spent, sharpened, own, errors.front(), errors.back(), reached + 1,
      seconds[reached], step, movedAfter, movedAfter / movedBefore);
  if (options.sheet.empty()) return;
  std::vector<ImageRgba8> eight;
  for (std::size_t i = 0; i < 8; ++i) eight.push_back(pictures[i * (pictures.size() - 1) / 7]);
  savePng(options.sheet, sheetOf(eight));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time from rest to a picture within 1.2 of its final error", "bench_rest");
  RestOptions options;
  options.frame.scene = BOXPROBE_DATA_DIR "/scenes/room.boxprobe.json";
  options.frame.size = "480x270";
  options.frame.samples = 1;
  program.add_option("SCENE", options.frame.scene, "Scene file")->capture_default_str();
  program.add_option("--size", options.frame.size, "Pixels")->capture_default_str();
  bench::addCameraOption(program, options.frame);
  program.add_option("--technique", options.technique, "Of all probes (default: as the scene has them)");
  program.add_option("--rays", options.rays, "At the end, a pixel")
      ->check(CLI::Range(1, RefineSettings::kMostRays / 4));
  program.add_option("--sheet", options.sheet, "Writes eight frames on the way into one picture");
  return bench::runProgram(program, argc, argv, [&] { run(program, options); });
}
