// A lesson's steps as pictures, with rays and boxes where a step has them, and its claims as measured. Called by the
// sheet and the page; shows no window.
#pragma once

#include <vtkSmartPointer.h>

#include <QImage>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/lessons/lesson_player.h"
#include "filters/explain/explanation.h"

class vtkReflectionProbeRepresentation;

namespace boxprobe {

struct LessonPictures {
  std::vector<QImage> steps;
  std::vector<std::optional<CurvePoints>> curves;  ///< of each step: what its curve was drawn from
  /// Of each step: is its picture taken from where the one before was? Two such pictures lie over each other.
  std::vector<bool> sameView;
  std::optional<Explanation> plan;  ///< of the pixel that was asked for, in the first step where a box is hit there
  std::string view;       ///< of the first step, or of that with the task, for a room to walk in (app/web/web_view.h)
  std::string firstView;  ///< of the first step
  std::size_t taskStep = 0;  ///< of `task`
  std::string task;  ///< of the first task that a browser can measure (app/lessons/room_task.h); empty: there is none
  struct Claim {
    std::string say;
    std::string measured;  ///< "0.21, which is 9.8 times 0.0215"
    bool holds = false;
  };
  std::vector<Claim> claims;
  /// Of each exercise, what was measured of its solution; nothing where nothing can be.
  std::vector<std::optional<Claim>> exercises;
};

/// One for many lessons: its window and programs are used again. `quiet`: without VTK's warnings.
class LessonPhotographer {
 public:
  LessonPhotographer(int width, int height, std::function<bool()> goOn = {}, bool quiet = false);
  ~LessonPhotographer();
  /// Throws InputError for a scene that cannot be read, WorkError if stopped.
  /// `plan`: the place in the pictures whose ray is explained.
  LessonPictures take(const Lesson& lesson, const std::optional<PicturePoint>& plan = {});
  /// For pictures of its steps one by one; the lesson must outlive them.
  void open(const Lesson& lesson);
  /// Of what the player shows now, with the boxes and the inset that the step wants. Throws WorkError where there is
  /// nothing to draw in the inset.
  QImage picture(const LessonStep& step);
  LessonPlayer& player() { return player_; }

 private:
  QImage pictureOf(const Lesson& lesson, std::size_t index);
  /// `lettered`: the picture has a P.
  void drawInset(QImage& picture, const LessonInset& inset, bool lettered);

  int width_, height_;
  LessonPlayer player_;
  vtkSmartPointer<vtkReflectionProbeRepresentation> boxes_;
};

/// "0.21, and 5 times 0.0215 is 0.107": what was found beside what it is held against.
std::string claimText(const LessonCondition& condition, const std::string& unit, const ClaimResult& result);

}  // namespace boxprobe
