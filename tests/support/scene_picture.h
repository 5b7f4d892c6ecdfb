// Scenes drawn off screen for tests: load, bake, picture; and how far two pictures are apart.
#pragma once

#include <vtkOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe::test {

/// A scene in a window of its own. `scene` may be edited before show() is called, and between calls.
class ScenePicture {
 public:
  ScenePicture(Scene scene, int width, int height, int multiSamples = 0);
  static ScenePicture fromFile(const std::string& nameInData, int width, int height);

  Scene scene;
  /// Syncs (everything), bakes, places `camera`.
  void show(const Camera& camera);
  /// Parallel projection of that height, in scene units.
  void setParallel(double height);
  ImageRgba8 display() { return renderer->renderDisplay(); }
  ImageRgbaF linear(int samplesPerPixel = 4);
  /// The same size, drawn four times as fine and averaged: a truth in which textures are themselves. Drawn as they are,
  /// they are blurred by the angle they are seen under, above all where the driver has no anisotropic sampling, and a
  /// capture sees them under other angles than the camera.
  ImageRgbaF fineLinear();

  vtkSmartPointer<vtkOpenGLRenderWindow> window;
  std::unique_ptr<SceneRenderer> renderer;

 private:
  bool loaded_ = false;
};

const Camera& cameraNamed(const Scene& scene, const std::string& name);

/// The camera seen in a horizontal mirror at `height`; its picture is upside down and left-right swapped twice, that
/// is, flip it top to bottom to compare.
Camera mirroredInFloor(const Camera& camera, double height);

/// Peak signal-to-noise ratio in dB of display-encoded values, over the pixels where `mask` (if given) is not 0.
double psnr(const ImageRgbaF& a, const ImageRgbaF& b, const std::vector<bool>& mask);

ImageRgbaF flippedTopToBottom(const ImageRgbaF& image);

/// Under BOXPROBE_TEST_OUTPUT, if that is set: pictures to look at.
void keepPicture(const ImageRgbaF& image, const std::string& name);
void keepPicture(const ImageRgba8& image, const std::string& name);

}  // namespace boxprobe::test
