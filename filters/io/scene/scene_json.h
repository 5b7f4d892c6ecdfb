// Converts scenes to and from JSON values. The public interface is scene_file.h.
#pragma once

#include <string>

#include "filters/core/base/field_error.h"
#include "filters/core/scene/scene.h"
#include "filters/io/json/json_text.h"

namespace boxprobe {

/// File names in the result are resolved against `folder`; "" leaves them unchanged. Throws FieldError. Does not
/// validate.
Scene sceneFromJson(const Json& root, const std::string& folder);

/// Minimal: default values are left out. Complete: every key that has a value, so that each can be replaced.
enum class JsonForm { Minimal, Complete };
/// File names are written relative to `folder`; "" leaves them unchanged.
Json sceneToJson(const Scene& scene, const std::string& folder, JsonForm form);

/// The JSON pointer of a key path in `root`, as far as it exists: names of probes become indices, "model" means
/// models[0].
Json::json_pointer pointerForPath(const Json& root, const KeyPath& path);

}  // namespace boxprobe
