#include "filters/reference/light/reference_box.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

namespace boxprobe {

BoxWorld::BoxWorld(const ProbeAtPoint& probe, const CubeMap& radiance)
    : map_(radiance),
      worldFromProbe_(probe.worldFromProbe),
      mapFromProbe_(probe.mapFromProbe),
      position_(probe.positionProbe),
      low_(probe.boxMin),
      high_(probe.boxMax) {}

glm::dvec3 BoxWorld::exit(const glm::dvec3& from, const glm::dvec3& l, int* axis) const {
  double distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (l[i] == 0.0) continue;
    const double room = l[i] > 0.0 ? high_[i] - from[i] : from[i] - low_[i];
    const double reached = std::max(room, 0.0) / std::abs(l[i]);
    if (reached >= distance) continue;
    distance = reached;
    if (axis != nullptr) *axis = i;
  }
  return glm::clamp(from + distance * l, low_, high_);
}

glm::dvec3 BoxWorld::hit(const glm::dvec3& directionWorld) const {
  return mapFromProbe_ * exit(position_, glm::transpose(worldFromProbe_) * directionWorld, nullptr);
}

bool BoxWorld::convex() const {
  const auto inside = [&](const glm::dvec3& p) {
    return glm::all(glm::greaterThanEqual(p, low_)) && glm::all(glm::lessThanEqual(p, high_));
  };
  // Single-precision rounding moves a surface in a wall of the box off it: a millionth of its size.
  return inside(glm::dvec3(0.0)) &&
         glm::all(glm::lessThan(glm::abs(position_ - glm::clamp(position_, low_, high_)), 1.0e-6 * (high_ - low_)));
}

glm::dvec3 BoxWorld::towards(const glm::dvec3& fromOriginMap) const {
  const glm::dvec3 fromOrigin = glm::transpose(mapFromProbe_) * fromOriginMap;
  const glm::dvec3 way = exit(glm::dvec3(0.0), fromOrigin, nullptr) - position_;
  const double length = glm::length(way);
  return length > 0.0 ? worldFromProbe_ * (way / length) : glm::dvec3(0.0);
}

double BoxWorld::magnification(const glm::dvec3& directionWorld, glm::dvec3* fromOriginMap) const {
  const glm::dvec3 l = glm::transpose(worldFromProbe_) * directionWorld;
  int axis = 0;
  const glm::dvec3 hit = exit(position_, l, &axis), way = hit - position_;
  *fromOriginMap = mapFromProbe_ * hit;
  const double fromHere = glm::dot(way, way), fromOrigin = glm::dot(hit, hit);
  const double cosineHere = std::abs(l[axis]), cosineOrigin = std::abs(hit[axis]) / std::sqrt(fromOrigin);
  if (!(fromOrigin > 0.0) || !(cosineHere > 0.0)) return 0.0;
  return cosineOrigin / fromOrigin * (fromHere / cosineHere);
}

glm::dvec3 BoxWorld::radiance(const glm::dvec3& directionWorld) const {
  return glm::dvec3(map_.fetch(glm::vec3(hit(directionWorld)), 0.0f));
}

void ReferenceBoxMaps::findBright() {
  bright.clear();
  for (const auto& probe : probes) {
    bright.push_back(probe ? std::make_shared<const BrightDirections>(probe->radiance) : nullptr);
  }
}

BoxSurroundings::BoxSurroundings(const LitPoint& pixel, const ReferenceBoxMaps& maps) {
  for (const ProbeAtPoint& probe : pixel.probes) {
    const auto index = static_cast<std::size_t>(probe.index);
    const double share = static_cast<double>(probe.weight) * probe.intensity;
    if (share <= 0.0 || index >= maps.probes.size() || !maps.probes[index]) continue;
    Part part{BoxWorld(probe, maps.probes[index]->radiance), share, nullptr};
    if (index < maps.bright.size() && maps.bright[index] && maps.bright[index]->groups() > 0 && part.world.convex()) {
      part.bright = maps.bright[index].get();
      groups_ += part.bright->groups();
    }
    parts_.push_back(part);
  }
  if (maps.sky) {
    sky_ = &maps.sky->radiance;
    skyShare_ = pixel.skyWeight;
  }
}

glm::dvec3 BoxSurroundings::radiance(const glm::dvec3& direction) const {
  glm::dvec3 sum(0.0);
  for (const Part& part : parts_) sum += part.share * part.world.radiance(direction);
  if (skyShare_ > 0.0) sum += skyShare_ * glm::dvec3(sky_->fetch(glm::vec3(direction), 0.0f));
  return sum;
}

BoxSurroundings::Light BoxSurroundings::light(const glm::dvec3& direction) const {
  Light sum;
  for (const Part& part : parts_) {
    const glm::dvec3 all = part.world.radiance(direction);
    const glm::dvec3 bright = part.bright != nullptr ? part.bright->excess(all) : glm::dvec3(0.0);
    sum.even += part.share * (all - bright);
    sum.bright += part.share * bright;
  }
  if (skyShare_ > 0.0) sum.even += skyShare_ * glm::dvec3(sky_->fetch(glm::vec3(direction), 0.0f));
  return sum;
}

