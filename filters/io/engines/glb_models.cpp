#include "filters/io/engines/glb_models.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>
#include <tuple>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/io/engines/glb_scene.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/image/png_image.h"

namespace boxprobe {

namespace {

constexpr int kVertices = 34962, kIndices = 34963;  // what a buffer view is for
constexpr int kFloat = 5126, kUnsigned = 5125;

/// Can the matrix be written as translation, rotation and scale, which is all that a node of glTF may be?
bool isPlain(const glm::dmat3& m) {
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 &a = m[i], &b = m[(i + 1) % 3];
    if (std::abs(glm::dot(a, b)) > 1e-6 * glm::length(a) * glm::length(b)) return false;
  }
  return true;
}

/// Fronts outside again, as a mirroring node turns them: what the reader did to the mesh is undone.
Mesh unmirrored(Mesh mesh) {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  for (glm::vec4& tangent : mesh.tangents) tangent.w = -tangent.w;
  return mesh;
}

/// The mesh with a shear in its positions.
Mesh sheared(Mesh mesh, const glm::dmat3& m) {
  const glm::dmat3 ofNormals = glm::transpose(glm::inverse(m));
  const double hand = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
  for (glm::vec3& p : mesh.positions) p = glm::vec3(m * glm::dvec3(p));
  for (glm::vec3& n : mesh.normals) n = glm::vec3(glm::normalize(ofNormals * glm::dvec3(n)));
  for (glm::vec4& t : mesh.tangents) {
    t = glm::vec4(glm::vec3(glm::normalize(m * glm::dvec3(t))), static_cast<float>(hand) * t.w);
  }
  return mesh;
}

bool areUnit(const std::vector<glm::vec3>& normals) {
  return std::all_of(normals.begin(), normals.end(),
                     [](const glm::vec3& n) { return std::abs(glm::length(glm::dvec3(n)) - 1.0) < 1e-5; });
}

bool areTangents(const std::vector<glm::vec4>& tangents) {
  return std::all_of(tangents.begin(), tangents.end(), [](const glm::vec4& t) {
    return std::abs(glm::length(glm::dvec3(t)) - 1.0) < 1e-5 && std::abs(t.w) == 1.0f;
  });
}

class ModelWriter {
 public:
  GlbDocument write(const Scene& scene, const SceneModels& models) {
    Json& root = document_.json;
    root = {{"asset", {{"version", "2.0"}, {"generator", "Boxprobe"}}}, {"scene", 0}};
    root["buffers"] = Json::array({Json::object()});
    root["bufferViews"] = Json::array();
    for (std::size_t i = 0; i < models.size(); ++i) {
      const std::size_t first = materials_.size();
      for (const Material& material : models[i]->materials) materials_.push_back(materialJson(material));
      addInstances(*models[i], worldFromFile(scene.models[i]), first);
    }
    Json scenes = Json::array({Json::object()});
    if (!nodes_.empty()) {
      for (std::size_t i = 0; i < nodes_.size(); ++i) scenes[0]["nodes"].push_back(i);
    }
    root["scenes"] = std::move(scenes);
    const auto put = [&root](const char* key, Json& list) {
      if (!list.empty()) root[key] = std::move(list);
    };
    put("nodes", nodes_);
    put("meshes", meshes_);
    put("accessors", accessors_);
    put("materials", materials_);
    put("textures", textures_);
    put("samplers", samplers_);
    put("images", images_);
    for (const std::string& name : used_) root["extensionsUsed"].push_back(name);
    if (root["bufferViews"].empty()) root.erase("bufferViews");
    return std::move(document_);
  }

 private:
  void addInstances(const Model& model, const glm::dmat4& placement, std::size_t firstMaterial) {
    std::map<std::pair<int, bool>, std::size_t> written;
    for (const Instance& instance : model.instances) {
      const glm::dmat4 world = placement * instance.worldFromModel;
      const glm::dmat3 linear(world);
      const Mesh& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
      Json node = {{"name", instance.node}};
      if (!isPlain(linear)) {
        node["mesh"] = addMesh(sheared(mesh, linear), firstMaterial);
        node["translation"] = glbNumbers(glm::dvec3(world[3]));
      } else {
        const bool mirrors = glm::determinant(linear) < 0.0;
        const auto [entry, isNew] = written.emplace(std::make_pair(instance.mesh, mirrors), meshes_.size());
        if (isNew) addMesh(mirrors ? unmirrored(mesh) : mesh, firstMaterial);
        node["mesh"] = entry->second;
        if (world != glm::dmat4(1.0)) node["matrix"] = glbMatrix(world);
      }
      nodes_.push_back(std::move(node));
    }
  }

