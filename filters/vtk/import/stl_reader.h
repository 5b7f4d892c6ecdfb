// STL files, binary and text. Called by the model reader. Knows no VTK: VTK 9.1's reader asks for the memory that a
// header promises and takes text for binary data. Source: the StereoLithography Interface Specification (3D Systems,
// 1988).
#pragma once

#include <string>

#include "filters/core/scene/model.h"
#include "filters/io/gltf/model_file.h"

namespace boxprobe {

/// Triangles without normals; those that a file has are often wrong. Throws InputError naming line or triangle. Memory
/// is at most a few times the file's size, time linear in it.
Mesh readStlMesh(const std::string& path, const LoadProgress& progress = {});

}  // namespace boxprobe
