// Polygons of model files as triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace boxprobe {

/// Twice the polygon's area times its unit normal (Newell's sum), also of a polygon that is concave or not plane.
glm::dvec3 polygonNormal(const std::vector<glm::dvec3>& corners);

/// What the polygons of one file may take in all: corners looked at. A polygon of 4096 corners takes at most about 42
/// million, and seldom one, but a file may hold thousands.
struct PolygonTests {
  std::uint64_t left = 4000000000;
};

/// For a model whose polygons took all tests.
inline constexpr const char* kPolygonsTooHard =
    "has polygons that take too long to divide; some of their triangles may overlap; save it as triangles";

/// A polygon's corners, in their order, as triangles of the same winding: always two fewer than corners. Convex ones
/// become fans around the first corner, others lose ears. In a polygon that crosses itself, and where no tests are
/// left, triangles may overlap.
std::vector<std::array<std::uint32_t, 3>> polygonTriangles(const std::vector<glm::dvec3>& corners, PolygonTests& tests);

}  // namespace boxprobe
