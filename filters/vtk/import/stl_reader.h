// Reads STL files, binary and text, with the colours that programs put into the binary form. VTK 9.1's reader allocates
// the memory that a header claims, and mistakes text for binary data. Source: the StereoLithography Interface
// Specification (3D Systems, 1988).
#pragma once

#include <string>

#include "filters/core/scene/model.h"
#include "filters/io/gltf/model_file.h"

namespace boxprobe {

/// Triangles with computed normals; those in files are often wrong. Throws InputError with the line or triangle. Memory
/// is at most a few times the file's size, time is linear in it.
Model readStl(const std::string& path, const LoadProgress& progress = {});

}  // namespace boxprobe
