// The window used for long: each round opens a scene from its file, with a live link that follows it, drags faces and
// the origin, orbits, changes the technique, undoes, rests until the picture is refined, bakes and saves what was
// baked, and walks through a lesson. What the process holds is written down after each round. A few rounds by
// themselves ask that no descriptor and no widget is left behind; for longer:
//   BOXPROBE_SOAK_MINUTES=60 BOXPROBE_TEST_OUTPUT=out/soak build/release/tests/gui/window_soak
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QMessageBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <cstdio>
#include <filesystem>
#include <random>

#include "app/gui/panels/technique_chooser.h"
#include "app/gui/view/rest_refinement.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/file_commands.h"
#include "app/gui/window/live_link.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/lesson_steps.h"
#include "tests/gui/soak_record.h"

namespace boxprobe {
namespace {

constexpr const char* kScenes[] = {"building", "room", "furnished", "glass", "windows", "gallery"};
// By themselves, the first scene alone, so that every round can leave what the one before it left.
constexpr int kShortRounds = 4;

class WindowSoak : public LessonWindowTest {
 protected:
  void SetUp() override {
    LessonWindowTest::SetUp();
    // Changes are left behind, baked files saved beside the scene.
    QObject::connect(&answer_, &QTimer::timeout, [] {
      if (auto* unasked = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
        ADD_FAILURE() << "nobody asked for " << unasked->windowTitle().toStdString();
        return unasked->reject();
      }
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      QAbstractButton* discard = box->button(QMessageBox::Discard);
      QAbstractButton* answer = discard != nullptr ? discard : box->button(QMessageBox::Save);
      if (answer != nullptr) return QTest::mouseClick(answer, Qt::LeftButton);
      ADD_FAILURE() << "nobody asked for " << box->text().toStdString();
      box->reject();
    });
    answer_.start(50);
  }

