// Rays of a picture that goes on at rest, as every part of the drawing knows them. Plain data.
#pragma once

namespace boxprobe {

/// Rays a pixel: of a frame, and of all frames that are averaged. 0: none.
struct RefinedRays {
  int aFrame = 0, inAll = 0;
  bool operator==(const RefinedRays& o) const { return aFrame == o.aFrame && inAll == o.inAll; }
};

}  // namespace boxprobe
