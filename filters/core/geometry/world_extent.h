// What geometry a scene may hold. Each number of a file is checked where it is read; their combination through
// transforms is checked here, once, when a scene and its models are put together.
#pragma once

#include <memory>
#include <vector>

#include "filters/core/base/file_limits.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Throws InputError naming the node and its model's file
/// - where a corner of a mesh's bounds lies beyond limits::kWorldCoordinate or is not finite after all transforms;
/// - where more than about limits::kTrianglesInOnePlace triangles overlap: at the fullest of 64 places, by the
///   triangles' bounds, and of more than 65,536 triangles by a sample.
/// `models` in the order of scene.models.
void checkGeometry(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models);

}  // namespace boxprobe
