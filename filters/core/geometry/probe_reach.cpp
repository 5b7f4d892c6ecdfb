#include "filters/core/geometry/probe_reach.h"

#include <algorithm>

namespace boxprobe {

namespace {

constexpr double kWallThickness = 0.4, kSkin = 0.12;
// Of a side's rays, so many come through where there is a door or a window.
constexpr int kRaysAlong = 24;
constexpr double kOpening = 0.02;

double reachOf(double beyond) {
  return beyond > kSkin && beyond <= kWallThickness ? beyond : 0.0;
}

}  // namespace

ProbeReach influenceReach(const glm::dvec3& boxMin, const glm::dvec3& boxMax, const glm::dvec3& influenceMin,
                          const glm::dvec3& influenceMax) {
  ProbeReach reach;
  for (int axis = 0; axis < 3; ++axis) {
    reach.low[axis] = reachOf(boxMin[axis] - influenceMin[axis]);
    reach.high[axis] = reachOf(influenceMax[axis] - boxMax[axis]);
  }
  return reach;
}

ProbeReach openReach(const ProbeReach& asked, const SightLines& lines, const glm::dvec3& originWorld,
                     const glm::dmat3& worldFromBox, const glm::dvec3& low, const glm::dvec3& high) {
  ProbeReach open;
  const glm::dvec3 size = high - low;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool upper = side % 2 != 0;
    const double reach = upper ? asked.high[axis] : asked.low[axis];
    if (!(reach > 0.0) || !(size[axis] > 0.0)) continue;
    // From before the side, since the wall may stand a little inside of the box.
    const double before = std::min(0.1, 0.1 * size[axis]);
    glm::dvec3 outwards(0.0);
    outwards[axis] = upper ? 1.0 : -1.0;
    int through = 0;
    for (int i = 0; i < kRaysAlong * kRaysAlong; ++i) {
      glm::dvec3 from(0.0);
      from[axis] = upper ? high[axis] - before : low[axis] + before;
      from[u] = low[u] + (i % kRaysAlong + 0.5) / kRaysAlong * size[u];
      from[v] = low[v] + (static_cast<double>(i / kRaysAlong) + 0.5) / kRaysAlong * size[v];
      const auto hit = lines.first(originWorld + worldFromBox * from, worldFromBox * outwards);
      through += hit && (hit->back || hit->distance < before + reach) ? 0 : 1;
    }
    if (through > kOpening * kRaysAlong * kRaysAlong) (upper ? open.high : open.low)[axis] = reach;
  }
  return open;
}

}  // namespace boxprobe
