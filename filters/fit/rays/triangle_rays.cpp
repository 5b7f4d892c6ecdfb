// See triangle_rays.h.
#include "filters/fit/rays/triangle_rays.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <map>
#include <string>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/embree.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/core/scene/material_override.h"
#include "filters/math/cube/srgb.h"

namespace boxprobe {

namespace {

/// An instance with its placement in the scene.
struct PlacedMesh {
  const Mesh* mesh = nullptr;
  const Material* material = nullptr;  ///< null: the default material
  glm::dmat4 worldFromMesh{1.0};
  bool unlit = false, calledSky = false;
  bool lightsProbes = true;  ///< what probes do not see gives them no light of its own
  Box bounds;                ///< world
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Box nothing() {
  return {glm::dvec3(kInfinity), glm::dvec3(-kInfinity)};
}

void include(Box& box, const glm::dvec3& position) {
  if (!std::isfinite(position.x + position.y + position.z)) return;
  box.min = glm::min(box.min, position);
  box.max = glm::max(box.max, position);
}

Box united(const Box& a, const Box& b) {
  return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

Box worldBounds(const Mesh& mesh, const glm::dmat4& worldFromMesh) {
  Box bounds = nothing();
  for (const glm::vec3& position : mesh.positions) {
    include(bounds, glm::dvec3(worldFromMesh * glm::dvec4(glm::dvec3(position), 1.0)));
  }
  return bounds;
}

/// Removes the largest mesh, again and again, as long as it may be a sky dome: unlit or named as a sky, and more than
/// twice as large as all others together, apart from those named as skies or clouds.
void leaveOutSkyDomes(std::vector<PlacedMesh>& placed) {
  const auto extent = [](const Box& box) { return glm::length(box.size()); };
  while (placed.size() > 1) {
    const auto largest = std::max_element(placed.begin(), placed.end(), [&](const PlacedMesh& a, const PlacedMesh& b) {
      return extent(a.bounds) < extent(b.bounds);
    });
    Box others = nothing();
    for (auto each = placed.begin(); each != placed.end(); ++each) {
      if (each != largest && !each->calledSky) others = united(others, each->bounds);
    }
    const bool maySky = largest->unlit || largest->calledSky;
    if (!maySky || others.min.x > others.max.x || extent(largest->bounds) <= 2.0 * extent(others)) return;
    placed.erase(largest);
  }
}

/// True for "sky", "SkyDome", "clouds.001".
bool namesSky(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.find("sky") != std::string::npos || name.find("cloud") != std::string::npos;
}

bool hidesWhatIsBehind(const Mesh& mesh, const Model& model) {
  if (mesh.material < 0) return true;
  const Material& material = model.materials[static_cast<std::size_t>(mesh.material)];
  return !material.transmits() && material.alphaMode != AlphaMode::Blend;
}

bool seen(const ObjectOverride& object, SeenBy seenBy) {
  switch (seenBy) {
    case SeenBy::Eyes:
      return object.visible;
    case SeenBy::Probes:
      return object.seenByProbes && !object.dynamic;
    case SeenBy::Lamps:
      return object.visible && !object.dynamic;
  }
  return false;
}

std::vector<PlacedMesh> placedMeshes(const Scene& scene, const TriangleRays::Models& models, SeenBy seenBy,
                                     const std::vector<std::string>& hidden) {
  std::vector<PlacedMesh> placed;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const glm::dmat4 placement = worldFromFile(scene.models[i]);
    for (const Instance& instance : models[i]->instances) {
      const Mesh& mesh = models[i]->meshes[static_cast<std::size_t>(instance.mesh)];
      const auto object = scene.objects.find(instance.node);
      if (object != scene.objects.end() && !seen(object->second, seenBy)) continue;
      if (std::find(hidden.begin(), hidden.end(), instance.node) != hidden.end()) continue;
      if (mesh.indices.size() < 3 || !hidesWhatIsBehind(mesh, *models[i])) continue;
      const glm::dmat4 worldFromMesh = movedInstance(placement * instance.worldFromModel, scene, instance.node);
      const Material* material =
          mesh.material < 0 ? nullptr : &models[i]->materials[static_cast<std::size_t>(mesh.material)];
      const bool unlit = material != nullptr && material->unlit;
      const bool calledSky = namesSky(instance.node) || (material != nullptr && namesSky(material->name));
      const bool lightsProbes = object == scene.objects.end() || object->second.seenByProbes;
      placed.push_back(
          {&mesh, material, worldFromMesh, unlit, calledSky, lightsProbes, worldBounds(mesh, worldFromMesh)});
    }
  }
  leaveOutSkyDomes(placed);
  return placed;
}

/// The mean of one channel of a texture, from a few hundred texels; 1 without a texture.
double meanOf(const TextureUse& texture, std::size_t channel) {
  if (!texture.image || texture.image->pixels.size() < 4) return 1.0;
  const std::vector<std::uint8_t>& pixels = texture.image->pixels;
  const std::size_t texels = pixels.size() / 4, stride = std::max<std::size_t>(1, texels / 509);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < texels; i += stride, count += 1.0) sum += pixels[4 * i + channel] / 255.0;
  return sum / count;
}

struct ReflectingLook {
  double roughness = 0.0, reflectance = 0.0;
  glm::vec3 albedo{0.0f}, emitted{0.0f};
  bool bothSides = false;
};

/// The linear mean of a texture's colours, from a few hundred texels; white without a texture.
glm::vec3 meanColorOf(const TextureUse& texture) {
  if (!texture.image || texture.image->pixels.size() < 4) return glm::vec3(1.0f);
  const std::vector<std::uint8_t>& pixels = texture.image->pixels;
  const std::size_t texels = pixels.size() / 4, stride = std::max<std::size_t>(1, texels / 509);
  glm::vec3 sum(0.0f);
  float count = 0.0f;
  for (std::size_t i = 0; i < texels; i += stride, count += 1.0f) {
    for (int c = 0; c < 3; ++c) sum[c] += linearOfSrgb(pixels[4 * i + static_cast<std::size_t>(c)]);
  }
  return sum / count;
}

/// With the scene's overrides; of a coated material the coat.
ReflectingLook reflectingLook(const Material& original, const Scene& scene) {
  const Material material = overriddenMaterial(original, scene);
  const glm::vec3 baseColor = glm::vec3(material.baseColor) * meanColorOf(material.baseColorTexture);
  if (material.unlit) return {1.0, 0.0, glm::vec3(0.0f), baseColor, material.doubleSided};
  const double ior = material.reflectedIor(), dielectric = std::pow((ior - 1.0) / (ior + 1.0), 2.0);
  const double metallic = material.metallic * meanOf(material.metallicRoughnessTexture, 2);
  const double color = (material.baseColor.x + material.baseColor.y + material.baseColor.z) / 3.0;
  ReflectingLook look{material.roughness * meanOf(material.metallicRoughnessTexture, 1),
                      dielectric + metallic * (color - dielectric), glm::min(baseColor, glm::vec3(1.0f)),
                      material.emissive * meanColorOf(material.emissiveTexture), material.doubleSided};
  if (material.coat > 0.0f && material.coatRoughness < look.roughness) {
    look.roughness = material.coatRoughness;
    look.reflectance = std::max(0.04 * material.coat, look.reflectance);
  }
  return look;
}

constexpr std::size_t kMostPositions = 4'000'000'000;  // Embree counts them in 32 bits

/// The weighted quantile of `values`, which are reordered. O(n) on average.
double quantile(std::vector<std::pair<float, float>>& values, double share) {
  if (values.empty()) return 0.0;
  double all = 0.0, below = 0.0;
  for (const auto& value : values) all += value.second;
  auto first = values.begin(), last = values.end();
  while (last - first > 1) {
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last);
    double half = 0.0;
    for (auto it = first; it != middle; ++it) half += it->second;
    if (below + half >= share * all) {
      last = middle;
    } else {
      below += half;
      first = middle;
    }
  }
  return first->first;
}

}  // namespace

