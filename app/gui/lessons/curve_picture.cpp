// See curve_picture.h.
#include "app/gui/lessons/curve_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/lessons/lesson_measure.h"
#include "filters/core/base/number_text.h"

namespace boxprobe {

namespace {

const QColor kInk("#1d2126"), kRule("#d4dae1"), kMeasured("#a2267a"), kCost("#0b6fa8"), kLine("#5d6670");
constexpr int kLetters = 17;  // pixels: read from the last row, and on a sheet at half size
constexpr int kTicks = 4;

/// 1, 2 or 5 times a power of ten, so that kTicks of them reach the largest value.
double tickFor(double largest) {
  if (!(largest > 0.0)) return 1.0;
  const double least = largest / kTicks, power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

QString textOf(const std::string& line) {
  return QString::fromStdString(line);
}

class Chart {
 public:
  Chart(QPainter& painter, const QRectF& area, std::size_t values) : painter_(painter), area_(area), values_(values) {}

  QPointF at(std::size_t value, double height, double tick) const {
    const double x = area_.left() + area_.width() * static_cast<double>(value) / static_cast<double>(values_ - 1);
    return {x, area_.bottom() - area_.height() * height / (kTicks * tick)};
  }

  void rules() const {
    painter_.setPen(QPen(kRule, 1.5));
    for (int i = 0; i <= kTicks; ++i) {
      const double y = area_.bottom() - area_.height() * i / kTicks;
      painter_.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
    }
  }

  void numbers(double tick, const QColor& color, bool right) const {
    painter_.setPen(color);
    for (int i = 0; i <= kTicks; ++i) {
      const double y = area_.bottom() - area_.height() * i / kTicks;
      const QRectF box(right ? area_.right() + 10 : 0, y - 12, right ? 60 : area_.left() - 10, 24);
      painter_.drawText(box, Qt::AlignVCenter | (right ? Qt::AlignLeft : Qt::AlignRight),
                        textOf(measuredText(i * tick, "")));
    }
  }

  void curve(const std::vector<double>& heights, double tick, const QColor& color, Qt::PenStyle style) const {
    QPainterPath path;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const QPointF point = at(i, heights[i], tick);
      i == 0 ? path.moveTo(point) : path.lineTo(point);
    }
    painter_.setPen(QPen(color, 3, style));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPath(path);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(color);
    for (std::size_t i = 0; i < heights.size(); ++i) painter_.drawEllipse(at(i, heights[i], tick), 5, 5);
  }

  void level(double height, double tick, const std::string& name) const {
    const double y = at(0, height, tick).y();
    painter_.setPen(QPen(kLine, 2, Qt::DashLine));
    painter_.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
    painter_.drawText(QRectF(area_.left(), y - 26, area_.width() - 6, 24), Qt::AlignRight | Qt::AlignBottom,
                      textOf(name));
  }

 private:
  QPainter& painter_;
  QRectF area_;
  std::size_t values_;
};

double largestOf(const std::vector<double>& values, double least = 0.0) {
  return std::max(least, *std::max_element(values.begin(), values.end()));
}

}  // namespace

QImage curvePicture(const LessonCurve& curve, const CurvePoints& points, int width, int height) {
  QImage picture(width, height, QImage::Format_RGB888);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  QFont font("DejaVu Sans");
  font.setPixelSize(kLetters);
  painter.setFont(font);
  const QRectF area(74, 46, width - (curve.cost ? 138 : 92), height - 46 - 62);
  const Chart chart(painter, area, curve.values.size());
  chart.rules();
  const double tick = tickFor(largestOf(points.measured, points.line.value_or(0.0)));
  chart.numbers(tick, kMeasured, false);
  if (points.line) chart.level(*points.line, tick, curve.lineName);
  if (!points.costs.empty()) {
    const double costTick = tickFor(largestOf(points.costs));
    chart.numbers(costTick, kCost, true);
    chart.curve(points.costs, costTick, kCost, Qt::DotLine);
    painter.setPen(kCost);
    painter.drawText(QRectF(0.5 * width, 8, 0.5 * width - 12, 26), Qt::AlignRight, textOf(curve.costName));
  }
  chart.curve(points.measured, tick, kMeasured, Qt::SolidLine);
  painter.setPen(kMeasured);
  painter.drawText(QRectF(12, 8, 0.5 * width, 26), Qt::AlignLeft, textOf(curve.measureName));
  painter.setPen(kInk);
  for (std::size_t i = 0; i < curve.values.size(); ++i) {
    const QPointF foot = chart.at(i, 0.0, 1.0);
    painter.drawText(QRectF(foot.x() - 30, foot.y() + 6, 60, 24), Qt::AlignHCenter,
                     textOf(numberText(curve.values[i])));
  }
  painter.drawText(QRectF(area.left(), height - 32, area.width(), 26), Qt::AlignHCenter, textOf(curve.fieldName));
  return picture;
}

std::string curveSvg(const LessonCurve& curve, const CurvePoints& points, const std::string& title) {
  constexpr double kWidth = 640.0, kHeight = 400.0, kTop = 46.0;
  const double left = 74.0, right = kWidth - (curve.cost ? 64.0 : 18.0), bottom = kHeight - 62.0;
  const auto escaped = [](const std::string& text) { return textOf(text).toHtmlEscaped().toStdString(); };
  const auto short_ = [](double value) { return QString::number(value, 'f', 1).toStdString(); };
  const auto across = [&](std::size_t value) {
    return left + (right - left) * static_cast<double>(value) / static_cast<double>(curve.values.size() - 1);
  };
  const auto height = [&](double value, double tick) { return bottom - (bottom - kTop) * value / (kTicks * tick); };
  std::string svg = "<svg class=\"chart\" viewBox=\"0 0 640 400\" role=\"img\" aria-label=\"" + escaped(title) + "\">";
  const auto text = [&](double x, double y, const char* anchor, const std::string& kind, const std::string& words) {
    svg += "<text x=\"" + short_(x) + "\" y=\"" + short_(y) + "\" text-anchor=\"" + anchor + "\" class=\"" + kind +
           "\">" + escaped(words) + "</text>";
  };
  const auto line = [&](double y, const char* kind) {
    svg += "<path class=\"" + std::string(kind) + "\" d=\"M" + short_(left) + " " + short_(y) + "H" + short_(right) +
           "\"/>";
  };
  const auto graph = [&](const std::vector<double>& values, double tick, const std::string& kind) {
    std::string way, dots;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string x = short_(across(i)), y = short_(height(values[i], tick));
      way += (i == 0 ? "M" : "L") + x + " " + y;
      dots += "<circle class=\"" + kind + "\" cx=\"" + x + "\" cy=\"" + y + "\" r=\"5\"/>";
    }
    svg += "<path class=\"graph " + kind + "\" d=\"" + way + "\"/>" + dots;
  };
  const auto numbers = [&](double tick, double x, const char* anchor, const char* kind) {
    for (int i = 0; i <= kTicks; ++i) text(x, height(i * tick, tick) + 6.0, anchor, kind, measuredText(i * tick, ""));
  };
  const double tick = tickFor(largestOf(points.measured, points.line.value_or(0.0)));
  for (int i = 0; i <= kTicks; ++i) line(height(i * tick, tick), "rule");
  numbers(tick, left - 10.0, "end", "measure");
  if (points.line) {
    line(height(*points.line, tick), "level");
    text(right - 6.0, height(*points.line, tick) - 8.0, "end", "level", curve.lineName);
  }
  if (!points.costs.empty()) {
    const double costTick = tickFor(largestOf(points.costs));
    numbers(costTick, right + 10.0, "start", "cost");
    graph(points.costs, costTick, "cost");
    text(kWidth - 12.0, 26.0, "end", "cost", curve.costName);
  }
  graph(points.measured, tick, "measure");
  text(12.0, 26.0, "start", "measure", curve.measureName);
  for (std::size_t i = 0; i < curve.values.size(); ++i) {
    text(across(i), bottom + 24.0, "middle", "value", numberText(curve.values[i]));
  }
  text(0.5 * (left + right), kHeight - 12.0, "middle", "value", curve.fieldName);
  return svg + "</svg>";
}

}  // namespace boxprobe
