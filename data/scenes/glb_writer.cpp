#include "data/scenes/glb_writer.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

#include "data/scenes/picture.h"
#include "filters/core/base/errors.h"

namespace boxprobe::scenes {
namespace {

using Json = nlohmann::ordered_json;  // keeps the order of insertion, so that the file reads top down

constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;

int wrapCode(Wrap wrap) {
  switch (wrap) {
    case Wrap::ClampToEdge:
      return 33071;
    case Wrap::MirroredRepeat:
      return 33648;
    case Wrap::Repeat:
      break;
  }
  return 10497;
}

template <typename Vector>
Json jsonArray(const Vector& v) {
  Json array = Json::array();
  for (int i = 0; i < v.length(); ++i) array.push_back(v[i]);
  return array;
}

void appendWord(std::string& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(word >> shift & 0xffu));
}

class Writer {
 public:
  Writer(const Model& model, int jpegQuality) : model_(model), jpegQuality_(jpegQuality) {
    gltf_["asset"] = {{"version", "2.0"}, {"generator", "boxprobe generate_scenes"}};
    gltf_["scene"] = 0;
    gltf_["scenes"] = Json::array({{{"nodes", Json::array()}}});
  }

  std::string bytes() {
    for (const Instance& instance : model_.instances) addNode(instance);
    for (const Mesh& mesh : model_.meshes) addMesh(mesh);
    for (const Material& material : model_.materials) addMaterial(material);
    for (const char* extension : {"KHR_materials_unlit", "KHR_materials_emissive_strength", "KHR_materials_specular",
                                  "KHR_materials_transmission", "KHR_materials_ior", "KHR_materials_volume",
                                  "KHR_materials_sheen", "KHR_materials_anisotropy"})
      if (extensions_.count(extension)) gltf_["extensionsUsed"].push_back(extension);
    gltf_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    return container();
  }

 private:
  void addNode(const Instance& instance) {
    Json node = {{"name", instance.node}, {"mesh", instance.mesh}};
    const glm::dmat4& matrix = instance.worldFromModel;
    glm::dmat4 onlyTranslated(1.0);
    onlyTranslated[3] = matrix[3];
    if (matrix != onlyTranslated) {
      for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) node["matrix"].push_back(matrix[column][row]);
    } else if (matrix != glm::dmat4(1.0)) {
      node["translation"] = {matrix[3].x, matrix[3].y, matrix[3].z};
    }
    gltf_["scenes"][0]["nodes"].push_back(nodes_++);
    gltf_["nodes"].push_back(node);
  }

  void addMesh(const Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    if (mesh.normals.size() != count || mesh.uv.size() != count || mesh.indices.empty() ||
        (!mesh.uv1.empty() && mesh.uv1.size() != count) || (!mesh.tangents.empty() && mesh.tangents.size() != count))
      throw WorkError("mesh " + mesh.name + ": needs a normal and a texture coordinate for each position, and indices");
    Json attributes;
    glm::vec3 low = mesh.positions.front(), high = low;
    for (const glm::vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
    attributes["POSITION"] = addAccessor(mesh.positions.data(), count, "VEC3", kFloat, kArrayBuffer);
    gltf_["accessors"].back()["min"] = jsonArray(low);
    gltf_["accessors"].back()["max"] = jsonArray(high);
    attributes["NORMAL"] = addAccessor(mesh.normals.data(), count, "VEC3", kFloat, kArrayBuffer);
    attributes["TEXCOORD_0"] = addAccessor(mesh.uv.data(), count, "VEC2", kFloat, kArrayBuffer);
    if (!mesh.uv1.empty()) {
      attributes["TEXCOORD_1"] = addAccessor(mesh.uv1.data(), count, "VEC2", kFloat, kArrayBuffer);
    }
    if (!mesh.tangents.empty()) {
      attributes["TANGENT"] = addAccessor(mesh.tangents.data(), count, "VEC4", kFloat, kArrayBuffer);
    }
    int indices = 0;
    if (count <= 65535) {
      const std::vector<std::uint16_t> narrow(mesh.indices.begin(), mesh.indices.end());
      indices = addAccessor(narrow.data(), narrow.size(), "SCALAR", kUnsignedShort, kElementArrayBuffer);
    } else {
      indices = addAccessor(mesh.indices.data(), mesh.indices.size(), "SCALAR", kUnsignedInt, kElementArrayBuffer);
    }
    Json primitive = {{"attributes", attributes}, {"indices", indices}};
    if (mesh.material >= 0) primitive["material"] = mesh.material;
    gltf_["meshes"].push_back({{"name", mesh.name}, {"primitives", Json::array({primitive})}});
  }

  void addMaterial(const Material& material) {
    Json pbr = {{"baseColorFactor", jsonArray(material.baseColor)},
                {"metallicFactor", material.metallic},
                {"roughnessFactor", material.roughness}};
    if (material.baseColorTexture.image) pbr["baseColorTexture"] = {{"index", texture(material.baseColorTexture)}};
    if (material.metallicRoughnessTexture.image) {
      pbr["metallicRoughnessTexture"] = {{"index", texture(material.metallicRoughnessTexture)}};
    }
    Json json = {{"name", material.name}, {"pbrMetallicRoughness", pbr}};
    if (material.emissiveTexture.image) json["emissiveTexture"] = {{"index", texture(material.emissiveTexture)}};
    if (material.normalTexture.image) {
      json["normalTexture"] = {{"index", texture(material.normalTexture)}, {"scale", material.normalScale}};
    }
    if (const TextureUse& occlusion = material.occlusionTexture; occlusion.image) {
      json["occlusionTexture"] = {{"index", texture(occlusion)}, {"texCoord", occlusion.uvSet}};
    }
    const float brightest = std::max({material.emissive.r, material.emissive.g, material.emissive.b});
    if (brightest > 1.0f) {  // the factor itself may not exceed 1
      json["emissiveFactor"] = jsonArray(material.emissive / brightest);
      json["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", brightest}};
      extensions_.insert("KHR_materials_emissive_strength");
    } else if (brightest > 0.0f) {
      json["emissiveFactor"] = jsonArray(material.emissive);
    }
    if (material.finish.specularEdge != 1.0f) {
      json["extensions"]["KHR_materials_specular"] = {{"specularFactor", material.finish.specularEdge}};
      extensions_.insert("KHR_materials_specular");
    }
    if (material.finish.hasSheen()) {
      json["extensions"]["KHR_materials_sheen"] = {{"sheenColorFactor", jsonArray(material.finish.sheenColor)},
                                                   {"sheenRoughnessFactor", material.finish.sheenRoughness}};
      extensions_.insert("KHR_materials_sheen");
    }
    if (material.finish.isAnisotropic()) {
      json["extensions"]["KHR_materials_anisotropy"] = {{"anisotropyStrength", material.finish.anisotropy},
                                                        {"anisotropyRotation", material.finish.anisotropyRotation}};
      extensions_.insert("KHR_materials_anisotropy");
    }
    if (material.transmission > 0.0f) {
      const auto add = [&](const char* name, const Json& extension) {
        json["extensions"][name] = extension;
        extensions_.insert(name);
      };
      add("KHR_materials_transmission", {{"transmissionFactor", material.transmission}});
      add("KHR_materials_ior", {{"ior", material.ior}});
      if (!material.thin) {
        Json volume = {{"thicknessFactor", material.thickness}};
        if (material.attenuationDistance > 0.0f) {
          volume["attenuationDistance"] = material.attenuationDistance;
          volume["attenuationColor"] = jsonArray(material.attenuationColor);
        }
        add("KHR_materials_volume", volume);
      }
    }
    if (material.unlit) {
      json["extensions"]["KHR_materials_unlit"] = Json::object();
      extensions_.insert("KHR_materials_unlit");
    }
    if (material.alphaMode == AlphaMode::Blend) json["alphaMode"] = "BLEND";
    if (material.doubleSided) json["doubleSided"] = true;
    gltf_["materials"].push_back(json);
  }

