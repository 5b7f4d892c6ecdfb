// What can be taken hold of in the picture, and which of it is shown.
#pragma once

#include <cstddef>

#include "filters/core/geometry/probe_frame.h"

namespace boxprobe {

/// What the handles of the selected probe edit.
enum class HandleMode {
  Box,        ///< the faces of the projection box, and the capture origin
  Influence,  ///< the faces of the influence box, and of the box inside which the probe has its full weight
  Origin,     ///< the capture origin alone: freely, or along the world's axes
  Place,      ///< the probe as a whole: moved and turned along the axes of its box
};

enum class HandleKind {
  Face,        ///< of the projection box
  Origin,      ///< the capture origin; another probe's selects that
  Influence,   ///< a face of the influence box
  Blend,       ///< a face of the box of full weight
  OriginAxis,  ///< an arrow at the origin, along an axis of the world
  Move,        ///< an arrow at the box's centre, along an axis of the box: moves the whole probe
  Turn,        ///< a ring about such an axis: turns the whole probe
};

struct Handle {
  HandleKind kind = HandleKind::Origin;
  std::size_t probe = 0;
  BoxFace face = {};  ///< of arrows and rings the axis alone; of Origin nothing
  bool operator==(const Handle& o) const {
    return kind == o.kind && probe == o.probe && (kind == HandleKind::Origin || face == o.face);
  }
};

}  // namespace boxprobe
