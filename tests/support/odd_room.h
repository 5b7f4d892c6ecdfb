// A room in which no two numbers are the same: sides, colours, roughnesses, lights, probes, influences, blend
// distances. What takes one for another gives another picture. Made here and not read from a file.
#pragma once

#include <memory>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe::test {

struct OddRoom {
  Scene scene;
  std::shared_ptr<const Model> model;
};

/// Six walls of a material each ("west", "east", "floor", "ceiling", "north", "south"), a painted pillar ("paint", with
/// a coat), a block of glass ("glass") and a block that moves ("mover"). Probes "a" and "b", which overlap over the
/// floor, and "c", turned, over both; six blend distances each. Three lights, one of each type.
OddRoom oddRoom();

}  // namespace boxprobe::test
