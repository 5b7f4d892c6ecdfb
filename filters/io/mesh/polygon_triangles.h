// Polygons of model files as triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace boxprobe {

/// Twice the polygon's area times its unit normal (Newell's sum), also of a polygon that is concave or not plane.
glm::dvec3 polygonNormal(const std::vector<glm::dvec3>& corners);

/// What the polygons of one file may take in all: corners tested against triangles. A polygon of 4096 corners that does
/// not cross itself takes less than a million; one made to take long takes 134 million, and a file may hold thousands.
struct PolygonTests {
  std::uint64_t left = 2000000000;
};

/// A polygon's corners, in their order, as triangles of the same winding: always two fewer than corners. Convex ones
/// become fans around the first corner, others lose ears. Where no tests are left, as in a polygon that crosses itself,
/// triangles may overlap.
std::vector<std::array<std::uint32_t, 3>> polygonTriangles(const std::vector<glm::dvec3>& corners, PolygonTests& tests);

}  // namespace boxprobe
