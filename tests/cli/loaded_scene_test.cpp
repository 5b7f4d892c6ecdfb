// What loading adds to the files: the probe and camera fitted to a bare model.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "app/session/fit_scene.h"

namespace boxprobe::test {
namespace {

Model twoPoints(const glm::dmat4& worldFromModel) {
  Model model;
  Mesh mesh;
  mesh.positions = {{0.0f, 0.0f, 0.0f}, {1.0f, 2.0f, 3.0f}};
  model.meshes.push_back(mesh);
  model.instances.push_back({"points", 0, worldFromModel});
  return model;
}

TEST(ModelBounds, AreInWorldSpaceAndInDouble) {
  const Box bounds = modelBounds(twoPoints(glm::translate(glm::dmat4(1.0), glm::dvec3(1e8 + 0.25, 0.0, -5.0))));
  EXPECT_EQ(bounds.min, glm::dvec3(1e8 + 0.25, 0.0, -5.0));
  EXPECT_EQ(bounds.max, glm::dvec3(1e8 + 1.25, 2.0, -2.0));
}

TEST(ModelBounds, OfNothingAreAUnitBox) {
  EXPECT_EQ(modelBounds(Model{}), Box{});
}

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

}  // namespace
}  // namespace boxprobe::test
