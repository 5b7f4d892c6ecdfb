// A model's material with a scene's override on it: what is drawn and what is traced. Called by the VTK layer, the
// reference and the material panel; knows neither.
#pragma once

#include "filters/core/scene/model.h"

namespace boxprobe {

/// `material` as `scene` wants it. A thickness makes a solid of it, thickness 0 a sheet, unless `thin` says otherwise.
Material overriddenMaterial(Material material, const Scene& scene);

}  // namespace boxprobe
