// Which texts a lesson without texts of its own asks for, and where in the lesson each of them belongs. Internal to
// this folder; knows nothing of languages or files.
#pragma once

#include <vector>

#include "filters/io/json/json_cursor.h"

namespace boxprobe {

/// One text: its key path among a language's texts of the lesson, {"steps", "on-the-floor", "say"}, and its place in
/// the lesson, "/steps/0/say".
struct LessonTextPlace {
  KeyPath key;
  Json::json_pointer into;
};

/// True for a lesson that carries its texts itself: it has a title.
bool carriesTexts(const Json& lesson);

/// In the lesson's order, without the chapter's name, which lessons share. Throws FieldError for a step, answer or
/// claim without an id of its own, and for a text that stands in the lesson.
std::vector<LessonTextPlace> lessonTextPlaces(const Json& lesson);

/// The text of an id: throws FieldError unless it is made of small letters, digits and hyphens.
std::string lessonTextId(const JsonCursor& value);

}  // namespace boxprobe
