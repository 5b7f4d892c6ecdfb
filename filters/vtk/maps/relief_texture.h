// A probe's relief (filters/math/cube/relief.h) as a texture, made from its distances when a draw first needs it. Needs
// the window's context current.
#pragma once

#include <memory>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/math/cube/relief.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

class ReliefTexture {
 public:
  /// The blocks in the probe's box. Distances are read back and the texture is made once; blocks are recomputed for
  /// another box, but not while one is `dragged`: then the previous ones are returned.
  std::shared_ptr<const ReliefBlocks> blocks(const CubeTexture& distance, const ProbeGeometry& probe, bool dragged);
  /// Makes the levels from 1 on (Relief::bounds) if they are missing; returns whether it did. To be called after
  /// blocks().
  bool makeLevels();
  /// RGBA32F, nearest texel and level; 0 before the first call of blocks().
  GLuint handle() const { return texture_.handle(); }
  std::size_t bytes() const { return texture_.bytes(); }

 private:
  void write(int levels);

  CubeTexture texture_;
  std::shared_ptr<const Relief> relief_;
  LazyRelief lazy_;
};

}  // namespace boxprobe
