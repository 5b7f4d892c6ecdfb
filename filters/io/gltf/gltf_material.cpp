// Materials, textures and samplers of a glTF file. The images they use are collected first, so that gltf_image.cpp can
// decode them in parallel.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <set>

#include "filters/core/base/file_limits.h"
#include "filters/core/base/one_line.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

constexpr double kDefaultIor = 1.5;

/// Replaces a base colour texture whose file is missing: middle grey in sRGB, so that the surface is visible.
const std::shared_ptr<const ImageRgba8>& missingPicture() {
  static const auto picture =
      std::make_shared<const ImageRgba8>(ImageRgba8{1, 1, {128, 128, 128, 255}, "missing texture"});
  return picture;
}

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
    specularFactor_ = 1.0f;
    specularColor_ = glm::vec3(1.0f);
    fullFresnel_ = false;
    glossiness_.reset();
    readExtensions(source, material);
    applySpecular(material);
    leaveOutMissing(material);
    if (material.transmits()) warnOfGlass(material.finish);
    return material;
  }

  /// Grey suits a base colour only: other missing textures count as absent.
  static void leaveOutMissing(Material& material) {
    if (material.emissiveTexture.image == missingPicture()) material.emissive = glm::vec3(0.0f);
    for (TextureUse* use : material.textures()) {
      if (use != &material.baseColorTexture && use->image == missingPicture()) use->image = nullptr;
    }
  }

  /// Work left for the material read last, to be done when pictures are decoded.
  const std::optional<GltfSpecularGlossiness>& glossiness() const { return glossiness_; }

 private:
  void warnOfGlass(const MaterialFinish& finish) {
    const auto leftOut = [this](bool there, const char* what) {
      if (there) file_.warn(std::string("has glass with ") + what + ", which is left out");
    };
    leftOut(finish.hasSheen(), "sheen");
    leftOut(finish.isAnisotropic(), "anisotropy");
    leftOut(finish.hasFilm(), "iridescence");
    leftOut(finish.tintsSpecular(), "a specular reflection of its own");
  }

  /// Products of larger values with light would overflow single precision.
  float bounded(double value) {
    if (std::fabs(value) > limits::kNumber) file_.warn("has material numbers above 1e18, which were clamped to it");
    return static_cast<float>(std::clamp(value, -limits::kNumber, limits::kNumber));
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
        const double ior = extensionNumber(extension, "ior", kDefaultIor);
        fullFresnel_ = ior == 0.0;
        material.ior = fullFresnel_ ? static_cast<float>(kDefaultIor) : bounded(std::max(ior, 1.0));
      } else if (name == "KHR_materials_specular") {
        readSpecular(extension, material.finish);
      } else if (name == "KHR_materials_sheen") {
        readSheen(extension, material.finish);
      } else if (name == "KHR_materials_anisotropy") {
        readAnisotropy(extension, material.finish);
      } else if (name == "KHR_materials_iridescence") {
        readIridescence(extension, material.finish);
      } else if (name == "KHR_materials_pbrSpecularGlossiness") {
        readSpecularGlossiness(extension, material);
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
      } else if (name == "KHR_materials_volume") {
        material.thickness = bounded(std::max(extensionNumber(extension, "thicknessFactor", 0.0), 0.0));
        const tinygltf::Value solid =
            extension.Has("extras") ? extension.Get("extras").Get("solid") : tinygltf::Value();
        const bool ownSolid = solid.IsBool() && solid.Get<bool>();  // in .glb files that this program wrote
        material.thin = material.thickness == 0.0f && !ownSolid;
        material.thicknessTexture = extensionTexture(extension, "thicknessTexture");
        // Its default is infinite.
        material.attenuationDistance = bounded(std::max(extensionNumber(extension, "attenuationDistance", 0.0), 0.0));
        material.attenuationColor = glm::min(colorOf(extension, "attenuationColor"), 1.0f);
      }
    }
  }

  void readSpecular(const tinygltf::Value& extension, MaterialFinish& finish) {
    specularFactor_ = unit(extensionNumber(extension, "specularFactor", 1.0));
    specularColor_ = colorOf(extension, "specularColorFactor");
    finish.specularTexture = extensionTexture(extension, "specularTexture");
    finish.specularColorTexture = extensionTexture(extension, "specularColorTexture");
  }

  void readSheen(const tinygltf::Value& extension, MaterialFinish& finish) {
    if (!extension.IsObject() || !extension.Has("sheenColorFactor")) return;  // black
    finish.sheenColor = glm::min(colorOf(extension, "sheenColorFactor"), 1.0f);
    finish.sheenRoughness = unit(extensionNumber(extension, "sheenRoughnessFactor", 0.0));
    finish.sheenColorTexture = extensionTexture(extension, "sheenColorTexture");
    finish.sheenRoughnessTexture = extensionTexture(extension, "sheenRoughnessTexture");
  }

  void readAnisotropy(const tinygltf::Value& extension, MaterialFinish& finish) {
    finish.anisotropy = unit(extensionNumber(extension, "anisotropyStrength", 0.0));
    finish.anisotropyRotation = bounded(extensionNumber(extension, "anisotropyRotation", 0.0));
    finish.anisotropyTexture = extensionTexture(extension, "anisotropyTexture");
  }

  void readIridescence(const tinygltf::Value& extension, MaterialFinish& finish) {
    const auto atLeast = [&](const char* key, double standard, double least) {
      return bounded(std::max(extensionNumber(extension, key, standard), least));
    };
    finish.iridescence = unit(extensionNumber(extension, "iridescenceFactor", 0.0));
    finish.filmIor = atLeast("iridescenceIor", 1.3, 1.0);
    finish.filmThicknessMin = atLeast("iridescenceThicknessMinimum", 100.0, 0.0);
    finish.filmThicknessMax = atLeast("iridescenceThicknessMaximum", 400.0, 0.0);
    finish.iridescenceTexture = extensionTexture(extension, "iridescenceTexture");
    finish.filmThicknessTexture = extensionTexture(extension, "iridescenceThicknessTexture");
  }

  /// `specular` gets the brightness of the factors, the finish their hue.
  void applySpecular(Material& material) {
    const float brightness = glm::dot(specularColor_, glm::vec3(0.2126f, 0.7152f, 0.0722f));
    material.finish.specularEdge = specularFactor_;
    // Almost grey counts as grey, because a tint needs a program of its own.
    const glm::vec3 away = glm::abs(specularColor_ - brightness);
    if (brightness > 0.0f && std::max({away.r, away.g, away.b}) > 1.0e-5f * brightness) {
      material.finish.specularTint = specularColor_ / brightness;
    }
    if (!fullFresnel_) {
      material.specular = specularFactor_ * brightness;
      return;
    }
    // An index of 0 means a reflectance of 1 before the factors (KHR_materials_ior).
    const float root = static_cast<float>((kDefaultIor - 1.0) / (kDefaultIor + 1.0));
    material.specular = specularFactor_ * std::min(brightness, 1.0f) / (root * root);
  }

  void readSpecularGlossiness(const tinygltf::Value& extension, Material& material) {
    GltfSpecularGlossiness factors;
    factors.specular = glm::min(colorOf(extension, "specularFactor"), 1.0f);
    factors.glossiness = unit(extensionNumber(extension, "glossinessFactor", 1.0));
    glossiness_ = factors;
    material.baseColor = glm::vec4(colorOf(extension, "diffuseFactor"), 1.0f);
    if (extension.IsObject() && extension.Has("diffuseFactor")) {
      const tinygltf::Value& diffuse = extension.Get("diffuseFactor");
      if (diffuse.IsArray() && diffuse.ArrayLen() == 4 && diffuse.Get(3).IsNumber()) {
        material.baseColor.a = unit(diffuse.Get(3).GetNumberAsDouble());
      }
    }
    material.baseColorTexture = extensionTexture(extension, "diffuseTexture");
    material.metallicRoughnessTexture = extensionTexture(extension, "specularGlossinessTexture");
  }

  /// Three or four numbers, of which the first three are clamped to at least 0; white if missing.
  glm::vec3 colorOf(const tinygltf::Value& extension, const char* key) {
    glm::vec3 color(1.0f);
    if (!extension.IsObject() || !extension.Has(key)) return color;
    const tinygltf::Value& values = extension.Get(key);
    for (int i = 0; i < 3; ++i) {
      if (values.IsArray() && values.ArrayLen() >= 3 && values.Get(i).IsNumber()) {
        color[i] = bounded(std::max(values.Get(i).GetNumberAsDouble(), 0.0));
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

  /// A texture of an extension that tinygltf does not parse.
  TextureUse extensionTexture(const tinygltf::Value& extension, const char* slot) {
    if (!extension.IsObject() || !extension.Has(slot)) return {};
    const tinygltf::Value& info = extension.Get(slot);
    const tinygltf::Value* transform = nullptr;
    if (info.IsObject() && info.Has("extensions") && info.Get("extensions").IsObject() &&
        info.Get("extensions").Has("KHR_texture_transform")) {
      transform = &info.Get("extensions").Get("KHR_texture_transform");
    }
    return texture(extensionWhole(info, "index", -1), extensionWhole(info, "texCoord", 0), transform, slot);
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
    use.uvSet = extensionWhole(transform, "texCoord", use.uvSet);
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
    const int image = imageOf(source);
    if (image < 0) {
      file_.warn("has textures without a PNG, JPEG or WebP image, which are ignored");
      return use;
    }
    if (!readImage(file_, image, where)) {
      use.image = missingPicture();
      return use;
    }
    // Placeholder until all images are decoded.
    auto wanted = std::make_shared<ImageRgba8>();
    wanted->width = -1 - image;
    use.image = wanted;
    return use;
  }

  static int imageOf(const tinygltf::Texture& source) {
    const auto webp = source.extensions.find("EXT_texture_webp");
    const int image = webp == source.extensions.end() ? -1 : extensionWhole(webp->second, "source", -1);
    return image >= 0 ? image : source.source;
  }

  GltfFile& file_;
  std::string place_;
  // State of the material that is being read.
  float specularFactor_ = 1.0f;
  glm::vec3 specularColor_{1.0f};
  bool fullFresnel_ = false;
  std::optional<GltfSpecularGlossiness> glossiness_;
};

/// Refraction mostly uses one thickness per object: the factor times the mean of the texture's green channel.
void takeMeanThickness(Material& material) {
  const std::shared_ptr<const ImageRgba8> image = material.thicknessTexture.image;
  if (!image || image->pixels.empty()) return;
  double sum = 0.0;
  for (std::size_t i = 1; i < image->pixels.size(); i += 4) sum += image->pixels[i];
  material.thicknessMean = static_cast<float>(sum * 4.0 / 255.0 / static_cast<double>(image->pixels.size()));
  material.thickness *= material.thicknessMean;
  if (material.thicknessMean == 0.0f) material.thicknessTexture = {};
}

}  // namespace

double extensionNumber(const tinygltf::Value& extension, const char* key, double standard) {
  if (!extension.IsObject() || !extension.Has(key) || !extension.Get(key).IsNumber()) return standard;
  return extension.Get(key).GetNumberAsDouble();
}

int extensionWhole(const tinygltf::Value& extension, const char* key, int standard) {
  const double value = extensionNumber(extension, key, standard);
  return value >= -1.0 && value <= 1.0e9 ? static_cast<int>(value) : standard;
}

std::vector<Material> readMaterials(GltfFile& file, const std::function<void(double)>& progress) {
  MaterialReader reader(file);
  std::vector<Material> materials;
  std::vector<std::optional<GltfSpecularGlossiness>> glossiness;
  for (std::size_t i = 0; i < file.gltf.materials.size(); ++i) {
    materials.push_back(reader.read(file.gltf.materials[i], i));
    glossiness.push_back(reader.glossiness());
  }
  const auto waits = [](const TextureUse& use) { return use.image && use.image->width < 0; };
  const auto wanted = [](const TextureUse& use) { return -1 - use.image->width; };
  const auto forEach = [&](const auto& work) {
    for (std::size_t i = 0; i < materials.size(); ++i) {
      for (TextureUse* use : materials[i].textures()) {
        if (waits(*use)) work(*use);
      }
    }
  };
  std::set<int> used;
  forEach([&](const TextureUse& use) { used.insert(wanted(use)); });
  const auto images = decodeImages(file, used, progress);
  forEach([&](TextureUse& use) {
    const std::shared_ptr<const ImageRgba8>& image = images.at(wanted(use));
    use.image = image ? image : missingPicture();
  });
  for (std::size_t i = 0; i < materials.size(); ++i) {
    MaterialReader::leaveOutMissing(materials[i]);
    takeMeanThickness(materials[i]);
    if (glossiness[i]) convertSpecularGlossiness(materials[i], *glossiness[i]);
  }
  return materials;
}

}  // namespace boxprobe
