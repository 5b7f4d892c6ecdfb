// Framebuffer objects, made and checked in one way: what is attached, in which order, and what to say if the driver
// refuses it. Also the textures and render buffers that are made to be attached. Used by everything that draws off the
// screen; every function needs the window's context current and leaves bindings as they were.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

/// One image of a framebuffer; without a handle there is none.
struct FramebufferImage {
  enum class Kind { Texture, RenderBuffer };
  GLuint handle = 0;
  Kind kind = Kind::Texture;
  GLenum target = GL_TEXTURE_2D;  ///< of a texture: a face of a cube map, too
  GLint level = 0;                ///< of a texture
};

class Framebuffer {
 public:
  /// What is thrown when the driver refuses, one line; `status` is what glCheckFramebufferStatus says.
  using Refusal = std::function<std::string(GLenum status)>;

  Framebuffer() = default;
  ~Framebuffer() { release(); }
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  /// Colours in their order, all of them drawn to, and depth, in place of what was attached before; makes the object if
  /// there is none. Throws WorkError if the driver refuses; the object is gone then.
  void attach(const std::vector<FramebufferImage>& colors, const FramebufferImage& depth, const Refusal& refusal);
  void release();

  bool made() const { return handle_ != 0; }
  GLuint handle() const { return handle_; }

 private:
  GLuint handle_ = 0;
  std::size_t colors_ = 0;
};

/// The usual refusal: names what the framebuffer is for, and the status.
Framebuffer::Refusal floatRefusal(const char* what);

/// RGBA32F colour (GL_RGBA) or 32-bit float depth (GL_DEPTH_COMPONENT) of one level, read texel by texel.
GLuint makeTargetTexture(int width, int height, GLenum internalFormat, GLenum format);

/// `samples` up to 1: one per pixel.
GLuint makeRenderBuffer(int width, int height, int samples, GLenum internalFormat);

inline FramebufferImage renderBufferImage(GLuint handle) {
  FramebufferImage image;
  image.handle = handle;
  image.kind = FramebufferImage::Kind::RenderBuffer;
  return image;
}

inline FramebufferImage textureImage(GLuint handle, GLenum target = GL_TEXTURE_2D, GLint level = 0) {
  FramebufferImage image;
  image.handle = handle;
  image.target = target;
  image.level = level;
  return image;
}

}  // namespace boxprobe
