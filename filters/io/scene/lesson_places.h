// Which texts a lesson without texts of its own needs, and where each belongs in it. Internal to this folder.
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

/// Does the lesson contain its texts, that is, a title?
bool carriesTexts(const Json& lesson);

/// In the lesson's order, without the chapter's name, which lessons share. Throws FieldError for a step, answer or
/// claim without an id, and for a text in the lesson.
std::vector<LessonTextPlace> lessonTextPlaces(const Json& lesson);

/// The id: throws FieldError unless it consists of lower-case letters, digits and hyphens.
std::string lessonTextId(const JsonCursor& value);

}  // namespace boxprobe
