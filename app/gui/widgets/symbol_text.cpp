// See symbol_text.h.
#include "app/gui/widgets/symbol_text.h"

#include <QColor>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QPen>
#include <QRectF>

namespace boxprobe {

namespace {

constexpr double kSymbolSize = 1.15, kSubscriptSize = 0.85;  ///< of the base font
constexpr double kSubscriptDrop = 0.3;                       ///< of the subscript's height
constexpr double kRimPixels = 3.0;

double advance(const QFont& font, const QString& text) {
  return QFontMetricsF(font).horizontalAdvance(text);
}

}  // namespace

SymbolText::SymbolText(const QString& text, const QFont& base)
    : symbolFont_(base), subscriptFont_(base), plainFont_(base) {
  const int underscore = text.indexOf('_');
  const int equals = text.indexOf(" = ");
  const int end = equals >= 0 ? equals : text.size();
  letter_ = text.left(underscore >= 0 ? underscore : end);
  if (underscore >= 0) subscript_ = text.mid(underscore + 1, end - underscore - 1);
  if (equals >= 0) rest_ = text.mid(equals);
  const bool word = letter_.size() > 1 && letter_ == letter_.toLower();
  if (!word) {
    for (QFont* font : {&symbolFont_, &subscriptFont_}) {
      font->setFamily("serif");
      font->setItalic(true);
    }
    symbolFont_.setPointSizeF(base.pointSizeF() * kSymbolSize);
  }
  subscriptFont_.setPointSizeF(base.pointSizeF() * kSubscriptSize);
  letter_.replace(" - ", QString::fromUtf8(" \u2212 "));
}

QSizeF SymbolText::size() const {
  return {advance(symbolFont_, letter_) + advance(subscriptFont_, subscript_) + advance(plainFont_, rest_),
          QFontMetricsF(symbolFont_).height()};
}

void SymbolText::paint(QPainter& painter, const QRectF& box, const QColor& color, const QColor& paper) const {
  const double baseline = box.top() + QFontMetricsF(symbolFont_).ascent();
  double x = box.left();
  const auto piece = [&](const QFont& font, const QString& text, double drop) {
    QPainterPath path;
    path.addText(x, baseline + drop, font, text);
    painter.strokePath(path, QPen(paper, kRimPixels, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, color);
    x += advance(font, text);
  };
  piece(symbolFont_, letter_, 0.0);
  piece(subscriptFont_, subscript_, kSubscriptDrop * QFontMetricsF(subscriptFont_).ascent());
  piece(plainFont_, rest_, 0.0);
}

}  // namespace boxprobe
