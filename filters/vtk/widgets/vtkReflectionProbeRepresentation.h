/**
 * @class vtkReflectionProbeRepresentation
 * @brief boxes and handles of a vtkReflectionProbe, to be dragged by vtkReflectionProbeWidget
 *
 * Draws the probe's box, its influence box and, dashed, the box inside which it has its full weight, with the handles
 * of one mode: balls on the faces, a diamond at the capture origin, arrows to move the probe, rings to rotate it. Parts
 * of a box that the scene hides are fainter. Handles have a constant size on screen, in pixels of 1/72 inch by the
 * window's DPI. A drag changes the probe; nothing is captured unless its origin or orientation changes.
 *
 * Draws with two renderers of its own, in the layers of the window above the renderer's: captures, pictures of render
 * passes and vtkRenderer::GetActors() do not include it. They exist while the representation has a renderer with a
 * window. The camera's window centre and view shear are ignored.
 *
 * Without a renderer, a window or a probe nothing is drawn and nothing can be dragged. Use it in the thread of the
 * window's OpenGL context.
 */
#pragma once

#include <vtkWidgetRepresentation.h>

#include <memory>
#include <string>

#include "filters/core/base/export.h"

#ifndef __VTK_WRAP__
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "filters/vtk/widgets/handle_drag.h"
#include "filters/vtk/widgets/view_projection.h"

namespace boxprobe {
class SurfaceRays;
}  // namespace boxprobe
#endif

class vtkReflectionProbe;

class BOXPROBE_EXPORT vtkReflectionProbeRepresentation : public vtkWidgetRepresentation {
 public:
  static vtkReflectionProbeRepresentation* New();
  // clang-format off
  vtkTypeMacro(vtkReflectionProbeRepresentation, vtkWidgetRepresentation)
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /** Includes the MTime of the probe. */
  vtkMTimeType GetMTime() override;

  ///@{
  /** Null (default): nothing is drawn. Changing it ends a drag, whose probe keeps its current values. */
  void SetProbe(vtkReflectionProbe* probe);
  vtkReflectionProbe* GetProbe() const;
  ///@}

  ///@{
  /** The handles that are shown. BOX (default): the faces of the box, and the origin. INFLUENCE: the faces of the
   * influence box and of the box of full weight, which set the blend distances. ORIGIN: the origin, freely or along the
   * world's axes. PLACE: the whole probe, moved along and rotated about the axes of its box. */
  enum ModeType { BOX = 0, INFLUENCE = 1, ORIGIN = 2, PLACE = 3 };
  void SetMode(int mode);
  vtkGetMacro(Mode, int)
  void SetModeToBox() { this->SetMode(BOX); }
  void SetModeToInfluence() { this->SetMode(INFLUENCE); }
  void SetModeToOrigin() { this->SetMode(ORIGIN); }
  void SetModeToPlace() { this->SetMode(PLACE); }
  ///@}

  ///@{
  /** Constraints of the current drag. Symmetric: the opposite face moves equally far the other way. Fine: a tenth of the
   * pointer's movement. Snapping: see below. ConstrainedAxis: the world axis along which the origin moves, 0 to 2 for X
   * to Z; -1: freely. All off by default; the widget sets the first three by the keys Alt, Shift and Control. */
  vtkSetMacro(Symmetric, bool)
  vtkGetMacro(Symmetric, bool)
  vtkBooleanMacro(Symmetric, bool)
  vtkSetMacro(Fine, bool)
  vtkGetMacro(Fine, bool)
  vtkBooleanMacro(Fine, bool)
  vtkSetMacro(Snapping, bool)
  vtkGetMacro(Snapping, bool)
  vtkBooleanMacro(Snapping, bool)
  vtkSetClampMacro(ConstrainedAxis, int, -1, 2)
  vtkGetMacro(ConstrainedAxis, int)
  ///@}

