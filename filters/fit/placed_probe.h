// A placed probe with the reason for it.
#pragma once

#include <cstddef>

#include "filters/core/base/phrase.h"
#include "filters/fit/box/fit_box.h"

namespace boxprobe {

struct PlacedProbe {
  Probe probe;
  std::size_t room = 0;
  bool part = false;         ///< covers a part of its room instead of all of it
  double gainDegrees = 0.0;  ///< reduction of the room's mean error when it was chosen
  BoxFit fit;
  Phrase reason = {};         ///< why it is there and what it gains; a sentence without a full stop
  bool surroundings = false;  ///< for what is seen outside of all rooms; `room` is one that sees much of it
};

}  // namespace boxprobe
