// The ray through a pixel of a picture, for both projections.
#pragma once

#include <glm/vec3.hpp>

class vtkCamera;

namespace boxprobe {

struct PixelRay {
  glm::dvec3 originWorld{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit, world
};

class PixelRays {
 public:
  /// For a picture of `width` x `height` pixels with the camera's current state.
  PixelRays(vtkCamera* camera, int width, int height);
  /// x, y in pixels from the top left; pixel centres are at + 0.5.
  PixelRay through(double x, double y) const;
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  int width_, height_;
  bool parallel_;
  glm::dvec3 eye_, forward_, right_, up_;
  double halfWidth_, halfHeight_;  // of the picture: tangents, or scene units in parallel projection
};

}  // namespace boxprobe
