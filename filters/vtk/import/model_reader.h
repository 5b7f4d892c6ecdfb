// Any model file as plain arrays: glTF through filters/io, OBJ with MTL, PLY, STL and VTP through VTK's readers, whose
// counts and indices are checked before and after. Called by whatever opens scenes; needs no display.
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
