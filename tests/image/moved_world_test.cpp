// Every scene of data/scenes, its probes and its camera moved by a million metres along each axis: the same picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/support/scene_names.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

void move(Box& box, const glm::dvec3& by) {
  box.min += by;
  box.max += by;
}

Scene moved(Scene scene, const glm::dvec3& by) {
  for (ModelFile& model : scene.models) model.translation += by;
  for (Camera& camera : scene.cameras) {
    camera.position += by;
    camera.target += by;
  }
  for (Light& light : scene.lights) light.position += by;
  for (Probe& probe : scene.probes) {
    probe.origin += by;
    move(probe.box, by);
    if (probe.influence) move(*probe.influence, by);
  }
  return scene;
}

ImageRgba8 pictureOf(const Scene& scene) {
  ScenePicture picture(scene, 640, 360);
  picture.show(scene.cameras.front());
  return picture.display();
}

class MovedWorld : public testing::TestWithParam<std::string> {};

TEST_P(MovedWorld, SamePicture) {
  Scene scene = ScenePicture::fromFile(std::string("scenes/") + GetParam() + ".boxprobe.json", 8, 8).scene;
  // Small captures show a wrong place as well as large ones.
  for (Probe& probe : scene.probes) {
    probe.faceSize = 64;
    probe.bounces = 1;
  }
  const ImageRgba8 here = pictureOf(scene);
  keepPicture(here, std::string("moved_") + GetParam() + "_0");
  for (const double distance : {1.0e4, 1.0e6}) {
    const ImageRgba8 there = pictureOf(moved(scene, glm::dvec3(distance)));
    keepPicture(there, std::string("moved_") + GetParam() + "_" + std::to_string(static_cast<int>(distance)));
    ASSERT_EQ(here.pixels.size(), there.pixels.size());
    std::size_t different = 0;
    int worst = 0;
    for (std::size_t i = 0; i < here.pixels.size(); i += 4) {
      int difference = 0;
      for (std::size_t c = 0; c < 3; ++c)
        difference = std::max(difference, std::abs(here.pixels[i + c] - there.pixels[i + c]));
      different += difference > 0;
      worst = std::max(worst, difference);
    }
    std::printf("  %s moved by %.0e m: %zu of %zu pixels differ, by at most %d/255\n", GetParam().c_str(), distance,
                different, here.pixels.size() / 4, worst);
    // Positions a million metres out are multiples of 1.2e-10 m in double, so matrices differ in their last float bit
    // here and there and an edge may fall on the other side of a pixel's centre.
    EXPECT_LE(different, here.pixels.size() / 4 / 2000);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, MovedWorld, testing::ValuesIn(sceneNames()));

}  // namespace
