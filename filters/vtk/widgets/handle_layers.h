// Boxes and handles over a renderer's picture: vtkRenderers of their own in the layers above, so that no capture and no
// pass over the picture can hold them. What the scene hides of a box is drawn fainter, handles are never hidden.
#pragma once

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/vtk/widgets/handle_actors.h"
#include "filters/vtk/widgets/handle_colors.h"
#include "filters/vtk/widgets/wire_actors.h"

class vtkRenderWindow;
class vtkRenderer;
class vtkTextActor;

namespace boxprobe {

class HandleLayers {
 public:
  /// `scene` is a renderer of `window`; its camera and viewport are followed. Not while the window draws.
  HandleLayers(vtkRenderWindow* window, vtkRenderer* scene);
  ~HandleLayers();
  HandleLayers(const HandleLayers&) = delete;
  HandleLayers& operator=(const HandleLayers&) = delete;

  /// Null once it is gone.
  vtkRenderWindow* window() const;
  /// `size`: of handles, in their usual pixels.
  void setLook(const HandleColors& colors, double size);
  /// `together`: the places of all selected probes; `selected` is the one whose handles are shown.
  void update(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
              const std::vector<std::size_t>& together, std::optional<Handle> highlighted, HandleMode mode);
  /// From a capture origin to the floor under it; nothing: none.
  void setDrop(const std::optional<std::array<glm::dvec3, 2>>& endsWorld);
  /// Proposed boxes, drawn dashed beside the probes' own.
  void setGhosts(const std::vector<Probe>& ghosts);
  /// Beside the pointer, which is at that logical pixel of a view so large. An empty text: none.
  void setReadout(const std::string& text, const glm::dvec2& pixel, const glm::dvec2& viewPixels);
  void setDrawn(bool drawn);
  /// Before each picture. `view` is in logical pixels, of `pixelScale` device pixels each.
  void follow(const ViewProjection& view, double pixelScale);

 private:
  void takeCamera(vtkRenderer* layer);

  vtkWeakPointer<vtkRenderWindow> window_;
  vtkWeakPointer<vtkRenderer> scene_;
  vtkSmartPointer<vtkRenderer> solidLayer_;  ///< depth-tested against the scene
  vtkSmartPointer<vtkRenderer> onTopLayer_;  ///< over everything
  vtkNew<vtkCallbackCommand> drawing_;       ///< a layer begins to draw
  WireActors solid_, faint_;
  HandleActors handles_;
  vtkSmartPointer<vtkTextActor> readout_;  ///< null until there is one
  double pixelScale_ = 1.0;
};

}  // namespace boxprobe
