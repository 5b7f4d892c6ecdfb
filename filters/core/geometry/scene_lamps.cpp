#include "filters/core/geometry/scene_lamps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>

#include "filters/core/base/field_error.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/base/one_line.h"
#include "filters/core/geometry/flat_polygons.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/core/geometry/probe_frame.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/scene/material_override.h"
#include "filters/math/cube/srgb.h"

namespace boxprobe {

namespace {

constexpr double kLampPi = 3.14159265358979323846;
// So many times the mean over all surfaces, and an object is a lamp.
constexpr double kLampStandsOut = 4.0;
// A light source belongs to a lamp from which it stands less than this away, in parts of the root of its area.
constexpr double kAtItsPlace = 0.5;
// It stands for the lamp unless that gives less than this share of its power: a spot light before a wall that glows.
constexpr double kLeastOfALight = 0.1;

double meanColor(const glm::dvec3& c) {
  return (c.x + c.y + c.z) / 3.0;
}

glm::dvec3 meanOf(const TextureUse& use) {
  if (!use.image || use.image->pixels.size() < 4) return glm::dvec3(1.0);
  glm::dvec3 sum(0.0);
  const std::size_t texels = use.image->pixels.size() / 4;
  for (std::size_t i = 0; i < texels; ++i) {
    for (int c = 0; c < 3; ++c) sum[c] += static_cast<double>(linearOfSrgb(use.image->pixels[4 * i + c]));
  }
  return sum / static_cast<double>(texels);
}

// What a surface of a material sends out by itself: mean radiance.
class MeanEmission {
 public:
  glm::dvec3 of(const Material& material) {
    const TextureUse& texture = material.unlit ? material.baseColorTexture : material.emissiveTexture;
    const glm::vec3 factor = material.unlit ? glm::vec3(material.baseColor) : material.emissive;
    glm::dvec3 light = glm::max(glm::dvec3(factor), glm::dvec3(0.0));
    if (!(meanColor(light) > 0.0) || !std::isfinite(meanColor(light))) return glm::dvec3(0.0);
    if (texture.image) {
      auto found = means_.find(texture.image.get());
      if (found == means_.end()) found = means_.emplace(texture.image.get(), meanOf(texture)).first;
      light *= found->second;
    }
    return light;
  }
  static bool textured(const Material& material) {
    return (material.unlit ? material.baseColorTexture : material.emissiveTexture).image != nullptr;
  }

 private:
  std::map<const ImageRgba8*, glm::dvec3> means_;
};

// One mesh where it stands.
struct PlacedMesh {
  std::string node;
  Material material;
  glm::dvec3 radiance{0.0};
  std::vector<glm::dvec3> positions;  // world
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double area = 0.0;
  bool hasFlat = false;  // triangles without area, which are left out
};

bool seenByBakedProbes(const Scene& scene, const std::string& node) {
  const auto found = scene.objects.find(node);
  if (found == scene.objects.end()) return true;
  return found->second.visible && found->second.seenByProbes && !found->second.dynamic;
}

std::vector<PlacedMesh> placedMeshes(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models) {
  std::vector<PlacedMesh> all;
  MeanEmission emission;
  for (std::size_t i = 0; i < models.size() && i < scene.models.size(); ++i) {
    const glm::dmat4 placement = worldFromFile(scene.models[i]);
    for (const Instance& instance : models[i]->instances) {
      if (!seenByBakedProbes(scene, instance.node)) continue;
      const Mesh& mesh = models[i]->meshes[static_cast<std::size_t>(instance.mesh)];
      const glm::dmat4 world = movedInstance(placement * instance.worldFromModel, scene, instance.node);
      PlacedMesh placed;
      placed.node = instance.node;
      if (mesh.material >= 0) placed.material = models[i]->materials[static_cast<std::size_t>(mesh.material)];
      placed.material = overriddenMaterial(std::move(placed.material), scene);
      placed.radiance = emission.of(placed.material);
      for (const glm::vec3& p : mesh.positions) {
        placed.positions.emplace_back(world * glm::dvec4(glm::dvec3(p), 1.0));
      }
      for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
        const std::array<std::uint32_t, 3> t = {mesh.indices[k], mesh.indices[k + 1], mesh.indices[k + 2]};
        if (std::max({t[0], t[1], t[2]}) >= placed.positions.size()) continue;
        const glm::dvec3 a = placed.positions[t[0]];
        const double area = 0.5 * glm::length(glm::cross(placed.positions[t[1]] - a, placed.positions[t[2]] - a));
        if (!(area > 0.0) || !std::isfinite(area)) {
          placed.hasFlat = true;
          continue;
        }
        placed.area += area;
        placed.triangles.push_back(t);
      }
      all.push_back(std::move(placed));
    }
  }
  return all;
}

double distanceToPolygon(const SceneLamp& lamp, const glm::dvec3& point) {
  const glm::dvec3 off = point - lamp.middle;
  const double height = glm::dot(off, lamp.normal);
  const std::size_t n = lamp.corners.size();
  bool above = true;
  double nearest = 1.0e300;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 a = lamp.corners[i], edge = lamp.corners[(i + 1) % n] - a;
    above &= glm::dot(glm::cross(edge, point - a), lamp.normal) >= 0.0;
    const double t = std::clamp(glm::dot(point - a, edge) / std::max(glm::dot(edge, edge), 1.0e-300), 0.0, 1.0);
    nearest = std::min(nearest, glm::length(point - a - t * edge));
  }
  return above ? std::abs(height) : nearest;
}

