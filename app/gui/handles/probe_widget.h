// The mouse over the document's probes: the representation tells which handle is under the pointer and what a drag
// makes of a probe; here that becomes a selection, a preview and one undo step, for several probes as well. Mouse
// positions are logical pixels.
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>
#include <optional>

#include "app/gui/edit/editor.h"
#include "app/gui/edit/view_state.h"
#include "app/gui/handles/scene_surfaces.h"
#include "filters/vtk/widgets/handle_drag.h"
#include "filters/vtk/widgets/handle_picking.h"

class vtkReflectionProbeRepresentation;

namespace boxprobe {

class ProbeWidget : public QObject {
  Q_OBJECT

 public:
  /// `view` answers with the view as it is now.
  ProbeWidget(Editor& editor, const ViewState& state, vtkReflectionProbeRepresentation& shown, SceneSurfaces& surfaces,
              std::function<ViewProjection()> view, QObject* parent = nullptr);

  /// True if the pointer took hold of a handle; the camera must then stay where it is. On the diamond of another probe
  /// it selects that one, with Ctrl beside those that are selected.
  bool press(const QPointF& pixel, Qt::KeyboardModifiers modifiers);
  /// While dragging: Shift moves a tenth as far, Ctrl snaps, Alt moves the opposite face as well.
  void move(const QPointF& pixel, Qt::KeyboardModifiers modifiers);
  void release(const QPointF& pixel, Qt::KeyboardModifiers modifiers);
  void leave();
  /// 0, 1, 2 while X, Y or Z is held down: the origin moves along that axis only.
  void setHeldAxis(std::optional<int> axis);
  bool dragging() const;
  void cancel();

  /// Arrow keys and Page up, down: the face under the pointer, else the origin or, in HandleMode::Place, the whole
  /// probe, by 10 cm, with Shift by 1 cm. Left, Right, Up and Down go along the horizontal axis of the world that is
  /// nearest to that way on the screen. False for other keys. One undo step from the first press to endNudge().
  bool nudge(int key, Qt::KeyboardModifiers modifiers);
  void endNudge();

  /// Whose handle is there.
  std::optional<std::size_t> probeAt(const QPointF& pixel) const;

  HandleMode mode() const;
  void setMode(HandleMode mode);

  /// The document changed.
  void update();
  void setVisible(bool visible);

 signals:
  void pictureChanged();
  void modeChanged(boxprobe::HandleMode mode);
  void taken();  ///< a press found a handle
  void cursorWanted(Qt::CursorShape shape);
  void hint(const QString& text);                             ///< what the handle under the pointer does; may be empty
  void readout(const QString& text, const QPointF& atPixel);  ///< numbers of the drag under way; empty: none

 private:
  void hover(const QPointF& pixel);
  void drag();
  void show();
  void preview(const Handle& handle, const Probe& start, const Probe& result);
  void endDrag();
  void updateDrop();
  void forget();

  Editor& editor_;
  const ViewState& state_;
  vtkReflectionProbeRepresentation& shown_;
  SceneSurfaces& surfaces_;
  std::function<ViewProjection()> view_;
  QPointF pixel_;
  bool previewed_ = false;  ///< by this drag: a click alone edits nothing
  struct Nudge {
    Handle handle;
    Probe start;
    glm::dvec3 by{0.0};  ///< world; along a face's axis for faces
  };
  std::optional<Nudge> nudge_;
};

}  // namespace boxprobe