  template <typename Vector>
  std::size_t addVectors(const std::vector<Vector>& values, const char* type, bool bounds = false) {
    std::string bytes(sizeof(Vector) * values.size(), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    Json json = {
        {"bufferView", addView(bytes, kVertices)}, {"componentType", kFloat}, {"count", values.size()}, {"type", type}};
    if (bounds) {
      Vector low = values.front(), high = values.front();
      for (const Vector& v : values) {
        low = glm::min(low, v);
        high = glm::max(high, v);
      }
      json["min"] = glbNumbers(low);
      json["max"] = glbNumbers(high);
    }
    accessors_.push_back(std::move(json));
    return accessors_.size() - 1;
  }

  std::size_t addView(const std::string& bytes, int target) {
    const std::size_t view = addBytes(document_, bytes);
    document_.json["bufferViews"][view]["target"] = target;
    return view;
  }

  std::size_t addMesh(const Mesh& mesh, std::size_t firstMaterial) {
    Json primitive, attributes;
    attributes["POSITION"] = addVectors(mesh.positions, "VEC3", true);
    std::vector<glm::vec3> normals = mesh.normals;
    if (!normals.empty()) {
      if (areUnit(normals)) {
        primitive["extras"] = {{"unitNormals", true}};  // dividing them by their length again changes the last bit
      } else {
        for (glm::vec3& n : normals) n = glm::length(n) > 0.0f ? glm::normalize(n) : glm::vec3(0.0f, 1.0f, 0.0f);
      }
      attributes["NORMAL"] = addVectors(normals, "VEC3");
    }
    if (!mesh.tangents.empty() && areTangents(mesh.tangents)) attributes["TANGENT"] = addVectors(mesh.tangents, "VEC4");
    if (!mesh.uv.empty()) attributes["TEXCOORD_0"] = addVectors(mesh.uv, "VEC2");
    if (!mesh.uv1.empty()) attributes["TEXCOORD_1"] = addVectors(mesh.uv1, "VEC2");
    if (!mesh.colors.empty()) attributes["COLOR_0"] = addVectors(mesh.colors, "VEC4");
    primitive["attributes"] = std::move(attributes);
    std::string bytes(4 * mesh.indices.size(), '\0');
    std::memcpy(bytes.data(), mesh.indices.data(), bytes.size());
    accessors_.push_back({{"bufferView", addView(bytes, kIndices)},
                          {"componentType", kUnsigned},
                          {"count", mesh.indices.size()},
                          {"type", "SCALAR"}});
    primitive["indices"] = accessors_.size() - 1;
    if (mesh.material >= 0) primitive["material"] = firstMaterial + static_cast<std::size_t>(mesh.material);
    meshes_.push_back({{"name", mesh.name}, {"primitives", Json::array({primitive})}});
    return meshes_.size() - 1;
  }

  std::size_t imageOf(const TextureUse& use) {
    const auto [entry, isNew] = imageNumbers_.emplace(use.image.get(), images_.size());
    if (isNew) {
      const ImageRgba8& image = *use.image;
      const std::string png = encodedPng(image.pixels.data(), image.width, image.height);
      if (png.empty()) throw WorkError(image.name + ": not enough memory for this picture");
      images_.push_back({{"bufferView", addBytes(document_, png)}, {"mimeType", "image/png"}});
    }
    return entry->second;
  }

  Json textureJson(const TextureUse& use) {
    const std::size_t image = imageOf(use);
    const auto sampling = std::make_tuple(use.wrapS, use.wrapT, use.nearest);
    const auto [sampler, newSampler] = samplerNumbers_.emplace(sampling, samplers_.size());
    if (newSampler) {
      const auto wrap = [](Wrap w) { return w == Wrap::Repeat ? 10497 : w == Wrap::ClampToEdge ? 33071 : 33648; };
      samplers_.push_back({{"magFilter", use.nearest ? 9728 : 9729},
                           {"minFilter", 9987},
                           {"wrapS", wrap(use.wrapS)},
                           {"wrapT", wrap(use.wrapT)}});
    }
    const auto [texture, isNew] = textureNumbers_.emplace(std::make_pair(image, sampler->second), textures_.size());
    if (isNew) textures_.push_back({{"sampler", sampler->second}, {"source", image}});
    Json json = {{"index", texture->second}};
    if (use.uvSet != 0) json["texCoord"] = use.uvSet;
    const glm::mat3x2& m = use.uvTransform;
    if (m == glm::mat3x2(1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f)) return json;
    Json transform = {{"offset", {m[2][0], m[2][1]}}};
    if (m[0][1] == 0.0f && m[1][0] == 0.0f) {
      transform["scale"] = {m[0][0], m[1][1]};
    } else {  // columns (c sx, -s sx) and (s sy, c sy)
      const glm::dvec2 x(m[0]), y(m[1]);
      const double turn = std::atan2(-x.y, x.x);
      transform["rotation"] = turn;
      transform["scale"] = {glm::length(x), std::sin(turn) * y.x + std::cos(turn) * y.y};
    }
    json["extensions"]["KHR_texture_transform"] = std::move(transform);
    used_.insert("KHR_texture_transform");
    return json;
  }

  void putTexture(Json& object, const char* key, const TextureUse& use) {
    if (use.image) object[key] = textureJson(use);
  }

  Json& extension(Json& material, const char* name) {
    used_.insert(name);
    Json& json = material["extensions"][name];
    if (json.is_null()) json = Json::object();
    return json;
  }

  Json materialJson(const Material& m) {
    Json json = {{"name", m.name}};
    Json& pbr = json["pbrMetallicRoughness"];  // not used once json has grown
    pbr = {
        {"baseColorFactor", glbNumbers(m.baseColor)}, {"metallicFactor", m.metallic}, {"roughnessFactor", m.roughness}};
    putTexture(pbr, "baseColorTexture", m.baseColorTexture);
    putTexture(pbr, "metallicRoughnessTexture", m.metallicRoughnessTexture);
    putTexture(json, "normalTexture", m.normalTexture);
    if (m.normalTexture.image) json["normalTexture"]["scale"] = m.normalScale;
    putTexture(json, "occlusionTexture", m.occlusionTexture);
    if (m.occlusionTexture.image) json["occlusionTexture"]["strength"] = m.occlusionStrength;
    putTexture(json, "emissiveTexture", m.emissiveTexture);
    if (m.emissive != glm::vec3(0.0f)) {
      float strength = 1.0f;  // a power of two: nothing is rounded
      while (std::max({m.emissive.x, m.emissive.y, m.emissive.z}) > strength) strength *= 2.0f;
      json["emissiveFactor"] = glbNumbers(m.emissive / strength);
      if (strength > 1.0f) extension(json, "KHR_materials_emissive_strength") = {{"emissiveStrength", strength}};
    }
    if (m.alphaMode == AlphaMode::Blend) json["alphaMode"] = "BLEND";
    if (m.alphaMode == AlphaMode::Mask) {
      json["alphaMode"] = "MASK";
      json["alphaCutoff"] = m.alphaCutoff;
    }
    if (m.doubleSided) json["doubleSided"] = true;
    if (m.unlit) extension(json, "KHR_materials_unlit");
    writeLayers(json, m);
    writeFinish(json, m);
    return json;
  }

  void writeLayers(Json& json, const Material& m) {
    // A layer that the file turns off may be turned on by the scene.
    const bool coated = m.coatTexture.image || m.coatRoughnessTexture.image || m.coatNormalTexture.image;
    if (m.coat > 0.0f || m.coatRoughness > 0.0f || coated) {
      Json& coat = extension(json, "KHR_materials_clearcoat");
      coat["clearcoatFactor"] = m.coat;
      coat["clearcoatRoughnessFactor"] = m.coatRoughness;
      putTexture(coat, "clearcoatTexture", m.coatTexture);
      putTexture(coat, "clearcoatRoughnessTexture", m.coatRoughnessTexture);
      putTexture(coat, "clearcoatNormalTexture", m.coatNormalTexture);
      if (m.coatNormalTexture.image) coat["clearcoatNormalTexture"]["scale"] = m.coatNormalScale;
    }
    if (m.transmission > 0.0f || m.transmissionTexture.image) {
      Json& glass = extension(json, "KHR_materials_transmission");
      glass["transmissionFactor"] = m.transmission;
      putTexture(glass, "transmissionTexture", m.transmissionTexture);
    }
    if (!m.thin || m.thickness > 0.0f || m.attenuationDistance > 0.0f || m.attenuationColor != glm::vec3(1.0f)) {
      Json& volume = extension(json, "KHR_materials_volume");
      volume["thicknessFactor"] = m.thicknessMean > 0.0f ? m.thickness / m.thicknessMean : m.thickness;
      putTexture(volume, "thicknessTexture", m.thicknessTexture);
      if (m.attenuationDistance > 0.0f) volume["attenuationDistance"] = m.attenuationDistance;
      volume["attenuationColor"] = glbNumbers(m.attenuationColor);
      if (!m.thin && !(m.thickness > 0.0f))
        volume["extras"] = {{"solid", true}};  // glTF says that by a thickness alone
    }
    if (m.ior != 1.5f) extension(json, "KHR_materials_ior") = {{"ior", m.ior}};
  }

  void writeFinish(Json& json, const Material& m) {
    const MaterialFinish& f = m.finish;
    if (m.specular != 1.0f || f.tintsSpecular() || f.specularEdge != 1.0f) {
      Json& specular = extension(json, "KHR_materials_specular");
      specular["specularFactor"] = f.specularEdge;
      const float rest = f.specularEdge > 0.0f ? m.specular / f.specularEdge : 1.0f;
      specular["specularColorFactor"] = glbNumbers(f.specularTint * rest);
      putTexture(specular, "specularTexture", f.specularTexture);
      putTexture(specular, "specularColorTexture", f.specularColorTexture);
    }
    if (f.hasSheen()) {
      Json& sheen = extension(json, "KHR_materials_sheen");
      sheen = {{"sheenColorFactor", glbNumbers(f.sheenColor)}, {"sheenRoughnessFactor", f.sheenRoughness}};
      putTexture(sheen, "sheenColorTexture", f.sheenColorTexture);
      putTexture(sheen, "sheenRoughnessTexture", f.sheenRoughnessTexture);
    }
    if (f.isAnisotropic()) {
      Json& brushed = extension(json, "KHR_materials_anisotropy");
      brushed = {{"anisotropyStrength", f.anisotropy}, {"anisotropyRotation", f.anisotropyRotation}};
      putTexture(brushed, "anisotropyTexture", f.anisotropyTexture);
    }
    if (f.hasFilm()) {
      Json& film = extension(json, "KHR_materials_iridescence");
      film = {{"iridescenceFactor", f.iridescence},
              {"iridescenceIor", f.filmIor},
              {"iridescenceThicknessMinimum", f.filmThicknessMin},
              {"iridescenceThicknessMaximum", f.filmThicknessMax}};
      putTexture(film, "iridescenceTexture", f.iridescenceTexture);
      putTexture(film, "iridescenceThicknessTexture", f.filmThicknessTexture);
    }
  }

  GlbDocument document_;
  Json nodes_ = Json::array(), meshes_ = Json::array(), accessors_ = Json::array(), materials_ = Json::array();
  Json textures_ = Json::array(), samplers_ = Json::array(), images_ = Json::array();
  std::map<const ImageRgba8*, std::size_t> imageNumbers_;
  std::map<std::tuple<Wrap, Wrap, bool>, std::size_t> samplerNumbers_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> textureNumbers_;
  std::set<std::string> used_;
};

}  // namespace

bool needsJoining(const Scene& scene) {
  if (scene.models.size() != 1) return true;
  const std::string extension = lowerExtension(scene.models.front().file);
  return extension != ".glb" && extension != ".gltf";
}

GlbDocument documentOfModels(const Scene& scene, const SceneModels& models) {
  return ModelWriter().write(scene, models);
}

Scene withJoinedModels(const Scene& scene, const SceneModels& models, const std::string& folder) {
  Scene joined = scene;
  joined.models = {ModelFile{}};
  joined.models.front().file = (std::filesystem::path(folder) / "models.glb").string();
  writeTextAtomically(joined.models.front().file, glbText(documentOfModels(scene, models), "the scene's models"));
  return joined;
}

}  // namespace boxprobe
