// How a page shows a scene that another part of it already holds: what data/web/room.js changes of web_scene.h's scene.
#pragma once

#include <string>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// {"camera": {..}, "hidden": [object, ..], "technique": id, "roughness": {material: r}, "boxes": [{"min", "max"}, ..]
/// in the order of the probes, relative to each capture origin}. Objects, materials and probes are those that `scene`
/// names.
std::string webView(const Scene& scene, const Camera& camera);

}  // namespace boxprobe
