// The state of a probe's maps, for the window's list and panels.
#pragma once

namespace boxprobe {

/// The state of a probe's maps.
enum class BakeState {
  NotUsed,    ///< no visible object is in its influence: nothing is made for it
  Stale,      ///< an input has changed, or nothing has been made: work is pending
  Capturing,  ///< in progress
  UpToDate,
  FromFile,  ///< up to date, from a baked file
};

}  // namespace boxprobe
