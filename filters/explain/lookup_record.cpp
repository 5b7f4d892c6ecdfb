#include "filters/explain/lookup_record.h"

#include <algorithm>

namespace boxprobe {

namespace {

class Recorder : public shading::CubeSampler {
 public:
  Recorder(const CubeMap* map, const ProbeGeometry* geometry) : map_(map), geometry_(geometry) {}

  glm::vec4 fetch(const glm::vec3& direction, float level) const override {
    Lookup lookup;
    lookup.direction = direction;
    lookup.level = level;
    glm::vec4 value(0.0f);
    if (map_ != nullptr) {
      const glm::vec3 inMap = geometry_->mapTurned ? glm::mat3(geometry_->mapFromProbe) * direction : direction;
      lookup.level = std::clamp(level, 0.0f, map_->maxLevel());
      lookup.roughness = shading::roughnessForLevel(lookup.level, map_->maxLevel());
      lookup.texels = map_->footprint(inMap, level);
      value = map_->fetch(inMap, level);
      lookup.value = glm::vec3(value);
      lookup.coverage = value.a;
    }
    lookups.push_back(std::move(lookup));
    return value;
  }

  mutable std::vector<Lookup> lookups;

 private:
  const CubeMap* map_;
  const ProbeGeometry* geometry_;
};

// Returns 1 in one channel for each of four lookups, 0 for all others.
class Impulse : public shading::CubeSampler {
 public:
  explicit Impulse(std::size_t first) : first_(first) {}
  glm::vec4 fetch(const glm::vec3&, float) const override {
    const std::size_t i = count_++;
    glm::vec4 value(0.0f);
    if (i >= first_ && i < first_ + 4) value[static_cast<int>(i - first_)] = 1.0f;
    return value;
  }

 private:
  std::size_t first_;
  mutable std::size_t count_ = 0;
};

RecordedLookups record(Evaluate evaluate, const CubeMap* map, const ProbeGeometry* geometry,
                       const shading::ProbeShape& shape, const shading::ShadingPoint& point) {
  const Recorder recorder(map, geometry);
  RecordedLookups result;
  result.value = evaluate(&recorder, shape, point);
  result.lookups = std::move(recorder.lookups);
  for (std::size_t first = 0; first < result.lookups.size(); first += 4) {
    const Impulse impulse(first);
    const glm::vec4 weights = evaluate(&impulse, shape, point);
    for (std::size_t i = first; i < std::min(first + 4, result.lookups.size()); ++i) {
      result.lookups[i].weight = weights[static_cast<int>(i - first)];
    }
  }
  return result;
}

}  // namespace

RecordedLookups recordLookups(Evaluate evaluate, const CubeMap& map, const ProbeGeometry& geometry,
                              const shading::ProbeShape& shape, const shading::ShadingPoint& point) {
  return record(evaluate, &map, &geometry, shape, point);
}

RecordedLookups recordLookups(Evaluate evaluate, const shading::ProbeShape& shape, const shading::ShadingPoint& point) {
  return record(evaluate, nullptr, nullptr, shape, point);
}

}  // namespace boxprobe
