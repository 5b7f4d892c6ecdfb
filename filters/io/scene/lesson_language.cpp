// See lesson_language.h.
#include "filters/io/scene/lesson_language.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "filters/core/base/file_limits.h"
#include "filters/core/base/nearest_name.h"
#include "filters/io/files/read_file.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

std::string required(const JsonCursor& value) {
  std::string text = value.text();
  if (text.empty()) value.fail("is empty");
  return text;
}

/// One level at a time: the library's operator[] of a pointer is a deprecated comparison in newer compilers.
Json& valueAt(Json& root, const Json::json_pointer& place) {
  if (place.empty()) return root;
  Json& holder = valueAt(root, place.parent_pointer());
  return holder.is_array() ? holder[std::stoul(place.back())] : holder[place.back()];
}

void readHeader(const JsonCursor& root, const std::string& language) {
  root.requireObject();
  const auto format = root.find("format");
  if (!format || format->json() != "boxprobe-lesson-text") {
    root.fail(
        "is not a file of lessons' texts; it starts with { \"format\": \"boxprobe-lesson-text\", \"version\": 1, ...");
  }
  for (const char* name : {"version", "language", "chapters", "lessons"}) {
    if (!root.find(name)) root.fail(std::string("has no ") + name);
  }
  const JsonCursor version = *root.find("version"), own = *root.find("language");
  if (version.whole() != 1) version.fail("is not 1, the one this program reads; get a newer program");
  if (own.text() != language) {
    own.fail("is \"" + own.text() + "\" and the file is named " + language + ".json; make them the same");
  }
  root.requireObject({"format", "version", "language", "unreviewed", "notation", "chapters", "lessons"});
  for (const char* name : {"chapters", "lessons"}) root.find(name)->requireObject();
  if (const auto note = root.find("unreviewed")) required(*note);
}

/// Inserts a lesson's texts one by one.
class TextMover {
 public:
  TextMover(const std::vector<LessonTextPlace>& places, Json& lesson) : lesson_(lesson) {
    for (const LessonTextPlace& place : places) {
      KeyPath key;
      for (const std::string& part : place.key) {
        std::vector<std::string>& names = known_[key];
        if (std::find(names.begin(), names.end(), part) == names.end()) names.push_back(part);
        key.push_back(part);
      }
      places_[key] = place.into;
    }
  }

  /// `key`: of the entry, in the lesson.
  void move(const JsonCursor& entry, const KeyPath& key = {}) {
    const std::vector<std::string>& names = known_[key];
    for (const JsonCursor& member : entry.members()) {
      if (std::find(names.begin(), names.end(), member.key()) == names.end()) {
        const std::string guess = didYouMean(member.key(), names);
        member.fail("has no place in the lesson" + (guess.empty() ? "; here it asks for " + nameList(names) : guess));
      }
      KeyPath at = key;
      at.push_back(member.key());
      if (const auto place = places_.find(at); place != places_.end()) {
        valueAt(lesson_, place->second) = required(member);
      } else {
        move(member, at);
      }
    }
    for (const std::string& name : names) {
      if (entry.find(name.c_str())) continue;
      KeyPath at = key;
      at.push_back(name);
      std::string reason = "has no " + name;
      reason.append("; add \"").append(name).append(places_.count(at) != 0 ? "\": \"...\"" : "\": {...}");
      entry.fail(reason);
    }
  }

 private:
  Json& lesson_;
  std::map<KeyPath, Json::json_pointer> places_;
  std::map<KeyPath, std::vector<std::string>> known_;  ///< the keys below each key
};

std::string textFolder(const std::string& folder) {
  return folder + "/text";
}

}  // namespace

bool isLanguageId(const std::string& text) {
  const auto fits = [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), fits);
}

std::vector<std::string> lessonTextLanguages(const std::string& folder) {
  std::vector<std::string> languages;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(textFolder(folder), error)) {
    const fs::path& path = entry.path();
    if (path.extension() == ".json" && isLanguageId(path.stem().string())) languages.push_back(path.stem().string());
  }
  std::sort(languages.begin(), languages.end());
  return languages;
}

LessonLanguage::LessonLanguage(const std::string& folder, const std::string& language) : id_(language) {
  const std::string path = textFolder(folder) + "/" + language + ".json";
  file_ = parseJsonText(readWholeFile(path, limits::kLessonTextBytes), path);
  try {
    readHeader(JsonCursor(file_.root, {}), language);
  } catch (const FieldError& error) {
    throw InputError(line(error));
  }
}

std::string LessonLanguage::line(const FieldError& error) const {
  return file_.placeText(pointerForPath(file_.root, error.path())) + ": " + error.what();
}

bool LessonLanguage::hasLesson(const std::string& lesson) const {
  return group("lessons").find(lesson.c_str()).has_value();
}

bool LessonLanguage::hasChapter(const std::string& chapter) const {
  return group("chapters").find(chapter.c_str()).has_value();
}

void LessonLanguage::putTexts(const std::string& name, const std::vector<LessonTextPlace>& places, Json& lesson) const {
  try {
    const JsonCursor lessons = group("lessons");
    const auto texts = lessons.find(name.c_str());
    if (!texts) lessons.fail("has no " + name + "; add \"" + name + "\": {...}, or give the lesson a title and texts");
    TextMover(places, lesson).move(*texts);
  } catch (const FieldError& error) {
    throw InputError(line(error));
  }
}

std::string LessonLanguage::chapter(const std::string& chapter) const {
  try {
    const JsonCursor chapters = group("chapters");
    const auto text = chapters.find(chapter.c_str());
    if (!text) chapters.fail("has no " + chapter + "; add \"" + chapter + "\": \"...\"");
    return required(*text);
  } catch (const FieldError& error) {
    throw InputError(line(error));
  }
}

std::vector<LessonSymbol> LessonLanguage::notation() const {
  std::vector<LessonSymbol> symbols;
  try {
    const auto list = JsonCursor(file_.root, {}).find("notation");
    if (!list) return symbols;
    list->requireArray();
    for (const JsonCursor& entry : list->elements()) {
      entry.requireObject({"symbol", "means"});
      const auto symbol = entry.find("symbol"), means = entry.find("means");
      if (!symbol || !means) entry.fail("needs both, a symbol and what it means");
      symbols.push_back({required(*symbol), required(*means)});
    }
  } catch (const FieldError& error) {
    throw InputError(line(error));
  }
  return symbols;
}

std::string LessonLanguage::unreviewed() const {
  const auto note = JsonCursor(file_.root, {}).find("unreviewed");
  return note ? note->text() : std::string();
}

std::vector<std::string> LessonLanguage::strays(const std::set<std::string>& lessons,
                                                const std::set<std::string>& chapters) const {
  std::vector<std::string> lines;
  const auto compare = [&](const char* name, const std::set<std::string>& known, const std::string& reason) {
    for (const JsonCursor& member : group(name).members()) {
      if (known.count(member.key()) != 0) continue;
      const std::string guess = didYouMean(member.key(), {known.begin(), known.end()});
      lines.push_back(line(FieldError(member.path(), reason + (guess.empty() ? "; take it out" : guess))));
    }
  };
  compare("lessons", lessons, "no lesson of that name takes its texts from here");
  compare("chapters", chapters, "no lesson is of that chapter");
  return lines;
}

}  // namespace boxprobe
