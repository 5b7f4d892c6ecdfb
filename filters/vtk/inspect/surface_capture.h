// Reads the surface at each pixel of a picture: draws it with the debug view's programs into a framebuffer with
// attachments for position, normal, material and colour. Draws only the requested part of the picture.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <vector>

#include "filters/explain/explanation.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/gl/framebuffer.h"
#include "filters/vtk/gl/opengl.h"

class vtkCamera;
class vtkLight;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;

namespace boxprobe {

/// A part of a picture of width x height pixels; x and y from the top left.
struct PixelRect {
  int x = 0, y = 0, width = 1, height = 1;
};

struct SurfacePixel {
  int object = 0;  ///< number of the pass; 0: background; -1: not a pass's number
  SurfacePoint point;
  glm::vec3 color{0.0f};              ///< linear, as drawn
  std::array<glm::vec4, 4> finish{};  ///< if requested: what gpu/surface_output.glsl writes of it; else 0
};

class SurfaceCapture {
 public:
  SurfaceCapture(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state);
  ~SurfaceCapture();
  SurfaceCapture(const SurfaceCapture&) = delete;
  SurfaceCapture& operator=(const SurfaceCapture&) = delete;

  /// Rows from the top of the picture down. The context must be current; `props` must draw with the debug program.
  /// `finish`: draws them a second time for finish properties.
  std::vector<SurfacePixel> capture(vtkCamera* camera, int width, int height, const PixelRect& rect,
                                    const std::vector<vtkProp*>& props, const std::vector<vtkLight*>& lights,
                                    bool finish = false);
  void release();

 private:
  static constexpr int kAttachments = 7;  ///< those of shaders/gpu/surface_output.glsl, and the colour
  using Values = std::array<std::vector<glm::vec4>, kAttachments>;
  void allocate(int width, int height);
  void draw(vtkCamera* camera, int height, const PixelRect& rect, bool finish);
  Values readBack(const PixelRect& rect);

  vtkOpenGLRenderWindow* window_;
  std::shared_ptr<DrawState> state_;
  vtkSmartPointer<vtkRenderer> renderer_;
  Framebuffer framebuffer_;
  GLuint depth_ = 0;
  std::array<GLuint, kAttachments> textures_{};
  int width_ = 0, height_ = 0;
};

}  // namespace boxprobe
