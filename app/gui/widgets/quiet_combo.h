// A combo box that scrolling past does not change. Called by the panels.
#pragma once

#include <QComboBox>
#include <QWheelEvent>

namespace boxprobe {

class QuietCombo : public QComboBox {
 public:
  explicit QuietCombo(QWidget* parent = nullptr) : QComboBox(parent) { setFocusPolicy(Qt::StrongFocus); }

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

}  // namespace boxprobe
