// Reads back a window's picture.
#pragma once

#include "filters/core/scene/model.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// The front buffer: display colours, alpha 255, rows from the top.
ImageRgba8 windowPixels(vtkOpenGLRenderWindow* window);

}  // namespace boxprobe
