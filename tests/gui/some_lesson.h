// A lesson with every kind of step, for what is shown of lessons without their scenes.
#pragma once

#include "filters/core/scene/lesson.h"

namespace boxprobe {

inline Lesson someLesson() {
  Lesson lesson;
  lesson.name = "some";
  lesson.title = "Three distances";
  lesson.chapter = "Projection";
  lesson.summary = "A ray leaves a box at the nearest of three planes.";
  const auto add = [&lesson](const char* title, const char* say) -> LessonStep& {
    lesson.steps.emplace_back();
    lesson.steps.back().title = title;
    lesson.steps.back().say = say;
    return lesson.steps.back();
  };
  LessonStep& first = add("Where it starts", "Each plane is one division.");
  first.formula = "t_x = \\frac{b_x - p_x}{r_x}";
  LessonStep& asks = add("Which of them", "The smallest distance is the way out of the box.");
  asks.question = LessonQuestion{"Which plane is it?",
                                 {{"The nearest", true, "Yes, it is met first."},
                                  {"The farthest", false, "The ray has left by then."},
                                  {"None", true, "That counts, too."}}};
  LessonStep& task = add("Your turn", "The box is too large.");
  task.mayMove = "Drag a face.";
  task.question = LessonQuestion{"Is it?", {{"No", false, "Look again."}, {"Yes", true, "It is."}}};
  task.task.emplace();
  task.task->ask = "Make the box fit.";
  task.task->unit = "m";
  task.task->praise = "It fits.";
  task.task->solution = {"probes.room.bevel=0"};
  task.task->done.measure.kind = MeasureKind::Mean;
  task.task->done.limit = 0.5;
  LessonStep& curve = add("Measured", "The error falls.");
  curve.curve.emplace();
  curve.curve->values = {1, 2, 4};
  curve.mayMove = "Other values.";
  LessonStep& map = add("In the map", "The texels that are sampled.");
  map.map.emplace();
  lesson.exercises.push_back({"How far is it?", "As far as the wall.", "d = 2", "m", {}});
  lesson.exercises.push_back({"And then?", "No farther.", "", "", {}});
  return lesson;
}

}  // namespace boxprobe
