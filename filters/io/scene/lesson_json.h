// A lesson from JSON values: what the lesson file's reader is made of. Internal to this folder; the public face is
// lesson_file.h.
#pragma once

#include <string>

#include "filters/core/scene/lesson.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

/// Names of files are resolved against `folder`. Throws FieldError. The scene is not read.
Lesson lessonFromJson(const Json& root, const std::string& folder);

}  // namespace boxprobe
