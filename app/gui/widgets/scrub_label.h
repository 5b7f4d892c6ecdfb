// A label that changes the number beside it when dragged sideways, as in tools artists know: one pixel a tenth of a
// step, with Shift a hundredth. Called by the panels' rows.
#pragma once

#include <QLabel>

namespace boxprobe {

class ValueField;

class ScrubLabel : public QLabel {
  Q_OBJECT

 public:
  ScrubLabel(const QString& text, ValueField* field, QWidget* parent = nullptr);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  ValueField* field_;
  bool dragging_ = false;
  double lastX_ = 0.0;
  double value_ = 0.0;  ///< unrounded, so that slow drags add up
};

}  // namespace boxprobe
