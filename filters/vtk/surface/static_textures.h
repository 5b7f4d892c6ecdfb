// The textures draws read whatever the scene: the split-sum table, a black cube that stands in for maps not captured
// yet, and, for techniques that draw samples, the blue-noise mask.
#pragma once

#include "filters/vtk/surface/draw_state.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Once; the context must be current.
void makeStaticTextures(vtkOpenGLRenderWindow* window, DrawState& state);
/// Once, and only if a technique wants it; the context must be current.
void makeBlueNoise(vtkOpenGLRenderWindow* window, DrawState& state);
void releaseStaticTextures(DrawState& state);

}  // namespace boxprobe
