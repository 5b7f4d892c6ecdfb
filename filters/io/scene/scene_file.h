// Reads and writes *.boxprobe.json.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filters/core/base/export.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Parses and validates. Paths in the result are resolved against the file's folder. Throws InputError: one line with
/// the file, then line and column (JSON errors) or the path to the key, and what to do.
BOXPROBE_EXPORT Scene loadSceneFile(const std::string& path);

/// The same from text; `name` stands for the file in messages; paths are relative to `folder`.
BOXPROBE_EXPORT Scene parseScene(const std::string& text, const std::string& name, const std::string& folder);

/// A scene for a bare model file: default sky, one camera and one probe, which the caller fits to the model's bounds.
BOXPROBE_EXPORT Scene sceneForModel(const std::string& modelPath);

/// JSON text that parseScene reads back equal; paths are relative to `folder`, and default values are left out.
BOXPROBE_EXPORT std::string sceneText(const Scene& scene, const std::string& folder);

/// Written to a temporary file beside `path`, flushed to disk and renamed: at any time there is a complete old or new
/// file.
BOXPROBE_EXPORT void saveSceneFile(const Scene& scene, const std::string& path);

/// Applies assignments as of `--set`, in order, and validates the result: "probes.room.box.max=[1,2,3]",
/// "materials.floor.roughness=0.25", "exposure=2", "probes.room.blendDistance=0.5", "objects.mirror.visible=false",
/// "cameras.main.position=[0,1,2]", "sky.color=[1,0,0]", "materials.\"Material.001\".roughness=0.5". A quoted name may
/// contain dots, and adds a probe or camera that does not exist. The value is JSON; a bare word is taken as a string.
/// Throws InputError with the unknown key or the value of the wrong type; `scene` is then unchanged.
BOXPROBE_EXPORT void setSceneFields(Scene& scene, const std::vector<std::string>& assignments);

/// The number at a key path as in setSceneFields, including defaults; nothing if there is no number.
BOXPROBE_EXPORT std::optional<double> sceneNumber(const Scene& scene, const std::string& keys);

}  // namespace boxprobe
