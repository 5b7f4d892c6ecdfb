// Reads any model file into plain arrays: glTF and OBJ through filters/io, PLY, STL and VTP through readers of this
// folder. Needs no display.
#pragma once

#include <string>

#include "filters/core/scene/model.h"
#include "filters/io/gltf/model_file.h"

namespace boxprobe {

/// Throws InputError with the file, what is wrong and where.
Model readModel(const std::string& path, const LoadProgress& progress = {}, const ModelState& state = {});

/// Can readModel read a file with this extension? Ignores case.
bool isModelFile(const std::string& path);

/// "*.glb *.gltf ...": for file dialogs and messages.
const std::string& modelFilePatterns();

}  // namespace boxprobe
