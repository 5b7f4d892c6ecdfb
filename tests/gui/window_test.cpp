// See window_test.h.
#include "tests/gui/window_test.h"

#include <QAbstractEventDispatcher>
#include <QApplication>
#include <QDeadlineTimer>
#include <QEventLoop>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>
#include <QWindow>

#include "app/gui/edit/view_state.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/view/motion_preview.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/rest_refinement.h"
#include "app/gui/view/viewport.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

/// So far apart in time two presses are not taken for a double click.
constexpr int kMillisecondsApart = 600;

}  // namespace

std::string buildingPath() {
  return std::string(BOXPROBE_DATA_DIR) + "/scenes/building.boxprobe.json";
}

LoadedScene smallBuilding(const std::vector<std::string>& more) {
  // The box is smaller than the building, so that the first camera sees all of its handles.
  std::vector<std::string> assignments = {"probes.room.faceSize=32", "probes.room.samplesPerPixel=1",
                                          "probes.room.bounces=1", "probes.room.blendDistance=0.5",
                                          "probes.room.box={\"min\":[-2,0.125,-2.5],\"max\":[1.5,2.75,1]}"};
  assignments.insert(assignments.end(), more.begin(), more.end());
  LoadedScene loaded = loadScene(buildingPath(), assignments);
  loaded.scene.probes.front().influence.reset();
  return loaded;
}

bool waitFor(const std::function<bool()>& holds) {
  const QDeadlineTimer deadline(300000);
  while (!holds()) {
    if (deadline.hasExpired()) return false;
    if (!QAbstractEventDispatcher::instance()->processEvents(QEventLoop::AllEvents)) QTest::qSleep(2);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  return true;
}

std::unique_ptr<MainWindow>& sharedWindow() {
  static std::unique_ptr<MainWindow> window;
  return window;
}

// A bare X server has no window manager to give a window the focus, so a request for it, which is all that Qt 6 wants
// left, does nothing.
static void activate(QWidget* window) {
  QT_WARNING_PUSH
  QT_WARNING_DISABLE_DEPRECATED
  QApplication::setActiveWindow(window);
  QT_WARNING_POP
}

void WindowTest::SetUp() {
  if (!sharedWindow()) sharedWindow() = std::make_unique<MainWindow>();
  window_ = sharedWindow().get();
  window_->pictureWork().setRest(kNeverMilliseconds);
  window_->refinement().setRest(kNeverMilliseconds);
  window_->resize(1440, 700);
  window_->findChild<QTabWidget*>("inspectors")->setCurrentIndex(0);
  window_->viewState().forget();  // what the test before selected and hid
  window_->showScene(scene());
  window_->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_, 60000));
  activate(window_);
  window_->viewport().setFocus();
  waitUntilIdle();
}

void WindowTest::waitUntilIdle() {
  constexpr int kMilliseconds = 300000;
  const bool done = QTest::qWaitFor(
      [this] {
        return window_->scheduler().idle() && !window_->motionPreview().active() &&
               (!window_->renderer().workPending() || window_->scheduler().workStopped());
      },
      kMilliseconds);
  ASSERT_TRUE(done) << "work still pending after five minutes, " << window_->renderer().workProgress() << " done";
  ASSERT_EQ(window_->renderer().error(), "");
}

void WindowTest::sizePicture(const QSize& size) {
  for (int i = 0; i < 4 && window_->viewport().size() != size; ++i) {
    window_->resize(window_->size() + size - window_->viewport().size());
    for (int turn = 0; turn < 4; ++turn) QCoreApplication::processEvents();
  }
  ASSERT_EQ(window_->viewport().size(), size);
}

void WindowTest::mouse(QEvent::Type type, const QWidget* over, const QPointF& position, Qt::MouseButton button,
                       Qt::KeyboardModifiers modifiers) {
  QWindow* window = window_->windowHandle();
  const QPointF local = QPointF(over->mapTo(window_, QPoint(0, 0))) + position;
  pointer_ = local - QPointF(window_->viewport().mapTo(window_, QPoint(0, 0)));
  timestamp_ += type == QEvent::MouseButtonPress ? kMillisecondsApart : 1;
  qt_handleMouseEvent(window, local, window->mapToGlobal(QPoint(0, 0)) + local, buttons_, button, type, modifiers,
                      timestamp_);
  QCoreApplication::processEvents();
}

