// Values of a glTF file that are of another type than the format defines. tinygltf passes over most of them without a
// word, and what was meant is missing in the picture. Fields after the glTF 2.0 specification, "Properties Reference",
// and those of the extensions that are read.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "filters/core/base/one_line.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

using GltfJson = nlohmann::json;

struct Type {
  const char* name;
  bool (*has)(const GltfJson&);  ///< of each element, if it is a list
  bool list = false;
  std::size_t count = 0;  ///< of the list; 0: any
};

bool isNumber(const GltfJson& value) {
  return value.is_number();
}
bool isWhole(const GltfJson& value) {
  return value.is_number_unsigned();
}
bool isText(const GltfJson& value) {
  return value.is_string();
}
bool isObject(const GltfJson& value) {
  return value.is_object();
}

constexpr Type kNumber{"a number", isNumber}, kWhole{"a whole number, 0 or more", isWhole};
constexpr Type kNumbers{"numbers", isNumber, true}, kWholes{"whole numbers, 0 or more", isWhole, true};
constexpr Type kText{"a text", isText}, kObject{"an object", isObject};
constexpr Type kTexts{"texts", isText, true}, kObjects{"objects", isObject, true};
constexpr Type kFlag{"true or false", [](const GltfJson& value) { return value.is_boolean(); }};

constexpr Type numbers(std::size_t count) {
  return {"numbers", isNumber, true, count};
}

struct Field {
  std::string_view within;  ///< member that holds the object, or the list with it; "": the root
  std::string_view key;
  Type type;
};

