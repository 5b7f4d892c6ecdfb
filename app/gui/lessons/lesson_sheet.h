// A lesson on one sheet of paper: its steps side by side, each a picture with its text and formula, then what was
// measured. Called by `boxprobe lessons -o`; knows no scene.
#pragma once

#include <QImage>

#include "app/gui/lessons/lesson_pictures.h"
#include "filters/core/scene/lesson.h"

namespace boxprobe {

/// Needs a QGuiApplication, for its fonts.
QImage lessonSheet(const Lesson& lesson, const LessonPictures& pictures);

}  // namespace boxprobe
