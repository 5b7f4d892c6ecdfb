// Sessions with the window's commands: exposure, sky, copies, history, cameras by their dialogs, files, animation,
// comparison, what is hidden for a projector. See session_values_test.cpp.
#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QSlider>
#include <QStatusBar>
#include <QTest>
#include <QToolButton>
#include <QUrl>

#include "app/gui/edit/view_state.h"
#include "app/gui/view/compare_wipe.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/window/file_commands.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/projector.h"
#include "app/gui/window/view_tools.h"
#include "filters/io/image/image_file.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/session_record.h"
#include "tests/unit/io_glb_builder.h"

namespace boxprobe {
namespace {

class SessionWindowTest : public SessionTest {
 protected:
  void step(const std::string& entry) {
    choose(entry);
    rest();
    note(entry.substr(entry.rfind('>') + 2));
  }
  /// What is previewed becomes a step by itself.
  void rest() {
    ASSERT_TRUE(waitFor([this] { return !document().previewing(); }));
  }
  void strike(Qt::Key pressed, Qt::KeyboardModifiers modifiers, const char* what) {
    key(pressed, modifiers);
    rest();
    note(what);
  }
  void seen(const std::shared_ptr<SeenDialog>& dialog) {
    lines_.push_back("dialog: " + told(dialog->text).substr(0, 80));
  }
  std::string told(QString text) const {
    return text.replace(folder_.path(), "FOLDER").replace('\n', " / ").toStdString();
  }
  bool drop(const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile("/nowhere/else.txt"), QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_, &enter);
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window_, &event);
    return enter.isAccepted();
  }
  void write(const QString& path, const std::string& bytes) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
  }
  void writeSky(const QString& path) {
    ImageRgbaF picture{8, 4, std::vector<float>(8 * 4 * 4, 0.5F)};
    saveExr(path.toStdString(), picture);
  }
};

TEST_F(SessionWindowTest, LightAndPicture) {
  for (int i = 0; i < 2; ++i) step("View > Exposure > Brighter");
  step("View > Exposure > Darker");
  strike(Qt::Key_BracketRight, {}, "]");
  auto* slider = window_->findChild<QWidget*>("exposureInBar")->findChild<QSlider*>();
  lines_.push_back("slider " + std::to_string(slider->value()) + " of " + std::to_string(slider->minimum()) + " to " +
                   std::to_string(slider->maximum()));
  slider->setValue(-17);
  rest();
  note("slider");
  slider->setValue(-60);
  step("View > Exposure > Darker");
  for (const char* tone : {"AgX", "ACES", "None", "Khronos PBR Neutral"}) {
    step(std::string("View > Tone mapping > ") + tone);
  }
  for (const char* background : {"Grey", "Blurred environment", "Environment"}) {
    step(std::string("View > Background > ") + background);
  }
  step("View > Ground shadow");
  step("View > Ambient occlusion");
  step("View > Ground shadow");
  step("View > Turn the sky > To the left");
  writeSky(inFolder("sky.exr"));
  lines_.push_back(drop(inFolder("sky.exr")) ? "taken" : "refused");
  note("a sky dropped");
  step("View > Turn the sky > To the left");
  step("View > Turn the sky > To the right");
  step("View > Turn the sky > To the right");
  dragWith(Qt::LeftButton, {60.0, 60.0}, {-41.0, 30.0}, Qt::ControlModifier | Qt::ShiftModifier);
  note("the sky dragged");
  for (int i = 0; i < 35; ++i) choose("View > Turn the sky > To the right");
  note("all around");
  auto* history = window_->findChild<QMenu*>("history");
  emit history->aboutToShow();
  lines_.push_back("history: " + entriesOf(*history));
  const QList<QAction*> steps = history->actions();
  steps[steps.size() / 2]->trigger();
  note("history, the middle one");
  emit history->aboutToShow();
  lines_.push_back("history: " + entriesOf(*history));
  for (const char* entry : {"View > Probe boxes and handles", "View > Reflections from probes", "View > Refine at rest",
                            "Debug > Work counters in the status bar", "Help > Keys over the picture"}) {
    step(entry);
    step(entry);
  }
  undoAll();
  note("undone");
  expectKept();
}

