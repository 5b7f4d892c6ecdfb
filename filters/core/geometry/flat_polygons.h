// Triangles as the flat convex polygons they were made from: what a modeller draws as a rectangle comes as two or two
// hundred triangles. Called for the lamps of a scene; plain geometry.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace boxprobe {

struct FlatPolygon {
  std::vector<glm::dvec3> corners;  ///< convex, none on the line between its neighbours; as the triangles go round
  std::size_t component = 0;        ///< polygons that touch in a vertex, directly or by others, have the same number
};

/// Triangles that share an edge and lie in one plane, within 0.1 degrees and 1e-4 of the whole's size, are one polygon;
/// where that is not convex or has holes, several. Vertices are the same if their positions are equal. Triangles
/// without area and repeated ones are left out; both sides of a sheet are two polygons.
std::vector<FlatPolygon> flatPolygons(const std::vector<glm::dvec3>& positions,
                                      const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// The polygon with at most `most` corners, of the same area: corners that change it least go first, then it grows
/// about its centroid.
std::vector<glm::dvec3> withFewerCorners(std::vector<glm::dvec3> corners, std::size_t most);

/// Of a flat polygon: half the sum of its corners' cross products. Its length is the area, its direction the normal.
glm::dvec3 areaVector(const std::vector<glm::dvec3>& corners);
glm::dvec3 polygonCentroid(const std::vector<glm::dvec3>& corners);

}  // namespace boxprobe
