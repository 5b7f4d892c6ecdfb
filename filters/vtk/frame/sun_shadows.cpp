#include "filters/vtk/frame/sun_shadows.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace boxprobe {

namespace {

// Pairs of objects that are looked at; of more objects all take shadows.
constexpr std::size_t kMostObjects = 2048;
// How far from what throws it an edge is as soft as the sun makes it, scene units: nearer it is softer, farther
// sharper.
constexpr double kSoftAt = 1.0;
// Taps of the filter are apart by so many texels at most, or steps would show between them.
constexpr double kMostApart = 3.0;

bool castsSun(const DrawnObject& object) {
  return object.settings.visible && !object.settings.dynamic && object.material.alphaMode != AlphaMode::Blend &&
         !object.material.transmits();
}

Box turned(const glm::dmat3& turn, const Box& box) {
  const glm::dvec3 middle = turn * box.center(), half = 0.5 * box.size();
  glm::dvec3 reach(0.0);
  for (int axis = 0; axis < 3; ++axis) reach += glm::abs(turn[axis]) * half[axis];
  return {middle - reach, middle + reach};
}

bool flat(const Box& box) {
  const glm::dvec3 size = box.size();
  return std::min({size.x, size.y, size.z}) <= 1.0e-6 * std::max({size.x, size.y, size.z});
}

}  // namespace

std::optional<SunView> sunView(const glm::dvec3& direction, const std::vector<Box>& casters) {
  const double length = glm::length(direction);
  if (casters.empty() || !(length > 0.0)) return std::nullopt;
  const glm::dvec3 away = direction / length, across = glm::normalize(glm::cross(anyUp(away), away));
  SunView view;
  view.sunFromWorld = glm::transpose(glm::dmat3(across, glm::cross(away, across), away));
  view.bounds = turned(view.sunFromWorld, casters.front());
  for (const Box& caster : casters) {
    const Box b = turned(view.sunFromWorld, caster);
    view.bounds = {glm::min(view.bounds.min, b.min), glm::max(view.bounds.max, b.max)};
  }
  const glm::dvec3 size = view.bounds.size();
  const double margin = std::max({size.x, size.y, size.z, 1.0e-6}) * 4.0 / SunShadows::kMapSize;
  view.bounds = {view.bounds.min - margin, view.bounds.max + margin};
  view.mapFromWorld = glm::scale(glm::dmat4(1.0), 1.0 / view.bounds.size()) *
                      glm::translate(glm::dmat4(1.0), -view.bounds.min) * glm::dmat4(view.sunFromWorld);
  return view;
}

std::vector<bool> sunReceivers(const SunView& view, const std::vector<Box>& receivers,
                               const std::vector<Box>& casters) {
  if (receivers.size() > kMostObjects || casters.size() > kMostObjects)
    return std::vector<bool>(receivers.size(), true);
  std::vector<Box> seen;
  for (const Box& caster : casters) seen.push_back(turned(view.sunFromWorld, caster));
  std::vector<bool> result;
  for (const Box& receiver : receivers) {
    const Box r = turned(view.sunFromWorld, receiver);
    bool shaded = false;
    for (std::size_t i = 0; i < seen.size() && !shaded; ++i) {
      const Box& c = seen[i];
      const bool itself = casters[i].min == receiver.min && casters[i].max == receiver.max;
      shaded = !(itself && flat(receiver)) && c.min.x < r.max.x && c.max.x > r.min.x && c.min.y < r.max.y &&
               c.max.y > r.min.y && c.min.z < r.max.z;
    }
    result.push_back(shaded);
  }
  return result;
}

void SunShadows::sceneChanged() {
  Of of;
  of.on = content_->lamps && content_->sightLines;
  of.models = content_->modelGeneration;
  of.lights = content_->scene.lights;
  for (const DrawnObject& object : content_->objects) {
    of.objects.push_back(object.worldFromModel);
    of.casts.push_back(castsSun(object));
  }
  if (of == of_) return;
  of_ = std::move(of);
  std::vector<SunShadow>& suns = state_->resources.sunShadows;
  suns.clear();
  stale_ = false;
  if (!of_.on) return;
  const std::vector<Light>& lights = content_->scene.lights;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const bool shines = lights[i].intensity > 0.0f && glm::length(lights[i].color) > 0.0f;
    if (lights[i].type == LightType::Directional && lights[i].shadows == LightShadows::None && shines)
      order.push_back(i);
  }
  if (order.empty()) return;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return lights[a].intensity * glm::length(lights[a].color) > lights[b].intensity * glm::length(lights[b].color);
  });
  if (order.size() > kMostMaps) order.resize(kMostMaps);
  std::sort(order.begin(), order.end());
  std::vector<Box> receivers, casters;
  for (const DrawnObject& object : content_->objects) {
    receivers.push_back(worldBounds(object));
    if (castsSun(object)) casters.push_back(receivers.back());
  }
  for (const std::size_t light : order) {
    const auto view = sunView(lights[light].direction, casters);
    if (!view) continue;
    SunShadow sun;
    sun.light = static_cast<int>(light);
    sun.size = kMapSize;
    sun.mapFromWorld = view->mapFromWorld;
    sun.shades = sunReceivers(*view, receivers, casters);
    if (std::none_of(sun.shades.begin(), sun.shades.end(), [](bool shaded) { return shaded; })) continue;
    const glm::dvec3 size = view->bounds.size();
    const double texel = std::max(size.x, size.y) / kMapSize;
    const double soft = 2.0 * kSoftAt * std::tan(0.5 * glm::radians(lights[light].angleDegrees)) / 3.0;
    const double apart = std::clamp(soft, texel, kMostApart * texel);
    sun.apart = glm::vec2(apart / size.x, apart / size.y);
    sun.off = static_cast<float>(apart + texel);
    suns.push_back(std::move(sun));
    stale_ = true;
  }
}

void SunShadows::update() {
  if (!stale_) return;
  stale_ = false;
  std::vector<SunShadow>& suns = state_->resources.sunShadows;
  for (std::size_t i = 0; i < suns.size(); ++i) {
    if (maps_.size() <= i) maps_.emplace_back();
    painter_.draw(maps_[i], kMapSize, suns[i].mapFromWorld, castsSun);
    suns[i].texture = maps_[i].texture;
  }
}

void SunShadows::release() {
  painter_.release();
  for (ShadowMap& map : maps_) ShadowMapPainter::release(map);
  maps_.clear();
  for (SunShadow& sun : state_->resources.sunShadows) sun.texture = 0;
  stale_ = !state_->resources.sunShadows.empty();
}

}  // namespace boxprobe
