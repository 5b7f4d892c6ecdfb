// A lesson from JSON values: what the lesson file's reader is made of. Internal to this folder; the public face is
// lesson_file.h.
#pragma once

#include <string>

#include "filters/core/scene/lesson.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

/// Throws FieldError unless it says that it is a lesson, of a version that this program reads, and has a lesson's keys.
void requireLessonHeader(const Json& root);

/// Of a lesson with its header and its texts. Names of files are resolved against `folder`. Throws FieldError. The
/// scene is not read.
Lesson lessonFromJson(const Json& root, const std::string& folder);

}  // namespace boxprobe
