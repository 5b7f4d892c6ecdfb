// See lit_errors.h.
#include "filters/fit/lit_errors.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/probe_index.h"
#include "filters/core/geometry/probe_shares.h"
#include "filters/fit/box/visibility.h"
#include "filters/math/shared/shared_math.h"

namespace boxprobe {

namespace {

struct LitProbe {
  ProbeGeometry geometry;
  OffsetBox box;
  double importance = 1.0;
  const SurfaceRays* captured = nullptr;
};

/// In degrees; nothing if the origin does not see the ray's end.
std::optional<double> errorOf(const LitProbe& probe, const ReflectedRay& ray) {
  const glm::dvec3 origin = probe.geometry.originWorld, target = ray.hit - origin;
  const double distance = glm::length(target);
  if (!(distance > 0.0) || !visibleFrom(*probe.captured, origin, ray.hit)) return std::nullopt;
  const glm::dmat3 boxFromWorld = glm::transpose(probe.geometry.worldFromProbe);
  const LookupRay lookup{boxFromWorld * (ray.from - origin), boxFromWorld * ray.along,
                         boxFromWorld * (target / distance), ray.weight};
  return std::min(glm::degrees(lookupError(lookup, boxExit(lookup, probe.box.offset).distance)), kHiddenDegrees);
}

}  // namespace

LitErrors litErrors(ProbeFitter& fitter, const ReflectedRays& rays, const std::vector<Probe>& probes) {
  std::vector<Probe> sorted = probes;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Probe& a, const Probe& b) { return a.importance > b.importance; });
  const ProbeIndex index(sorted);
  std::vector<LitProbe> lit;
  for (const Probe& probe : sorted) {
    lit.push_back(
        {probeGeometry(probe, probe.origin), offsetBox(probe), probe.importance, &fitter.placeOf(probe).captured});
  }
  LitErrors errors;
  std::vector<std::pair<double, double>> all;
  for (const ReflectedRay& ray : rays.rays) {
    const std::vector<std::size_t> near = index.meeting({ray.from, ray.from});
    std::vector<float> weights;
    std::vector<int> groups;
    for (std::size_t i = 0; i < near.size(); ++i) {
      const ProbeGeometry& g = lit[near[i]].geometry;
      const glm::vec3 p(glm::transpose(g.worldFromProbe) * (ray.from - g.originWorld));
      weights.push_back(shading::influenceWeight(p, g.influenceMin, g.influenceMax, g.rateMin, g.rateMax));
      const bool same = i > 0 && lit[near[i]].importance == lit[near[i - 1]].importance;
      groups.push_back(i == 0 ? 0 : groups.back() + (same ? 0 : 1));
    }
    const ProbeShares shares = shareOut(weights, groups, false);
    double degrees = kHiddenDegrees * shares.sky;
    errors.unlit += ray.weight * shares.sky;
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (!(shares.probes[i] > 0.0f)) continue;
      const std::optional<double> error = errorOf(lit[near[i]], ray);
      if (!error) errors.hidden += ray.weight * shares.probes[i];
      degrees += shares.probes[i] * error.value_or(kHiddenDegrees);
    }
    errors.meanDegrees += ray.weight * degrees;
    all.emplace_back(degrees, ray.weight);
  }
  std::sort(all.begin(), all.end());
  double below = 0.0;
  for (const auto& [degrees, weight] : all) {
    below += weight;
    errors.p95Degrees = degrees;
    if (below >= 0.95) break;
  }
  return errors;
}

}  // namespace boxprobe
