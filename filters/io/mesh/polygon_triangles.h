// Polygons of model files as triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace boxprobe {

/// Twice the polygon's area times its unit normal (Newell's sum), also of a polygon that is concave or not plane.
glm::dvec3 polygonNormal(const std::vector<glm::dvec3>& corners);

/// A polygon's corners, in their order, as triangles of the same winding: always two fewer than corners. Convex ones
/// become fans around the first corner, others lose ears.
std::vector<std::array<std::uint32_t, 3>> polygonTriangles(const std::vector<glm::dvec3>& corners);

}  // namespace boxprobe