std::vector<double> BoxSurroundings::lampChances(const VisibleNormalLobe& lobe) const {
  // For lobes narrower than a group its middle is not representative.
  constexpr double kLeastAlpha = 0.1;
  const VisibleNormalLobe wide = lobe.widened(kLeastAlpha);
  std::vector<double> reflected, shares;
  double all = 0.0, light = 0.0;
  for (const Part& part : parts_) {
    if (part.bright == nullptr) continue;
    for (std::size_t g = 0; g < part.bright->groups(); ++g) {
      const glm::dvec3 l = part.world.towards(part.bright->middle(g));
      const VisibleNormalLobe::Density of = wide.at(l);
      glm::dvec3 fromOrigin;
      const double larger = part.world.magnification(l, &fromOrigin);
      shares.push_back(part.share * part.bright->share(g));
      reflected.push_back(larger > 0.0 ? shares.back() * of.weight * of.density / larger : 0.0);
      light += shares.back();
      all += reflected.back();
    }
  }
  // A fifth by light alone, so that nothing that the middle of a group misses is lost.
  std::vector<double> chances;
  double sum = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double byLight = shares[i] / light;
    sum += all > 0.0 ? 0.2 * byLight + 0.8 * reflected[i] / all : byLight;
    chances.push_back(sum);
  }
  for (double& c : chances) c /= sum;
  return chances;
}

glm::dvec3 BoxSurroundings::towardsLamp(const std::vector<double>& chances, const glm::dvec2& u) const {
  auto at = static_cast<std::size_t>(std::upper_bound(chances.begin(), chances.end(), u.x) - chances.begin());
  at = std::min(at, chances.size() - 1);
  const double before = at > 0 ? chances[at - 1] : 0.0, chance = chances[at] - before;
  const glm::dvec2 within(chance > 0.0 ? std::clamp((u.x - before) / chance, 0.0, 1.0) : 0.5, u.y);
  for (const Part& part : parts_) {
    if (part.bright == nullptr) continue;
    if (at < part.bright->groups()) return part.world.towards(part.bright->sample(at, within));
    at -= part.bright->groups();
  }
  return glm::dvec3(0.0);
}

double BoxSurroundings::lampDensity(const std::vector<double>& chances, const glm::dvec3& direction) const {
  double sum = 0.0;
  std::size_t first = 0;
  for (const Part& part : parts_) {
    if (part.bright == nullptr) continue;
    glm::dvec3 fromOrigin;
    const double larger = part.world.magnification(direction, &fromOrigin);
    if (larger > 0.0) {
      const BrightDirections::Place place = part.bright->at(fromOrigin);
      const std::size_t at = first + place.group;
      sum += place.density * larger * (chances[at] - (at > 0 ? chances[at - 1] : 0.0));
    }
    first += part.bright->groups();
  }
  return sum;
}

glm::dvec3 BoxSurroundings::reflected(const VisibleNormalLobe& lobe, const ReflectingLayer& layer, int rays,
                                      std::uint64_t seed) const {
  return reflectedOf([&](const glm::dvec3& l) { return light(l); }, lobe, layer, rays, seed);
}

glm::dvec3 BoxSurroundings::reflectedOf(const std::function<Light(const glm::dvec3&)>& light,
                                        const VisibleNormalLobe& lobe, const ReflectingLayer& layer, int rays,
                                        std::uint64_t seed) const {
  const auto reflectance = [&](double hDotV) { return layer.reflectance(hDotV); };
  if (groups_ == 0 || lobe.mirror()) {
    return lobeReflected(lobe, rays, seed, reflectance, [&](const glm::dvec3& l) {
      const Light of = light(l);
      return of.even + of.bright;
    });
  }
  // As many rays towards lamps as by the lobe: each fails where the other is good.
  const int towardsLamps = std::max(rays / 2, 1), byLobe = std::max(rays - towardsLamps, 1);
  const std::vector<double> chances = lampChances(lobe);
  glm::dvec3 bright(0.0);
  const auto addBright = [&](const glm::dvec3& l, const VisibleNormalLobe::Density& of, const glm::dvec3& value) {
    if (value == glm::dvec3(0.0)) return;
    const double density = byLobe * of.density + towardsLamps * lampDensity(chances, l);
    if (density > 0.0) bright += of.weight * of.density / density * layer.reflectance(of.hDotV) * value;
  };
  const glm::dvec3 even = lobeReflected(lobe, byLobe, seed, reflectance, [&](const glm::dvec3& l) {
    const Light seen = light(l);
    addBright(l, lobe.at(l), seen.bright);
    return seen.even;
  });
  const ShiftedPoints points(hashBits(seed ^ 0x5bd1e995u));
  for (int i = 0; i < towardsLamps; ++i) {
    const glm::dvec3 l = towardsLamp(chances, points[i]);
    const VisibleNormalLobe::Density of = lobe.at(l);
    if (of.weight > 0.0) addBright(l, of, light(l).bright);
  }
  return even + bright;
}

glm::dvec3 referenceBoxColor(const LitPoint& pixel, const ReferenceBoxMaps& maps, int rays, std::uint64_t seed,
                             bool* exact) {
  if (exact != nullptr) *exact = true;
  if (!pixel.hit) return glm::dvec3(pixel.color);
  const BoxSurroundings surroundings(pixel, maps);
  glm::dvec3 color(pixel.direct + pixel.emissive + pixel.diffuse);
  if (surroundings.empty()) return color;
  for (const ReflectingLayer& layer : reflectingLayers(pixel.surface, maps.energy)) {
    const VisibleNormalLobe lobe = layer.lobe(glm::normalize(glm::dvec3(pixel.surface.viewWorld)));
    if (exact != nullptr) *exact = *exact && lobe.mirror();
    color += surroundings.reflected(lobe, layer, rays, seed);
    seed = hashBits(seed);
  }
  return color;
}

}  // namespace boxprobe
