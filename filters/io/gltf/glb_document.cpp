#include "filters/io/gltf/glb_document.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/read_file.h"
#include "filters/io/gltf/gltf_chunks.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

constexpr std::uint64_t kHeaders = 12 + 8 + 8;

void append32(std::string& bytes, std::uint64_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
}

void pad(std::string& bytes, char with) {
  bytes.resize((bytes.size() + 3) / 4 * 4, with);
}

Json* member(Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

/// Where each of the file's buffers begins in the joined one. A fallback for readers that cannot decompress has no
/// bytes and stays a buffer of its own.
struct JoinedBuffer {
  std::size_t index = 0, offset = 0;
};

std::size_t wholeNumber(const GltfFile& file, const Json* value, std::size_t standard, const std::string& place) {
  if (value == nullptr) return standard;
  if (!value->is_number_unsigned() || value->get<std::uint64_t>() > limits::kGltfBytes) {
    file.fail(place, "is not a whole number in range; export it again");
  }
  return value->get<std::size_t>();
}

std::vector<JoinedBuffer> joinBuffers(const GltfFile& file, const GltfSource& source, GlbDocument& document) {
  std::vector<JoinedBuffer> joined;
  Json kept = Json::array({Json::object()});
  Json* buffers = member(document.json, "buffers");
  if (buffers != nullptr && !buffers->is_array()) file.fail("buffers", "is not a list; export it again");
  for (std::size_t i = 0; buffers != nullptr && i < buffers->size(); ++i) {
    Json& buffer = (*buffers)[i];
    const std::string place = "buffer " + std::to_string(i);
    const std::size_t length = wholeNumber(file, member(buffer, "byteLength"), 0, place + ": byteLength");
    const Json* uri = member(buffer, "uri");
    if (uri != nullptr && !uri->is_string()) file.fail(place, "uri is not a text; export it again");
    Json* extensions = member(buffer, "extensions");
    if (uri == nullptr && extensions != nullptr && extensions->contains("EXT_meshopt_compression")) {
      joined.push_back({kept.size(), 0});
      kept.push_back(buffer);
      continue;
    }
    // Each buffer may name the same bytes once more.
    if (length > limits::kGltfBytes - std::min<std::uint64_t>(document.binary.size(), limits::kGltfBytes)) {
      file.fail("buffers", "have more than 4095 MB together; split the model");
    }
    std::unique_ptr<std::string> read;
    const ByteRange range = bufferBytes(file, i, uri != nullptr ? uri->get<std::string>() : std::string(),
                                        source.binary ? &source.chunks.binary : nullptr, length, read);
    joined.push_back({0, document.binary.size()});
    document.binary.append(reinterpret_cast<const char*>(range.data), range.size);
    document.binary.resize((document.binary.size() + 15) / 16 * 16, '\0');  // views keep what they were aligned to
  }
  document.json["buffers"] = std::move(kept);
  return joined;
}

void moveView(const GltfFile& file, Json& view, const std::vector<JoinedBuffer>& joined, const std::string& place) {
  const std::size_t buffer = wholeNumber(file, member(view, "buffer"), joined.size(), place + ": buffer");
  if (buffer >= joined.size()) file.fail(place, "has no buffer of that number; export it again");
  view["buffer"] = joined[buffer].index;
  const std::size_t offset = wholeNumber(file, member(view, "byteOffset"), 0, place + ": byteOffset");
  if (offset + joined[buffer].offset > 0) view["byteOffset"] = offset + joined[buffer].offset;
}

const char* mimeOf(const std::string& bytes) {
  if (bytes.compare(0, 4, "\x89PNG") == 0) return "image/png";
  if (bytes.compare(0, 2, "\xff\xd8") == 0) return "image/jpeg";
  if (bytes.size() > 12 && bytes.compare(0, 4, "RIFF") == 0 && bytes.compare(8, 4, "WEBP") == 0) return "image/webp";
  if (bytes.size() > 7 && bytes.compare(1, 6, "KTX 20") == 0) return "image/ktx2";
  return nullptr;
}

void takeImages(const GltfFile& file, GlbDocument& document) {
  Json* images = member(document.json, "images");
  if (images == nullptr || !images->is_array()) return;
  for (Json& image : *images) {
    const Json* uri = member(image, "uri");
    if (uri == nullptr || !uri->is_string() || isDataUri(uri->get<std::string>())) continue;
    const auto bytes = readUri(file, uri->get<std::string>());
    const char* mime = bytes ? mimeOf(*bytes) : nullptr;
    if (mime == nullptr) continue;  // it keeps its address: there is none, or no format that a .glb may hold
    requireGlbSize(document, bytes->size(), file.path);
    image.erase("uri");
    image["bufferView"] = addBytes(document, *bytes);
    image["mimeType"] = mime;
  }
}

}  // namespace

