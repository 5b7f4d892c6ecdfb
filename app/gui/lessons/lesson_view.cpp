// See lesson_view.h.
#include "app/gui/lessons/lesson_view.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QTabBar>
#include <QTextEdit>
#include <algorithm>
#include <exception>
#include <utility>

#include "app/gui/lessons/lesson_list_page.h"
#include "app/gui/lessons/lesson_panel.h"
#include "app/gui/lessons/lesson_progress.h"
#include "app/gui/lessons/lesson_step_page.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/message_box.h"
#include "app/lessons/lesson_language.h"
#include "app/lessons/lesson_measure.h"
#include "filters/core/base/errors.h"
#include "filters/io/gltf/model_file.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

/// Widgets that go through text or choices with the arrow keys.
bool takesArrows(const QWidget* widget) {
  return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
         qobject_cast<const QTextEdit*>(widget) || qobject_cast<const QComboBox*>(widget) ||
         qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
         qobject_cast<const QTabBar*>(widget);
}

}  // namespace

LessonView::LessonView(Workspace& workspace, DebugView& debugView, std::string folder, QWidget* window)
    : QObject(window),
      workspace_(workspace),
      window_(window),
      folder_(std::move(folder)),
      panel_(new LessonPanel),
      stage_(workspace, debugView),
      held_(workspace.viewport()),
      published_(workspace),
      visit_(workspace, {[this](const Scene& scene) {
                           return models_.load(scene, workspace_.document().scene(), workspace_.models(), window_);
                         },
                         [this] { held_.hold(); }, [this] { stage_.enter(); },
                         [this] {
                           stage_.leave();
                           models_.forget();
                           check_.setTask({});
                           published_.show({});
                           panel_->showList();
                           panel_->list()->setLessonOpen(false);
                           showProgress();
                           updateKeys();
                           emit workspace_.lessonShown(false);
                           workspace_.requestPicture();
                         },
                         [this] { stepShown(); }}),
      check_({[this] {
                return workspace_.viewport().readyToDraw() && workspace_.renderer().error().empty() &&
                       !workspace_.renderer().workPending();
              },
              [this] { return workspace_.document().previewing(); },
              [this](const LessonMeasure& wanted) { return measure(wanted); }}) {
  connectPanel();
  connectKeys();
  observe();
}

void LessonView::observe() {
  workspace_.listenTo(this);
  connect(&workspace_, &Workspace::opening, this, [this] { visit_.drop(); });
  connect(&workspace_, &Workspace::ownSceneWanted, this, &LessonView::leave);
  workspace_.changes().add("lessons", ChangeKinds::all(), [this](const Changes&) { documentChanged(); });
  connect(&workspace_.editor(), &Editor::settled, this, &LessonView::documentChanged);
  connect(&workspace_.scheduler(), &RenderScheduler::rendered, this, &LessonView::pictureDrawn);
  connect(&workspace_.scheduler(), &RenderScheduler::workEnded, this, &LessonView::workEnded);
  connect(&workspace_.viewport(), &Viewport::cameraMoved, this, &LessonView::cameraMoved);
  connect(&workspace_.viewport(), &Viewport::becameReady, this, &LessonView::shapeChanged);
}

LessonView::~LessonView() = default;

void LessonView::setFolder(const std::string& folder) {
  folder_ = folder;
  read_ = false;
}

void LessonView::setLanguage(const std::string& language) {
  language_ = language;
  read_ = false;
}

