// Materials, textures and samplers of a glTF file. What images they use is collected first, so that gltf_image.cpp can
// decode them together.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <set>

#include "filters/core/base/one_line.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

constexpr double kDefaultIor = 1.5;

class MaterialReader {
 public:
  explicit MaterialReader(GltfFile& file) : file_(file) {}

  Material read(const tinygltf::Material& source, std::size_t index) {
    Material material;
    place_ = "material " + std::to_string(index) + (source.name.empty() ? "" : " \"" + source.name + "\"");
    material.name = source.name.empty() ? "material" + std::to_string(index) : source.name;
    const auto& pbr = source.pbrMetallicRoughness;
    material.baseColor = factor<glm::vec4>(pbr.baseColorFactor, glm::vec4(1.0f));
    material.metallic = unit(pbr.metallicFactor);
    material.roughness = unit(pbr.roughnessFactor);
    material.emissive = factor<glm::vec3>(source.emissiveFactor, glm::vec3(0.0f));
    material.normalScale = bounded(source.normalTexture.scale);
    material.occlusionStrength = unit(source.occlusionTexture.strength);
    material.doubleSided = source.doubleSided;
    material.baseColorTexture = texture(pbr.baseColorTexture, "baseColorTexture");
    material.metallicRoughnessTexture = texture(pbr.metallicRoughnessTexture, "metallicRoughnessTexture");
    material.normalTexture = texture(source.normalTexture, "normalTexture");
    material.occlusionTexture = texture(source.occlusionTexture, "occlusionTexture");
    material.emissiveTexture = texture(source.emissiveTexture, "emissiveTexture");
    if (source.alphaMode == "MASK") {
      material.alphaMode = AlphaMode::Mask;
    } else if (source.alphaMode == "BLEND") {
      material.alphaMode = AlphaMode::Blend;
    } else if (!source.alphaMode.empty() && source.alphaMode != "OPAQUE") {
      file_.warn("has materials with alphaMode " + oneLine(source.alphaMode) +
                 ", which glTF does not define; drawn opaque");
    }
    material.alphaCutoff = bounded(std::max(source.alphaCutoff, 0.0));
    readExtensions(source, material);
    return material;
  }

