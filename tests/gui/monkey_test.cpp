// A monkey at the window: events of a fixed seed, over three scenes, by the ways a user has. Nothing may crash, throw
// or leave the document invalid; what is undone to the start is the scene as opened. How long the event loop was busy
// at most is printed, for the machine decides it.
//   BOXPROBE_MONKEY_EVENTS=5000 BOXPROBE_MONKEY_SEED=2 build/release/tests/gui/monkey_test
#include <gtest/gtest.h>
#include <unistd.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QSlider>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "app/gui/view/picture_work.h"
#include "app/gui/view/viewport.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

int setting(const char* name, int otherwise) {
  bool number = false;
  const int value = qEnvironmentVariableIntValue(name, &number);
  return number ? value : otherwise;
}

double megabytesInUse() {
  std::ifstream file("/proc/self/statm");
  double pages = 0.0, resident = 0.0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

class MonkeyTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    window_->pictureWork().setRest(PictureWork::kRestMilliseconds);
    // Dialogs are left as they came.
    connection_ = QObject::connect(&refuse_, &QTimer::timeout, [] {
      if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) dialog->reject();
      if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    });
    refuse_.start(50);
  }
  void TearDown() override {
    refuse_.stop();
    QObject::disconnect(connection_);
  }

  int number(int below) { return static_cast<int>(random_() % static_cast<unsigned>(std::max(below, 1))); }
  QPointF somewhere() {
    return {1.0 * number(window_->viewport().width()), 1.0 * number(window_->viewport().height())};
  }
  Qt::KeyboardModifiers someModifiers() {
    static const Qt::KeyboardModifiers all[] = {{}, {}, {}, Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier};
    return all[number(6)];
  }

  std::string dragSomewhere() {
    static const Qt::MouseButton buttons[] = {Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
    const Qt::MouseButton button = buttons[number(4)];
    const QPointF from = somewhere(), to = somewhere();
    const auto modifiers = someModifiers();
    move(from, modifiers);
    press(from, modifiers, button);
    const int steps = number(6);
    for (int i = 1; i <= steps; ++i) move(from + (to - from) * i / steps, modifiers);
    if (number(8) == 0) key(Qt::Key_Escape);
    release(to, modifiers, button);
    return "drag";
  }
  std::string dragAFace() {
    if (document().scene().probes.empty() || !document().selectedProbe()) return "nothing";
    const Probe& selected = document().scene().probes[*document().selectedProbe()];
    const auto at =
        window_->viewport().view().pixel(faceCenterWorld(selected, kBoxFaces[static_cast<std::size_t>(number(6))]));
    if (!at) return "nothing";
    drag({at->x, at->y}, somewhere(), someModifiers(), 4);
    return "face";
  }
  std::string turnTheWheel() {
    const QPointF at = somewhere();
    QWheelEvent event(at, window_->viewport().mapToGlobal(at.toPoint()), {}, {0, number(2) == 0 ? 120 : -120}, {},
                      someModifiers(), Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&window_->viewport(), &event);
    return "wheel";
  }
  std::string pressAKey() {
    static const Qt::Key keys[] = {Qt::Key_1,    Qt::Key_2,  Qt::Key_3,    Qt::Key_4,   Qt::Key_W,
                                   Qt::Key_A,    Qt::Key_S,  Qt::Key_D,    Qt::Key_F,   Qt::Key_P,
                                   Qt::Key_G,    Qt::Key_E,  Qt::Key_H,    Qt::Key_C,   Qt::Key_V,
                                   Qt::Key_Left, Qt::Key_Up, Qt::Key_Home, Qt::Key_Tab, Qt::Key_Escape};
    window_->viewport().setFocus();
    key(keys[number(20)], number(5) == 0 ? Qt::ShiftModifier : Qt::NoModifier);
    return "key";
  }
  std::string undoOrRedo() {
    window_->viewport().setFocus();
    key(Qt::Key_Z, number(3) == 0 ? Qt::ControlModifier | Qt::ShiftModifier : Qt::ControlModifier);
    return "undo";
  }
  std::string chooseFromTheMenu() {
    // What ends the program, writes files or runs for minutes is not the monkey's.
    static const char* const left[] = {"Quit",  "Reload", "recent", "Save",      "Export",    "Bake", "Place",
                                       "Lesso", "Open",   "Sky",    "Projector", "reference", "about"};
    std::vector<QAction*> all;
    std::vector<QMenu*> menus;
    for (QAction* top : window_->menuBar()->actions()) {
      if (top->menu() != nullptr) menus.push_back(top->menu());
    }
    while (!menus.empty()) {
      QMenu* menu = menus.back();
      menus.pop_back();
      for (QAction* action : menu->actions()) {
        const QString text = QString(action->text()).remove('&');
        if (std::any_of(std::begin(left), std::end(left), [&](const char* word) { return text.contains(word); }))
          continue;
        if (action->menu() != nullptr) {
          menus.push_back(action->menu());
        } else if (action->isEnabled() && !action->isSeparator()) {
          all.push_back(action);
        }
      }
    }
    if (all.empty()) return "nothing";
    QAction* action = all[static_cast<std::size_t>(number(static_cast<int>(all.size())))];
    const std::string text = action->text().toStdString();
    action->trigger();
    return "menu: " + text;
  }
  std::string useAPanel() {
    std::vector<QWidget*> all;
    for (QWidget* widget : window_->findChildren<QWidget*>()) {
      if (!widget->isVisible() || !widget->isEnabled()) continue;
      const bool takes = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QSlider*>(widget) ||
                         qobject_cast<QComboBox*>(widget) || qobject_cast<QLineEdit*>(widget);
      if (takes && widget->window() == window_) all.push_back(widget);
    }
    if (all.empty()) return "nothing";
    QWidget* widget = all[static_cast<std::size_t>(number(static_cast<int>(all.size())))];
    const std::string name = widget->objectName().toStdString();
    if (auto* slider = qobject_cast<QSlider*>(widget)) {
      slider->setValue(slider->minimum() + number(slider->maximum() - slider->minimum() + 1));
      return "slider: " + name;
    }
    if (auto* combo = qobject_cast<QComboBox*>(widget)) {
      combo->setFocus();
      combo->setCurrentIndex(number(combo->count()));
      emit combo->activated(combo->currentIndex());
      return "combo: " + name;
    }
    if (auto* line = qobject_cast<QLineEdit*>(widget)) {
      static const char* const texts[] = {"0", "1", "-1", "0.25", "2.5", "1e9", "", "abc", "9999999999"};
      line->setFocus();
      line->selectAll();
      QTest::keyClicks(line, texts[number(9)]);
      QTest::keyClick(line, Qt::Key_Return);
      return "line: " + name;
    }
    const QString text = qobject_cast<QAbstractButton*>(widget)->text();
    if (text.contains("ake") || text.contains("easure") || text.contains("ave")) return "nothing";  // minutes; files
    QTest::mouseClick(widget, Qt::LeftButton);
    return "button: " + name + " " + text.toStdString();
  }

  std::string something() {
    switch (number(10)) {
      case 0:
      case 1:
        return dragSomewhere();
      case 2:
      case 3:
        return dragAFace();
      case 4:
        return turnTheWheel();
      case 5:
        return pressAKey();
      case 6:
        return undoOrRedo();
      case 7:
        return chooseFromTheMenu();
      default:
        return useAPanel();
    }
  }

  std::mt19937 random_{static_cast<unsigned>(setting("BOXPROBE_MONKEY_SEED", 1))};
  QTimer refuse_;
  QMetaObject::Connection connection_;
};

