// One frame in linear light: float colour, further attachments if asked for, and depth, drawn at one or several samples
// a pixel and resolved to textures. Called by vtkPicturePass; knows no scene. Every function needs the window's context
// current.
#pragma once

#include <array>

#include "filters/vtk/gl/framebuffer.h"
#include "filters/vtk/gl/opengl.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

class FrameTarget {
 public:
  /// Colour; and what a surface's reflection is apart from it: see shaders/gpu/reflection_apart.glsl.
  static constexpr int kMostAttachments = 4;

  FrameTarget() = default;
  ~FrameTarget() { release(); }
  FrameTarget(const FrameTarget&) = delete;
  FrameTarget& operator=(const FrameTarget&) = delete;

  /// `samples`: 0 or 1 for one per pixel; several for colour alone. Keeps what it has when nothing differs. Throws
  /// WorkError if the driver refuses.
  void allocate(int width, int height, int samples, int attachments);
  void release();

  /// What is drawn into.
  GLuint framebuffer() const { return (samples_ > 1 ? sampled_ : resolved_).handle(); }
  /// Draws go to colour alone, or to every attachment. The framebuffer must be bound.
  void drawTo(bool everyAttachment) const;
  /// Brings what was drawn into the textures.
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
