// The conventions of other programs, as documented in cube_layout.h and filters/io/README.md: OpenEXR's against its own
// functions, Blender's and Unity's against the formulas and tables they publish.
#include <OpenEXR/ImfEnvmap.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/io/cube/cube_layout.h"

namespace boxprobe {
namespace {

glm::vec3 asGlm(const Imath::V3f& v) {
  return {v.x, v.y, v.z};
}

TEST(CubeLayouts, FacesLieWhereOpenExrSaysTheyDo) {
  constexpr int kSize = 5;
  const Imath::Box2i window({0, 0}, {kSize - 1, 6 * kSize - 1});
  for (int face = 0; face < 6; ++face) {
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const auto exrFace = static_cast<Imf::CubeMapFace>(face);
        const Imath::V2f inFace(static_cast<float>(x), static_cast<float>(y));
        const glm::vec3 wanted = asGlm(Imf::CubeMap::direction(exrFace, window, inFace));
        const Imath::V2f pixel = Imf::CubeMap::pixelPosition(exrFace, window, inFace);
        const auto at = [](float p) { return static_cast<float>(texelCoordinate(p, kSize, TexelPlacement::Edges)); };
        const CubePoint point = mirroredOpenExr({face, at(pixel.x), at(pixel.y - static_cast<float>(face * kSize))});
        EXPECT_LT(glm::distance(shading::cubeDirection(point.face, point.s, point.t), wanted), 1e-6f) << face;
      }
    }
  }
}

TEST(CubeLayouts, LatLongIsOpenExrs) {
  const Imath::Box2i window({0, 0}, {15, 7});
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      const glm::vec3 wanted =
          asGlm(Imf::LatLongMap::direction(window, Imath::V2f(static_cast<float>(x), static_cast<float>(y))));
      const glm::vec3 direction =
          latLongDirection(texelCoordinate(x, 16, TexelPlacement::Edges), texelCoordinate(y, 8, TexelPlacement::Edges));
      EXPECT_LT(glm::distance(direction, wanted), 1e-6f);
      if (y == 0 || y == 7) continue;  // at a pole every longitude is right
      const glm::dvec2 point = latLongPoint(direction);
      EXPECT_NEAR(std::cos(point.x * 3.14159265), std::cos(texelCoordinate(x, 16, TexelPlacement::Edges) * 3.14159265),
                  1e-6);
      EXPECT_NEAR(point.y, texelCoordinate(y, 8, TexelPlacement::Edges), 1e-6);
    }
  }
  EXPECT_LT(glm::distance(latLongDirection(0.0, 0.0), {0, 0, 1}), 1e-6f);
  EXPECT_LT(glm::distance(latLongDirection(-0.5, 0.0), {1, 0, 0}), 1e-6f);
  EXPECT_LT(glm::distance(latLongDirection(0.0, -1.0), {0, 1, 0}), 1e-6f);
}

constexpr double kPi = 3.14159265358979323846;

std::vector<glm::vec3> someDirections() {
  std::vector<glm::vec3> directions;
  for (int i = 0; i < 200; ++i) {
    const float x = static_cast<float>(i);
    directions.push_back({std::sin(1.3f * x), std::sin(2.1f * x + 1.0f), std::cos(0.7f * x + 2.0f)});
  }
  return directions;
}

TEST(CubeLayouts, BlenderShowsOurLatLongUprightAndUnmirroredAfterAQuarterTurn) {
  // Cycles: u = 1/2 - atan2(y, x) / 2 pi, v = 1 - acos(z / length) / pi from the bottom, in Blender's axes, Z up, into
  // which its glTF importer turns (x, y, z) as (x, -z, y). With 90 degrees as the Mapping node's rotation about Z, each
  // direction finds its own texel.
  for (const glm::vec3& direction : someDirections()) {
    const glm::vec3 blender(direction.x, -direction.z, direction.y);
    const glm::vec3 turned(-blender.y, blender.x, blender.z);
    const double u = 0.5 - std::atan2(turned.y, turned.x) / (2.0 * kPi);
    const double v = 1.0 - std::acos(turned.z / glm::length(turned)) / kPi;
    const glm::dvec2 point = latLongPoint(direction);
    EXPECT_NEAR(std::cos(2.0 * kPi * u), std::cos(kPi * (point.x + 1.0)), 1e-5);
    EXPECT_NEAR(std::sin(2.0 * kPi * u), std::sin(kPi * (point.x + 1.0)), 1e-5);
    EXPECT_NEAR(1.0 - v, 0.5 * point.y + 0.5, 1e-5);
  }
}

TEST(CubeLayouts, ALeftHandedWorldSwapsTheXFacesAndMirrorsAllSix) {
  // Direct3D, and so Unity and CubeMapGen, look faces up by the same table of numbers as OpenGL: equal numbers, equal
  // texel. A scene that a left-handed program imports with x negated therefore needs its faces like this.
  for (const glm::vec3& direction : someDirections()) {
    const CubePoint ours = cubePoint(direction), theirs = cubePoint({-direction.x, direction.y, direction.z});
    EXPECT_EQ(theirs.face, ours.face < 2 ? 1 - ours.face : ours.face);
    EXPECT_EQ(theirs.s, -ours.s);
    EXPECT_EQ(theirs.t, ours.t);
  }
}

}  // namespace
}  // namespace boxprobe
