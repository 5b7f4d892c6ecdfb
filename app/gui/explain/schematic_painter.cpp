// See schematic_painter.h.
#include "app/gui/explain/schematic_painter.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <QStaticText>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "app/gui/explain/explanation_html.h"
#include "app/gui/widgets/phrase_words.h"
#include "app/gui/widgets/symbol_text.h"

namespace boxprobe {

namespace {

const QColor kPaper(18, 20, 24, 232);
const QColor kRim(18, 20, 24);  ///< the paper without what shines through
const QColor kInk(236, 238, 240);
const QColor kDim(150, 156, 165);
const QColor kBox(176, 182, 192);
const QColor kDecides(255, 104, 84);
constexpr double kVectorPixels = 40.0;  ///< N, V and R are directions: drawn as long as reads well
constexpr double kArrowPixels = 9.0;
constexpr double kDotPixels = 4.0;
constexpr double kMargin = 26.0;  ///< around a drawing, for labels
constexpr double kInsetPadding = 17.0;

/// The colours that the lines have in the picture (filters/vtk/rays/ray_colors.cpp).
QColor colorOf(SchematicLine kind) {
  switch (kind) {
    case SchematicLine::Eye:
      return {115, 199, 255};
    case SchematicLine::Normal:
      return {51, 217, 158};
    case SchematicLine::Reflected:
      return {255, 166, 26};
    case SchematicLine::Lookup:
      return {230, 140, 204};
    case SchematicLine::TrueHit:
      return {255, 255, 255};
    case SchematicLine::Slab:
      return {255, 166, 26, 150};
  }
  return kInk;
}

QPen pen(const QColor& color, double width, Qt::PenStyle style = Qt::SolidLine) {
  QPen made(color, width, style, Qt::RoundCap, Qt::RoundJoin);
  return made;
}

double length(const QPointF& v) {
  return std::hypot(v.x(), v.y());
}

class ViewPainter {
 public:
  /// `inset`: small, without axes, the rays as lines with heads.
  ViewPainter(QPainter& painter, const QRectF& area, const SchematicView& view, double pixelsPerUnit,
              bool inset = false)
      : painter_(painter), area_(area), view_(view), scale_(pixelsPerUnit), inset_(inset) {
    const glm::dvec2 middle = 0.5 * (view.low + view.high);
    offset_ = area.center() - QPointF(middle.x * scale_, -middle.y * scale_);
  }

  void paint() {
    painter_.save();
    painter_.setClipRect(area_);
    paintBox();
    for (const auto& line : view_.lines) paintLine(line);
    paintPoints();
    // After all lines, so that none runs across a letter; points' names first: they have the least choice.
    std::stable_sort(labels_.begin(), labels_.end(), [](const Label& a, const Label& b) { return a.rank < b.rank; });
    for (const Label& label : labels_) place(label);
    painter_.restore();
    if (!inset_) paintAxes();
  }

 private:
  struct Label {
    QString text;
    QPointF anchor, direction;
    QColor color;
    int rank = 0;
  };
  static constexpr int kPointRank = 0, kPlaneRank = 1, kLineRank = 2, kOptionalRank = 3;

  QPointF at(const glm::dvec2& p) const { return offset_ + QPointF(p.x * scale_, -p.y * scale_); }

  void paintBox() {
    painter_.setBrush(QColor(255, 255, 255, 14));
    painter_.setPen(pen(view_.boxUsed ? kBox : kDim, 1.4, view_.boxUsed ? Qt::SolidLine : Qt::DashLine));
    if (view_.boxLow) painter_.drawRect(QRectF(at(*view_.boxLow), at(*view_.boxHigh)).normalized());
    for (const auto& plane : view_.planes) {
      if (plane.smallest) {
        painter_.setPen(pen(kDecides, 4.0));
        painter_.drawLine(at(plane.from), at(plane.to));
        continue;
      }
      // The other plane goes on beyond the box: the ray meets it there.
      painter_.setPen(pen(kDim, 1.0, Qt::DashLine));
      const QPointF crossing = at(plane.crossing);
      const QPointF a = at(plane.from), b = at(plane.to);
      painter_.drawLine(length(crossing - a) < length(crossing - b) ? a : b, crossing);
    }
  }

  void arrowHead(const QPointF& tip, const QPointF& direction, const QColor& color) {
    const QPointF back = tip - kArrowPixels * direction;
    const QPointF side = 0.42 * kArrowPixels * QPointF(-direction.y(), direction.x());
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(color);
    painter_.drawPolygon(QPolygonF({tip, back + side, back - side}));
  }

