// A ray through a pixel, and the view's axes. Called by picking and by the drags; plain values.
#pragma once

#include <glm/vec3.hpp>

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

}  // namespace boxprobe
