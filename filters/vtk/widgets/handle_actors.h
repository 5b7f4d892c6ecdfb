// Draws the handles in a vtkRenderer: balls on the faces of the selected probe in their axis' colour, filled at the
// maximum and hollow at the minimum, arrows and rings, a diamond at its capture origin, small diamonds at the other
// probes' origins. Their size on screen is constant; they are brighter and larger under the pointer.
#pragma once

#include <vtkSmartPointer.h>

#include <functional>
#include <glm/mat3x3.hpp>
#include <optional>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/vtk/widgets/handle_colors.h"
#include "filters/vtk/widgets/handle_picking.h"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace boxprobe {

class HandleActors {
 public:
  explicit HandleActors(vtkRenderer* renderer);

  /// `together`: ascending indices of all selected probes.
  void update(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
              const std::vector<std::size_t>& together, std::optional<Handle> highlighted, HandleMode mode);
  /// Applies at the next update(). `size`: factor of the default pixel sizes.
  void setLook(const HandleColors& colors, double size);
  /// Device pixels per logical pixel.
  void setPixelScale(double scale);
  /// To be called before each picture: sizes follow the view, in logical pixels.
  void fit(const ViewProjection& view);

 private:
  enum class Form { Round, Pointing, Ring };
  struct Mark {
    vtkSmartPointer<vtkActor> body, outline;
    Form form = Form::Round;
    glm::dvec3 positionWorld{0.0};
    glm::dmat3 frame{1.0};  ///< for oriented shapes: its X is the axis
    double radiusPixels = 7.0, outlinePixels = 2.0;
    bool shown = false;
    bool idle = false;  ///< of a probe that is not selected: fades and shrinks with distance
  };
  static double fadeOf(const Mark& mark, const ViewProjection& view, double nearest);
  Mark newMark(vtkPolyData* shape, Form form);
  Mark& markOf(const Handle& handle);
  /// The selection state of a handle's probe: not selected, selected as well, or the one with all handles.
  enum class Rank { Idle, Beside, Shown };
  void place(Mark& mark, const std::vector<Probe>& probes, const Handle& handle, Rank rank, bool highlighted);
  void forAll(const std::function<void(Mark&)>& work);

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPolyData> diamond_;
  std::vector<Mark> faces_;           ///< six, of the box that the mode edits
  std::vector<Mark> blends_;          ///< six
  std::vector<Mark> arrows_, rings_;  ///< three
  std::vector<Mark> origins_;         ///< one per probe; never shrinks
  HandleColors colors_;
  double size_ = 1.0;
};

}  // namespace boxprobe
