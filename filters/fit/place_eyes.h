// Where people stand in a room, and where they look: the eyes by which its pictures are judged.
#pragma once

#include <vector>

#include "filters/fit/rooms/find_rooms.h"

namespace boxprobe {

/// At most twelve, far from each other, 1.2 to 1.8 m above the floor (in units of another size at a like share of the
/// height). The first looks along the longest view, others elsewhere. Deterministic; none if nobody can stand there.
std::vector<Camera> eyesIn(const SurfaceRays& rays, const Rooms& rooms, const Room& room);

}  // namespace boxprobe
