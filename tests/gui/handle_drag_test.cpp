// From mouse rays to metres.
#include "app/gui/handles/handle_drag.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace boxprobe {
namespace {

Ray towards(const glm::dvec3& from, const glm::dvec3& to) {
  return {from, glm::normalize(to - from)};
}

TEST(HandleDrag, ClosestOnLineIsWhereTheRayWasAimed) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-4.0, 4.0);
  const auto vector = [&] { return glm::dvec3(any(random), any(random), any(random)); };
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 point = vector(), axis = glm::normalize(vector()), eye = vector();
    const double t = any(random);
    const Ray ray = towards(eye, point + t * axis);
    const auto found = closestOnLine(ray, point, axis);
    if (std::abs(glm::dot(axis, ray.direction)) > 0.999) continue;
    ASSERT_TRUE(found);
    ASSERT_NEAR(*found, t, 1e-8);
  }
}

TEST(HandleDrag, NothingAlongTheLineOrBehindTheViewer) {
  const Ray ray{glm::dvec3(0.0), glm::dvec3(0.0, 0.0, -1.0)};
  EXPECT_FALSE(closestOnLine(ray, glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0)));
  EXPECT_FALSE(closestOnLine(ray, glm::dvec3(0.0, 1.0, 5.0), glm::dvec3(1.0, 0.0, 0.0)));
  EXPECT_FALSE(meetPlane(ray, glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 0.0, 1.0)));
}

TEST(HandleDrag, AFaceSeenHeadOnFollowsUpAndDown) {
  Probe probe;
  probe.box = {glm::dvec3(-2.0), glm::dvec3(2.0)};
  const ViewAxes view{glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 1.0, 0.0)};
  const glm::dvec3 eye(0.0, 0.0, 1.0);
  FaceDrag drag(probe, {2, false}, view, towards(eye, glm::dvec3(0.0, 0.0, -2.0)));
  const Box away = drag.box(towards(eye, glm::dvec3(0.0, 0.5, -2.0)), false);
  EXPECT_NEAR(away.min.z, -2.5, 1e-12) << "up moves it away from the viewer";
  const Box closer = drag.box(towards(eye, glm::dvec3(0.0, -0.5, -2.0)), false);
  EXPECT_NEAR(closer.min.z, -1.5, 1e-12);
  EXPECT_EQ(away.max, probe.box.max);
}

TEST(HandleDrag, WhatTheGrabMissedTheHandleByStaysBetweenThem) {
  Probe probe;
  probe.box = {glm::dvec3(-2.0), glm::dvec3(2.0)};
  const ViewAxes view{glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 1.0, 0.0)};
  const glm::dvec3 eye(0.5, 1.0, 9.0);
  FaceDrag drag(probe, {0, true}, view, towards(eye, glm::dvec3(2.1, 0.0, 0.0)));
  EXPECT_NEAR(drag.box(towards(eye, glm::dvec3(2.1, 0.0, 0.0)), false).max.x, 2.0, 1e-12);
  EXPECT_NEAR(drag.box(towards(eye, glm::dvec3(3.1, 0.0, 0.0)), false).max.x, 3.0, 1e-9);
}

TEST(HandleDrag, TheOriginStaysInItsPlaneOrOnItsAxis) {
  Probe probe;
  probe.origin = {0.5, 1.0, -2.0};
  const glm::dvec3 forward = glm::normalize(glm::dvec3(0.3, -0.2, -1.0));
  const glm::dvec3 eye(0.0, 2.0, 5.0);
  OriginDrag drag(probe, {forward, glm::dvec3(0.0, 1.0, 0.0)}, towards(eye, probe.origin));
  const glm::dvec3 moved = drag.origin(towards(eye, glm::dvec3(1.5, 1.4, -2.5)), std::nullopt);
  EXPECT_NEAR(glm::dot(moved - probe.origin, forward), 0.0, 1e-12);
  EXPECT_GT(glm::length(moved - probe.origin), 0.5);
  const glm::dvec3 raised = drag.origin(towards(eye, probe.origin + glm::dvec3(0.0, 0.7, 0.0)), 1);
  EXPECT_NEAR(glm::length(raised - probe.origin - glm::dvec3(0.0, 0.7, 0.0)), 0.0, 1e-9);
}

}  // namespace
}  // namespace boxprobe
