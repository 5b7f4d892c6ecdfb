// The handles' pictures in a vtkRenderer: balls on the faces of the selected probe in their axis' colour, filled at the
// maximum and hollow at the minimum, arrows and rings, a diamond at its capture origin, a small diamond at the other
// probes' origins; always the same size on the screen, brighter and larger under the pointer.
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

  /// `together`: the places of all selected probes, ascending.
  void update(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
              const std::vector<std::size_t>& together, std::optional<Handle> highlighted, HandleMode mode);
  /// For the next update(). `size`: of their usual pixels.
  void setLook(const HandleColors& colors, double size);
  /// Device pixels of a logical one.
  void setPixelScale(double scale);
  /// Before each picture: sizes follow the view, whose pixels are logical ones.
  void fit(const ViewProjection& view);

 private:
  enum class Form { Round, Pointing, Ring };
  struct Mark {
    vtkSmartPointer<vtkActor> body, outline;
    Form form = Form::Round;
    glm::dvec3 positionWorld{0.0};
    glm::dmat3 frame{1.0};  ///< of what points or lies somewhere: its X is the axis
    double radiusPixels = 7.0, outlinePixels = 2.0;
    bool shown = false;
    bool idle = false;  ///< of a probe that is not selected: smaller and fainter with its distance
  };
  static double fadeOf(const Mark& mark, const ViewProjection& view, double nearest);
  Mark newMark(vtkPolyData* shape, Form form);
  Mark& markOf(const Handle& handle);
  /// Which of the selected probes a handle belongs to: none, one beside another, the one whose handles are shown.
  enum class Rank { Idle, Beside, Shown };
  void place(Mark& mark, const std::vector<Probe>& probes, const Handle& handle, Rank rank, bool highlighted);
  void forAll(const std::function<void(Mark&)>& work);

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPolyData> diamond_;
  std::vector<Mark> faces_;           ///< six, of the box that the mode is about
  std::vector<Mark> blends_;          ///< six
  std::vector<Mark> arrows_, rings_;  ///< three
  std::vector<Mark> origins_;         ///< one per probe; grows, never shrinks
  HandleColors colors_;
  double size_ = 1.0;
};

}  // namespace boxprobe
