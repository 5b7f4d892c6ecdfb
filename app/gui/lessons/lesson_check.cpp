// See lesson_check.h.
#include "app/gui/lessons/lesson_check.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "app/lessons/lesson_measure.h"
#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

/// A few times a second is as fast as a number can be read.
constexpr int kApartMilliseconds = 250;
/// A measurement that costs more would stop a drag; others take a fifth of its time at most.
constexpr qint64 kMostInDragMilliseconds = 150;
constexpr qint64 kTimesApart = 4;

}  // namespace

LessonCheck::LessonCheck(Hooks hooks, QObject* parent) : QObject(parent), hooks_(std::move(hooks)) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &LessonCheck::measure);
  sinceMeasure_.start();
}

void LessonCheck::setTask(std::optional<LessonTask> task) {
  task_ = std::move(task);
  result_.reset();
  lastCost_ = kMostInDragMilliseconds + 1;  // unknown: not in a drag
  timer_.stop();
  invalidate();
}

void LessonCheck::invalidate() {
  stale_ = true;
  if (!task_ || timer_.isActive()) return;
  const bool counts = hooks_.dragging() && lastCost_ <= kMostInDragMilliseconds;
  const qint64 apart = std::max<qint64>(kApartMilliseconds, counts ? kTimesApart * lastCost_ : 0);
  timer_.start(static_cast<int>(std::max<qint64>(apart - sinceMeasure_.elapsed(), 0)));
}

void LessonCheck::measure() {
  // What ends the drag or the captures invalidates again.
  if (!task_ || !hooks_.ready()) return;
  if (hooks_.dragging() && lastCost_ > kMostInDragMilliseconds) return emit waiting();
  QElapsedTimer clock;
  clock.start();
  try {
    const LessonCondition& condition = task_->done;
    Result result;
    result.value = hooks_.measure(condition.measure);
    const auto times = condition.times ? hooks_.measure(*condition.times) : std::optional<double>(1.0);
    if (times) result.limit = conditionLimit(condition, *times);
    result.done = result.value && times && conditionHolds(condition, *result.value, *times);
    result_ = result;
    stale_ = false;
  } catch (const std::exception& error) {
    task_.reset();  // it would fail again at every change
    emit failed(QString::fromStdString(messageOf(error)));
    return;
  }
  lastCost_ = clock.elapsed();
  sinceMeasure_.restart();
  emit measured();
}

}  // namespace boxprobe
