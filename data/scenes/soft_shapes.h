// Shapes of furniture: boxes with rounded edges, cushions, tubes, turned pieces and leaves. Called by the scenes; knows
// nothing of materials or files. All about or from the points that are given, metres; textures repeat every `metres`.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "data/scenes/mesh_builder.h"

namespace boxprobe::scenes {

/// A box whose edges are cut by `bevel` and shaded round; u runs along the longer side of each face, from `shift` on.
MeshBuilder bevelBox(glm::dvec3 low, glm::dvec3 high, double bevel, double metres, glm::dvec2 shift = {});

/// A box with edges of radius `radius` whose faces swell by `bulge` in their middles: `cells` a side.
MeshBuilder cushion(glm::dvec3 low, glm::dvec3 high, double radius, glm::dvec3 bulge, int cells, double metres);

/// A round bar through `points`, `radii` thick there, with flat ends.
MeshBuilder tube(const std::vector<glm::dvec3>& points, const std::vector<double>& radii, int slices);

/// A profile of (radius, height) points turned about +Y, outside to the left going up; each run is smooth in itself,
/// and runs meet in sharp edges.
MeshBuilder turned(const std::vector<std::vector<glm::dvec2>>& runs, int slices);

/// A leaf from `base`, `length` long towards `along`, bending towards `down`, as wide as `width`.
MeshBuilder leaf(glm::dvec3 base, glm::dvec3 along, glm::dvec3 down, double length, double width, double bend);

}  // namespace boxprobe::scenes
