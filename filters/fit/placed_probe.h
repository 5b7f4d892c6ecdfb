// A probe that was placed, and why. Called by place_probes and what it is made of.
#pragma once

#include "filters/fit/box/fit_box.h"

namespace boxprobe {

struct PlacedProbe {
  Probe probe;
  std::size_t room = 0;
  bool part = false;         ///< of a part of its room; else of all of it
  double gainDegrees = 0.0;  ///< of the room's mean error, when it was chosen
  BoxFit fit;
};

}  // namespace boxprobe
