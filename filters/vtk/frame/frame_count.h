// The progress of an averaged picture.
#pragma once

namespace boxprobe {

struct FrameCount {
  int averaged = 0;
  int wanted = 0;        ///< 0: the picture is not averaged
  bool refined = false;  ///< refined by rays at rest, instead of a technique's own frames
  bool more() const { return averaged < wanted; }
};

/// Frames of an averaged picture by default: until a pixel has had 4096 rays, but at least 16 frames, which show that
/// the pattern moves, and at most 1024.
inline int framesWanted(int raysAFrame) {
  const int frames = (4096 + raysAFrame - 1) / raysAFrame;
  return frames < 16 ? 16 : frames > 1024 ? 1024 : frames;
}

}  // namespace boxprobe
