// The lessons beside a learner's own work: that scene is put aside whole and comes back, tries are kept, tasks are done
// by real drags and typing, the projector's key, lesson files that cannot be read.
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "app/gui/edit/gauge_rows.h"
#include "app/gui/edit/probe_gauge.h"
#include "app/gui/explain/debug_view.h"
#include "app/gui/explain/picture_inset.h"
#include "app/gui/explain/surface_view_panel.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/lessons/lesson_progress.h"
#include "app/gui/panels/fit_panel.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"
#include "app/gui/window/file_commands.h"
#include "app/gui/window/projector.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/lesson_steps.h"

namespace boxprobe {
namespace {

/// A lesson of the tests' own: the program's may change their words and steps.
const char* const kLessonText = R"({
  "format": "boxprobe-lesson", "version": 1, "title": "A floor mirror", "chapter": "Box projection",
  "summary": "Looked up with R alone, a mirror shows the room as if it stood at the probe.",
  "scene": "SCENES/room.boxprobe.json",
  "set": {"probes.room.technique": "infinite"},
  "steps": [
    {"title": "Everything floats", "say": "Each point of the floor looks the cubemap up with its reflection vector.",
     "formula": "R = 2 (N \\cdot V) N - V", "camera": "A"},
    {"title": "The box knows", "say": "The ray is followed until it leaves the box.", "formula": "H = P + d R",
     "set": {"probes.room.technique": "box"}, "boxes": true, "rays": [[0.5, 0.75]],
     "question": {"ask": "Which direction is looked up?", "answers": [
       {"text": "R", "reply": "That was before."},
       {"text": "From the probe to where the ray leaves the box", "right": true, "reply": "Yes."}]}},
    {"title": "Your turn", "say": "The box is half a metre too large.", "boxes": true,
     "inset": {"plan": [0.62, 0.78], "corner": "top-left"},
     "set": {"probes.room.box.max": [4.5, 3, 3]}, "mayMove": "Drag the box's face.",
     "task": {"ask": "Make the box fit the room.", "measure": {"kind": "view", "name": "hit-error"}, "below": 0.02,
       "unit": "m", "praise": "The box is the room again.", "solution": {"probes.room.box.max": [4, 3, 3]},
       "mistake": {"probes.room.box.max": [5, 3, 3]}}}
  ],
  "claims": [{"say": "Bare R is worse.", "measure": {"kind": "error", "step": 1}, "above": 5,
    "times": {"kind": "error", "step": 2}}]
})";