  ///@{
  /** While snapping, and if SnapToSurfaces is on (default), a face of a box snaps to the wall under the pointer, or to
   * one within SnapDistance (pixels; 14 by default). Walls are the visible actors with vtkPolyDataMapper. */
  vtkSetMacro(SnapToSurfaces, bool)
  vtkGetMacro(SnapToSurfaces, bool)
  vtkBooleanMacro(SnapToSurfaces, bool)
  vtkSetClampMacro(SnapDistance, double, 0.0, 1000.0)
  vtkGetMacro(SnapDistance, double)
  ///@}
  ///@{
  /** Other handles, and faces without a wall, snap to a grid whose step is the smallest visible power of ten, at most
   * this: 0.1 units by default. Rotations snap to AngleStep degrees, 15 by default. */
  vtkSetClampMacro(LargestGridStep, double, 1.0e-9, 1.0e9)
  vtkGetMacro(LargestGridStep, double)
  vtkSetClampMacro(AngleStep, double, 0.01, 180.0)
  vtkGetMacro(AngleStep, double)
  ///@}

  ///@{
  /** Distance in pixels from a face's ball (whose diameter is HandleSize, 14 by default; other handles in proportion)
   * within which a handle can be grabbed. 5 by default. */
  vtkSetClampMacro(Tolerance, double, 0.0, 100.0)
  vtkGetMacro(Tolerance, double)
  ///@}

  ///@{
  /** Display colours. Faces' handles, arrows and rings have the colour of their axis. */
  vtkSetVector3Macro(XAxisColor, double)
  vtkGetVector3Macro(XAxisColor, double)
  vtkSetVector3Macro(YAxisColor, double)
  vtkGetVector3Macro(YAxisColor, double)
  vtkSetVector3Macro(ZAxisColor, double)
  vtkGetVector3Macro(ZAxisColor, double)
  vtkSetVector3Macro(BoxColor, double)
  vtkGetVector3Macro(BoxColor, double)
  vtkSetVector3Macro(InfluenceColor, double)
  vtkGetVector3Macro(InfluenceColor, double)
  vtkSetVector3Macro(BlendColor, double)
  vtkGetVector3Macro(BlendColor, double)
  vtkSetVector3Macro(OriginColor, double)
  vtkGetVector3Macro(OriginColor, double)
  vtkSetVector3Macro(HaloColor, double)
  vtkGetVector3Macro(HaloColor, double)
  ///@}

  ///@{
  /** The numbers of the current drag, one or several lines of UTF-8; empty without a drag. LengthUnit, empty by default,
   * follows lengths. Drawn beside the pointer if ReadoutVisibility is on (default). */
  const char* GetReadout() const;
  vtkSetMacro(ReadoutVisibility, bool)
  vtkGetMacro(ReadoutVisibility, bool)
  vtkBooleanMacro(ReadoutVisibility, bool)
  vtkSetStdStringFromCharMacro(LengthUnit)
  vtkGetCharFromStdStringMacro(LengthUnit)
  ///@}

  /** The kind of handle that the pointer is over, or drags. */
  enum InteractionStateType { Outside = 0, MovingFace, MovingInfluence, MovingBlend, MovingOrigin, MovingOriginAlongAxis,
                              Translating, Rotating };
  /** The face of that handle: 0 to 5 for -X, +X, -Y, ..., in the order of bounds; -1 for other handles. */
  int GetInteractionFace() const;
  /** The axis of that handle, 0 to 2; -1 for the origin, and without a handle. */
  int GetInteractionAxis() const;
  /** Is a handle being dragged? */
  bool GetDragging() const;
  /** Ends the current drag and restores the probe. */
  void CancelInteraction();

  ///@{
  /** Positions are in display coordinates of the renderer's window, as in events. */
  int ComputeInteractionState(int x, int y, int modify = 0) override;
  void StartWidgetInteraction(double eventPosition[2]) override;
  void WidgetInteraction(double eventPosition[2]) override;
  void EndWidgetInteraction(double eventPosition[2]) override;
  ///@}
  /** 0 removes the highlight. ComputeInteractionState() sets it. */
  void Highlight(int highlighted) override;

