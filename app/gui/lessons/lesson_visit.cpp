// See lesson_visit.h.
#include "app/gui/lessons/lesson_visit.h"

#include "app/session/opened_glb.h"
#include "filters/io/scene/lesson_file.h"
#include "filters/io/scene/scene_file.h"

namespace boxprobe {

LessonVisit::LessonVisit(Workspace& workspace, Hooks hooks)
    : workspace_(workspace), document_(workspace.document()), editor_(workspace.editor()), hooks_(std::move(hooks)) {}

void LessonVisit::setLesson(const std::optional<Lesson>& lesson) {
  lesson_ = lesson;
  workspace_.setLesson(this->lesson());
}

void LessonVisit::open(const Lesson& lesson, std::size_t step) {
  const Lesson copy = lesson;  // it may be the one that is open
  show(copy, step);
}

void LessonVisit::goTo(std::size_t step) {
  if (lesson_ && step < lesson_->steps.size() && step != step_) open(*lesson_, step);
}

void LessonVisit::show(const Lesson& lesson, std::size_t step) {
  editor_.finish();
  // Whatever can fail comes first.
  auto scene = std::make_shared<const Scene>(lessonScene(lesson, step));
  std::optional<std::string> selected;
  if (const auto index = document_.selectedProbe(); index && lesson_) selected = document_.scene().probes[*index].name;
  if (selected && !findProbe(*scene, *selected)) selected.reset();
  if (!selected && !scene->probes.empty()) selected = scene->probes.front().name;
  Document::State state = Document::State::opened(*scene, "", selected);
  const Models models = hooks_.loadModels(*scene);

  hooks_.beforeStep();
  keepTry();
  const bool entering = !own_;
  if (entering) {
    own_ = Own{document_.state(), workspace_.models()};
    hooks_.entered();
  }
  setLesson(lesson);
  step_ = step;
  stepScene_ = std::move(scene);
  // On entering, too, where the learner's own scene has the same models: its baked files are not the lesson's.
  const bool others = entering || models != workspace_.models();
  if (others) workspace_.showModels(models, "");
  document_.restore(std::move(state), others ? Changes::all() : Changes());
  hooks_.stepShown();
}

void LessonVisit::leave() {
  if (!own_) return;
  editor_.finish();
  keepTry();
  setLesson({});
  stepScene_.reset();
  const Own own = std::move(*own_);
  own_.reset();
  workspace_.showModels(own.models, ownPathOf(own.state.path(), own.state.scene()));
  document_.restore(own.state, Changes::all());
  hooks_.left();
}

void LessonVisit::drop() {
  if (!own_) return;
  editor_.cancel();
  keepTry();
  setLesson({});
  stepScene_.reset();
  own_.reset();
  hooks_.left();
}

bool LessonVisit::showsLesson() const {
  return lesson_ && document_.state().scene() == *stepScene_;
}

bool LessonVisit::hasTry() const {
  return lesson_ && (!showsLesson() || tries_.count(key()) > 0);
}

void LessonVisit::keepTry() {
  if (lesson_ && !showsLesson()) tries_.insert_or_assign(key(), document_.state());
}

void LessonVisit::commitLessonScene(const QString& label) {
  editor_.commit(label, [scene = stepScene_](Scene& shown) { shown = *scene; });
}

void LessonVisit::showLessonScene() {
  if (!lesson_) return;
  editor_.finish();
  keepTry();
  commitLessonScene(tr("Show the lesson's scene"));
}

void LessonVisit::showTry() {
  if (!lesson_ || !showsLesson()) return;
  editor_.finish();
  const auto kept = tries_.find(key());
  if (kept == tries_.end()) return;
  document_.restore(kept->second);
}

void LessonVisit::startOver() {
  if (!lesson_) return;
  showTry();  // its history goes on, so that undo can bring it back
  editor_.finish();
  tries_.erase(key());
  commitLessonScene(tr("Start over"));
}

void LessonVisit::apply(const std::string& label, const std::vector<std::string>& assignments) {
  if (!lesson_) return;
  editor_.commit(QString::fromStdString(label), [scene = stepScene_, assignments](Scene& shown) {
    Scene changed = *scene;
    setSceneFields(changed, assignments);
    shown = changed;
  });
}

}  // namespace boxprobe
