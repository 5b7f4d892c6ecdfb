// The state of a probe's maps, for the window's list and panels.
#pragma once

#include <cstddef>
#include <string>

namespace boxprobe {

/// The state of a probe's maps.
enum class BakeState {
  NotUsed,    ///< no visible object is in its influence: nothing is made for it
  Stale,      ///< an input has changed, or nothing has been made: work is pending
  Capturing,  ///< in progress
  UpToDate,
  FromFile,  ///< up to date, from a baked file
};

/// What is being made now, for those who wait.
struct WorkNow {
  enum class What {
    Nothing,
    Shadows,  ///< of lamps: rays, before anything is captured
    Coarse,   ///< a probe in few texels, to be seen until it is captured
    Capture,  ///< a bounce of a probe, or its further work
    Rest,     ///< programs, levels, what is traced of the whole scene
  } what = What::Nothing;
  std::string probe;            ///< of Coarse and Capture; empty: the sky
  int bounce = 0, bounces = 0;  ///< of Capture: the one that is made, and how many there will be
  std::size_t missing = 0;      ///< probes in use that do not show their own maps yet
  std::size_t used = 0;         ///< probes in use
};

}  // namespace boxprobe
