// See lesson_texts.h.
#include "filters/io/scene/lesson_texts.h"

#include <algorithm>
#include <utility>

namespace boxprobe {

LessonTexts::LessonTexts(std::string folder, const std::string& language) : folder_(std::move(folder)) {
  const std::vector<std::string> there = lessonTextLanguages(folder_);
  for (const std::string& wanted : {language, std::string("en")}) {
    if (!has(wanted) && std::find(there.begin(), there.end(), wanted) != there.end()) {
      languages_.emplace_back(folder_, wanted);
    }
  }
}

bool LessonTexts::has(const std::string& language) const {
  return std::any_of(languages_.begin(), languages_.end(),
                     [&](const LessonLanguage& own) { return own.id() == language; });
}

std::string LessonTexts::chapterName(const JsonCursor& chapter) {
  const std::string id = lessonTextId(chapter);
  chapters_.insert(id);
  for (const LessonLanguage& language : languages_) {
    if (language.hasChapter(id)) return language.chapter(id);
  }
  return languages_.back().chapter(id);  // throws with advice
}

Json LessonTexts::lessonWithTexts(const Json& lesson, const std::string& name) {
  const JsonCursor root(lesson, {});
  if (languages_.empty()) {
    root.fail("has no title; add \"title\": \"...\" and the lesson's other texts, or a file " + folder_ +
              "/text/en.json with them");
  }
  lessons_.insert(name);
  const auto chapter = root.find("chapter");
  if (!chapter) root.fail("has no chapter; add \"chapter\": \"...\", one of those in the files of texts");
  const std::vector<LessonTextPlace> places = lessonTextPlaces(lesson);
  for (const LessonLanguage& language : languages_) {
    const bool last = &language == &languages_.back();
    if (!last && !language.hasLesson(name)) continue;
    try {
      Json whole = lesson;
      language.putTexts(name, places, whole);
      whole["chapter"] = chapterName(*chapter);
      whole["language"] = language.id();
      if (const std::string note = language.unreviewed(); !note.empty()) whole["unreviewed"] = note;
      return whole;
    } catch (const FieldError&) {
      throw;
    } catch (const InputError& error) {
      if (last) throw;
      faults_.push_back(std::string(error.what()) + " (the lesson is in English until then)");
    }
  }
  return lesson;
}

std::vector<LessonSymbol> LessonTexts::notation() const {
  for (const LessonLanguage& language : languages_) {
    std::vector<LessonSymbol> symbols = language.notation();
    if (!symbols.empty()) return symbols;
  }
  return {};
}

std::vector<std::string> LessonTexts::strays() const {
  std::vector<std::string> lines;
  for (const LessonLanguage& language : languages_) {
    const std::vector<std::string> own = language.strays(lessons_, chapters_);
    lines.insert(lines.end(), own.begin(), own.end());
  }
  return lines;
}

}  // namespace boxprobe
