// See axis_gizmo.h.
#include "app/gui/view/axis_gizmo.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <glm/geometric.hpp>

#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/view_commands.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/axis_colors.h"
#include "app/gui/widgets/pointer_place.h"

namespace boxprobe {

namespace {

constexpr int kSide = 86;  ///< logical pixels
constexpr double kArm = 31.0, kKnob = 9.0, kHollowKnob = 6.5;

}  // namespace

AxisGizmo::AxisGizmo(Workspace& workspace) : QWidget(&workspace.viewport()), workspace_(workspace) {
  setObjectName("axisGizmo");
  setFixedSize(kSide, kSide);
  setMouseTracking(true);
  setCursor(Qt::PointingHandCursor);
  setToolTip(tr("Click an axis to look along it"));
  workspace.viewport().installEventFilter(this);
  connect(&workspace.scheduler(), &RenderScheduler::rendered, this, QOverload<>::of(&QWidget::update));
  place();
}

std::array<glm::dvec3, 6> AxisGizmo::directions() const {
  const ViewProjection view = workspace_.viewport().view();
  const ViewAxes axes = view.axes();
  std::array<glm::dvec3, 6> all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    glm::dvec3 world(0.0);
    world[kBoxFaces[i].axis] = kBoxFaces[i].sign();
    all[i] = {glm::dot(world, view.right()), glm::dot(world, axes.up), -glm::dot(world, axes.forward)};
  }
  return all;
}

QPointF AxisGizmo::knob(const BoxFace& face) const {
  const glm::dvec3 d = directions()[static_cast<std::size_t>(face.index())];
  return QPointF(0.5 * kSide + kArm * d.x, 0.5 * kSide - kArm * d.y);
}

std::optional<BoxFace> AxisGizmo::at(const QPointF& place) const {
  std::optional<BoxFace> best;
  double nearest = -2.0;
  const auto all = directions();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const QPointF off = knob(kBoxFaces[i]) - place;
    if (QPointF::dotProduct(off, off) > kKnob * kKnob || all[i].z < nearest) continue;
    best = kBoxFaces[i];
    nearest = all[i].z;
  }
  return best;
}

void AxisGizmo::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (hovered_) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(16, 18, 22, 110));
    painter.drawEllipse(rect());
  }
  const auto all = directions();
  std::array<std::size_t, 6> order{0, 1, 2, 3, 4, 5};
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return all[a].z < all[b].z; });
  QFont font = painter.font();
  font.setBold(true);
  font.setPixelSize(11);
  painter.setFont(font);
  for (const std::size_t i : order) {
    const BoxFace& face = kBoxFaces[i];
    QColor color = axisColor(face.axis);
    if (hovered_ && *hovered_ == face) color = color.lighter(140);
    const QPointF to = knob(face);
    if (face.positive) {
      painter.setPen(QPen(color, 2.2));
      painter.drawLine(QPointF(0.5 * kSide, 0.5 * kSide), to);
    }
    painter.setPen(QPen(face.positive ? haloColor() : color, face.positive ? 1.0 : 1.6));
    painter.setBrush(face.positive ? color : QColor(16, 18, 22, 170));
    const double radius = face.positive ? kKnob : kHollowKnob;
    painter.drawEllipse(to, radius, radius);
    if (!face.positive) continue;
    painter.setPen(haloColor());
    painter.drawText(QRectF(to.x() - kKnob, to.y() - kKnob, 2.0 * kKnob, 2.0 * kKnob), Qt::AlignCenter,
                     QString("XYZ"[face.axis]));
  }
}

void AxisGizmo::mousePressEvent(QMouseEvent* event) {
  event->accept();
  if (event->button() != Qt::LeftButton) return;
  if (const auto face = at(pointerPlace(*event))) workspace_.views().lookAlong(*face);
}

void AxisGizmo::mouseMoveEvent(QMouseEvent* event) {
  hovered_ = at(pointerPlace(*event));
  update();
}

void AxisGizmo::leaveEvent(QEvent* event) {
  hovered_.reset();
  update();
  QWidget::leaveEvent(event);
}

void AxisGizmo::place() {
  constexpr int kMargin = 6;
  move(parentWidget()->width() - width() - kMargin, kMargin);
}

bool AxisGizmo::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) place();
  return QWidget::eventFilter(watched, event);
}

}  // namespace boxprobe
