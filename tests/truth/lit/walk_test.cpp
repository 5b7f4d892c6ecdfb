// A walk through a door, from the lit room into the dark one, at the step of a walk: the picture's light never jumps
// between two frames by itself. Where it changes much, the path tracer says whether the place does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "filters/reference/path/reference_path.h"
#include "tests/truth/lit/lit_pictures.h"

namespace {

using namespace boxprobe;

constexpr int kFrames = 60, kWidth = 80, kHeight = 48;
// Of a picture's mean light, from one frame to the next.
constexpr double kMostPop = 0.02;
constexpr int kRays = 160;  // a pixel: the mean of a picture is known to some .3 %

Camera onTheWay(int frame) {
  const double t = static_cast<double>(frame) / (kFrames - 1);
  Camera camera;
  camera.position = {3.5 - 6.2 * t, 1.55, 0.95 - 0.15 * t};
  camera.target = camera.position + glm::dvec3(-3.0, -0.35, -0.4 + 0.9 * t);
  camera.verticalFovDegrees = 58.0;
  return camera;
}

double meanLight(const ImageRgbaF& picture) {
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    if (i % 4 != 3) sum += static_cast<double>(picture.pixels[i]);
  }
  return sum / static_cast<double>(picture.pixels.size() / 4 * 3);
}

class Truth {
 public:
  explicit Truth(const LoadedScene& loaded) : tracer_(loaded.scene, loaded.models, loadSkyImage(loaded.scene)) {}
  double light(int frame) {
    const auto known = known_.find(frame);
    if (known != known_.end()) return known->second;
    PathSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.raysPerPixel = kRays;
    settings.seed = static_cast<std::uint64_t>(11 + frame);
    return known_[frame] = meanLight(tracer_.render(onTheWay(frame), settings).color);
  }
  std::size_t traced() const { return known_.size(); }

 private:
  ReferencePath tracer_;
  std::map<int, double> known_;
};

TEST(WalkThroughADoor, NothingPops) {
  const LoadedScene loaded = loadScene(loadLitIndex().scenePath("doorway"));
  OffscreenScene shown({"walk_test", kWidth, kHeight, 1, true});
  ShownSettings settings;
  settings.camera = onTheWay(0);
  shown.show(loaded.scene, loaded.models, settings);
  ASSERT_TRUE(shown.capture());
  const auto light = [&](int frame) {
    shown.renderer().applyCamera(onTheWay(frame));
    EXPECT_TRUE(shown.capture());
    return meanLight(shown.renderer().renderLinear(kWidth, kHeight, 16));
  };
  Truth truth(loaded);
  double step = 0.0, pop = 0.0, before = light(0), brightest = before, darkest = before;
  for (int frame = 1; frame < kFrames; ++frame) {
    const double now = light(frame), change = now / before - 1.0;
    step = std::max(step, std::abs(change));
    double itself = change;
    if (std::abs(change) > kMostPop) {
      const double due = truth.light(frame) / truth.light(frame - 1) - 1.0;
      itself = change - due;
      std::printf("  frame %d: light changes by %+.4f, truly by %+.4f\n", frame, change, due);
    }
    pop = std::max(pop, std::abs(itself));
    brightest = std::max(brightest, now);
    darkest = std::min(darkest, now);
    before = now;
  }
  shown.requireHealthy();
  std::printf("  %d frames: light %.3f to %.3f, largest change %.4f, largest that the path tracer has not %.4f, %zu traced\n",
              kFrames, darkest, brightest, step, pop, truth.traced());
  EXPECT_LE(pop, kMostPop);
  EXPECT_GT(brightest, 2.0 * darkest) << "no walk from light into the dark";
}

}  // namespace
