#include "filters/vtk/rays/vtkRayLinesProp.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include <array>
#include <cstddef>
#include <string>

#include "filters/core/base/errors.h"
#include "filters/math/shared/shader_source.h"
#include "filters/vtk/gl/opengl.h"

vtkStandardNewMacro(vtkRayLinesProp);

namespace {

using boxprobe::DrawnLine;

// Lines count as slightly nearer to the eye in the depth test: a line in a wall is visible, one behind a table is not.
constexpr double kPull = 0.996;

// The transform from the lines' coordinates to clip space, column-major as for SetUniformMatrix4x4v. The anchor is
// transformed to view space in double: far from the world's origin the large numbers cancel there.
std::array<float, 16> clipFromLine(vtkCamera* camera, double aspect, const glm::dvec3& anchor, double pull) {
  vtkNew<vtkMatrix4x4> view;
  view->DeepCopy(camera->GetModelViewTransformMatrix());
  for (int row = 0; row < 3; ++row) {
    const double* r = &view->Element[row][0];
    view->SetElement(row, 3, r[0] * anchor.x + r[1] * anchor.y + r[2] * anchor.z + r[3]);
    for (int column = 0; column < 4; ++column) view->Element[row][column] *= pull;
  }
  vtkNew<vtkMatrix4x4> clip;
  vtkMatrix4x4::Multiply4x4(camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0), view, clip);
  std::array<float, 16> columns{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      columns[4 * column + row] = static_cast<float>(clip->Element[row][column]);
    }
  }
  return columns;
}

void setAttribute(vtkShaderProgram* program, const char* name, int components, std::size_t offset) {
  const GLint location = glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), name);
  if (location < 0) return;
  const auto index = static_cast<GLuint>(location);
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, sizeof(DrawnLine), reinterpret_cast<void*>(offset));
  glVertexAttribDivisor(index, 1);  // one value per line
}

}  // namespace

vtkRayLinesProp::vtkRayLinesProp() {
  this->PickableOff();
}

vtkRayLinesProp::~vtkRayLinesProp() = default;

void vtkRayLinesProp::SetLines(std::vector<DrawnLine> lines, const glm::dvec3& anchorWorld) {
  this->Lines = std::move(lines);
  this->AnchorWorld = anchorWorld;
  this->LinesChanged = true;
  this->Modified();
}

void vtkRayLinesProp::SetPixelScale(float scale) {
  this->PixelScale = scale;
  this->Modified();
}

void vtkRayLinesProp::BuildArray() {
  glGenVertexArrays(1, &this->VertexArray);
  glGenBuffers(1, &this->Buffer);
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->Buffer);
  setAttribute(this->Program, "bpFrom", 3, offsetof(DrawnLine, from));
  setAttribute(this->Program, "bpTo", 3, offsetof(DrawnLine, to));
  setAttribute(this->Program, "bpColor", 3, offsetof(DrawnLine, color));
  setAttribute(this->Program, "bpShape", 2, offsetof(DrawnLine, widthPixels));
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void vtkRayLinesProp::Upload() {
  if (!this->LinesChanged) {
    return;
  }
  glBindBuffer(GL_ARRAY_BUFFER, this->Buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(this->Lines.size() * sizeof(DrawnLine)), this->Lines.data(),
               GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  this->LinesChanged = false;
}

int vtkRayLinesProp::RenderOverlay(vtkViewport* viewport) {
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  if (renderer == nullptr || this->Lines.empty()) {
    return 0;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (this->Program == nullptr) {
    // VTK's own placeholders: the version line and the mapping of gl_FragData.
    const std::string head = "//VTK::System::Dec\n";
    const std::string vertex = head + std::string(boxprobe::shaderSource("gpu/ray_lines_vertex.glsl"));
    const std::string fragment =
        head + "//VTK::Output::Dec\n" + std::string(boxprobe::shaderSource("gpu/ray_lines.glsl"));
    this->Program = cache->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  } else {
    cache->ReadyShaderProgram(this->Program);
  }
  if (this->Program == nullptr || !this->Program->GetCompiled()) {
    throw boxprobe::WorkError("the shader ray_lines.glsl does not compile on this driver");
  }
  if (this->VertexArray == 0) {
    this->BuildArray();
    this->LinesChanged = true;
  }
  this->Upload();

  vtkCamera* camera = renderer->GetActiveCamera();
  const double aspect = renderer->GetTiledAspectRatio();
  auto clip = clipFromLine(camera, aspect, this->AnchorWorld, 1.0);
  auto pulled = clipFromLine(camera, aspect, this->AnchorWorld, kPull);
  int size[2], origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const float half[2] = {0.5f * static_cast<float>(size[0]), 0.5f * static_cast<float>(size[1])};
  const double near = camera->GetParallelProjection() ? -1.0 : camera->GetClippingRange()[0];
  this->Program->SetUniformMatrix4x4("bpClipFromLine", clip.data());
  this->Program->SetUniformMatrix4x4("bpPulledFromLine", pulled.data());
  this->Program->SetUniform2f("bpHalfViewport", half);
  this->Program->SetUniformf("bpNear", static_cast<float>(near));
  this->Program->SetUniformf("bpPixelScale", this->PixelScale);

  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  const vtkOpenGLState::ScopedglDepthFunc function(state);
  const vtkOpenGLState::ScopedglBlendFuncSeparate blending(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);
  // A ray to the sky extends beyond the scene's depth range, and must be visible to its end.
  glEnable(GL_DEPTH_CLAMP);
  glBindVertexArray(this->VertexArray);
  // All halos before any core: where lines cross, no halo cuts another's core.
  for (const int part : {0, 1, 2}) {
    this->Program->SetUniformi("bpPart", part);
    state->vtkglDepthFunc(part == 0 ? GL_GREATER : GL_LEQUAL);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(this->Lines.size()));
  }
  glBindVertexArray(0);
  glDisable(GL_DEPTH_CLAMP);
  return 1;
}

void vtkRayLinesProp::ReleaseGraphicsResources(vtkWindow* window) {
  if (this->VertexArray != 0 && window != nullptr) {
    static_cast<vtkOpenGLRenderWindow*>(window)->MakeCurrent();
    glDeleteVertexArrays(1, &this->VertexArray);
    glDeleteBuffers(1, &this->Buffer);
  }
  this->VertexArray = 0;
  this->Buffer = 0;
  this->Program = nullptr;
  this->Superclass::ReleaseGraphicsResources(window);
}
