#include "filters/core/scene/material_override.h"

namespace boxprobe {

Material overriddenMaterial(Material material, const Scene& scene) {
  const auto it = scene.materials.find(material.name);
  if (it == scene.materials.end()) return material;
  const MaterialOverride& o = it->second;
  if (o.baseColor) material.baseColor = glm::vec4(*o.baseColor, material.baseColor.a);
  const auto take = [](auto& value, const auto& own) {
    if (own) value = *own;
  };
  take(material.metallic, o.metallic);
  take(material.roughness, o.roughness);
  take(material.emissive, o.emissive);
  take(material.normalScale, o.normalScale);
  take(material.coat, o.coat);
  take(material.ior, o.ior);
  take(material.transmission, o.transmission);
  take(material.thickness, o.thickness);
  if (o.thickness) material.thin = *o.thickness == 0.0f;
  take(material.thin, o.thin);
  take(material.attenuationDistance, o.attenuationDistance);
  take(material.attenuationColor, o.attenuationColor);
  take(material.glass, o.glass);
  return material;
}

}  // namespace boxprobe