GlbDocument readGlbDocument(const std::string& path) {
  const GltfSource source = readGltfSource(path);
  GltfFile file;
  file.path = path;
  GlbDocument document;
  try {
    document.json = Json::parse(source.json());
    if (!document.json.is_object()) file.fail("asset", "is missing; is it a glTF file?");
    const std::vector<JoinedBuffer> joined = joinBuffers(file, source, document);
    if (Json* views = member(document.json, "bufferViews"); views != nullptr && views->is_array()) {
      for (std::size_t i = 0; i < views->size(); ++i) {
        const std::string place = "bufferView " + std::to_string(i);
        moveView(file, (*views)[i], joined, place);
        Json* extensions = member((*views)[i], "extensions");
        Json* meshopt = extensions == nullptr ? nullptr : member(*extensions, "EXT_meshopt_compression");
        if (meshopt != nullptr) moveView(file, *meshopt, joined, place + ": EXT_meshopt_compression");
      }
    }
    takeImages(file, document);
  } catch (const Json::exception& problem) {
    throw InputError(oneLine(path + ": " + problem.what() + "; export it again"));
  }
  return document;
}

std::size_t addBytes(GlbDocument& document, const std::string& bytes) {
  Json& views = document.json["bufferViews"];
  views.push_back({{"buffer", 0}, {"byteOffset", document.binary.size()}, {"byteLength", bytes.size()}});
  document.binary += bytes;
  pad(document.binary, '\0');
  return views.size() - 1;
}

void requireGlbSize(const GlbDocument& document, std::uint64_t more, const std::string& path) {
  const std::uint64_t size = kHeaders + document.binary.size() + more;
  if (size <= limits::kGltfBytes) return;
  throw InputError(
      path + ": would have " + std::to_string(size >> 20) +
      " MB, and a .glb file counts its bytes in 32 bits: 4095 MB at most; lower faceSize of the probes, or "
      "name some of them by --probe");
}

std::string glbText(const GlbDocument& document, const std::string& path) {
  Json json = document.json;
  if (document.binary.empty()) {
    json.erase("buffers");
  } else {
    json["buffers"][0]["byteLength"] = document.binary.size();
  }
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  pad(text, ' ');
  requireGlbSize(document, text.size(), path);
  std::string file = "glTF";
  file.reserve(kHeaders + text.size() + document.binary.size());
  append32(file, 2);
  append32(file, 12 + 8 + text.size() + (document.binary.empty() ? 0 : 8 + document.binary.size()));
  append32(file, text.size());
  file += "JSON" + text;
  if (document.binary.empty()) return file;
  append32(file, document.binary.size());
  file += std::string("BIN\0", 4) + document.binary;
  return file;
}

std::optional<std::string> glbJsonText(const std::string& path) {
  const std::uintmax_t size = requireInputFile(path);
  std::ifstream in(path, std::ios::binary);
  std::string head(20, '\0');
  in.read(head.data(), 20);
  if (in.gcount() < 20 || head.compare(0, 4, "glTF") != 0) return std::nullopt;
  const auto word = [&head](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(head[at + i]);
    return value;
  };
  if (word(12) > size - 20) throw InputError(path + ": is cut off: its JSON chunk runs past the end; export it again");
  std::string text(word(12), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (static_cast<std::size_t>(in.gcount()) != text.size()) throw InputError(path + ": cannot be read");
  return text;
}

}  // namespace boxprobe
