// A probe's relief (filters/math/cube/relief.h) as a texture, made from its distances when a draw first wants it.
// Called by the probe pass, with the window's context current; knows no scene.
#pragma once

#include <memory>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/math/cube/relief.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

class ReliefTexture {
 public:
  /// What stands in the probe's box; the distances are read back and the texture is made once, blocks again for another
  /// box, but not while one is `dragged`: they are then those of the box before.
  std::shared_ptr<const ReliefBlocks> blocks(const CubeTexture& distance, const ProbeGeometry& probe, bool dragged);
  /// The levels from 1 on (Relief::bounds), if they are not there. After blocks(); were they made?
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
