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
#include "filters/io/json/json_excerpt.h"

namespace boxprobe {

namespace {

using GltfJson = nlohmann::json;

struct Type {
  const char* name;              ///< of each element, if it is a list
  bool (*has)(const GltfJson&);  ///< a value or an element
  const char* many = nullptr;    ///< elements; null: no list
  std::size_t count = 0;         ///< of the list; 0: any
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
constexpr Type kText{"text in quotes", isText}, kObject{"an object in braces", isObject};
constexpr Type kNumbers{kNumber.name, isNumber, "numbers"}, kWholes{kWhole.name, isWhole, "whole numbers"};
constexpr Type kTexts{kText.name, isText, "texts"}, kObjects{kObject.name, isObject, "objects"};
constexpr Type kFlag{"true or false", [](const GltfJson& value) { return value.is_boolean(); }};

constexpr Type numbers(std::size_t count) {
  return {kNumbers.name, kNumbers.has, kNumbers.many, count};
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

std::string listText(const Type& type) {
  return (type.count > 0 ? std::to_string(type.count) + " " : "a list of ") + type.many + " in brackets";
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
      if (field != nullptr) check(*field, place, value);
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
    check(kExtension, *above, extensions);
    if (!extensions.is_object()) return;
    for (const auto& [name, extension] : extensions.get_ref<const GltfJson::object_t&>()) {
      if (fields_.count(name) == 0) continue;
      const Place place{above, name};
      check(kExtension, place, extension);
      visit(extension, name, &place);
    }
  }

  void check(const Field& field, const Place& place, const GltfJson& value) {
    const Type& type = field.type;
    if (type.many == nullptr) {
      if (!type.has(value)) note(field, place, type.name, value);
      return;
    }
    if (!value.is_array() || (type.count > 0 && value.size() != type.count)) {
      note(field, place, listText(type), value);
      return;
    }
    const auto wrong = std::find_if_not(value.begin(), value.end(), type.has);
    if (wrong == value.end()) return;
    note(field, {&place, {}, static_cast<std::size_t>(wrong - value.begin()), true}, type.name, *wrong);
  }

  void note(const Field& field, const Place& place, const std::string& wanted, const GltfJson& value) {
    for (Wrong& wrong : found_) {
      if (wrong.field != &field) continue;
      ++wrong.count;
      return;
    }
    found_.push_back({&field, placeText(place) + ": must be " + wanted + ", not " + excerpt(value)});
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
