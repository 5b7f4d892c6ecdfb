// Reads model files into plain arrays. glTF and GLB go through tinygltf (whole core format, extensions as JSON), so
// that the same arrays feed VTK and the ray tracer.
#pragma once

#include <string>

#include "filters/core/model.h"

namespace boxprobe {

/// Throws InputError naming the file, what is wrong and where (accessor, node, image). Never reads outside the model's
/// folder.
Model loadModelFile(const std::string& path);

}  // namespace boxprobe
