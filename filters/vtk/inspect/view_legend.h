// The debug view's colours and the bar that explains them: one source for what the shader shows and what the legend
// says. Owned by the scene renderer; draws into the window only, never into captures or linear pictures.
#pragma once

#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/core/scene/surface_view.h"
#include "filters/vtk/draw/scene_resources.h"

class vtkColorTransferFunction;
class vtkLegendBoxActor;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkScalarBarActor;
class vtkTextActor;

namespace boxprobe {

class ViewLegend {
 public:
  ViewLegend();
  ~ViewLegend();

  /// The name of a view, and its bar with the range; for weights and faces a swatch for each. Row 0 takes all away.
  void show(vtkRenderer* renderer, const SurfaceViewRow& row, double low, double high,
            const std::vector<std::string>& probeNames);
  /// The colour map as the shader reads it. The context must be current.
  void upload(vtkOpenGLRenderWindow* window, SceneResources& resources) const;

 private:
  void showNames(vtkRenderer* renderer, const std::vector<glm::vec3>& colors, const std::vector<std::string>& names);

  vtkSmartPointer<vtkColorTransferFunction> colors_;
  vtkSmartPointer<vtkScalarBarActor> bar_;
  vtkSmartPointer<vtkLegendBoxActor> names_;
  vtkSmartPointer<vtkTextActor> caption_;
};

}  // namespace boxprobe
