// Draws one glass object: which faces in which pass, and its uniforms.
#pragma once

#include <functional>

#include "filters/vtk/draw/glass_surface.h"

class vtkOpenGLState;
class vtkShaderProgram;

namespace boxprobe {

/// Calls `draw` once per pass, with faces, depth and colour masks set; `colored` is false for a depth-only pass.
/// Returns the number of passes. Restores the state.
int drawGlassPasses(vtkOpenGLState* state, const GlassSurface& glass, const std::function<void(bool colored)>& draw);

/// Uniforms of shaders/gpu/glass.glsl. `faceSize`: texels of the sampled cubemap; `shellUnit`: the texture unit of the
/// shell, if it has one.
void uploadGlass(vtkShaderProgram* program, const GlassSurface& glass, const glm::dvec3& eyeWorld, int faceSize,
                 int shellUnit);

}  // namespace boxprobe
