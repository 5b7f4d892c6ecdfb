// KHR_materials_variants: the same model in other materials.
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

const tinygltf::Value* arrayIn(const tinygltf::ExtensionMap& extensions, const char* key) {
  const auto found = extensions.find("KHR_materials_variants");
  if (found == extensions.end() || !found->second.IsObject() || !found->second.Has(key)) return nullptr;
  const tinygltf::Value& list = found->second.Get(key);
  return list.IsArray() ? &list : nullptr;
}

}  // namespace

std::vector<std::string> variantNames(const GltfFile& file) {
  std::vector<std::string> names;
  const tinygltf::Value* list = arrayIn(file.gltf.extensions, "variants");
  for (std::size_t i = 0; list != nullptr && i < list->ArrayLen(); ++i) {
    const tinygltf::Value& entry = list->Get(static_cast<int>(i));
    const bool named = entry.IsObject() && entry.Has("name") && entry.Get("name").IsString();
    names.push_back(named ? entry.Get("name").Get<std::string>() : "variant" + std::to_string(i));
  }
  return names;
}

int variantMaterial(const tinygltf::Primitive& primitive, int variant) {
  const tinygltf::Value* mappings = arrayIn(primitive.extensions, "mappings");
  for (std::size_t i = 0; mappings != nullptr && i < mappings->ArrayLen(); ++i) {
    const tinygltf::Value& mapping = mappings->Get(static_cast<int>(i));
    if (!mapping.IsObject()) continue;
    const tinygltf::Value& variants = mapping.Get("variants");
    for (std::size_t v = 0; v < variants.ArrayLen(); ++v) {
      const tinygltf::Value& index = variants.Get(static_cast<int>(v));
      if (index.IsNumber() && index.GetNumberAsDouble() == variant) return extensionWhole(mapping, "material", -1);
    }
  }
  return primitive.material;
}

}  // namespace boxprobe
