#include "filters/vtk/probes/capture_key.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <type_traits>
#include <variant>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/scene/scene_fields.h"
#include "filters/math/shared/shared_math.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

// Increase them whenever captures or filters give other texels for the same inputs, so that older files are made again.
// A sky is not lit: where only probes' captures change, its version stays, and with it studio.levels.
constexpr int kBakeVersion = 8, kSkyVersion = 5;

std::string imageKey(const TextureUse& use, std::map<const void*, std::string>& known) {
  if (!use.image) return {};
  std::string& key = known[use.image.get()];
  if (key.empty()) {
    ContentHash hash;
    hash.add(use.image->width).add(use.image->height).addArray(use.image->pixels);
    key = hash.text();
  }
  ContentHash hash;
  hash.add(key).add(static_cast<int>(use.wrapS)).add(static_cast<int>(use.wrapT)).add(use.uvSet);
  hash.add(use.nearest ? 1 : 0).addBytes(&use.uvTransform, sizeof use.uvTransform);
  return hash.text();
}

std::string meshKey(const Mesh& mesh) {
  ContentHash hash;
  hash.addArray(mesh.positions).addArray(mesh.normals).addArray(mesh.tangents).addArray(mesh.uv).addArray(mesh.indices);
  hash.addArray(mesh.uv1).addArray(mesh.colors);
  return hash.text();
}

// Materials without a finish keep the keys they had before finishes were supported.
void addFinish(ContentHash& hash, MaterialFinish finish, std::map<const void*, std::string>& images) {
  hash.add("finish").addVector(finish.specularTint).add(finish.specularEdge).addVector(finish.sheenColor);
  hash.add(finish.sheenRoughness).add(finish.anisotropy).add(finish.anisotropyRotation).add(finish.iridescence);
  hash.add(finish.filmIor).add(finish.filmThicknessMin).add(finish.filmThicknessMax);
  for (const TextureUse* use : finish.textures()) hash.add(imageKey(*use, images));
}

std::string materialKey(const Material& m, std::map<const void*, std::string>& images) {
  ContentHash hash;
  hash.add(m.name).addVector(m.baseColor).add(m.baseColor.a).add(m.metallic).add(m.roughness).addVector(m.emissive);
  hash.add(m.normalScale).add(m.occlusionStrength).add(m.coat).add(m.coatRoughness).add(m.ior);
  if (m.specular != 1.0f) hash.add("specular").add(m.specular);
  hash.add(m.unlit ? 1 : 0).add(m.doubleSided ? 1 : 0);
  // Opaque materials keep the keys they had before glass was supported, unless they describe glass that an override of
  // the transmission would enable.
  const bool asGlass =
      !m.thin || m.thickness != 0.0f || m.attenuationDistance != 0.0f || m.attenuationColor != glm::vec3(1.0f);
  if (m.transmits() || asGlass) {
    hash.add("glass").add(m.transmission).add(m.thin ? 1 : 0).add(m.thickness).add(m.attenuationDistance);
    hash.addVector(m.attenuationColor).add("lamps pass");  // earlier keys had scattered lamps as well
  }
  hash.add(m.coatNormalScale).add(static_cast<double>(m.alphaMode)).add(m.alphaCutoff);
  for (const TextureUse* use :
       {&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.occlusionTexture, &m.emissiveTexture,
        &m.coatTexture, &m.coatRoughnessTexture, &m.coatNormalTexture, &m.transmissionTexture}) {
    hash.add(imageKey(*use, images));
  }
  if (m.thicknessTexture.image) hash.add("thickness").add(imageKey(m.thicknessTexture, images));
  if (m.finish.any()) addFinish(hash, m.finish, images);
  return hash.text();
}

void addOverride(ContentHash& hash, const MaterialOverride& m) {
  for (const auto& color : {m.baseColor, m.emissive}) {
    hash.add(color ? 1 : 0);
    if (color) hash.addVector(*color);
  }
  for (const auto& value : {m.metallic, m.roughness, m.normalScale, m.coat, m.ior, m.transmission}) {
    hash.add(value ? 1 : 0).add(value ? static_cast<double>(*value) : 0.0);
  }
  if (m.thickness) hash.add("thickness").add(static_cast<double>(*m.thickness));
  if (m.attenuationDistance) hash.add("attenuation distance").add(static_cast<double>(*m.attenuationDistance));
  if (m.attenuationColor) hash.add("attenuation").addVector(*m.attenuationColor);
  if (m.thin) hash.add("thin").add(*m.thin ? 1 : 0);
  if (m.glass) hash.add("form").add(static_cast<int>(*m.glass));
}

