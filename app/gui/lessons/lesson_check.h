// Whether a lesson's task is done: measures when the scene has come to rest and its captures are there, a few times a
// second at most, and while something is dragged only if that costs next to nothing. Called by the lesson view; knows
// the renderer only as functions.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>

#include "filters/core/scene/lesson.h"

namespace boxprobe {

class LessonCheck : public QObject {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<bool()> ready;     ///< what is on show is complete: nothing left to capture
    std::function<bool()> dragging;  ///< a preview is under way
    /// Nothing where it is not defined.
    std::function<std::optional<double>(const LessonMeasure&)> measure;
  };
  struct Result {
    std::optional<double> value;  ///< nothing: not defined for what is on show
    std::optional<double> limit;  ///< what it is compared with; nothing: likewise
    bool done = false;
  };

  explicit LessonCheck(Hooks hooks, QObject* parent = nullptr);

  /// The task of the step on show; nothing: none.
  void setTask(std::optional<LessonTask> task);
  /// The scene changed, or what it is drawn with is now there.
  void invalidate();
  /// What is on show has not been measured yet.
  bool pending() const { return task_ && stale_; }
  const std::optional<Result>& result() const { return result_; }  ///< of the task, once measured

 signals:
  void measured();
  /// Measuring would stop the drag: it is measured when that ends.
  void waiting();
  /// It cannot be measured here: one line.
  void failed(const QString& line);

 private:
  void measure();

  Hooks hooks_;
  QTimer timer_;
  QElapsedTimer sinceMeasure_;
  qint64 lastCost_ = 0;  ///< milliseconds
  std::optional<LessonTask> task_;
  std::optional<Result> result_;
  bool stale_ = false;
};

}  // namespace boxprobe
