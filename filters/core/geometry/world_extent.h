// How far a scene may extend. Each number of a file is checked where it is read; their combination through transforms
// is checked here, once, when a scene and its models are put together.
#pragma once

#include <memory>
#include <vector>

#include "filters/core/base/file_limits.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Throws InputError naming the node, its model's file and how far it extends if a corner of a mesh's bounds lies
/// beyond limits::kWorldCoordinate or is not finite after all transforms. `models` in the order of scene.models.
void checkExtent(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models);

}  // namespace boxprobe
