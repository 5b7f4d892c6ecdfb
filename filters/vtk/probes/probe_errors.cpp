// The probe set's measurements: how wrong the techniques are that `auto` chooses from, with a probe's own final picture
// in its own box. Once after a bake and after a drag, never during one. See probe_set.h.
#include "filters/math/technique/technique_errors.h"
#include "filters/vtk/maps/cube_transfer.h"
#include "filters/vtk/probes/probe_set.h"

namespace boxprobe {

namespace {

/// Looked up in the probe's frame: a map keeps the axes it was captured with.
class TurnedCube : public shading::CubeSampler {
 public:
  TurnedCube(const CubeMap& map, const glm::dmat3& mapFromProbe) : map_(map), mapFromProbe_(mapFromProbe) {}
  glm::vec4 fetch(const glm::vec3& direction, float level) const override {
    return map_.fetch(mapFromProbe_ * direction, level);
  }

 private:
  const CubeMap& map_;
  glm::mat3 mapFromProbe_;
};

}  // namespace

// Asked between frames: compared, and nothing put together. What follows something that moves is measured once for each
// box.
bool ProbeSet::errorsStale(std::size_t index) const {
  const Entry& entry = entries_[index];
  const ProbeGeometry& geometry = entry.drawn->geometry;
  if (!entry.used || !entry.drawn->maps || !isAutomatic(geometry.technique)) return false;
  const bool realtime = probe(index).mode == ProbeMode::Realtime;
  if (!realtime && entry.shown != entry.wanted) return false;
  const Measured& measured = entry.measured;
  return !entry.drawn->errors || measured.boxMin != geometry.boxMin || measured.boxMax != geometry.boxMax ||
         measured.mapFromProbe != geometry.mapFromProbe || (!realtime && measured.shown != entry.shown);
}

std::optional<std::size_t> ProbeSet::toMeasure() const {
  if (interactive_ || moving_ || !enabled_) return std::nullopt;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (errorsStale(i)) return i;
  }
  return std::nullopt;
}

void ProbeSet::measureErrors(std::size_t index) {
  Entry& entry = entries_[index];
  const ProbeGeometry& geometry = entry.drawn->geometry;
  entry.measured = {entry.shown, geometry.boxMin, geometry.boxMax, geometry.mapFromProbe};
  const CubeMap chain = readRadiance(*entry.drawn->maps);
  const TurnedCube turned(chain, geometry.mapFromProbe);
  entry.drawn->errors = std::make_shared<const TechniqueErrors>(
      measureTechniqueErrors(turned, probeShape(geometry, chain.maxLevel(), 0.0f)));
  ++state_->counts.counters.errorsMeasured;
  assignToObjects();
}

}  // namespace boxprobe
