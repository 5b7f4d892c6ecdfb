#include "filters/reference/trace/shadow_light.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/geometry/light_shadow.h"

namespace boxprobe {

namespace {

constexpr double kFullTurn = 6.283185307179586;

/// Transmittance of one ray over `distance`.
glm::dvec3 alongRay(const SceneTracer& tracer, glm::dvec3 origin, const glm::dvec3& direction, double distance,
                    RaySees sees) {
  glm::dvec3 through(1.0);
  constexpr int kMostPanes = 16;
  for (int i = 0; i < kMostPanes; ++i) {
    const auto hit = tracer.firstHit(origin, direction, sees);
    if (!hit || hit->distance >= distance) return through;
    const SurfacePoint surface = tracer.surface(*hit, origin);
    if (tracer.object(*hit).material.alphaMode != AlphaMode::Blend) return glm::dvec3(0.0);
    through *= (1.0 - static_cast<double>(surface.opacity)) * glm::dvec3(surface.albedo);
    // On the far side of the pane, as far off it as awayFrom() is on this side.
    const glm::dvec3 next = 2.0 * hit->positionWorld - tracer.awayFrom(*hit);
    distance -= glm::length(next - origin);
    origin = next;
  }
  return glm::dvec3(0.0);
}

}  // namespace

glm::dvec3 lightThrough(const SceneTracer& tracer, const glm::dvec3& away, const Light& light, int side, RaySees sees) {
  const bool directional = light.type == LightType::Directional;
  const glm::dvec3 to = directional ? -glm::normalize(light.direction) : light.position - away;
  const double distance = directional ? 1.0 : glm::length(to);
  const double radius =
      directional ? std::tan(0.5 * glm::radians(light.angleDegrees)) : static_cast<double>(light.radius);
  const glm::dvec3 forward = to / std::max(distance, 1.0e-30);
  const glm::dvec3 right = glm::normalize(
      glm::cross(forward, std::abs(forward.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0)));
  const glm::dvec3 up = glm::cross(right, forward);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < side * side; ++i) {
    // Equal areas: radius by the root of one coordinate, angle by the other.
    const double r = radius * std::sqrt((i % side + 0.5) / side), angle = kFullTurn * (i / side + 0.5) / side;
    const glm::dvec3 target = to + r * (std::cos(angle) * right + std::sin(angle) * up);
    const double length = glm::length(target);
    sum += alongRay(tracer, away, target / length, directional ? 1.0e30 : length, sees);
  }
  return sum / static_cast<double>(side * side);
}

}  // namespace boxprobe
