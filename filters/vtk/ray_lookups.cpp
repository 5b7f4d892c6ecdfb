// See ray_lookups.h.
#include "filters/vtk/ray_lookups.h"

#include <cmath>

namespace boxprobe {

namespace {

// A map that holds nothing but notes what it is asked for.
class Recorder : public shading::CubeSampler {
 public:
  glm::vec4 fetch(const glm::vec3& direction, float level) const override {
    lookups.push_back({direction, level, 0.0f});
    return glm::vec4(0.0f);
  }
  mutable std::vector<RayLookup> lookups;
};

// A map that answers 1 to one fetch and 0 to all others: a technique's value is linear in what it fetches, so what
// comes out is that fetch's share.
class OneFetch : public shading::CubeSampler {
 public:
  explicit OneFetch(std::size_t which) : which_(which) {}
  glm::vec4 fetch(const glm::vec3&, float) const override { return glm::vec4(count_++ == which_ ? 1.0f : 0.0f); }

 private:
  std::size_t which_;
  mutable std::size_t count_ = 0;
};

bool finite(const RayLookup& l) {
  return std::isfinite(l.direction.x) && std::isfinite(l.direction.y) && std::isfinite(l.direction.z) &&
         std::isfinite(l.level) && std::isfinite(l.share);
}

}  // namespace

std::vector<RayLookup> recordLookups(const EvaluationRow& technique, const shading::ProbeShape& shape,
                                     const shading::ShadingPoint& point) {
  const Recorder recorder;
  technique.evaluate(&recorder, shape, point);
  std::vector<RayLookup> lookups;
  for (std::size_t i = 0; i < recorder.lookups.size(); ++i) {
    RayLookup lookup = recorder.lookups[i];
    const OneFetch one(i);
    lookup.share = technique.evaluate(&one, shape, point).x;
    if (finite(lookup)) lookups.push_back(lookup);
  }
  return lookups;
}

}  // namespace boxprobe
