// What a planar mirror's shader asks before it looks for moving objects.
#include "filters/math/shared/mirror_math.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace boxprobe {
namespace {

using glm::vec3;
using glm::vec4;

/// Looks along -z from the origin: u is 0.5 + 0.5 x / -z, and v likewise.
shading::MirrorLook look(const MirrorTexels* picture) {
  shading::MirrorLook look{};
  look.toU = vec4(0.5f, 0.0f, -0.5f, 0.0f);
  look.toV = vec4(0.0f, 0.5f, -0.5f, 0.0f);
  look.toW = vec4(0.0f, 0.0f, -1.0f, 0.0f);
  look.normal = vec3(0.0f, 1.0f, 0.0f);
  look.farHeight = 2.0f;
  look.texelSize = 0.25f;
  look.sizeX = look.sizeY = 8.0f;
  look.maxLevel = 3.0f;
  look.picture = picture;
  return look;
}

TEST(MirrorMath, WhatReachesBehindTheMirroredEyeMayMeetAnything) {
  MirrorTexels empty;
  for (int size = 8; size > 0; size /= 2) {
    MirrorTexels::Level level;
    level.width = level.height = size;
    level.color.assign(static_cast<std::size_t>(size * size), vec4(0.0f));
    level.heights = level.color;
    empty.levels.push_back(level);
  }
  const vec3 from(0.1f, -0.2f, -3.0f);
  const vec3 away = glm::normalize(vec3(0.05f, 1.0f, -0.1f)), back = glm::normalize(vec3(0.05f, 0.3f, 1.0f));
  EXPECT_FALSE(shading::mirrorReaches(look(&empty), from, away, 0.001f)) << "nothing moves in the picture";
  EXPECT_TRUE(shading::mirrorReaches(look(&empty), from, back, 0.001f)) << "the picture does not show it";
}

}  // namespace
}  // namespace boxprobe
