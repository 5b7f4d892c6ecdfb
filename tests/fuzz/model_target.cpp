// Model files: whatever is accepted can be drawn without another look: indices inside their arrays, finite numbers,
// unit normals.
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "filters/core/base/errors.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/image/image_detail.h"
#include "tests/fuzz/parse_target.h"
#include "tests/fuzz/scratch_file.h"

namespace boxprobe::fuzz {

namespace {

template <typename Vector>
bool finite(const Vector& v) {
  for (int i = 0; i < Vector::length(); ++i) {
    if (!std::isfinite(v[i])) return false;
  }
  return true;
}

template <typename Vector>
void checkAttribute(const std::vector<Vector>& values, std::size_t positions) {
  promise(values.empty() || values.size() == positions, "an attribute has not one entry a position");
  for (const Vector& value : values) promise(finite(value), "an attribute is not finite");
}

void checkMaterial(const Material& material) {
  promise(finite(material.baseColor) && finite(material.emissive), "a material's colour is not finite");
  for (const float value :
       {material.metallic, material.roughness, material.normalScale, material.occlusionStrength, material.coat,
        material.coatRoughness, material.ior, material.specular, material.reflectedIor(), material.thickness,
        material.alphaCutoff, material.coatNormalScale, material.transmission}) {
    promise(std::isfinite(value), "a material's number is not finite");
  }
  const MaterialFinish& finish = material.finish;
  promise(finite(finish.specularTint) && finite(finish.sheenColor), "a finish's colour is not finite");
  for (const float value : {finish.specularEdge, finish.sheenRoughness, finish.anisotropy, finish.anisotropyRotation,
                            finish.iridescence, finish.filmIor, finish.filmThicknessMin, finish.filmThicknessMax}) {
    promise(std::isfinite(value), "a finish's number is not finite");
  }
  for (const TextureUse* use : material.textures()) {
    if (!use->image) continue;
    promise(use->uvSet == 0 || use->uvSet == 1, "a texture lies on a third set of coordinates");
    for (int column = 0; column < 3; ++column) {
      promise(finite(use->uvTransform[column]), "a texture's transform is not finite");
    }
    const ImageRgba8& image = *use->image;
    promise(image.pixels.size() == std::size_t(4) * image.width * image.height, "a texture has another size");
  }
}

}  // namespace

void checkMesh(const Mesh& mesh, std::size_t materials) {
  promise(!mesh.indices.empty() && mesh.indices.size() % 3 == 0, "a mesh has no whole triangles");
  for (const std::uint32_t index : mesh.indices) promise(index < mesh.positions.size(), "an index has no position");
  checkAttribute(mesh.positions, mesh.positions.size());
  checkAttribute(mesh.normals, mesh.positions.size());
  checkAttribute(mesh.tangents, mesh.positions.size());
  checkAttribute(mesh.uv, mesh.positions.size());
  checkAttribute(mesh.uv1, mesh.positions.size());
  checkAttribute(mesh.colors, mesh.positions.size());
  for (const glm::vec3& normal : mesh.normals) {
    promise(std::fabs(glm::length(normal) - 1.0f) < 1e-3f, "a normal is not unit");
  }
  promise(mesh.material >= -1 && mesh.material < static_cast<int>(materials),
          "a mesh has a material that is not there");
}

/// The probes that a .glb may hold, unpacked as when it is opened.
void parseProbesOf(const std::string& path, const std::string& folder) {
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
  try {
    if (!holdsProbes(path)) return;
    unpackGlb(path, folder);
    validate(glbSceneOf(path, folder));
  } catch (const InputError& refused) {
    checkRefusal(refused.what());
  }
}

void parseModelFile(const std::string& bytes) {
  static const ScratchFile scratch;
  const bool binary = bytes.compare(0, 4, "glTF") == 0;
  const std::string path = scratch.write(binary ? "model.glb" : "model.gltf", bytes);
  if (binary) parseProbesOf(path, scratch.path("unpacked"));
  try {
    Model model = loadModelFile(path);
    // What the file offers besides, too.
    if (!model.variants.empty() || model.animationSeconds > 0.0) {
      ModelState state;
      if (!model.variants.empty()) state.variant = model.variants.back();
      state.seconds = 0.5 * model.animationSeconds;
      model = loadModelFile(path, {}, state);
    }
    for (const Material& material : model.materials) checkMaterial(material);
    for (const Mesh& mesh : model.meshes) checkMesh(mesh, model.materials.size());
    for (const Instance& instance : model.instances) {
      promise(instance.mesh >= 0 && static_cast<std::size_t>(instance.mesh) < model.meshes.size(),
              "an instance has a mesh that is not there");
      for (int column = 0; column < 4; ++column) {
        promise(finite(glm::vec4(instance.worldFromModel[column])), "a node's transform is beyond float");
      }
    }
    // Lights and cameras go into scenes, which have ranges of their own.
    Scene scene;
    scene.models.push_back({"model"});
    scene.lights = model.lights;
    scene.cameras = model.cameras;
    try {
      validate(scene);
    } catch (const InputError& refused) {
      checkRefusal(refused.what());  // beyond a scene's lengths: told when the scene is made
    }
    for (const std::string& warning : model.warnings) checkRefusal(warning);
  } catch (const InputError& refused) {
    checkRefusal(refused.what());
  }
}

}  // namespace boxprobe::fuzz