TEST_F(SessionWindowTest, ProbesAndCameras) {
  step("Edit > Duplicate probe");
  step("Edit > Duplicate probe");
  window_->editor().selectProbes({0, 1});
  note("two");
  step("Edit > Copy 2 probes");
  step("Edit > Paste probes");
  QApplication::clipboard()->setText("[{\"name\": \"room\", \"origin\": [1, 2, 3]}]");
  step("Edit > Paste probes");
  QApplication::clipboard()->setText("{\"name\": \"new\", \"origin\": [0, 1, 0]}");
  step("Edit > Paste probes");
  QApplication::clipboard()->setText("{\"probes\": [{\"name\": \"p\"}, {\"name\": \"q\"}]}");
  step("Edit > Paste probes");
  for (const char* bad : {"{\"probes\": []}", "3", "nonsense", "{\"format\": \"boxprobe-scene\", \"version\": 1}"}) {
    QApplication::clipboard()->setText(bad);
    step("Edit > Paste probes");
  }
  QApplication::clipboard()->clear();
  step("Edit > Paste probes");
  window_->editor().selectProbes({1, 2, 3});
  step("Edit > Delete 3 probes");
  strike(Qt::Key_Z, Qt::ControlModifier, "undone");
  strike(Qt::Key_Y, Qt::ControlModifier, "redone");
  strike(Qt::Key_Z, Qt::ControlModifier, "undone");
  undoAll();
  note("all undone");
  window_->editor().selectProbe(1);
  step("Edit > Delete probe");
  step("Edit > Delete probe");
  step("Edit > Copy probe");
  strike(Qt::Key_Z, Qt::ControlModifier, "undone");
  strike(Qt::Key_Z, Qt::ControlModifier, "undone");
  window_->editor().commitOne("Rename", [](Probe& edited) { edited.name = "renamed"; });
  note("renamed");
  window_->viewState().setHidden(ViewState::Part::Probe, {"renamed"}, true);
  window_->viewState().setLocked(ViewState::Part::Probe, {"room"}, true);
  strike(Qt::Key_Z, Qt::ControlModifier, "undone");
  window_->editor().commit("Swap", [](Scene& edited) { std::swap(edited.probes[0].name, edited.probes[1].name); });
  note("names swapped");
  window_->viewState().setLocked(ViewState::Part::Probe, {"room"}, false);
  undoAll();

  auto dialog = answerInputDialog("desk");
  choose("View > Camera > Store this view...");
  ASSERT_TRUE(waitFor([&] { return !dialog->text.isEmpty(); }));
  seen(dialog);
  note("stored");
  dialog = answerInputDialog("");
  choose("View > Camera > Rename > top");
  ASSERT_TRUE(waitFor([&] { return !dialog->text.isEmpty(); }));
  seen(dialog);
  note("not renamed");
  dialog = answerInputDialog("above & below");
  choose("View > Camera > Rename > top");
  ASSERT_TRUE(waitFor([&] { return !dialog->text.isEmpty(); }));
  note("renamed");
  step("View > Camera > above  below");
  undoAll();
  expectKept();
}

TEST_F(SessionWindowTest, Files) {
  auto dialog = answerFileDialog(inFolder("mine"));
  choose("File > Save as...");
  seen(dialog);
  note("saved as mine");
  choose("View > Tone mapping > AgX");
  note("edited");
  choose("File > Save");
  note("saved");
  choose("View > Tone mapping > ACES");
  auto question = answerMessageBox(QMessageBox::Cancel);
  choose("File > Reload");
  seen(question);
  note("not reloaded");
  window_->editor().selectProbe(0);
  putCamera({3.0, 3.0, 5.0}, {0.0, 1.0, 0.0});
  note("another view");
  question = answerMessageBox(QMessageBox::Discard);
  choose("File > Reload");
  note("reloaded");
  choose("View > Tone mapping > ACES");
  question = answerMessageBox(QMessageBox::Cancel);
  lines_.push_back(window_->close() ? "closed" : "stays");
  seen(question);
  question = answerMessageBox(QMessageBox::Save);
  EXPECT_TRUE(window_->files().openPath(inFolder("mine.boxprobe.json")));
  seen(question);
  note("saved and opened");
  // Another scene of that name and no path.
  write(inFolder("bad.boxprobe.json"), "{\"format\": \"boxprobe-scene\", \"version\": 1, \"colour\": 3}");
  question = answerMessageBox(QMessageBox::Ok);
  EXPECT_FALSE(window_->files().openPath(inFolder("bad.boxprobe.json")));
  seen(question);
  note("a bad file");
  question = answerMessageBox(QMessageBox::Ok);
  EXPECT_FALSE(window_->files().openPath(inFolder("gone.boxprobe.json")));
  seen(question);
  note("none");
  question = answerMessageBox(QMessageBox::Ok);
  write(inFolder("bad.hdr"), "nothing");
  lines_.push_back(drop(inFolder("bad.hdr")) ? "taken" : "refused");
  seen(question);
  note("a bad sky");
  lines_.push_back(drop(inFolder("text.txt")) ? "taken" : "refused");
  note("a text");
  writeSky(inFolder("sky.EXR"));
  dialog = answerFileDialog(inFolder("sky.EXR"));
  choose("File > Sky from a picture...");
  seen(dialog);
  note("a sky");
  setDrawn(true);
  dialog = answerFileDialog(inFolder("shown"));
  choose("File > Export image...");
  seen(dialog);
  note("exported");
  setDrawn(false);
  const QImage picture(inFolder("shown.png"));
  lines_.push_back("picture of " + std::to_string(picture.width()) + " x " + std::to_string(picture.height()));
  question = answerMessageBox(QMessageBox::No);
  dialog = answerFileDialog(inFolder("shown"));
  choose("File > Export image...");
  seen(question);
  note("not written over");
  dialog = answerFileDialog(inFolder("mine.boxprobe.json"));
  question = answerMessageBox(QMessageBox::Discard);
  choose("File > Open...");
  seen(dialog);
  note("opened");
  auto* recent = window_->findChild<QAction*>();
  for (QMenu* menu : window_->findChildren<QMenu*>()) {
    if (menu->title().remove('&') == "Open recent") recent = menu->menuAction();
  }
  lines_.push_back("recent: " + told(recent->menu()->actions().value(0)->text()));
  const auto recovered = window_->files().saveRecovery();
  lines_.push_back("recovery: '" + told(QString::fromStdString(recovered)) + "'");
  choose("View > Tone mapping > None");
  for (int i = 0; i < 2; ++i) {
    lines_.push_back("recovery: '" + told(QString::fromStdString(window_->files().saveRecovery())) + "'");
  }
  undoAll();
  note("undone");
  expectKept();
}

