// Probes for a whole model: its rooms, a fitted box for each, and more probes in a room as long as they gain. Called by
// `boxprobe place` and by the window, in a thread of its own.
#pragma once

#include <string>
#include <vector>

#include "filters/fit/lit_errors.h"
#include "filters/fit/placed_probe.h"
#include "filters/fit/rooms/find_rooms.h"

namespace boxprobe {

struct PlaceSettings {
  std::size_t most = 64;    ///< probes, those that are kept included
  double leastGain = 0.02;  ///< of a further probe in a room, of what its probes gain in all
  bool keep = false;        ///< the scene's probes stay, and rooms that hold one get no other
  bool inverted = false;    ///< back sides may be walls, even where no camera stands among them
  int rays = 4096;          ///< of each fit
};

/// A room as the report has it.
struct PlacedRoom {
  Box extent;  ///< of its free space, along axes turned by `yawDegrees` about the world's +y axis
  double yawDegrees = 0.0;
  glm::dvec3 middleWorld{0.0};
  double volume = 0.0;
  std::vector<Doorway> doorways;       ///< `a` is this room
  bool reflects = true;                ///< else it has no ceiling and only rough surfaces, and counts for nothing
  std::size_t parts = 1;               ///< between narrow places
  LitErrors before, after;             ///< with the scene's own probes; with the probes placed
  std::vector<std::string> decisions;  ///< sentences without a full stop: every probe that was tried, and why not
};

struct Placement {
  std::vector<PlacedRoom> rooms;    ///< the largest first
  std::vector<PlacedProbe> probes;  ///< in the order of the rooms
  std::vector<Probe> kept;          ///< of the scene; without a room all of them
  LitErrors before, after;          ///< of all rooms, by volume
  std::vector<std::string> remarks;
  double cell = 0.0;  ///< size of a cell of the free space, scene units
  std::size_t cells = 0;
  double roomSeconds = 0.0, seconds = 0.0;

  /// The kept ones and those placed.
  std::vector<Probe> all() const;
};

/// Judged by people who stand in the rooms, not by the scene's cameras. Deterministic. Nothing, if `progress` stopped
/// it. Throws WorkError where the ray tracer cannot take the models.
std::optional<Placement> placeProbes(const Scene& scene, const TriangleRays::Models& models,
                                     const PlaceSettings& settings = {}, const FitProgress& progress = {});

}  // namespace boxprobe
