#include "filters/core/geometry/lamp_reach.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace boxprobe {

bool seenWithin(const ProbeSight& sight, int channel, const std::array<double, 6>& boundsWorld) {
  if (channel == kSeenByNone) return false;
  const SightLattice& lattice = sight.lattice;
  if (channel < 0 || lattice.empty()) return true;
  constexpr double kOff = 0.36;  // of a surface that a place lies, in nodes: sightPlace, and rounding
  const glm::dmat3 boxFromWorld = glm::transpose(sight.worldFromBox);
  glm::dvec3 low(1.0e300), high(-1.0e300);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const glm::dvec3 world(boundsWorld[corner & 1], boundsWorld[2 + (corner >> 1 & 1)], boundsWorld[4 + (corner >> 2)]);
    const glm::dvec3 at = boxFromWorld * (world - sight.middleWorld);
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  glm::ivec3 first(0), last(0);
  for (int axis = 0; axis < 3; ++axis) {
    const int most = lattice.nodes[axis] - 1;
    const double perUnit = most / std::max(lattice.high[axis] - lattice.low[axis], 1.0e-300);
    const auto node = [&](double at) { return std::clamp((at - lattice.low[axis]) * perUnit, -2.0, most + 2.0); };
    first[axis] = std::clamp(static_cast<int>(std::floor(node(low[axis]) - kOff)), 0, most);
    last[axis] = std::clamp(static_cast<int>(std::ceil(node(high[axis]) + kOff)), 0, most);
  }
  const int part = channel / 4;
  for (int z = first.z; z <= last.z; ++z) {
    for (int y = first.y; y <= last.y; ++y) {
      const int row = ((part * lattice.nodes.z + z) * lattice.nodes.y + y) * lattice.nodes.x;
      for (int x = first.x; x <= last.x; ++x) {
        if (lattice.texels[static_cast<std::size_t>(4 * (row + x) + channel % 4)] != 0) return true;
      }
    }
  }
  return false;
}

bool LampReach::seen(const std::shared_ptr<const ProbeSight>& sight, int channel,
                     const std::array<double, 6>& boundsWorld) {
  if (!sight || channel == kSeenByAll) return true;
  constexpr std::size_t kMost = 8192;  // objects that move have other bounds in each frame
  if (known_.find(sight) == known_.end()) {
    for (auto entry = known_.begin(); entry != known_.end();) {
      entry = entry->first.expired() ? known_.erase(entry) : std::next(entry);
    }
  }
  Known& known = known_[sight];
  if (known.size() > kMost) known.clear();
  const auto [at, added] = known.try_emplace({channel, boundsWorld}, false);
  if (added) at->second = seenWithin(*sight, channel, boundsWorld);
  return at->second;
}

}  // namespace boxprobe
