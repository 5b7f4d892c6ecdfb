// Converts between a scene's camera and VTK's.
#pragma once

#include "filters/core/scene/scene.h"

class vtkCamera;

namespace boxprobe {

/// Does not change the clipping distances.
void setCamera(vtkCamera* to, const Camera& camera);
/// The current state; the name and other values that VTK does not store are defaults.
Camera cameraValues(vtkCamera* from);

}  // namespace boxprobe
