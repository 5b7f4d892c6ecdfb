#include "filters/reference/trace/picture_rays.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace boxprobe {

PictureRays::PictureRays(const Camera& camera, int width, int height)
    : width_(width), height_(height), eye_(camera.position), parallel_(camera.parallelHeight > 0.0) {
  forward_ = glm::normalize(camera.target - camera.position);
  const double half = parallel_ ? 0.5 * camera.parallelHeight : std::tan(0.5 * glm::radians(camera.verticalFovDegrees));
  const glm::dvec3 right = glm::normalize(glm::cross(forward_, camera.up));
  right_ = right * (half * width / height);
  up_ = glm::cross(right, forward_) * half;
}

}  // namespace boxprobe
