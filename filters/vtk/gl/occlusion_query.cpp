#include "filters/vtk/gl/occlusion_query.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <string>

#include "filters/core/base/errors.h"
#include "filters/math/shared/shader_source.h"

namespace boxprobe {

namespace {

// Boxes are enlarged by this share of their distance and size: they touch the very surfaces that are in the depth
// buffer, and rounding must not hide them.
constexpr double kMargin = 2.0e-3;

glm::dmat4 clipFromEye(vtkCamera* camera, double aspect, const glm::dvec3& eye) {
  vtkMatrix4x4* m = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  glm::dmat4 clipFromWorld;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) clipFromWorld[column][row] = m->GetElement(row, column);
  }
  return glm::translate(clipFromWorld, eye);
}

// Makes draws test depth and change nothing, during the lifetime of this object.
class DepthTestAlone {
 public:
  explicit DepthTestAlone(vtkOpenGLState* state)
      : test_(state, GL_DEPTH_TEST),
        cull_(state, GL_CULL_FACE),
        blend_(state, GL_BLEND),
        depthMask_(state),
        function_(state),
        colorMask_(state) {
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }

 private:
  vtkOpenGLState::ScopedglEnableDisable test_, cull_, blend_;
  vtkOpenGLState::ScopedglDepthMask depthMask_;
  vtkOpenGLState::ScopedglDepthFunc function_;
  vtkOpenGLState::ScopedglColorMask colorMask_;
};

bool passed(GLuint query) {
  GLuint any = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &any);
  return any != 0;
}

}  // namespace

OcclusionQuery::OcclusionQuery() : farthest_({"gpu/no_color.glsl"}, nullptr) {}

OcclusionQuery::~OcclusionQuery() = default;

void OcclusionQuery::haveQueries(std::size_t count) {
  if (queries_.size() >= count) return;
  const std::size_t had = queries_.size();
  queries_.resize(count);
  glGenQueries(static_cast<GLsizei>(count - had), &queries_[had]);
}

OcclusionQuery::Rectangle OcclusionQuery::farthestShows(vtkRenderer* renderer) {
  constexpr int kTiles = 12, kAll = kTiles * kTiles;  // along each side, and in total
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  const DepthTestAlone alone(state);
  const vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglScissor box(state);
  state->vtkglEnable(GL_SCISSOR_TEST);
  GLint view[4];
  glGetIntegerv(GL_VIEWPORT, view);
  const auto column = [&](int i) { return view[0] + view[2] * i / kTiles; };
  const auto row = [&](int i) { return view[1] + view[3] * i / kTiles; };
  haveQueries(kAll);
  glDepthRange(1.0, 1.0);  // the triangle's depth is in the middle of the range
  for (int i = 0; i < kAll; ++i) {
    const int x = i % kTiles, y = i / kTiles;
    state->vtkglScissor(column(x), row(y), column(x + 1) - column(x), row(y + 1) - row(y));
    const GLuint query = queries_[static_cast<std::size_t>(i)];
    glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
    farthest_.draw(window, [](vtkShaderProgram*) {});
    glEndQuery(GL_ANY_SAMPLES_PASSED);
  }
  glDepthRange(0.0, 1.0);
  int left = kTiles, right = 0, bottom = kTiles, top = 0;
  for (int i = 0; i < kAll; ++i) {
    if (!passed(queries_[static_cast<std::size_t>(i)])) continue;
    left = std::min(left, i % kTiles);
    right = std::max(right, i % kTiles + 1);
    bottom = std::min(bottom, i / kTiles);
    top = std::max(top, i / kTiles + 1);
  }
  if (right == 0) return {};
  return {column(left), row(bottom), column(right) - column(left), row(top) - row(bottom)};
}

std::vector<bool> OcclusionQuery::visible(vtkRenderer* renderer, const std::vector<Box>& boxes) {
  std::vector<bool> result(boxes.size(), true);
  if (boxes.empty()) return result;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (program_ == nullptr) {
    const std::string vertex = "//VTK::System::Dec\n" + std::string(shaderSource("gpu/box_vertex.glsl"));
    const std::string fragment =
        "//VTK::System::Dec\n//VTK::Output::Dec\n" + std::string(shaderSource("gpu/no_color.glsl"));
    program_ = cache->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
    glGenVertexArrays(1, &vertexArray_);
  } else {
    cache->ReadyShaderProgram(program_);
  }
  if (program_ == nullptr || !program_->GetCompiled()) throw WorkError("the shader box_vertex does not compile");

  const DepthTestAlone alone(window->GetState());
  haveQueries(boxes.size());
  vtkCamera* camera = renderer->GetActiveCamera();
  glm::dvec3 eye;
  camera->GetPosition(&eye.x);
  double range[2];
  camera->GetClippingRange(range);
  const glm::mat4 matrix(clipFromEye(camera, renderer->GetTiledAspectRatio(), eye));
  program_->SetUniformMatrix4x4("bpClipFromEye", const_cast<float*>(&matrix[0][0]));
  glBindVertexArray(vertexArray_);
  std::vector<bool> asked(boxes.size(), false);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const glm::dvec3 center = boxes[i].center() - eye;
    const glm::dvec3 half = 0.5 * boxes[i].size() + kMargin * (glm::length(center) + glm::length(boxes[i].size()));
    const glm::dvec3 reach = half + 2.0 * range[0];  // geometry cut by the near plane would not be visible
    if (glm::all(glm::lessThanEqual(glm::abs(center), reach)) || camera->GetParallelProjection()) continue;
    const glm::vec3 low(center - half), high(center + half);
    program_->SetUniform3f("bpLow", &low.x);
    program_->SetUniform3f("bpHigh", &high.x);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, queries_[i]);
    glDrawArrays(GL_TRIANGLES, 0, 36);
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    asked[i] = true;
  }
  glBindVertexArray(0);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (asked[i]) result[i] = passed(queries_[i]);
  }
  return result;
}

void OcclusionQuery::release() {
  if (!queries_.empty()) glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
  queries_.clear();
  if (vertexArray_ != 0) glDeleteVertexArrays(1, &vertexArray_);
  vertexArray_ = 0;
  program_ = nullptr;
  farthest_.release();
}

}  // namespace boxprobe
