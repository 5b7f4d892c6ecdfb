#include "filters/vtk/widgets/drag_snap.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/fit/rays/surface_rays.h"

namespace boxprobe {

namespace {

constexpr double kFacingCosine = 0.95;  ///< 18 degrees: a wall on which a face could lie
constexpr double kStepPixels = 6.0;     ///< minimum grid spacing on the screen

double roundTo(double value, double step) {
  return std::round(value / step) * step;
}

}  // namespace

DragSnap::DragSnap(const SurfaceRays* surfaces, const Ray& pointer, double metresPerPixel, const SnapSettings& settings)
    : surfaces_(surfaces),
      pointer_(pointer),
      reach_(settings.catchPixels * metresPerPixel),
      step_(std::min(settings.largestStep,
                     std::pow(10.0, std::ceil(std::log10(std::max(kStepPixels * metresPerPixel, 1e-6)))))),
      turnStepDegrees_(settings.turnStepDegrees) {}

double DragSnap::face(const glm::dvec3& point, const glm::dvec3& axis, double offset, const glm::dvec3& inside) {
  if (surfaces_ != nullptr) {
    if (const auto hit = surfaces_->first(pointer_.origin, pointer_.direction);
        hit && std::abs(glm::dot(hit->normalWorld, axis)) > kFacingCosine) {
      target_ = SnapTarget::Pointed;
      return glm::dot(pointer_.origin + hit->distance * pointer_.direction - point, axis);
    }
    if (const auto hit = surfaces_->first(inside, axis)) {
      const double wall = glm::dot(inside - point, axis) + hit->distance;
      if (std::abs(wall - offset) < reach_) {
        target_ = SnapTarget::Opposite;
        return wall;
      }
    }
  }
  return grid(point, axis, offset);
}

double DragSnap::grid(const glm::dvec3& point, const glm::dvec3& axis, double offset) {
  target_ = SnapTarget::Grid;
  const double at = glm::dot(point, axis);
  return roundTo(at + offset, step_) - at;
}

glm::dvec3 DragSnap::grid(const glm::dvec3& point) {
  target_ = SnapTarget::Grid;
  return {roundTo(point.x, step_), roundTo(point.y, step_), roundTo(point.z, step_)};
}

}  // namespace boxprobe
