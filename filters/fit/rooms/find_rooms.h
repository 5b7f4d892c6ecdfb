// The rooms of a model: free space, cut where it is narrow, put together again where the cut is no wall. Called by
// place_probes.
#pragma once

#include "filters/fit/rooms/free_space.h"

namespace boxprobe {

struct Room {
  std::vector<std::size_t> cells;               ///< of the free space
  std::vector<std::vector<std::size_t>> parts;  ///< between narrow places; one, or cells of this room
  Box extent;                                   ///< of the cells, along the grid's axes
  double volume = 0.0;                          ///< scene units cubed
  double roofed = 0.0;                          ///< share of the cells with a ceiling
};

/// A way from one room to another.
struct Doorway {
  std::size_t a = 0, b = 0;  ///< rooms
  double area = 0.0;         ///< scene units squared
  glm::dvec3 normal{0.0};    ///< unit, from a to b, along the grid's axes
};

struct Rooms {
  WalledRegion region;
  FreeSpace space;
  std::vector<Room> rooms;  ///< the largest first
  std::vector<Doorway> doorways;
  int hollows = 0;  ///< closed spaces too small for a room, left out
};

/// Bounds of cells along any axes, without the few that reach into door frames.
Box extentOf(const FreeSpace& space, const std::vector<std::size_t>& cells, const glm::dmat3& worldFromAxes);

struct RoomSettings {
  /// May back sides be the walls of rooms, as in a model with inverted faces? It is one where they close in more space
  /// than front sides do.
  bool inverted = false;
};

/// Watershed on the distance of the nearest surface; two basins are one room where the opening is more than a quarter
/// of the wall between them and no door: a door is small and stands under a lintel. No room is smaller than 0.45 times
/// the usual height cubed. No rooms where no surface stands upright. Nothing if `progress` stopped it. Deterministic.
std::optional<Rooms> findRooms(const SurfaceRays& rays, const RoomSettings& settings = {},
                               const std::function<bool(double)>& progress = {});

}  // namespace boxprobe
