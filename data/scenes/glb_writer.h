// A model as the bytes of a GLB file, pictures as PNG inside. Called by generate_scenes and its test. Equal models give
// equal bytes; images and meshes that are shared in the model are shared in the file.
#pragma once

#include <string>

#include "filters/core/scene/model.h"

namespace boxprobe::scenes {

/// Throws WorkError for a mesh without normals or texture coordinates, since every scene here promises both. Written
/// are base colour, roughness, occlusion, emissive and normal textures, sheen and brushed metal: no scene here has
/// others. With a `jpegQuality` other than 0 opaque pictures of more than 128 texels a side become JPEG.
std::string glbBytes(const Model& model, int jpegQuality = 0);

}  // namespace boxprobe::scenes
