// See probe_widget.h.
#include "app/gui/handles/probe_widget.h"

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "app/gui/handles/handle_words.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"

namespace boxprobe {

namespace {

constexpr double kNudge = 0.1, kFineNudge = 0.01;  ///< scene units

glm::dvec2 toGlm(const QPointF& p) {
  return {p.x(), p.y()};
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

ProbeWidget::ProbeWidget(Editor& editor, const ViewState& state, vtkReflectionProbeRepresentation& shown,
                         SceneSurfaces& surfaces, std::function<ViewProjection()> view, QObject* parent)
    : QObject(parent), editor_(editor), state_(state), shown_(shown), surfaces_(surfaces), view_(std::move(view)) {
  shown_.SetReadoutVisibility(false);  // the viewport has a label for it
  shown_.SetLengthUnit("m");
  shown_.SetReadoutWords([](const char* text) { return handleWords(text).toStdString(); });
  shown_.SetSurfaces([this] { return surfaces_.rays(); });
  connect(&state_, &ViewState::changed, this, &ProbeWidget::update);
}

bool ProbeWidget::dragging() const {
  return shown_.GetDragging();
}

HandleMode ProbeWidget::mode() const {
  return static_cast<HandleMode>(shown_.GetMode());
}

bool ProbeWidget::press(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  if (dragging()) return true;
  endNudge();
  pixel_ = pixel;
  show();
  hover(pixel);
  const auto hovered = shown_.GetHovered();
  if (!hovered) return false;
  emit taken();
  if (editor_.document().selectedProbe() != hovered->probe) {
    if (modifiers.testFlag(Qt::ControlModifier)) {
      editor_.toggleProbe(hovered->probe);
    } else {
      editor_.selectProbe(hovered->probe);
    }
    forget();  // what can be done with it is another thing now
    show();
    hover(pixel);
    return true;
  }
  editor_.finish();
  if (!editor_.probe()) return false;
  show();
  previewed_ = false;
  if (!shown_.Grab(view_(), toGlm(pixel))) return false;
  emit cursorWanted(Qt::ClosedHandCursor);
  return true;
}

void ProbeWidget::move(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  pixel_ = pixel;
  if (!dragging()) return hover(pixel);
  shown_.SetFine(modifiers.testFlag(Qt::ShiftModifier));
  shown_.SetSnapping(modifiers.testFlag(Qt::ControlModifier));
  shown_.SetSymmetric(modifiers.testFlag(Qt::AltModifier));
  drag();
}

void ProbeWidget::release(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  if (!dragging()) return;
  move(pixel, modifiers);
  if (!dragging()) return;
  const Handle handle = shown_.GetDrag()->handle();
  const bool takeOut = !previewed_ && handle.kind == HandleKind::Origin && modifiers.testFlag(Qt::ControlModifier);
  endDrag();
  editor_.finish();
  if (takeOut) editor_.toggleProbe(handle.probe);
  show();
  hover(pixel);
}

void ProbeWidget::forget() {
  shown_.Highlight(0);
}

void ProbeWidget::leave() {
  if (dragging() || !shown_.GetHovered()) return;
  forget();
  update();
  emit hint({});
}

void ProbeWidget::setHeldAxis(std::optional<int> axis) {
  shown_.SetConstrainedAxis(axis.value_or(-1));
  if (dragging() && previewed_) drag();
}

void ProbeWidget::cancel() {
  if (!dragging()) return;
  endDrag();
  editor_.cancel();
  show();
  hover(pixel_);
}

void ProbeWidget::setMode(HandleMode mode) {
  if (mode == this->mode()) return;
  cancel();
  endNudge();
  shown_.SetMode(static_cast<int>(mode));
  update();
  emit modeChanged(mode);
}

std::optional<std::size_t> ProbeWidget::probeAt(const QPointF& pixel) const {
  const auto under = shown_.HandleAt(view_(), toGlm(pixel));
  return under ? std::optional<std::size_t>(under->probe) : std::nullopt;
}

void ProbeWidget::hover(const QPointF& pixel) {
  const auto before = shown_.GetHovered();
  const auto under = shown_.Hover(view_(), toGlm(pixel));
  const auto& probes = editor_.scene().probes;
  const auto selected = editor_.document().selectedProbe();
  emit cursorWanted(!under                                  ? Qt::ArrowCursor
                    : under->kind != HandleKind::Origin     ? Qt::OpenHandCursor
                    : selected && *selected == under->probe ? Qt::SizeAllCursor
                                                            : Qt::PointingHandCursor);
  if (under == before) return;
  emit hint(under ? handleHint(*under, probes[under->probe], selected == under->probe) : QString());
  update();
}

void ProbeWidget::drag() {
  if (!editor_.probe()) return cancel();
  const auto result = shown_.Pull(view_(), toGlm(pixel_));
  if (!result) return;
  previewed_ = true;
  const Handle handle = shown_.GetDrag()->handle();
  const Probe start = shown_.GetDrag()->start();
  preview(handle, start, *result);
  if (dragging()) emit readout(QString::fromUtf8(shown_.GetReadout()), pixel_);
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
  shown_.LetGo();
  updateDrop();
  emit readout({}, {});
}

bool ProbeWidget::nudge(int key, Qt::KeyboardModifiers modifiers) {
  const ViewProjection view = view_();
  const auto direction = nudgeDirection(key, view);
  if (!direction || dragging() || shown_.GetVisibility() == 0) return false;
  if (!nudge_) {
    editor_.finish();
    const Probe* probe = editor_.probe();
    if (!probe) return false;
    const std::size_t selected = *editor_.document().selectedProbe();
    const auto& hovered = shown_.GetHovered();
    const bool face = hovered && hovered->probe == selected && isFace(*hovered);
    const Handle whole{mode() == HandleMode::Place ? HandleKind::Move : HandleKind::Origin, selected, {}};
    nudge_ = Nudge{face ? *hovered : whole, *probe, {}};
  }
  nudge_->by += *direction * (modifiers.testFlag(Qt::ShiftModifier) ? kFineNudge : kNudge);
  const Probe result = nudgedProbe(nudge_->start, nudge_->handle, nudge_->by, view.axes());
  preview(nudge_->handle, nudge_->start, result);
  return true;
}

void ProbeWidget::endNudge() {
  if (!nudge_) return;
  nudge_.reset();
  editor_.finish();
}

void ProbeWidget::updateDrop() {
  const Probe* probe = editor_.probe();
  const ProbeDrag* drag = shown_.GetDrag();
  const bool origin = drag != nullptr && drag->handle().kind == HandleKind::Origin;
  if (probe == nullptr || shown_.GetVisibility() == 0 ||
      !(mode() == HandleMode::Origin || mode() == HandleMode::Place || origin)) {
    return shown_.ShowDrop({});
  }
  const auto floor = surfaces_.meet({probe->origin, {0.0, -1.0, 0.0}});
  glm::dvec3 foot = probe->origin;
  foot.y = floor ? floor->y : std::min(probe->box.min.y, probe->origin.y);
  shown_.ShowDrop(std::array<glm::dvec3, 2>{probe->origin, foot});
}

void ProbeWidget::show() {
  const auto& probes = editor_.scene().probes;
  std::vector<bool> hidden, locked;
  for (const Probe& probe : probes) {
    hidden.push_back(!state_.shown(ViewState::Part::Probe, probe.name));
    locked.push_back(state_.locked(ViewState::Part::Probe, probe.name));
  }
  shown_.LeaveOut(std::move(hidden), std::move(locked));
  shown_.ShowProbes(probes, editor_.document().selectedProbe(), editor_.selected());
}

void ProbeWidget::update() {
  // Undone or replaced from elsewhere while the button was down: the drag has nothing left to move.
  if (dragging() && previewed_ && !editor_.document().previewing()) endDrag();
  if (nudge_ && !editor_.document().previewing()) nudge_.reset();
  show();
  updateDrop();
  emit pictureChanged();
}

void ProbeWidget::setVisible(bool visible) {
  if (!visible) cancel();
  shown_.SetVisibility(visible ? 1 : 0);
  forget();
  update();
}

}  // namespace boxprobe
