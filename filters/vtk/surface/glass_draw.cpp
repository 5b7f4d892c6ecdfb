#include "filters/vtk/surface/glass_draw.h"

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include <algorithm>

namespace boxprobe {

int drawGlassPasses(vtkOpenGLState* state, const GlassSurface& glass, const std::function<void(bool colored)>& draw) {
  const vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  const vtkOpenGLState::ScopedglDepthMask depth(state);
  const vtkOpenGLState::ScopedglColorMask color(state);
  state->vtkglDepthMask(GL_TRUE);
  int passes = 1;
  if (glass.walls) {
    // Each wall once, by its face towards the eye; blended in any order, because a wall absorbs little. Depth
    // afterwards.
    state->vtkglEnable(GL_CULL_FACE);
    state->vtkglCullFace(GL_BACK);
    state->vtkglDepthMask(GL_FALSE);
    draw(true);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw(false);
    return passes;
  }
  if (glass.form == GlassForm::TwoPass && !glass.sheet) {
    state->vtkglEnable(GL_CULL_FACE);
    state->vtkglCullFace(GL_FRONT);
    state->vtkglDepthMask(GL_FALSE);
    draw(true);
    state->vtkglCullFace(GL_BACK);
    state->vtkglDepthMask(GL_TRUE);
    ++passes;
  } else {
    // From inside, back faces are visible.
    state->vtkglDisable(GL_CULL_FACE);
  }
  // Depth first: otherwise hidden faces would show through blended ones.
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw(false);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  draw(true);
  state->vtkglCullFace(GL_BACK);
  return passes;
}

void uploadGlass(vtkShaderProgram* program, const GlassSurface& glass, const glm::dvec3& eyeWorld, int faceSize,
                 int shellUnit) {
  const shading::GlassObject object = glass.object(eyeWorld);
  const auto set = [program](const char* name, float value) {
    if (program->IsUniformUsed(name)) program->SetUniformf(name, value);
  };
  set("bpGlassIor", object.ior);
  set("bpGlassTransmission", glass.transmission);
  set("bpGlassThickness", object.thickness);
  set("bpGlassRadius", object.radius);
  set("bpGlassReach", glass.attenuationDistance);
  set("bpGlassStraight", glass.straightAngle(faceSize));
  set("bpGlassBehind", glass.behindShare());
  if (program->IsUniformUsed("bpGlassCenter")) program->SetUniform3f("bpGlassCenter", &object.center.x);
  if (program->IsUniformUsed("bpGlassColor")) program->SetUniform3f("bpGlassColor", &glass.attenuationColor.x);
  if (shellUnit >= 0 && program->IsUniformUsed("bpGlassShell")) program->SetUniformi("bpGlassShell", shellUnit);
}

}  // namespace boxprobe
