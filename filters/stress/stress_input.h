// One input of the stress test: a probe, a pixel and a technique's parameters as plain floats, and the same as a row of
// numbers that can be printed and typed in again. Made by stress_classes, used by stress_subjects; knows neither.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/math/shared/shared_math.h"
#include "filters/math/technique/parameter_table.h"

namespace boxprobe::stress {

struct StressInput {
  /// "World": the box's own axes, but for the capture origin C, which everything else is near to.
  glm::vec3 originWorld{0.0f};
  glm::vec3 boxMinWorld{-1.0f}, boxMaxWorld{1.0f};
  glm::vec3 positionWorld{0.0f};
  glm::vec3 normal{0.0f, 1.0f, 0.0f}, view{0.0f, 1.0f, 0.0f}, reflection{0.0f, 1.0f, 0.0f};  ///< as position is
  glm::vec3 turn{0.0f};  ///< axis times angle (radians): how the box is turned against position, normal, view
  float roughness = 0.25f;
  float maxLevel = 6.0f;
  float blendDistance = 1.0f;  ///< of all six faces, scene units
  float bevel = 0.0f;          ///< scene units
  glm::ivec2 pixel{0};
  int frame = 0;
  shading::TechniqueParameters parameters = standardParameters();
};

/// What a technique gets: relative to C, along the box's axes, computed in float as the shader computes it. Broken
/// pixels are mended as both hosts mend them (shaders/shared/finite.glsl). `slot` is not set.
struct LocalInput {
  shading::ProbeShape probe{};
  shading::ShadingPoint point{};
};
LocalInput localInput(const StressInput& input);

/// The rotation that `turn` stands for, rounded to float as the host hands it to the shader.
glm::mat3 worldFromProbe(const glm::vec3& turn);

/// As localInput, before broken pixels are mended: what programs without a guard work on.
LocalInput unguardedInput(const StressInput& input);

/// Names of the numbers, in the order of numbersOf(); parameters of the technique at hand last.
std::vector<std::string> numberNames(const std::vector<const ParameterRow*>& parameters);
/// Whole numbers are exact in a float, so is everything else: it was one.
std::vector<float> numbersOf(const StressInput& input, const std::vector<const ParameterRow*>& parameters);
/// The inverse. Throws std::invalid_argument unless there are as many numbers as names.
StressInput inputFrom(const std::vector<float>& numbers, const std::vector<const ParameterRow*>& parameters);

/// Longest side of the box; of a box that is a point, of no length, the distance to it.
double boxSize(const shading::ProbeShape& probe, const glm::vec3& position);

}  // namespace boxprobe::stress