struct TriangleRays::Structure {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Structure() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  /// All meshes as one geometry, with positions relative to `anchor`. The reader has turned over the triangles of a
  /// mirrored instance. Embree's builder for many geometries aborts the program if all of them are flat.
  void fill(const std::vector<PlacedMesh>& placed, const glm::dvec3& anchor, std::size_t positionCount,
            std::size_t triangleCount) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_LOW);
    const TracedTriangles space = newTriangles(geometry, positionCount, triangleCount);
    if (space.positions != nullptr && space.corners != nullptr) {
      glm::vec3* position = space.positions;
      std::uint32_t* corner = space.corners;
      std::uint32_t begin = 0;
      for (const PlacedMesh& each : placed) {
        for (const glm::vec3& p : each.mesh->positions) {
          *position++ = glm::vec3(glm::dvec3(each.worldFromMesh * glm::dvec4(glm::dvec3(p), 1.0)) - anchor);
        }
        const std::vector<std::uint32_t>& indices = each.mesh->indices;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
          for (std::size_t k = 0; k < 3; ++k) *corner++ = begin + indices[i + k];
        }
        begin += static_cast<std::uint32_t>(each.mesh->positions.size());
      }
      leaveOutWithoutArea(space, triangleCount);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
};

TriangleRays::TriangleRays(const Scene& scene, const Models& models, SeenBy seenBy,
                           const std::vector<std::string>& hidden)
    : structure_(std::make_unique<Structure>()) {
  const std::vector<PlacedMesh> placed = placedMeshes(scene, models, seenBy, hidden);
  std::map<const Material*, ReflectingLook> known;
  bounds_ = nothing();
  std::size_t positions = 0;
  for (const PlacedMesh& each : placed) {
    const auto [look, added] = known.try_emplace(each.material);
    if (added) look->second = reflectingLook(each.material != nullptr ? *each.material : Material{}, scene);
    looks_.push_back({static_cast<std::uint32_t>(triangles_), look->second.roughness, look->second.reflectance,
                      look->second.albedo, each.lightsProbes ? look->second.emitted : glm::vec3(0.0f),
                      look->second.bothSides});
    triangles_ += each.mesh->indices.size() / 3;
    positions += each.mesh->positions.size();
    bounds_ = united(bounds_, each.bounds);
  }
  if (positions > kMostPositions) throw WorkError("the model has more than 4,000 million vertices");
  if (!(bounds_.min.x <= bounds_.max.x)) triangles_ = 0;
  if (triangles_ == 0) {
    bounds_ = core_ = {glm::dvec3(0.0), glm::dvec3(0.0)};
    return;
  }
  anchor_ = bounds_.center();

  Structure& s = *structure_;
  s.device = newRayDevice();
  s.scene = rtcNewScene(s.device);
  rtcSetSceneFlags(s.scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(s.scene, RTC_BUILD_QUALITY_LOW);
  // A few tens of thousands of triangles are enough to locate the surfaces.
  constexpr std::size_t kLooked = 30000;
  const std::size_t stride = std::max<std::size_t>(1, triangles_ / kLooked);
  std::array<std::vector<std::pair<float, float>>, 3> along;
  std::size_t triangle = 0;
  for (const PlacedMesh& each : placed) {
    const std::vector<std::uint32_t>& indices = each.mesh->indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      if (triangle++ % stride != 0) continue;
      glm::dvec3 corner[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 position(each.mesh->positions[indices[i + k]]);
        corner[k] = glm::dvec3(each.worldFromMesh * glm::dvec4(position, 1.0)) - anchor_;
      }
      const double weight = std::sqrt(glm::length(glm::cross(corner[1] - corner[0], corner[2] - corner[0])));
      if (!std::isfinite(weight)) continue;
      for (const glm::dvec3& c : corner) {
        for (int axis = 0; axis < 3; ++axis) {
          along[static_cast<std::size_t>(axis)].emplace_back(static_cast<float>(c[axis]), static_cast<float>(weight));
        }
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    auto& values = along[static_cast<std::size_t>(axis)];
    core_.min[axis] = anchor_[axis] + quantile(values, 0.01);
    core_.max[axis] = anchor_[axis] + quantile(values, 0.99);
  }
  if (!glm::any(glm::greaterThan(core_.size(), glm::dvec3(0.0)))) core_ = bounds_;  // all triangles are degenerate
  s.fill(placed, anchor_, positions, triangles_);
  rtcCommitScene(s.scene);
  checkCommitted(s.device, "the model");
}

TriangleRays::~TriangleRays() = default;

std::optional<SurfaceHit> TriangleRays::first(const glm::dvec3& origin, const glm::dvec3& direction) const {
  if (empty()) return std::nullopt;
  const glm::vec3 from(origin - anchor_), along(direction);
  RTCRayHit query;
  query.ray = {from.x, from.y, from.z, 0.0f, along.x, along.y, along.z, 0.0f, std::numeric_limits<float>::infinity(),
               ~0u,    0u,     0u};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersectOne(structure_->scene, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const glm::vec3 normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
  const float length = glm::length(normal);
  const bool back = glm::dot(normal, along) > 0.0f;
  const glm::dvec3 unit = length > 0.0f ? glm::dvec3(normal / length) : -direction;
  const auto after = std::upper_bound(looks_.begin(), looks_.end(), query.hit.primID,
                                      [](std::uint32_t id, const Look& look) { return id < look.firstTriangle; });
  const Look& look = *std::prev(after);
  const glm::vec3 emitted = back && !look.bothSides ? glm::vec3(0.0f) : look.emitted;
  return SurfaceHit{query.ray.tfar, back, back ? -unit : unit, look.roughness, look.reflectance, look.albedo, emitted};
}

bool TriangleRays::between(const glm::dvec3& from, const glm::dvec3& to) const {
  if (empty()) return false;
  const glm::vec3 start(from - anchor_), way(to - from);
  RTCRay ray{start.x, start.y, start.z, 0.0f, way.x, way.y, way.z, 0.0f, 1.0f, ~0u, 0u, 0u};
  return occludedOne(structure_->scene, &ray);
}

}  // namespace boxprobe
