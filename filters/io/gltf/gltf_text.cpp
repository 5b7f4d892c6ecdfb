// Prepares the JSON of a glTF file for tinygltf; see GltfText. Nothing has validated the file before, so every member
// is checked.
#include <nlohmann/json.hpp>
#include <set>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

using GltfJson = nlohmann::json;

/// One byte in place of a buffer that tinygltf must not read.
constexpr const char* kOneByte = "data:application/octet-stream;base64,AA==";

/// The member if `object` is an object and has it, else null.
GltfJson* member(GltfJson& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

/// The elements of a member that is an array.
std::vector<GltfJson*> elements(GltfJson& object, const char* key) {
  std::vector<GltfJson*> list;
  GltfJson* array = member(object, key);
  if (array == nullptr || !array->is_array()) return list;
  for (GltfJson& element : *array) list.push_back(&element);
  return list;
}

std::string textMember(GltfJson& object, const char* key) {
  const GltfJson* value = member(object, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

GltfJson* extension(GltfJson& object, const char* name) {
  GltfJson* all = member(object, "extensions");
  return all == nullptr ? nullptr : member(*all, name);
}

std::vector<std::string> names(GltfJson& root, const char* key) {
  std::vector<std::string> list;
  for (const GltfJson* name : elements(root, key)) {
    if (name->is_string()) list.push_back(name->get<std::string>());
  }
  return list;
}

/// Adds the names of all extensions that stand anywhere in `value`, whether extensionsUsed has them or not.
void addNamesWithin(const GltfJson& value, std::set<std::string>& found) {
  if (value.is_array()) {
    for (const GltfJson& element : value) addNamesWithin(element, found);
  }
  if (!value.is_object()) return;
  for (const auto& [key, within] : value.items()) {
    // Extras hold anything; textures of unknown formats are named where a material misses them.
    if (key == "extras" || key == "textures") continue;
    if (key == "extensions" && within.is_object()) {
      for (const auto& [name, ignored] : within.items()) found.insert(name);
    }
    addNamesWithin(within, found);
  }
}

void checkVersion(const GltfFile& file, GltfJson& root) {
  GltfJson* asset = member(root, "asset");
  const GltfJson* version = asset == nullptr ? nullptr : member(*asset, "version");
  if (version == nullptr || !version->is_string()) file.fail("asset", "has no version; is it a glTF file?");
  const std::string text = version->get<std::string>();
  if (text.rfind("2.", 0) != 0) file.fail("asset", "is glTF version \"" + text + "\"; export it as glTF 2.0");
}

void takeBuffers(const GltfFile& file, GltfJson& root, GltfText& text) {
  for (GltfJson* source : elements(root, "buffers")) {
    const std::string place = "buffer " + std::to_string(text.buffers.size());
    GltfText::Buffer buffer;
    buffer.uri = textMember(*source, "uri");
    const GltfJson* length = member(*source, "byteLength");
    if (length == nullptr || !length->is_number_unsigned()) {
      file.fail(place, "has no byteLength that is a whole number; export it again");
    }
    buffer.byteLength = length->get<std::size_t>();
    GltfJson* meshopt = extension(*source, "EXT_meshopt_compression");
    const GltfJson* fallback = meshopt == nullptr ? nullptr : member(*meshopt, "fallback");
    buffer.unused = fallback != nullptr && fallback->is_boolean() && fallback->get<bool>();
    text.buffers.push_back(buffer);
    *source = {{"byteLength", 1}, {"uri", kOneByte}};
  }
}

void takeImages(GltfFile& file, GltfJson& root) {
  for (GltfJson* source : elements(root, "images")) {
    GltfImage image;
    image.name = textMember(*source, "name");
    image.uri = textMember(*source, "uri");
    const GltfJson* view = member(*source, "bufferView");
    if (view != nullptr && view->is_number_unsigned() && view->get<std::size_t>() < 0x7fffffffu) {
      image.bufferView = view->get<int>();
    }
    file.images.push_back(std::move(image));
  }
  if (root.is_object()) root.erase("images");
}

/// tinygltf refuses indices without a buffer view, which compressed ones lack.
void takeDracoIndices(GltfFile& file, GltfJson& root) {
  const std::vector<GltfJson*> meshes = elements(root, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const std::vector<GltfJson*> primitives = elements(*meshes[m], "primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      if (extension(*primitives[p], "KHR_draco_mesh_compression") == nullptr) continue;
      const GltfJson* indices = member(*primitives[p], "indices");
      const bool whole =
          indices != nullptr && indices->is_number_unsigned() && indices->get<std::size_t>() < 0x7fffffffu;
      file.dracoIndices[{m, p}] = whole ? indices->get<int>() : -1;
      primitives[p]->erase("indices");
    }
  }
}

/// A scene's changes of materials are written for other readers into a .glb with probes
/// (filters/io/engines/glb_probes); here the scene changes them itself.
void restoreMaterials(const GltfFile& file, GltfJson& root) {
  GltfJson* probes = extension(root, "BOXPROBE_reflection_probes");
  GltfJson* before = probes == nullptr ? nullptr : member(*probes, "materials");
  if (before == nullptr || !before->is_object()) return;
  const std::vector<GltfJson*> materials = elements(root, "materials");
  for (auto& [number, material] : before->items()) {
    const bool digits =
        !number.empty() && number.size() < 9 && number.find_first_not_of("0123456789") == std::string::npos;
    const std::size_t index = digits ? std::stoul(number) : materials.size();
    if (index >= materials.size() || !material.is_object()) {
      file.fail("BOXPROBE_reflection_probes.materials." + number, "is no material of the file; export it again");
    }
    *materials[index] = material;
  }
}

}  // namespace

GltfText prepareGltf(GltfFile& file, const std::string& json) {
  GltfText text;
  try {
    GltfJson root = GltfJson::parse(json);
    checkVersion(file, root);
    std::vector<std::string> used = names(root, "extensionsUsed");
    std::set<std::string> found;
    addNamesWithin(root, found);
    used.insert(used.end(), found.begin(), found.end());
    checkExtensions(file, names(root, "extensionsRequired"), used);
    restoreMaterials(file, root);
    warnOfTypes(file, root);
    takeBuffers(file, root, text);
    takeImages(file, root);
    takeDracoIndices(file, root);
    text.json = root.dump(-1, ' ', false, GltfJson::error_handler_t::replace);
  } catch (const GltfJson::exception& problem) {
    throw InputError(oneLine(file.path + ": " + problem.what() + "; export it again"));
  }
  return text;
}

}  // namespace boxprobe