class LessonTest : public LessonWindowTest {
 protected:
  void SetUp() override {
    LessonWindowTest::SetUp();
    QFile file(folder_.filePath("1-mirror.lesson.json"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(kLessonText).replace("SCENES", QByteArray(BOXPROBE_DATA_DIR) + "/scenes"));
    file.close();
    lessons().setFolder(folder_.path().toStdString());
  }

  static constexpr const char* kMirror = "mirror";
  static constexpr std::size_t kTask = 2;  ///< the step of it that asks for something to be done
  static constexpr BoxFace kPlusX{0, true};
  double face() const { return probe().box.max.x; }

  QTemporaryDir folder_;
};

/// With a scene of the learner's own, edited and not saved.
class OwnSceneTest : public LessonTest {
 protected:
  LoadedScene scene() const override { return smallBuilding(); }
  void SetUp() override {
    LessonTest::SetUp();
    window_->editor().commitProbe("Own edit", [](Probe& edited) { edited.intensity = 1.5; });
    window_->editor().commitProbe("Taken back", [](Probe& edited) { edited.intensity = 2.5; });
    document().undo();
    mine_ = document().scene();
  }
  void expectMine() {
    EXPECT_EQ(visit().lesson(), nullptr);
    EXPECT_EQ(document().scene(), mine_);
    EXPECT_EQ(document().path(), buildingPath());
    EXPECT_TRUE(document().modified());
    EXPECT_EQ(document().undoLabel(), "Own edit");
    EXPECT_EQ(document().redoLabel(), "Taken back");
    EXPECT_TRUE(window_->windowTitle().startsWith("building.boxprobe.json"));
    EXPECT_EQ(document().selectedProbe(), std::optional<std::size_t>(0));
  }
  Scene mine_;
};

TEST_F(OwnSceneTest, ComesBackWholeWithItsView) {
  drag({300, 300}, {380, 330});  // the camera
  const Camera camera = window_->renderer().currentCamera();
  const int view = findSurfaceView("hit-error").value();
  window_->debugView().surfacePanel()->choose(view);
  window_->findChild<QAction*>("showReflections")->setChecked(false);
  const auto models = window_->models();

  openFromList(kMirror);
  waitUntilIdle();
  EXPECT_TRUE(window_->windowTitle().startsWith("Lesson: "));
  EXPECT_FALSE(document().modified());
  EXPECT_FALSE(document().canUndo());
  EXPECT_NE(window_->models(), models);
  EXPECT_FALSE(window_->renderer().currentCamera() == camera);
  edit({"probes.room.intensity=3"});
  key(Qt::Key_Right);
  click("leaveLessons");

  expectMine();
  EXPECT_EQ(window_->models(), models) << "what is loaded is not loaded again";
  EXPECT_EQ(window_->renderer().currentCamera().position, camera.position);
  EXPECT_EQ(window_->renderer().currentCamera().verticalFovDegrees, camera.verticalFovDegrees);
  EXPECT_EQ(window_->debugView().surfacePanel()->settings().view, view);
  EXPECT_FALSE(window_->findChild<QAction*>("showReflections")->isChecked());
  EXPECT_TRUE(window_->findChild<QAction*>("showBoxes")->isChecked());
  window_->debugView().surfacePanel()->choose(0);
  window_->findChild<QAction*>("showReflections")->setChecked(true);
  waitUntilIdle();
}

// The first step of that lesson shows no reflections.
TEST_F(OwnSceneTest, IsCapturedAgainOnceALessonIsLeft) {
  const std::string name = probe().name;
  waitUntilIdle();
  ASSERT_EQ(window_->renderer().bakeState(name), BakeState::UpToDate);
  lessons().setFolder(lessonFolder());
  openFromList("black-mirror");
  waitUntilIdle();
  click("leaveLessons");
  EXPECT_TRUE(waitFor([&] { return window_->renderer().bakeState(name) == BakeState::UpToDate; }));
}

TEST_F(OwnSceneTest, ClosingAsksAboutItAndNeverAboutTheLessons) {
  openFromList(kMirror);
  edit({"probes.room.intensity=3"});
  const auto asked = answerMessageBox(QMessageBox::Cancel);
  EXPECT_FALSE(window_->close());
  EXPECT_TRUE(asked->text.contains("building.boxprobe.json")) << asked->text.toStdString();
  expectMine();
}

TEST_F(OwnSceneTest, SavingInALessonAsksForAName) {
  openFromList(kMirror);
  edit({"probes.room.intensity=3"});
  QTemporaryDir folder;
  const auto dialog = answerFileDialog(folder.filePath("try"));
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(dialog->text, "Save as");
  EXPECT_EQ(loadScene(folder.filePath("try.boxprobe.json").toStdString()).scene.probes.front().intensity, 3.0);

  const Lesson lesson = *visit().lesson();
  const QString own = QString::fromStdString(lesson.scene);
  EXPECT_FALSE(window_->files().mayWrite(own));
  EXPECT_TRUE(window_->files().mayWrite(folder.filePath("other.boxprobe.json")));
  click("leaveLessons");
  EXPECT_TRUE(window_->files().mayWrite(own));
  expectMine();
}

TEST_F(OwnSceneTest, TheDocksCrossLeavesTheLessons) {
  openFromList(kMirror);
  window_->findChild<QDockWidget*>("lessons")->close();
  expectMine();
}

TEST_F(LessonTest, OpensFromTheHelpMenuByTheMouse) {
  lessons().setFolder(lessonFolder());
  QMenuBar* bar = window_->menuBar();
  QAction* help = bar->actions().last();
  QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(help).center());
  QMenu* menu = help->menu();
  ASSERT_TRUE(QTest::qWaitFor([menu] { return menu->isVisible(); }, 60000));
  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(menu->actions().first()).center());
  EXPECT_TRUE(QTest::qWaitFor([this] { return shown("lesson:floor-mirror"); }, 60000));
  keepPicture("lesson_list");
  button("lesson:floor-mirror")->setFocus();
  key(Qt::Key_Return);
  ASSERT_NE(visit().lesson(), nullptr);
  EXPECT_EQ(visit().step(), 0u);
  waitUntilIdle();
  keepPicture("lesson_step");
}