void addCamera(ContentHash& hash, const Probe& probe) {
  hash.add(kBakeVersion).addVector(probe.origin).add(probe.nearDistance).add(probe.farDistance).add(probe.faceSize);
  hash.add(probe.samplesPerPixel).add(static_cast<double>(probe.clear.index()));
  if (const auto* color = std::get_if<glm::vec3>(&probe.clear)) hash.addVector(*color);
  // The cube's axes are the box's. Unrotated probes keep the keys they had when all lay along the world's axes.
  if (probe.rotationDegrees != glm::dvec3(0.0)) hash.add("turned").addVector(probe.rotationDegrees);
}

// A box is outside a face's 90 degree pyramid if it is entirely beyond one of its planes or the far plane; may be true
// for a near miss. The margin covers float rounding in the projection, which could reach a texel at the edge.
bool inFrustum(const Box& boundsWorld, const Probe& probe, int face) {
  const bool turned = probe.rotationDegrees != glm::dvec3(0.0);
  const glm::dmat3 worldFromMap = turned ? rotationMatrix(probe.rotationDegrees) : glm::dmat3(1.0);
  const auto direction = [&](float u, float v) {
    return worldFromMap * glm::dvec3(shading::cubeDirection(face, u, v));
  };
  const glm::dvec3 forward = direction(0.0f, 0.0f);
  const glm::dvec3 s = direction(1.0f, 0.0f) - forward;
  const glm::dvec3 t = direction(0.0f, 1.0f) - forward;
  const glm::dvec3 center = boundsWorld.center() - probe.origin;
  const glm::dvec3 half = 0.5 * boundsWorld.size();
  const double margin = 1.0e-4 * (glm::length(center) + glm::length(half));
  const auto beyond = [&](const glm::dvec3& inward) {
    return glm::dot(center, inward) + glm::dot(half, glm::abs(inward)) < -margin;
  };
  const double nearest = glm::dot(center, forward) - glm::dot(half, glm::abs(forward));
  if (nearest > probe.farDistance + margin) return false;
  return !beyond(forward) && !beyond(forward + s) && !beyond(forward - s) && !beyond(forward + t) &&
         !beyond(forward - t);
}

// Of a field. Numbers, truth and texts by name, vectors by their components.
void addValue(ContentHash& hash, std::monostate) {
  hash.add("none");
}
template <typename Number, typename = std::enable_if_t<std::is_arithmetic_v<Number>>>
void addValue(ContentHash& hash, Number value) {
  hash.add(static_cast<double>(value));
}
void addValue(ContentHash& hash, const std::string& text) {
  hash.add(text);
}
void addValue(ContentHash& hash, const glm::dvec2& v) {
  hash.add(v.x).add(v.y);
}
void addValue(ContentHash& hash, const glm::vec3& v) {
  hash.addVector(v);
}
void addValue(ContentHash& hash, const glm::dvec3& v) {
  hash.addVector(v);
}
void addValue(ContentHash& hash, const std::vector<std::string>& names) {
  for (const std::string& name : names) hash.add(name);
}
void addValue(ContentHash& hash, const Box& box) {
  hash.addVector(box.min).addVector(box.max);
}
void addValue(ContentHash& hash, const BlendDistance& distance) {
  hash.addVector(distance.min).addVector(distance.max);
}
void addValue(ContentHash& hash, const Bevel& bevel) {
  hash.add(bevel.radius).add(bevel.fromRoughness);
}
void addValue(ContentHash& hash, const BoxOcclusion& occlusion) {
  hash.add(occlusion.multiplier).add(occlusion.power).add(occlusion.strength);
}
void addValue(ContentHash& hash, const ProbeLattice& lattice) {
  hash.add(lattice.used ? lattice.spacing : 0.0);
}
void addValue(ContentHash& hash, const Clear& clear) {
  hash.add(static_cast<double>(clear.index()));
  if (const auto* color = std::get_if<glm::vec3>(&clear)) hash.addVector(*color);
}
void addValue(ContentHash& hash, const std::map<std::string, ParameterValue>& parameters) {
  for (const auto& [name, value] : parameters) {
    hash.add(name);
    std::visit([&](const auto& held) { addValue(hash, held); }, value);
  }
}

