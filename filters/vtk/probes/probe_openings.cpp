// The probe set's openings: which probes let the sky show through, and its diffuse light that comes in by them. Worked
// out on the CPU from small levels whenever a probe's maps or the sky are others, so that another sky costs no capture.
// See probe_set.h.
#include "filters/math/cube/openings.h"
#include "filters/vtk/maps/cube_transfer.h"
#include "filters/vtk/probes/probe_set.h"

namespace boxprobe {

namespace {

CubeMap level0(const ProbeMaps& maps) {
  CubeMap cube(maps.radiance.faceSize(), 1);
  readLevel0(maps.radiance, cube);
  return cube;
}

const Openings& openingsOf(const ProbeMaps& maps) {
  if (!maps.openings) {
    const CubeMap captured = level0(maps);
    maps.openings = std::make_shared<const Openings>(Openings{reducedCube(captured), anyOpening(captured)});
  }
  return *maps.openings;
}

}  // namespace

bool ProbeSet::updateOpenings() {
  bool changed = false;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    DrawnProbe& drawn = *entries_[i].drawn;
    const bool asked = std::holds_alternative<ClearToOpen>(probe(i).clear);
    const bool open = asked && drawn.maps && openingsOf(*drawn.maps).any;
    changed |= drawn.open != open;
    drawn.open = open;
    if (!open || !state_->resources.sky) continue;
    const auto of = std::make_pair(drawn.maps, state_->resources.sky);
    if (entries_[i].openSkyOf == of) continue;
    entries_[i].openSkyOf = of;
    drawn.openSky = skyThroughOpenings(openingsOf(*drawn.maps).reduced, rotationMatrix(drawn.maps->capturedRotation),
                                       openingsOf(*state_->resources.sky).reduced);
  }
  return changed;
}

void ProbeSet::showOpenings() {
  if (updateOpenings()) assignToObjects();
}

std::function<void(bool)> ProbeSet::withoutSky(std::function<void(bool)> drawing) {
  return [this, drawing = std::move(drawing)](bool begins) {
    if (begins) skyKept_ = state_->resources.sky;
    if (begins) state_->resources.sky = nullptr;
    if (drawing) drawing(begins);
    if (!begins) state_->resources.sky = std::move(skyKept_);
  };
}

}  // namespace boxprobe
