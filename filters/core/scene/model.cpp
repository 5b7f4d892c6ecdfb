// What can be said of a model from its arrays alone.
#include "filters/core/scene/model.h"

namespace boxprobe {

std::vector<TextureUse*> Material::textures() {
  return {&baseColorTexture, &metallicRoughnessTexture, &normalTexture,     &occlusionTexture,   &emissiveTexture,
          &coatTexture,      &coatRoughnessTexture,     &coatNormalTexture, &transmissionTexture};
}

std::vector<const TextureUse*> Material::textures() const {
  std::vector<const TextureUse*> uses;
  for (TextureUse* use : const_cast<Material*>(this)->textures()) uses.push_back(use);
  return uses;
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
