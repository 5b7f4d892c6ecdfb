// Boxes and handles over the picture: own vtkRenderers in layers above the scene's, so that no capture and no exported
// image can hold them. What the scene hides of a box is drawn fainter. Called by the probe widget and the window; knows
// no mouse.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <vector>

#include "app/gui/handles/handle_actors.h"
#include "app/gui/handles/handle_picking.h"
#include "app/gui/handles/wire_actors.h"
#include "filters/core/scene/scene.h"

class vtkRenderWindow;
class vtkRenderer;

namespace boxprobe {

class ProbeOverlay {
 public:
  /// `sceneRenderer` is in layer 0 of `window`; its camera is followed.
  ProbeOverlay(vtkRenderWindow* window, vtkRenderer* sceneRenderer);
  ~ProbeOverlay();
  ProbeOverlay(const ProbeOverlay&) = delete;
  ProbeOverlay& operator=(const ProbeOverlay&) = delete;

  /// `together`: the places of all selected probes; `selected` is the one whose handles are shown.
  void update(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
              const std::vector<std::size_t>& together, std::optional<Handle> highlighted,
              HandleMode mode = HandleMode::Box);
  /// From a capture origin to the floor under it; nothing: none.
  void setDrop(const std::optional<std::array<glm::dvec3, 2>>& endsWorld);
  /// Proposed boxes, drawn dashed beside the probes' own.
  void setGhosts(const std::vector<Probe>& ghosts);
  void setVisible(bool visible);
  bool visible() const { return visible_; }
  /// Not drawn at all, without forgetting whether they are visible: while an image is exported.
  void setSuspended(bool suspended);
  /// Before each picture. `view` is in logical pixels.
  void follow(const ViewProjection& view);

 private:
  vtkSmartPointer<vtkRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> scene_;
  vtkSmartPointer<vtkRenderer> solidLayer_;  ///< depth-tested against the scene
  vtkSmartPointer<vtkRenderer> onTopLayer_;  ///< over everything
  WireActors solid_, faint_;
  HandleActors handles_;
  bool visible_ = true;
};

}  // namespace boxprobe
