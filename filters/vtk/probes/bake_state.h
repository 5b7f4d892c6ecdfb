// How far a probe's maps are: answered by the probe set, shown by the window's list and panels.
#pragma once

namespace boxprobe {

/// How far a probe's maps are.
enum class BakeState {
  NotUsed,    ///< no visible object lies in its influence: nothing is made for it
  Stale,      ///< an input changed, or nothing was made yet: work is pending
  Capturing,  ///< being made now
  UpToDate,
  FromFile,  ///< up to date, from a baked file
};

}  // namespace boxprobe
