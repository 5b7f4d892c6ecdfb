// Lamps that cannot light an object, because none of it sees them: left out of its draws.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <utility>

#include "filters/core/geometry/lamp_sight.h"

namespace boxprobe {

/// Does a surface somewhere in the bounds, world, in VTK's order, find anything in that channel of the sight? Exact for
/// bounds along the axes: the nodes that shading::sightPlace may reach from there.
bool seenWithin(const ProbeSight& sight, int channel, const std::array<double, 6>& boundsWorld);

/// The same, each worked out once: again for another sight or other bounds.
class LampReach {
 public:
  bool seen(const std::shared_ptr<const ProbeSight>& sight, int channel, const std::array<double, 6>& boundsWorld);

 private:
  using Known = std::map<std::pair<int, std::array<double, 6>>, bool>;
  std::map<std::weak_ptr<const ProbeSight>, Known, std::owner_less<>> known_;
};

}  // namespace boxprobe
