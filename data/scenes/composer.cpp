#include "data/scenes/composer.h"

#include <glm/ext/matrix_transform.hpp>
#include <utility>

namespace boxprobe::scenes {
namespace {

// Pictures here are made to fit their faces: repeating would blend opposite edges into each other. Those that tile are
// given Wrap::Repeat by their scene.
TextureUse clamped(const Picture& picture) {
  return {picture, Wrap::ClampToEdge, Wrap::ClampToEdge};
}

}  // namespace

int Composer::material(Material material) {
  model_.materials.push_back(std::move(material));
  return static_cast<int>(model_.materials.size()) - 1;
}

int Composer::mesh(MeshBuilder builder, const std::string& name, int material) {
  return mesh(std::move(builder).finish(name, material));
}

int Composer::mesh(Mesh mesh) {
  model_.meshes.push_back(std::move(mesh));
  return static_cast<int>(model_.meshes.size()) - 1;
}

void Composer::place(const std::string& node, int mesh, glm::dvec3 position, double scale) {
  const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), position);
  model_.instances.push_back({node, mesh, glm::scale(moved, glm::dvec3(scale))});
}

void Composer::place(const std::string& node, int mesh, const glm::dmat4& worldFromModel) {
  model_.instances.push_back({node, mesh, worldFromModel});
}

void Composer::add(const std::string& node, MeshBuilder builder, int material) {
  place(node, mesh(std::move(builder), node, material));
}

Model Composer::finish() && {
  return std::move(model_);
}

Material perfectMirror(const std::string& name) {
  Material material;
  material.name = name;
  material.metallic = 1.0f;
  material.roughness = 0.0f;
  return material;
}

Material unlit(const std::string& name, glm::vec3 color) {
  Material material;
  material.name = name;
  material.metallic = 0.0f;
  material.roughness = 1.0f;
  material.baseColor = glm::vec4(color, 1.0f);
  material.unlit = true;
  return material;
}

Material unlit(const std::string& name, const Picture& picture) {
  Material material = unlit(name, glm::vec3(1.0f));
  material.baseColorTexture = clamped(picture);
  return material;
}

Material lamp(const std::string& name, glm::vec3 radiance) {
  Material material;
  material.name = name;
  material.baseColor = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  material.metallic = 1.0f;
  material.roughness = 1.0f;
  material.emissive = radiance;
  return material;
}

Material lit(const std::string& name, glm::vec3 color, float glow) {
  Material material;
  material.name = name;
  material.baseColor = glm::vec4(color, 1.0f);
  material.metallic = 0.0f;
  material.roughness = 0.9f;
  material.emissive = glow * color;
  return material;
}

Material lit(const std::string& name, const Picture& picture, float glow) {
  Material material = lit(name, glm::vec3(1.0f), glow);
  material.baseColorTexture = clamped(picture);
  material.emissiveTexture = clamped(picture);
  return material;
}

}  // namespace boxprobe::scenes
