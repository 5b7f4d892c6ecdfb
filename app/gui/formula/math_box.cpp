// See math_box.h.
#include "app/gui/formula/math_box.h"

#include <QFont>
#include <QFontMetricsF>
#include <QStringList>
#include <QTransform>
#include <algorithm>

namespace boxprobe {

namespace {

/// Outlines are taken at this size and scaled: large enough that no rounding to pixels shows.
constexpr double kOutlinePixels = 200.0;
constexpr double kAxis = 0.26;  ///< of fraction bars and minus signs over the baseline, in em
constexpr double kRule = 0.055;
constexpr double kFractionGap = 0.16;
constexpr double kScriptRise = 0.38, kScriptDrop = 0.18;
constexpr double kScriptsApart = 0.12;  ///< between a superscript and a subscript of one base
constexpr double kLimitGap = 0.14, kAccentGap = 0.06;

QFont outlineFont(MathFont kind) {
  QFont font;
  font.setFamilies({"DejaVu Serif", "serif"});
  font.setPixelSize(static_cast<int>(kOutlinePixels));
  font.setHintingPreference(QFont::PreferNoHinting);
  font.setItalic(kind == MathFont::Italic || kind == MathFont::BoldItalic);
  font.setBold(kind == MathFont::Bold || kind == MathFont::BoldItalic);
  return font;
}

void place(MathBox& into, const MathBox& box, double x, double y) {
  into.path.addPath(box.path.translated(x, y));
  into.ascent = std::max(into.ascent, box.ascent - y);
  into.descent = std::max(into.descent, box.descent + y);
}

double centred(double width, const MathBox& box) {
  return 0.5 * (width - box.width);
}

}  // namespace

MathBox mathText(const QString& text, MathFont kind, double size) {
  const QFont font = outlineFont(kind);
  QPainterPath path;
  path.addText(0.0, 0.0, font, text);
  const double scale = size / kOutlinePixels;
  MathBox box;
  box.path = QTransform::fromScale(scale, scale).map(path);
  box.path.setFillRule(Qt::WindingFill);  // glyphs made of overlapping parts have no holes
  box.width = QFontMetricsF(font).horizontalAdvance(text) * scale;
  const QRectF ink = box.path.boundingRect();
  box.ascent = std::max(-ink.top(), 0.0);
  box.descent = std::max(ink.bottom(), 0.0);
  if (font.italic()) box.slant = std::max(ink.right() - box.width, 0.0) + 0.04 * size;
  return box;
}

MathBox mathSpace(double width) {
  MathBox box;
  box.width = width;
  return box;
}

void appendBox(MathBox& row, const MathBox& box, double spaceBefore) {
  place(row, box, row.width + spaceBefore, 0.0);
  row.width += spaceBefore + box.width;
  row.slant = box.slant;
}

MathBox mathFraction(const MathBox& numerator, const MathBox& denominator, double size) {
  const double overhang = 0.1 * size;
  MathBox box;
  const double bar = std::max(numerator.width, denominator.width) + 2.0 * overhang;
  box.width = bar + 2.0 * overhang;
  const double gap = (kFractionGap + 0.5 * kRule) * size;
  place(box, numerator, overhang + centred(bar, numerator), -kAxis * size - gap - numerator.descent);
  place(box, denominator, overhang + centred(bar, denominator), -kAxis * size + gap + denominator.ascent);
  box.path.addRect(overhang, -(kAxis + 0.5 * kRule) * size, bar, kRule * size);
  return box;
}

MathBox mathRoot(const MathBox& radicand, const std::optional<MathBox>& degree, double size) {
  const double gap = 0.12 * size, rule = kRule * size;
  const double top = -std::max(radicand.ascent, 0.7 * size) - gap, bottom = radicand.descent + 0.06 * size;
  const double height = bottom - top;
  const double hook = std::min(0.5 * size, 0.28 * size + 0.1 * height);  // the sign's width
  MathBox box;
  double x = 0.0;
  if (degree) {
    x = std::max(degree->width - 0.45 * hook, 0.0);
    place(box, *degree, x + 0.45 * hook - degree->width, bottom - 0.6 * height - degree->descent);
  }
  // A thin upstroke to a thick downstroke, then the long thin rise to the bar.
  const double knee = bottom - 0.45 * height, thick = 1.9 * rule;
  QPainterPath sign;
  sign.moveTo(x, knee + 0.1 * hook);
  sign.lineTo(x + 0.28 * hook, knee - 0.12 * hook);
  sign.lineTo(x + 0.58 * hook, bottom - 2.2 * rule);
  sign.lineTo(x + hook - rule, top - rule);
  sign.lineTo(x + hook + radicand.width + 0.1 * size, top - rule);
  sign.lineTo(x + hook + radicand.width + 0.1 * size, top);
  sign.lineTo(x + hook, top);
  sign.lineTo(x + 0.58 * hook + 0.3 * rule, bottom);
  sign.lineTo(x + 0.58 * hook - 0.5 * rule, bottom);
  sign.lineTo(x + 0.28 * hook - 0.6 * thick, knee + 0.12 * hook);
  sign.lineTo(x + 0.2 * rule, knee + 0.1 * hook + rule);
  sign.closeSubpath();
  box.path.addPath(sign);
  box.ascent = std::max(box.ascent, rule - top);
  box.descent = std::max(box.descent, bottom);
  place(box, radicand, x + hook, 0.0);
  box.width = x + hook + radicand.width + 0.14 * size;
  box.path.setFillRule(Qt::WindingFill);
  return box;
}

MathBox mathScripts(const MathBox& base, const std::optional<MathBox>& below, const std::optional<MathBox>& above,
                    double size) {
  MathBox box = base;
  double rise = 0.0, drop = 0.0;
  if (above) rise = std::max({kScriptRise * size, base.ascent - 0.32 * size, above->descent + 0.25 * size});
  if (below) drop = std::max({kScriptDrop * size, base.descent - 0.02 * size, below->ascent - 0.42 * size});
  if (above && below) {
    const double apart = (rise - above->descent) - (below->ascent - drop);
    drop += std::max(kScriptsApart * size - apart, 0.0);
  }
  const double gap = 0.03 * size;
  double width = base.width;
  if (above) {
    place(box, *above, base.width + base.slant + gap, -rise);
    width = std::max(width, base.width + base.slant + gap + above->width);
  }
  if (below) {
    place(box, *below, base.width + gap, drop);
    width = std::max(width, base.width + gap + below->width);
  }
  box.width = width + gap;
  box.slant = 0.0;
  return box;
}

MathBox mathLimits(const MathBox& base, const std::optional<MathBox>& below, const std::optional<MathBox>& above,
                   double size, bool accent) {
  MathBox box;
  box.width = base.width;
  for (const auto* part : {&below, &above}) {
    if (*part) box.width = std::max(box.width, (*part)->width);
  }
  const double gap = (accent ? kAccentGap : kLimitGap) * size;
  place(box, base, centred(box.width, base), 0.0);
  const double baseAscent = box.ascent, baseDescent = box.descent;
  const double lean = accent ? 0.5 * base.slant + 0.04 * size : 0.0;  // over what leans
  if (above) {
    // The accent's own ink starts well over its baseline: it is put down on to the base.
    const double inkBottom = above->path.boundingRect().bottom();
    place(box, *above, centred(box.width, *above) + lean, -baseAscent - gap - inkBottom);
  }
  if (below) {
    const double inkTop = below->path.boundingRect().top();
    place(box, *below, centred(box.width, *below), baseDescent + gap - inkTop);
  }
  return box;
}

MathBox mathFence(const QString& text, double ascent, double descent, double size) {
  MathBox glyph = mathText(text, MathFont::Upright, size);
  const double reach = std::max(ascent - kAxis * size, descent + kAxis * size) + 0.04 * size;
  const QRectF ink = glyph.path.boundingRect();
  if (2.0 * reach <= ink.height()) return glyph;
  const QTransform stretch = QTransform::fromTranslate(0.0, -ink.center().y()) *
                             QTransform::fromScale(1.0, 2.0 * reach / ink.height()) *
                             QTransform::fromTranslate(0.0, -kAxis * size);
  glyph.path = stretch.map(glyph.path);
  glyph.ascent = reach + kAxis * size;
  glyph.descent = reach - kAxis * size;
  return glyph;
}

MathBox mathTable(const std::vector<std::vector<MathBox>>& rows, double size) {
  std::vector<double> columns;
  for (const auto& row : rows) {
    columns.resize(std::max(columns.size(), row.size()), 0.0);
    for (std::size_t i = 0; i < row.size(); ++i) columns[i] = std::max(columns[i], row[i].width);
  }
  const double columnGap = 0.8 * size, rowGap = 0.35 * size;
  MathBox stacked;  // the first row's top at y = 0
  double y = 0.0;
  for (const auto& row : rows) {
    double ascent = 0.6 * size, descent = 0.15 * size;
    for (const MathBox& cell : row) ascent = std::max(ascent, cell.ascent), descent = std::max(descent, cell.descent);
    double x = 0.0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      place(stacked, row[i], x, y + ascent);
      x += columns[i] + columnGap;
      stacked.width = std::max(stacked.width, x - columnGap);
    }
    y += ascent + descent + rowGap;
  }
  MathBox box;
  box.width = stacked.width;
  const double height = std::max(y - rowGap, 0.0);
  box.path = stacked.path.translated(0.0, -kAxis * size - 0.5 * height);
  box.ascent = 0.5 * height + kAxis * size;
  box.descent = 0.5 * height - kAxis * size;
  return box;
}

}  // namespace boxprobe
