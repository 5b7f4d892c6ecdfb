// The name, keys, state and tool tip of each entry of the menus, and what choosing it changes, against menu_values.txt.
#include <gtest/gtest.h>

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QTimer>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "app/gui/edit/view_state.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/window_state.h"
#include "tests/gui/window_test.h"
#include "tests/support/kept_values.h"

namespace boxprobe {
namespace {

using Json = nlohmann::json;

class MenuValuesTest : public WindowTest {
 protected:
  LoadedScene scene() const override {
    return smallBuilding({"probes.room.origin=[0.1,1.7,-0.4]", "probes.room.rotationDegrees=[3,17,-5]",
                          "sky.rotationDegrees=12", "exposure=1.3"});
  }

  std::vector<std::pair<std::string, QAction*>> entries() { return menuEntries(*window_->menuBar()); }

  QAction* entryAt(const std::string& path) {
    for (const auto& [name, action] : entries()) {
      if (name == path) return action;
    }
    return nullptr;
  }

  /// What can be told apart of the window: the scene, the selection, what is hidden, the camera, entries, panels.
  std::map<std::string, std::string> state() {
    std::map<std::string, std::string> all;
    const Json scene = Json::parse(sceneText(document().scene(), std::string(BOXPROBE_DATA_DIR) + "/scenes")).flatten();
    for (const auto& [path, value] : scene.items()) all["scene " + path] = value.dump();
    for (const std::size_t index : window_->editor().selected()) all["selected"] += " " + std::to_string(index);
    const ViewState& view = window_->viewState();
    for (const Probe& each : document().scene().probes) {
      all["probe " + each.name] = view.shown(ViewState::Part::Probe, each.name) ? "shown" : "hidden";
    }
    all["objects"] = view.isolated() ? "isolated" : view.anyHidden() ? "some hidden" : "shown";
    const Camera camera = window_->renderer().currentCamera();
    char text[400];
    std::snprintf(text, sizeof text, "%.3f %.3f %.3f to %.3f %.3f %.3f", camera.position.x, camera.position.y,
                  camera.position.z, camera.target.x, camera.target.y, camera.target.z);
    all["camera"] = text;
    for (const auto& [name, action] : entries()) all["entry " + name] = stateOf(*action);
    // What panels hold comes and goes with what is measured beside the window.
    for (const QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
      all["dock " + dock->objectName().toStdString()] = dock->isVisible() ? "shown" : "hidden";
    }
    all["counters"] = window_->findChild<QWidget*>("workCounters")->isVisible() ? "shown" : "hidden";
    return all;
  }

  static void turn() {
    for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
  }

  /// Entries that open a file dialog, end the window, start work in the background, or depend on the desktop.
  static bool leftOut(const std::string& path) {
    for (const char* part :
         {"...", "Quit", "about", "Fit", "Place", "Bake", "Theme", "Language", "Compare", "Projector", "Keys", "Paste",
          "Copy", "Open recent", "Reload", "Save", "Expose auto", "Cancel", "History"}) {
      if (path.find(part) != std::string::npos) return true;
    }
    return false;
  }
};

TEST_F(MenuValuesTest, EachEntryHasItsNameAndDoesWhatItDid) {
  sizePicture({760, 520});  // cameras stand by its shape
  // Dialogs are closed, and that there was one is noted.
  bool asked = false;
  QTimer dialogs;
  QObject::connect(&dialogs, &QTimer::timeout, [&asked] {
    if (QWidget* dialog = QApplication::activeModalWidget()) asked = dialog->close();
  });
  dialogs.start(50);
  std::vector<std::string> lines;
  for (const auto& [name, action] : entries()) {
    QStringList keys;
    for (const QKeySequence& key : action->shortcuts()) keys << key.toString(QKeySequence::PortableText);
    lines.push_back("entry " + name + " [" + keys.join(", ").toStdString() + "] " + stateOf(*action) + " '" +
                    action->toolTip().toStdString() + "'");
  }
  turn();
  std::vector<std::string> paths;
  for (const auto& [name, action] : entries()) paths.push_back(name);
  for (const std::string& entryPath : paths) {
    QAction* action = entryAt(entryPath);  // some menus are filled anew
    if (action == nullptr || action->menu() != nullptr || !action->isEnabled() || leftOut(entryPath)) continue;
    const QPointer<QAction> chosen =
        action->actionGroup() != nullptr ? action->actionGroup()->checkedAction() : nullptr;
    const bool isSwitch = action->isCheckable() && action->actionGroup() == nullptr;
    window_->viewState().showAll();
    window_->editor().selectProbes({0});
    turn();
    const std::map<std::string, std::string> before = state();
    asked = false;
    action->trigger();
    turn();
    // A step of a field becomes one of the history when no other follows it for a while.
    if (differing(before, state()).find(" scene /") != std::string::npos) {
      EXPECT_TRUE(waitFor([&] { return document().canUndo(); })) << entryPath;
      turn();
    }
    lines.push_back("do " + entryPath + ":" + (asked ? " asks;" : "") + differing(before, state()));
    while (document().canUndo()) document().undo();
    if (chosen != nullptr) {
      chosen->trigger();
    } else if (QAction* again = isSwitch ? entryAt(entryPath) : nullptr) {
      again->trigger();
    }
    turn();
    const std::string left = differing(before, state());
    if (left != " nothing") lines.back() += " | and back:" + left;
  }
  test::expectKeptValues("gui/values/menu_values.txt", lines, test::kExactly);
}

}  // namespace
}  // namespace boxprobe
