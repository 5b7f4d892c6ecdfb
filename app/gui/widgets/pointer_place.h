// Where the pointer is, logical pixels: Qt 5 and 6 name it differently.
#pragma once

#include <QMouseEvent>
#include <QPointF>

namespace boxprobe {

/// In the widget.
inline QPointF pointerPlace(const QMouseEvent& event) {
#if QT_VERSION_MAJOR >= 6
  return event.position();
#else
  return event.localPos();
#endif
}

/// On the screen.
inline QPointF pointerOnScreen(const QMouseEvent& event) {
#if QT_VERSION_MAJOR >= 6
  return event.globalPosition();
#else
  return event.screenPos();
#endif
}

}  // namespace boxprobe