 private:
  /// Beyond 1e18 products with light would leave single precision.
  float bounded(double value) {
    if (std::fabs(value) > kLargestGltfNumber) file_.warn("has material numbers above 1e18, which were clamped to it");
    return static_cast<float>(std::clamp(value, -kLargestGltfNumber, kLargestGltfNumber));
  }
  static float unit(double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); }

  template <typename Vector>
  Vector factor(const std::vector<double>& values, const Vector& standard) {
    if (values.size() != static_cast<std::size_t>(Vector::length())) return standard;
    Vector result;
    for (int i = 0; i < Vector::length(); ++i) {
      result[i] = bounded(std::max(values[static_cast<std::size_t>(i)], 0.0));
    }
    return result;
  }

  void readExtensions(const tinygltf::Material& source, Material& material) {
    for (const auto& [name, extension] : source.extensions) {
      if (name == "KHR_materials_unlit") {
        material.unlit = true;
      } else if (name == "KHR_materials_emissive_strength") {
        const float strength = bounded(std::max(extensionNumber(extension, "emissiveStrength", 1.0), 0.0));
        for (int i = 0; i < 3; ++i)
          material.emissive[i] = bounded(static_cast<double>(material.emissive[i]) * strength);
      } else if (name == "KHR_materials_ior") {
        material.ior = bounded(std::max(extensionNumber(extension, "ior", kDefaultIor), 1.0));
      } else if (name == "KHR_materials_clearcoat") {
        material.coat = unit(extensionNumber(extension, "clearcoatFactor", 0.0));
        material.coatRoughness = unit(extensionNumber(extension, "clearcoatRoughnessFactor", 0.0));
        material.coatTexture = extensionTexture(extension, "clearcoatTexture");
        material.coatRoughnessTexture = extensionTexture(extension, "clearcoatRoughnessTexture");
        material.coatNormalTexture = extensionTexture(extension, "clearcoatNormalTexture");
        if (material.coatNormalTexture.image) {
          material.coatNormalScale = bounded(extensionNumber(extension.Get("clearcoatNormalTexture"), "scale", 1.0));
        }
      } else if (name == "KHR_materials_transmission") {
        material.transmission = unit(extensionNumber(extension, "transmissionFactor", 0.0));
        material.transmissionTexture = extensionTexture(extension, "transmissionTexture");
        if (material.transmissionTexture.image) {
          file_.warn("has materials with a transmission texture, which is not supported; only the factor is used");
        }
      } else if (name == "KHR_materials_volume") {
        material.thickness = bounded(std::max(extensionNumber(extension, "thicknessFactor", 0.0), 0.0));
        material.thin = material.thickness == 0.0f;
        // Its default is infinite.
        material.attenuationDistance = bounded(std::max(extensionNumber(extension, "attenuationDistance", 0.0), 0.0));
        material.attenuationColor = attenuationColor(extension);
      }
    }
  }

  static glm::vec3 attenuationColor(const tinygltf::Value& extension) {
    glm::vec3 color(1.0f);
    if (!extension.IsObject() || !extension.Has("attenuationColor")) return color;
    const tinygltf::Value& values = extension.Get("attenuationColor");
    for (int i = 0; i < 3; ++i) {
      if (values.IsArray() && values.ArrayLen() == 3 && values.Get(i).IsNumber()) {
        color[i] = unit(values.Get(i).GetNumberAsDouble());
      }
    }
    return color;
  }

  static Wrap wrapMode(int mode) {
    if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::ClampToEdge;
    if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::MirroredRepeat;
    return Wrap::Repeat;
  }

  template <typename TextureInfo>
  TextureUse texture(const TextureInfo& info, const char* slot) {
    const auto transform = info.extensions.find("KHR_texture_transform");
    return texture(info.index, info.texCoord, transform == info.extensions.end() ? nullptr : &transform->second, slot);
  }

  /// A texture that tinygltf knows nothing of.
  TextureUse extensionTexture(const tinygltf::Value& extension, const char* slot) {
    if (!extension.IsObject() || !extension.Has(slot)) return {};
    const tinygltf::Value& info = extension.Get(slot);
    const tinygltf::Value* transform = nullptr;
    if (info.IsObject() && info.Has("extensions") && info.Get("extensions").IsObject() &&
        info.Get("extensions").Has("KHR_texture_transform")) {
      transform = &info.Get("extensions").Get("KHR_texture_transform");
    }
    return texture(wholeNumber(info, "index", -1), wholeNumber(info, "texCoord", 0), transform, slot);
  }

  static int wholeNumber(const tinygltf::Value& object, const char* key, int standard) {
    const double value = extensionNumber(object, key, standard);
    return value >= -1.0 && value <= 1.0e9 ? static_cast<int>(value) : standard;
  }

  glm::vec2 transformPair(const tinygltf::Value& transform, const char* key, float standard) {
    glm::vec2 pair(standard);
    if (!transform.IsObject() || !transform.Has(key)) return pair;
    const tinygltf::Value& list = transform.Get(key);
    for (std::size_t i = 0; i < 2 && list.IsArray() && i < list.ArrayLen(); ++i) {
      if (list.Get(static_cast<int>(i)).IsNumber()) {
        pair[static_cast<int>(i)] = bounded(list.Get(static_cast<int>(i)).GetNumberAsDouble());
      }
    }
    return pair;
  }

  /// KHR_texture_transform: translation * rotation * scale of (u, v, 1), v downwards.
  void readTransform(const tinygltf::Value& transform, TextureUse& use) {
    const glm::vec2 offset = transformPair(transform, "offset", 0.0f), scale = transformPair(transform, "scale", 1.0f);
    const double turn = extensionNumber(transform, "rotation", 0.0);
    const auto c = static_cast<float>(std::cos(turn)), s = static_cast<float>(std::sin(turn));
    use.uvTransform = glm::mat3x2(c * scale.x, -s * scale.x, s * scale.y, c * scale.y, offset.x, offset.y);
    use.uvSet = wholeNumber(transform, "texCoord", use.uvSet);
  }

  TextureUse texture(int textureIndex, int texCoord, const tinygltf::Value* transform, const char* slot) {
    TextureUse use;
    if (textureIndex < 0) return use;
    const std::string where = place_ + ": " + slot;
    const auto& textures = file_.gltf.textures;
    if (static_cast<std::size_t>(textureIndex) >= textures.size()) {
      file_.fail(where, "texture " + std::to_string(textureIndex) + " does not exist; the file has " +
                            std::to_string(textures.size()));
    }
    use.uvSet = texCoord;
    if (transform != nullptr) readTransform(*transform, use);
    if (use.uvSet < 0 || use.uvSet > 1) {
      file_.warn("has textures on a third set of texture coordinates; the second is used");
      use.uvSet = 1;
    }
    const tinygltf::Texture& source = textures[static_cast<std::size_t>(textureIndex)];
    if (source.sampler >= 0) {
      if (static_cast<std::size_t>(source.sampler) >= file_.gltf.samplers.size()) {
        file_.fail(where, "sampler " + std::to_string(source.sampler) + " does not exist; the file has " +
                              std::to_string(file_.gltf.samplers.size()));
      }
      const tinygltf::Sampler& sampler = file_.gltf.samplers[static_cast<std::size_t>(source.sampler)];
      use.wrapS = wrapMode(sampler.wrapS);
      use.wrapT = wrapMode(sampler.wrapT);
      use.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    }
    if (source.source < 0) {
      file_.warn("has textures without a PNG or JPEG image, which are ignored");
      return use;
    }
    if (static_cast<std::size_t>(source.source) >= file_.gltf.images.size()) {
      file_.fail(where, "image " + std::to_string(source.source) + " does not exist; the file has " +
                            std::to_string(file_.gltf.images.size()));
    }
    // Stands for the image until all are decoded.
    auto wanted = std::make_shared<ImageRgba8>();
    wanted->width = -1 - source.source;
    use.image = wanted;
    return use;
  }

  GltfFile& file_;
  std::string place_;
};

}  // namespace

double extensionNumber(const tinygltf::Value& extension, const char* key, double standard) {
  if (!extension.IsObject() || !extension.Has(key) || !extension.Get(key).IsNumber()) return standard;
  return extension.Get(key).GetNumberAsDouble();
}

std::vector<Material> readMaterials(GltfFile& file, const std::function<void(double)>& progress) {
  MaterialReader reader(file);
  std::vector<Material> materials;
  for (std::size_t i = 0; i < file.gltf.materials.size(); ++i) {
    materials.push_back(reader.read(file.gltf.materials[i], i));
  }
  std::set<int> used;
  const auto wanted = [](const TextureUse& use) { return -1 - use.image->width; };
  for (Material& material : materials) {
    for (const TextureUse* use : material.textures()) {
      if (use->image) used.insert(wanted(*use));
    }
  }
  const auto images = decodeImages(file, used, progress);
  for (Material& material : materials) {
    for (TextureUse* use : material.textures()) {
      if (use->image) use->image = images.at(wanted(*use));
    }
  }
  return materials;
}

}  // namespace boxprobe
