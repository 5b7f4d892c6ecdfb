// Reads and writes *.boxprobe.json. Called by the program and the tests; knows nothing of VTK or Qt.
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

/// The same from text; `name` stands for the file in messages, `folder` is what paths are relative to.
BOXPROBE_EXPORT Scene parseScene(const std::string& text, const std::string& name, const std::string& folder);

/// A scene for a bare model file: default sky, one camera and one probe fitted to the model's bounds by the caller.
BOXPROBE_EXPORT Scene sceneForModel(const std::string& modelPath);

/// JSON text; paths are written relative to `folder`. What equals its default is left out. parseScene reads it back
/// equal.
BOXPROBE_EXPORT std::string sceneText(const Scene& scene, const std::string& folder);

/// Written to a temporary file beside `path`, flushed to disk and renamed: the old or the new file is there, whole.
BOXPROBE_EXPORT void saveSceneFile(const Scene& scene, const std::string& path);

/// Applies assignments as of `--set`, in order, and validates once all are in: "probes.room.box.max=[1,2,3]",
/// "materials.floor.roughness=0.25", "exposure=2", "probes.room.blendDistance=0.5", "objects.mirror.visible=false",
/// "cameras.main.position=[0,1,2]", "sky.color=[1,0,0]", "materials.\"Material.001\".roughness=0.5": a name in quotes
/// may hold dots, and adds a probe or camera that is not there. VALUE is JSON; a bare word is taken as a string. Throws
/// InputError naming the key that does not exist or the value of the wrong type; `scene` is then unchanged.
BOXPROBE_EXPORT void setSceneFields(Scene& scene, const std::vector<std::string>& assignments);

/// The number at a key path as of setSceneFields, defaults included; nothing if there is no number.
BOXPROBE_EXPORT std::optional<double> sceneNumber(const Scene& scene, const std::string& keys);

}  // namespace boxprobe
