// Which surfaces a placed probe lights: its room up to the walls, through door frames up to the next room, a part of a
// room with a soft edge. Called by place_probes.
#pragma once

#include <utility>
#include <vector>

#include "filters/fit/placed_probe.h"
#include "filters/fit/rooms/find_rooms.h"

namespace boxprobe {

/// Gives `probe` the rotation, the box of some cells along its axes, and an influence that reaches a cell further.
void setBoxAbout(Probe& probe, const FreeSpace& space, const std::vector<std::size_t>& cells,
                 const glm::dvec3& rotationDegrees);

/// Influences of the first probes of rooms, one for each. They end a little behind the walls that rays meet; where a
/// door leads to the next room, at that room's wall, so that the two probes fade into each other within the door's
/// frame.
void setInfluences(const SurfaceRays& rays, const Rooms& rooms, std::vector<PlacedProbe>& probes);

/// Influence of a probe for a part of a room: as that of the room's probe where it reaches the room's walls, else with
/// a soft edge. It is more important than the room's.
void setPartInfluence(const SurfaceRays& rays, const FreeSpace& space, const std::vector<std::size_t>& cells,
                      const Probe& ofRoom, Probe& ofPart);

/// Pairs of probes whose influences overlap by more than a twentieth of the smaller one.
std::vector<std::pair<std::size_t, std::size_t>> overlaps(const std::vector<PlacedProbe>& probes);

}  // namespace boxprobe
