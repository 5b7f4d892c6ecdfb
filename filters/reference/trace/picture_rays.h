// Rays through a picture as vtkCamera projects it: the field of view is vertical, pixels are square. In parallel
// projection all rays have the same direction and start beside each other.
#pragma once

#include <glm/vec3.hpp>

#include "filters/core/scene/scene.h"

namespace boxprobe {

class PictureRays {
 public:
  PictureRays(const Camera& camera, int width, int height);
  /// Pixels from the top left.
  glm::dvec3 origin(double x, double y) const { return parallel_ ? eye_ + beside(x, y) : eye_; }
  /// Not unit.
  glm::dvec3 direction(double x, double y) const { return parallel_ ? forward_ : forward_ + beside(x, y); }

 private:
  glm::dvec3 beside(double x, double y) const {
    return (2.0 * x / width_ - 1.0) * right_ + (1.0 - 2.0 * y / height_) * up_;
  }
  int width_, height_;
  glm::dvec3 eye_;
  bool parallel_;
  glm::dvec3 forward_, right_, up_;
};

}  // namespace boxprobe
