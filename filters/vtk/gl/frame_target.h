// A frame in linear light: float colour, optional further attachments, and depth, drawn with one or several samples per
// pixel and resolved to textures. Every function needs the window's context current.
#pragma once

#include <array>

#include "filters/vtk/gl/framebuffer.h"
#include "filters/vtk/gl/opengl.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

class FrameTarget {
 public:
  /// Colour, and a surface's reflection in separate attachments: see shaders/gpu/reflection_apart.glsl.
  static constexpr int kMostAttachments = 4;

  FrameTarget() = default;
  ~FrameTarget() { release(); }
  FrameTarget(const FrameTarget&) = delete;
  FrameTarget& operator=(const FrameTarget&) = delete;

  /// `samples`: 0 or 1 for one per pixel; several for colour alone. Does nothing if all values are unchanged. Throws
  /// WorkError if the driver refuses.
  void allocate(int width, int height, int samples, int attachments);
  void release();

  /// The framebuffer to draw to.
  GLuint framebuffer() const { return (samples_ > 1 ? sampled_ : resolved_).handle(); }
  /// Draws to colour alone, or to every attachment. The framebuffer must be bound.
  void drawTo(bool everyAttachment) const;
  /// Resolves the samples into the textures.
  void resolve(vtkOpenGLRenderWindow* window) const;

  GLuint texture(int attachment) const { return textures_[static_cast<std::size_t>(attachment)]; }
  GLuint depth() const { return depth_; }
  int width() const { return width_; }
  int height() const { return height_; }
  int attachments() const { return attachments_; }

 private:
  int width_ = 0, height_ = 0, samples_ = 0, attachments_ = 0;
  Framebuffer resolved_, sampled_;
  GLuint depth_ = 0;
  std::array<GLuint, kMostAttachments> textures_{};
  GLuint sampledColor_ = 0, sampledDepth_ = 0;  // several samples per pixel: render buffers
};

}  // namespace boxprobe
