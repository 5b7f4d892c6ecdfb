// See tool_icons.h.
#include "app/gui/widgets/tool_icons.h"

#include <QIconEngine>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>

#include "app/gui/widgets/axis_colors.h"

namespace boxprobe {

namespace {

/// In a square of 24 units.
class Engine : public QIconEngine {
 public:
  explicit Engine(ToolIcon icon) : icon_(icon) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (mode == QIcon::Disabled) painter->setOpacity(0.4);
    const double scale = std::min(rect.width(), rect.height()) / 24.0;
    painter->translate(rect.center() + QPointF(0.5, 0.5));
    painter->scale(scale, scale);
    draw(*painter);
    painter->restore();
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return picture;
  }
  QIconEngine* clone() const override { return new Engine(icon_); }

 private:
  static void knob(QPainter& p, const QPointF& at, const QColor& color) {
    p.setPen(QPen(haloColor(), 0.8));
    p.setBrush(color);
    p.drawEllipse(at, 2.6, 2.6);
  }
  static void arrow(QPainter& p, const QPointF& to, const QColor& color) {
    p.setPen(QPen(color, 2.0));
    p.drawLine(QPointF(0.0, 0.0), to * 0.7);
    p.setPen(Qt::NoPen);
    p.setBrush(color);
    const QPointF across(-to.y() * 0.25, to.x() * 0.25);
    p.drawPolygon(QPolygonF({to, to * 0.6 + across, to * 0.6 - across}));
  }

  void draw(QPainter& p) const {
    const QRectF square(-8.0, -8.0, 16.0, 16.0);
    p.setBrush(Qt::NoBrush);
    switch (icon_) {
      case ToolIcon::Box:
        p.setPen(QPen(boxColor(), 1.8));
        p.drawRect(square);
        knob(p, {8.0, 0.0}, axisColor(0));
        knob(p, {0.0, -8.0}, axisColor(1));
        break;
      case ToolIcon::Influence:
        p.setPen(QPen(influenceColor(), 1.8));
        p.drawRect(square.adjusted(-1.0, -1.0, 1.0, 1.0));
        p.setPen(QPen(blendColor(), 1.5, Qt::DashLine));
        p.drawRect(square.adjusted(4.0, 4.0, -4.0, -4.0));
        break;
      case ToolIcon::Origin:
        p.setPen(QPen(haloColor(), 0.8));
        p.setBrush(originColor());
        p.drawPolygon(QPolygonF({{0.0, -8.5}, {6.5, 0.0}, {0.0, 8.5}, {-6.5, 0.0}}));
        break;
      case ToolIcon::Place:
        arrow(p, {10.0, 0.0}, axisColor(0));
        arrow(p, {0.0, -10.0}, axisColor(1));
        p.setBrush(Qt::NoBrush);
        p.setPen(QPen(axisColor(2), 1.6));
        p.drawArc(square, 190 * 16, 70 * 16);
        break;
    }
  }

  ToolIcon icon_;
};

}  // namespace

QIcon toolIcon(ToolIcon icon) {
  return QIcon(new Engine(icon));
}

}  // namespace boxprobe
