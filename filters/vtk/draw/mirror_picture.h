// What the draw of a mirror is told of its picture: filled by the mirror set for each frame, read by the probe passes
// that draw the mirror and by explanations. Plain data.
#pragma once

#include <memory>

#include "filters/math/shared/mirror_math.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

struct MirrorPicture {
  /// A picture was drawn for what is being drawn now. False between frames, so that captures never see one.
  bool shown = false;
  GLuint color = 0, height = 0;                ///< 2D textures
  shading::MirrorLook look{};                  ///< relative to the eye of what is being drawn now; `picture` is null
  std::shared_ptr<const MirrorTexels> texels;  ///< read back for explanations; null unless asked for
};

}  // namespace boxprobe
