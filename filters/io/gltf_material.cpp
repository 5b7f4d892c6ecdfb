// Materials, textures, samplers and images of a glTF file. Images are decoded when the first material asks for them and
// shared by all that do.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "filters/core/one_line.h"
#include "filters/io/gltf_parts.h"
#include "filters/io/image_detail.h"

namespace boxprobe {

namespace {

constexpr double kDefaultIor = 1.5;

class MaterialReader {
 public:
  explicit MaterialReader(GltfFile& file) : file_(file), images_(file.gltf.images.size()) {}

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
    readExtensions(source, material);
    if (!source.alphaMode.empty() && source.alphaMode != "OPAQUE") {
      file_.warn("has materials with alphaMode " + oneLine(source.alphaMode) + ", which are drawn opaque");
    }
    return material;
  }

 private:
  /// Beyond 1e18 products with light would leave single precision.
  float bounded(double value) {
    if (std::fabs(value) > kLargestNumber)
      file_.warn("has material numbers beyond 1e18, which were brought down to it");
    return static_cast<float>(std::clamp(value, -kLargestNumber, kLargestNumber));
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

  static double extensionNumber(const tinygltf::Value& extension, const char* key, double standard) {
    if (!extension.IsObject() || !extension.Has(key) || !extension.Get(key).IsNumber()) return standard;
    return extension.Get(key).GetNumberAsDouble();
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
        for (const char* key : {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"}) {
          if (extension.IsObject() && extension.Has(key))
            file_.warn("has clear-coat textures, which are not supported");
        }
      }
    }
  }

  static Wrap wrapMode(int mode) {
    if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::ClampToEdge;
    if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::MirroredRepeat;
    return Wrap::Repeat;
  }

  template <typename TextureInfo>
  TextureUse texture(const TextureInfo& info, const char* slot) {
    TextureUse use;
    if (info.index < 0) return use;
    const std::string where = place_ + ": " + slot;
    const auto& textures = file_.gltf.textures;
    if (static_cast<std::size_t>(info.index) >= textures.size()) {
      file_.fail(where, "texture " + std::to_string(info.index) + " does not exist; the file has " +
                            std::to_string(textures.size()));
    }
    if (info.texCoord != 0) file_.warn("has textures on a second set of texture coordinates; the first set is used");
    const tinygltf::Texture& source = textures[static_cast<std::size_t>(info.index)];
    if (source.sampler >= 0) {
      if (static_cast<std::size_t>(source.sampler) >= file_.gltf.samplers.size()) {
        file_.fail(where, "sampler " + std::to_string(source.sampler) + " does not exist; the file has " +
                              std::to_string(file_.gltf.samplers.size()));
      }
      const tinygltf::Sampler& sampler = file_.gltf.samplers[static_cast<std::size_t>(source.sampler)];
      use.wrapS = wrapMode(sampler.wrapS);
      use.wrapT = wrapMode(sampler.wrapT);
    }
    if (source.source < 0) {
      file_.warn("has textures without a PNG or JPEG image, which are left out");
      return use;
    }
    use.image = image(source.source, where);
    return use;
  }

  std::shared_ptr<const ImageRgba8> image(int index, const std::string& where) {
    if (static_cast<std::size_t>(index) >= images_.size()) {
      file_.fail(where,
                 "image " + std::to_string(index) + " does not exist; the file has " + std::to_string(images_.size()));
    }
    auto& decoded = images_[static_cast<std::size_t>(index)];
    if (decoded) return decoded;
    const tinygltf::Image& source = file_.gltf.images[static_cast<std::size_t>(index)];
    const bool isFile = !source.uri.empty();
    const std::string called = isFile ? source.uri : source.name;
    const std::string name =
        oneLine(file_.path + ": image " + std::to_string(index) + (called.empty() ? "" : " (" + called + ")"));
    ByteRange bytes;
    if (source.bufferView >= 0) {
      bytes = bufferViewBytes(file_, source.bufferView, "image " + std::to_string(index));
    } else if (const auto kept = file_.encodedImages.find(index); kept != file_.encodedImages.end()) {
      bytes = {reinterpret_cast<const unsigned char*>(kept->second.data()), kept->second.size()};
    }
    ImageRgba8 picture = decodeImage8(bytes.data, bytes.size, name);
    picture.name = called.empty() ? "image " + std::to_string(index) : called;
    decoded = std::make_shared<const ImageRgba8>(std::move(picture));
    return decoded;
  }

  GltfFile& file_;
  std::string place_;
  std::vector<std::shared_ptr<const ImageRgba8>> images_;
};

}  // namespace

std::vector<Material> readMaterials(GltfFile& file) {
  MaterialReader reader(file);
  std::vector<Material> materials;
  for (std::size_t i = 0; i < file.gltf.materials.size(); ++i) {
    materials.push_back(reader.read(file.gltf.materials[i], i));
  }
  return materials;
}

}  // namespace boxprobe
