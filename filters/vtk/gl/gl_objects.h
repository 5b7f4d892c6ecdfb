// OpenGL objects of captures and filters with RAII: cubemaps with mip levels, float targets. Every function needs the
// window's context current.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "filters/vtk/gl/framebuffer.h"
#include "filters/vtk/gl/opengl.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Enables filtering across cube edges. Returns an empty text, or why reflections would show seams.
std::string seamlessCubesProblem();

/// A cubemap in RGBA16F (colour), R32F (distance) or RGBA32F (relief) with its own mip levels.
class CubeTexture {
 public:
  CubeTexture() = default;
  ~CubeTexture() { release(); }
  CubeTexture(const CubeTexture&) = delete;
  CubeTexture& operator=(const CubeTexture&) = delete;

  /// Levels 0..levels-1, of `faceSize >> level` texels. Texels are undefined until written. Throws WorkError if the
  /// driver is out of memory.
  void allocate(int faceSize, int levels, GLenum internalFormat);
  void release();

  bool allocated() const { return handle_ != 0; }
  GLuint handle() const { return handle_; }
  int faceSize() const { return faceSize_; }
  int levels() const { return levels_; }
  std::size_t bytes() const;

  /// Texels of one face and level as RGBA float, rows along t.
  std::vector<float> readFace(int face, int level) const;
  /// The same into the caller's memory, 4 floats per texel.
  void readFace(int face, int level, float* rgba) const;
  void writeFace(int face, int level, const std::vector<float>& rgba);
  /// Writes RGBA half floats, one per texel of the level, bit for bit into an RGBA16F cube.
  void writeHalves(int face, int level, const std::uint16_t* rgba);

 private:
  GLuint handle_ = 0;
  GLenum internalFormat_ = 0;
  int faceSize_ = 0;
  int levels_ = 0;
};

/// A render target with RGBA32F colour and 32-bit float depth.
class FloatTarget {
 public:
  FloatTarget() = default;
  ~FloatTarget() { release(); }
  FloatTarget(const FloatTarget&) = delete;
  FloatTarget& operator=(const FloatTarget&) = delete;

  /// Does nothing if the size is unchanged. Throws WorkError if the driver refuses.
  void allocate(int width, int height);
  void release();
  GLuint framebuffer() const { return framebuffer_.handle(); }
  GLuint color() const { return color_; }
  GLuint depth() const { return depth_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  Framebuffer framebuffer_;
  GLuint color_ = 0, depth_ = 0;
  int width_ = 0, height_ = 0;
};

/// A framebuffer for faces and levels of cubemaps, attached in turn.
class CubeFramebuffer {
 public:
  /// Binds it with `color` (and `second` as attachment 1 if given), and sets the viewport to the level's size.
  void bind(vtkOpenGLRenderWindow* window, const CubeTexture& color, int face, int level,
            const CubeTexture* second = nullptr);
  /// Binds it for drawing with its current attachments: the target of a blit.
  void bindDraw(vtkOpenGLRenderWindow* window);
  void release() { framebuffer_.release(); }

 private:
  Framebuffer framebuffer_;
};

/// Saves and restores the state that a full-screen pass changes: framebuffer bindings, viewport, depth test, blending,
/// scissor. Also enables seamless cubemap filtering, which VTK enables only for its own image-based lighting.
class PassState {
 public:
  explicit PassState(vtkOpenGLRenderWindow* window);
  ~PassState();
  PassState(const PassState&) = delete;
  PassState& operator=(const PassState&) = delete;

 private:
  struct Saved;
  vtkOpenGLRenderWindow* window_;
  Saved* saved_;
};

/// A texture bound to a unit of VTK's own unit manager during the lifetime of this object.
class BoundTexture {
 public:
  BoundTexture(vtkOpenGLRenderWindow* window, GLenum target, GLuint handle);
  ~BoundTexture();
  BoundTexture(const BoundTexture&) = delete;
  BoundTexture& operator=(const BoundTexture&) = delete;
  int unit() const { return unit_; }

 private:
  vtkOpenGLRenderWindow* window_;
  GLenum target_;
  int unit_;
};

}  // namespace boxprobe