TEST_F(MonkeyTest, BreaksNothing) {
  const int events = setting("BOXPROBE_MONKEY_EVENTS", 240);
  const std::string folder = std::string(BOXPROBE_DATA_DIR) + "/scenes/";
  std::map<double, std::string> longest;  // milliseconds, what took them
  for (const char* scene : {"building", "room", "gallery"}) {
    std::vector<std::string> sets;
    LoadedScene loaded = loadScene(folder + scene + ".boxprobe.json");
    for (Probe& probe : loaded.scene.probes) {
      probe.faceSize = 32;
      probe.samplesPerPixel = 1;
      probe.bounces = 1;
    }
    const Scene opened = loaded.scene;
    window_->showScene(std::move(loaded));
    waitUntilIdle();
    const double before = megabytesInUse();
    for (int i = 0; i < events / 3; ++i) {
      QElapsedTimer clock;
      clock.start();
      const std::string done = something();
      QCoreApplication::processEvents();
      longest[static_cast<double>(clock.nsecsElapsed()) * 1e-6] = std::string(scene) + ", " + done;
      if (longest.size() > 10) longest.erase(longest.begin());
      ASSERT_NO_THROW(validate(document().scene())) << done;
    }
    key(Qt::Key_Escape);
    window_->editor().finish();
    while (document().canUndo()) document().undo();
    EXPECT_TRUE(document().scene() == opened) << scene << ": undone, it is as it was opened";
    std::printf("%s: %d events, %.0f MB before, %.0f after\n", scene, events / 3, before, megabytesInUse());
  }
  for (auto each = longest.rbegin(); each != longest.rend(); ++each) {
    std::printf("%8.0f ms  %s\n", each->first, each->second.c_str());
  }
}

}  // namespace
}  // namespace boxprobe
