// Scene to and from JSON values: what the scene file's reader, writer and single-field setter share, and the Python
// module. The public face is scene_file.h.
#pragma once

#include <string>

#include "filters/core/base/field_error.h"
#include "filters/core/scene/scene.h"
#include "filters/io/json/json_text.h"

namespace boxprobe {

/// File names in the result are resolved against `folder`; "" leaves them as they are. Throws FieldError. Not
/// validated.
Scene sceneFromJson(const Json& root, const std::string& folder);

/// Minimal: what equals its default is left out. Complete: every key that has a value, so that each can be replaced.
enum class JsonForm { Minimal, Complete };
/// File names are written relative to `folder`; "" leaves them as they are.
Json sceneToJson(const Scene& scene, const std::string& folder, JsonForm form);

/// Where a key path leads in `root`: names of probes become indices, "model" stands in for models[0]. As far as it
/// goes.
Json::json_pointer pointerForPath(const Json& root, const KeyPath& path);

}  // namespace boxprobe