  /// A unit vector at P: as long as its foreshortening on this view; towards the reader, a dot in a ring.
  void paintVector(const QPointF& from, const QPointF& direction, double foreshortening, const QColor& color,
                   const QString& label) {
    constexpr double kEndOn = 0.12;
    if (foreshortening < kEndOn) {
      painter_.setPen(pen(color, 1.8));
      painter_.setBrush(Qt::NoBrush);
      painter_.drawEllipse(from, 2.2 * kDotPixels, 2.2 * kDotPixels);
      labels_.push_back({label, from + QPointF(-1.6 * kDotPixels, -1.6 * kDotPixels), {-0.7, -0.7}, color, kLineRank});
      return;
    }
    const QPointF tip = from + kVectorPixels * std::max(foreshortening, 0.35) * direction;
    painter_.setPen(pen(color, 2.8));
    painter_.drawLine(from, tip - 0.6 * kArrowPixels * direction);
    arrowHead(tip, direction, color);
    labels_.push_back({label, tip, QPointF(-direction.y(), direction.x()), color, kLineRank});
  }

  void paintLine(const SchematicView::Line& line) {
    const QPointF from = at(line.from), to = at(line.to);
    const double pixels = length(to - from);
    const QPointF direction = pixels > 0.0 ? (to - from) / pixels : QPointF();
    const QColor color = colorOf(line.kind);
    if (inset_ && line.kind != SchematicLine::TrueHit) {
      const bool eye = line.kind == SchematicLine::Eye;
      painter_.setPen(pen(color, eye ? 1.4 : 2.2));
      painter_.drawLine(from, eye || pixels < kArrowPixels ? to : to - 0.6 * kArrowPixels * direction);
      if (!eye && pixels > kArrowPixels) arrowHead(to, direction, color);
      if (pixels > 2.0 * kArrowPixels) {
        labels_.push_back({QString::fromStdString(line.label), 0.5 * (from + to),
                           QPointF(direction.y(), -direction.x()), color,
                           line.kind == SchematicLine::Lookup ? kOptionalRank : kLineRank});
      }
      return;
    }
    switch (line.kind) {
      case SchematicLine::Slab:
        painter_.setPen(pen(color, 1.2, Qt::DotLine));
        painter_.drawLine(from, to);
        break;
      case SchematicLine::TrueHit:
        painter_.setPen(pen(color, 2.0, Qt::DashLine));
        painter_.drawLine(from, to);
        break;
      case SchematicLine::Normal:
        paintVector(from, direction, line.foreshortening, color, "N");
        break;
      case SchematicLine::Eye:
        painter_.setPen(pen(color, 1.3));
        painter_.drawLine(from, to);
        paintVector(to, -direction, line.foreshortening, color, "V");
        break;
      case SchematicLine::Reflected:
        painter_.setPen(pen(color, 1.6));
        painter_.drawLine(from, to);
        paintVector(from, direction, line.foreshortening, color, "R");
        if (line.label == "d" && pixels > 2.2 * kVectorPixels) {
          labels_.push_back({"d", from + 0.68 * (to - from), QPointF(direction.y(), -direction.x()), color, kLineRank});
        }
        break;
      case SchematicLine::Lookup:
        painter_.setPen(pen(color, 2.2));
        painter_.drawLine(from, to - 0.6 * kArrowPixels * direction);
        if (pixels > kArrowPixels) arrowHead(to, direction, color);
        if (pixels > kVectorPixels) {
          labels_.push_back({QString::fromStdString(line.label), from + 0.45 * (to - from),
                             QPointF(direction.y(), -direction.x()), color, kLineRank});
        }
        break;
    }
  }

  void paintPoints() {
    for (const auto& point : view_.points) {
      QPointF pixel = at(point.at);
      QColor color = kInk;
      if (point.kind == SchematicPoint::Origin) color = colorOf(SchematicLine::Lookup);
      if (point.kind == SchematicPoint::Hit) color = kDecides;
      if (point.kind == SchematicPoint::TrueHit) color = colorOf(SchematicLine::TrueHit);
      if (point.kind == SchematicPoint::SlabPlane) color = kDim;
      if (point.kind == SchematicPoint::Eye) {
        paintEye(pixel);
        continue;
      }
      painter_.setPen(pen(kRim, 1.0));
      painter_.setBrush(color);
      const double size = point.kind == SchematicPoint::SlabPlane ? 0.7 * kDotPixels : kDotPixels;
      painter_.drawEllipse(pixel, size, size);
      occupied_.push_back({pixel.x() - size, pixel.y() - size, 2.0 * size, 2.0 * size});
      if (!area_.contains(pixel)) continue;
      labels_.push_back(
          {phraseWords(point.label), pixel, {point.labelDirection.x, -point.labelDirection.y}, color, kPointRank});
    }
    for (const auto& plane : view_.planes) {
      if (!plane.smallest) continue;
      const QPointF middle = 0.5 * (at(plane.from) + at(plane.to));
      // Outside the box, where nothing else is drawn.
      const QPointF outwards = middle - QRectF(at(*view_.boxLow), at(*view_.boxHigh)).center();
      labels_.push_back({QString::fromStdString(plane.label), middle, outwards / std::max(length(outwards), 1.0),
                         kDecides, kPlaneRank});
    }
  }

