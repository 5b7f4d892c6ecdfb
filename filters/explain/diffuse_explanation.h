// The sources of a probe's diffuse light at a point: its lamps as shapes and the nodes of its lattice. Lengths in scene
// units, light linear, before exposure.
#pragma once

#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace boxprobe {

/// One polygon of a lamp; an object may have several.
struct LampAtPoint {
  std::string node;       ///< the object it belongs to
  glm::vec3 light{0.0f};  ///< irradiance over pi from it
  float filled = 0.0f;    ///< visible share, 0 to 1, of the cosine hemisphere about N that it fills
};

struct LatticeNodeAtPoint {
  glm::ivec3 node{0};             ///< along the axes of the box, from 0
  glm::vec3 positionProbe{0.0f};  ///< relative to the capture origin, box axes
  float weight = 0.0f;
  bool known = true;  ///< false: it lies within something and has the light of its neighbours
};

struct DiffuseExplanation {
  std::vector<LampAtPoint> lamps;         ///< those that give light here, the brightest first
  std::vector<LatticeNodeAtPoint> nodes;  ///< those with weight, the heaviest first; none: the capture's coefficients
  glm::ivec3 nodeCount{0};                ///< of the lattice along each axis
  int cutWays = 0;                        ///< of the lattice: from a node to the next, with surfaces between
  glm::vec3 lattice{0.0f};                ///< irradiance over pi from the lattice
  float known = 0.0f;                     ///< weight of the nodes whose light is their own, 0 to 1
};

}  // namespace boxprobe
