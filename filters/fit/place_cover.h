// No surface that people in the rooms see is left without a probe: influences grow over what lies behind walls and
// through doors, and what is outside of all rooms gets a probe of its own. Boxes stay as they are.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "filters/fit/placed_probe.h"
#include "filters/fit/rooms/find_rooms.h"

namespace boxprobe {

/// A place on a surface that is seen from within a room.
struct SeenPlace {
  glm::dvec3 positionWorld{0.0}, normalWorld{0.0};
  std::size_t room = 0;
};

/// What eyes all over the rooms see, alike for each room. Deterministic.
std::vector<SeenPlace> seenFromRooms(const SurfaceRays& rays, const Rooms& rooms);

/// The share of the places that no probe lights.
double bareShare(const std::vector<SeenPlace>& seen, const std::vector<Probe>& probes);

/// Grows the influences of rooms' first probes over bare places within a room's height of them. Where one then reaches
/// into another probe's influence, that one must come first: such pairs are appended to `above`, the second above the
/// first. `kept` are other probes of the scene.
void growOverSeen(const std::vector<SeenPlace>& seen, const std::vector<Probe>& kept, double height,
                  std::vector<PlacedProbe>& probes, std::vector<std::pair<std::size_t, std::size_t>>& above);

/// A probe for the places that are still bare, below all others: captured outside, where it sees the most of them; its
/// influence is all of the model. Nothing if there is no free place outside.
std::optional<PlacedProbe> surroundingsProbe(const SurfaceRays& rays, const Rooms& rooms,
                                             const std::vector<SeenPlace>& seen, const std::vector<Probe>& probes);

}  // namespace boxprobe
