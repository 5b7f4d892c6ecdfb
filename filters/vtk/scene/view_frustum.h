// The view frustum of a camera, as planes in the world, for culling. Conservative: may be true for a near miss.
#pragma once

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "filters/core/scene/scene.h"

namespace boxprobe {

class ViewFrustum {
 public:
  /// The four sides, and the plane through the eye; there is no far plane, because clipping distances follow from what
  /// is visible.
  ViewFrustum(vtkCamera* camera, double aspect) {
    vtkMatrix4x4* m = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
    const auto row = [&](int i) {
      return glm::dvec4(m->GetElement(i, 0), m->GetElement(i, 1), m->GetElement(i, 2), m->GetElement(i, 3));
    };
    planes_ = {row(3) + row(0), row(3) - row(0), row(3) + row(1), row(3) - row(1)};
    for (glm::dvec4& plane : planes_) plane /= glm::length(glm::dvec3(plane));
  }

  bool meets(const Box& box) const {
    const glm::dvec3 center = box.center(), half = 0.5 * box.size();
    for (const glm::dvec4& plane : planes_) {
      const glm::dvec3 normal(plane);
      const double nearest = glm::dot(normal, center) + glm::dot(glm::abs(normal), half) + plane.w;
      // Allows for rounding of the products above.
      if (nearest < -1.0e-9 * (glm::length(center) + glm::length(half))) return false;
    }
    return true;
  }

 private:
  std::array<glm::dvec4, 4> planes_;
};

}  // namespace boxprobe
