#include "filters/core/picture/pareto_front.h"

#include <algorithm>

namespace boxprobe {

void markParetoFront(std::vector<ParetoPoint>& points) {
  for (ParetoPoint& point : points) {
    point.onParetoFront = std::none_of(points.begin(), points.end(), [&](const ParetoPoint& other) {
      return other.cost <= point.cost && other.error <= point.error &&
             (other.cost < point.cost || other.error < point.error);
    });
  }
}

}  // namespace boxprobe
