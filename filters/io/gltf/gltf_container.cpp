// Opens a glTF or GLB file: the container, and buffers in separate files.
#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <set>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/inside_folder.h"
#include "filters/io/files/read_file.h"
#include "filters/io/gltf/gltf_chunks.h"
#include "filters/io/gltf/gltf_parts.h"
#include "filters/io/json/json_text.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

std::uint32_t littleEndian32(const std::string& bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
    value = (value << 8) | static_cast<unsigned char>(bytes[offset + static_cast<std::size_t>(i)]);
  return value;
}

}  // namespace

Chunks chunksOf(const std::string& bytes, const std::string& path) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  constexpr std::uint32_t kBinary = 0x004e4942;
  const auto damaged = [&path](const std::string& what) {
    return InputError(path + ": " + what + "; export it again");
  };
  if (bytes.size() < kHeader + kChunkHeader) throw damaged("is cut off: a GLB file has a header of 20 bytes");
  const std::uint32_t version = littleEndian32(bytes, 4);
  if (version != 2) throw damaged("is GLB version " + std::to_string(version) + ", not 2");
  const std::size_t length = littleEndian32(bytes, 8);
  if (length > bytes.size()) {
    throw damaged("is cut off: the header says " + std::to_string(length) + " bytes, the file has " +
                  std::to_string(bytes.size()));
  }
  Chunks chunks;
  std::size_t index = 0;
  for (std::size_t offset = kHeader; offset + kChunkHeader <= length; ++index) {
    const std::size_t size = littleEndian32(bytes, offset), from = offset + kChunkHeader;
    if (size > length - from) {
      throw damaged("chunk " + std::to_string(index) + " of " + std::to_string(size) + " bytes runs past the end");
    }
    if (index == 0) chunks.json = bytes.substr(from, size);
    if (index == 1 && littleEndian32(bytes, offset + 4) == kBinary) {
      chunks.binary = {reinterpret_cast<const unsigned char*>(bytes.data()) + from, size};
    }
    offset = from + size;
  }
  return chunks;
}

