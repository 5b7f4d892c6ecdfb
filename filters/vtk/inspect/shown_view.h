// The current debug view: its range, if it depends on the scene, and its legend.
#pragma once

#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/surface_view.h"
#include "filters/vtk/scene/scene_content.h"

class vtkColorTransferFunction;
class vtkLegendBoxActor;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkScalarBarActor;
class vtkTextActor;

namespace boxprobe {

/// The colour map of the debug view, shared by shader and legend. Draws into the window only, never into captures or
/// linear pictures.
class ViewLegend {
 public:
  ViewLegend();
  ~ViewLegend();

  /// Shows a view's name, and its bar with the range or, for weights and faces, swatches. Row 0 removes everything.
  void show(vtkRenderer* renderer, const SurfaceViewRow& row, double low, double high,
            const std::vector<std::string>& probeNames);
  /// Uploads the colour map for the shader, and traced light below it. The context must be current.
  void upload(vtkOpenGLRenderWindow* window, SceneResources& resources, const ImageRgbaF& truth) const;

 private:
  void showNames(vtkRenderer* renderer, const std::vector<glm::vec3>& colors, const std::vector<std::string>& names);

  vtkSmartPointer<vtkColorTransferFunction> colors_;
  vtkSmartPointer<vtkScalarBarActor> bar_;
  vtkSmartPointer<vtkLegendBoxActor> names_;
  vtkSmartPointer<vtkTextActor> caption_;
};

class ShownView {
 public:
  const SurfaceViewSettings& settings() const { return settings_; }
  void set(const SurfaceViewSettings& settings) { settings_ = settings; }
  /// Is it a debug view instead of the picture?
  bool any() const { return settings_.view != 0; }
  /// See SceneRenderer::setDiffuseTruth.
  void setTruth(ImageRgbaF light);
  /// At a pixel of a picture of `width` x `height`, from the top left; nothing: not traced there.
  std::optional<glm::vec4> truthAt(int x, int y, int width, int height) const;

  /// The ends of its scale: those that were set, else the row's, else the scene's.
  std::pair<double, double> range(const SceneContent& content) const;
  /// Applies the view to objects, draws and legend.
  void apply(SceneContent& content, DrawState& state, vtkRenderer* renderer);
  /// To be called before each frame. The context must be current.
  void upload(vtkOpenGLRenderWindow* window, SceneResources& resources);

 private:
  SurfaceViewSettings settings_;
  ViewLegend legend_;
  ImageRgbaF truth_;
  bool truthChanged_ = false;
};

}  // namespace boxprobe
