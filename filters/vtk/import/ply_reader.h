// Reads PLY files, text and binary of either byte order. VTK 9.1's reader rounds positions to single precision, knows
// few names of properties, and crashes on damaged files.
#pragma once

#include <string>

#include "filters/core/scene/model.h"
#include "filters/io/gltf/model_file.h"

namespace boxprobe {

/// Polygons and triangle strips with normals, colours of vertices and faces (sRGB), texture coordinates of vertices and
/// of corners, and the pictures of "comment TextureFile". What a file has beyond that is named in the model's warnings.
/// Throws InputError with the line, or with the entry of binary data.
Model readPly(const std::string& path, const LoadProgress& progress = {});

}  // namespace boxprobe