constexpr Field kFields[] = {
    {"", "scene", kWhole},
    {"", "scenes", kObjects},
    {"", "nodes", kObjects},
    {"", "meshes", kObjects},
    {"", "materials", kObjects},
    {"", "textures", kObjects},
    {"", "samplers", kObjects},
    {"", "images", kObjects},
    {"", "cameras", kObjects},
    {"", "skins", kObjects},
    {"", "animations", kObjects},
    {"", "accessors", kObjects},
    {"", "bufferViews", kObjects},
    {"", "buffers", kObjects},
    {"", "extensionsUsed", kTexts},
    {"", "extensionsRequired", kTexts},
    {"scenes", "nodes", kWholes},
    {"nodes", "name", kText},
    {"nodes", "mesh", kWhole},
    {"nodes", "skin", kWhole},
    {"nodes", "camera", kWhole},
    {"nodes", "children", kWholes},
    {"nodes", "translation", numbers(3)},
    {"nodes", "rotation", numbers(4)},
    {"nodes", "scale", numbers(3)},
    {"nodes", "matrix", numbers(16)},
    {"nodes", "weights", kNumbers},
    {"meshes", "name", kText},
    {"meshes", "primitives", kObjects},
    {"meshes", "weights", kNumbers},
    {"primitives", "attributes", kObject},
    {"primitives", "indices", kWhole},
    {"primitives", "material", kWhole},
    {"primitives", "mode", kWhole},
    {"primitives", "targets", kObjects},
    {"materials", "name", kText},
    {"materials", "pbrMetallicRoughness", kObject},
    {"materials", "emissiveFactor", numbers(3)},
    {"materials", "alphaMode", kText},
    {"materials", "alphaCutoff", kNumber},
    {"materials", "doubleSided", kFlag},
    {"pbrMetallicRoughness", "baseColorFactor", numbers(4)},
    {"pbrMetallicRoughness", "metallicFactor", kNumber},
    {"pbrMetallicRoughness", "roughnessFactor", kNumber},
    {"normalTexture", "scale", kNumber},
    {"occlusionTexture", "strength", kNumber},
    {"textures", "source", kWhole},
    {"textures", "sampler", kWhole},
    {"samplers", "magFilter", kWhole},
    {"samplers", "minFilter", kWhole},
    {"samplers", "wrapS", kWhole},
    {"samplers", "wrapT", kWhole},
    {"samplers", "input", kWhole},  // of animations
    {"samplers", "output", kWhole},
    {"samplers", "interpolation", kText},
    {"images", "uri", kText},
    {"images", "bufferView", kWhole},
    {"cameras", "name", kText},
    {"cameras", "type", kText},
    {"cameras", "perspective", kObject},
    {"cameras", "orthographic", kObject},
    {"perspective", "yfov", kNumber},
    {"orthographic", "ymag", kNumber},
    {"skins", "joints", kWholes},
    {"skins", "inverseBindMatrices", kWhole},
    {"animations", "channels", kObjects},
    {"animations", "samplers", kObjects},
    {"channels", "sampler", kWhole},
    {"channels", "target", kObject},
    {"target", "node", kWhole},
    {"target", "path", kText},
    {"accessors", "bufferView", kWhole},
    {"accessors", "byteOffset", kWhole},
    {"accessors", "componentType", kWhole},
    {"accessors", "count", kWhole},
    {"accessors", "normalized", kFlag},
    {"accessors", "type", kText},
    {"accessors", "sparse", kObject},
    {"bufferViews", "buffer", kWhole},
    {"bufferViews", "byteLength", kWhole},
    {"bufferViews", "byteOffset", kWhole},
    {"bufferViews", "byteStride", kWhole},
    {"EXT_mesh_gpu_instancing", "attributes", kObject},
    {"EXT_texture_webp", "source", kWhole},
    {"KHR_lights_punctual", "lights", kObjects},
    {"KHR_lights_punctual", "light", kWhole},
    {"lights", "name", kText},
    {"lights", "type", kText},
    {"lights", "color", numbers(3)},
    {"lights", "intensity", kNumber},
    {"lights", "range", kNumber},
    {"lights", "spot", kObject},
    {"spot", "innerConeAngle", kNumber},
    {"spot", "outerConeAngle", kNumber},
    {"KHR_materials_anisotropy", "anisotropyStrength", kNumber},
    {"KHR_materials_anisotropy", "anisotropyRotation", kNumber},
    {"KHR_materials_clearcoat", "clearcoatFactor", kNumber},
    {"KHR_materials_clearcoat", "clearcoatRoughnessFactor", kNumber},
    {"clearcoatNormalTexture", "scale", kNumber},
    {"KHR_materials_emissive_strength", "emissiveStrength", kNumber},
    {"KHR_materials_ior", "ior", kNumber},
    {"KHR_materials_iridescence", "iridescenceFactor", kNumber},
    {"KHR_materials_iridescence", "iridescenceIor", kNumber},
    {"KHR_materials_iridescence", "iridescenceThicknessMinimum", kNumber},
    {"KHR_materials_iridescence", "iridescenceThicknessMaximum", kNumber},
    {"KHR_materials_pbrSpecularGlossiness", "diffuseFactor", numbers(4)},
    {"KHR_materials_pbrSpecularGlossiness", "specularFactor", numbers(3)},
    {"KHR_materials_pbrSpecularGlossiness", "glossinessFactor", kNumber},
    {"KHR_materials_sheen", "sheenColorFactor", numbers(3)},
    {"KHR_materials_sheen", "sheenRoughnessFactor", kNumber},
    {"KHR_materials_specular", "specularFactor", kNumber},
    {"KHR_materials_specular", "specularColorFactor", numbers(3)},
    {"KHR_materials_transmission", "transmissionFactor", kNumber},
    {"KHR_materials_variants", "variants", kObjects},
    {"KHR_materials_variants", "mappings", kObjects},
    {"variants", "name", kText},
    {"mappings", "material", kWhole},
    {"mappings", "variants", kWholes},
    {"KHR_materials_volume", "thicknessFactor", kNumber},
    {"KHR_materials_volume", "attenuationDistance", kNumber},
    {"KHR_materials_volume", "attenuationColor", numbers(3)},
    {"KHR_texture_transform", "offset", numbers(2)},
    {"KHR_texture_transform", "rotation", kNumber},
    {"KHR_texture_transform", "scale", numbers(2)},
    {"KHR_texture_transform", "texCoord", kWhole},
};

/// Of materials whatever ends with "Texture", and what it holds; and of every extension that is known.
constexpr Field kTexture{"", "", kObject}, kTextureNumber{"", "", kWhole}, kExtension{"", "", kObject};

