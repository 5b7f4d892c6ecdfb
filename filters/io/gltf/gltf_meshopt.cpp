// EXT_meshopt_compression through meshoptimizer. The extension's codecs have bounded compression ratios, so a file's
// counts are checked against its bytes before anything is allocated.
#include <meshoptimizer.h>

#include <limits>

#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

enum class Codec { Attributes, Triangles, Indices };

/// The extension of a buffer view, validated.
struct Compressed {
  ByteRange bytes;
  Codec codec = Codec::Attributes;
  std::size_t count = 0, stride = 0;
  std::string filter;
};

std::string extensionText(const tinygltf::Value& extension, const char* key) {
  if (!extension.IsObject() || !extension.Has(key) || !extension.Get(key).IsString()) return {};
  return extension.Get(key).Get<std::string>();
}

/// Integers up to 2^53 are exact in the double that JSON gives.
std::size_t extensionSize(const GltfFile& file, const tinygltf::Value& extension, const char* key, double standard,
                          const std::string& place) {
  const double value = extensionNumber(extension, key, standard);
  if (!(value >= 0.0 && value <= 9007199254740992.0)) {
    file.fail(place, std::string(key) + " must be a whole number, 0 or more; export it again");
  }
  return static_cast<std::size_t>(value);
}

ByteRange compressedBytes(const GltfFile& file, const tinygltf::Value& extension, const std::string& place) {
  const int index = extensionWhole(extension, "buffer", -1);
  if (index < 0 || static_cast<std::size_t>(index) >= file.gltf.buffers.size()) {
    file.fail(place, "buffer " + std::to_string(index) + " does not exist; the file has " +
                         std::to_string(file.gltf.buffers.size()));
  }
  const std::vector<unsigned char>& bytes = file.gltf.buffers[static_cast<std::size_t>(index)].data;
  const std::size_t offset = extensionSize(file, extension, "byteOffset", 0.0, place);
  const std::size_t length = extensionSize(file, extension, "byteLength", -1.0, place);
  if (offset > bytes.size() || length > bytes.size() - offset) {
    file.fail(place, std::to_string(length) + " bytes from byte " + std::to_string(offset) +
                         " run past the end of buffer " + std::to_string(index) + " of " +
                         std::to_string(bytes.size()) + " bytes; the file is damaged");
  }
  return {bytes.data() + offset, length};
}

/// The codecs' limits on strides and on elements per byte: a group of 16 vertices takes at least 2 bits per byte of the
/// stride, a triangle a byte, an index a byte.
void checkSizes(const GltfFile& file, const Compressed& c, const std::string& place) {
  const bool attributes = c.codec == Codec::Attributes;
  const bool strideFits =
      attributes ? c.stride >= 4 && c.stride <= 256 && c.stride % 4 == 0 : c.stride == 2 || c.stride == 4;
  if (!strideFits) file.fail(place, "byteStride " + std::to_string(c.stride) + " is not possible; export it again");
  if (c.codec == Codec::Triangles && c.count % 3 != 0) {
    file.fail(place, "a count of " + std::to_string(c.count) + " is no whole number of triangles; export it again");
  }
  const bool octahedral = c.filter == "OCTAHEDRAL", quaternion = c.filter == "QUATERNION";
  if ((octahedral && c.stride != 4 && c.stride != 8) || (quaternion && c.stride != 8)) {
    file.fail(place, "byteStride " + std::to_string(c.stride) + " does not go with filter " + c.filter);
  }
  constexpr std::size_t kVerticesAByte = 64;
  const std::size_t most = attributes ? kVerticesAByte * (c.bytes.size / c.stride + 1)
                                      : (c.codec == Codec::Triangles ? 3 : 1) * c.bytes.size;
  if (c.count > most) {
    file.fail(place, std::to_string(c.count) + " elements are promised in " + std::to_string(c.bytes.size) +
                         " bytes; the file is damaged");
  }
}

Compressed compressedView(const GltfFile& file, const tinygltf::Value& extension, const std::string& place) {
  Compressed c;
  c.bytes = compressedBytes(file, extension, place);
  c.count = extensionSize(file, extension, "count", -1.0, place);
  c.stride = extensionSize(file, extension, "byteStride", -1.0, place);
  c.filter = extensionText(extension, "filter");
  const std::string mode = extensionText(extension, "mode");
  if (mode == "TRIANGLES" || mode == "INDICES") {
    c.codec = mode == "TRIANGLES" ? Codec::Triangles : Codec::Indices;
    c.filter.clear();
  } else if (mode != "ATTRIBUTES") {
    file.fail(place, "mode \"" + mode + "\" is unknown; export it again");
  }
  const bool known = c.filter.empty() || c.filter == "NONE" || c.filter == "OCTAHEDRAL" || c.filter == "QUATERNION" ||
                     c.filter == "EXPONENTIAL";
  if (!known) file.fail(place, "filter \"" + c.filter + "\" is unknown; export it again");
  checkSizes(file, c, place);
  return c;
}

std::vector<unsigned char> decoded(const GltfFile& file, const Compressed& c, const std::string& place) {
  std::vector<unsigned char> bytes(c.count * c.stride);
  if (c.count == 0) return bytes;
  int problem = 0;
  switch (c.codec) {
    case Codec::Attributes:
      problem = meshopt_decodeVertexBuffer(bytes.data(), c.count, c.stride, c.bytes.data, c.bytes.size);
      break;
    case Codec::Triangles:
      problem = meshopt_decodeIndexBuffer(bytes.data(), c.count, c.stride, c.bytes.data, c.bytes.size);
      break;
    case Codec::Indices:
      problem = meshopt_decodeIndexSequence(bytes.data(), c.count, c.stride, c.bytes.data, c.bytes.size);
      break;
  }
  if (problem != 0) file.fail(place, "its compressed bytes cannot be decoded; the file is damaged");
  if (c.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), c.count, c.stride);
  if (c.filter == "QUATERNION") meshopt_decodeFilterQuat(bytes.data(), c.count, c.stride);
  if (c.filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), c.count, c.stride);
  return bytes;
}

}  // namespace

void unpackMeshopt(GltfFile& file) {
  // All are counted before the first is decoded: views may share their compressed bytes.
  for (const bool counted : {false, true}) {
    for (std::size_t i = 0; i < file.gltf.bufferViews.size(); ++i) {
      const auto& extensions = file.gltf.bufferViews[i].extensions;
      const auto found = extensions.find("EXT_meshopt_compression");
      if (found == extensions.end()) continue;
      const std::string place = "bufferView " + std::to_string(i) + ": EXT_meshopt_compression";
      const Compressed compressed = compressedView(file, found->second, place);
      if (!counted) {
        file.count(compressed.count * compressed.stride, place);
        continue;
      }
      tinygltf::Buffer buffer;
      buffer.data = decoded(file, compressed, place);
      tinygltf::BufferView& view = file.gltf.bufferViews[i];
      view.buffer = static_cast<int>(file.gltf.buffers.size());
      view.byteOffset = 0;
      view.byteLength = buffer.data.size();
      view.byteStride = compressed.codec == Codec::Attributes ? compressed.stride : 0;
      file.gltf.buffers.push_back(std::move(buffer));
    }
  }
}

}  // namespace boxprobe
