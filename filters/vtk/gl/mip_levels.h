// Mip levels of 8-bit colour textures, drawn by a program of our own. Mesa's software drivers make them by a program of
// theirs, which no cache keeps: compiling it anew took a tenth of a start. Ours gives the same texels
// (tests/image/mip_levels_test) and comes from Mesa's cache. Used by the textures of surfaces; needs a current context.
#pragma once

#include "filters/vtk/gl/framebuffer.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

class MipLevels {
 public:
  MipLevels() = default;
  ~MipLevels() { release(); }
  MipLevels(const MipLevels&) = delete;
  MipLevels& operator=(const MipLevels&) = delete;

  /// Levels 1 and up of the texture that is bound to GL_TEXTURE_2D of the active unit, RGBA8 or SRGB8_ALPHA8 of that
  /// size. Sets its filters and wrap modes; everything else is left as it was. By glGenerateMipmap where a graphics
  /// card draws or a program cannot be had.
  void make(GLuint texture, GLenum internalFormat, int width, int height);
  void release();

 private:
  bool ready();

  GLuint program_ = 0, vertexArray_ = 0;
  GLint source_ = -1;
  bool tried_ = false;
  Framebuffer framebuffer_;
};

}  // namespace boxprobe
