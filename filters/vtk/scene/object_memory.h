#pragma once

#include <memory>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Throws InputError naming the model with most instances where actors for all of them would take more than half of the
/// machine's memory. `models` in the order of scene.models.
void requireMemoryForObjects(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models);

}  // namespace boxprobe
