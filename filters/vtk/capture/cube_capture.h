// Captures a scene from one point, a face at a time, into RGBA float at several samples per texel; resolves to
// half-float radiance with coverage in alpha, and to distance. Not to be called during a render of the window.
#pragma once

#include <vtkSmartPointer.h>

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/gl/full_screen_pass.h"

class vtkCamera;
class vtkLight;
class vtkOpenGLRenderWindow;
class vtkPicturePass;
class vtkProp;
class vtkRenderer;
class vtkTargetPass;

namespace boxprobe {

/// The settings for rendering one face.
struct CaptureSettings {
  glm::dvec3 originWorld{0.0};
  glm::dvec3 rotationDegrees{0.0};  ///< of the cube's axes, as in rotationMatrix
  double nearDistance = 0.01;
  double farDistance = 1000.0;
  int samplesPerTexelSide = 2;
  Clear clear = ClearToSky{};
};

/// Samples along each side of a texel or pixel, for 1, 4 or 16 in total.
inline int samplesPerSide(int samplesPerPixel) {
  return samplesPerPixel >= 16 ? 4 : samplesPerPixel >= 4 ? 2 : 1;
}

class CubeCapture {
 public:
  CubeCapture(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state);
  ~CubeCapture();

  /// Renders `props`, lit by `lights`, into level 0 of one face of `radiance` and `distance`, which have the same face
  /// size. Counts texels above half-float range and non-finite texels.
  void captureFace(const CaptureSettings& settings, int face, const std::vector<vtkProp*>& props,
                   const std::vector<vtkLight*>& lights, const CubeTexture& radiance, const CubeTexture* distance);

  /// Draws into a few pixels that nobody reads, to compile programs and upload buffers.
  void drawOnce(const CaptureSettings& settings, const std::vector<vtkProp*>& props,
                const std::vector<vtkLight*>& lights);

  /// Renders a whole frame in linear units with any camera: RGBA, `samplesPerSide`² samples per pixel, rows from the
  /// top. With `picture`, averages frames up to its limit; `beforeFrame` is called before each with its number.
  ImageRgbaF renderFrame(vtkCamera* camera, int width, int height, int samplesPerSide,
                         const std::vector<vtkProp*>& props, const std::vector<vtkLight*>& lights,
                         vtkPicturePass* picture = nullptr, const std::function<void(int)>& beforeFrame = {});

  /// Draws all captures and frames of this object; its camera is set for each.
  vtkRenderer* renderer() const { return renderer_; }

  void release();

 private:
  void renderInto(vtkCamera* camera, int width, int height, const std::vector<vtkProp*>& props,
                  const std::vector<vtkLight*>& lights, const glm::vec3& clearColor);
  void prepare(int width, int height, const std::vector<vtkLight*>& lights, const glm::vec3& clearColor);
  void draw(vtkCamera* camera);

  vtkOpenGLRenderWindow* window_;
  std::shared_ptr<DrawState> state_;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkTargetPass> pass_;
  vtkSmartPointer<vtkCamera> faceCamera_;
  FloatTarget target_;
  CubeFramebuffer faces_;
  FullScreenPass resolve_;
  GLuint query_ = 0;
};

}  // namespace boxprobe
