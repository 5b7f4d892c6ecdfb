// The container of a .glb file.
#pragma once

#include <string>

#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

/// The JSON and the binary chunk of a GLB file.
struct Chunks {
  std::string json;
  ByteRange binary;  ///< within the bytes that were given
};

/// Throws InputError with `path` for what is cut off or of another version.
Chunks chunksOf(const std::string& bytes, const std::string& path);

}  // namespace boxprobe
