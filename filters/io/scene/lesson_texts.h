// Provides the texts of lessons: in the requested language if it has all texts of a lesson, else in English. Internal
// to this folder.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "filters/core/scene/lesson.h"
#include "filters/io/scene/lesson_language.h"

namespace boxprobe {

class LessonTexts {
 public:
  /// `language` first, then English; skips those without a file in `folder`. Throws InputError if a file is invalid.
  LessonTexts(std::string folder, const std::string& language);

  /// The lesson `name` with its texts inserted. Throws FieldError about the lesson, InputError about texts of the last
  /// language; errors in the language before it are listed by faults().
  Json lessonWithTexts(const Json& lesson, const std::string& name);

  /// In the requested language if it has one, else in English. Throws InputError.
  std::vector<LessonSymbol> notation() const;

  bool has(const std::string& language) const;
  /// One line for each lesson that is shown in English because of an error in the requested language.
  const std::vector<std::string>& faults() const { return faults_; }
  /// Lessons and chapters of the files that no lesson has used so far.
  std::vector<std::string> strays() const;

 private:
  std::string chapterName(const JsonCursor& chapter);

  std::string folder_;
  std::vector<LessonLanguage> languages_;  ///< in order of preference
  std::set<std::string> lessons_, chapters_;
  std::vector<std::string> faults_;
};

}  // namespace boxprobe
