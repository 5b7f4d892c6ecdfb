#include "filters/core/geometry/probe_shares.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/math/shared/shared_math.h"

namespace boxprobe {

ProbeShares shareOut(const std::vector<float>& weights, const std::vector<int>& groups, bool onlyProbes) {
  ProbeShares shares;
  std::vector<float> sum(groups.empty() ? 0 : static_cast<std::size_t>(groups.back()) + 1, 0.0f);
  for (std::size_t i = 0; i < weights.size(); ++i) sum[static_cast<std::size_t>(groups[i])] += weights[i];
  std::vector<float> share;
  for (const float s : sum) {
    share.push_back(shading::groupShare(shares.sky, s));
    shares.sky = shading::remainingAfter(shares.sky, s);
  }
  if (onlyProbes) {
    const float scale = shading::onlyProbesScale(shares.sky);
    for (float& s : share) s *= scale;
    shares.sky = shading::onlyProbesRemaining(shares.sky);
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    shares.probes.push_back(share[static_cast<std::size_t>(groups[i])] * weights[i]);
  }
  return shares;
}

double objectWeight(const Probe& probe, const Box& boundsWorld) {
  const Box& influence = probe.influenceBox();
  const glm::dvec3 pivot = probe.box.center();
  const glm::dmat3 probeFromWorld = glm::transpose(rotationMatrix(probe.rotationDegrees));
  const glm::dvec3 middle = pivot + probeFromWorld * (boundsWorld.center() - pivot);
  const glm::dvec3 size = 0.5 * boundsWorld.size();
  const glm::dvec3 half = glm::abs(probeFromWorld[0]) * size.x + glm::abs(probeFromWorld[1]) * size.y +
                          glm::abs(probeFromWorld[2]) * size.z;
  double weight = 1.0;
  for (int i = 0; i < 3; ++i) {
    const double low = middle[i] - half[i], high = middle[i] + half[i];
    const double inside = std::min(high, influence.max[i]) - std::max(low, influence.min[i]);
    if (inside < 0.0) return 0.0;
    if (high > low) weight *= std::min(inside / (high - low), 1.0);
  }
  return weight;
}

}  // namespace boxprobe
