// The handles' pictures in a vtkRenderer: a ball on each face of the selected probe in its axis' colour, a diamond at
// its capture origin, a small diamond at the other probes' origins; always the same size on the screen, brighter and
// larger under the pointer. Called by the probe widget; knows no mouse.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "app/gui/handles/handle_picking.h"
#include "filters/core/scene/scene.h"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace boxprobe {

class HandleActors {
 public:
  explicit HandleActors(vtkRenderer* renderer);

  void update(const std::vector<Probe>& probes, std::optional<std::size_t> selected, std::optional<Handle> highlighted);
  void setVisible(bool visible);
  /// Before each picture: sizes follow the view, whose pixels are logical ones.
  void fit(const ViewProjection& view);

 private:
  struct Mark {
    vtkSmartPointer<vtkActor> body, outline;
    glm::dvec3 positionWorld{0.0};
    double radiusPixels = 7.0;
  };
  Mark newMark(vtkPolyData* shape);
  void place(Mark& mark, const std::vector<Probe>& probes, const Handle& handle, bool selected, bool highlighted);

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPolyData> ball_, diamond_;
  std::vector<Mark> faces_;    ///< six
  std::vector<Mark> origins_;  ///< one per probe; grows, never shrinks
  std::size_t shownOrigins_ = 0;
  bool shownFaces_ = false;
  bool visible_ = true;
};

}  // namespace boxprobe
