// The numbers of a drag as text for people, to be shown beside the pointer.
#pragma once

#include <functional>
#include <string>

#include "filters/core/scene/scene.h"
#include "filters/vtk/widgets/drag_snap.h"
#include "filters/vtk/widgets/handle.h"

namespace boxprobe {

struct ReadoutStyle {
  std::string unit;  ///< of lengths: "m"; empty: none is said
  /// Another language's form of an English one, whose %1, %2, ... stand for numbers, names and, last, the unit; null:
  /// English.
  std::function<std::string(const char*)> words;
};

/// UTF-8, one or two lines. Of a drag of `handle` that has made `now` of `before`.
std::string handleReadout(const Handle& handle, const Probe& before, const Probe& now, const ReadoutStyle& style);
/// "on the wall ahead", "grid 0.1 m"
std::string snapReadout(const DragSnap& snap, const Handle& handle, const ReadoutStyle& style);

}  // namespace boxprobe
