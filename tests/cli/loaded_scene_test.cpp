// A probe and a camera from bounds, and what loading makes of a bare model and `--set`.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/session/fit_scene.h"
#include "app/session/load_scene.h"

namespace boxprobe::test {
namespace {

TEST(FittedProbe, EnclosesTheBoundsWithoutChangingTheirCentre) {
  const Box bounds{glm::dvec3(-3, 0, -1), glm::dvec3(5, 3, 7)};
  const Probe probe = fittedProbe(bounds);
  EXPECT_EQ(probe.origin, bounds.center());
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LT(probe.box.min[axis], bounds.min[axis]);
    EXPECT_GT(probe.box.max[axis], bounds.max[axis]);
    EXPECT_NEAR(probe.box.center()[axis], probe.origin[axis], 1e-12);
    EXPECT_LT(probe.box.size()[axis], 1.01 * bounds.size()[axis]);
  }
  EXPECT_LT(probe.nearDistance, probe.farDistance);
}

TEST(FittedProbe, OfAPointIsValid) {
  Scene scene;
  scene.probes = {fittedProbe({glm::dvec3(2), glm::dvec3(2)})};
  EXPECT_NO_THROW(validate(scene));
}

TEST(FittedCamera, SeesEveryCornerOfTheBounds) {
  for (const Box bounds :
       {Box{glm::dvec3(-3, 0, -1), glm::dvec3(5, 3, 7)}, Box{glm::dvec3(0), glm::dvec3(0.01, 100, 0.01)}}) {
    const Camera camera = fittedCamera(bounds);
    const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
    const double halfAngle = 0.5 * glm::radians(camera.verticalFovDegrees);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 position((corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                                (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                                (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
      const double cosine = glm::dot(forward, glm::normalize(position - camera.position));
      EXPECT_GE(cosine, std::cos(halfAngle) - 1e-12);
    }
  }
}

const std::string kRoom = BOXPROBE_DATA_DIR "/scenes/room.glb";

TEST(BareModel, IsFittedAfterItsUnitAndUpAxisAreSet) {
  const LoadedScene metres = loadScene(kRoom);
  ASSERT_EQ(metres.scene.probes.size(), 1u);
  const LoadedScene centimetres = loadScene(kRoom, {"models.0.unit=cm", "models.0.scale=50"});
  ASSERT_EQ(centimetres.scene.probes.size(), 1u);
  EXPECT_NEAR(centimetres.scene.probes[0].box.max.x, 0.5 * metres.scene.probes[0].box.max.x, 0.01);
  EXPECT_LT(glm::length(centimetres.scene.cameras[0].position), 2.6) << "within half the room";
  const LoadedScene turned = loadScene(kRoom, {"models.0.upAxis=z"});
  EXPECT_GT(turned.fit->survey.points.size(), 0u);
  EXPECT_NEAR(turned.scene.probes.at(0).box.size().y, metres.scene.probes[0].box.size().z, 0.05);
}

TEST(BareModel, WhatIsSetGoesOverWhatIsFitted) {
  const LoadedScene none = loadScene(kRoom, {"probes=[]", "exposure=2", "sky.color=[0,0,1]"});
  EXPECT_TRUE(none.scene.probes.empty());
  EXPECT_EQ(none.scene.exposure, 2.0);
  EXPECT_FALSE(none.exposureAutomatic);
  EXPECT_TRUE(std::holds_alternative<SkyColor>(none.scene.sky));
  const LoadedScene set = loadScene(kRoom, {"probes.probe.faceSize=64", "lights.0.intensity=9"});
  EXPECT_EQ(set.scene.probes[0].faceSize, 64);
  EXPECT_EQ(set.scene.lights.at(0).intensity, 9.0f);
  EXPECT_TRUE(set.exposureAutomatic);
}

TEST(BareModel, FollowsWishes) {
  FitWishes wishes;
  wishes.kind = ModelKind::Object;
  const LoadedScene object = loadScene(kRoom, {}, {}, wishes);
  EXPECT_TRUE(object.scene.probes.empty());
  EXPECT_EQ(std::get<SkyImage>(object.scene.sky).file, studioFile());
  EXPECT_NO_THROW(loadSkyImage(object.scene));
  wishes.light = FitLight::Studio;
  EXPECT_TRUE(loadScene(kRoom, {}, {}, wishes).scene.lights.empty());
  EXPECT_FALSE(object.exposureAutomatic) << "the studio is made for an exposure of 1";
}

}  // namespace
}  // namespace boxprobe::test
