// Properties of a model that follow from its arrays.
#include "filters/core/scene/model.h"

#include <algorithm>
#include <cmath>

namespace boxprobe {

bool MaterialFinish::tintsSpecular() const {
  return specularTint != glm::vec3(1.0f) || specularEdge != 1.0f || specularTexture.image || specularColorTexture.image;
}

std::vector<TextureUse*> MaterialFinish::textures() {
  return {&specularTexture,   &specularColorTexture, &sheenColorTexture,   &sheenRoughnessTexture,
          &anisotropyTexture, &iridescenceTexture,   &filmThicknessTexture};
}

std::vector<TextureUse*> Material::textures() {
  std::vector<TextureUse*> uses = {
      &baseColorTexture, &metallicRoughnessTexture, &normalTexture,     &occlusionTexture,    &emissiveTexture,
      &coatTexture,      &coatRoughnessTexture,     &coatNormalTexture, &transmissionTexture, &thicknessTexture};
  for (TextureUse* use : finish.textures()) uses.push_back(use);
  return uses;
}

std::vector<const TextureUse*> Material::textures() const {
  std::vector<const TextureUse*> uses;
  for (TextureUse* use : const_cast<Material*>(this)->textures()) uses.push_back(use);
  return uses;
}

float Material::reflectedIor() const {
  if (specular == 1.0f) return ior;
  const float root = (ior - 1.0f) / (ior + 1.0f);
  // A full mirror would need an infinite index: this one reaches a reflectance of 0.9999998.
  const float amplitude = std::sqrt(std::clamp(specular * root * root, 0.0f, 1.0f));
  return (1.0f + amplitude) / std::max(1.0f - amplitude, 1.0e-7f);
}

std::size_t Model::triangleCount() const {
  std::size_t count = 0;
  for (const Instance& instance : instances) {
    if (instance.mesh >= 0 && static_cast<std::size_t>(instance.mesh) < meshes.size()) {
      count += meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3;
    }
  }
  return count;
}

}  // namespace boxprobe
