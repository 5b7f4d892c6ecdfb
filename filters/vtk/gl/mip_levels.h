// Makes mip levels of 8-bit colour textures by a program of our own. Mesa's software drivers use a program that no
// cache keeps: compiling it took a tenth of the start. Ours gives the same texels (tests/image/mip_levels_test) and is
// kept in Mesa's cache. Needs a current context.
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

  /// Makes levels 1 and up of the texture bound to GL_TEXTURE_2D of the active unit, RGBA8 or SRGB8_ALPHA8 of that
  /// size. Sets its filters and wrap modes; other state is preserved. Uses glGenerateMipmap on graphics cards, and
  /// where the program cannot be used or the driver draws wrongly.
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
