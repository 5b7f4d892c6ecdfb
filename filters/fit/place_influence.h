// Which surfaces a placed probe lights: its room up to the walls, through door frames up to the next room; for a part
// of a room, with a soft edge.
#pragma once

#include <utility>
#include <vector>

#include "filters/fit/placed_probe.h"
#include "filters/fit/rooms/find_rooms.h"

namespace boxprobe {

/// Sets the rotation of `probe`, its box around some cells along these axes, and an influence box one cell larger.
void setBoxAbout(Probe& probe, const FreeSpace& space, const std::vector<std::size_t>& cells,
                 const glm::dvec3& rotationDegrees);

/// Moves the sides of a box in that reach from indoors outdoors, or the other way round. The influence, if it is
/// separate, is to be set afterwards.
void keepApart(const Rooms& rooms, std::size_t room, Probe& probe);

/// Influence boxes of the first probes of rooms, one per room. They end a little behind the walls that rays meet,
/// behind the window frames, panes and reveals that the room sees there (unless another room is behind the wall) or, at
/// a door to the next room, at that room's wall, so that the two probes blend within the door frame. What leads from
/// indoors outdoors is an end for boxes, too: see keepApart().
void setInfluences(const SurfaceRays& rays, const Rooms& rooms, std::vector<PlacedProbe>& probes);

/// The influence box of a probe for a part of a room: as that of the room's probe at the room's walls, elsewhere with a
/// soft edge. The probe gets a higher importance than the room's.
void setPartInfluence(const SurfaceRays& rays, const FreeSpace& space, const std::vector<std::size_t>& cells,
                      const Probe& ofRoom, Probe& ofPart);

/// How far a place is outside of a probe's influence box; 0 within it. Scene units.
double influenceDistance(const Probe& probe, const glm::dvec3& world);
/// Grows the influence so that the place and `skin` around it have the full weight: what stays on a side keeps its
/// blend distance, a side that moves gets one of `skin`.
void reachOver(Probe& probe, const glm::dvec3& world, double skin);
/// Of the influence boxes, along the axes of the first one: an upper bound if they are rotated against each other.
double sharedVolume(const Probe& a, const Probe& b);

/// Pairs of probes whose influence boxes overlap by more than a twentieth of the smaller one.
std::vector<std::pair<std::size_t, std::size_t>> overlaps(const std::vector<PlacedProbe>& probes);

}  // namespace boxprobe
