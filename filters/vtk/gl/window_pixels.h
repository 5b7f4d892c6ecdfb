// A window's picture read back. Called by the scene renderer after a frame; knows no scene.
#pragma once

#include "filters/core/scene/model.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// The front of the frame buffer as it is: display colours, alpha 255, rows from the top.
ImageRgba8 windowPixels(vtkOpenGLRenderWindow* window);

}  // namespace boxprobe
