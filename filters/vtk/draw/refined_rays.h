// The rays of a refined picture.
#pragma once

namespace boxprobe {

/// Rays per pixel in one frame, and in all averaged frames. 0: none.
struct RefinedRays {
  int aFrame = 0, inAll = 0;
  bool operator==(const RefinedRays& o) const { return aFrame == o.aFrame && inAll == o.inAll; }
};

}  // namespace boxprobe
