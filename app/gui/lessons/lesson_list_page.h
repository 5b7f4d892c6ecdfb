// All lessons by chapter, each with how far the learner has come; at the end what cannot be read, one line each. Called
// by the lesson panel.
#pragma once

#include <QWidget>
#include <map>
#include <string>
#include <vector>

#include "filters/io/scene/lesson_file.h"

class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace boxprobe {

class TextButton;

class LessonListPage : public QWidget {
  Q_OBJECT

 public:
  explicit LessonListPage(QWidget* parent = nullptr);

  void show(const LessonList& list);
  /// From what is kept; `last` is the lesson to go on with, empty: none.
  void showProgress(const LessonList& list, const QString& last);
  /// The button gets the focus and is scrolled to.
  void bringForward(const QString& lesson);

 signals:
  void chosen(const QString& lesson);
  void forgetRequested();
  void leaveRequested();

 public:
  void setLessonOpen(bool open);

 private:
  void addHeading(const QString& text);
  void addErrors(const QString& heading, const std::vector<std::string>& errors);

  QLabel* intro_;
  QPushButton* leave_;
  QPushButton* forget_;
  QScrollArea* scroll_;
  QVBoxLayout* rows_ = nullptr;
  std::map<QString, TextButton*> buttons_;
};

}  // namespace boxprobe
