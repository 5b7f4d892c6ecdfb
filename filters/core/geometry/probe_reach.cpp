#include "filters/core/geometry/probe_reach.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "filters/math/cube/diffuse_lattice.h"

namespace boxprobe {

namespace {

// In metreOf() the box.
constexpr double kSkin = 0.12, kBeforeSide = 0.1;
// Of a side's rays, so many come through where there is a door or a window.
constexpr int kRaysAlong = 24;
constexpr double kOpening = 0.02;
// With the box, of its shortest side and of the box.
constexpr double kLongest = 5.0, kLonger = 1.25;

// Do rays straight outwards come through the side of a box as far as `reach` beyond it?
bool opens(int side, double reach, const SightLines& lines, const glm::dvec3& originWorld,
           const glm::dmat3& worldFromBox, const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 size = high - low;
  const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
  const bool upper = side % 2 != 0;
  // From before the side, since the wall may stand a little inside of the box.
  const double before = std::min(kBeforeSide * metreOf(size), 0.1 * size[axis]);
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
  return through > kOpening * kRaysAlong * kRaysAlong;
}

// Around all surfaces, in the box's frame.
Box surfacesAround(const SightLines& lines, const glm::dvec3& originWorld, const glm::dmat3& worldFromBox) {
  const Box world = lines.bounds();
  const glm::dmat3 boxFromWorld = glm::transpose(worldFromBox);
  Box around{glm::dvec3(1e300), glm::dvec3(-1e300)};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at((corner & 1) != 0 ? world.max.x : world.min.x, (corner & 2) != 0 ? world.max.y : world.min.y,
                        (corner & 4) != 0 ? world.max.z : world.min.z);
    const glm::dvec3 inBox = boxFromWorld * (at - originWorld);
    around = {glm::min(around.min, inBox), glm::max(around.max, inBox)};
  }
  return around;
}

}  // namespace

ProbeReach influenceReach(const glm::dvec3& boxMin, const glm::dvec3& boxMax, const glm::dvec3& influenceMin,
                          const glm::dvec3& influenceMax) {
  ProbeReach reach;
  const double skin = kSkin * metreOf(boxMax - boxMin);
  for (int axis = 0; axis < 3; ++axis) {
    const double below = boxMin[axis] - influenceMin[axis], above = influenceMax[axis] - boxMax[axis];
    reach.low[axis] = below > skin ? below : 0.0;
    reach.high[axis] = above > skin ? above : 0.0;
  }
  return reach;
}

ProbeReach openReach(const ProbeReach& asked, const SightLines& lines, const glm::dvec3& originWorld,
                     const glm::dmat3& worldFromBox, const glm::dvec3& low, const glm::dvec3& high) {
  ProbeReach open;
  const glm::dvec3 size = high - low;
  const double wall = kWallThickness * metreOf(size), skin = kSkin * metreOf(size);
  const Box surfaces = surfacesAround(lines, originWorld, worldFromBox);
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const bool upper = side % 2 != 0;
    const double wanted = upper ? asked.high[axis] : asked.low[axis];
    const double there = upper ? surfaces.max[axis] - high[axis] : low[axis] - surfaces.min[axis];
    const double reach = wanted > wall ? std::min(wanted, there) : wanted;
    if (!(reach > skin) || !(size[axis] > 0.0)) continue;
    if (reach <= wall && !opens(side, reach, lines, originWorld, worldFromBox, low, high)) continue;
    (upper ? open.high : open.low)[axis] = reach;
  }
  const double shortest = std::min({size.x, size.y, size.z});
  for (int axis = 0; axis < 3; ++axis) {
    const double both = open.low[axis] + open.high[axis];
    const double most = std::max(kLongest * shortest - size[axis], (kLonger - 1.0) * size[axis]);
    if (!(both > most)) continue;
    open.low[axis] *= most / both;
    open.high[axis] *= most / both;
  }
  return open;
}

}  // namespace boxprobe
