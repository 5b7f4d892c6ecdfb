// What a probe lets through, as a cubemap whose levels are plain means, made from the coverage it was captured with
// when a draw first asks for a light's shadow. Called by the probe pass, with the window's context current; knows no
// scene.
#pragma once

#include <memory>

#include "filters/math/cube/cube_map.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

class CoverageTexture {
 public:
  /// Reads level 0 of `radiance` back once. `tint`: colour of the glass in each direction, null where there is none;
  /// `openIfWhole`: a picture that covers everything says nothing about openings.
  void make(const CubeTexture& radiance, const CubeMap* tint, bool openIfWhole);
  bool made() const { return chain_ != nullptr; }
  GLuint handle() const { return texture_.handle(); }
  /// What the texture holds.
  const std::shared_ptr<const CubeMap>& chain() const { return chain_; }
  std::size_t bytes() const { return texture_.bytes(); }

 private:
  CubeTexture texture_;
  std::shared_ptr<const CubeMap> chain_;
};

}  // namespace boxprobe
