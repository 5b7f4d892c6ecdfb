// A glTF file as it is, to be added to: its JSON, and everything that it names as one buffer. Nothing is decoded, so
// that extensions which nobody here knows survive. Called by what writes .glb files.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "filters/io/json/json_text.h"

namespace boxprobe {

struct GlbDocument {
  Json json;
  std::string binary;  ///< of buffer 0, the binary chunk; its length a multiple of 4
};

/// Of a .glb or .gltf file. Buffers are joined into one; pictures beside the file are taken into it, except those that
/// do not exist. Throws InputError: one line with the file and the place.
GlbDocument readGlbDocument(const std::string& path);

/// Adds a buffer view of these bytes, which begins at a multiple of 4, and returns its index.
std::size_t addBytes(GlbDocument& document, const std::string& bytes);

/// As a file. `path` is for the message: throws InputError if it would have more bytes than GLB's 32-bit lengths count.
std::string glbText(const GlbDocument& document, const std::string& path);

/// Throws as glbText() does if the document and so many bytes more would not fit: to be asked before they are made.
void requireGlbSize(const GlbDocument& document, std::uint64_t more, const std::string& path);

/// The JSON chunk alone, which is all that is read of the file; nothing if it is no .glb. Throws InputError for a
/// damaged one.
std::optional<std::string> glbJsonText(const std::string& path);

}  // namespace boxprobe