void LessonView::connectPanel() {
  LessonStepPage* step = panel_->step();
  connect(panel_->list(), &LessonListPage::chosen, this, [this](const QString& name) {
    const bool here = visit_.lesson() && QString::fromStdString(visit_.lesson()->name) == name;
    if (!here) return open(name);
    panel_->showStep();
    updateKeys();
  });
  connect(panel_->list(), &LessonListPage::forgetRequested, this, [this] {
    const auto answer =
        askUser(panel_, tr("Forget progress"), tr("Mark all lessons as not started? This cannot be undone."),
                QMessageBox::Yes | QMessageBox::Cancel, QMessageBox::Cancel);
    if (answer != QMessageBox::Yes) return;
    forgetLessons();
    showProgress();
  });
  connect(panel_->list(), &LessonListPage::leaveRequested, this, &LessonView::leave);
  connect(step, &LessonStepPage::leaveRequested, this, &LessonView::leave);
  connect(step, &LessonStepPage::listRequested, this, &LessonView::showList);
  connect(step, &LessonStepPage::backRequested, this, &LessonView::back);
  connect(step, &LessonStepPage::nextRequested, this, &LessonView::next);
  connect(step, &LessonStepPage::answered, this, &LessonView::answered);
  connect(step, &LessonStepPage::solutionRequested, this, [this] {
    if (visit_.lesson() && visit_.shownStep().task) visit_.apply("Show the answer", visit_.shownStep().task->solution);
  });
  connect(step, &LessonStepPage::lessonSceneRequested, this, [this] {
    visit_.showLessonScene();
    updateTry();
  });
  connect(step, &LessonStepPage::tryRequested, this, [this] {
    visit_.showTry();
    updateTry();
  });
  connect(step, &LessonStepPage::startOverRequested, this, [this] {
    visit_.startOver();
    updateTry();
  });
  connect(&check_, &LessonCheck::measured, this, &LessonView::measured);
  connect(&check_, &LessonCheck::waiting, step, &LessonStepPage::showWaiting);
  connect(&check_, &LessonCheck::failed, step, &LessonStepPage::showFailure);
}

void LessonView::connectKeys() {
  const auto add = [this](int key, void (LessonView::*turn)()) {
    auto* shortcut = new QShortcut(QKeySequence(key), window_);
    shortcut->setEnabled(false);
    connect(shortcut, &QShortcut::activated, this, turn);
    keys_.push_back(shortcut);
  };
  for (const int key : {Qt::Key_Right, Qt::Key_PageDown}) add(key, &LessonView::next);
  for (const int key : {Qt::Key_Left, Qt::Key_PageUp}) add(key, &LessonView::back);
  connect(qApp, &QApplication::focusChanged, this, &LessonView::updateKeys);
}

void LessonView::updateKeys() {
  const bool turns = lessonOpen() && panel_->stepShown() && !takesArrows(QApplication::focusWidget());
  for (QShortcut* key : keys_) key->setEnabled(turns);
}

template <typename Work>
void LessonView::guarded(const Work& work) {
  try {
    work();
  } catch (const LoadCancelled&) {
    held_.release();
    emit message(tr("Loading cancelled; the scene is unchanged."));
  } catch (const std::exception& error) {
    held_.release();
    emit failed(QString::fromStdString(messageOf(error)));
  }
}

void LessonView::readLessons() {
  try {
    list_ = loadLessons(folder_, lessonLanguage(language_, folder_));
  } catch (const std::exception& error) {
    list_ = {};
    list_.errors.push_back(messageOf(error));
  }
  read_ = true;
  panel_->list()->show(list_);
}

void LessonView::leave() {
  workspace_.prepareForAnother();
  visit_.leave();
}

void LessonView::showList() {
  if (!read_ || !lessonOpen()) readLessons();  // a lesson's author wants to see what was just written
  panel_->showList();
  panel_->list()->setLessonOpen(lessonOpen());
  showProgress();
  updateKeys();
  emit shown();
  panel_->list()->bringForward(lastLesson());
}

void LessonView::open(const QString& name, std::optional<std::size_t> step) {
  if (!read_) readLessons();
  workspace_.prepareForAnother();
  guarded([&] {
    const std::string id = name.toStdString();
    const Lesson& lesson = findLesson(list_, id);
    const LessonProgress progress = lessonProgress(QString::fromStdString(lesson.name));
    const std::size_t leftOff =
        progress.done || progress.furthest < 0 ? 0 : static_cast<std::size_t>(progress.furthest);
    const std::size_t there = lesson.name == id ? leftOff : formerStep(lesson, id).value_or(0);
    visit_.open(lesson, std::min(step.value_or(there), lesson.steps.size() - 1));
    emit shown();
  });
}

