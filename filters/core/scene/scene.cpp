// Equality of scenes, field by field (undo, "modified" and the reader's round trip rest on it), and finding by name.
#include "filters/core/scene/scene.h"

#include <algorithm>
#include <tuple>
#include <unordered_set>

namespace boxprobe {

bool ModelFile::operator==(const ModelFile& o) const {
  return std::tie(file, translation, rotationDegrees, scale, unit, upAxis) ==
         std::tie(o.file, o.translation, o.rotationDegrees, o.scale, o.unit, o.upAxis);
}

bool SkyColor::operator==(const SkyColor& o) const {
  return color == o.color;
}

bool SkyGradient::operator==(const SkyGradient& o) const {
  return std::tie(top, horizon, ground) == std::tie(o.top, o.horizon, o.ground);
}

bool SkyImage::operator==(const SkyImage& o) const {
  return file == o.file;
}

bool Camera::operator==(const Camera& o) const {
  return std::tie(name, position, target, up, verticalFovDegrees, parallelHeight) ==
         std::tie(o.name, o.position, o.target, o.up, o.verticalFovDegrees, o.parallelHeight);
}

bool Light::operator==(const Light& o) const {
  return std::tie(type, direction, position, color, intensity, innerConeDegrees, outerConeDegrees, range, shadows,
                  angleDegrees, radius, shadowLevel, levelsPerUnit) ==
         std::tie(o.type, o.direction, o.position, o.color, o.intensity, o.innerConeDegrees, o.outerConeDegrees,
                  o.range, o.shadows, o.angleDegrees, o.radius, o.shadowLevel, o.levelsPerUnit);
}

bool MaterialOverride::operator==(const MaterialOverride& o) const {
  return std::tie(baseColor, metallic, roughness, emissive, normalScale, coat, ior, transmission, thickness,
                  attenuationDistance, attenuationColor, thin, glass) ==
         std::tie(o.baseColor, o.metallic, o.roughness, o.emissive, o.normalScale, o.coat, o.ior, o.transmission,
                  o.thickness, o.attenuationDistance, o.attenuationColor, o.thin, o.glass);
}

bool ObjectOverride::operator==(const ObjectOverride& o) const {
  return std::tie(visible, seenByProbes, dynamic, probeUsage, weights, translation, rotationDegrees) ==
         std::tie(o.visible, o.seenByProbes, o.dynamic, o.probeUsage, o.weights, o.translation, o.rotationDegrees);
}

bool PlanarMirror::operator==(const PlanarMirror& o) const {
  return std::tie(enabled, maxRoughness, resolution) == std::tie(o.enabled, o.maxRoughness, o.resolution);
}

bool Box::operator==(const Box& o) const {
  return min == o.min && max == o.max;
}

bool BlendDistance::operator==(const BlendDistance& o) const {
  return min == o.min && max == o.max;
}

bool Bevel::operator==(const Bevel& o) const {
  return radius == o.radius && fromRoughness == o.fromRoughness;
}

bool BoxOcclusion::operator==(const BoxOcclusion& o) const {
  return std::tie(multiplier, power, strength) == std::tie(o.multiplier, o.power, o.strength);
}

bool Probe::operator==(const Probe& o) const {
  return std::tie(name, origin, box, rotationDegrees, influence, nearDistance, farDistance, clear, blendDistance,
                  importance, intensity, projection, technique, parameters, faceSize, bounces, mode, image, imageLayout,
                  encoding, decode, filter, samplesPerPixel, filterSamples, hides, bevel, occlusion) ==
         std::tie(o.name, o.origin, o.box, o.rotationDegrees, o.influence, o.nearDistance, o.farDistance, o.clear,
                  o.blendDistance, o.importance, o.intensity, o.projection, o.technique, o.parameters, o.faceSize,
                  o.bounces, o.mode, o.image, o.imageLayout, o.encoding, o.decode, o.filter, o.samplesPerPixel,
                  o.filterSamples, o.hides, o.bevel, o.occlusion);
}

bool Scene::operator==(const Scene& o) const {
  return std::tie(models, sky, skyRotationDegrees, cameras, lights, materials, objects, mirrors, mirrorBudget, probes,
                  exposure) == std::tie(o.models, o.sky, o.skyRotationDegrees, o.cameras, o.lights, o.materials,
                                        o.objects, o.mirrors, o.mirrorBudget, o.probes, o.exposure);
}

std::optional<std::size_t> findProbe(const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.probes.begin(), scene.probes.end(), [&](const Probe& probe) { return probe.name == name; });
  if (found == scene.probes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - scene.probes.begin());
}

std::string unusedProbeName(const Scene& scene, const std::string& stem) {
  std::unordered_set<std::string> taken;
  for (const Probe& probe : scene.probes) taken.insert(probe.name);
  std::string base = stem.empty() ? "probe" : stem;
  if (taken.count(base) == 0) return base;
  for (std::size_t number = 2;; ++number) {  // ends: one of the first probes.size() + 1 numbers is free
    std::string name = base + " " + std::to_string(number);
    if (taken.count(name) == 0) return name;
  }
}

}  // namespace boxprobe
