// What the programs of draws with shadowed lights are told: lights, the probes' coverage, maps of what moves. Called by
// the mapper while it draws; the texts that read it are shaders/gpu/coverage*.glsl and moving_shadow.glsl.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "filters/vtk/surface/draw_state.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace boxprobe {

/// `eyeWorld`: the camera's position. Textures stay bound for the life of what is added to `bound`.
void uploadCoverage(vtkShaderProgram* program, vtkOpenGLRenderWindow* window, const DrawState& state,
                    const ProbeBinding& binding, const glm::dvec3& eyeWorld,
                    std::vector<std::unique_ptr<BoundTexture>>& bound);

}  // namespace boxprobe
