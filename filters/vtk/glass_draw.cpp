#include "filters/vtk/glass_draw.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtkShaderProgram.h>

#include <algorithm>

#include "filters/vtk/vtkProbePolyDataMapper.h"

namespace boxprobe {

bool isGlass(vtkProp* prop) {
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* mapper = actor != nullptr ? vtkProbePolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  return mapper != nullptr && mapper->DrawsGlass();
}

std::vector<vtkProp*> glassLast(const std::vector<vtkProp*>& props, vtkCamera* camera) {
  std::vector<vtkProp*> order;
  std::vector<std::pair<double, vtkProp*>> glass;
  const double* eye = camera->GetPosition();
  const double* along = camera->GetDirectionOfProjection();
  for (vtkProp* prop : props) {
    const double* b = isGlass(prop) ? prop->GetBounds() : nullptr;
    if (b == nullptr) {
      order.push_back(prop);
      continue;
    }
    double distance = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      distance += along[axis] * (0.5 * (b[2 * axis] + b[2 * axis + 1]) - eye[axis]);
    }
    glass.emplace_back(distance, prop);
  }
  std::stable_sort(glass.begin(), glass.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [distance, prop] : glass) order.push_back(prop);
  return order;
}

int drawGlassPasses(vtkOpenGLState* state, const GlassSurface& glass, const std::function<void(bool colored)>& draw) {
  const vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  const vtkOpenGLState::ScopedglDepthMask depth(state);
  const vtkOpenGLState::ScopedglColorMask color(state);
  int passes = 1;
  if (glass.walls) {
    // Each wall once, by the face of it that looks at the eye; blended in any order, for a wall takes little. Their
    // depth afterwards.
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
    // From within it is the back faces that are seen.
    state->vtkglDisable(GL_CULL_FACE);
  }
  // Its depth first: a face that another one hides would show through where it is blended.
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
