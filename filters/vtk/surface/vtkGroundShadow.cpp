#include "filters/vtk/surface/vtkGroundShadow.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <utility>

#include "filters/math/shared/shader_source.h"
#include "filters/vtk/gl/gl_objects.h"
#include "filters/vtk/gl/opengl.h"

vtkStandardNewMacro(vtkGroundShadow);

namespace {

glm::dmat4 clipFromEye(vtkCamera* camera, double aspect, const glm::dvec3& eye) {
  vtkMatrix4x4* m = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  glm::dmat4 clipFromWorld;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      clipFromWorld[column][row] = m->GetElement(row, column);
    }
  }
  return glm::translate(clipFromWorld, eye);
}

}  // namespace

void vtkGroundShadow::SetShadow(std::shared_ptr<const boxprobe::GroundShadow> shadow) {
  if (shadow != nullptr && shadow->empty()) {
    shadow = nullptr;
  }
  if (shadow == this->Shadow) {
    return;
  }
  this->Shadow = std::move(shadow);
  this->Changed = true;
  this->Modified();
}

double* vtkGroundShadow::GetBounds() {
  if (this->Shadow == nullptr) {
    return nullptr;
  }
  const boxprobe::GroundShadow& s = *this->Shadow;
  const double bounds[6] = {s.low.x, s.high.x, s.height, s.height, s.low.y, s.high.y};
  std::copy(bounds, bounds + 6, this->Bounds);
  return this->Bounds;
}

int vtkGroundShadow::RenderOpaqueGeometry(vtkViewport* viewport) {
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkCamera* camera = renderer->GetActiveCamera();
  glm::dvec3 eye;
  camera->GetPosition(&eye.x);
  if (this->Shadow == nullptr || eye.y <= this->Shadow->height) {
    return 0;
  }
  const boxprobe::GroundShadow& shadow = *this->Shadow;
  vtkOpenGLState* state = window->GetState();
  if (this->Changed) {
    this->Changed = false;
    if (this->Texture == 0) {
      glGenTextures(1, &this->Texture);
    }
    const boxprobe::BoundTexture bound(window, GL_TEXTURE_2D, this->Texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R16F, shadow.columns, shadow.rows, 0, GL_RED, GL_FLOAT, shadow.light.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  if (!this->Pass) {
    this->Pass = std::make_unique<boxprobe::FullScreenPass>(
        "gpu/ground_shadow.glsl", std::string(boxprobe::shaderSource("gpu/ground_shadow.glsl")), this->Counts,
        "gpu/ground_vertex.glsl");
  }
  const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  const vtkOpenGLState::ScopedglDepthFunc function(state);
  const vtkOpenGLState::ScopedglBlendFuncSeparate factors(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_LEQUAL);
  const glm::mat4 clip(clipFromEye(camera, renderer->GetTiledAspectRatio(), eye));
  const glm::vec3 low(glm::dvec3(shadow.low.x, shadow.height, shadow.low.y) - eye);
  const float size[2] = {static_cast<float>(shadow.high.x - shadow.low.x),
                         static_cast<float>(shadow.high.y - shadow.low.y)};
  const boxprobe::BoundTexture light(window, GL_TEXTURE_2D, this->Texture);
  this->Pass->draw(window, [&](vtkShaderProgram* program) {
    program->SetUniformMatrix4x4("bpClipFromEye", const_cast<float*>(&clip[0][0]));
    program->SetUniform3f("bpLow", &low.x);
    program->SetUniform2f("bpPlaneSize", size);
    program->SetUniformi("bpGroundLight", light.unit());
  });
  return 1;
}

void vtkGroundShadow::ReleaseGraphicsResources(vtkWindow* window) {
  this->Superclass::ReleaseGraphicsResources(window);
  if (this->Texture != 0) {
    glDeleteTextures(1, &this->Texture);
  }
  this->Texture = 0;
  this->Changed = this->Shadow != nullptr;
  if (this->Pass) {
    this->Pass->release();
  }
}
