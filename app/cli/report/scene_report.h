// What a scene holds, as JSON: the answer of `info`. Needs no display.
#pragma once

#include <nlohmann/json.hpp>

#include "app/session/load_scene.h"

namespace boxprobe {

/// Keys: path, models, objects, probes, sky, cameras, lights, exposure, fit (of a bare model), warnings. Memory in
/// bytes, as on the graphics side.
nlohmann::ordered_json sceneReport(const LoadedScene& loaded);

}  // namespace boxprobe
