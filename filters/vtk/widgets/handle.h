// Draggable handles in the picture.
#pragma once

#include <cstddef>

#include "filters/core/geometry/probe_frame.h"

namespace boxprobe {

/// What the handles of the selected probe edit.
enum class HandleMode {
  Box,        ///< the faces of the projection box, and the capture origin
  Influence,  ///< the faces of the influence box, and of the box of full weight
  Origin,     ///< only the capture origin: freely, or along the world's axes
  Place,      ///< the whole probe: moved and rotated along the axes of its box
};

enum class HandleKind {
  Face,        ///< of the projection box
  Origin,      ///< the capture origin; clicking another probe's selects that probe
  Influence,   ///< a face of the influence box
  Blend,       ///< a face of the box of full weight
  OriginAxis,  ///< an arrow at the origin, along a world axis
  Move,        ///< an arrow at the box's centre, along an axis of the box: moves the whole probe
  Turn,        ///< a ring around such an axis: rotates the whole probe
};

struct Handle {
  HandleKind kind = HandleKind::Origin;
  std::size_t probe = 0;
  BoxFace face = {};  ///< only the axis for arrows and rings; unused for Origin
  bool operator==(const Handle& o) const {
    return kind == o.kind && probe == o.probe && (kind == HandleKind::Origin || face == o.face);
  }
};

}  // namespace boxprobe
