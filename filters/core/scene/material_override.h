// A model's material with a scene's override applied: used for drawing and for tracing.
#pragma once

#include "filters/core/scene/model.h"

namespace boxprobe {

/// `material` with the scene's override. A thickness makes it a solid, thickness 0 a sheet, unless `thin` is given.
Material overriddenMaterial(Material material, const Scene& scene);

}  // namespace boxprobe
