// See probe_widget.h.
#include "app/gui/handles/probe_widget.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <utility>

#include "app/gui/handles/handle_words.h"

namespace boxprobe {

namespace {

/// Farther from a handle's centre than its radius: hands shake, and projectors are watched from afar.
constexpr double kReachPixels = 12.0;

/// A press that moves less is a click.
constexpr double kClickPixels = 2.0;

constexpr double kFine = 0.1;                      ///< with Shift
constexpr double kNudge = 0.1, kFineNudge = 0.01;  ///< scene units

glm::dvec2 toGlm(const QPointF& p) {
  return {p.x(), p.y()};
}

bool isFace(const Handle& handle) {
  return handle.kind == HandleKind::Face || handle.kind == HandleKind::Influence || handle.kind == HandleKind::Blend;
}

/// The horizontal axis of the world, either way, that is nearest to `wanted`.
glm::dvec3 horizontalAxis(const glm::dvec3& wanted) {
  if (std::abs(wanted.x) >= std::abs(wanted.z)) return {wanted.x < 0.0 ? -1.0 : 1.0, 0.0, 0.0};
  return {0.0, 0.0, wanted.z < 0.0 ? -1.0 : 1.0};
}

std::optional<glm::dvec3> nudgeDirection(int key, const ViewProjection& view) {
  const ViewAxes axes = view.axes();
  // Looking straight down, up on the screen is what lies ahead.
  const glm::dvec3 ahead = std::abs(axes.forward.y) > 0.9 ? axes.up : axes.forward;
  switch (key) {
    case Qt::Key_Right:
      return horizontalAxis(view.right());
    case Qt::Key_Left:
      return -horizontalAxis(view.right());
    case Qt::Key_Up:
      return horizontalAxis(ahead);
    case Qt::Key_Down:
      return -horizontalAxis(ahead);
    case Qt::Key_PageUp:
      return glm::dvec3(0.0, 1.0, 0.0);
    case Qt::Key_PageDown:
      return glm::dvec3(0.0, -1.0, 0.0);
    default:
      return std::nullopt;
  }
}

}  // namespace

ProbeWidget::ProbeWidget(Editor& editor, ProbeOverlay& overlay, SceneSurfaces& surfaces,
                         std::function<ViewProjection()> view, QObject* parent)
    : QObject(parent), editor_(editor), overlay_(overlay), surfaces_(surfaces), view_(std::move(view)) {}

bool ProbeWidget::press(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  if (dragging()) return true;
  endNudge();
  pixel_ = held_ = pixel;
  modifiers_ = modifiers;
  hover(pixel);
  if (!hovered_) return false;
  if (editor_.document().selectedProbe() != hovered_->probe) {
    if (modifiers.testFlag(Qt::ControlModifier)) {
      editor_.toggleProbe(hovered_->probe);
    } else {
      editor_.selectProbe(hovered_->probe);
    }
    hovered_.reset();  // what can be done with it is another thing now
    hover(pixel);
    return true;
  }
  editor_.finish();
  const Probe* probe = editor_.probe();
  if (!probe) return false;
  pressed_ = pixel;
  const ViewProjection view = view_();
  moved_ = previewed_ = false;
  drag_.emplace(*probe, *hovered_, view.axes(), view.ray(toGlm(pixel)));
  emit cursorWanted(Qt::ClosedHandCursor);
  return true;
}

void ProbeWidget::move(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  const QPointF delta = pixel - pixel_;
  pixel_ = pixel;
  modifiers_ = modifiers;
  if (!dragging()) return hover(pixel);
  held_ += delta * (modifiers.testFlag(Qt::ShiftModifier) ? kFine : 1.0);
  if (!moved_ && glm::length(toGlm(pixel - pressed_)) < kClickPixels) return;
  moved_ = true;
  drag();
}

void ProbeWidget::release(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  if (!dragging()) return;
  move(pixel, modifiers);
  if (!dragging()) return;
  const Handle handle = drag_->handle();
  const bool takeOut = !moved_ && handle.kind == HandleKind::Origin && modifiers.testFlag(Qt::ControlModifier);
  endDrag();
  editor_.finish();
  if (takeOut) editor_.toggleProbe(handle.probe);
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

void ProbeWidget::setMode(HandleMode mode) {
  if (mode == mode_) return;
  cancel();
  endNudge();
  mode_ = mode;
  hovered_.reset();
  update();
  emit modeChanged(mode);
}

std::optional<std::size_t> ProbeWidget::probeAt(const QPointF& pixel) const {
  const auto under =
      handleAt(editor_.scene().probes, editor_.document().selectedProbe(), view_(), toGlm(pixel), kReachPixels, mode_);
  return overlay_.visible() && under ? std::optional<std::size_t>(under->probe) : std::nullopt;
}

void ProbeWidget::hover(const QPointF& pixel) {
  const auto& probes = editor_.scene().probes;
  const auto selected = editor_.document().selectedProbe();
  const auto under = overlay_.visible() ? handleAt(probes, selected, view_(), toGlm(pixel), kReachPixels, mode_)
                                        : std::optional<Handle>();
  emit cursorWanted(!under                                  ? Qt::ArrowCursor
                    : under->kind != HandleKind::Origin     ? Qt::OpenHandCursor
                    : selected && *selected == under->probe ? Qt::SizeAllCursor
                                                            : Qt::PointingHandCursor);
  if (under == hovered_) return;
  hovered_ = under;
  emit hint(under ? handleHint(*under, probes[under->probe], selected == under->probe) : QString());
  update();
}

void ProbeWidget::drag() {
  if (!editor_.probe()) return cancel();
  const ViewProjection view = view_();
  DragWish wish{view.ray(toGlm(held_)), modifiers_.testFlag(Qt::AltModifier), heldAxis_, nullptr};
  std::optional<DragSnap> snap;
  if (modifiers_.testFlag(Qt::ControlModifier)) {
    const Handle& handle = drag_->handle();
    snap.emplace(isFace(handle) ? surfaces_.rays() : nullptr, view.ray(toGlm(pixel_)),
                 view.metresPerPixel(handleAnchorWorld(*editor_.probe(), handle)));
    wish.snap = &*snap;
  }
  const Probe result = drag_->at(wish);
  const Handle handle = drag_->handle();
  previewed_ = true;
  preview(handle, drag_->start(), result);
  QString text = handleReadout(handle, drag_ ? drag_->start() : result, result);
  if (snap) text += "\n" + snapWords(*snap, handle);
  emit readout(text, pixel_);
}

// Previews start from the scene as it was before the drag: what goes along is told from where it stood, too.
void ProbeWidget::preview(const Handle& handle, const Probe& start, const Probe& result) {
  const int part = 16 * static_cast<int>(handle.kind) + handle.face.index();
  std::set<std::string> along;
  if (movesOthers(handle.kind)) {
    for (const std::size_t index : editor_.selected()) along.insert(editor_.scene().probes[index].name);
  }
  along.erase(result.name);
  const QString label = along.empty() ? handleEditLabel(handle, QString::fromStdString(result.name))
                                      : handleEditLabel(handle, editor_.selectedName());
  editor_.preview({this, part, result.name}, label, [handle, start, result, along](Scene& scene) {
    for (Probe& edited : scene.probes) {
      if (edited.name == result.name) {
        edited.box = result.box;
        edited.influence = result.influence;
        edited.origin = result.origin;
        edited.rotationDegrees = result.rotationDegrees;
        edited.blendDistance = result.blendDistance;
      } else if (along.count(edited.name) > 0) {
        edited = movedAlong(edited, handle.kind, start, result);
      }
    }
  });
}

void ProbeWidget::endDrag() {
  drag_.reset();
  updateDrop();
  emit readout({}, {});
}

bool ProbeWidget::nudge(int key, Qt::KeyboardModifiers modifiers) {
  const ViewProjection view = view_();
  const auto direction = nudgeDirection(key, view);
  if (!direction || dragging() || !overlay_.visible()) return false;
  if (!nudge_) {
    editor_.finish();
    const Probe* probe = editor_.probe();
    if (!probe) return false;
    const std::size_t selected = *editor_.document().selectedProbe();
    const bool face = hovered_ && hovered_->probe == selected && isFace(*hovered_);
    const Handle whole{mode_ == HandleMode::Place ? HandleKind::Move : HandleKind::Origin, selected, {}};
    nudge_ = Nudge{face ? *hovered_ : whole, *probe, {}};
  }
  nudge_->by += *direction * (modifiers.testFlag(Qt::ShiftModifier) ? kFineNudge : kNudge);
  const Handle handle = nudge_->handle;
  Probe result = nudge_->start;
  if (isFace(handle)) {
    // A face goes along its own axis only; a ray beside it that has moved so far says how far.
    const glm::dvec3 axis = handleAxisWorld(nudge_->start, handle);
    const glm::dvec3 anchor = handleAnchorWorld(nudge_->start, handle);
    const glm::dvec3 side = std::abs(axis.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 across = glm::normalize(glm::cross(axis, side));
    const Ray from{anchor - across, across};
    ProbeDrag along(nudge_->start, handle, view.axes(), from);
    const Ray to{from.origin + glm::dot(nudge_->by, axis) * axis, across};
    result = along.at({to, false, std::nullopt, nullptr});
  } else if (handle.kind == HandleKind::Move) {
    result = movedProbe(result, nudge_->by);
  } else {
    result.origin += nudge_->by;
  }
  preview(handle, nudge_->start, result);
  return true;
}

void ProbeWidget::endNudge() {
  if (!nudge_) return;
  nudge_.reset();
  editor_.finish();
}

void ProbeWidget::updateDrop() {
  const Probe* probe = editor_.probe();
  const bool origin = drag_ && drag_->handle().kind == HandleKind::Origin;
  if (probe == nullptr || !overlay_.visible() ||
      !(mode_ == HandleMode::Origin || mode_ == HandleMode::Place || origin)) {
    return overlay_.setDrop({});
  }
  const auto floor = surfaces_.meet({probe->origin, {0.0, -1.0, 0.0}});
  glm::dvec3 foot = probe->origin;
  foot.y = floor ? floor->y : std::min(probe->box.min.y, probe->origin.y);
  overlay_.setDrop(std::array<glm::dvec3, 2>{probe->origin, foot});
}

void ProbeWidget::update() {
  const auto& probes = editor_.scene().probes;
  if (hovered_ && hovered_->probe >= probes.size()) hovered_.reset();
  // Undone or replaced from elsewhere while the button was down: the drag has nothing left to move.
  if (dragging() && previewed_ && !editor_.document().previewing()) endDrag();
  if (nudge_ && !editor_.document().previewing()) nudge_.reset();
  overlay_.update(probes, editor_.document().selectedProbe(), editor_.selected(), hovered_, mode_);
  updateDrop();
  emit pictureChanged();
}

void ProbeWidget::setVisible(bool visible) {
  if (!visible) cancel();
  overlay_.setVisible(visible);
  hovered_.reset();
  update();
}

}  // namespace boxprobe
