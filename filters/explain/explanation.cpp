#include "filters/explain/explanation.h"

namespace boxprobe {

LitPoint litPoint(const Explanation& e) {
  LitPoint point;
  point.x = e.x;
  point.y = e.y;
  point.hit = e.hit;
  point.surface = e.surface;
  point.direct = e.direct;
  point.emissive = e.emissive;
  point.diffuse = e.diffuse + e.sheen;
  point.color = e.color;
  point.nDotV = e.nDotV;
  point.skyWeight = e.skyWeight;
  point.probes.assign(e.probes.begin(), e.probes.end());
  return point;
}

}  // namespace boxprobe
