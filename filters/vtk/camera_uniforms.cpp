#include "filters/vtk/camera_uniforms.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

namespace boxprobe {

std::array<float, 9> viewToWorldRotation(vtkCamera* camera) {
  const vtkMatrix4x4* viewFromWorld = camera->GetModelViewTransformMatrix();
  std::array<float, 9> viewToWorld{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      // The inverse of a rotation is its transpose: element (row, column) of the inverse is (column, row) here.
      viewToWorld[column * 3 + row] =
          static_cast<float>(viewFromWorld->GetElement(static_cast<int>(column), static_cast<int>(row)));
    }
  }
  return viewToWorld;
}

}  // namespace boxprobe
