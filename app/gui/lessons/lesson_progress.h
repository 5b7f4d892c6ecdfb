// How far the learner has come in each lesson, kept between sessions beside the preferences. Called by the lesson
// views; knows no lesson file.
#pragma once

#include <QSet>
#include <QString>

namespace boxprobe {

struct LessonProgress {
  int furthest = -1;     ///< the last step seen, from 0; -1: never opened
  bool done = false;     ///< seen to the end, with everything that is asked answered and done
  QSet<QString> solved;  ///< "question 2", "task 3": of which steps, counted from 1
};

QString solvedQuestion(std::size_t step);
QString solvedTask(std::size_t step);

LessonProgress lessonProgress(const QString& lesson);
void keepLessonProgress(const QString& lesson, const LessonProgress& progress);
/// The lesson that was open last; empty: none yet.
QString lastLesson();
void keepLastLesson(const QString& lesson);
void forgetLessons();

}  // namespace boxprobe