TEST_F(SessionWindowTest, Animation) {
  const auto open = [this](float seconds) {
    GlbBuilder glb;
    glb.triangle();
    glb.node({{"mesh", 0}});
    const int times = glb.floats("SCALAR", 1, {0, seconds});
    glb.json["accessors"][static_cast<std::size_t>(times)]["min"] = {0};
    glb.json["accessors"][static_cast<std::size_t>(times)]["max"] = {seconds};
    const int moves = glb.floats("VEC3", 3, {0, 0, 0, 8, 0, 0});
    glb.json["animations"] = nlohmann::json::array(
        {{{"channels", nlohmann::json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}})},
          {"samplers", nlohmann::json::array({{{"input", times}, {"output", moves}}})}}});
    write(inFolder("moving.glb"), glb.glb());
    write(inFolder("moving.boxprobe.json"),
          "{\"format\": \"boxprobe-scene\", \"version\": 1, \"exposure\": 1.1, "
          "\"model\": \"moving.glb\", \"cameras\": {\"a\": {\"position\": [0, 0, 9], "
          "\"target\": [0, 0, 0]}}}");
    EXPECT_TRUE(window_->files().openPath(inFolder("moving.boxprobe.json")));
    note("opened, of " + roundedText(seconds) + " s");
  };
  auto* slider = window_->findChild<QSlider*>("animationTime");
  const auto shown = [this](double seconds, double length) {
    EXPECT_TRUE(waitFor([&] {
      return std::abs(window_->renderer().bounds().size().x - 1.0 - 8.0 * seconds / length) < 1e-3;
    })) << window_->renderer().bounds().size().x;
  };
  open(4.0F);
  slider->setValue(375);
  shown(1.5, 4.0);
  note("3/8");
  slider->setSliderDown(true);
  slider->setSliderPosition(500);
  shown(2.0, 4.0);
  note("held at 1/2");
  slider->setSliderPosition(125);
  shown(0.5, 4.0);
  note("held at 1/8");
  slider->setSliderDown(false);
  note("let go");
  auto* rest = window_->findChild<QToolButton*>("animationRest");
  rest->click();
  shown(0.0, 4.0);
  note("at rest");
  rest->click();
  note("and not");
  slider->setValue(1000);
  shown(4.0, 4.0);
  note("the end");
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  shown(0.0, 4.0);
  note("undone");
  undoAll();
  note("all undone");
  open(37.0F);
  slider->setValue(333);
  shown(12.32, 37.0);
  note("hundredths");
  undoAll();
  ASSERT_TRUE(QFile::remove(inFolder("moving.glb")));
  slider->setValue(500);
  EXPECT_TRUE(waitFor([this] { return window_->statusBar()->currentMessage().contains("moving.glb"); }));
  note("the file has gone");
  undoAll();
  window_->showScene(scene());
  note("another scene");
  expectKept();
}

