// Reads OBJ files with their MTL and pictures.
#pragma once

#include <string>

#include "filters/core/scene/model.h"
#include "filters/io/gltf/model_file.h"

namespace boxprobe {

/// Objects (else groups) are the model's nodes, one mesh for each of their materials. What is missing beside the file
/// costs the colour, not the shape, and is said in the model's warnings, as is what the file asks for and does not get.
/// Throws InputError with file and line. Never reads outside the model's folder.
Model readObj(const std::string& path, const LoadProgress& progress = {});

}  // namespace boxprobe
