// One input of the stress test: a probe, a pixel and a technique's parameters as floats, convertible to a row of
// numbers that can be printed and typed in again.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/math/shared/shared_math.h"
#include "filters/math/technique/parameter_table.h"

namespace boxprobe::stress {

struct StressInput {
  /// "World": along the box's own axes, but not relative to the capture origin C, which everything else is near to.
  glm::vec3 originWorld{0.0f};
  glm::vec3 boxMinWorld{-1.0f}, boxMaxWorld{1.0f};
  glm::vec3 positionWorld{0.0f};
  glm::vec3 normal{0.0f, 1.0f, 0.0f}, view{0.0f, 1.0f, 0.0f}, reflection{0.0f, 1.0f, 0.0f};  ///< as position is
  glm::vec3 turn{0.0f};  ///< axis times angle (radians): rotation of the box against position, normal, view
  float roughness = 0.25f;
  float maxLevel = 6.0f;
  float blendDistance = 1.0f;  ///< of all six faces, scene units
  float bevel = 0.0f;          ///< scene units
  glm::ivec2 pixel{0};
  int frame = 0;
  shading::TechniqueParameters parameters = standardParameters();
};

/// The inputs of a technique: relative to C, along the box's axes, computed in float as in the shader. Broken pixels
/// are repaired as by both hosts (shaders/shared/finite.glsl). `slot` is not set.
struct LocalInput {
  shading::ProbeShape probe{};
  shading::ShadingPoint point{};
};
LocalInput localInput(const StressInput& input);

/// The rotation of `turn`, rounded to float as the host passes it to the shader.
glm::mat3 worldFromProbe(const glm::vec3& turn);

/// As localInput, without the repair of broken pixels: the input of programs without a guard.
LocalInput unguardedInput(const StressInput& input);

/// Names of the numbers, in the order of numbersOf(); the technique's parameters come last.
std::vector<std::string> numberNames(const std::vector<const ParameterRow*>& parameters);
/// Exact: integers fit into a float, and everything else is one.
std::vector<float> numbersOf(const StressInput& input, const std::vector<const ParameterRow*>& parameters);
/// The inverse. Throws std::invalid_argument unless the counts match.
StressInput inputFrom(const std::vector<float>& numbers, const std::vector<const ParameterRow*>& parameters);

/// Longest side of the box; for a degenerate box the distance to it.
double boxSize(const shading::ProbeShape& probe, const glm::vec3& position);

}  // namespace boxprobe::stress