  int texture(const TextureUse& use) {
    const auto key = std::make_tuple(image(*use.image), sampler(use.wrapS, use.wrapT));
    const auto [entry, added] = textures_.try_emplace(key, static_cast<int>(textures_.size()));
    if (added) gltf_["textures"].push_back({{"source", std::get<0>(key)}, {"sampler", std::get<1>(key)}});
    return entry->second;
  }

  int image(const ImageRgba8& picture) {
    const auto [entry, added] = images_.try_emplace(&picture, static_cast<int>(images_.size()));
    if (added) {
      const bool jpeg = jpegQuality_ > 0 && std::max(picture.width, picture.height) > 128;
      const std::string bytes = jpeg ? jpegBytes(picture, jpegQuality_) : pngBytes(picture);
      const int view = addBufferView(bytes.data(), bytes.size(), 0);
      gltf_["images"].push_back(
          {{"name", picture.name}, {"mimeType", jpeg ? "image/jpeg" : "image/png"}, {"bufferView", view}});
    }
    return entry->second;
  }

  int sampler(Wrap s, Wrap t) {
    const auto [entry, added] = samplers_.try_emplace({s, t}, static_cast<int>(samplers_.size()));
    constexpr int kLinear = 9729, kLinearMipmapLinear = 9987;
    if (added)
      gltf_["samplers"].push_back(
          {{"magFilter", kLinear}, {"minFilter", kLinearMipmapLinear}, {"wrapS", wrapCode(s)}, {"wrapT", wrapCode(t)}});
    return entry->second;
  }

  template <typename Value>
  int addAccessor(const Value* values, std::size_t count, const char* type, int componentType, int target) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const int view = addBufferView(values, count * sizeof(Value), target);
    gltf_["accessors"].push_back(
        {{"bufferView", view}, {"componentType", componentType}, {"count", count}, {"type", type}});
    return static_cast<int>(gltf_["accessors"].size()) - 1;
  }

  /// `target` 0: not for the GPU.
  int addBufferView(const void* data, std::size_t size, int target) {
    Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}};
    if (target != 0) view["target"] = target;
    binary_.append(static_cast<const char*>(data), size);
    binary_.resize((binary_.size() + 3) / 4 * 4, '\0');  // accessors must start at multiples of their component size
    gltf_["bufferViews"].push_back(view);
    return static_cast<int>(gltf_["bufferViews"].size()) - 1;
  }

  std::string container() const {
    std::string json = gltf_.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string file = "glTF";
    appendWord(file, 2);
    appendWord(file, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary_.size()));
    appendWord(file, static_cast<std::uint32_t>(json.size()));
    file += "JSON" + json;
    appendWord(file, static_cast<std::uint32_t>(binary_.size()));
    file += std::string("BIN\0", 4) + binary_;
    return file;
  }

  const Model& model_;
  int jpegQuality_;
  Json gltf_;
  std::string binary_;
  int nodes_ = 0;
  std::map<const ImageRgba8*, int> images_;
  std::map<std::pair<Wrap, Wrap>, int> samplers_;
  std::map<std::tuple<int, int>, int> textures_;
  std::set<std::string> extensions_;
};

}  // namespace

std::string glbBytes(const Model& model, int jpegQuality) {
  return Writer(model, jpegQuality).bytes();
}

}  // namespace boxprobe::scenes
