// A monkey at the window: events of a fixed seed, over three scenes, by the ways a user has. Nothing may crash, throw
// or leave the document invalid; what is undone to the start is the scene as opened. How long the event loop was busy
// at most is printed by kind of event, for the machine decides it. Scenes are names of data/scenes, paths, or `dense`:
// a flat with things of 200,000 triangles, made here.
//   export BOXPROBE_MONKEY_EVENTS=5000 BOXPROBE_MONKEY_SEED=2 BOXPROBE_MONKEY_SCENES=building,dense,gallery
//   build/release/tests/gui/monkey_test
#include <gtest/gtest.h>
#include <unistd.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QTreeView>
#include <QWheelEvent>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "app/gui/panels/outliner.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/scene_reporter.h"
#include "data/scenes/glb_writer.h"
#include "tests/gui/block_meter.h"
#include "tests/gui/window_test.h"
#include "tests/support/made_flat.h"
#include "tests/support/sphere_mesh.h"

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

/// madeFlat() with four spheres of 51,200 triangles in its rooms.
std::string denseModel(const QString& folder) {
  Model model = test::madeFlat();
  Mesh sphere = test::sphereMesh(0.35F, 160, 160);
  Material shiny;
  shiny.name = "shiny";
  shiny.roughness = 0.2F;
  shiny.metallic = 1.0F;
  model.materials.push_back(shiny);
  sphere.material = static_cast<int>(model.materials.size()) - 1;
  sphere.name = "sphere";
  model.meshes.push_back(sphere);
  const int mesh = static_cast<int>(model.meshes.size()) - 1;
  for (const double x : {-3.0, -1.5, 1.5, 4.0}) {
    model.instances.push_back(
        {"sphere " + std::to_string(x), mesh, glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0.4, 0.9))});
  }
  QFile file(QDir(folder).filePath("dense.glb"));
  EXPECT_TRUE(file.open(QIODevice::WriteOnly));
  const std::string bytes = scenes::glbBytes(model);
  file.write(bytes.data(), static_cast<qint64>(bytes.size()));
  return file.fileName().toStdString();
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
    meter().setCounters({});  // an assertion may have ended the test before it did
  }

  void now(const std::string& what) { meter().setLabel(scene_ + ", " + what); }
  static BlockMeter& meter() { return *static_cast<BlockMeter*>(qApp); }
  /// Of a name of data/scenes, a path, or "dense".
  std::string fileOf(const QString& scene) const {
    if (scene == "dense") return denseModel(folder_.path());
    if (scene.contains('/')) return scene.toStdString();
    return std::string(BOXPROBE_DATA_DIR) + "/scenes/" + scene.toStdString() + ".boxprobe.json";
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
    now("menu: " + text);
    meter().during("menu", [action] { action->trigger(); });
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
    now("panel: " + name);
    if (auto* slider = qobject_cast<QSlider*>(widget)) {
      const int value = slider->minimum() + number(slider->maximum() - slider->minimum() + 1);
      meter().during("slider", [slider, value] { slider->setValue(value); });
      return "slider: " + name;
    }
    if (auto* combo = qobject_cast<QComboBox*>(widget)) {
      combo->setFocus();
      const int index = number(combo->count());
      meter().during("combo box", [combo, index] {
        combo->setCurrentIndex(index);
        emit combo->activated(combo->currentIndex());
      });
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

  std::string useTheOutliner() {
    const auto* outliner = window_->findChild<Outliner*>();
    QTreeView* tree = outliner->tree();
    std::vector<QModelIndex> rows;
    const std::function<void(const QModelIndex&)> collect = [&](const QModelIndex& parent) {
      for (int i = 0; i < tree->model()->rowCount(parent); ++i) {
        const QModelIndex row = tree->model()->index(i, 0, parent);
        rows.push_back(row);
        collect(row);
      }
    };
    collect({});
    if (rows.empty()) return "nothing";
    const QModelIndex row = rows[static_cast<std::size_t>(number(static_cast<int>(rows.size())))];
    tree->scrollTo(row);
    const QRect at = tree->visualRect(row.siblingAtColumn(number(OutlinerModel::kColumns)));
    const auto modifiers = someModifiers();
    now("outliner");
    meter().during("outliner", [&] {
      if (number(4) != 0) return QTest::mouseClick(tree->viewport(), Qt::LeftButton, modifiers, at.center());
      const std::unique_ptr<QMenu> menu = window_->findChild<Outliner*>()->menuFor(row);
      const QList<QAction*> actions = menu->actions();
      if (actions.isEmpty()) return;
      QAction* action = actions[number(actions.size())];
      if (!action->isSeparator() && action->isEnabled() && !action->text().contains("ake")) action->trigger();
    });
    return "outliner";
  }

  /// Small: what is written is another test's.
  std::string writeAReport() {
    ReviewSettings settings;
    settings.width = 32;
    settings.height = 18;
    settings.paths = 2;
    settings.samplesPerPixel = 1;
    window_->reporter().setSettings(settings);
    now("report");
    meter().during("report", [this] { window_->reporter().write(folder_.filePath("report.html")); });
    window_->reporter().setSettings({});
    return "report";
  }

  std::string something() {
    constexpr int kReports = 200;  // one in so many
    if (number(kReports) == 0) return writeAReport();
    switch (number(11)) {
      case 0:
      case 1:
        now("drag");
        return dragSomewhere();
      case 2:
      case 3:
        now("drag of a face");
        return dragAFace();
      case 4:
        now("wheel");
        return turnTheWheel();
      case 5:
        now("key");
        return pressAKey();
      case 6:
        now("undo");
        return undoOrRedo();
      case 7:
        return chooseFromTheMenu();
      case 8:
        return useTheOutliner();
      default:
        return useAPanel();
    }
  }

  std::mt19937 random_{static_cast<unsigned>(setting("BOXPROBE_MONKEY_SEED", 1))};
  std::string scene_;
  QTemporaryDir folder_;
  QTimer refuse_;
  QMetaObject::Connection connection_;
};

TEST_F(MonkeyTest, BreaksNothing) {
  const int events = setting("BOXPROBE_MONKEY_EVENTS", 240);
  const QStringList scenes = qEnvironmentVariable("BOXPROBE_MONKEY_SCENES", "building,dense,gallery").split(',');
  meter().setCounters([this] { return counters(); });
  meter().forget();
  for (const QString& name : scenes) {
    const std::string scene = name.toStdString();
    LoadedScene loaded = loadScene(fileOf(name));
    for (Probe& probe : loaded.scene.probes) {
      probe.faceSize = 32;
      probe.samplesPerPixel = 1;
      probe.bounces = 1;
    }
    const Scene opened = loaded.scene;
    loaded.exposureAutomatic = false;  // the first picture would set it
    scene_ = scene;
    now("opening");
    meter().during("a scene shown", [&] { window_->showScene(std::move(loaded)); });
    waitUntilIdle();
    const double before = megabytesInUse();
    const int share = events / static_cast<int>(scenes.size());
    for (int i = 0; i < share; ++i) {
      const std::string done = something();
      QCoreApplication::processEvents();
      ASSERT_NO_THROW(validate(document().scene())) << done;
    }
    key(Qt::Key_Escape);
    window_->editor().finish();
    while (document().canUndo()) document().undo();
    EXPECT_TRUE(document().scene() == opened) << scene << ": undone, it is as it was opened";
    std::printf("%s: %d events, %.0f MB before, %.0f after\n", scene.c_str(), share, before, megabytesInUse());
  }
  meter().setCounters({});
  std::printf("%s", meter().table().c_str());
}

}  // namespace
}  // namespace boxprobe
