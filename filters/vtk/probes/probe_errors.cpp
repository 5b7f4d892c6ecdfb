#include "filters/vtk/probes/probe_errors.h"

#include "filters/math/technique/technique_errors.h"
#include "filters/vtk/maps/cube_transfer.h"

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
bool ProbeErrors::stale(std::size_t index) const {
  const ProbeEntry& entry = (*entries_)[index];
  const DrawnProbe& drawn = shown_->drawn(index);
  const ProbeGeometry& geometry = drawn.geometry;
  if (!entry.used || !drawn.maps || !isAutomatic(geometry.technique)) return false;
  const bool realtime = entries_->probe(index).mode == ProbeMode::Realtime;
  if (!realtime && entry.shown != entry.wanted) return false;
  const MeasuredWith& measured = (*shown_)[index].measured;
  return !drawn.errors || measured.boxMin != geometry.boxMin || measured.boxMax != geometry.boxMax ||
         measured.mapFromProbe != geometry.mapFromProbe || (!realtime && measured.shown != entry.shown);
}

std::optional<std::size_t> ProbeErrors::next() const {
  for (std::size_t i = 0; i < entries_->size(); ++i) {
    if (stale(i)) return i;
  }
  return std::nullopt;
}

void ProbeErrors::measure(std::size_t index) {
  ShownProbe& probe = (*shown_)[index];
  const ProbeGeometry& geometry = probe.drawn->geometry;
  probe.measured = {(*entries_)[index].shown, geometry.boxMin, geometry.boxMax, geometry.mapFromProbe};
  const CubeMap chain = readRadiance(*probe.drawn->maps);
  const TurnedCube turned(chain, geometry.mapFromProbe);
  probe.drawn->errors = std::make_shared<const TechniqueErrors>(
      measureTechniqueErrors(turned, probeShape(geometry, chain.maxLevel(), 0.0f)));
  ++state_->counts.counters.errorsMeasured;
}

}  // namespace boxprobe