template <typename Meets>
std::vector<std::size_t> objectsThatMeet(const CaptureWorld& world, const Probe& probe, const Meets& meets) {
  std::vector<std::size_t> found;
  world.tree.search(meets, [&](std::size_t i) {
    if (captureShows(probe, world.objects[i])) found.push_back(i);
  });
  std::sort(found.begin(), found.end());
  return found;
}

template <typename Meets>
std::vector<std::size_t> addShown(ContentHash& hash, const CaptureWorld& world, const Probe& probe,
                                  const Meets& meets) {
  std::vector<std::size_t> lighting;
  // A hidden lamp does not light what is captured, whether or not the capture would show it.
  if (world.lattices) {
    for (const std::string& hidden : std::set<std::string>(probe.hides.begin(), probe.hides.end())) hash.add(hidden);
  }
  hash.add(world.lights);
  // Captures of an open probe exclude the sky's light, which is added when the probe is sampled, unless lattices bring
  // it.
  if (!std::holds_alternative<ClearToOpen>(probe.clear)) {
    hash.add(world.sky);
  } else if (world.several(probe) && world.nodesBringSky(probe)) {
    hash.add(world.latticeSky);
  }
  for (const std::size_t i : objectsThatMeet(world, probe, meets)) {
    const CaptureObject& object = world.objects[i];
    hash.add(object.key);
    // Lamps as shapes light what a probe reaches: without one it is captured without their light.
    if (world.lattices && !object.unlit && object.probes.empty()) hash.add("beyond probes");
    lighting.insert(lighting.end(), object.probes.begin(), object.probes.end());
  }
  std::sort(lighting.begin(), lighting.end());
  lighting.erase(std::unique(lighting.begin(), lighting.end()), lighting.end());
  return lighting;
}

}  // namespace

std::vector<std::string> objectContentKeys(const std::vector<std::shared_ptr<const Model>>& models,
                                           std::size_t modelCount) {
  std::vector<std::string> keys;
  std::map<const void*, std::string> images, meshes;
  for (std::size_t i = 0; i < models.size() && i < modelCount; ++i) {
    for (const Instance& instance : models[i]->instances) {
      const Mesh& mesh = models[i]->meshes[static_cast<std::size_t>(instance.mesh)];
      std::string& key = meshes[&mesh];
      if (key.empty()) {
        key = meshKey(mesh);
        if (mesh.material >= 0)
          key += materialKey(models[i]->materials[static_cast<std::size_t>(mesh.material)], images);
      }
      keys.push_back(key);
    }
  }
  return keys;
}

CaptureWorld captureWorld(const Scene& scene, const std::vector<PlacedObject>& objects, const std::string& skyPixels,
                          const ProbeIndex& probes) {
  CaptureWorld world;
  world.sky = skyKey(scene, skyPixels);
  ContentHash lights;
  for (const Light& light : scene.lights) {
    lights.add(static_cast<double>(light.type)).addVector(light.direction).addVector(light.position);
    lights.addVector(light.color).add(light.intensity);
    lights.add(light.innerConeDegrees).add(light.outerConeDegrees).add(light.range);
    // The second bounce shows what the first one's coverage leaves of it, and the glass in it is looked for at a
    // capture.
    if (light.shadows != LightShadows::None) {
      lights.add(static_cast<double>(light.shadows)).add(light.angleDegrees).add(light.radius);
      lights.add(static_cast<double>(light.shadowLevel)).add(light.levelsPerUnit);
    }
  }
  if (scene.energy == Energy::Multiple) lights.add("multiple");
  world.lights = lights.text();
  std::vector<Box> bounds;
  for (const PlacedObject& placed : objects) {
    CaptureObject object;
    object.node = placed.node;
    object.seenByProbes = placed.seenByProbes;
    object.dynamic = placed.dynamic;
    object.unlit = placed.unlit;
    object.boundsWorld = placed.boundsWorld;
    ContentHash hash;
    hash.add(placed.contentKey).addBytes(&placed.worldFromModel, sizeof placed.worldFromModel);
    if (const auto it = scene.materials.find(placed.materialName); it != scene.materials.end()) {
      addOverride(hash, it->second);
    }
    // Which of probes and sky light it, also in captures.
    if (const auto it = scene.objects.find(placed.node); it != scene.objects.end()) {
      const ObjectOverride& settings = it->second;
      if (settings.probeUsage != ProbeUsage::BlendAndSky) hash.add("usage").add(static_cast<int>(settings.probeUsage));
      if (settings.weights != WeightMode::Pixel) hash.add("weights").add(static_cast<int>(settings.weights));
    }
    object.key = hash.text();
    if (!placed.unlit) object.probes = probes.meeting(object.boundsWorld);
    bounds.push_back(object.boundsWorld);
    world.objects.push_back(std::move(object));
  }
  world.tree = BoxTree(bounds);
  return world;
}

