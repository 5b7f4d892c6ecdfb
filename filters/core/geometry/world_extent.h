// How far a scene may reach. Each number of a file is checked by itself where it is read; what transforms make of them
// together is checked here, once, where a scene and its models are put together. Called by the loader of scenes.
#pragma once

#include <memory>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Coordinates of geometry, world. A float still holds the area of a triangle that large.
constexpr double kLargestCoordinateWorld = 1.0e15;

/// Throws InputError naming the node, its model's file and how far it reaches, if a corner of a mesh's bounds lies
/// beyond kLargestCoordinateWorld or is not finite after all transforms. `models` in the order of scene.models.
void checkExtent(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models);

}  // namespace boxprobe
