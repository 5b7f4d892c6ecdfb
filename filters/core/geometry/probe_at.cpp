#include "filters/core/geometry/probe_at.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numeric>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/probe_shares.h"
#include "filters/math/shared/shared_math.h"

namespace boxprobe {

namespace {

double influenceVolume(const Probe& probe) {
  const glm::dvec3 size = probe.influenceBox().size();
  return size.x * size.y * size.z;
}

/// Distance to the influence box in scene units; 0 inside.
double influenceDistance(const Probe& probe, const glm::dvec3& pointWorld) {
  const glm::dvec3 pivot = probe.box.center();
  const glm::dvec3 point = pivot + glm::transpose(rotationMatrix(probe.rotationDegrees)) * (pointWorld - pivot);
  const Box& box = probe.influenceBox();
  return glm::length(point - glm::clamp(point, box.min, box.max));
}

}  // namespace

std::optional<std::size_t> probeLighting(const std::vector<Probe>& probes, const glm::dvec3& pointWorld) {
  std::vector<std::size_t> order(probes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return probes[a].importance > probes[b].importance; });
  std::vector<float> weights;
  std::vector<int> groups;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const ProbeGeometry g = probeGeometry(probes[order[i]], probes[order[i]].origin);
    const glm::vec3 point(glm::transpose(g.worldFromProbe) * (pointWorld - g.originWorld));
    weights.push_back(shading::influenceWeight(point, g.influenceMin, g.influenceMax, g.rateMin, g.rateMax));
    const bool same = i > 0 && probes[order[i]].importance == probes[order[i - 1]].importance;
    groups.push_back(i == 0 ? 0 : groups.back() + (same ? 0 : 1));
  }
  const ProbeShares shares = shareOut(weights, groups, false);
  std::optional<std::size_t> best;
  float most = 0.0f;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const float share = shares.probes[i];
    const bool smaller = best && share == most && influenceVolume(probes[order[i]]) < influenceVolume(probes[*best]);
    if (!(share > most) && !smaller) continue;
    most = share;
    best = order[i];
  }
  return best;
}

std::optional<std::size_t> probeNearest(const std::vector<Probe>& probes, const glm::dvec3& pointWorld) {
  if (const auto lighting = probeLighting(probes, pointWorld)) return lighting;
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const double distance = influenceDistance(probes[i], pointWorld);
    if (!(distance < least)) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

}  // namespace boxprobe
