// What the lesson dock holds: the list, or the step that is open, in letters that can be made large. Called by the
// lesson view.
#pragma once

#include <QStackedWidget>

namespace boxprobe {

class LessonListPage;
class LessonStepPage;

class LessonPanel : public QStackedWidget {
  Q_OBJECT

 public:
  static constexpr double kUsualType = 12.5;  ///< points

  explicit LessonPanel(QWidget* parent = nullptr);

  LessonListPage* list() const { return list_; }
  LessonStepPage* step() const { return step_; }
  void showList();
  void showStep();
  bool stepShown() const;
  void setTypeSize(double points);

 private:
  LessonListPage* list_;
  LessonStepPage* step_;
};

}  // namespace boxprobe