namespace {

/// tinygltf's message, usable within a sentence.
std::string reasonOf(const std::string& error) {
  std::string text = oneLine(error);
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text.empty() ? "is not a glTF file" : text;
}

std::string percentDecoded(const std::string& uri) {
  const auto digit = [&](std::size_t at) {
    const char c = at < uri.size() ? uri[at] : '\0';
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
  };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool code = uri[i] == '%' && digit(i + 1) >= 0 && digit(i + 2) >= 0;
    const bool zero = code && digit(i + 1) == 0 && digit(i + 2) == 0;  // would end a file name: not decoded
    if (code && !zero) {
      text += static_cast<char>(16 * digit(i + 1) + digit(i + 2));
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

bool sameIgnoringCase(const std::string& text, std::size_t at, const std::string& lower) {
  if (at > text.size() || text.size() - at < lower.size()) return false;
  return std::equal(lower.begin(), lower.end(), text.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

/// Decodes the data behind the comma. tinygltf accepts few media types, so all are renamed to one of them.
std::string dataOf(const GltfFile& file, const std::string& uri) {
  const std::size_t comma = uri.find(',');
  const std::string kind = uri.substr(0, std::min(comma, std::size_t(100)));
  std::vector<unsigned char> bytes;
  std::string ignoredType;
  const bool base64 = kind.size() >= 7 && sameIgnoringCase(kind, kind.size() - 7, ";base64");
  if (comma == std::string::npos || !base64 ||
      (comma + 1 < uri.size() &&
       !tinygltf::DecodeDataURI(&bytes, ignoredType, "data:application/octet-stream;base64," + uri.substr(comma + 1), 0,
                                false))) {
    throw InputError(oneLine(file.path + ": the data URI \"" + kind.substr(0, 40) +
                             "...\" cannot be decoded; only base64 is; export it again"));
  }
  return {bytes.begin(), bytes.end()};
}

/// One name of the file that a URI names, however it is spelt.
std::string onePath(const GltfFile& file, const std::string& uri) {
  std::string name = percentDecoded(uri);
  std::replace(name.begin(), name.end(), '\\', '/');
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(fs::path(file.path).parent_path() / name, ignored), ignored).string();
}

void readBuffers(GltfFile& file, const GltfText& text, const Chunks* chunks) {
  std::set<std::string> known;
  for (std::size_t i = 0; i < text.buffers.size(); ++i) {
    const GltfText::Buffer& source = text.buffers[i];
    std::vector<unsigned char>& data = file.gltf.buffers.at(i).data;
    data.clear();
    if (source.unused) continue;
    std::unique_ptr<std::string> read;
    const ByteRange* chunk = chunks != nullptr ? &chunks->binary : nullptr;
    const ByteRange range = bufferBytes(file, i, source.uri, chunk, source.byteLength, read);
    // The bytes of a data URI are the file's own already.
    if (read && !isDataUri(source.uri)) {
      if (known.insert(onePath(file, source.uri)).second) {
        file.budget.allow(read->size());
      } else {
        file.count(read->size(), "buffer " + std::to_string(i));
      }
    }
    if (range.size > 0) data.assign(range.data, range.data + range.size);
  }
}

}  // namespace

void GltfFile::fail(const std::string& where, const std::string& reason) const {
  throw InputError(oneLine(path + ": " + where + ": " + reason));
}

void GltfFile::warn(const std::string& warning) {
  if (warned.insert(warning).second) warnings.push_back(warning);
}

void GltfFile::count(std::uint64_t bytes, const std::string& where) const {
  budget.count(bytes, path + ": " + where);
}

bool isDataUri(const std::string& uri) {
  return sameIgnoringCase(uri, 0, "data:");
}

std::unique_ptr<std::string> readUri(const GltfFile& file, const std::string& uri) {
  if (isDataUri(uri)) return std::make_unique<std::string>(dataOf(file, uri));
  const fs::path folder = fs::path(file.path).parent_path().empty() ? fs::path(".") : fs::path(file.path).parent_path();
  std::string name = percentDecoded(uri);
  if (name.find('\0') != std::string::npos) return nullptr;  // not a valid file name
  std::error_code ignored;
  // Windows path separators.
  if (!fs::exists(folder / name, ignored)) std::replace(name.begin(), name.end(), '\\', '/');
  const fs::path whole = folder / name;
  if (!insideFolderOf(whole.string(), file.path)) {
    throw InputError(oneLine(file.path + ": " + whole.string() + ": lies outside the model's folder; put it inside"));
  }
  if (!fs::exists(whole, ignored)) {
    noteAsked(whole.string());
    return nullptr;
  }
  try {
    return std::make_unique<std::string>(readWholeFile(whole.string()));
  } catch (const InputError& error) {
    throw InputError(oneLine(file.path + ": " + error.what()));
  }
}

ByteRange bufferBytes(const GltfFile& file, std::size_t index, const std::string& uri, const ByteRange* chunk,
                      std::uint64_t length, std::unique_ptr<std::string>& read) {
  const std::string place = "buffer " + std::to_string(index);
  ByteRange range;
  if (!uri.empty()) {
    read = readUri(file, uri);
    if (!read) {
      throw InputError(oneLine(file.path + ": " + (fs::path(file.path).parent_path() / percentDecoded(uri)).string() +
                               ": does not exist; check the path"));
    }
    range = {reinterpret_cast<const unsigned char*>(read->data()), read->size()};
  } else if (chunk != nullptr && index == 0) {
    range = *chunk;
  } else if (chunk != nullptr) {
    file.fail(place, "has no uri, and only buffer 0 may be the binary chunk; export it again");
  } else {
    file.fail(place, "has no uri; export it again");
  }
  if (length > range.size) {
    file.fail(place, "has " + std::to_string(range.size) + " bytes, but byteLength is " + std::to_string(length) +
                         "; the file is cut off");
  }
  return {range.data, static_cast<std::size_t>(length)};
}

GltfSource readGltfSource(const std::string& path) {
  GltfSource source;
  source.bytes = readWholeFile(path, limits::kGltfBytes);
  source.binary = source.bytes.compare(0, 4, "glTF") == 0;
  if (source.binary) source.chunks = chunksOf(source.bytes, path);
  checkJsonSyntax(source.json(), source.binary ? path + ": JSON chunk" : path);
  return source;
}

GltfFile openGltf(const std::string& path) {
  const GltfSource source = readGltfSource(path);

  GltfFile file;
  file.path = path;
  file.budget.allow(source.bytes.size());
  const GltfText text = prepareGltf(file, source.json());
  tinygltf::TinyGLTF loader;
  std::string error, ignoredWarnings;  // its warnings concern images, which are hidden from it
  bool read = false;
  try {
    read = loader.LoadASCIIFromString(&file.gltf, &error, &ignoredWarnings, text.json.data(),
                                      static_cast<unsigned int>(text.json.size()), "");
  } catch (const std::exception& problem) {
    error = problem.what();
  }
  if (!read) throw InputError(path + ": " + reasonOf(error) + "; export it again");
  if (file.gltf.buffers.size() != text.buffers.size()) file.fail("buffers", "cannot be read; export it again");
  readBuffers(file, text, source.binary ? &source.chunks : nullptr);
  unpackMeshopt(file);
  return file;
}

}  // namespace boxprobe
