// Framebuffer objects, created and checked in one place, with the textures and render buffers to attach. Every function
// needs the window's context current and preserves bindings.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

/// One image of a framebuffer; none without a handle.
struct FramebufferImage {
  enum class Kind { Texture, RenderBuffer };
  GLuint handle = 0;
  Kind kind = Kind::Texture;
  GLenum target = GL_TEXTURE_2D;  ///< of a texture; may be a face of a cubemap
  GLint level = 0;                ///< of a texture
};

class Framebuffer {
 public:
  /// The message to throw if the driver refuses, one line; `status` is from glCheckFramebufferStatus.
  using Refusal = std::function<std::string(GLenum status)>;

  Framebuffer() = default;
  ~Framebuffer() { release(); }
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  /// Attaches colours in order, all of them draw buffers, and depth, in place of earlier attachments; creates the
  /// object if necessary. Throws WorkError if the driver refuses, and deletes the object.
  void attach(const std::vector<FramebufferImage>& colors, const FramebufferImage& depth, const Refusal& refusal);
  void release();

  bool made() const { return handle_ != 0; }
  GLuint handle() const { return handle_; }

 private:
  GLuint handle_ = 0;
  std::size_t colors_ = 0;
};

/// The usual message: the framebuffer's purpose, and the status.
Framebuffer::Refusal floatRefusal(const char* what);

/// RGBA32F colour (GL_RGBA) or 32-bit float depth (GL_DEPTH_COMPONENT), one level, nearest sampling.
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
