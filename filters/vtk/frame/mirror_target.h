// What a planar mirror's picture is drawn into: half-float colour and height, four samples per texel resolved, with mip
// levels. Called by the mirrors' painter; knows no scene. Every function needs the window's context current.
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

  /// `samples`: 1 or several; `mips`: a whole chain, or the finest level alone. Keeps what it has when nothing differs.
  /// Throws WorkError if the driver refuses.
  void allocate(int width, int height, int samples, bool mips);
  void release();

  /// Transparent black, nothing near.
  void clear(vtkOpenGLRenderWindow* window);
  /// Draws go to depth alone, or to colour and height as well.
  void drawColors(vtkOpenGLRenderWindow* window, bool colors);
  GLuint framebuffer() const { return (samples_ > 1 ? sampled_ : resolved_).handle(); }
  /// Brings what was drawn into the textures, all levels.
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
