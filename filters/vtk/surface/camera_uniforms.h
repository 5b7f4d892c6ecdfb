// What shaders are told of the camera. Called by the probe pass and the sky when they draw; knows nothing of probes.
#pragma once

#include <array>

class vtkCamera;

namespace boxprobe {

/// Rotation from view to world axes, in the order SetUniformMatrix3x3 takes: column after column.
std::array<float, 9> viewToWorldRotation(vtkCamera* camera);

/// The same to axes that stand turned by `degrees` about world +Y: what a turned sky is looked up along.
std::array<float, 9> viewToTurnedRotation(vtkCamera* camera, double degrees);

}  // namespace boxprobe
