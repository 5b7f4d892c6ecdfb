#include "filters/reference/reference_box.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "filters/reference/reflecting_layers.h"
#include "filters/reference/visible_normal_lobe.h"

namespace boxprobe {

BoxWorld::BoxWorld(const ProbeExplanation& probe, const CubeMap& radiance)
    : map_(radiance),
      worldFromProbe_(probe.worldFromProbe),
      position_(probe.positionProbe),
      low_(probe.boxMin),
      high_(probe.boxMax) {}

glm::dvec3 BoxWorld::hit(const glm::dvec3& directionWorld) const {
  const glm::dvec3 l = glm::transpose(worldFromProbe_) * directionWorld;
  double distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (l[i] == 0.0) continue;
    const double room = l[i] > 0.0 ? high_[i] - position_[i] : position_[i] - low_[i];
    distance = std::min(distance, std::max(room, 0.0) / std::abs(l[i]));
  }
  return worldFromProbe_ * glm::clamp(position_ + distance * l, low_, high_);
}

glm::dvec3 BoxWorld::radiance(const glm::dvec3& directionWorld) const {
  return glm::dvec3(map_.fetch(glm::vec3(hit(directionWorld)), 0.0f));
}

glm::dvec3 referenceBoxColor(const Explanation& pixel, const ReferenceBoxMaps& maps, const BrdfTable& brdf, int rays,
                             std::uint64_t seed, bool* exact) {
  if (exact != nullptr) *exact = true;
  if (!pixel.hit) return glm::dvec3(pixel.color);
  struct Part {
    BoxWorld world;
    double share;
  };
  std::vector<Part> parts;
  for (const ProbeExplanation& probe : pixel.probes) {
    const auto index = static_cast<std::size_t>(probe.index);
    const double share = static_cast<double>(probe.weight) * probe.intensity;
    if (share <= 0.0 || index >= maps.probes.size() || !maps.probes[index]) continue;
    parts.push_back({BoxWorld(probe, maps.probes[index]->radiance), share});
  }
  const double skyShare = maps.sky ? pixel.skyWeight : 0.0;
  const auto surroundings = [&](const glm::dvec3& direction) {
    glm::dvec3 sum(0.0);
    for (const Part& part : parts) sum += part.share * part.world.radiance(direction);
    if (skyShare > 0.0) sum += skyShare * glm::dvec3(maps.sky->radiance.fetch(glm::vec3(direction), 0.0f));
    return sum;
  };
  glm::dvec3 color(pixel.direct + pixel.emissive + pixel.diffuse);
  if (parts.empty() && skyShare <= 0.0) return color;
  for (const ReflectingLayer& layer : reflectingLayers(pixel.surface, brdf)) {
    const VisibleNormalLobe lobe(glm::normalize(layer.normalWorld), glm::normalize(glm::dvec3(pixel.surface.viewWorld)),
                                 layer.roughness * layer.roughness);
    if (exact != nullptr) *exact = *exact && lobe.mirror();
    color += layer.factor *
             lobeMean(lobe, glm::dvec3(layer.fresnel.f0), glm::dvec3(layer.fresnel.f90), rays, seed, surroundings);
    seed = stirred(seed);
  }
  return color;
}

}  // namespace boxprobe
