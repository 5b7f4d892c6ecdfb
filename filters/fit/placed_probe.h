// A placed probe with the reason for it.
#pragma once

#include "filters/fit/box/fit_box.h"

namespace boxprobe {

struct PlacedProbe {
  Probe probe;
  std::size_t room = 0;
  bool part = false;         ///< covers a part of its room instead of all of it
  double gainDegrees = 0.0;  ///< reduction of the room's mean error when it was chosen
  BoxFit fit;
};

}  // namespace boxprobe
