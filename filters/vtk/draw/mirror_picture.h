// The picture of a planar mirror for the draw of that mirror: set by the mirror set for each frame, read by probe
// passes and explanations.
#pragma once

#include <memory>

#include "filters/math/shared/mirror_math.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

struct MirrorPicture {
  /// Is there a picture for the current draw? False between frames, so that captures never show one.
  bool shown = false;
  GLuint color = 0, height = 0;                ///< 2D textures
  shading::MirrorLook look{};                  ///< relative to the eye of the current draw; `picture` is null
  std::shared_ptr<const MirrorTexels> texels;  ///< read back for explanations; null unless requested
};

}  // namespace boxprobe
