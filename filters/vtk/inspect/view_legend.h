// The colour map of the debug view, shared by shader and legend. Draws into the window only, never into captures or
// linear pictures.
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

  /// Shows a view's name, and its bar with the range or, for weights and faces, swatches. Row 0 removes everything.
  void show(vtkRenderer* renderer, const SurfaceViewRow& row, double low, double high,
            const std::vector<std::string>& probeNames);
  /// Uploads the colour map for the shader. The context must be current.
  void upload(vtkOpenGLRenderWindow* window, SceneResources& resources) const;

 private:
  void showNames(vtkRenderer* renderer, const std::vector<glm::vec3>& colors, const std::vector<std::string>& names);

  vtkSmartPointer<vtkColorTransferFunction> colors_;
  vtkSmartPointer<vtkScalarBarActor> bar_;
  vtkSmartPointer<vtkLegendBoxActor> names_;
  vtkSmartPointer<vtkTextActor> caption_;
};

}  // namespace boxprobe
