#include "filters/vtk/frame/moving_shadows.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

bool casts(const DrawnObject& object) {
  return object.settings.visible && object.settings.dynamic && object.material.alphaMode != AlphaMode::Blend;
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
    : state_(state), content_(content), painter_(window, std::move(state), content) {}

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
    if (state_->resources.movingLightsInUse.count(static_cast<int>(i)) == 0) continue;
    const auto matrix = movingMapFromWorld(lights[i], *casters);
    if (!matrix) continue;
    const std::size_t at = state_->resources.movingShadows.size();
    if (maps_.size() <= at) maps_.emplace_back();
    painter_.draw(maps_[at], kMovingMapSize, *matrix, casts);
    state_->resources.movingShadows.push_back({static_cast<int>(i), maps_[at].texture, *matrix});
  }
}

void MovingShadows::release() {
  painter_.release();
  for (ShadowMap& map : maps_) ShadowMapPainter::release(map);
  maps_.clear();
  state_->resources.movingShadows.clear();
  stale_ = true;
}

}  // namespace boxprobe
