// The container of a .glb file.
#pragma once

#include <cstdint>
#include <memory>
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

/// A file of either form as it lies on the disk.
struct GltfSource {
  std::string bytes;
  bool binary = false;  ///< .glb: `chunks` are its own; else `bytes` are the JSON text
  Chunks chunks;
  const std::string& json() const { return binary ? chunks.json : bytes; }
};

/// The size and the syntax of the JSON text are checked. Throws InputError.
GltfSource readGltfSource(const std::string& path);

/// The `length` bytes of buffer `index`: of its `uri`, else, for buffer 0 (glTF 2.0, section 3.6.1.2), of the binary
/// chunk, null for a file without one. `read` keeps what was read. Throws InputError for what is missing or cut off.
ByteRange bufferBytes(const GltfFile& file, std::size_t index, const std::string& uri, const ByteRange* chunk,
                      std::uint64_t length, std::unique_ptr<std::string>& read);

}  // namespace boxprobe
