// A scene's lattice of how much of the sky is open (filters/core/geometry/sky_openness.h) as a three-dimensional
// texture. Filled when a draw first asks, with the window's context current.
#pragma once

#include <memory>

#include "filters/core/geometry/sky_openness.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

class OpennessTexture {
 public:
  OpennessTexture() = default;
  ~OpennessTexture() { release(); }
  OpennessTexture(const OpennessTexture&) = delete;
  OpennessTexture& operator=(const OpennessTexture&) = delete;

  /// RGBA, a byte each, linear; never 0. Null: one texel that nobody should read.
  GLuint handle(const std::shared_ptr<const SkyOpenness>& open);
  void release();

 private:
  GLuint handle_ = 0;
  GLuint none_ = 0;  ///< while nothing is traced, and for captures
  std::shared_ptr<const SkyOpenness> of_;
};

}  // namespace boxprobe