TEST_F(SessionWindowTest, Comparisons) {
  const auto caption = [this](const char* name) {
    return waitFor([&] { return window_->findChild<QLabel*>("compareRight")->text() == name; });
  };
  auto* numbers = window_->findChild<QLabel*>("compareNumbers");
  const auto measured = [&] {
    EXPECT_TRUE(waitFor([&] { return !numbers->text().isEmpty(); }));
    const QRect at = numbers->geometry();
    const auto* line = window_->findChild<QLabel*>("compareRight");
    lines_.push_back("numbers: " + numbers->text().toStdString() + ", about " +
                     std::to_string((2 * at.x() + at.width() + 1) / 2) + ", " +
                     std::to_string(line->y() - at.y() - at.height()) + " above the line");
  };
  setDrawn(true);
  waitUntilIdle();
  key(Qt::Key_C);
  note("held");
  measured();
  note("measured");
  auto* divider = window_->findChild<QWidget*>("compareDivider");
  dragOver(divider, {7.0, 100.0}, {-113.0, 140.0}, 3);
  note("divider to the left");
  auto* wipe = window_->findChild<CompareWipe*>("compare");
  for (const double share : {1.3, 0.0, 0.97, 0.5}) {
    wipe->setDivider(share);
    note("divider at " + roundedText(wipe->divider()));
  }
  key(Qt::Key_V);
  note("flipped");
  wipe->setDivider(0.3);
  note("divider while flipped");
  key(Qt::Key_V);
  note("and back");
  key(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
  note("difference");
  EXPECT_TRUE(caption("Difference: Held"));
  measured();
  note("is there");
  choose("View > Cut away what hides the probe's box");
  note("cut");
  choose("View > Cut away what hides the probe's box");
  note("whole");
  choose("View > Camera > low");
  waitUntilIdle();
  note("another view");
  key(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
  note("no difference, there");
  choose("View > Camera > main");
  waitUntilIdle();
  note("back");
  key(Qt::Key_V);
  choose("View > Compare > With the reflection alone ray traced");
  note("reflection");
  choose("View > Compare > Stop comparing");
  note("stopped");
  key(Qt::Key_V, Qt::ShiftModifier);
  note("error");
  key(Qt::Key_C, Qt::AltModifier);
  note("four views");
  window_->findChild<QComboBox*>("compareView1")->setCurrentIndex(0);
  key(Qt::Key_C, Qt::AltModifier);
  note("no more");
  choose("View > Compare > With all light, path traced");
  note("traced");
  key(Qt::Key_Escape);
  note("Escape");
  key(Qt::Key_Escape);
  note("and again");
  wipe->setDivider(0.5);
  window_->findChild<QComboBox*>("compareView1")->setCurrentIndex(2);
  expectKept();
}

TEST_F(SessionWindowTest, FieldsAndChoices) {
  for (const QWidget* widget : window_->findChildren<QWidget*>()) {
    if (const auto* field = qobject_cast<const ValueField*>(widget)) {
      lines_.push_back("field from " + roundedText(field->minimum()) + " to " + roundedText(field->maximum()) + " by " +
                       roundedText(field->singleStep()) + ", decimals " + std::to_string(field->decimals()) + ", '" +
                       field->suffix().toStdString() + "', tip '" + field->toolTip().left(30).toStdString() + "'");
    } else if (const auto* combo = qobject_cast<const QComboBox*>(widget)) {
      std::string line = "choice " + combo->objectName().toStdString() + ":";
      for (int i = 0; i < combo->count(); ++i) {
        line += " '" + combo->itemText(i).toStdString() + "' " + combo->itemData(i).toString().toStdString() + " '" +
                combo->itemData(i, Qt::ToolTipRole).toString().left(12).toStdString() + "';";
      }
      lines_.push_back(line);
    }
  }
  expectKept();
}

TEST_F(SessionWindowTest, PanelsAndProjector) {
  for (const char* dock : {"Outliner", "Cubemap", "Debug", "Explain", "Cost", "Frame", "Inspector"}) {
    step(std::string("View > ") + dock);
    step(std::string("View > ") + dock);
  }
  const auto shown = [this](const char* what) {
    std::string text = what;
    for (const auto* widget : window_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
      if (widget->isVisible() && !widget->objectName().startsWith("qt_") && !widget->objectName().isEmpty()) {
        text += ", " + widget->objectName().toStdString();
      }
    }
    lines_.push_back(text);
  };
  shown("before");
  window_->findChild<QWidget*>("outliner")->hide();
  choose("View > Projector: the picture and the lesson alone");
  turn();
  shown("projector");
  lines_.push_back(window_->isFullScreen() ? "fills the screen" : "does not");
  key(Qt::Key_Escape);
  turn();
  shown("after");
  lines_.push_back(window_->isFullScreen() || window_->projector().on() ? "fills the screen" : "does not");
  window_->findChild<QWidget*>("outliner")->show();
  window_->showNormal();
  turn();
  expectKept();
}

}  // namespace
}  // namespace boxprobe