  /// The eye itself where the drawing has room for it; else where its ray comes in.
  void paintEye(const QPointF& eye) {
    constexpr double kInset = 12.0;
    const QRectF room = area_.adjusted(kInset, kInset, -kInset, -kInset);
    if (room.contains(eye)) {
      painter_.setPen(pen(kInk, 1.6));
      painter_.setBrush(Qt::NoBrush);
      painter_.drawEllipse(eye, 9.0, 5.0);
      painter_.setBrush(kInk);
      painter_.drawEllipse(eye, 2.2, 2.2);
      return;
    }
    const auto p = std::find_if(view_.points.begin(), view_.points.end(),
                                [](const auto& point) { return point.kind == SchematicPoint::Shading; });
    if (p == view_.points.end()) return;
    const QPointF from = at(p->at), step = eye - from;
    double t = 1.0;
    const auto limit = [&t](double origin, double delta, double low, double high) {
      if (delta > 0.0) t = std::min(t, (high - origin) / delta);
      if (delta < 0.0) t = std::min(t, (low - origin) / delta);
    };
    limit(from.x(), step.x(), room.left(), room.right());
    limit(from.y(), step.y(), room.top(), room.bottom());
    const QPointF entry = from + std::max(t, 0.0) * step;
    labels_.push_back({QCoreApplication::translate("SchematicPainter", "from the eye"), entry,
                       -step / std::max(length(step), 1.0), kDim, kOptionalRank});
  }

  /// Beside its anchor, towards its direction if that is free; else the nearest of the directions around that is.
  void place(const Label& label) {
    if (label.text.isEmpty()) return;
    const SymbolText symbol(label.text, painter_.font());
    const QSizeF size = symbol.size();
    const double wanted = std::atan2(label.direction.y(), label.direction.x());
    constexpr double kGap = 7.0;
    QRectF best;
    bool placed = false;
    for (const double turn : {0.0, 0.7, -0.7, 1.4, -1.4, 2.2, -2.2, 3.14}) {
      const QPointF towards(std::cos(wanted + turn), std::sin(wanted + turn));
      const QPointF middle = label.anchor + QPointF(towards.x() * (0.5 * size.width() + kGap),
                                                    towards.y() * (0.35 * size.height() + kGap));
      const QRectF box(middle.x() - 0.5 * size.width(), middle.y() - 0.5 * size.height(), size.width(), size.height());
      const QRectF letters = box.adjusted(0.0, 0.2 * size.height(), 0.0, -0.2 * size.height());
      const bool free =
          area_.contains(box) && std::none_of(occupied_.begin(), occupied_.end(),
                                              [&](const QRectF& other) { return other.intersects(letters); });
      if (best.isNull() || free) best = box;
      placed = placed || free;
      if (free) break;
    }
    if (!placed && label.rank == kOptionalRank) return;
    // Nothing leaves the drawing, even where everything is taken.
    best.moveLeft(std::clamp(best.left(), area_.left(), std::max(area_.right() - size.width(), area_.left())));
    best.moveTop(std::clamp(best.top(), area_.top(), std::max(area_.bottom() - size.height(), area_.top())));
    occupied_.push_back(best.adjusted(0.0, 0.2 * size.height(), 0.0, -0.2 * size.height()));
    symbol.paint(painter_, best, label.color, kRim);
  }

