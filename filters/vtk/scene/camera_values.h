// A scene's camera as VTK's, and back. Called by the scene renderer; knows no scene.
#pragma once

#include "filters/core/scene/scene.h"

class vtkCamera;

namespace boxprobe {

/// Clipping distances stay as they are.
void setCamera(vtkCamera* to, const Camera& camera);
/// As it stands, after interaction, too; its name and what else VTK does not keep are those of a new one.
Camera cameraValues(vtkCamera* from);

}  // namespace boxprobe
