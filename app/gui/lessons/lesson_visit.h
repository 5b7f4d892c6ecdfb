// A visit to a lesson in the window's one document: the learner's own scene is taken out whole and put back at the end,
// and what the learner does to a step's scene is a try of its own, kept beside the lesson's.
#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/gui/view/workspace.h"
#include "filters/core/scene/lesson.h"

namespace boxprobe {

class LessonVisit : public QObject {
  Q_OBJECT

 public:
  using Models = Workspace::Models;
  struct Hooks {
    /// The models of a scene, read where they are not at hand. Throws InputError, LoadCancelled.
    std::function<Models(const Scene&)> loadModels;
    std::function<void()> beforeStep;  ///< while what was shown before still is
    std::function<void()> entered;     ///< the learner's own scene has gone; the first step's is not there yet
    std::function<void()> left;        ///< the learner's own scene is back
    std::function<void()> stepShown;   ///< lesson(), step() and the document are those of the step
  };

  LessonVisit(Workspace& workspace, Hooks hooks);

  /// Throws InputError, and leaves everything as it was, if the step's scene cannot be shown.
  void open(const Lesson& lesson, std::size_t step);
  void goTo(std::size_t step);
  /// Back to the learner's own scene. Does nothing while no lesson is open.
  void leave();
  /// Another scene takes the document over: the learner's own is not put back.
  void drop();

  const Lesson* lesson() const { return lesson_ ? &*lesson_ : nullptr; }
  std::size_t step() const { return step_; }
  const LessonStep& shownStep() const { return lesson_->steps[step_]; }
  /// As the lesson has it, without what the learner did.
  const Scene& stepScene() const { return *stepScene_; }

  /// What is on show is the lesson's own scene.
  bool showsLesson() const;
  bool hasTry() const;
  /// The lesson's scene as an undo step; the try is kept.
  void showLessonScene();
  void showTry();
  /// The lesson's scene; the try is forgotten, but undo brings it back.
  void startOver();
  /// Assignments as of --set on the lesson's scene, as an edit of the learner's.
  void apply(const std::string& label, const std::vector<std::string>& assignments);

 private:
  void setLesson(const std::optional<Lesson>& lesson);
  void keepTry();
  void commitLessonScene(const QString& label);
  void show(const Lesson& lesson, std::size_t step);
  using TryKey = std::pair<std::string, std::size_t>;
  TryKey key() const { return {lesson_->path, step_}; }

  struct Own {
    Document::State state;
    Models models;
  };

  Workspace& workspace_;
  Document& document_;
  Editor& editor_;
  Hooks hooks_;
  std::optional<Own> own_;  ///< while a lesson is open
  std::optional<Lesson> lesson_;
  std::size_t step_ = 0;
  std::shared_ptr<const Scene> stepScene_;
  std::map<TryKey, Document::State> tries_;  ///< until the program ends
};

}  // namespace boxprobe
