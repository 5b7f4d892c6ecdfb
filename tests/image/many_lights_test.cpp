// Scenes with more lights than VTK gets code for. Light adds up: the picture with all lights is judged by pictures with
// few of them, each by VTK's own code.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "tests/support/scene_picture.h"

namespace boxprobe::test {
namespace {

// No two alike; within data/scenes/furnished, which is 7 x 2.8 x 5.
Light light(int i) {
  const double t = 0.37 + 0.61803398875 * i, u = 0.11 + 0.7548776662 * i, v = 0.53 + 0.5698402910 * i;
  const auto part = [](double x) { return x - std::floor(x); };
  Light made;
  made.type = i % 7 == 3 ? LightType::Directional : i % 3 == 1 ? LightType::Spot : LightType::Point;
  made.position = {6.4 * part(t) - 3.2, 0.2 + 2.4 * part(u), 4.4 * part(v) - 2.2};
  made.direction = {part(u) - 0.4, -0.3 - part(t), part(v) - 0.6};
  made.color = {0.3f + 0.7f * static_cast<float>(part(v)), 0.4f, 0.2f + 0.8f * static_cast<float>(part(t))};
  made.intensity = made.type == LightType::Directional ? 0.05f : 0.3f + static_cast<float>(part(u));
  made.outerConeDegrees = 25.0 + 40.0 * part(t);
  made.innerConeDegrees = 0.6 * made.outerConeDegrees * part(v);
  if (i % 2 == 0) made.range = 0.8 + 2.0 * part(u);
  return made;
}

std::vector<Light> lights(int from, int to) {
  std::vector<Light> made;
  for (int i = from; i < to; ++i) made.push_back(light(i));
  return made;
}

struct LitRoom {
  LitRoom() : picture(ScenePicture::fromFile("scenes/furnished.boxprobe.json", 160, 90)) {
    Scene& scene = picture.scene;
    scene.probes.clear();
    scene.lamps = LampForm::InMap;  // no shadow maps of suns: which two have one depends on the others
    scene.sky = SkyColor{glm::vec3(0.0f)};
    scene.materials["floor"].coat = 0.8f;
  }
  ImageRgbaF with(std::vector<Light> lights, const char* camera = "main") {
    picture.scene.lights = std::move(lights);
    picture.show(cameraNamed(picture.scene, camera));
    return picture.linear(1);
  }
  void moveSphere(double by) { picture.scene.objects["sphere 1"].translation = glm::dvec3(by, 0.2 * by, 0.0); }

  ScenePicture picture;
};

double largestDifference(const ImageRgbaF& a, const ImageRgbaF& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    largest = std::max(largest, std::abs(double(a.pixels[i]) - b.pixels[i]) / (0.01 + std::abs(b.pixels[i])));
  }
  return largest;
}

TEST(ManyLights, AddUpAsFewDo) {
  LitRoom room;
  constexpr int kAll = 97, kAtOnce = 20;  // as few as VTK gets
  for (const char* camera : {"main", "low"}) {
    const ImageRgbaF dark = room.with({}, camera);
    ImageRgbaF sum = dark;
    for (int from = 0; from < kAll; from += kAtOnce) {
      const ImageRgbaF few = room.with(lights(from, std::min(from + kAtOnce, kAll)), camera);
      for (std::size_t i = 0; i < sum.pixels.size(); ++i) {
        if (i % 4 != 3) sum.pixels[i] += few.pixels[i] - dark.pixels[i];
      }
    }
    const ImageRgbaF all = room.with(lights(0, kAll), camera);
    EXPECT_LT(largestDifference(all, sum), 2e-3) << camera;
    EXPECT_GT(largestDifference(all, dark), 1.0) << "they light something";
  }
}

// From a number that VTK has code for to one that it has not, and back; and an object that leaves some lights behind.
TEST(ManyLights, EditedPicturesAreThoseOfAFreshStart) {
  const auto fresh = [](int count, double moved) {
    LitRoom other;
    if (moved != 0.0) other.moveSphere(moved);
    return other.with(lights(0, count)).pixels;
  };
  LitRoom room;
  for (const int count : {31, 33, 32, 60, 33, 31})
    EXPECT_EQ(room.with(lights(0, count)).pixels, fresh(count, 0.0)) << count;
  room.with(lights(0, 60));
  for (const double moved : {1.3, -0.9}) {
    room.moveSphere(moved);
    EXPECT_EQ(room.with(lights(0, 60)).pixels, fresh(60, moved)) << moved;
  }
}

}  // namespace
}  // namespace boxprobe::test
