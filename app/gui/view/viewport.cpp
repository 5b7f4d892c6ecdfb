// See viewport.h.
#include "app/gui/view/viewport.h"

#include <QVTKInteractor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <QKeyEvent>
#include <QLabel>
#include <QLineF>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <optional>
#include <utility>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/widgets/place_keys.h"
#include "app/gui/widgets/pointer_place.h"
#include "filters/vtk/gl/software_driver.h"

namespace boxprobe {

namespace {

std::optional<int> axisOfKey(int key) {
  if (key == Qt::Key_X) return 0;
  if (key == Qt::Key_Y) return 1;
  if (key == Qt::Key_Z) return 2;
  return std::nullopt;
}

CameraController::Motion motionFor(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
  using Motion = CameraController::Motion;
  if (button == Qt::MiddleButton) return Motion::Pan;
  if (button == Qt::RightButton) return Motion::Look;
  if (button != Qt::LeftButton) return Motion::None;
  if (modifiers.testFlag(Qt::ShiftModifier) && modifiers.testFlag(Qt::ControlModifier)) return Motion::TurnSky;
  if (modifiers.testFlag(Qt::ShiftModifier)) return Motion::Pan;
  if (modifiers.testFlag(Qt::ControlModifier)) return Motion::Zoom;
  return Motion::Orbit;
}

constexpr double kClickPixels = 4.0;  ///< a press that moves less is a click
constexpr double kWheelStep = 120.0;  ///< eighths of a degree: one notch of a usual wheel

}  // namespace

Viewport::Viewport(QWidget* parent) : QVTKOpenGLNativeWidget(parent), readout_(new QLabel(this)) {
  setRenderWindow(window_.Get());
  // VTK's own mouse interaction would render at every event, and knows nothing of handles.
  interactor()->SetInteractorStyle(nullptr);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(280, 240);  // beside outliner and panels in 1024 pixels
  readout_->setAttribute(Qt::WA_TransparentForMouseEvents);
  readout_->setStyleSheet(
      "QLabel { color: #f4f4f4; background: rgba(16, 18, 22, 210); border-radius: 5px; padding: 6px 10px; }");
  readout_->hide();
}

Viewport::~Viewport() = default;

vtkGenericOpenGLRenderWindow* Viewport::window3d() const {
  return window_.Get();
}

void Viewport::setCamera(std::function<vtkCamera*()> camera, std::function<std::optional<glm::dvec3>(const Ray&)> meet,
                         std::function<Box()> bounds) {
  camera_ = std::move(camera);
  const auto ray = [this](const QPointF& pixel) { return view().ray({pixel.x(), pixel.y()}); };
  cameraController_.setHooks({camera_, ray, std::move(meet), std::move(bounds)});
  connect(&cameraController_, &CameraController::moved, this, &Viewport::cameraMoved);
  connect(&cameraController_, &CameraController::skyTurned, this, &Viewport::skyTurned);
  connect(&cameraController_, &CameraController::skyTurnEnded, this, &Viewport::skyTurnEnded);
}

void Viewport::setProbeWidget(ProbeWidget* widget) {
  probeWidget_ = widget;
  connect(widget, &ProbeWidget::cursorWanted, this,
          [this](Qt::CursorShape shape) { setCursor(picking_ && shape == Qt::ArrowCursor ? Qt::CrossCursor : shape); });
  connect(widget, &ProbeWidget::readout, this, &Viewport::showReadout);
}

ViewProjection Viewport::view() const {
  return {camera_(), static_cast<double>(width()), static_cast<double>(height())};
}

bool Viewport::readyToDraw() const {
  return !lost_ && isValid() && isVisible() && window_->GetReadyForRendering();
}

// Qt asks the driver each time it makes the context current. A widget that moves to another window has none for a
// while.
void Viewport::noticeLostContext() {
  if (lost_ || context() == nullptr || isValid()) return;
  lost_ = true;
  QTimer::singleShot(0, this, &Viewport::contextLost);
}

void Viewport::showReadout(const QString& text, const QPointF& atPixel) {
  readout_->setVisible(!text.isEmpty());
  if (text.isEmpty()) return;
  readout_->setText(text);
  readout_->adjustSize();
  constexpr int kBesidePointer = 22;
  const int x = std::min(static_cast<int>(atPixel.x()) + kBesidePointer, width() - readout_->width());
  const int y = std::min(static_cast<int>(atPixel.y()) + kBesidePointer, height() - readout_->height());
  readout_->move(std::max(x, 0), std::max(y, 0));
}

void Viewport::setPicking(bool on) {
  picking_ = on;
  pressed_.reset();
  setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
}

void Viewport::initializeGL() {
  QVTKOpenGLNativeWidget::initializeGL();
  // Where the processor draws, four samples per pixel make a picture take three times as long: following the mouse
  // comes first there.
  softwareRenderer_ = tunedForCpu();
  constexpr int kSamples = 4;
  window_->SetMultiSamples(softwareRenderer_ ? 0 : kSamples);
}

void Viewport::paintEvent(QPaintEvent* event) {
  QVTKOpenGLNativeWidget::paintEvent(event);
  noticeLostContext();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  event->accept();
  if (cameraController_.motion() != CameraController::Motion::None) return;
  if (event->button() == Qt::LeftButton && probeWidget_->press(pointerPlace(*event), event->modifiers())) return;
  if (probeWidget_->dragging()) return;
  if (event->button() == Qt::LeftButton || event->button() == Qt::RightButton) pressed_ = pointerPlace(*event);
  cameraController_.begin(motionFor(event->button(), event->modifiers()), pointerPlace(*event));
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  mousePressEvent(event);
  const bool plain = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier;
  if (plain && !picking_ && !probeWidget_->dragging() && pressed_) emit doubleClicked(pointerPlace(*event));
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  event->accept();
  if (cameraController_.motion() == CameraController::Motion::None) {
    probeWidget_->move(pointerPlace(*event), event->modifiers());
    if (!probeWidget_->dragging()) emit pointerMoved(pointerPlace(*event));
  } else if (pressed_ && QLineF(*pressed_, pointerPlace(*event)).length() < kClickPixels) {
    return;  // a hand is never quite still
  } else {
    pressed_.reset();
    if (cameraController_.move(pointerPlace(*event), height())) emit cameraMoved();
  }
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  event->accept();
  if (event->button() == Qt::LeftButton) probeWidget_->release(pointerPlace(*event), event->modifiers());
  if (event->buttons() == Qt::NoButton) cameraController_.end();
  if (!pressed_) return;
  const QPointF pressed = *pressed_;
  pressed_.reset();
  if (QLineF(pressed, pointerPlace(*event)).length() < kClickPixels) clickEnded(event->button(), pointerPlace(*event));
}

void Viewport::clickEnded(Qt::MouseButton button, const QPointF& at) {
  if (button == Qt::RightButton) emit menuRequested(at);
  if (button != Qt::LeftButton) return;
  if (picking_) {
    emit clicked(at);
  } else {
    emit selected(at);
  }
}

void Viewport::wheelEvent(QWheelEvent* event) {
  event->accept();
  cameraController_.wheel(event->position(), event->angleDelta().y() / kWheelStep);
  emit cameraMoved();
}

void Viewport::leaveEvent(QEvent* event) {
  probeWidget_->leave();
  emit pointerLeft();
  QVTKOpenGLNativeWidget::leaveEvent(event);
}

bool Viewport::event(QEvent* event) {
  // While the button is held E flies up; the menu has it otherwise.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (cameraController_.takesKey(keyByPlace(*key), key->modifiers())) {
      event->accept();
      return true;
    }
  }
  return QVTKOpenGLNativeWidget::event(event);
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  const int key = keyByPlace(*event);
  if (cameraController_.takesKey(key, event->modifiers())) {
    if (!event->isAutoRepeat()) cameraController_.keyDown(key, event->modifiers().testFlag(Qt::ShiftModifier));
    return event->accept();
  }
  if (probeWidget_->nudge(event->key(), event->modifiers())) return event->accept();
  if (const auto axis = axisOfKey(key); axis && !event->isAutoRepeat()) probeWidget_->setHeldAxis(axis);
  QVTKOpenGLNativeWidget::keyPressEvent(event);
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat()) {
    cameraController_.keyUp(keyByPlace(*event));
    probeWidget_->endNudge();
  }
  if (axisOfKey(keyByPlace(*event)) && !event->isAutoRepeat()) probeWidget_->setHeldAxis(std::nullopt);
  QVTKOpenGLNativeWidget::keyReleaseEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event) {
  cameraController_.stopFlying();
  probeWidget_->endNudge();
  probeWidget_->setHeldAxis(std::nullopt);  // its release will go elsewhere
  QVTKOpenGLNativeWidget::focusOutEvent(event);
}

void Viewport::showEvent(QShowEvent* event) {
  QVTKOpenGLNativeWidget::showEvent(event);
  // The context exists once the first paint event has been handled.
  QTimer::singleShot(0, this, &Viewport::becameReady);
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  emit becameReady();
}

}  // namespace boxprobe
