// Converts between the world and the pixels of a view: rays through pixels, projected points, and the size of a pixel.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

class vtkCamera;

namespace boxprobe {

/// A ray through a pixel, world space. `direction` has unit length.
struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};
};

/// The axes of a view: unit vectors, world space.
struct ViewAxes {
  glm::dvec3 forward{0.0, 0.0, -1.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
};

/// A camera and a viewport size. Pixels count from the top left; y grows downwards. Uses the camera's position, axes,
/// and vertical field of view or parallel scale; ignores window centre and view shear.
class ViewProjection {
 public:
  ViewProjection(vtkCamera* camera, double widthPixels, double heightPixels);

  /// Nothing for a point behind the viewer.
  std::optional<glm::dvec2> pixel(const glm::dvec3& pointWorld) const;
  Ray ray(const glm::dvec2& pixel) const;
  ViewAxes axes() const { return {forward_, up_}; }
  glm::dvec3 eyeWorld() const { return eye_; }
  glm::dvec3 right() const { return right_; }
  bool parallel() const { return parallel_; }
  /// World length of one pixel at that point.
  double metresPerPixel(const glm::dvec3& pointWorld) const;

 private:
  glm::dvec3 eye_, forward_, right_, up_;
  double halfHeight_;  ///< tangent of half the vertical field of view; half the height in parallel projection
  double width_, height_;
  bool parallel_;
};

}  // namespace boxprobe
