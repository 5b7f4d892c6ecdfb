// See ray_pixels.h.
#include "filters/vtk/rays/ray_pixels.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

PixelRays::PixelRays(vtkCamera* camera, int width, int height)
    : width_(std::max(width, 1)), height_(std::max(height, 1)), parallel_(camera->GetParallelProjection() != 0) {
  glm::dvec3 focus, viewUp;
  camera->GetPosition(&eye_.x);
  camera->GetFocalPoint(&focus.x);
  camera->GetViewUp(&viewUp.x);
  forward_ = glm::normalize(focus - eye_);
  right_ = glm::normalize(glm::cross(forward_, viewUp));
  up_ = glm::cross(right_, forward_);
  const double halfAngle = 0.5 * camera->GetViewAngle() * 3.14159265358979323846 / 180.0;
  halfHeight_ = parallel_ ? camera->GetParallelScale() : std::tan(halfAngle);
  halfWidth_ = halfHeight_ * width_ / height_;
}

PixelRay PixelRays::through(double x, double y) const {
  const double s = (2.0 * x / width_ - 1.0) * halfWidth_;
  const double t = (1.0 - 2.0 * y / height_) * halfHeight_;
  const glm::dvec3 aside = s * right_ + t * up_;
  if (parallel_) return {eye_ + aside, forward_};
  return {eye_, glm::normalize(forward_ + aside)};
}

}  // namespace boxprobe