  void paintAxes() {
    constexpr double kAxisPixels = 20.0;
    static const std::array<const char*, 3> names = {"x", "y", "z"};
    QPointF corner = area_.bottomLeft() + QPointF(14.0, -14.0);
    if (view_.upFlipped) corner.ry() -= kAxisPixels;
    const auto axis = [&](const QPointF& direction, const QString& name) {
      painter_.setPen(pen(kDim, 1.3));
      painter_.drawLine(corner, corner + kAxisPixels * direction);
      arrowHead(corner + kAxisPixels * direction, direction, kDim);
      const SymbolText symbol(name, painter_.font());
      const QPointF middle = corner + QPointF((kAxisPixels + 9.0) * direction.x(), (kAxisPixels + 9.0) * direction.y());
      const QSizeF size = symbol.size();
      symbol.paint(painter_, {middle.x() - 0.5 * size.width(), middle.y() - 0.5 * size.height(), 1.0, 1.0}, kDim, kRim);
    };
    const QString right = names[static_cast<std::size_t>(view_.right)];
    axis({1.0, 0.0}, view_.rightFlipped ? QString::fromUtf8("\u2212") + right : right);
    axis({0.0, view_.upFlipped ? 1.0 : -1.0}, names[static_cast<std::size_t>(view_.up)]);
  }

  QPainter& painter_;
  QRectF area_;
  const SchematicView& view_;
  double scale_;
  bool inset_;
  QPointF offset_;
  std::vector<Label> labels_;
  std::vector<QRectF> occupied_;  ///< by points and by labels placed
};

double fittingScale(const SchematicView& view, const QSizeF& area, double margin = kMargin) {
  const glm::dvec2 extent = view.high - view.low;
  const double smallest = 1e-9;
  return std::min((area.width() - 2.0 * margin) / std::max(extent.x, smallest),
                  (area.height() - 2.0 * margin) / std::max(extent.y, smallest));
}

void paintPaper(QPainter& painter, const QRectF& area) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kPaper);
  painter.drawRoundedRect(area, 6.0, 6.0);
}

/// Of an inset, for its one line of words, beyond the padding that a drawing has anyway.
double headHeight(const QPainter& painter) {
  return QFontMetricsF(painter.font()).height() - 0.5 * kInsetPadding;
}

}  // namespace

QSizeF insetSize(const QPainter& painter, const SchematicView& view, const QSizeF& most) {
  const QSizeF room = most - QSizeF(0.0, headHeight(painter));
  const double scale = fittingScale(view, room, kInsetPadding);
  const glm::dvec2 drawn = scale * (view.high - view.low) + 2.0 * kInsetPadding;
  constexpr double kWords = 96.0;
  return {std::clamp(drawn.x, std::min(kWords, most.width()), most.width()), drawn.y + headHeight(painter)};
}

void paintInset(QPainter& painter, const QRectF& area, const SchematicView& view, const QString& words) {
  paintPaper(painter, area);
  const double head = headHeight(painter);
  const QRectF inner = area.adjusted(0.0, head, 0.0, 0.0);
  ViewPainter(painter, inner, view, fittingScale(view, inner.size(), kInsetPadding), true).paint();
  painter.setPen(kInk);
  painter.drawText(QPointF(area.left() + 6.0, area.top() + 2.0 + QFontMetricsF(painter.font()).ascent()), words);
}

void paintSchematic(QPainter& painter, const QRectF& area, const Schematic& schematic) {
  paintPaper(painter, area);
  const double line = QFontMetricsF(painter.font()).height();
  const QRectF inner = area.adjusted(6.0, line + 6.0, -6.0, -line - 8.0);
  const QRectF left(inner.left(), inner.top(), 0.5 * inner.width() - 3.0, inner.height());
  const QRectF right(inner.center().x() + 3.0, inner.top(), 0.5 * inner.width() - 3.0, inner.height());
  // One scale for both, as technical drawings have it.
  const double scale =
      std::min(fittingScale(schematic.plan, left.size()), fittingScale(schematic.elevation, right.size()));
  ViewPainter(painter, left, schematic.plan, scale).paint();
  ViewPainter(painter, right, schematic.elevation, scale).paint();
  painter.setPen(pen(QColor(255, 255, 255, 40), 1.0));
  painter.drawLine(QPointF(inner.center().x(), area.top() + 6.0), QPointF(inner.center().x(), inner.bottom()));
  painter.setPen(kInk);
  const auto title = [&](const QRectF& view, const Phrase& text) {
    painter.drawText(QRectF(view.left() + 4.0, area.top() + 4.0, view.width(), line), Qt::AlignLeft, phraseWords(text));
  };
  title(left, schematic.plan.title);
  title(right, schematic.elevation.title);
  QStaticText caption("<span style=\"color:" + kDecides.name() + "\">" + formulaHtml(phraseWords(schematic.caption)) +
                      "</span>");
  caption.setTextFormat(Qt::RichText);
  caption.setTextWidth(area.width());
  painter.drawStaticText(QPointF(area.left() + 10.0, area.bottom() - line - 6.0), caption);
}

}  // namespace boxprobe
