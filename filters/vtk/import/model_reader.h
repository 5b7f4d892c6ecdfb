// Any model file as plain arrays: glTF through filters/io, STL and VTP through readers of this folder, OBJ with MTL and
// PLY through VTK's, which get only files that were checked. Called by whatever opens scenes; needs no display.
#pragma once

#include <string>

#include "filters/core/scene/model.h"
#include "filters/io/gltf/model_file.h"

namespace boxprobe {

/// Throws InputError naming the file, what is wrong and where.
Model readModel(const std::string& path, const LoadProgress& progress = {}, const ModelState& state = {});

/// By its extension, in any case: is it a file for readModel?
bool isModelFile(const std::string& path);

/// "*.glb *.gltf ...": for file dialogs and messages.
const std::string& modelFilePatterns();

}  // namespace boxprobe
