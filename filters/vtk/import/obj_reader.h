// OBJ files. Called by the model reader alone.
#pragma once

#include "filters/io/gltf/model_file.h"

namespace boxprobe {

/// As readModel.
Model readObj(const std::string& path, const LoadProgress& progress);

/// For files that say nothing of it: light grey plastic, seen from both sides, because winding is not reliable there.
Material plainMaterial();

}  // namespace boxprobe
