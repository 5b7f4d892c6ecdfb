// Gives lessons their texts: in the language that is wanted where it has all of a lesson's, else in English. Internal
// to this folder; called by lesson_file.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "filters/core/scene/lesson.h"
#include "filters/io/scene/lesson_language.h"

namespace boxprobe {

class LessonTexts {
 public:
  /// `language` first, then English; those of the two that `folder` has a file for. Throws InputError if one of the
  /// files is not what it should be.
  LessonTexts(std::string folder, const std::string& language);

  /// The lesson `name` as if it carried its texts itself. Throws FieldError about the lesson, InputError about the
  /// texts of the last language; what is wrong in the one before it is told by faults().
  Json lessonWithTexts(const Json& lesson, const std::string& name);

  /// In the language that is wanted if it has one, else in English. Throws InputError.
  std::vector<LessonSymbol> notation() const;

  bool has(const std::string& language) const;
  /// One line each: a lesson that is shown in English because a text in the language that is wanted is not right.
  const std::vector<std::string>& faults() const { return faults_; }
  /// Lessons and chapters of the files that no lesson so far has asked for.
  std::vector<std::string> strays() const;

 private:
  std::string chapterName(const JsonCursor& chapter);

  std::string folder_;
  std::vector<LessonLanguage> languages_;  ///< the most wanted first
  std::set<std::string> lessons_, chapters_;
  std::vector<std::string> faults_;
};

}  // namespace boxprobe