class LampRemarks {
 public:
  explicit LampRemarks(std::vector<std::string>& sentences) : sentences_(sentences) {}
  void say(const KeyPath& path, const std::string& sentence) {
    std::string line = oneLine(keyPathText(path) + ": " + sentence);
    if (said_.insert(line).second) sentences_.push_back(std::move(line));
  }

 private:
  std::vector<std::string>& sentences_;
  std::set<std::string> said_;
};

void addLamp(const PlacedMesh& placed, std::size_t firstGroup, std::vector<FlatPolygon>& polygons,
             std::vector<SceneLamp>& lamps) {
  for (FlatPolygon& polygon : polygons) {
    SceneLamp lamp;
    lamp.node = placed.node;
    lamp.material = placed.material.name;
    lamp.corners = withFewerCorners(std::move(polygon.corners), shading::kLampCorners);
    const glm::dvec3 area = areaVector(lamp.corners);
    lamp.area = glm::length(area);
    if (!(lamp.area > 0.0)) continue;
    lamp.normal = area / lamp.area;
    lamp.middle = polygonCentroid(lamp.corners);
    lamp.radiance = placed.radiance;
    lamp.bothSides = placed.material.doubleSided;
    lamp.power = kLampPi * lamp.area * meanColor(lamp.radiance) * (lamp.bothSides ? 2.0 : 1.0);
    lamp.group = firstGroup + polygon.component;
    lamps.push_back(std::move(lamp));
  }
}

// Of each light source the nearest lamp, if that is near enough.
void countOnce(const Scene& scene, std::vector<SceneLamp>& lamps, LampRemarks& remarks) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    if (light.type == LightType::Directional || lamps.empty()) continue;
    const auto nearest = std::min_element(lamps.begin(), lamps.end(), [&](const SceneLamp& a, const SceneLamp& b) {
      return distanceToPolygon(a, light.position) < distanceToPolygon(b, light.position);
    });
    if (nearest->light || distanceToPolygon(*nearest, light.position) > kAtItsPlace * std::sqrt(nearest->area)) {
      continue;
    }
    double power = 0.0;
    for (const SceneLamp& lamp : lamps) power += lamp.group == nearest->group ? lamp.power : 0.0;
    const double own = 4.0 * kLampPi * static_cast<double>(light.intensity) * meanColor(glm::dvec3(light.color));
    if (power < kLeastOfALight * own) continue;
    nearest->light = i;
    remarks.say({"lights", "[" + std::to_string(i) + "]"},
                "stands at the place of the lamp " + nearest->node + " and is counted once, by the lamp's shape.");
  }
}

}  // namespace

SceneLamps sceneLamps(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models) {
  SceneLamps result;
  LampRemarks remarks(result.remarks);
  const std::vector<PlacedMesh> all = placedMeshes(scene, models);
  double area = 0.0, light = 0.0;
  for (const PlacedMesh& placed : all) {
    area += placed.area;
    light += placed.area * meanColor(placed.radiance);
  }
  std::size_t left = limits::kLampTriangles, groups = 0;
  for (const PlacedMesh& placed : all) {
    const double shines = meanColor(placed.radiance);
    if (!(shines > 0.0)) continue;
    const KeyPath path = {"objects", placed.node};
    const bool stands = !placed.triangles.empty() && shines * area > kLampStandsOut * light;
    if (placed.hasFlat && placed.triangles.empty()) {
      remarks.say(path, "shines and has no area: it is no lamp.");
    }
    if (!stands) continue;
    if (placed.triangles.size() > left) {
      remarks.say(path, "with its " + std::to_string(placed.triangles.size()) +
                            " triangles lamps would have more than " + std::to_string(limits::kLampTriangles) +
                            ": it stays in the probes' maps.");
      continue;
    }
    left -= placed.triangles.size();
    std::vector<FlatPolygon> polygons = flatPolygons(placed.positions, placed.triangles);
    std::map<std::size_t, std::size_t> pieces;
    for (const FlatPolygon& polygon : polygons) ++pieces[polygon.component];
    const std::size_t before = polygons.size();
    polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                                  [&](const FlatPolygon& p) { return pieces[p.component] > kMostProbeLamps; }),
                   polygons.end());
    if (polygons.size() < before) {
      remarks.say(path, "a curved lamp, of more than " + std::to_string(kMostProbeLamps) +
                            " flat polygons, stays in the probes' maps.");
    }
    if (!polygons.empty() && MeanEmission::textured(placed.material)) {
      remarks.say(path, "the lamp shines evenly, by the mean of its texture.");
    }
    addLamp(placed, groups, polygons, result.lamps);
    groups += placed.positions.size();
  }
  countOnce(scene, result.lamps, remarks);
  std::stable_sort(result.lamps.begin(), result.lamps.end(),
                   [](const SceneLamp& a, const SceneLamp& b) { return a.power > b.power; });
  return result;
}

