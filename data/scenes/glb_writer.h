// A model as the bytes of a GLB file, pictures as PNG inside. Called by generate_scenes and its test. Equal models give
// equal bytes; images and meshes that are shared in the model are shared in the file.
#pragma once

#include <string>

#include "filters/core/scene/model.h"

namespace boxprobe::scenes {

/// Throws WorkError for a mesh without normals or texture coordinates, since every scene here promises both. Textures
/// other than base colour, emissive and normal are not written: no scene here has them.
std::string glbBytes(const Model& model);

}  // namespace boxprobe::scenes
