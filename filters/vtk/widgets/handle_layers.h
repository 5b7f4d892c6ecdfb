// Draws boxes and handles over a renderer's picture, with separate vtkRenderers in the layers above, so that captures
// and passes over the picture do not contain them. Parts of boxes hidden by the scene are fainter; handles are never
// hidden.
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
  /// `scene`: a renderer of `window`, whose camera and viewport are followed. Must not be called while the window
  /// draws.
  HandleLayers(vtkRenderWindow* window, vtkRenderer* scene);
  ~HandleLayers();
  HandleLayers(const HandleLayers&) = delete;
  HandleLayers& operator=(const HandleLayers&) = delete;

  /// Null after its deletion.
  vtkRenderWindow* window() const;
  /// `size`: factor of the handles' default pixel sizes.
  void setLook(const HandleColors& colors, double size);
  /// `together`: indices of all selected probes; `selected`: the one whose handles are shown.
  void update(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
              const std::vector<std::size_t>& together, std::optional<Handle> highlighted, HandleMode mode);
  /// A line from a capture origin to the floor below it; nothing: none.
  void setDrop(const std::optional<std::array<glm::dvec3, 2>>& endsWorld);
  /// Proposed boxes, drawn dashed in addition to the probes' own.
  void setGhosts(const std::vector<Probe>& ghosts);
  /// Text beside the pointer, which is at that logical pixel of a view of that size. Empty: none.
  void setReadout(const std::string& text, const glm::dvec2& pixel, const glm::dvec2& viewPixels);
  void setDrawn(bool drawn);
  /// To be called before each picture. `view` is in logical pixels of `pixelScale` device pixels.
  void follow(const ViewProjection& view, double pixelScale);

 private:
  void takeCamera(vtkRenderer* layer);

  vtkWeakPointer<vtkRenderWindow> window_;
  vtkWeakPointer<vtkRenderer> scene_;
  vtkSmartPointer<vtkRenderer> solidLayer_;  ///< depth-tested against the scene
  vtkSmartPointer<vtkRenderer> onTopLayer_;  ///< over everything
  vtkNew<vtkCallbackCommand> drawing_;       ///< a layer starts to draw
  WireActors solid_, faint_;
  HandleActors handles_;
  vtkSmartPointer<vtkTextActor> readout_;  ///< null until first used
  double pixelScale_ = 1.0;
};

}  // namespace boxprobe
