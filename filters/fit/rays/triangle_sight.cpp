#include "filters/fit/rays/triangle_sight.h"

#include <glm/common.hpp>
#include <set>
#include <string>

#include "filters/core/scene/material_override.h"
#include "filters/fit/rays/triangle_rays.h"

namespace boxprobe {

namespace {

// Shines all over, evenly: no texture says that some of it does not.
bool shinesAllOver(const Model& model, const Instance& instance, const Scene& scene) {
  const Mesh& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
  if (mesh.material < 0) return false;
  const Material m = overriddenMaterial(model.materials[static_cast<std::size_t>(mesh.material)], scene);
  const glm::vec3 light = m.unlit ? glm::vec3(m.baseColor) : m.emissive;
  const TextureUse& texture = m.unlit ? m.baseColorTexture : m.emissiveTexture;
  return !texture.image && light.x + light.y + light.z > 0.0f;
}

class TriangleSight : public SightLines {
 public:
  TriangleSight(const Scene& scene, const TriangleRays::Models& models) {
    std::set<std::string> shining, others;
    for (std::size_t i = 0; i < models.size() && i < scene.models.size(); ++i) {
      for (const Instance& instance : models[i]->instances) {
        (shinesAllOver(*models[i], instance, scene) ? shining : others).insert(instance.node);
      }
    }
    // A node of several meshes, one of which shines, counts among the solid ones.
    for (const std::string& node : others) shining.erase(node);
    solid_ = std::make_unique<TriangleRays>(scene, models, SeenBy::Lamps,
                                            std::vector<std::string>(shining.begin(), shining.end()));
    if (shining.empty()) return;
    shining_ = std::make_unique<TriangleRays>(scene, models, SeenBy::Lamps,
                                              std::vector<std::string>(others.begin(), others.end()));
  }

  bool empty() const override { return solid_->empty() && (!shining_ || shining_->empty()); }
  bool blocked(const glm::dvec3& from, const glm::dvec3& to, bool shining) const override {
    return solid_->between(from, to) || (shining && shining_ && shining_->between(from, to));
  }
  std::optional<Met> first(const glm::dvec3& from, const glm::dvec3& direction) const override {
    std::optional<Met> nearest;
    for (const TriangleRays* rays : {solid_.get(), shining_.get()}) {
      if (rays == nullptr) continue;
      const auto hit = rays->first(from, direction);
      if (hit && (!nearest || hit->distance < nearest->distance))
        nearest = Met{hit->distance, hit->back, hit->normalWorld, hit->albedo, hit->emitted};
    }
    return nearest;
  }
  Box bounds() const override {
    if (!shining_ || shining_->empty())
      return solid_->empty() ? Box{glm::dvec3(0.0), glm::dvec3(0.0)} : solid_->bounds();
    if (solid_->empty()) return shining_->bounds();
    return {glm::min(solid_->bounds().min, shining_->bounds().min),
            glm::max(solid_->bounds().max, shining_->bounds().max)};
  }

 private:
  std::unique_ptr<TriangleRays> solid_, shining_;  // shining_: null if nothing shines
};

}  // namespace

std::shared_ptr<const SightLines> traceSightLines(const Scene& scene,
                                                  const std::vector<std::shared_ptr<const Model>>& models) {
  return std::make_shared<const TriangleSight>(scene, models);
}

}  // namespace boxprobe
