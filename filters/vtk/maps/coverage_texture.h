// A probe's transmittance as a cubemap whose levels are plain means, made from its captured coverage when a draw first
// needs a light's shadow. Needs the window's context current.
#pragma once

#include <memory>

#include "filters/math/cube/cube_map.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

class CoverageTexture {
 public:
  /// Reads back level 0 of `radiance` once. `tint`: colour of the glass by direction, null without glass;
  /// `openIfWhole`: a picture that covers everything tells nothing of openings.
  void make(const CubeTexture& radiance, const CubeMap* tint, bool openIfWhole);
  bool made() const { return chain_ != nullptr; }
  GLuint handle() const { return texture_.handle(); }
  /// The contents of the texture.
  const std::shared_ptr<const CubeMap>& chain() const { return chain_; }
  std::size_t bytes() const { return texture_.bytes(); }

 private:
  CubeTexture texture_;
  std::shared_ptr<const CubeMap> chain_;
};

}  // namespace boxprobe
