// See probe_widget.h.
#include "app/gui/handles/probe_widget.h"

#include <glm/geometric.hpp>
#include <utility>

namespace boxprobe {

namespace {

/// Farther from a handle's centre than its radius: hands shake, and projectors are watched from afar.
constexpr double kReachPixels = 12.0;

/// A press that moves less is a click.
constexpr double kClickPixels = 2.0;

glm::dvec2 toGlm(const QPointF& p) {
  return {p.x(), p.y()};
}

QString metres(double value) {
  return QString::number(value, 'f', 3);
}

QString hintFor(const Handle& handle, const std::vector<Probe>& probes, bool selected) {
  const QString name = QString::fromStdString(probes[handle.probe].name);
  if (handle.kind == HandleKind::Face) {
    return ProbeWidget::tr("Drag to move face %1 of %2. Ctrl: both sides. Esc: cancel.")
        .arg(QString(faceName(handle.face)), name);
  }
  if (!selected) return ProbeWidget::tr("Click to select probe %1.").arg(name);
  return ProbeWidget::tr(
             "Drag to move the capture origin of %1. Shift or Y: up and down. X, Z: along that axis. Esc: cancel.")
      .arg(name);
}

}  // namespace

ProbeWidget::ProbeWidget(Editor& editor, ProbeOverlay& overlay, std::function<ViewProjection()> view, QObject* parent)
    : QObject(parent), editor_(editor), overlay_(overlay), view_(std::move(view)) {}

bool ProbeWidget::press(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  if (dragging()) return true;
  pixel_ = pixel;
  modifiers_ = modifiers;
  hover(pixel);
  if (!hovered_) return false;
  if (editor_.document().selectedProbe() != hovered_->probe) {
    editor_.selectProbe(hovered_->probe);
    return true;
  }
  editor_.finish();
  const Probe* probe = editor_.probe();
  if (!probe) return false;
  pressed_ = pixel;
  const ViewProjection view = view_();
  const Ray ray = view.ray(toGlm(pixel));
  moved_ = previewed_ = false;
  if (hovered_->kind == HandleKind::Face) {
    faceDrag_.emplace(*probe, hovered_->face, view.axes(), ray);
  } else {
    originDrag_.emplace(*probe, view.axes(), ray);
  }
  emit cursorWanted(Qt::ClosedHandCursor);
  return true;
}

void ProbeWidget::move(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  pixel_ = pixel;
  modifiers_ = modifiers;
  if (!dragging()) return hover(pixel);
  if (!moved_ && glm::length(toGlm(pixel - pressed_)) < kClickPixels) return;
  moved_ = true;
  drag();
}

void ProbeWidget::release(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  if (!dragging()) return;
  move(pixel, modifiers);
  if (!dragging()) return;
  endDrag();
  editor_.finish();
  hover(pixel);
}

void ProbeWidget::leave() {
  if (dragging() || !hovered_) return;
  hovered_.reset();
  update();
  emit hint({});
}

void ProbeWidget::setHeldAxis(std::optional<int> axis) {
  heldAxis_ = axis;
  if (dragging() && moved_) drag();
}

void ProbeWidget::cancel() {
  if (!dragging()) return;
  endDrag();
  editor_.cancel();
  hover(pixel_);
}

void ProbeWidget::hover(const QPointF& pixel) {
  const auto& probes = editor_.scene().probes;
  const auto selected = editor_.document().selectedProbe();
  const auto under =
      overlay_.visible() ? handleAt(probes, selected, view_(), toGlm(pixel), kReachPixels) : std::optional<Handle>();
  emit cursorWanted(!under                                  ? Qt::ArrowCursor
                    : under->kind == HandleKind::Face       ? Qt::OpenHandCursor
                    : selected && *selected == under->probe ? Qt::SizeAllCursor
                                                            : Qt::PointingHandCursor);
  if (under == hovered_) return;
  hovered_ = under;
  emit hint(under ? hintFor(*under, probes, selected == under->probe) : QString());
  update();
}

void ProbeWidget::drag() {
  const Ray ray = view_().ray(toGlm(pixel_));
  if (faceDrag_) dragFace(ray);
  if (originDrag_) dragOrigin(ray);
}

void ProbeWidget::dragFace(const Ray& ray) {
  const Probe* probe = editor_.probe();
  if (!probe) return cancel();
  const Box box = faceDrag_->box(ray, modifiers_.testFlag(Qt::ControlModifier));
  const QString face = faceName(faceDrag_->face());
  previewed_ = true;
  editor_.previewProbe({this, 1 + 2 * faceDrag_->face().axis + (faceDrag_->face().positive ? 1 : 0)},
                       tr("Move face %1 of %2").arg(face, QString::fromStdString(probe->name)),
                       [box](Probe& edited) { setBox(edited, box); });
  const glm::dvec3 size = box.size();
  const int axis = faceDrag_->face().axis;
  const double position = faceDrag_->face().positive ? box.max[axis] : box.min[axis];
  emit readout(
      tr("%1  %2 m\nsize %3 × %4 × %5 m").arg(face, metres(position), metres(size.x), metres(size.y), metres(size.z)),
      pixel_);
}

void ProbeWidget::dragOrigin(const Ray& ray) {
  const Probe* probe = editor_.probe();
  if (!probe) return cancel();
  previewed_ = true;
  std::optional<int> axis = heldAxis_;
  if (!axis && modifiers_.testFlag(Qt::ShiftModifier)) axis = 1;
  const glm::dvec3 origin = originDrag_->origin(ray, axis);
  editor_.previewProbe({this}, tr("Move origin of %1").arg(QString::fromStdString(probe->name)),
                       [origin](Probe& edited) { edited.origin = origin; });
  emit readout(tr("origin\n%1  %2  %3 m").arg(metres(origin.x), metres(origin.y), metres(origin.z)), pixel_);
}

void ProbeWidget::endDrag() {
  faceDrag_.reset();
  originDrag_.reset();
  emit readout({}, {});
}

void ProbeWidget::update() {
  const auto& probes = editor_.scene().probes;
  if (hovered_ && hovered_->probe >= probes.size()) hovered_.reset();
  // Undone or replaced from elsewhere while the button was down: the drag has nothing left to move.
  if (dragging() && previewed_ && !editor_.document().previewing()) endDrag();
  overlay_.update(probes, editor_.document().selectedProbe(), hovered_);
  emit pictureChanged();
}

void ProbeWidget::setVisible(bool visible) {
  if (!visible) cancel();
  overlay_.setVisible(visible);
  hovered_.reset();
  update();
}

}  // namespace boxprobe
