// See session_record.h.
#include "tests/gui/session_record.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QSlider>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "app/gui/edit/view_state.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/view/compare_views.h"
#include "app/gui/view/compare_wipe.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/view_tools.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/window_state.h"
#include "tests/support/kept_values.h"

namespace boxprobe {

namespace {

using Json = nlohmann::json;

constexpr int kWidth = 480, kHeight = 440;

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string oneLine(QString text) {
  return text.replace('\n', " / ").toStdString();
}

}  // namespace

std::string roundedText(double value) {
  constexpr double kOffTheBorder = 1.7e-6;
  char text[64];
  std::snprintf(text, sizeof text, "%.4f", value + kOffTheBorder);
  std::string shorter = text;
  while (shorter.back() == '0') shorter.pop_back();
  if (shorter.back() == '.') shorter.pop_back();
  return shorter == "-0" ? "0" : shorter;
}

std::string roundedText(const glm::dvec3& value) {
  return roundedText(value.x) + " " + roundedText(value.y) + " " + roundedText(value.z);
}

LoadedScene SessionTest::scene() const {
  LoadedScene loaded = smallBuilding({"probes.room.origin=[0.1,1.3,-0.4]", "probes.room.rotationDegrees=[3,17,-5]",
                                      "probes.room.faceSize=16",
                                      "probes.room.blendDistance={\"min\":[0.11,0.22,0.33],\"max\":"
                                      "[0.44,0.35,0.26]}",
                                      "exposure=1.3"});
  Probe other = loaded.scene.probes.front();
  other.name = "corner";
  other.box = {glm::dvec3(1.9, 0.2, -3.1), glm::dvec3(3.7, 2.3, -0.9)};
  other.influence = Box{glm::dvec3(1.6, 0.1, -3.5), glm::dvec3(3.9, 2.6, -0.6)};
  other.origin = {2.6, 1.1, -1.7};
  other.rotationDegrees = {0.0, -8.0, 0.0};
  loaded.scene.probes.push_back(other);
  return loaded;
}

void SessionTest::SetUp() {
  // The scene of the test before is there, captured: only its history and marks are to be forgotten.
  static Scene shown;
  if (sharedWindow() && !shown.probes.empty() && sharedWindow()->document().scene() == shown) {
    window_ = sharedWindow().get();
    window_->findChild<QTabWidget*>("inspectors")->setCurrentIndex(0);
    window_->viewport().setFocus();
  } else {
    WindowTest::SetUp();
    shown = document().scene();
  }
  sizePicture(QSize(kWidth, kHeight));
  document().restore(Document::State::opened(shown, document().path(), "room"));
  emit window_->editor().settled();
  // It is measured beside the window, and its marks over the picture take the mouse.
  window_->findChild<QCheckBox*>("liveError")->setChecked(false);
  window_->statusBar()->clearMessage();
  window_->viewState().selectObjects({"floor"});
  window_->viewState().selectObjects({});
  choose("View > Reset view");
  move({3.0, 3.0});  // where no handle is, for the cursor
  move({-3.0, -3.0});
  setDrawn(false);
  turn();
  connections_.push_back(
      QObject::connect(window_->statusBar(), &QStatusBar::messageChanged, [this](const QString& text) {
        if (!text.isEmpty() && (messages_.empty() || messages_.back() != oneLine(text))) {
          messages_.push_back(oneLine(text));
        }
      }));
  forget();
}

// What events change is there before it is drawn, and drawing takes a hundred times as long.
void SessionTest::setDrawn(bool drawn) {
  window_->viewport().window3d()->SetReadyForRendering(drawn);
  if (drawn) window_->scheduler().requestRender();
}

void SessionTest::TearDown() {
  for (const auto& connection : connections_) QObject::disconnect(connection);
  window_->tools().stopComparing();
  window_->probeWidget().setMode(HandleMode::Box);
  window_->viewState().showAll();
  undoAll();
  setDrawn(true);
}

void SessionTest::turn() {
  for (int i = 0; i < 4; ++i) QCoreApplication::processEvents();
}

// Edges that do not depend on how long words are.
void SessionTest::addOverlays(std::map<std::string, std::string>& all) {
  const auto& picture = window_->viewport();
  const auto place = [&](const char* name, const auto& text) {
    const auto* widget = picture.findChild<QWidget*>(name, Qt::FindChildrenRecursively);
    const bool seen = widget != nullptr && widget->isVisible();
    all[std::string("over ") + name] = seen ? text(widget->geometry()).toStdString() : "hidden";
  };
  const auto whole = [](const QRect& r) {
    return QString("%1 %2 %3x%4").arg(r.x()).arg(r.y()).arg(r.width()).arg(r.height());
  };
  for (const char* name : {"compare", "compareDivider", "compareViews", "compareView0", "compareView1", "compareView2",
                           "compareView3", "heldPicture", "welcome"}) {
    place(name, whole);
  }
  place("axisGizmo",
        [&](const QRect& r) { return QString("%1 %2").arg(picture.width() - r.x() - r.width()).arg(r.y()); });
  // At an edge they stop.
  place("compareLeft", [](const QRect& r) {
    return (r.x() > 8 ? QString("to %1").arg(r.x() + r.width()) : QString("from 8")) +
           QString(", %1").arg(r.y() + r.height());
  });
  place("compareRight", [](const QRect& r) {
    return (r.x() + r.width() < kWidth - 8 ? QString("from %1").arg(r.x()) : QString("to the edge")) +
           QString(", %1").arg(r.y() + r.height());
  });
  place("importBar", [](const QRect& r) { return QString("about %1, from %2").arg(r.center().x()).arg(r.y()); });
  place("keys", [](const QRect& r) { return QString("%1 %2, %3 wide").arg(r.x()).arg(r.y()).arg(r.width()); });
  for (const char* name : {"compareLeft", "compareRight"}) {
    const auto* label = picture.findChild<QLabel*>(name);
    // How far a trace is changes by itself.
    const QString text = label->text().section(':', 0, 0).section(',', 0, 0);
    if (label->isVisible()) all[std::string("text ") + name] = oneLine(text);
  }
  for (const QLabel* label : picture.findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (!label->objectName().isEmpty() || !label->isVisible()) continue;
    all["readout"] += oneLine(label->text());
    // Beside the pointer, and within the picture: how wide its text is depends on the fonts.
    EXPECT_EQ(label->size(), label->sizeHint());
    const QPoint beside = pointer().toPoint() + QPoint(22, 22),
                 most(picture.width() - label->width(), picture.height() - label->height());
    EXPECT_EQ(label->x(), std::min(beside.x(), most.x())) << label->text().toStdString();
    EXPECT_EQ(label->y(), std::min(beside.y(), most.y())) << label->text().toStdString();
  }
}

std::map<std::string, std::string> SessionTest::state() {
  std::map<std::string, std::string> all;
  const Json scene = Json::parse(sceneText(document().scene(), "/")).flatten();
  for (const auto& [path, value] : scene.items()) {
    all[path] = value.is_number() ? roundedText(value.get<double>()) : value.dump();
  }
  for (const std::size_t index : window_->editor().selected()) all["selected"] += " " + std::to_string(index);
  const auto shown = document().selectedProbe();
  all["selected"] += shown ? ", of them " + std::to_string(*shown) : " none";
  const ViewState& view = window_->viewState();
  for (const Probe& each : document().scene().probes) {
    const auto part = ViewState::Part::Probe;
    all["eye of " + each.name] = std::string(view.shown(part, each.name) ? "shown" : "hidden") +
                                 (view.locked(part, each.name) ? ", locked" : "");
  }
  all["objects"] = std::string(view.isolated()    ? "isolated"
                               : view.anyHidden() ? "some hidden"
                                                  : "shown") +
                   ", selected: " + joined(view.objects());
  const WindowView& drawn = window_->renderer().windowView();
  const std::string hidden = joined(drawn.hidden);
  all["drawn"] = "without " + (hidden.size() < 60 ? hidden : std::to_string(drawn.hidden.size())) + ", outlined " +
                 joined(drawn.outlined);
  if (drawn.cutaway) {
    all["drawn"] += ", cut " + roundedText(drawn.cutaway->box.min) + " to " + roundedText(drawn.cutaway->box.max) +
                    " turned " + roundedText(drawn.cutaway->rotationDegrees);
  }
  const Camera camera = window_->renderer().currentCamera();
  all["camera"] = roundedText(camera.position) + " to " + roundedText(camera.target) + " up " + roundedText(camera.up) +
                  " fov " + roundedText(camera.verticalFovDegrees) +
                  (camera.parallelHeight > 0.0 ? " parallel " + roundedText(camera.parallelHeight) : "");
  for (const auto& [name, action] : menuEntries(*window_->menuBar())) {
    // Those have files of tests before, too.
    if (name.rfind("File > Open recent >", 0) != 0) all["entry " + name] = stateOf(*action);
  }
  for (const QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
    all["dock " + dock->objectName().toStdString()] = dock->isVisible() ? "shown" : "hidden";
  }
  for (const QToolBar* bar : window_->findChildren<QToolBar*>()) {
    all["bar " + bar->objectName().toStdString()] = bar->isVisible() ? "shown" : "hidden";
  }
  all["bar of menus"] = window_->menuBar()->isVisible() ? "shown" : "hidden";
  all["status bar"] = window_->statusBar()->isVisible() ? "shown" : "hidden";
  all["title"] = window_->windowTitle().toStdString();
  all["page"] = std::to_string(window_->findChild<QTabWidget*>("inspectors")->currentIndex());
  for (const char* name : {"probeName", "objectName", "sceneName", "animationText"}) {
    all[name] = window_->findChild<QLabel*>(name)->text().toStdString();
  }
  for (const char* name : {"worstSpotBack", "modelKind", "animationRest"}) {
    const auto* button = window_->findChild<QAbstractButton*>(name);
    all[name] = (button->isVisible() ? button->text().toStdString() : "hidden") +
                std::string(button->isEnabled() ? "" : ", grey") + (button->isChecked() ? ", on" : "");
  }
  all["animationTime"] = std::to_string(window_->findChild<QSlider*>("animationTime")->value());
  all["steps"] = std::to_string(document().position()) + " of " + std::to_string(document().stepLabels().size());
  if (document().previewing()) all["steps"] += ", and a preview";
  all["changed"] = window_->isWindowModified() ? "yes" : "no";
  all["cursor"] = std::to_string(static_cast<int>(window_->viewport().cursor().shape()));
  addOverlays(all);
  return all;
}

// Of this run alone, and with or without the slash before it.
std::string SessionTest::withoutFolders(std::string text) const {
  const std::string own = folder_.path().mid(1).toStdString(), data = std::string(BOXPROBE_DATA_DIR).substr(1);
  for (const auto& [folder, word] : {std::pair(own, "FOLDER"), std::pair(data, "DATA")}) {
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder)) {
      const std::size_t from = at > 0 && text[at - 1] == '/' ? at - 1 : at;
      text.replace(from, at + folder.size() - from, word);
    }
  }
  return text;
}