std::string skyKey(const Scene& scene, const std::string& skyPixels) {
  ContentHash hash;
  hash.add("sky").add(kSkyVersion).add(static_cast<double>(scene.sky.index()));
  if (const auto* gradient = std::get_if<SkyGradient>(&scene.sky)) {
    hash.addVector(gradient->top).addVector(gradient->horizon).addVector(gradient->ground);
  } else if (const auto* color = std::get_if<SkyColor>(&scene.sky)) {
    hash.addVector(color->color);
  } else {
    hash.add(skyPixels);
    // Other skies do not depend on their rotation.
    if (scene.skyRotationDegrees != 0.0) hash.add(scene.skyRotationDegrees);
  }
  return hash.text();
}

std::string imageContentKey(const ImageRgbaF& image) {
  return ContentHash().add(image.width).add(image.height).addArray(image.pixels).text();
}

std::string importKey(const Probe& probe, const CubeMap& picture) {
  ContentHash hash;
  hash.add("import")
      .add(kBakeVersion)
      .add(static_cast<double>(probe.filter))
      .add(probe.filterSamples)
      .add(picture.faceSize());
  const auto texels = static_cast<std::size_t>(picture.faceSize()) * static_cast<std::size_t>(picture.faceSize());
  for (int face = 0; face < 6; ++face) hash.addBytes(picture.face(0, face), texels * 4 * sizeof(float));
  return hash.text();
}

std::string drawnKey(const Probe& probe) {
  ContentHash hash;
  for (const FieldRow<Probe>& row : probeFields()) {
    const auto changes = [&](bool Changes::*kind) {
      return std::find(row.changes.begin(), row.changes.end(), kind) != row.changes.end();
    };
    if (row.get == nullptr || !(changes(&Changes::probeShape) || changes(&Changes::probeTechnique))) continue;
    hash.add(row.key);
    std::visit([&](const auto& value) { addValue(hash, value); }, row.get(probe));
  }
  return hash.text();
}

bool captureShows(const Probe& probe, const CaptureObject& object) {
  if (!object.seenByProbes || (object.dynamic && probe.mode != ProbeMode::Realtime)) return false;
  return std::find(probe.hides.begin(), probe.hides.end(), object.node) == probe.hides.end();
}

std::vector<std::size_t> objectsInFace(const CaptureWorld& world, const Probe& probe, int face) {
  return objectsThatMeet(world, probe, [&](const Box& box) { return inFrustum(box, probe, face); });
}

CaptureView faceView(const CaptureWorld& world, const Probe& probe, int face) {
  ContentHash hash;
  hash.add("face").add(face);
  addCamera(hash, probe);
  CaptureView view;
  view.lighting = addShown(hash, world, probe, [&](const Box& box) { return inFrustum(box, probe, face); });
  view.key = hash.text();
  return view;
}

CaptureView probeView(const CaptureWorld& world, const Probe& probe) {
  ContentHash hash;
  hash.add("probe").add(static_cast<double>(probe.filter)).add(probe.filterSamples);
  addCamera(hash, probe);
  CaptureView view;
  view.lighting = addShown(hash, world, probe, [&](const Box& box) {
    for (int face = 0; face < 6; ++face) {
      if (inFrustum(box, probe, face)) return true;
    }
    return false;
  });
  view.key = hash.text();
  return view;
}

}  // namespace boxprobe
