// How far a picture that is a mean of frames has come. Plain values, read by the status line and by tools.
#pragma once

namespace boxprobe {

struct FrameCount {
  int averaged = 0;
  int wanted = 0;        ///< 0: the picture is no mean of frames
  bool refined = false;  ///< of rays that go on at rest, not of a technique's own frames
  bool more() const { return averaged < wanted; }
};

/// Frames a picture is averaged from on its own: until a pixel has had 4096 rays, but at least 16 frames, which show
/// that the pattern moves, and at most 1024, which end.
inline int framesWanted(int raysAFrame) {
  const int frames = (4096 + raysAFrame - 1) / raysAFrame;
  return frames < 16 ? 16 : frames > 1024 ? 1024 : frames;
}

}  // namespace boxprobe
