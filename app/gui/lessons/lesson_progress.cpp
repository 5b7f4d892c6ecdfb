// See lesson_progress.h.
#include "app/gui/lessons/lesson_progress.h"

#include <QStringList>

#include "app/gui/widgets/preferences.h"

namespace boxprobe {

namespace {

constexpr const char* kGroup = "lessons";
constexpr const char* kLast = "lessons/last";

QString key(const QString& lesson, const char* what) {
  return QString("%1/progress/%2/%3").arg(kGroup, lesson, what);
}

}  // namespace

QString solvedQuestion(std::size_t step) {
  return QString("question %1").arg(step + 1);
}

QString solvedTask(std::size_t step) {
  return QString("task %1").arg(step + 1);
}

LessonProgress lessonProgress(const QString& lesson) {
  const auto settings = preferences();
  LessonProgress progress;
  progress.furthest = settings->value(key(lesson, "furthest"), -1).toInt();
  progress.done = settings->value(key(lesson, "done"), false).toBool();
  for (const QString& solved : settings->value(key(lesson, "solved")).toStringList()) progress.solved.insert(solved);
  return progress;
}

void keepLessonProgress(const QString& lesson, const LessonProgress& progress) {
  const auto settings = preferences();
  settings->setValue(key(lesson, "furthest"), progress.furthest);
  settings->setValue(key(lesson, "done"), progress.done);
  QStringList solved = progress.solved.values();
  solved.sort();
  settings->setValue(key(lesson, "solved"), solved);
}

QString lastLesson() {
  return preferences()->value(kLast).toString();
}

void keepLastLesson(const QString& lesson) {
  preferences()->setValue(kLast, lesson);
}

void forgetLessons() {
  preferences()->remove(kGroup);
}

}  // namespace boxprobe
