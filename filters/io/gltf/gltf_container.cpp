// Opening a glTF or GLB file: the outer format, files beside it, versions and extensions.
#include <algorithm>
#include <cstring>
#include <filesystem>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/read_file.h"
#include "filters/io/gltf/gltf_parts.h"
#include "filters/io/json/json_text.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string>& supportedExtensions() {
  static const std::vector<std::string> names = {"KHR_materials_unlit",        "KHR_materials_emissive_strength",
                                                 "KHR_materials_clearcoat",    "KHR_materials_ior",
                                                 "KHR_materials_transmission", "KHR_materials_volume",
                                                 "KHR_texture_transform",      "KHR_lights_punctual",
                                                 "KHR_mesh_quantization"};
  return names;
}

/// What tinygltf's callbacks work on. Exceptions must not pass through it: the first problem is kept here instead.
struct Reading {
  std::string modelPath;
  fs::path folder;
  std::string problem;
  std::map<int, std::string> images;
};

bool insideFolder(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(file, error);
  if (error) return false;
  const fs::path base = fs::weakly_canonical(folder, error);
  if (error) return false;
  return std::mismatch(base.begin(), base.end(), whole.begin(), whole.end()).first == base.end();
}

bool readFileBeside(std::vector<unsigned char>* out, std::string*, const std::string& name, void* user) {
  Reading& reading = *static_cast<Reading*>(user);
  try {
    if (!insideFolder(name, reading.folder)) {
      throw InputError(name + ": lies outside the model's folder; put it inside");
    }
    const std::string bytes = readWholeFile(name);
    out->assign(bytes.begin(), bytes.end());
    return true;
  } catch (const std::exception& error) {
    if (reading.problem.empty()) reading.problem = oneLine(reading.modelPath + ": " + error.what());
    return false;
  }
}

/// Keeps the bytes of images from files and data URIs; decoding waits until a material asks. Buffer views are skipped:
/// tinygltf passes them on without checking their bounds.
bool keepImage(tinygltf::Image* image, const int index, std::string*, std::string*, int, int,
               const unsigned char* bytes, int size, void* user) {
  if (image->bufferView < 0 && size > 0) {
    static_cast<Reading*>(user)->images[index].assign(reinterpret_cast<const char*>(bytes),
                                                      static_cast<std::size_t>(size));
  }
  return true;
}

std::uint32_t littleEndian32(const std::string& bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
    value = (value << 8) | static_cast<unsigned char>(bytes[offset + static_cast<std::size_t>(i)]);
  return value;
}

/// The JSON chunk. All chunk lengths are checked here: tinygltf may read some bytes past a truncated binary chunk.
std::string jsonChunk(const std::string& bytes, const std::string& path) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
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
  std::string json;
  std::size_t index = 0;
  for (std::size_t offset = kHeader; offset + kChunkHeader <= length; ++index) {
    const std::size_t size = littleEndian32(bytes, offset);
    if (size > length - offset - kChunkHeader) {
      throw damaged("chunk " + std::to_string(index) + " of " + std::to_string(size) + " bytes runs past the end");
    }
    if (index == 0) json = bytes.substr(offset + kChunkHeader, size);
    offset += kChunkHeader + size;
  }
  return json;
}

/// tinygltf's message as the middle of a sentence.
std::string reasonOf(const std::string& error) {
  std::string text = oneLine(error);
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text.empty() ? "is not a glTF file" : text;
}

void checkVersionAndExtensions(GltfFile& file) {
  if (file.gltf.asset.version.rfind("2.", 0) != 0) {
    file.fail("asset", "is glTF version \"" + file.gltf.asset.version + "\"; export it as glTF 2.0");
  }
  const std::vector<std::string>& known = supportedExtensions();
  const auto supported = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  for (const std::string& name : file.gltf.extensionsRequired) {
    if (!supported(name)) {
      file.fail("extensionsRequired", "needs " + name + ", which is not supported; export without it");
    }
  }
  for (const std::string& name : file.gltf.extensionsUsed) {
    if (!supported(name)) file.warn("uses the extension " + oneLine(name) + ", which is not supported and is ignored");
  }
}

}  // namespace

void GltfFile::fail(const std::string& where, const std::string& reason) const {
  throw InputError(oneLine(path + ": " + where + ": " + reason));
}

void GltfFile::warn(const std::string& warning) {
  if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(warning);
}

GltfFile openGltf(const std::string& path) {
  constexpr std::uintmax_t kLargestFile = 0xfffffff0u;  // tinygltf counts bytes in 32 bits
  const std::string bytes = readWholeFile(path, kLargestFile);
  const bool binary = bytes.compare(0, 4, "glTF") == 0;
  if (binary) {
    checkJsonSyntax(jsonChunk(bytes, path), path + ": JSON chunk");
  } else {
    checkJsonSyntax(bytes, path);
  }

  GltfFile file;
  file.path = path;
  Reading reading;
  reading.modelPath = path;
  reading.folder = fs::path(path).parent_path().empty() ? fs::path(".") : fs::path(path).parent_path();

  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(&keepImage, &reading);
  tinygltf::FsCallbacks callbacks = {};
  // Every name counts as found in the model's folder, so that tinygltf does not look for it in the working directory.
  callbacks.FileExists = [](const std::string&, void*) { return true; };
  callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
  callbacks.ReadWholeFile = &readFileBeside;
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };
  callbacks.user_data = &reading;
  loader.SetFsCallbacks(callbacks);

  std::string error, ignoredWarnings;  // its warnings are about images, whose problems are kept above
  bool read = false;
  try {
    const auto size = static_cast<unsigned int>(bytes.size());
    if (binary) {
      read = loader.LoadBinaryFromMemory(&file.gltf, &error, &ignoredWarnings,
                                         reinterpret_cast<const unsigned char*>(bytes.data()), size,
                                         reading.folder.string());
    } else {
      read =
          loader.LoadASCIIFromString(&file.gltf, &error, &ignoredWarnings, bytes.data(), size, reading.folder.string());
    }
  } catch (const std::exception& problem) {
    error = problem.what();
  }
  if (!reading.problem.empty()) throw InputError(reading.problem);
  if (!read) throw InputError(path + ": " + reasonOf(error) + "; export it again");
  file.encodedImages = std::move(reading.images);
  checkVersionAndExtensions(file);
  return file;
}

}  // namespace boxprobe
