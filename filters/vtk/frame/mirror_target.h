// The render target of a planar mirror's picture: half-float colour and height with several samples per texel, resolved
// to textures with mip levels. Every function needs the window's context current.
#pragma once

#include <array>
#include <memory>

#include "filters/math/shared/mirror_math.h"
#include "filters/vtk/gl/framebuffer.h"
#include "filters/vtk/gl/opengl.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

class MirrorTarget {
 public:
  MirrorTarget() = default;
  ~MirrorTarget() { release(); }
  MirrorTarget(const MirrorTarget&) = delete;
  MirrorTarget& operator=(const MirrorTarget&) = delete;

  /// `wantedSamples`: 1 or several, fewer if the driver has no more; `mips`: a whole chain, or only the finest level.
  /// Does nothing if all values are unchanged. Throws WorkError if the driver refuses.
  void allocate(int width, int height, int wantedSamples, bool mips);
  void release();

  /// Clears to transparent black at the far plane.
  void clear(vtkOpenGLRenderWindow* window);
  /// Draws go to depth only, or also to colour and height.
  void drawColors(vtkOpenGLRenderWindow* window, bool colors);
  GLuint framebuffer() const { return (samples_ > 1 ? sampled_ : resolved_).handle(); }
  /// Resolves the samples into the textures, and makes all levels.
  void finish(vtkOpenGLRenderWindow* window);

  GLuint color() const { return textures_[0]; }
  GLuint height() const { return textures_[1]; }
  int width() const { return width_; }
  int rows() const { return rows_; }
  int levels() const { return levels_; }
  std::size_t bytes() const;
  std::shared_ptr<const MirrorTexels> readBack() const;

 private:
  int width_ = 0, rows_ = 0, samples_ = 0, levels_ = 0;
  std::array<GLuint, 2> textures_{}, buffers_{};
  Framebuffer resolved_, sampled_;
  GLuint depth_ = 0, sampledDepth_ = 0;
};

}  // namespace boxprobe
