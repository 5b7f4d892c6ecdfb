// The texts of all lessons in one language: FOLDER/text/LANGUAGE.json, the only file that a translator copies. Internal
// to this folder; lesson_texts.h chooses the language.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "filters/core/scene/lesson.h"
#include "filters/io/json/json_cursor.h"
#include "filters/io/scene/lesson_places.h"

namespace boxprobe {

/// The languages with a text file, sorted.
std::vector<std::string> lessonTextLanguages(const std::string& folder);

/// Letters, digits and hyphens, as in pt-BR.
bool isLanguageId(const std::string& text);

class LessonLanguage {
 public:
  /// Throws InputError: one line with the file, the place in it and what to do. So do the other functions.
  LessonLanguage(const std::string& folder, const std::string& language);

  const std::string& id() const { return id_; }
  bool hasLesson(const std::string& lesson) const;
  bool hasChapter(const std::string& chapter) const;

  /// Inserts every text of the lesson `name` at its place in `places`. Throws for missing texts and for texts without a
  /// place.
  void putTexts(const std::string& name, const std::vector<LessonTextPlace>& places, Json& lesson) const;
  std::string chapter(const std::string& chapter) const;
  /// The file's descriptions of symbols in formulas; empty: none.
  std::vector<LessonSymbol> notation() const;
  /// The file's notice that the translation was not reviewed; empty: it was.
  std::string unreviewed() const;

  /// A line for each lesson and each chapter of this file that is not in `lessons` and `chapters`.
  std::vector<std::string> strays(const std::set<std::string>& lessons, const std::set<std::string>& chapters) const;

 private:
  JsonCursor group(const char* name) const { return *JsonCursor(file_.root, {}).find(name); }
  /// The message of a FieldError about this file, with its line.
  std::string line(const FieldError& error) const;

  std::string id_;
  JsonText file_;
};

}  // namespace boxprobe
