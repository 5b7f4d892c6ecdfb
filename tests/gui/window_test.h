// A main window with a small scene, and a mouse: what every test of the window starts from. Events go through the
// window system's own entrance to Qt, so that grabbing, focus and button states are those a user gets.
#pragma once

#include <gtest/gtest.h>

#include <QEvent>
#include <QPointF>
#include <QString>
#include <Qt>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/window/main_window.h"
#include "filters/core/base/counters.h"
#include "filters/core/geometry/probe_frame.h"

class QWidget;

namespace boxprobe {

/// Lets the event loop turn, round by round, until `holds` does, for what may pass by: QTest::qWaitFor asks only once
/// nothing is left to do. False after five minutes.
bool waitFor(const std::function<bool()>& holds);

/// So long that it does not come: for a timer that another test is about.
constexpr int kNeverMilliseconds = 24 * 3600 * 1000;

/// The building with captures small enough to wait for.
std::string buildingPath();
LoadedScene smallBuilding(const std::vector<std::string>& more = {});

/// The window all tests share: its shader programs are compiled once. Deleted by the test program's end.
std::unique_ptr<MainWindow>& sharedWindow();

class WindowTest : public ::testing::Test {
 protected:
  /// The window makes no programs for a scene at rest: how soon a test gets how far is the machine's.
  void SetUp() override;

  /// What SetUp shows.
  virtual LoadedScene scene() const { return smallBuilding(); }

  /// Until nothing is left to capture or draw.
  void waitUntilIdle();
  /// By the window: panels take as much of it as their fonts ask for.
  void sizePicture(const QSize& size);
  /// The mouse over the picture: positions in the viewport's logical pixels. Each event is handled, and whatever it
  /// causes in the same turns of the event loop, before the call returns.
  void press(const QPointF& pixel, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButton button = Qt::LeftButton);
  void move(const QPointF& pixel, Qt::KeyboardModifiers modifiers = {});
  void release(const QPointF& pixel, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButton button = Qt::LeftButton);
  /// With the left button.
  void doubleClick(const QPointF& pixel);
  /// Press, `steps` moves on a straight line, release.
  void drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers modifiers = {}, int steps = 8);
  /// The same over another widget, in its pixels.
  void dragOver(QWidget* widget, const QPointF& from, const QPointF& to, int steps = 8);
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
  void keyDown(Qt::Key key);
  void keyUp(Qt::Key key);
  /// The inspector that has it, as by a click on its tab.
  void bring(QWidget* widget);
  /// Into the field: selects all, types, Enter.
  void type(QWidget* field, const QString& text);

  QPointF facePixel(const BoxFace& face) const;
  QPointF originPixel(std::size_t probe = 0) const;
  QPointF pixelOf(const glm::dvec3& pointWorld) const;
  /// Where the handle of `face` would be with the face `metres` farther out.
  QPointF facePixelAfter(const BoxFace& face, double metres) const;

  const Probe& probe(std::size_t index = 0) const { return window_->document().scene().probes.at(index); }
  const Counters& counters() const;
  Document& document() { return window_->document(); }
  /// Where the mouse was last, in the viewport's pixels.
  QPointF pointer() const { return pointer_; }
  MainWindow* window_ = nullptr;

 private:
  void mouse(QEvent::Type type, const QWidget* over, const QPointF& position, Qt::MouseButton button,
             Qt::KeyboardModifiers modifiers);

  Qt::MouseButtons buttons_;
  QPointF pointer_;
  int timestamp_ = 0;
};

}  // namespace boxprobe
