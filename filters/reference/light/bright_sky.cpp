#include "filters/reference/light/bright_sky.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace boxprobe {

glm::dvec3 BrightSky::towards(const glm::dvec2& u) const {
  double before = 0.0;
  std::size_t group = 0;
  while (group + 1 < directions_.groups() && before + directions_.share(group) <= u.x) {
    before += directions_.share(group++);
  }
  // The remainder of the first number selects the place in the group.
  const double share = directions_.share(group);
  const double within = share > 0.0 ? std::clamp((u.x - before) / share, 0.0, 1.0) : 0.5;
  return glm::normalize(directions_.sample(group, {within, u.y}));
}

double BrightSky::density(const glm::dvec3& direction) const {
  const BrightDirections::Place place = directions_.at(direction);
  return place.density > 0.0 ? directions_.share(place.group) * place.density : 0.0;
}

}  // namespace boxprobe