TEST_F(LessonTest, TheStepsOfALessonShareTheirModelsAndThePictureStaysUntilTheNextIsThere) {
  openFromList(kMirror);
  waitUntilIdle();
  const auto models = window_->models();
  const QWidget* held = window_->findChild<QLabel*>("heldPicture");
  ASSERT_NE(held, nullptr);
  EXPECT_FALSE(held->isVisible());
  key(Qt::Key_Right);
  EXPECT_EQ(window_->models(), models);
  waitUntilIdle();
  EXPECT_FALSE(held->isVisible());
  lessons().setFolder(lessonFolder());
  click("lessonList");
  click("lesson:levels");
  EXPECT_TRUE(held->isVisible() || !window_->renderer().workPending()) << "the half-made picture must not show";
  waitUntilIdle();
  EXPECT_FALSE(held->isVisible());
}

TEST_F(LessonTest, TheInsetFollowsTheBoxAndGoesWithItsStep) {
  openFromList(kMirror);
  waitUntilIdle();
  EXPECT_FALSE(shown("lessonInset"));
  lessons().open(kMirror, kTask);
  waitUntilIdle();
  ASSERT_TRUE(shown("lessonInset"));
  const auto* inset = dynamic_cast<const PictureInset*>(window_->findChild<QWidget*>("lessonInset"));
  ASSERT_NE(inset, nullptr);
  const auto wall = [&] { return inset->view()->boxHigh->x + probe().origin.x; };
  EXPECT_NEAR(wall(), 4.5, 1e-5);
  keepPicture("lesson_inset");
  edit({"probes.room.box.max=[4.25,3,3]"});
  waitUntilIdle();
  ASSERT_TRUE(inset->view().has_value());
  EXPECT_NEAR(wall(), 4.25, 1e-5);
  key(Qt::Key_Left);
  waitUntilIdle();
  EXPECT_FALSE(shown("lessonInset"));
}

TEST_F(LessonTest, AStepsPictureIsWholeInANarrowWindowUntilTheCameraIsMoved) {
  openFromList(kMirror);
  const auto& cameras = document().scene().cameras;
  const auto stored = std::find_if(cameras.begin(), cameras.end(), [](const Camera& c) { return c.name == "A"; });
  ASSERT_NE(stored, cameras.end());
  const auto aspect = [&] { return static_cast<double>(window_->viewport().width()) / window_->viewport().height(); };
  const auto now = [&] { return window_->renderer().currentCamera().verticalFovDegrees; };
  // As wide as 16:10 at the stored camera's height.
  const auto whole = [&] {
    const double half = stored->verticalFovDegrees * std::acos(-1.0) / 360.0;
    return 360.0 / std::acos(-1.0) * std::atan(std::tan(half) * std::max(1.6 / aspect(), 1.0));
  };
  double before = 0.0;
  for (const QSize size : {QSize(1300, 700), QSize(1180, 1000), QSize(1240, 860)}) {
    window_->resize(size);
    ASSERT_TRUE(waitFor([&] { return aspect() != before; }));
    waitUntilIdle();
    before = aspect();
    EXPECT_NEAR(now(), whole(), 1e-6) << before;
  }
  ASSERT_LT(before, 1.4);
  const double moved = now();
  drag({300, 300}, {380, 330});
  window_->resize(1300, 700);
  ASSERT_TRUE(waitFor([&] { return aspect() != before; }));
  waitUntilIdle();
  EXPECT_NEAR(now(), moved, 1e-6);
  EXPECT_GT(std::abs(whole() - moved), 1.0);
}