  int number(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
  /// Over the picture: beside it are buttons that lead elsewhere.
  void dragOverPicture(const QPointF& from) {
    const QRectF picture(window_->viewport().rect().adjusted(8, 8, -8, -8));
    const QPointF to = from + QPointF(number(160) - 80, number(120) - 60);
    if (picture.contains(from) && picture.contains(to)) drag(from, to);
  }

  void dragHandle(const glm::dvec3& world) {
    if (const auto at = window_->viewport().view().pixel(world)) dragOverPicture({at->x, at->y});
  }

  /// A copy in a folder of its own: what is baked is saved beside it.
  void openScene(const std::string& name) {
    LoadedScene loaded = loadScene(std::string(BOXPROBE_DATA_DIR) + "/scenes/" + name + ".boxprobe.json");
    for (Probe& probe : loaded.scene.probes) {
      probe.faceSize = 64;
      probe.samplesPerPixel = 1;
      probe.bounces = 1;
    }
    const QString path = folder_.filePath(QString::fromStdString(name) + ".boxprobe.json");
    saveSceneFile(loaded.scene, path.toStdString());
    ASSERT_TRUE(window_->files().openPath(path));
    waitUntilIdle();
  }

  void editByHand() {
    for (int i = 0; i < 3; ++i) {
      dragHandle(faceCenterWorld(probe(), kBoxFaces[static_cast<std::size_t>(number(6))]));
    }
    dragHandle(probe().origin);
    dragOverPicture({120.0, 120.0});  // orbits
    waitUntilIdle();
    auto* chooser = window_->findChild<TechniqueChooser*>("technique");
    for (QComboBox* combo : {chooser->projection(), chooser->evaluation()}) {
      combo->setCurrentIndex(number(combo->count()));
      emit combo->activated(combo->currentIndex());
      waitUntilIdle();
    }
    for (int i = 0; i < 4; ++i) key(Qt::Key_Z, Qt::ControlModifier);
    key(Qt::Key_Y, Qt::ControlModifier);
    waitUntilIdle();
  }

  /// Until the picture at rest has become better than the technique's own, and the file of the live link stands.
  void rest(int revision) {
    RestRefinement& refinement = window_->refinement();
    const bool enabled = refinement.enabled();
    refinement.setEnabled(true);
    refinement.setRest(40);
    EXPECT_TRUE(waitFor([&] {
      const FrameCount frames = window_->renderer().frameCount();
      return frames.refined && frames.averaged > 2;
    }));
    EXPECT_TRUE(waitFor([&] { return window_->liveLink().revision() > revision; }));
    refinement.setRest(kNeverMilliseconds);
    refinement.setEnabled(false);  // to its end it takes minutes
    refinement.setEnabled(enabled);
    waitUntilIdle();
  }

  void bakeAndSave() {
    window_->findChild<QToolButton*>("bake")->click();
    waitUntilIdle();
    ASSERT_FALSE(document().path().empty());
    window_->findChild<QToolButton*>("saveBaked")->click();
    EXPECT_TRUE(waitFor([this] { return window_->statusBar()->currentMessage().startsWith("Wrote"); }));
    waitUntilIdle();
  }

  void walkLesson(const Lesson& lesson) {
    openFromList(lesson.name);
    while (shown("lessonNext")) {  // from where it was left off: a lesson done before may show its end
      waitUntilIdle();
      click("lessonNext");
    }
    click("leaveLessonsFromList");
    waitUntilIdle();
  }

  std::mt19937 random_{1};
  QTemporaryDir folder_;
  QTimer answer_;
};

TEST_F(WindowSoak, NothingIsLeftBehind) {
  const double minutes = qEnvironmentVariable("BOXPROBE_SOAK_MINUTES", "0").toDouble();
  const bool brief = minutes <= 0.0;
  const LessonList lessons = loadLessons(lessonFolder());
  std::vector<SoakRow> rows;
  QElapsedTimer clock;
  clock.start();
  const auto more = [&] {
    return brief ? rows.size() < kShortRounds : static_cast<double>(clock.elapsed()) < 60000.0 * minutes;
  };
  while (more()) {
    const std::size_t round =
        rows.size() + static_cast<std::size_t>(qEnvironmentVariableIntValue("BOXPROBE_SOAK_FROM"));
    const std::string scene = brief ? kScenes[0] : kScenes[round % std::size(kScenes)];
    openScene(scene);
    const int revision = window_->liveLink().revision();
    window_->liveLink().start(folder_.filePath("live.glb"));
    editByHand();
    rest(revision);
    bakeAndSave();
    window_->liveLink().stop();
    walkLesson(lessons.lessons[brief ? 0 : round % lessons.lessons.size()]);
    ASSERT_FALSE(HasFailure()) << "round " << round + 1 << ", " << scene;
    SoakRow row = lookAtProcess();
    row.minutes = static_cast<double>(clock.elapsed()) / 60000.0;
    row.scene = scene;
    row.mapMegabytes = static_cast<double>(window_->renderer().probeMemoryBytes()) / 1048576.0;
    row.programs = static_cast<int>(counters().programsCompiled);
    rows.push_back(row);
    std::printf(
        "round %zu, %s: %.1f minutes, %.0f MB resident, %.0f heap, %.0f maps, %d descriptors, %d threads, %d "
        "widgets, %d programs\n",
        round + 1, scene.c_str(), row.minutes, row.residentMegabytes, row.heapMegabytes, row.mapMegabytes,
        row.descriptors, row.threads, row.widgets, row.programs);
    std::fflush(stdout);
    const QString output = qEnvironmentVariable("BOXPROBE_TEST_OUTPUT");
    if (!output.isEmpty()) {
      std::filesystem::create_directories(output.toStdString());
      writeSoakTable(output.toStdString() + "/window_soak.csv", rows);
    }
  }
  const QString output = qEnvironmentVariable("BOXPROBE_TEST_OUTPUT");
  if (!output.isEmpty()) drawSoak(output.toStdString() + "/window_soak.png", rows);
  // The first round of each scene makes what all share.
  const std::size_t settled = brief ? 1 : std::size(kScenes);
  ASSERT_GT(rows.size(), settled + 1) << "too short to tell";
  EXPECT_LE(rows.back().descriptors, rows[settled].descriptors);
  // Threads come when a pool is first asked for more; memory with every program of a technique not chosen before.
  if (brief) {
    EXPECT_EQ(rows.back().widgets, rows[settled].widgets);
  }
}

}  // namespace
}  // namespace boxprobe
