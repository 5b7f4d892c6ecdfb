// How one glass object is drawn: which faces in which pass, and its uniforms. Called by vtkProbeActor for materials
// that transmit light. Knows no scene.
#pragma once

#include <functional>

#include "filters/vtk/draw/glass_surface.h"

class vtkOpenGLState;
class vtkShaderProgram;

namespace boxprobe {

/// Calls `draw` once a pass, with faces, depth and colours set for it; `colored` is false of a pass for depth alone.
/// Returns how many were drawn. What is set is put back.
int drawGlassPasses(vtkOpenGLState* state, const GlassSurface& glass, const std::function<void(bool colored)>& draw);

/// Uniforms of shaders/gpu/glass.glsl. `faceSize`: texels of the cubemap that is looked up; `shellUnit`: the texture
/// unit of the shell, if it has one.
void uploadGlass(vtkShaderProgram* program, const GlassSurface& glass, const glm::dvec3& eyeWorld, int faceSize,
                 int shellUnit);

}  // namespace boxprobe
