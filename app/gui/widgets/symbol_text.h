// A symbol as a textbook sets it, "t_x = 2.12": the letter slanted, its subscript lowered, the rest upright, with a rim
// that keeps it legible across lines. Called by the painters of drawings.
#pragma once

#include <QFont>
#include <QSizeF>
#include <QString>

class QColor;
class QPainter;
class QRectF;

namespace boxprobe {

class SymbolText {
 public:
  /// What follows an underscore is a subscript; a word in small letters stays upright.
  SymbolText(const QString& text, const QFont& base);

  QSizeF size() const;
  /// From the upper left corner of `box`, on paper of that colour.
  void paint(QPainter& painter, const QRectF& box, const QColor& color, const QColor& paper) const;

 private:
  QFont symbolFont_, subscriptFont_, plainFont_;
  QString letter_, subscript_, rest_;
};

}  // namespace boxprobe
