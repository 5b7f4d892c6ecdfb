// Captures without the lamps in them.
#include "filters/math/cube/lamp_free.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace {

using namespace boxprobe;
using glm::vec3;
using glm::vec4;

// A square at x = 2, turned towards the origin: y from -0.3 to 0.5, z from -0.2 to 0.4.
LampPolygon squareLamp() {
  LampPolygon lamp;
  lamp.count = 4;
  lamp.corners[0] = {2, -0.3f, -0.2f};
  lamp.corners[1] = {2, -0.3f, 0.4f};
  lamp.corners[2] = {2, 0.5f, 0.4f};
  lamp.corners[3] = {2, 0.5f, -0.2f};
  return lamp;
}

bool onLamp(const vec3& d) {
  if (d.x <= 0.0f) return false;
  const float y = 2.0f * d.y / d.x, z = 2.0f * d.z / d.x;
  return y > -0.3f && y < 0.5f && z > -0.2f && z < 0.4f;
}

template <typename Value>
CubeMap cubeOf(int size, const Value& value) {
  CubeMap map(size, 1);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const float s = (2.0f * static_cast<float>(column) + 1.0f) / static_cast<float>(size) - 1.0f;
        const float t = (2.0f * static_cast<float>(row) + 1.0f) / static_cast<float>(size) - 1.0f;
        map.setTexel(0, face, column, row, value(shading::cubeDirection(face, s, t)));
      }
    }
  }
  return map;
}

vec4 lit(const vec3& d) {
  return onLamp(d) ? vec4(300.0f, 200.0f, 100.0f, 1.0f) : vec4(0.2f, d.x > 0.0f ? 0.3f : 0.1f, 0.4f, 1.0f);
}

float brightest(const CubeMap& map) {
  float most = 0.0f;
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < map.faceSize() * map.faceSize(); ++i) most = std::max(most, map.face(0, face)[4 * i]);
  }
  return most;
}

TEST(LampFree, ALampBecomesWhatIsAroundIt) {
  const CubeMap capture = cubeOf(32, lit);
  ASSERT_EQ(brightest(capture), 300.0f);
  const CubeMap free = withoutLamps(capture, CubeMap(), {squareLamp()});
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < 32; ++row) {
      for (int column = 0; column < 32; ++column) {
        const vec4 before = capture.texel(0, face, column, row), after = free.texel(0, face, column, row);
        if (before.x < 1.0f) {
          EXPECT_NEAR(glm::length(after - before), 0.0f, 1e-6f);
        } else {
          EXPECT_NEAR(glm::length(after - vec4(0.2f, 0.3f, 0.4f, 1.0f)), 0.0f, 1e-5f);
        }
      }
    }
  }
}

TEST(LampFree, WhatHidesALampStays) {
  const CubeMap capture = cubeOf(32, lit);
  // As captures have it: the distance in x alone.
  const CubeMap near =
      cubeOf(32, [](const vec3& d) { return vec4(onLamp(d) ? 1.2f : 2.0f * glm::length(d), 0.0f, 0.0f, 1.0f); });
  EXPECT_EQ(brightest(withoutLamps(capture, near, {squareLamp()})), 300.0f);  // something bright at 1.2 m before it
  const CubeMap far = cubeOf(32, [](const vec3& d) { return vec4(onLamp(d) ? 2.0f * glm::length(d) / d.x : 2.5f); });
  EXPECT_LT(brightest(withoutLamps(capture, far, {squareLamp()})), 0.3f);
  EXPECT_LT(brightest(withoutLamps(capture, cubeOf(32, [](const vec3&) { return vec4(0.0f); }), {squareLamp()})), 0.3f);
}

TEST(LampFree, ALampsBackIsNoLamp) {
  LampPolygon turned = squareLamp();
  std::swap(turned.corners[1], turned.corners[3]);
  const CubeMap capture = cubeOf(32, lit);
  EXPECT_EQ(brightest(withoutLamps(capture, CubeMap(), {turned})), 300.0f);
  turned.bothSides = true;
  EXPECT_LT(brightest(withoutLamps(capture, CubeMap(), {turned})), 0.3f);
}

// All that is seen are lamps: nothing is left; a lamp about the origin, or a broken one, does no harm.
TEST(LampFree, DegenerateLampsAreTaken) {
  const CubeMap capture = cubeOf(8, [](const vec3&) { return vec4(7.0f); });
  std::vector<LampPolygon> all;
  for (int face = 0; face < 6; ++face) {
    LampPolygon wall;
    wall.count = 4;
    wall.bothSides = true;
    const vec3 places[4] = {shading::cubeDirection(face, -1.5f, -1.5f), shading::cubeDirection(face, 1.5f, -1.5f),
                            shading::cubeDirection(face, 1.5f, 1.5f), shading::cubeDirection(face, -1.5f, 1.5f)};
    std::copy(std::begin(places), std::end(places), wall.corners.begin());
    all.push_back(wall);
  }
  EXPECT_EQ(brightest(withoutLamps(capture, CubeMap(), all)), 0.0f);
  LampPolygon none, through = squareLamp();
  for (vec3& corner : through.corners) corner.x = 0.0f;  // the origin lies in it
  through.bothSides = true;
  EXPECT_EQ(brightest(withoutLamps(capture, CubeMap(), {none, through})), 7.0f);
  // One of the points by which its background is found is the origin itself, which has no direction.
  LampPolygon about;
  about.count = 4;
  const vec3 corners[4] = {{0, 1, 0}, {0, 0, 1}, {0, -2, -1}, {0, 0, -1}};
  std::copy(std::begin(corners), std::end(corners), about.corners.begin());
  const CubeMap sides = cubeOf(8, [](const vec3& d) { return vec4(std::abs(d.x) == 1.0f ? 100.0f : 7.0f); });
  EXPECT_EQ(lampBackgrounds(sides, {about}).at(0), vec3(7.0f)) << "all else of it lies in the plane x = 0";
}

TEST(LampFree, AShapeGivesWhatItAddsToItsPlace) {
  const CubeMap free = withoutLamps(cubeOf(32, lit), CubeMap(), {squareLamp()});
  LampPolygon other = squareLamp();  // the same behind the origin: nothing was taken out there
  for (vec3& corner : other.corners) corner.x = -corner.x;
  const std::vector<vec3> backgrounds = lampBackgrounds(free, {squareLamp(), other});
  ASSERT_EQ(backgrounds.size(), 2u);
  EXPECT_NEAR(glm::length(backgrounds[0] - vec3(0.2f, 0.3f, 0.4f)), 0.0f, 1e-5f);
  EXPECT_NEAR(glm::length(backgrounds[1] - vec3(0.2f, 0.1f, 0.4f)), 0.0f, 1e-5f);
  const vec3 adds = withoutBackground({300.0f, 200.0f, 0.25f}, backgrounds[0]);
  EXPECT_NEAR(adds.x, 299.8f, 1e-3f);
  EXPECT_NEAR(adds.y, 199.7f, 1e-3f);
  EXPECT_EQ(adds.z, 0.0f);  // dimmer than what stands there
}

}  // namespace
