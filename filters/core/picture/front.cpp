#include "filters/core/picture/front.h"

#include <algorithm>

namespace boxprobe {

void markFront(std::vector<FrontPoint>& points) {
  for (FrontPoint& point : points) {
    point.onFront = std::none_of(points.begin(), points.end(), [&](const FrontPoint& other) {
      return other.cost <= point.cost && other.error <= point.error &&
             (other.cost < point.cost || other.error < point.error);
    });
  }
}

}  // namespace boxprobe