void WindowTest::press(const QPointF& pixel, Qt::KeyboardModifiers modifiers, Qt::MouseButton button) {
  buttons_.setFlag(button, true);
  mouse(QEvent::MouseButtonPress, &window_->viewport(), pixel, button, modifiers);
}

void WindowTest::move(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  mouse(QEvent::MouseMove, &window_->viewport(), pixel, Qt::NoButton, modifiers);
}

void WindowTest::release(const QPointF& pixel, Qt::KeyboardModifiers modifiers, Qt::MouseButton button) {
  buttons_.setFlag(button, false);
  mouse(QEvent::MouseButtonRelease, &window_->viewport(), pixel, button, modifiers);
}

void WindowTest::doubleClick(const QPointF& pixel) {
  constexpr int kBetween = 50;
  move(pixel);
  press(pixel);
  release(pixel);
  timestamp_ += kBetween - kMillisecondsApart;
  press(pixel);
  release(pixel);
}

void WindowTest::drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers modifiers, int steps) {
  move(from, modifiers);
  press(from, modifiers);
  for (int i = 1; i <= steps; ++i) move(from + (to - from) * i / steps, modifiers);
  release(to, modifiers);
}

void WindowTest::dragOver(QWidget* widget, const QPointF& from, const QPointF& to, int steps) {
  // As a user does who has to scroll to it first.
  for (QWidget* above = widget->parentWidget(); above != nullptr; above = above->parentWidget()) {
    if (auto* scroll = qobject_cast<QScrollArea*>(above)) scroll->ensureWidgetVisible(widget);
  }
  QCoreApplication::processEvents();
  buttons_.setFlag(Qt::LeftButton, true);
  mouse(QEvent::MouseButtonPress, widget, from, Qt::LeftButton, {});
  for (int i = 1; i <= steps; ++i) mouse(QEvent::MouseMove, widget, from + (to - from) * i / steps, Qt::NoButton, {});
  buttons_.setFlag(Qt::LeftButton, false);
  mouse(QEvent::MouseButtonRelease, widget, to, Qt::LeftButton, {});
}

void WindowTest::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  // Without a window manager nobody hands the focus back when a dialog has closed.
  if (QApplication::activeWindow() == nullptr) activate(window_);
  QTest::keyClick(window_->windowHandle(), key, modifiers);
}

void WindowTest::keyDown(Qt::Key key) {
  QTest::keyPress(window_->windowHandle(), key);
}

void WindowTest::keyUp(Qt::Key key) {
  QTest::keyRelease(window_->windowHandle(), key);
}

void WindowTest::bring(QWidget* widget) {
  auto* tabs = window_->findChild<QTabWidget*>("inspectors");
  for (int i = 0; i < tabs->count(); ++i) {
    if (tabs->widget(i)->isAncestorOf(widget)) tabs->setCurrentIndex(i);
  }
}

void WindowTest::type(QWidget* field, const QString& text) {
  bring(field);
  field->setFocus();
  key(Qt::Key_A, Qt::ControlModifier);
  for (const QChar c : text) QTest::keyClick(window_->windowHandle(), c.toLatin1());
  key(Qt::Key_Return);
}

QPointF WindowTest::facePixel(const BoxFace& face) const {
  return pixelOf(faceCenterWorld(probe(), face));
}

QPointF WindowTest::originPixel(std::size_t probe) const {
  return pixelOf(window_->document().scene().probes.at(probe).origin);
}

QPointF WindowTest::pixelOf(const glm::dvec3& pointWorld) const {
  const auto at = window_->viewport().view().pixel(pointWorld);
  EXPECT_TRUE(at);
  return at ? QPointF(at->x, at->y) : QPointF();
}

QPointF WindowTest::facePixelAfter(const BoxFace& face, double metres) const {
  return pixelOf(faceCenterWorld(probe(), face) + metres * faceAxisWorld(probe(), face));
}

const Counters& WindowTest::counters() const {
  return window_->renderer().counters();
}

}  // namespace boxprobe
