// A combo box that scrolling past does not change, and that can say that it stands for several values. Called by the
// panels.
#pragma once

#include <QComboBox>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QWheelEvent>

#include "app/gui/widgets/differs.h"

namespace boxprobe {

class QuietCombo : public QComboBox {
 public:
  explicit QuietCombo(QWidget* parent = nullptr) : QComboBox(parent) { setFocusPolicy(Qt::StrongFocus); }

  /// What it stands for differs: a dash is drawn in place of the choice.
  void setDiffers(bool differs) {
    differs_ = differs;
    update();
  }
  bool differs() const { return differs_; }

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
  void paintEvent(QPaintEvent* event) override {
    if (!differs_) return QComboBox::paintEvent(event);
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    option.currentText = differsText();
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
  }

 private:
  bool differs_ = false;
};

}  // namespace boxprobe
