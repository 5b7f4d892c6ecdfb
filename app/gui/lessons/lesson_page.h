// All lessons on one HTML page that needs nothing beside it: pictures within, formulas as MathML, questions that
// answer. Called by `boxprobe lessons -o`; knows no scene.
#pragma once

#include <string>

#include "app/gui/lessons/lesson_pictures.h"
#include "filters/core/scene/lesson.h"

namespace boxprobe {

class LessonPage {
 public:
  void add(const Lesson& lesson, const LessonPictures& pictures);
  std::string text() const;

 private:
  std::string contents_, body_, chapter_;
};

}  // namespace boxprobe
