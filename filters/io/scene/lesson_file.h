// Reads *.lesson.json, one file per lesson, and the texts of all lessons, one file per language (see
// data/lessons/README.md).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "filters/core/scene/lesson.h"

namespace boxprobe {

/// Uses the texts in the lesson, else those of text/en.json beside it. Throws InputError: one line with the file, then
/// line and column, the path to the key, and what to do. The lesson's scene must exist, and every step's scene must be
/// valid.
Lesson loadLessonFile(const std::string& path);

/// The lessons of a folder, ordered by file name, with one error line for each that cannot be read.
struct LessonList {
  std::vector<Lesson> lessons;
  std::vector<std::string> errors;
  /// One line per text error that does not make a lesson unreadable: an incomplete translation, whose lesson is shown
  /// in English, and texts that no lesson uses.
  std::vector<std::string> textErrors;
  std::string language = "en";         ///< the requested one; a lesson without texts in it is in English, or in its own
  std::vector<LessonSymbol> notation;  ///< of all formulas, in the texts' order
};
/// Throws InputError if the folder does not exist or has no lessons, if there is no lesson in that language, or if the
/// file of its texts, or of the English ones, is invalid.
LessonList loadLessons(const std::string& folder, const std::string& language = "en");

/// The languages in which a folder has texts, sorted; always includes English.
std::vector<std::string> lessonLanguages(const std::string& folder);

/// The lesson of that name, or the one into which a lesson of that name was merged. Throws InputError with the nearest
/// name.
const Lesson& findLesson(const LessonList& list, std::string_view name);
/// Index of the step with which the former lesson of that name begins; nothing if it was not merged into this one.
std::optional<std::size_t> formerStep(const Lesson& lesson, std::string_view name);

/// Path of the scene file that a step starts from: the lesson's, or that of the last step that starts anew.
const std::string& sceneFileOf(const Lesson& lesson, std::size_t step);
/// The scene of a step: its scene file with the changes of all steps since it was opened. Throws InputError.
Scene lessonScene(const Lesson& lesson, std::size_t step);
/// The camera of a step: its own, else that of the last step before it that has one and shows the same scene file, else
/// the scene's `main`, else its first.
Camera lessonCamera(const Lesson& lesson, std::size_t step, const Scene& scene);

}  // namespace boxprobe
