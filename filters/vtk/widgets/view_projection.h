// Between the world and the pixels of a view: rays through pixels, where points are drawn, how long a pixel is there.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

class vtkCamera;

namespace boxprobe {

/// Through a pixel, world space. `direction` has unit length.
struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};
};

/// What the drags need of the view: unit vectors, world space.
struct ViewAxes {
  glm::dvec3 forward{0.0, 0.0, -1.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
};

/// A camera seen through a viewport of so many pixels. Pixels count from the top left; y grows downwards. Of the camera
/// the position, the axes and the vertical field of view or the parallel scale are read; window centres and view shears
/// are not.
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
  double halfHeight_;  ///< tangent of half the vertical field of view; half the height in a parallel projection
  double width_, height_;
  bool parallel_;
};

}  // namespace boxprobe
