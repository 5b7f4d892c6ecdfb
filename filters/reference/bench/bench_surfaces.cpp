#include "filters/reference/bench/bench_surfaces.h"

#include <algorithm>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

// Surfaces with a higher reflectance at normal incidence count as reflecting whatever their roughness: more than any
// common non-metal has.
constexpr float kLeastReflectance = 0.1f;
// Smoother non-metals count as well.
constexpr float kGlossy = 0.5f;

Material overridden(Material material, const Scene& scene) {
  const auto found = scene.materials.find(material.name);
  if (found == scene.materials.end()) return material;
  const MaterialOverride& o = found->second;
  if (o.baseColor) material.baseColor = glm::vec4(*o.baseColor, material.baseColor.a);
  material.metallic = o.metallic.value_or(material.metallic);
  material.roughness = o.roughness.value_or(material.roughness);
  material.normalScale = o.normalScale.value_or(material.normalScale);
  material.coat = o.coat.value_or(material.coat);
  return material;
}

bool reflects(const Material& m) {
  if (m.unlit) return false;
  const float metal = m.metallic * std::max({m.baseColor.r, m.baseColor.g, m.baseColor.b});
  return metal >= kLeastReflectance || m.coat > 0.0f || (m.metallic < 0.5f && m.roughness < kGlossy);
}

}  // namespace

std::map<std::string, SurfaceKind> reflectingMaterials(const Scene& scene,
                                                       const std::vector<std::shared_ptr<const Model>>& models) {
  std::map<std::string, SurfaceKind> result;
  for (const auto& model : models) {
    for (const Material& plain : model->materials) {
      const Material material = overridden(plain, scene);
      if (!reflects(material)) continue;
      const bool mapped = material.normalTexture.image && material.normalScale != 0.0f;
      result[material.name] = mapped ? SurfaceKind::NormalMapped : SurfaceKind::Smooth;
    }
  }
  return result;
}

std::map<std::string, SurfaceKind> onlyMaterials(const std::map<std::string, SurfaceKind>& materials,
                                                 const std::vector<std::string>& names) {
  if (names.empty()) return materials;
  std::map<std::string, SurfaceKind> only;
  for (const std::string& name : names) {
    const auto found = materials.find(name);
    if (found == materials.end()) {
      std::string there;
      for (const auto& [each, kind] : materials) there += (there.empty() ? "" : ", ") + each;
      throw InputError("--materials " + name + ": no reflecting material of that name; the scene has: " + there);
    }
    only.insert(*found);
  }
  return only;
}

Scene withRoughness(const Scene& scene, const std::map<std::string, SurfaceKind>& materials, double roughness) {
  Scene result = scene;
  for (const auto& [name, kind] : materials) result.materials[name].roughness = static_cast<float>(roughness);
  for (Probe& probe : result.probes) probe.bounces = 1;
  return result;
}

Scene withTechnique(Scene scene, const BenchTechnique& technique) {
  for (Probe& probe : scene.probes) {
    probe.technique = technique.id;
    probe.parameters = technique.parameters;
  }
  return scene;
}

std::vector<BenchPixel> measuredPixels(std::vector<LitPoint> picture, int width,
                                       const std::map<std::string, SurfaceKind>& materials) {
  std::vector<BenchPixel> pixels;
  for (LitPoint& e : picture) {
    const auto material = materials.find(e.surface.material);
    if (!e.hit || material == materials.end()) continue;
    float weight = 0.0f;
    for (const ProbeAtPoint& probe : e.probes) weight += probe.captured ? probe.weight : 0.0f;
    if (weight < 0.5f) continue;
    const auto index = static_cast<std::size_t>(e.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(e.x);
    pixels.push_back({index, material->second, std::move(e)});
  }
  return pixels;
}

}  // namespace boxprobe
