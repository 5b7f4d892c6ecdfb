// Names of rooms as people call them: from the names of the objects in them, else numbered.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "filters/fit/rays/triangle_rays.h"
#include "filters/fit/rooms/find_rooms.h"

namespace boxprobe {

/// "kitchen" for "Kitchen_Floor.001", "living room" for "LivingRoomSofa"; empty if a name says nothing of a room.
std::string roomNamedBy(const std::string& node);

/// For each room what most of the names of the objects in it say, or nothing. `models` in the order of scene.models.
std::vector<std::string> roomsNamedByObjects(const Scene& scene, const TriangleRays::Models& models,
                                             const Rooms& rooms);

/// The room of each cell of the free space; the number of rooms for cells in none.
std::vector<std::size_t> roomOfCells(const Rooms& rooms);
/// The cell at a place; nothing outside the grid.
std::optional<std::size_t> cellAt(const FreeSpace& space, const glm::dvec3& world);

/// Every room a name of its own: the given one, numbered where rooms share it, or "room 1", "room 2" without gaps.
/// Rooms with `probes` are numbered first.
std::vector<std::string> numberedRooms(const std::vector<std::string>& names, const std::vector<std::size_t>& probes);

}  // namespace boxprobe
