#include "filters/vtk/surface/camera_uniforms.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <cmath>

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

std::array<float, 9> viewToTurnedRotation(vtkCamera* camera, double degrees) {
  std::array<float, 9> m = viewToWorldRotation(camera);
  const double angle = degrees * (3.14159265358979323846 / 180.0);
  const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  for (std::size_t column = 0; column < 3; ++column) {
    const float x = m[column * 3], z = m[column * 3 + 2];
    m[column * 3] = c * x - s * z;
    m[column * 3 + 2] = s * x + c * z;
  }
  return m;
}

}  // namespace boxprobe
