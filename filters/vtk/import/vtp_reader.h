// Reads VTP files, VTK's XML format of PolyData: text and binary, inline and appended, compressed or not. VTK 9.1's own
// reader trusts the counts of headers: a file of 4 kB took 17 s and 3.9 GB.
#pragma once

#include <string>

#include "filters/core/scene/model.h"
#include "filters/io/gltf/model_file.h"

namespace boxprobe {

/// Polygons and strips of all pieces, with normals, texture coordinates and colours of points and cells; other arrays
/// are named in the model's warnings. Throws InputError with the array.
Model readVtp(const std::string& path, const LoadProgress& progress = {});

}  // namespace boxprobe
