// Reads *.lesson.json: one file a lesson (see data/lessons/README.md). Called by the window, `boxprobe lessons` and
// tests; knows nothing of VTK or Qt.
#pragma once

#include <string>
#include <vector>

#include "filters/core/scene/lesson.h"

namespace boxprobe {

/// Throws InputError: one line with the file, then line and column, the path to the key, and what to do. The scene it
/// names is there, and every step's scene is valid.
Lesson loadLessonFile(const std::string& path);

/// Of a folder, ordered by file name: the lessons that can be read, and for each of the others its one line.
struct LessonList {
  std::vector<Lesson> lessons;
  std::vector<std::string> errors;
};
/// Throws InputError if there is no such folder, or no lesson in it.
LessonList loadLessons(const std::string& folder);

/// The lesson of that name. Throws InputError with the nearest one.
const Lesson& findLesson(const LessonList& list, const std::string& name);

/// The scene as a step shows it: the lesson's, with its changes and those of every step up to this one. Throws
/// InputError.
Scene lessonScene(const Lesson& lesson, std::size_t step);
/// The camera of a step: its own, or that of the last step before it that has one, or the scene's `main`, else its
/// first.
Camera lessonCamera(const Lesson& lesson, std::size_t step, const Scene& scene);

}  // namespace boxprobe
