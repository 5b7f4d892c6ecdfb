// The schematic: plan and side elevation of what is explained, in a corner of the picture, as large as that has room
// for, or under the card that explains. Called by the main window; paints through schematic_painter.h. Takes no mouse.
#pragma once

#include <QWidget>
#include <optional>

#include "filters/explain/schematic.h"

namespace boxprobe {

class SchematicInset : public QWidget {
  Q_OBJECT

 public:
  /// Keeps itself in the lower right corner, or the upper one, of `parent`.
  explicit SchematicInset(QWidget* parent);
  /// In a layout instead, as wide as that makes it.
  struct InLayout {};
  explicit SchematicInset(InLayout);

  /// Nothing to draw (the background, no probe) hides it.
  /// `position`: of the pixel explained, logical; the inset keeps off it.
  void show(const Explanation& explanation, const QPointF& position);
  void clear();
  /// By the user: off, it stays hidden whatever is explained, and computes nothing.
  void setShown(bool shown);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  std::optional<Schematic> schematic_;
  QPointF position_;
  bool shown_ = true;
  bool inPicture_ = true;
};

}  // namespace boxprobe
