#include "filters/vtk/frame/sun_shadows.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>
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

// With a margin of some texels around it.
void setBounds(SunView& view, const Box& bounds) {
  const glm::dvec3 size = bounds.size();
  const double margin = std::max({size.x, size.y, 1.0e-6 * size.z, 1.0e-6}) * 4.0 / SunShadows::kMapSize;
  view.bounds = {bounds.min - margin, bounds.max + margin};
  view.mapFromWorld = glm::scale(glm::dmat4(1.0), 1.0 / view.bounds.size()) *
                      glm::translate(glm::dmat4(1.0), -view.bounds.min) * glm::dmat4(view.sunFromWorld);
}

// As the light sees it, the longer side.
double widthOf(const Box& inView) {
  return std::max(inView.size().x, inView.size().y);
}

double texelOf(const SunView& view) {
  return widthOf(view.bounds) / SunShadows::kMapSize;
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
  setBounds(view, view.bounds);
  return view;
}

std::optional<SunView> sunViewAround(const SunView& all, const std::vector<Box>& some) {
  if (some.empty()) return std::nullopt;
  Box around = turned(all.sunFromWorld, some.front());
  for (const Box& one : some) {
    const Box b = turned(all.sunFromWorld, one);
    around = {glm::min(around.min, b.min), glm::max(around.max, b.max)};
  }
  around.min.z = all.bounds.min.z;
  around.max.z = all.bounds.max.z;
  SunView view = all;
  setBounds(view, around);
  return 2.0 * texelOf(view) <= texelOf(all) ? std::optional<SunView>(view) : std::nullopt;
}

namespace {

// Does all of `receiver` lie on the light's side of `caster`, a flat one? What stands on a floor is not shaded by it.
bool before(const SunView& view, const Box& receiver, const Box& caster) {
  if (!flat(caster)) return false;
  const glm::dvec3 size = caster.size();
  const int axis = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  const double away = view.sunFromWorld[axis].z, least = 1.0e-6 * std::max({size.x, size.y, size.z});
  return away < 0.0   ? receiver.min[axis] >= caster.min[axis] - least
         : away > 0.0 ? receiver.max[axis] <= caster.max[axis] + least
                      : false;
}

}  // namespace

std::vector<bool> sunReceivers(const SunView& view, const std::vector<Box>& receivers, const std::vector<Box>& casters,
                               bool onGround) {
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
      shaded = !(itself && flat(receiver)) && (onGround || !before(view, receiver, casters[i])) && c.min.x < r.max.x &&
               c.max.x > r.min.x && c.min.y < r.max.y && c.max.y > r.min.y && c.min.z < r.max.z;
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
  if (order.size() > kMostSuns) order.resize(kMostSuns);
  std::sort(order.begin(), order.end());
  std::vector<Box> bounds, casters;
  for (const DrawnObject& object : content_->objects) {
    bounds.push_back(worldBounds(object));
    if (castsSun(object)) casters.push_back(bounds.back());
  }
  for (const std::size_t light : order) {
    const auto view = sunView(lights[light].direction, casters);
    if (!view) continue;
    // What is wider than half of everything, such as the ground, reads the one; what stands on it the other.
    std::vector<bool> whole = sunReceivers(*view, bounds, casters), near(whole.size(), false);
    std::vector<Box> around;
    const std::vector<bool> shaded = sunReceivers(*view, bounds, casters, false);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      near[i] = shaded[i] && widthOf(turned(view->sunFromWorld, bounds[i])) <= 0.5 * widthOf(view->bounds);
      if (near[i]) around.push_back(bounds[i]);
    }
    if (const auto finer = sunViewAround(*view, around)) {
      for (std::size_t i = 0; i < whole.size(); ++i) whole[i] = whole[i] && !near[i];
      add(static_cast<int>(light), *finer, std::move(near));
    }
    add(static_cast<int>(light), *view, std::move(whole));
  }
}

void SunShadows::add(int light, const SunView& view, std::vector<bool> shades) {
  if (std::none_of(shades.begin(), shades.end(), [](bool shaded) { return shaded; })) return;
  SunShadow sun;
  sun.light = light;
  sun.size = kMapSize;
  sun.mapFromWorld = view.mapFromWorld;
  sun.shades = std::move(shades);
  const glm::dvec3 size = view.bounds.size();
  const double texel = texelOf(view);
  const double angle = content_->scene.lights[static_cast<std::size_t>(light)].angleDegrees;
  const double soft = 2.0 * kSoftAt * std::tan(0.5 * glm::radians(angle)) / 3.0;
  const double apart = std::clamp(soft, texel, kMostApart * texel);
  sun.apart = glm::vec2(apart / size.x, apart / size.y);
  sun.off = static_cast<float>(apart + texel);
  state_->resources.sunShadows.push_back(std::move(sun));
  stale_ = true;
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
