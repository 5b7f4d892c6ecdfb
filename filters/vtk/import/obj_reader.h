// Reads OBJ files.
#pragma once

#include "filters/io/gltf/model_file.h"

namespace boxprobe {

/// As readModel.
Model readObj(const std::string& path, const LoadProgress& progress);

/// For formats without materials: light grey plastic, double-sided, because winding is not reliable in them.
Material plainMaterial();

}  // namespace boxprobe
