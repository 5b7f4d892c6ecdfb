// Textures that are derived from a probe's maps when a draw first needs them. Every function needs the window's context
// current.
#pragma once

#include <cstddef>
#include <memory>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/relief.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

/// Its transmittance as a cubemap whose levels are plain means, from the captured coverage, for lights' shadows.
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

/// Its light table (filters/math/cube/light_table.h), from the capture.
class LightTexture {
 public:
  LightTexture() = default;
  ~LightTexture() { release(); }
  LightTexture(const LightTexture&) = delete;
  LightTexture& operator=(const LightTexture&) = delete;

  /// Reads level 0 back once.
  void make(const CubeTexture& radiance);
  void release();
  /// RGBA32F, one row of cells per row; 0 if nothing is bright.
  GLuint handle() const { return handle_; }
  /// Cells along a face; 0: no table.
  int faceSize() const { return faceSize_; }
  std::size_t bytes() const;

 private:
  GLuint handle_ = 0;
  int faceSize_ = 0;
  bool made_ = false;
};

/// Its relief (filters/math/cube/relief.h), from the distances.
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