bool isTexture(std::string_view key) {
  constexpr std::string_view kEnd = "Texture";
  return key.size() > kEnd.size() && key.substr(key.size() - kEnd.size()) == kEnd;
}

bool hasType(const GltfJson& value, const Type& type) {
  if (!type.list) return type.has(value);
  return value.is_array() && (type.count == 0 || value.size() == type.count) &&
         std::all_of(value.begin(), value.end(), type.has);
}

std::string typeText(const Type& type) {
  if (!type.list) return type.name;
  return "a list of " + (type.count > 0 ? std::to_string(type.count) + " " : std::string()) + type.name;
}

std::string valueText(const GltfJson& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  if (value.is_string()) return "\"" + value.get<std::string>().substr(0, 40) + "\"";
  return value.dump();
}

/// Where a value stands: a member of what is above, or an element of its list.
struct Place {
  const Place* above;  ///< null for members of the root
  std::string_view key;
  std::size_t index = 0;
  bool listed = false;
};

std::string placeText(const Place& place) {
  const std::string above = place.above == nullptr ? "" : placeText(*place.above);
  if (place.listed) return above + "[" + std::to_string(place.index) + "]";
  return (above.empty() ? "" : above + ".") + std::string(place.key);
}

class TypeCheck {
 public:
  TypeCheck() {
    for (const Field& field : kFields) fields_[field.within].push_back(&field);
  }

  /// `within`: the member that holds `object`, or the list with it.
  void visit(const GltfJson& object, std::string_view within, const Place* above) {
    if (!object.is_object()) return;
    for (const auto& [key, value] : object.get_ref<const GltfJson::object_t&>()) {
      if (key == "extras") continue;
      const Place place{above, key};
      if (key == "extensions") {
        visitExtensions(value, &place);
        continue;
      }
      const Field* field = fieldOf(within, key);
      if (field != nullptr && !hasType(value, field->type)) note(*field, place, value);
      if (key == "attributes" || key == "targets") continue;  // names of any kind
      if (value.is_object()) visit(value, key, &place);
      if (!value.is_array()) continue;
      for (std::size_t i = 0; i < value.size(); ++i) {
        const Place element{&place, {}, i, true};
        visit(value[i], key, &element);
      }
    }
  }

  /// One line for each field, in the order in which they were found.
  void tell(GltfFile& file) const {
    for (const Wrong& wrong : found_) {
      const std::string more = wrong.count > 1 ? "; " + std::to_string(wrong.count - 1) + " more like it" : "";
      file.warn(oneLine(wrong.text + more));
    }
  }

 private:
  struct Wrong {
    const Field* field;
    std::string text;
    std::size_t count = 1;
  };

  const Field* fieldOf(std::string_view within, std::string_view key) const {
    if (isTexture(key)) return &kTexture;
    if (isTexture(within) && (key == "index" || key == "texCoord")) return &kTextureNumber;
    const auto known = fields_.find(within);
    if (known == fields_.end()) return nullptr;
    const auto found =
        std::find_if(known->second.begin(), known->second.end(), [&](const Field* each) { return each->key == key; });
    return found == known->second.end() ? nullptr : *found;
  }

  /// Of others than these nothing is known.
  void visitExtensions(const GltfJson& extensions, const Place* above) {
    if (!extensions.is_object()) return note(kExtension, *above, extensions);
    for (const auto& [name, extension] : extensions.get_ref<const GltfJson::object_t&>()) {
      if (fields_.count(name) == 0) continue;
      const Place place{above, name};
      if (!extension.is_object()) note(kExtension, place, extension);
      visit(extension, name, &place);
    }
  }

  void note(const Field& field, const Place& place, const GltfJson& value) {
    for (Wrong& wrong : found_) {
      if (wrong.field != &field) continue;
      ++wrong.count;
      return;
    }
    found_.push_back({&field, placeText(place) + ": must be " + typeText(field.type) + ", not " + valueText(value)});
  }

  std::map<std::string_view, std::vector<const Field*>> fields_;
  std::vector<Wrong> found_;
};

}  // namespace

void warnOfTypes(GltfFile& file, const nlohmann::json& root) {
  TypeCheck check;
  check.visit(root, "", nullptr);
  check.tell(file);
}

}  // namespace boxprobe
