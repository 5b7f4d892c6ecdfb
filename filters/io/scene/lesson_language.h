// All lessons' texts in one language: FOLDER/text/LANGUAGE.json, the one file that a translator copies. Internal to
// this folder; which language is wanted is the business of lesson_texts.h.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "filters/core/scene/lesson.h"
#include "filters/io/json/json_cursor.h"
#include "filters/io/scene/lesson_places.h"

namespace boxprobe {

/// The languages there is a file for, sorted.
std::vector<std::string> lessonTextLanguages(const std::string& folder);

/// Letters, digits and hyphens, as in pt-BR.
bool isLanguageId(const std::string& text);

class LessonLanguage {
 public:
  /// Throws InputError: one line with the file, the place in it and what to do. So do the others.
  LessonLanguage(const std::string& folder, const std::string& language);

  const std::string& id() const { return id_; }
  bool hasLesson(const std::string& lesson) const;
  bool hasChapter(const std::string& chapter) const;

  /// Puts every text of the lesson `name` where `places` says. Throws for one that is missing and for one that has no
  /// place.
  void putTexts(const std::string& name, const std::vector<LessonTextPlace>& places, Json& lesson) const;
  std::string chapter(const std::string& chapter) const;
  /// What the file says of the symbols in formulas; empty: nothing.
  std::vector<LessonSymbol> notation() const;
  /// The file's own words for that nobody has read it over; empty: it has none.
  std::string unreviewed() const;

  /// A line for each lesson and each chapter here that is not in `lessons` and `chapters`.
  std::vector<std::string> strays(const std::set<std::string>& lessons, const std::set<std::string>& chapters) const;

 private:
  JsonCursor group(const char* name) const { return *JsonCursor(file_.root, {}).find(name); }
  /// What a FieldError about this file says, with the line.
  std::string line(const FieldError& error) const;

  std::string id_;
  JsonText file_;
};

}  // namespace boxprobe
