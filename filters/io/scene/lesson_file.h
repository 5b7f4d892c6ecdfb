// Reads *.lesson.json: one file a lesson, and the texts of all lessons, one file a language (see
// data/lessons/README.md). Called by the window, `boxprobe lessons` and tests; knows nothing of VTK or Qt.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "filters/core/scene/lesson.h"

namespace boxprobe {

/// With the texts it carries, else with those of text/en.json beside it. Throws InputError: one line with the file,
/// then line and column, the path to the key, and what to do. The scene it names is there, and every step's scene is
/// valid.
Lesson loadLessonFile(const std::string& path);

/// Of a folder, ordered by file name: the lessons that can be read, and for each of the others its one line.
struct LessonList {
  std::vector<Lesson> lessons;
  std::vector<std::string> errors;
  /// One line for each text that is wrong and yet keeps no lesson from being read: a translation that is not whole, so
  /// that its lesson is in English, and texts that no lesson asks for.
  std::vector<std::string> textErrors;
  std::string language = "en";         ///< the one asked for; a lesson without texts in it is in English, or in its own
  std::vector<LessonSymbol> notation;  ///< of all formulas, as the texts order them
};
/// Throws InputError if there is no such folder, no lesson in it, no lesson in that language, or if the file of its
/// texts, or of the English ones, is none.
LessonList loadLessons(const std::string& folder, const std::string& language = "en");

/// The languages that a folder has texts in, sorted; English always.
std::vector<std::string> lessonLanguages(const std::string& folder);

/// The lesson of that name. Throws InputError with the nearest one.
const Lesson& findLesson(const LessonList& list, std::string_view name);

/// The scene as a step shows it: the lesson's, with its changes and those of every step up to this one. Throws
/// InputError.
Scene lessonScene(const Lesson& lesson, std::size_t step);
/// The camera of a step: its own, or that of the last step before it that has one, or the scene's `main`, else its
/// first.
Camera lessonCamera(const Lesson& lesson, std::size_t step, const Scene& scene);

}  // namespace boxprobe
