#include "filters/vtk/frame/moving_shadows.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "filters/core/base/errors.h"
#include "filters/math/shared/shader_source.h"

namespace boxprobe {

namespace {

bool casts(const DrawnObject& object) {
  return object.settings.visible && object.settings.dynamic && object.material.alphaMode != AlphaMode::Blend;
}

glm::dvec3 anyUp(const glm::dvec3& forward) {
  return std::abs(forward.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
}

}  // namespace

std::optional<glm::dmat4> movingMapFromWorld(const Light& light, const Box& casters) {
  const glm::dvec3 center = casters.center();
  // With a margin for the filter at the edges.
  const double radius = std::max(0.5 * glm::length(casters.size()), 1.0e-6) * (1.0 + 8.0 / kMovingMapSize);
  const glm::dmat4 unit =
      glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)) * glm::scale(glm::dmat4(1.0), glm::dvec3(0.5));
  if (light.type == LightType::Directional) {
    const glm::dvec3 forward = glm::normalize(light.direction);
    const glm::dmat4 view = glm::lookAt(center - 2.0 * radius * forward, center, anyUp(forward));
    return unit * glm::ortho(-radius, radius, -radius, radius, radius, 3.0 * radius) * view;
  }
  const double distance = glm::length(center - light.position);
  if (distance <= 1.01 * radius) return std::nullopt;
  const glm::dvec3 forward = (center - light.position) / distance;
  const glm::dmat4 view = glm::lookAt(light.position, center, anyUp(forward));
  return unit * glm::perspective(2.0 * std::asin(radius / distance), 1.0, distance - radius, distance + radius) * view;
}

MovingShadows::MovingShadows(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state,
                             const SceneContent* content)
    : window_(window), state_(std::move(state)), content_(content) {}

void MovingShadows::update() {
  if (!stale_) return;
  stale_ = false;
  state_->resources.movingShadows.clear();
  std::optional<Box> casters;
  for (const DrawnObject& object : content_->objects) {
    if (!casts(object)) continue;
    const Box b = worldBounds(object);
    casters = casters ? Box{glm::min(casters->min, b.min), glm::max(casters->max, b.max)} : b;
  }
  if (!casters) return;
  const std::vector<Light>& lights = content_->scene.lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (lights[i].shadows != LightShadows::CoverageAndMap ||
        state_->resources.shadowLightsInUse.count(static_cast<int>(i)) == 0)
      continue;
    const auto matrix = movingMapFromWorld(lights[i], *casters);
    if (!matrix) continue;
    const std::size_t at = state_->resources.movingShadows.size();
    if (maps_.size() <= at) maps_.emplace_back();
    drawMap(maps_[at], *matrix);
    state_->resources.movingShadows.push_back({static_cast<int>(i), maps_[at].texture, *matrix});
    ++state_->counts.counters.shadowMapsDrawn;
  }
}

void MovingShadows::drawMap(Map& map, const glm::dmat4& mapFromWorld) {
  const PassState saved(window_);
  vtkOpenGLState* state = window_->GetState();
  if (map.texture == 0) {
    glGenTextures(1, &map.texture);
    const BoundTexture bound(window_, GL_TEXTURE_2D, map.texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kMovingMapSize, kMovingMapSize, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
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
  state->vtkglViewport(0, 0, kMovingMapSize, kMovingMapSize);
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST), cull(state, GL_CULL_FACE);
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  const vtkOpenGLState::ScopedglDepthFunc function(state);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  // Prevents self-shadowing of slanted surfaces: an offset by the depth range of a texel, and a little of the 24-bit
  // resolution.
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
}

void MovingShadows::release() {
  geometry_.release();
  for (Map& map : maps_) {
    glDeleteTextures(1, &map.texture);
    map.framebuffer.release();
  }
  maps_.clear();
  state_->resources.movingShadows.clear();
  program_ = nullptr;
  stale_ = true;
}

}  // namespace boxprobe