void LessonView::stepShown() {
  const Lesson& lesson = *visit_.lesson();
  const std::size_t index = visit_.step();
  stage_.setUp(visit_.shownStep(), lessonCamera(lesson, index, visit_.stepScene()));

  const QString name = QString::fromStdString(lesson.name);
  LessonProgress progress = lessonProgress(name);
  progress.furthest = std::max(progress.furthest, static_cast<int>(index));
  keepLessonProgress(name, progress);
  keepLastLesson(name);
  keepSolved({});
  panel_->step()->show(lesson, index,
                       {progress.solved.contains(solvedQuestion(index)), progress.solved.contains(solvedTask(index))});
  panel_->showStep();
  check_.setTask(visit_.shownStep().task);
  published_.show(visit_.shownStep().published);
  updateTry();
  // Hidden buttons hand the focus on to whatever comes next, which looks chosen.
  if (panel_->isAncestorOf(QApplication::focusWidget())) workspace_.viewport().setFocus();
  updateKeys();
  emit workspace_.lessonShown(true);
  workspace_.requestPicture();
}

void LessonView::keepSolved(const QString& what) {
  const Lesson& lesson = *visit_.lesson();
  const QString name = QString::fromStdString(lesson.name);
  LessonProgress progress = lessonProgress(name);
  if (!what.isEmpty()) progress.solved.insert(what);
  bool all = progress.furthest + 1 >= static_cast<int>(lesson.steps.size());
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    all = all && (!lesson.steps[i].question || progress.solved.contains(solvedQuestion(i))) &&
          (!lesson.steps[i].task || progress.solved.contains(solvedTask(i)));
  }
  progress.done = progress.done || all;
  keepLessonProgress(name, progress);
}

void LessonView::answered(bool right) {
  if (right && visit_.lesson()) keepSolved(solvedQuestion(visit_.step()));
}

void LessonView::measured() {
  if (!visit_.lesson() || !check_.result()) return;
  panel_->step()->showResult(*check_.result());
  if (check_.result()->done) keepSolved(solvedTask(visit_.step()));
}

void LessonView::next() {
  if (!visit_.lesson()) return;
  workspace_.prepareForAnother();
  if (visit_.step() + 1 == visit_.lesson()->steps.size()) return finish();
  guarded([this] { visit_.goTo(visit_.step() + 1); });
}

void LessonView::back() {
  workspace_.prepareForAnother();
  if (visit_.lesson() && visit_.step() > 0) guarded([this] { visit_.goTo(visit_.step() - 1); });
}

void LessonView::finish() {
  const std::string name = visit_.lesson()->name;
  const LessonProgress progress = lessonProgress(QString::fromStdString(name));
  showList();
  const auto here = std::find_if(list_.lessons.begin(), list_.lessons.end(),
                                 [&](const Lesson& lesson) { return lesson.name == name; });
  const bool another = here != list_.lessons.end() && here + 1 != list_.lessons.end();
  if (progress.done && another) panel_->list()->bringForward(QString::fromStdString((here + 1)->name));
  emit message(progress.done ? tr("This lesson is done") : tr("This lesson still has a question or a task"));
}

void LessonView::showProgress() {
  panel_->list()->showProgress(list_, lastLesson());
}

void LessonView::updateTry() {
  if (visit_.lesson()) panel_->step()->showTry(visit_.showsLesson(), visit_.hasTry());
}

void LessonView::documentChanged() {
  if (!visit_.lesson()) return;
  if (!workspace_.document().previewing()) updateTry();
  check_.invalidate();
  published_.invalidate();
  stage_.invalidate();
}

void LessonView::pictureDrawn() {
  if (held_.held() && !workspace_.renderer().workPending()) held_.release();
  if (visit_.lesson() && stage_.pictureDrawn()) workspace_.requestPicture();
}

void LessonView::workEnded() {
  held_.release();
  check_.invalidate();
  published_.invalidate();
  stage_.invalidate();
}

void LessonView::shapeChanged() {
  if (!visit_.lesson()) return;
  stage_.shapeChanged();
  stage_.invalidate();
  published_.invalidate();
  check_.invalidate();  // it may have waited for the first picture
}

void LessonView::cameraMoved() {
  published_.invalidate();
  stage_.invalidate();
}

std::optional<double> LessonView::measure(const LessonMeasure& wanted) {
  workspace_.viewport().window3d()->MakeCurrent();
  const Scene& scene = workspace_.document().scene();
  const ShownScene shown{workspace_.renderer(), scene, workspace_.models(),
                         lessonCamera(*visit_.lesson(), visit_.step(), visit_.stepScene())};
  const auto value = measureShown(shown, wanted);
  workspace_.requestPicture();
  return value;
}

}  // namespace boxprobe
