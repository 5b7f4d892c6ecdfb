// Recovers flat convex polygons from triangles: a rectangle of a modelling program arrives as two or two hundred
// triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace boxprobe {

struct FlatPolygon {
  std::vector<glm::dvec3> corners;  ///< convex, no three in a line; in the winding order of the triangles
  std::size_t component = 0;        ///< polygons that touch in a vertex, directly or through others, share the number
};

/// Triangles that share an edge and lie in one plane, within 0.1 degrees and 1e-4 of the whole's size, become one
/// polygon, or several if that is not convex or has holes. Vertices are the same if their positions are equal.
/// Degenerate and repeated triangles are left out; both sides of a sheet are two polygons.
std::vector<FlatPolygon> flatPolygons(const std::vector<glm::dvec3>& positions,
                                      const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// The polygon simplified to at most `most` corners, of the same area: removes the corners that change it least, then
/// scales it about its centroid.
std::vector<glm::dvec3> withFewerCorners(std::vector<glm::dvec3> corners, std::size_t most);

/// Half the sum of the cross products of a flat polygon's corners. Its length is the area, its direction the normal.
glm::dvec3 areaVector(const std::vector<glm::dvec3>& corners);
glm::dvec3 polygonCentroid(const std::vector<glm::dvec3>& corners);

}  // namespace boxprobe
