// Positions of files in double precision, as maps and surveys have them, far from the origin.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace boxprobe {

/// A model's positions as meshes hold them, and where they are.
struct NearPositions {
  std::vector<glm::vec3> positions;
  glm::dmat4 worldFromModel{1.0};  ///< the transform of the model's instances: a translation
};

/// Subtracts the centre of the bounds, in double precision, where it is farther from the origin than four times the
/// model's size: single precision would round 431000 to 0.03. Nearer models keep their numbers. Throws an InputError
/// that starts with `place` for a point that is not finite or beyond 1e18.
NearPositions nearPositions(const std::vector<glm::dvec3>& positions, const std::string& place);

}  // namespace boxprobe