TEST_F(LessonTest, ADragOfTheBoxDoesTheTask) {
  window_->resize(1440, 900);  // as it opens
  window_->openLesson(kMirror, kTask);
  waitForMeasure();
  EXPECT_FALSE(lessons().check().result()->done);
  keepPicture("lesson_task");
  EXPECT_TRUE(text("taskValue").contains("done below 0.02 m")) << text("taskValue").toStdString();
  ASSERT_NEAR(face(), 4.5, 1e-9);
  const QPointF there = facePixelAfter(kPlusX, -0.5), beside = facePixelAfter(kPlusX, -0.6);
  // The mouse takes and leaves it at whole pixels; how many there are is up to the height of menus and letters.
  const double pixel = 0.1 / std::hypot(there.x() - beside.x(), there.y() - beside.y());
  drag(facePixel(kPlusX), there, {}, 16);
  EXPECT_NEAR(face(), 4.0, pixel);
  // Shift moves a tenth as far, and so is ten times as exact.
  drag(facePixel(kPlusX), facePixelAfter(kPlusX, 10.0 * (4.0 - face())), Qt::ShiftModifier, 16);
  EXPECT_NEAR(face(), 4.0, 0.03);
  waitForMeasure();
  // As exact as the mouse can be; the rest by the field.
  EXPECT_LT(*lessons().check().result()->value, 0.05);
  auto* row = window_->findChild<VectorRow*>("boxMax");
  ASSERT_NE(row, nullptr);
  type(row->findChildren<ValueField*>().first(), "4");
  waitForMeasure();
  EXPECT_TRUE(lessons().check().result()->done) << text("taskValue").toStdString();
  EXPECT_TRUE(lessonProgress(kMirror).solved.contains(solvedTask(kTask)));
  EXPECT_TRUE(text("taskPraise").startsWith("Done."));
  keepPicture("lesson_task_done");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NE(face(), 4.0) << "undo works on the try";
}

TEST_F(LessonTest, ThePanelOfAStep) {
  window_->openLesson(kMirror, 1);
  waitUntilIdle();
  click("answer1");
  EXPECT_EQ(text("reply"), "Yes.");
  const QWidget* formula = window_->findChild<QWidget*>("stepFormula");
  EXPECT_TRUE(formula->isVisible());
  EXPECT_GT(formula->height(), 20);
  const QString folder = qEnvironmentVariable("BOXPROBE_TEST_OUTPUT");
  if (!folder.isEmpty()) window_->findChild<QDockWidget*>("lessons")->grab().save(folder + "/lesson_panel.png");
  keepPicture("lesson_rays");
}

TEST_F(LessonTest, NoErrorIsShownOfARoomThatIsWrongOnPurpose) {
  auto* rows = window_->findChild<GaugeRows*>();
  EXPECT_TRUE(rows->isVisibleTo(rows->parentWidget()));
  openFromList(kMirror);
  EXPECT_FALSE(rows->isVisibleTo(rows->parentWidget()));
  EXPECT_FALSE(window_->findChild<FitPanel*>()->gauge().gauge().has_value());
  window_->lessons().leave();
  EXPECT_TRUE(rows->isVisibleTo(rows->parentWidget()));
}

TEST_F(LessonTest, ATryIsKeptBesideTheLessonsScene) {
  window_->openLesson(kMirror, kTask);
  EXPECT_FALSE(shown("showTry"));
  edit({"probes.room.box.max=[4.2,3,3]"});
  EXPECT_TRUE(button("showTry")->isChecked());
  key(Qt::Key_Left);
  EXPECT_EQ(visit().step(), kTask - 1);
  EXPECT_EQ(face(), 4.0) << "the step before as the lesson has it";
  EXPECT_FALSE(shown("showTry"));
  key(Qt::Key_Right);
  EXPECT_EQ(face(), 4.5) << "the step as the lesson has it";
  EXPECT_TRUE(button("showLessonScene")->isChecked());
  click("showTry");
  EXPECT_EQ(face(), 4.2);
  click("showLessonScene");
  EXPECT_EQ(face(), 4.5);
  document().undo();
  EXPECT_EQ(face(), 4.2);
  click("showLessonScene");

  // Edits of the lesson's scene are a new try; the one before is under it.
  edit({"probes.room.box.max=[4.8,3,3]"});
  EXPECT_TRUE(button("showTry")->isChecked());
  document().undo();
  EXPECT_EQ(face(), 4.5);
  document().undo();
  EXPECT_EQ(face(), 4.2);
  document().redo();
  document().redo();

  click("startOver");
  EXPECT_EQ(face(), 4.5);
  EXPECT_FALSE(shown("showTry"));
  document().undo();
  EXPECT_EQ(face(), 4.8) << "undo brings it back";
  EXPECT_TRUE(shown("showTry"));
  EXPECT_EQ(lessonScene(*visit().lesson(), kTask).probes.front().box.max.x, 4.5);

  // For the rest of the time the program runs, lessons left and opened again.
  click("leaveLessons");
  window_->openLesson(kMirror, kTask);
  click("showTry");
  EXPECT_EQ(face(), 4.8);
  click("startOver");
}