std::vector<std::size_t> probeLamps(const std::vector<SceneLamp>& lamps, const Probe& probe, std::size_t most) {
  const glm::dmat3 boxFromWorld = glm::transpose(rotationMatrix(probe.rotationDegrees));
  const glm::dvec3 center = probe.box.center(), half = 0.5 * probe.box.size();
  const double skin = 0.01 * glm::length(half);  // walls are thick, and lamps hang before them or stand in them
  struct Group {
    double power = 0.0;
    std::vector<std::size_t> members;
    bool meets = false;
  };
  std::map<std::size_t, Group> groups;
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const SceneLamp& lamp = lamps[i];
    if (std::find(probe.hides.begin(), probe.hides.end(), lamp.node) != probe.hides.end()) continue;
    Group& group = groups[lamp.group];
    group.power += lamp.power;
    group.members.push_back(i);
    // Does the polygon meet the box? The part of it within, cut at the six faces, is not empty.
    std::vector<glm::dvec3> part;
    for (const glm::dvec3& corner : lamp.corners) part.push_back(boxFromWorld * (corner - center));
    for (int face = 0; face < 6 && !part.empty(); ++face) {
      const int axis = face / 2;
      const double side = face % 2 == 0 ? 1.0 : -1.0;
      std::vector<glm::dvec3> within;
      for (std::size_t k = 0; k < part.size(); ++k) {
        const glm::dvec3 a = part[k], b = part[(k + 1) % part.size()];
        const double da = half[axis] + skin - side * a[axis], db = half[axis] + skin - side * b[axis];
        if (da >= 0.0) within.push_back(a);
        if ((da >= 0.0) != (db >= 0.0)) within.push_back(a + da / (da - db) * (b - a));
      }
      part = std::move(within);
    }
    if (part.empty()) continue;
    // How far the box reaches on the shining side.
    const glm::dvec3 n = boxFromWorld * lamp.normal, middle = boxFromWorld * (lamp.middle - center);
    const double reach = glm::dot(glm::abs(n), half), height = glm::dot(n, middle);
    const double before = reach - height, behind = reach + height;
    group.meets |= before > 1.0e-3 * reach || (lamp.bothSides && behind > 1.0e-3 * reach);
  }
  std::vector<const Group*> order;
  for (const auto& entry : groups) {
    if (entry.second.meets) order.push_back(&entry.second);
  }
  std::stable_sort(order.begin(), order.end(), [](const Group* a, const Group* b) { return a->power > b->power; });
  std::vector<std::size_t> chosen;
  for (const Group* group : order) {
    if (chosen.size() + group->members.size() > most) continue;
    chosen.insert(chosen.end(), group->members.begin(), group->members.end());
  }
  std::sort(chosen.begin(), chosen.end());  // lamps lie by falling power
  return chosen;
}

std::vector<std::size_t> captureLamps(const std::vector<SceneLamp>& lamps, const Probe& probe, std::size_t most) {
  struct Group {
    double strength = 0.0;
    bool hidden = false;
    std::vector<std::size_t> members;
  };
  std::map<std::size_t, Group> groups;
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const SceneLamp& lamp = lamps[i];
    Group& group = groups[lamp.group];
    const glm::dvec3 off = lamp.middle - probe.origin;
    group.strength += lamp.power / std::max({glm::dot(off, off), lamp.area, 1.0e-12});
    group.hidden |= std::find(probe.hides.begin(), probe.hides.end(), lamp.node) != probe.hides.end();
    group.members.push_back(i);
  }
  std::vector<const Group*> order;
  for (const auto& entry : groups) {
    if (!entry.second.hidden) order.push_back(&entry.second);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Group* a, const Group* b) { return a->strength > b->strength; });
  std::vector<std::size_t> chosen;
  for (const Group* group : order) {
    if (chosen.size() + group->members.size() > most) continue;
    chosen.insert(chosen.end(), group->members.begin(), group->members.end());
  }
  return chosen;
}

LampPolygon lampPolygon(const SceneLamp& lamp, const glm::dvec3& originWorld, const glm::dmat3& worldFromFrame) {
  LampPolygon polygon;
  polygon.count = static_cast<int>(std::min<std::size_t>(lamp.corners.size(), shading::kLampCorners));
  polygon.bothSides = lamp.bothSides;
  const glm::dmat3 frameFromWorld = glm::transpose(worldFromFrame);
  for (int i = 0; i < polygon.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    polygon.corners[k] = glm::vec3(frameFromWorld * (lamp.corners[k] - originWorld));
  }
  return polygon;
}

}  // namespace boxprobe
