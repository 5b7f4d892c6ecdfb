// A walk through a door, from the lit room into the dark one: what is shown changes with the camera, and never by
// itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "tests/truth/lit/lit_pictures.h"

namespace {

using namespace boxprobe;

constexpr int kFrames = 60, kWidth = 80, kHeight = 48;
// Of the picture's light: so much of it may change at one place of the way.
constexpr double kMostPop = 0.02;
constexpr int kHalvings = 9;  // of the way between two frames, to a fifth of a millimetre

Camera onTheWay(double frame) {
  const double t = frame / (kFrames - 1);
  Camera camera;
  camera.position = {3.5 - 6.2 * t, 1.55, 0.95 - 0.15 * t};
  camera.target = camera.position + glm::dvec3(-3.0, -0.35, -0.4 + 0.9 * t);
  camera.verticalFovDegrees = 58.0;
  return camera;
}

// Of the brighter picture's light.
double changed(const ImageRgbaF& a, const ImageRgbaF& b) {
  double sum = 0.0, first = 0.0, second = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    const double p = static_cast<double>(a.pixels[i]), q = static_cast<double>(b.pixels[i]);
    sum += std::abs(p - q);
    first += p;
    second += q;
  }
  return sum / std::max({first, second, 1.0e-30});
}

TEST(WalkThroughADoor, NothingPops) {
  const LoadedScene loaded = loadScene(loadLitIndex().scenePath("doorway"));
  OffscreenScene shown({"walk_test", kWidth, kHeight, 1, true});
  ShownSettings settings;
  settings.camera = onTheWay(0.0);
  shown.show(loaded.scene, loaded.models, settings);
  ASSERT_TRUE(shown.capture());
  const auto frame = [&](double at) {
    shown.renderer().applyCamera(onTheWay(at));
    EXPECT_TRUE(shown.capture());
    return shown.renderer().renderLinear(kWidth, kHeight, 16);
  };
  double pop = 0.0, step = 0.0;
  int halved = 0;
  ImageRgbaF before = frame(0.0);
  for (int i = 1; i < kFrames; ++i) {
    const ImageRgbaF next = frame(i);
    double change = changed(before, next), low = i - 1.0, high = i;
    step = std::max(step, change);
    // What the camera's way changes falls with the way; what pops stays, in one half or the other.
    ImageRgbaF first = before, last = next;
    for (int k = 0; k < kHalvings && change > kMostPop; ++k) {
      const double middle = 0.5 * (low + high);
      const ImageRgbaF between = frame(middle);
      const double near = changed(first, between), far = changed(between, last);
      (near > far ? high : low) = middle;
      (near > far ? last : first) = between;
      change = std::max(near, far);
      ++halved;
    }
    pop = std::max(pop, change);
    before = next;
  }
  shown.requireHealthy();
  std::printf("  %d frames: largest step %.3f of the picture's light, largest pop %.4f, after %d halvings\n", kFrames,
              step, pop, halved);
  EXPECT_LE(pop, kMostPop);
  EXPECT_GT(halved, 0) << "nothing is judged";
}

}  // namespace