TEST_F(LessonTest, ArrowKeysTurnStepsUnlessTheyAreWantedElsewhere) {
  window_->openLesson(kMirror, 0);
  key(Qt::Key_Right);
  EXPECT_EQ(visit().step(), 1u);
  auto* field = window_->findChild<VectorRow*>("boxMax")->findChildren<ValueField*>().first();
  field->setFocus();
  key(Qt::Key_Left);
  EXPECT_EQ(visit().step(), 1u) << "a text field goes through its digits";
  window_->viewport().setFocus();
  key(Qt::Key_PageUp);
  EXPECT_EQ(visit().step(), 0u);
  key(Qt::Key_Left);
  EXPECT_EQ(visit().step(), 0u);
  click("leaveLessons");
  key(Qt::Key_Right);
  EXPECT_EQ(visit().lesson(), nullptr);
}

TEST_F(LessonTest, OneKeyLeavesThePictureAndTheLessonInLargeType) {
  window_->openLesson(kMirror, 1);
  waitUntilIdle();
  const auto* say = window_->findChild<QLabel*>("stepText");
  const int letters = say->fontInfo().pixelSize();
  EXPECT_GE(letters, QFontInfo(window_->font()).pixelSize() + 2) << "large enough to read beside a picture";
  const auto* probes = window_->findChild<QDockWidget*>("probes");
  const auto* lesson = window_->findChild<QDockWidget*>("lessons");
  ASSERT_TRUE(probes->isVisible());
  for (const Qt::Key back : {Qt::Key_F11, Qt::Key_Escape}) {
    key(Qt::Key_F11);
    QCoreApplication::processEvents();
    EXPECT_FALSE(probes->isVisible());
    EXPECT_FALSE(window_->menuBar()->isVisible());
    EXPECT_FALSE(window_->statusBar()->isVisible());
    EXPECT_TRUE(lesson->isVisible());
    EXPECT_TRUE(window_->isFullScreen());
    EXPECT_GT(say->fontInfo().pixelSize(), letters * 4 / 3);
    key(Qt::Key_Right);
    EXPECT_EQ(visit().step(), 2u);
    key(Qt::Key_Left);
    waitUntilIdle();
    if (back == Qt::Key_F11) keepPicture("lesson_projector");
    key(back);
    QCoreApplication::processEvents();
    EXPECT_FALSE(window_->projector().on());
    EXPECT_TRUE(probes->isVisible());
    EXPECT_TRUE(window_->menuBar()->isVisible());
    EXPECT_TRUE(window_->statusBar()->isVisible());
    EXPECT_TRUE(lesson->isVisible());
    EXPECT_FALSE(window_->isFullScreen());
    EXPECT_EQ(say->fontInfo().pixelSize(), letters);
  }
}

TEST_F(LessonTest, ProgressIsKeptShownAndForgotten) {
  window_->openLesson(kMirror, 1);
  click("leaveLessons");
  EXPECT_EQ(lessonProgress(kMirror).furthest, 1);
  EXPECT_EQ(lastLesson(), kMirror);
  openFromList(kMirror);
  EXPECT_EQ(visit().step(), 1u) << "where it was left off";
  key(Qt::Key_F1);
  EXPECT_TRUE(shown("leaveLessonsFromList"));
  const auto asked = answerMessageBox(QMessageBox::Yes);
  click("forgetProgress");
  EXPECT_FALSE(asked->text.isEmpty()) << "it cannot be undone";
  EXPECT_EQ(lessonProgress(kMirror).furthest, -1);
  EXPECT_FALSE(button("forgetProgress")->isEnabled());
}

