// Parses a lesson from JSON values. Internal to this folder; the public interface is lesson_file.h.
#pragma once

#include <string>

#include "filters/core/scene/lesson.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

/// Throws FieldError unless it is a lesson of a supported version, with a lesson's keys.
void requireLessonHeader(const Json& root);

/// Parses a lesson that has its header and texts. File names are resolved against `folder`. The scene is not read.
/// Throws FieldError.
Lesson lessonFromJson(const Json& root, const std::string& folder);

}  // namespace boxprobe
