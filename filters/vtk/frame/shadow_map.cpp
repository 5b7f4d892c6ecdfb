#include "filters/vtk/frame/shadow_map.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "filters/core/base/errors.h"
#include "filters/math/shared/shader_source.h"

namespace boxprobe {

glm::dvec3 anyUp(const glm::dvec3& forward) {
  return std::abs(forward.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
}

void ShadowMapPainter::draw(ShadowMap& map, int size, const glm::dmat4& mapFromWorld,
                            const std::function<bool(const DrawnObject&)>& casts) {
  const PassState saved(window_);
  vtkOpenGLState* state = window_->GetState();
  if (map.texture != 0 && map.size != size) release(map);
  if (map.texture == 0) {
    map.size = size;
    glGenTextures(1, &map.texture);
    const BoundTexture bound(window_, GL_TEXTURE_2D, map.texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  }
  if (!map.framebuffer.made()) {
    map.framebuffer.attach({}, textureImage(map.texture),
                           [](GLenum) { return "OpenGL refuses the framebuffer for a shadow map"; });
  }
  vtkOpenGLShaderCache* cache = window_->GetShaderCache();
  if (program_ == nullptr) {
    const std::string vertex = "//VTK::System::Dec\n" + std::string(shaderSource("gpu/depth_vertex.glsl"));
    const std::string fragment =
        "//VTK::System::Dec\n//VTK::Output::Dec\n" + std::string(shaderSource("gpu/no_color.glsl"));
    program_ = cache->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
    ++state_->counts.counters.programsCompiled;
  } else {
    cache->ReadyShaderProgram(program_);
  }
  if (program_ == nullptr || !program_->GetCompiled()) throw WorkError("the shader depth_vertex does not compile");
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, map.framebuffer.handle());
  state->vtkglViewport(0, 0, size, size);
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST), cull(state, GL_CULL_FACE);
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  const vtkOpenGLState::ScopedglDepthFunc function(state);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  // A slanted surface must not shadow itself: by the depth a texel spans, and a little of what 24 bits resolve.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2.0f, 8.0f);
  const glm::dmat4 clip =
      glm::scale(glm::dmat4(1.0), glm::dvec3(2.0)) * glm::translate(glm::dmat4(1.0), glm::dvec3(-0.5)) * mapFromWorld;
  std::size_t index = 0;
  for (const auto& model : content_->models) {
    for (const Instance& instance : model->instances) {
      if (index == content_->objects.size()) break;
      const DrawnObject& object = content_->objects[index++];
      if (!casts(object)) continue;
      const glm::mat4 matrix(clip * object.worldFromModel);
      program_->SetUniformMatrix4x4("bpClipFromModel", const_cast<float*>(&matrix[0][0]));
      geometry_.draw(model, static_cast<std::size_t>(instance.mesh));
    }
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
  ++state_->counts.counters.shadowMapsDrawn;
}

void ShadowMapPainter::release(ShadowMap& map) {
  glDeleteTextures(1, &map.texture);
  map.texture = 0;
  map.framebuffer.release();
}

void ShadowMapPainter::release() {
  geometry_.release();
  program_ = nullptr;
}

}  // namespace boxprobe