TEST_F(LessonTest, AFormerNameOpensWhereThatLessonWent) {
  lessons().setFolder(lessonFolder());
  window_->openLesson("in-the-cubemap");
  ASSERT_NE(visit().lesson(), nullptr);
  EXPECT_EQ(visit().lesson()->name, "floor-mirror");
  EXPECT_EQ(visit().step(), 2u);
  window_->openLesson("sphere-proxy");
  EXPECT_EQ(visit().lesson()->name, "proxies");
  EXPECT_EQ(visit().step(), 1u);
  EXPECT_FALSE(window_->files().mayWrite(QString::fromStdString(visit().lesson()->scene)));
  EXPECT_FALSE(window_->files().mayWrite(QString::fromStdString(visit().lesson()->steps[3].scene)));
}

TEST_F(LessonTest, AnUnknownLessonIsToldInOneLine) {
  QString line;
  QObject::connect(&lessons(), &LessonView::failed, window_, [&line](const QString& told) { line = told; });
  window_->openLesson("miror");
  EXPECT_EQ(visit().lesson(), nullptr);
  EXPECT_TRUE(line.contains("miror")) << line.toStdString();
  EXPECT_TRUE(line.contains("mirror")) << line.toStdString();
  EXPECT_FALSE(line.contains('\n'));
}

TEST_F(LessonTest, BrokenLessonsAreListedAtTheEndAndTheOthersWork) {
  QTemporaryDir folder;
  const auto write = [&](const QString& name, const QByteArray& content) {
    QFile file(folder.filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content);
  };
  const auto lesson = [](const QByteArray& scenePath, const QByteArray& camera) {
    return "{\"format\":\"boxprobe-lesson\",\"version\":1,\"title\":\"T\",\"chapter\":\"C\",\"summary\":\"S\","
           "\"scene\":\"" +
           scenePath + "\",\"steps\":[{\"title\":\"A\",\"say\":\"B\",\"camera\":\"" + camera + "\"}]}";
  };
  const QByteArray room = QByteArray(BOXPROBE_DATA_DIR) + "/scenes/room.boxprobe.json";
  write("1-good.lesson.json", lesson(room, "A"));
  write("2-malformed.lesson.json", "{\"format\": \"boxprobe-lesson\",");
  write("3-no-scene.lesson.json", lesson("none.boxprobe.json", "A"));
  write("4-no-camera.lesson.json", lesson(room, "nowhere"));
  lessons().setFolder(folder.path().toStdString());
  key(Qt::Key_F1);
  QStringList errors;
  for (const QLabel* label : window_->findChildren<QLabel*>()) {
    if (label->property("lessonError").toBool() && label->isVisible()) errors << label->text();
  }
  ASSERT_EQ(errors.size(), 3);
  EXPECT_TRUE(errors[0].contains("2-malformed.lesson.json"));
  EXPECT_TRUE(errors[1].contains("3-no-scene.lesson.json"));
  EXPECT_TRUE(errors[2].contains("4-no-camera.lesson.json"));
  EXPECT_TRUE(errors[2].contains("nowhere"));
  for (const QString& line : errors) EXPECT_FALSE(line.contains('\n')) << line.toStdString();
  keepPicture("lesson_errors");
  click("lesson:good");
  ASSERT_NE(visit().lesson(), nullptr);
  EXPECT_EQ(visit().lesson()->title, "T");
}

TEST_F(LessonTest, AFolderWithoutLessonsSaysSo) {
  lessons().setFolder("/nowhere/at/all");
  key(Qt::Key_F1);
  bool told = false;
  for (const QLabel* label : window_->findChildren<QLabel*>()) {
    told = told || (label->property("lessonError").toBool() && label->text().contains("/nowhere/at/all"));
  }
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace boxprobe
