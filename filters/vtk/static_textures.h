// The two textures every draw with probes reads whatever the scene: the split-sum table, and a black cube that stands
// in for maps not captured yet.
#pragma once

#include "filters/vtk/draw_state.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Once; the context must be current.
void makeStaticTextures(vtkOpenGLRenderWindow* window, DrawState& state);
void releaseStaticTextures(DrawState& state);

}  // namespace boxprobe
