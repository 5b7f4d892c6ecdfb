// Boxes in the world: rotations, faces, the box of full weight, moving a face.
#include "filters/core/geometry/probe_frame.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {
namespace {

Probe turnedProbe() {
  Probe probe;
  probe.box = {glm::dvec3(-1.0, 0.0, -3.0), glm::dvec3(4.0, 2.5, 2.0)};
  probe.rotationDegrees = {10.0, 35.0, -20.0};
  return probe;
}

TEST(ProbeFrame, FacesPointOutAndStandInTheMiddleOfTheirCorners) {
  const Probe probe = turnedProbe();
  const auto corners = boxCornersWorld(probe.box, rotationMatrix(probe.rotationDegrees), probe.box.center());
  for (const BoxFace& face : kBoxFaces) {
    glm::dvec3 mean(0.0);
    for (unsigned i = 0; i < 8; ++i) {
      const bool high = (i >> static_cast<unsigned>(face.axis)) & 1U;
      if (high == face.positive) mean += corners[i] / 4.0;
    }
    EXPECT_NEAR(glm::length(mean - faceCenterWorld(probe, face)), 0.0, 1e-12) << faceName(face);
    EXPECT_GT(glm::dot(faceCenterWorld(probe, face) - probe.box.center(), faceAxisWorld(probe, face)), 0.0);
  }
}

TEST(ProbeFrame, EdgesJoinCornersThatDifferInOneAxis) {
  for (const auto& edge : boxEdges()) {
    const int differing = edge[0] ^ edge[1];
    EXPECT_TRUE(differing == 1 || differing == 2 || differing == 4);
  }
}

TEST(ProbeFrame, MovingAFaceKeepsTheOtherFivePlanes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> metres(-3.0, 3.0);
  for (int i = 0; i < 500; ++i) {
    const Probe before = turnedProbe();
    for (const BoxFace& face : kBoxFaces) {
      const double offset = metres(random);
      Probe after = before;
      setBox(after, withFaceMoved(before.box, before.rotationDegrees, face, offset, false, kMinimumThickness));
      ASSERT_GE(after.box.size()[face.axis], kMinimumThickness - 1e-12);
      for (const BoxFace& other : kBoxFaces) {
        if (other == face) continue;
        const double was = glm::dot(faceCenterWorld(before, other), faceAxisWorld(before, other));
        const double is = glm::dot(faceCenterWorld(after, other), faceAxisWorld(after, other));
        ASSERT_NEAR(was, is, 1e-12 * 10) << faceName(face) << " moved " << faceName(other);
      }
    }
  }
}

TEST(ProbeFrame, WithoutRotationTheOtherNumbersAreUntouched) {
  const Box before{glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(1e6 + 0.1, 7.7, 9.9)};
  const Box after = withFaceMoved(before, glm::dvec3(0.0), {1, true}, 0.123, false, kMinimumThickness);
  EXPECT_EQ(after.min, before.min);
  EXPECT_EQ(after.max.x, before.max.x);
  EXPECT_EQ(after.max.z, before.max.z);
  EXPECT_EQ(after.max.y, before.max.y + 0.123);
}

TEST(ProbeFrame, ThinnerThanTheMinimumMayStayButNotShrink) {
  const Box thin{glm::dvec3(0.0), glm::dvec3(0.01, 1.0, 1.0)};
  const Box after = withFaceMoved(thin, glm::dvec3(0.0), {0, true}, -5.0, false, kMinimumThickness);
  EXPECT_DOUBLE_EQ(after.size().x, 0.01);
}

TEST(ProbeFrame, AnInfluenceBoxOfItsOwnStaysInTheWorld) {
  Probe probe = turnedProbe();
  probe.influence = Box{glm::dvec3(-2.0, -1.0, -4.0), glm::dvec3(5.0, 3.0, 3.0)};
  const glm::dmat3 rotation = rotationMatrix(probe.rotationDegrees);
  const auto before = boxCornersWorld(*probe.influence, rotation, probe.box.center());
  setBox(probe, withFaceMoved(probe.box, probe.rotationDegrees, {0, true}, 1.5, false, kMinimumThickness));
  const auto after = boxCornersWorld(*probe.influence, rotation, probe.box.center());
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(glm::length(before[i] - after[i]), 0.0, 1e-12);
}

TEST(ProbeFrame, FullWeightIsTheInfluenceBoxDrawnIn) {
  Probe probe;
  probe.box = {glm::dvec3(0.0), glm::dvec3(4.0)};
  probe.blendDistance = {glm::dvec3(1.0, 0.0, 3.0), glm::dvec3(0.5, 0.0, 3.0)};
  const Box inner = fullWeightBox(probe);
  EXPECT_EQ(inner.min, glm::dvec3(1.0, 0.0, 2.0));
  EXPECT_EQ(inner.max, glm::dvec3(3.5, 4.0, 2.0)) << "opposite distances that overlap meet in one plane";
}

}  // namespace
}  // namespace boxprobe
