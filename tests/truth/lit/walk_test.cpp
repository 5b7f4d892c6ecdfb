// A walk through a door, from the lit room into the dark one: what is shown changes with the camera, and never by
// itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "tests/truth/lit/lit_pictures.h"

namespace {

using namespace boxprobe;

constexpr int kFrames = 60, kWidth = 80, kHeight = 48;
// Of the picture's light: between two frames the light of all of it may leave the mean of its neighbours by so much,
// and pixels may change so much in all where the camera moves by a hundredth of a millimetre.
constexpr double kMostPop = 0.02, kMostStill = 0.002;

Camera onTheWay(double frame) {
  const double t = frame / (kFrames - 1);
  Camera camera;
  camera.position = {3.5 - 6.2 * t, 1.55, 0.95 - 0.15 * t};
  camera.target = camera.position + glm::dvec3(-3.0, -0.35, -0.4 + 0.9 * t);
  camera.verticalFovDegrees = 58.0;
  return camera;
}

double lightOf(const ImageRgbaF& picture) {
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    sum += i % 4 == 3 ? 0.0 : static_cast<double>(picture.pixels[i]);
  return sum;
}

double changed(const ImageRgbaF& a, const ImageRgbaF& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    sum += i % 4 == 3 ? 0.0 : std::abs(static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]));
  }
  return sum;
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
  std::vector<double> light;
  double still = 0.0;
  for (int i = 0; i < kFrames; ++i) {
    const ImageRgbaF picture = frame(i);
    light.push_back(lightOf(picture));
    ASSERT_GT(light.back(), 0.0);
    still = std::max(still, changed(picture, frame(i + 1.0e-4)) / light.back());
  }
  shown.requireHealthy();
  double pop = 0.0, step = 0.0;
  for (std::size_t i = 1; i + 1 < light.size(); ++i) {
    pop = std::max(pop, std::abs(light[i] - 0.5 * (light[i - 1] + light[i + 1])) / light[i]);
    step = std::max(step, std::abs(light[i] - light[i - 1]) / light[i]);
  }
  std::printf(
      "  %d frames: largest pop %.4f of the picture's light, step %.4f, change at rest %.5f; last over first %.3f\n",
      kFrames, pop, step, still, light.back() / light.front());
  EXPECT_LE(pop, kMostPop);
  EXPECT_LE(still, kMostStill);
  EXPECT_LT(light.back(), 0.5 * light.front()) << "the walk does not get into the dark";
}

}  // namespace
