// See fit_scene.h.
#include "app/session/fit_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace boxprobe {

Probe fittedProbe(const Box& bounds) {
  const double diagonal = glm::length(bounds.size());
  Probe probe;
  probe.origin = bounds.center();
  // The outermost surfaces lie inside the box, not on its faces, where the sign of a rounding error would decide
  // whether a pixel belongs to the probe; it also gives a flat model a box with a volume.
  const glm::dvec3 margin(std::max(1e-3 * diagonal, 1e-6));
  probe.box = {bounds.min - margin, bounds.max + margin};
  // Nothing is outside the box, so there is nothing to blend into; a blend distance would fade the walls to the sky.
  probe.blendDistance = {glm::dvec3(0.0), glm::dvec3(0.0)};
  probe.nearDistance = std::max(1e-4 * diagonal, 1e-6);
  probe.farDistance = std::max(2.0 * diagonal, probe.nearDistance * 10.0);
  return probe;
}

Camera fittedCamera(const Box& bounds) {
  Camera camera;
  const double radius = std::max(0.5 * glm::length(bounds.size()), 1e-6);
  const double distance = radius / std::sin(0.5 * glm::radians(camera.verticalFovDegrees));
  camera.target = bounds.center();
  camera.position = camera.target + distance * glm::normalize(glm::dvec3(0.5, 0.35, 1.0));
  return camera;
}

}  // namespace boxprobe
