// The lessons' parts put together: the panel, the visit to the lesson that is open, the stage that is set for its
// steps, the check of its tasks.
#pragma once

#include <QObject>
#include <QShortcut>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/lessons/lesson_check.h"
#include "app/gui/lessons/lesson_models.h"
#include "app/gui/lessons/lesson_stage.h"
#include "app/gui/lessons/lesson_visit.h"
#include "app/gui/lessons/published_overlay.h"
#include "app/gui/view/held_picture.h"
#include "filters/io/scene/lesson_file.h"

class QWidget;

namespace boxprobe {

class LessonPanel;

class LessonView : public QObject {
  Q_OBJECT

 public:
  /// `folder`: where the lessons are.
  LessonView(Workspace& workspace, DebugView& debugView, std::string folder, QWidget* window);
  ~LessonView() override;

  LessonPanel* panel() const { return panel_; }
  /// Another folder of lessons, read when the list is shown next.
  void setFolder(const std::string& folder);
  /// Another language of the lessons' texts, from then on; empty: the locale's.
  void setLanguage(const std::string& language);

  void showList();
  /// At the step, or where the learner left off. An unknown name is told by `failed`.
  void open(const QString& name, std::optional<std::size_t> step = {});
  bool lessonOpen() const { return visit_.lesson() != nullptr; }
  void leave();
  void next();
  void back();

  const LessonVisit& visit() const { return visit_; }
  const LessonCheck& check() const { return check_; }
  const PublishedOverlay& published() const { return published_; }

 signals:
  void shown();  ///< the panel has something to look at
  void message(const QString& line);
  void failed(const QString& line);

 private:
  void observe();
  /// The scene changed, or an edit came to rest.
  void documentChanged();
  void pictureDrawn();
  void workEnded();
  void shapeChanged();
  void cameraMoved();
  void connectPanel();
  void connectKeys();
  void readLessons();
  template <typename Work>
  void guarded(const Work& work);
  void stepShown();
  void answered(bool right);
  void measured();
  void keepSolved(const QString& what);
  void finish();
  void showProgress();
  void updateTry();
  void updateKeys();
  std::optional<double> measure(const LessonMeasure& measure);

  Workspace& workspace_;
  QWidget* window_;
  std::string folder_, language_;
  LessonList list_;
  bool read_ = false;
  LessonPanel* panel_;
  LessonModels models_;
  LessonStage stage_;
  HeldPicture held_;
  PublishedOverlay published_;
  LessonVisit visit_;
  LessonCheck check_;
  std::vector<QShortcut*> keys_;
};

}  // namespace boxprobe
