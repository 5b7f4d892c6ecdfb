// Taking hold of the probes with the mouse: which handle is under the pointer, what dragging it does to the document,
// and that one drag is one undo step. Called by the viewport with mouse positions in logical pixels; draws through the
// overlay; knows no GL and no panel.
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>
#include <optional>

#include "app/gui/edit/editor.h"
#include "app/gui/handles/handle_drag.h"
#include "app/gui/handles/handle_picking.h"
#include "app/gui/handles/probe_overlay.h"

namespace boxprobe {

class ProbeWidget : public QObject {
  Q_OBJECT

 public:
  /// `view` answers with the view as it is now.
  ProbeWidget(Editor& editor, ProbeOverlay& overlay, std::function<ViewProjection()> view, QObject* parent = nullptr);

  /// True if the pointer took hold of a handle; the camera must then stay where it is.
  bool press(const QPointF& pixel, Qt::KeyboardModifiers modifiers);
  void move(const QPointF& pixel, Qt::KeyboardModifiers modifiers);
  void release(const QPointF& pixel, Qt::KeyboardModifiers modifiers);
  void leave();
  /// 0, 1, 2 while X, Y or Z is held down: the origin moves along that axis only.
  void setHeldAxis(std::optional<int> axis);
  bool dragging() const { return faceDrag_ || originDrag_; }
  void cancel();

  /// The document changed.
  void update();
  void setVisible(bool visible);

 signals:
  void pictureChanged();
  void cursorWanted(Qt::CursorShape shape);
  void hint(const QString& text);                             ///< what the handle under the pointer does; may be empty
  void readout(const QString& text, const QPointF& atPixel);  ///< numbers of the drag under way; empty: none

 private:
  void hover(const QPointF& pixel);
  void drag();
  void dragFace(const Ray& ray);
  void dragOrigin(const Ray& ray);
  void endDrag();

  Editor& editor_;
  ProbeOverlay& overlay_;
  std::function<ViewProjection()> view_;
  std::optional<Handle> hovered_;
  std::optional<FaceDrag> faceDrag_;
  std::optional<OriginDrag> originDrag_;
  std::optional<int> heldAxis_;
  QPointF pressed_, pixel_;
  Qt::KeyboardModifiers modifiers_;
  bool moved_ = false;      ///< since the press: a click alone edits nothing
  bool previewed_ = false;  ///< by this drag
};

}  // namespace boxprobe
