// Camera uniforms.
#pragma once

#include <array>

class vtkCamera;

namespace boxprobe {

/// Rotation from view to world axes, column-major as for SetUniformMatrix3x3.
std::array<float, 9> viewToWorldRotation(vtkCamera* camera);

/// The same to axes rotated by `degrees` about world +Y, in which a rotated sky is sampled.
std::array<float, 9> viewToTurnedRotation(vtkCamera* camera, double degrees);

}  // namespace boxprobe
