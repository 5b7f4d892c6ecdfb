// Ambient occlusion: how much of an even sky is open at places of a scene, past what stands in the scene itself. In a
// lattice around everything, traced once as the scene stands still; looked up by surfaces that the sky lights
// (shaders/shared/sky_openness.glsl).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "filters/core/geometry/sight_lines.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

struct SkyOpenness {
  glm::dvec3 low{0.0};   ///< of the first node, world
  double spacing = 0.0;  ///< of nodes along each axis, scene units
  glm::ivec3 nodes{0};
  /// RGBA, a node after the other, x fastest: the first moment of what is open and its share, 0 to 255.
  std::vector<std::uint8_t> texels;
  std::size_t rays = 0;  ///< that were traced

  bool empty() const { return texels.empty(); }
  /// So far off a surface it is looked up, where nodes behind the surface have little say. Scene units.
  double off() const { return spacing; }
  /// Share of the sky's diffuse light that is left at a place of a surface (world), facing `normal` (unit), as draws
  /// have it; linear between nodes. Not of an empty lattice.
  float at(const glm::dvec3& position, const glm::vec3& normal) const;
};

/// Of what stands in `bounds` (world); empty where nothing does or `stop` said true. Deterministic.
SkyOpenness tracedSkyOpenness(const SightLines& lines, const Box& bounds, const std::function<bool()>& stop = {});

}  // namespace boxprobe
