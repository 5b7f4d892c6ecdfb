// Finds the rooms of a model: divides the free space where it is narrow, and merges again where the boundary is not a
// wall.
#pragma once

#include "filters/fit/rooms/free_space.h"

namespace boxprobe {

struct Room {
  std::vector<std::size_t> cells;               ///< of the free space
  std::vector<std::vector<std::size_t>> parts;  ///< between narrow places; one part has all cells of the room
  Box extent;                                   ///< of the cells, along the grid's axes
  double volume = 0.0;                          ///< scene units cubed
  double roofed = 0.0;                          ///< share of the cells with a ceiling
  bool outdoors = false;                        ///< a court or garden: as FreeSpace::outdoors() of each of its cells
};

/// A passage between two rooms.
struct Doorway {
  std::size_t a = 0, b = 0;  ///< rooms
  double area = 0.0;         ///< scene units squared
  glm::dvec3 normal{0.0};    ///< unit, from a to b, along the grid's axes
};

struct Rooms {
  WalledRegion region;
  FreeSpace space;
  std::vector<Room> rooms;  ///< in order of decreasing size
  std::vector<Doorway> doorways;
  int hollows = 0;  ///< closed spaces too small for a room
};

/// Bounds of cells along any axes, without the few that reach into door frames.
Box extentOf(const FreeSpace& space, const std::vector<std::size_t>& cells, const glm::dmat3& worldFromAxes);

struct RoomSettings {
  /// Allow back faces as walls, as in a model with inverted faces? It counts as such if they enclose more space than
  /// front faces do.
  bool inverted = false;
};

/// Watershed on the distance to the nearest surface. Two basins form one room if the opening is more than a quarter of
/// the wall between them and is not a door: doors are small and below a lintel. Rooms are at least 0.45 times the usual
/// height, cubed. What is outdoors is never one room with what is indoors. No rooms without upright surfaces. Nothing
/// if `progress` stopped it. Deterministic.
std::optional<Rooms> findRooms(const SurfaceRays& rays, const RoomSettings& settings = {},
                               const std::function<bool(double)>& progress = {});

}  // namespace boxprobe
