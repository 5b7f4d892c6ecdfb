#include "filters/vtk/widgets/view_projection.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace boxprobe {

ViewProjection::ViewProjection(vtkCamera* camera, double widthPixels, double heightPixels)
    : eye_(0.0),
      forward_(0.0),
      right_(0.0),
      up_(0.0),
      halfHeight_(1.0),
      width_(std::max(widthPixels, 1.0)),
      height_(std::max(heightPixels, 1.0)),
      parallel_(camera->GetParallelProjection() != 0) {
  const double* position = camera->GetPosition();
  const double* direction = camera->GetDirectionOfProjection();
  const double* viewUp = camera->GetViewUp();
  eye_ = {position[0], position[1], position[2]};
  forward_ = glm::normalize(glm::dvec3(direction[0], direction[1], direction[2]));
  right_ = glm::normalize(glm::cross(forward_, glm::dvec3(viewUp[0], viewUp[1], viewUp[2])));
  up_ = glm::cross(right_, forward_);
  halfHeight_ = parallel_ ? camera->GetParallelScale() : std::tan(glm::radians(0.5 * camera->GetViewAngle()));
}

std::optional<glm::dvec2> ViewProjection::pixel(const glm::dvec3& pointWorld) const {
  const glm::dvec3 d = pointWorld - eye_;
  const double depth = glm::dot(d, forward_);
  if (!parallel_ && depth <= 0.0) return std::nullopt;
  const double scale = 0.5 * height_ / (halfHeight_ * (parallel_ ? 1.0 : depth));
  return glm::dvec2(0.5 * width_ + scale * glm::dot(d, right_), 0.5 * height_ - scale * glm::dot(d, up_));
}

Ray ViewProjection::ray(const glm::dvec2& pixel) const {
  const double x = (pixel.x - 0.5 * width_) / (0.5 * height_) * halfHeight_;
  const double y = (0.5 * height_ - pixel.y) / (0.5 * height_) * halfHeight_;
  if (parallel_) return {eye_ + x * right_ + y * up_, forward_};
  return {eye_, glm::normalize(forward_ + x * right_ + y * up_)};
}

double ViewProjection::metresPerPixel(const glm::dvec3& pointWorld) const {
  const double depth = parallel_ ? 1.0 : std::max(glm::dot(pointWorld - eye_, forward_), 0.0);
  return depth * halfHeight_ / (0.5 * height_);
}

}  // namespace boxprobe
