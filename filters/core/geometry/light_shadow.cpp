#include "filters/core/geometry/light_shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

bool lightOutside(const Light& light, const Probe& probe) {
  if (light.type == LightType::Directional) return true;
  const glm::dvec3 center = probe.box.center();
  const glm::dvec3 p = center + glm::transpose(rotationMatrix(probe.rotationDegrees)) * (light.position - center);
  return glm::any(glm::lessThan(p, probe.box.min)) || glm::any(glm::greaterThan(p, probe.box.max));
}

float LightSize::tangentAt(float distance) const {
  return tangent + radius / std::max(distance, 1.0e-6f);  // as shaders/gpu/coverage.glsl
}

LightSize lightSize(const Light& light) {
  if (light.type != LightType::Directional) return {0.0f, static_cast<float>(light.radius)};
  return {static_cast<float>(std::tan(0.5 * glm::radians(light.angleDegrees))), 0.0f};
}

float levelsPerUnit(const glm::vec3& boxMin, const glm::vec3& boxMax, float maxLevel) {
  return maxLevel / std::max(glm::length(boxMax - boxMin), 1.0e-6f);
}

}  // namespace boxprobe