void SessionTest::note(const std::string& what) {
  turn();
  auto now = state();
  std::string line = what + ":" + differing(known_, now);
  for (const std::string& message : messages_) line += " | " + message;
  lines_.push_back(withoutFolders(line));
  known_ = std::move(now);
  messages_.clear();
}

void SessionTest::choose(const std::string& entry) {
  for (const auto& [name, action] : menuEntries(*window_->menuBar())) {
    if (name == entry) return action->trigger();
  }
  ADD_FAILURE() << "no menu has " << entry;
}

std::string SessionTest::entriesOf(const QMenu& menu) {
  std::string text;
  for (const QAction* action : menu.actions()) {
    const std::string name = QString(action->text()).remove('&').toStdString();
    const std::string marked = action->isChecked() ? name + " on" : name;
    text += ", " + (action->isSeparator() ? "[" + name + "]" : action->isEnabled() ? marked : "(" + marked + ")");
  }
  return text.empty() ? text : text.substr(2);
}

void SessionTest::undoAll() {
  while (document().canUndo()) window_->editor().undo();
}

void SessionTest::expectKept() {
  const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  test::expectKeptValues("gui/values/session_" + name + ".txt", lines_);
}

void SessionTest::wheel(const QPointF& at, int eighths, int sideways) {
  QWheelEvent event(at, window_->viewport().mapToGlobal(at.toPoint()), {}, {sideways, eighths}, Qt::NoButton, {},
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&window_->viewport(), &event);
}

void SessionTest::click(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  move(at, modifiers);
  press(at, modifiers);
  release(at, modifiers);
}

void SessionTest::dragWith(Qt::MouseButton button, const QPointF& from, const QPointF& by,
                           Qt::KeyboardModifiers modifiers) {
  move(from, modifiers);
  press(from, modifiers, button);
  for (int i = 1; i <= 3; ++i) move(from + by * i / 3.0, modifiers);
  release(from + by, modifiers, button);
}

void SessionTest::putCamera(const glm::dvec3& position, const glm::dvec3& target) {
  auto& renderer = const_cast<SceneRenderer&>(window_->renderer());
  Camera camera = renderer.currentCamera();
  camera.position = position;
  camera.target = target;
  camera.up = {0.0, 1.0, 0.0};
  camera.parallelHeight = 0.0;
  camera.verticalFovDegrees = 54.0;
  renderer.applyCamera(camera);
  emit window_->viewport().cameraMoved();
}

}  // namespace boxprobe
