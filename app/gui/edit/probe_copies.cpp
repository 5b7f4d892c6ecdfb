// See probe_copies.h.
#include "app/gui/edit/probe_copies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filters/core/geometry/probe_frame.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/vtk/widgets/handle_drag.h"

namespace boxprobe {

ProbeCopies::ProbeCopies(const Scene& scene) : names_(scene) {
  for (const Probe& probe : scene.probes) taken_.insert(placeOf(probe));
}

ProbeCopies::Place ProbeCopies::placeOf(const Probe& probe) {
  const Box& box = probe.box;
  const glm::dvec3 &origin = probe.origin, &turn = probe.rotationDegrees;
  Place place = {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z,
                 origin.x,  origin.y,  origin.z,  turn.x,    turn.y,    turn.z};
  // A copy of a copy gets to a place by other sums than a copy of the original.
  constexpr double kGrid = 1e-9;
  for (double& value : place) value = std::nearbyint(value / kGrid) * kGrid;
  return place;
}

Probe ProbeCopies::add(Probe probe) {
  constexpr double kShare = 0.1;
  const Place given = placeOf(probe);
  const auto before = last_.find(given);
  Probe moved = before == last_.end() ? probe : before->second;
  const glm::dvec3 step =
      rotationMatrix(probe.rotationDegrees)[0] * (kShare * std::max(probe.box.size().x, kMinimumThickness));
  // Ends: each step reaches another place, unless the step is lost in rounding.
  for (Place at = placeOf(moved); !taken_.insert(at).second;) {
    moved = movedProbe(moved, step);
    const Place next = placeOf(moved);
    if (next == at) break;
    at = next;
  }
  // What was copied before from this place may have had another influence.
  probe.influence = movedProbe(probe, moved.origin - probe.origin).influence;
  probe.box = moved.box;
  probe.origin = moved.origin;
  last_.insert_or_assign(given, std::move(moved));
  probe.name = names_.take(probe.name);
  return probe;
}

}  // namespace boxprobe
