// A slider that scrolling past does not change, unless it was clicked before. Called by the panels.
#pragma once

#include <QSlider>
#include <QWheelEvent>

namespace boxprobe {

class QuietSlider : public QSlider {
 public:
  explicit QuietSlider(Qt::Orientation orientation, QWidget* parent = nullptr) : QSlider(orientation, parent) {
    setFocusPolicy(Qt::StrongFocus);
  }

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (!hasFocus()) return event->ignore();
    QSlider::wheelEvent(event);
  }
};

}  // namespace boxprobe