  /** Null removes the layers. The widget calls it when it is enabled or disabled; not to be called during a render. */
  void SetRenderer(vtkRenderer* renderer) override;
  void BuildRepresentation() override;
  /** Sets the probe's bounds, scaled by PlaceFactor about their centre. */
  void PlaceWidget(double bounds[6]) override;
  /** World bounds of the projection box and the influence box; null without a probe. */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void SetVisibility(vtkTypeBool visible) override;
  /** Draws nothing itself, but updates the layers above. */
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  // clang-format on

#ifndef __VTK_WRAP__
  /// For programs with their own probes and undo: they tell what to show, and drags return the resulting probe without
  /// changing anything. Views are in logical pixels, from the top left.
  ///@{
  /// Shows several probes, `selected` with its handles; `together`: ascending indices of others that are selected.
  /// Instead of SetProbe().
  void ShowProbes(const std::vector<boxprobe::Probe>& probes, std::optional<std::size_t> selected,
                  const std::vector<std::size_t>& together);
  /// Of the probes that ShowProbes() shows: hidden ones are neither drawn nor found under the pointer, locked ones not
  /// found. By their index; those beyond the end are neither.
  void LeaveOut(std::vector<bool> hidden, std::vector<bool> locked);
  /// Shows proposed boxes, dashed.
  void ShowGhosts(const std::vector<boxprobe::Probe>& ghosts);
  /// A plumb line from a capture origin to the floor below it; nothing: none.
  void ShowDrop(const std::optional<std::array<glm::dvec3, 2>>& endsWorld);
  /// Replaces the renderer's actors; called when a face first snaps. May return null.
  void SetSurfaces(std::function<const boxprobe::SurfaceRays*()> surfaces);
  /// Translates the readout, see ReadoutStyle.
  void SetReadoutWords(std::function<std::string(const char*)> words);
  /// To be called before each picture if the representation is not among a renderer's props.
  void Follow(const boxprobe::ViewProjection& view);

  std::optional<boxprobe::Handle> HandleAt(const boxprobe::ViewProjection& view, const glm::dvec2& pixel) const;
  /// Highlights the handle under the pointer, and returns it.
  std::optional<boxprobe::Handle> Hover(const boxprobe::ViewProjection& view, const glm::dvec2& pixel);
  const std::optional<boxprobe::Handle>& GetHovered() const;
  /// Starts dragging the highlighted handle if it belongs to the selected probe.
  bool Grab(const boxprobe::ViewProjection& view, const glm::dvec2& pixel);
  /// The probe that results from the drag. Nothing without a drag, and while it may still be a click.
  std::optional<boxprobe::Probe> Pull(const boxprobe::ViewProjection& view, const glm::dvec2& pixel);
  void LetGo();
  /// Null without a drag.
  const boxprobe::ProbeDrag* GetDrag() const;
  ///@}
#endif

 protected:
  vtkReflectionProbeRepresentation();
  ~vtkReflectionProbeRepresentation() override;

  int Mode = BOX;
  bool Symmetric = false;
  bool Fine = false;
  bool Snapping = false;
  int ConstrainedAxis = -1;
  bool SnapToSurfaces = true;
  double SnapDistance = 14.0;
  double LargestGridStep = 0.1;
  double AngleStep = 15.0;
  double Tolerance = 5.0;
  double XAxisColor[3];
  double YAxisColor[3];
  double ZAxisColor[3];
  double BoxColor[3];
  double InfluenceColor[3];
  double BlendColor[3];
  double OriginColor[3];
  double HaloColor[3];
  bool ReadoutVisibility = true;
  std::string LengthUnit;

 private:
  vtkReflectionProbeRepresentation(const vtkReflectionProbeRepresentation&) = delete;
  void operator=(const vtkReflectionProbeRepresentation&) = delete;

  void MakeLayers();
  void Refresh();
  void SetHovered(int state);

  struct Parts;
  std::unique_ptr<Parts> Inside;
};
