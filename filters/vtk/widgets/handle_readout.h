// The numbers of a drag as text beside the pointer.
#pragma once

#include <functional>
#include <string>

#include "filters/core/scene/scene.h"
#include "filters/vtk/widgets/drag_snap.h"
#include "filters/vtk/widgets/handle.h"

namespace boxprobe {

struct ReadoutStyle {
  std::string unit;  ///< of lengths: "m"; empty: none
  /// The translation of an English form, in which %1, %2, ... are numbers, names and, last, the unit; null: English.
  std::function<std::string(const char*)> words;
};

/// UTF-8, one or two lines, for a drag of `handle` that has changed `before` to `now`.
std::string handleReadout(const Handle& handle, const Probe& before, const Probe& now, const ReadoutStyle& style);
/// "on the wall ahead", "grid 0.1 m"
std::string snapReadout(const DragSnap& snap, const Handle& handle, const ReadoutStyle& style);

}  // namespace boxprobe
