// Plan and sections of a room with boxes in them, to see why a fit failed. Called by fit_rooms.
#pragma once

#include <array>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "tests/support/random_room.h"

namespace boxprobe::bench {

struct DrawnBox {
  Probe probe;  ///< its box, as it is turned
  std::array<std::uint8_t, 3> color{};
};

/// From above, cut at the origin's height (dark) and at 40 cm (grey), and two sections through the origin: along x at
/// the right, along z below. A disc at the probe's origin, a tick for each camera. One scale for all, the longest side
/// of the first box and half as much more. At least one box.
ImageRgba8 roomPlan(const test::RandomRoom& room, const std::vector<DrawnBox>& boxes);

}  // namespace boxprobe::bench
