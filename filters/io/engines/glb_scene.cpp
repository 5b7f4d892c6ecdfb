#include "filters/io/engines/glb_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/geometry/model_placement.h"

namespace boxprobe {

namespace {

constexpr const char* kLights = "KHR_lights_punctual";

void use(Json& root, const char* extension) {
  Json& used = root["extensionsUsed"];
  if (used.is_null()) used = Json::array();
  if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
}

/// The scene that viewers open.
Json& rootNodes(Json& root) {
  Json& scenes = root["scenes"];
  if (!scenes.is_array() || scenes.empty()) {
    scenes = Json::array({Json::object()});
    root["scene"] = 0;
  }
  const std::size_t wanted =
      root.contains("scene") && root["scene"].is_number_unsigned() ? root["scene"].get<std::size_t>() : 0;
  Json& nodes = scenes[std::min(wanted, scenes.size() - 1)]["nodes"];
  if (!nodes.is_array()) nodes = Json::array();
  return nodes;
}

std::size_t addNode(Json& root, Json node) {
  root["nodes"].push_back(std::move(node));
  return root["nodes"].size() - 1;
}

/// Returns the materials as they were, by their numbers.
Json writeMaterials(Json& root, const Scene& scene) {
  Json before = Json::object();
  if (!root.contains("materials") || !root["materials"].is_array()) return before;
  for (std::size_t i = 0; i < root["materials"].size(); ++i) {
    Json& material = root["materials"][i];
    const auto found = scene.materials.find(material.value("name", std::string()));
    if (found == scene.materials.end()) continue;
    before[std::to_string(i)] = material;
    const MaterialOverride& change = found->second;
    Json& pbr = material["pbrMetallicRoughness"];
    if (change.baseColor) {
      const double alpha = pbr.contains("baseColorFactor") && pbr["baseColorFactor"].size() == 4
                               ? pbr["baseColorFactor"][3].get<double>()
                               : 1.0;
      pbr["baseColorFactor"] = glbNumbers(*change.baseColor);
      pbr["baseColorFactor"].push_back(alpha);
    }
    if (change.metallic) pbr["metallicFactor"] = *change.metallic;
    if (change.roughness) pbr["roughnessFactor"] = *change.roughness;
    if (pbr.is_null()) material.erase("pbrMetallicRoughness");  // and no more of it: a member more moves the others
    const auto put = [&](const char* extension, const char* field, const auto& value) {
      if (!value) return;
      material["extensions"][extension][field] = *value;
      use(root, extension);
    };
    put("KHR_materials_clearcoat", "clearcoatFactor", change.coat);
    put("KHR_materials_ior", "ior", change.ior);
    put("KHR_materials_transmission", "transmissionFactor", change.transmission);
    put("KHR_materials_volume", "thicknessFactor", change.thickness);
    put("KHR_materials_volume", "attenuationDistance", change.attenuationDistance);
    if (change.attenuationColor) {
      put("KHR_materials_volume", "attenuationColor", std::optional<Json>(glbNumbers(*change.attenuationColor)));
    }
    if (change.normalScale && material.contains("normalTexture"))
      material["normalTexture"]["scale"] = *change.normalScale;
    if (!change.emissive) continue;
    const glm::vec3 light = *change.emissive;
    const float strength = std::max({light.x, light.y, light.z, 1.0f});
    material["emissiveFactor"] = glbNumbers(light / strength);
    if (strength > 1.0f) {
      material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
      use(root, "KHR_materials_emissive_strength");
    } else if (material.contains("extensions")) {
      material["extensions"].erase("KHR_materials_emissive_strength");
      if (material["extensions"].empty()) material.erase("extensions");
    }
  }
  return before;
}

/// Looks along its own -Z from a place.
glm::dmat4 worldFromLook(const glm::dvec3& position, const glm::dvec3& ahead, const glm::dvec3& up) {
  const glm::dvec3 back = -glm::normalize(ahead);
  glm::dvec3 right = glm::cross(up, back);
  if (glm::length(right) < 1e-9) right = glm::cross(glm::dvec3(1.0, 0.0, 0.0), back);
  if (glm::length(right) < 1e-9) right = glm::cross(glm::dvec3(0.0, 0.0, 1.0), back);
  right = glm::normalize(right);
  return {glm::dvec4(right, 0.0), glm::dvec4(glm::cross(back, right), 0.0), glm::dvec4(back, 0.0),
          glm::dvec4(position, 1.0)};
}

std::size_t cameraNode(Json& root, const Camera& camera) {
  const double away = std::max(glm::length(camera.target - camera.position), 1e-6);
  Json json = {{"name", camera.name}};
  if (camera.parallelHeight > 0.0) {
    json["type"] = "orthographic";
    json["orthographic"] = {{"xmag", camera.parallelHeight * 8.0 / 9.0},
                            {"ymag", camera.parallelHeight * 0.5},
                            {"znear", 0.001 * away},
                            {"zfar", 1000.0 * away}};
  } else {
    json["type"] = "perspective";
    json["perspective"] = {{"yfov", glm::radians(camera.verticalFovDegrees)}, {"znear", std::min(0.001 * away, 0.01)}};
  }
  root["cameras"].push_back(std::move(json));
  return addNode(root,
                 {{"name", camera.name},
                  {"camera", root["cameras"].size() - 1},
                  {"matrix", glbMatrix(worldFromLook(camera.position, camera.target - camera.position, camera.up))}});
}

std::size_t lightNode(Json& root, const Light& light) {
  Json json = {{"color", glbNumbers(light.color)}, {"intensity", light.intensity}};
  json["type"] = light.type == LightType::Directional ? "directional"
                 : light.type == LightType::Point     ? "point"
                                                      : "spot";
  if (light.type != LightType::Directional && light.range > 0.0) json["range"] = light.range;
  if (light.type == LightType::Spot) {
    json["spot"] = {{"innerConeAngle", glm::radians(light.innerConeDegrees)},
                    {"outerConeAngle", glm::radians(light.outerConeDegrees)}};
  }
  Json& lights = root["extensions"][kLights]["lights"];
  lights.push_back(std::move(json));
  const glm::dmat4 place = worldFromLook(light.position, light.direction, glm::dvec3(0.0, 1.0, 0.0));
  return addNode(root, {{"matrix", glbMatrix(place)}, {"extensions", {{kLights, {{"light", lights.size() - 1}}}}}});
}

void removeLights(Json& root) {
  if (!root.contains("nodes")) return;
  for (Json& node : root["nodes"]) {
    if (!node.contains("extensions")) continue;
    node["extensions"].erase(kLights);
    if (node["extensions"].empty()) node.erase("extensions");
  }
  if (!root.contains("extensions")) return;
  root["extensions"].erase(kLights);
  if (root["extensions"].empty()) root.erase("extensions");
  Json& used = root["extensionsUsed"];
  if (used.is_array()) used.erase(std::remove(used.begin(), used.end(), Json(kLights)), used.end());
}

/// How far away a camera's target lies is not part of glTF.
bool sameViews(const std::vector<Camera>& a, const std::vector<Camera>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Camera& one, const Camera& other) {
    const glm::dvec3 ahead = glm::normalize(one.target - one.position);
    const double scale = 1.0 + glm::length(one.position);
    return one.name == other.name && glm::length(one.position - other.position) < 1e-6 * scale &&
           glm::length(ahead - glm::normalize(other.target - other.position)) < 1e-6 &&
           std::abs(one.verticalFovDegrees - other.verticalFovDegrees) < 1e-6 &&
           std::abs(one.parallelHeight - other.parallelHeight) < 1e-6 * scale;
  });
}

}  // namespace

Json writeSceneInto(GlbDocument& document, const Scene& scene, const Model& model,
                    const std::set<std::size_t>& countedLights) {
  Json& root = document.json;
  Json materials = writeMaterials(root, scene);
  const ModelFile& placed = scene.models.front();
  if (const glm::dmat4 world = worldFromFile(placed); world != glm::dmat4(1.0)) {
    Json children = rootNodes(root);
    if (!children.empty()) {
      const std::size_t above =
          addNode(root, {{"name", "placement"}, {"matrix", glbMatrix(world)}, {"children", children}});
      rootNodes(root) = Json::array({above});
    }
  }
  // The model's own ones stay as they are where the scene has no others.
  std::vector<Light> own = placedLights(model, placed);
  if (scene.lights != own || !countedLights.empty()) {
    removeLights(root);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      if (countedLights.count(i) != 0) continue;
      const std::size_t node = lightNode(root, scene.lights[i]);
      rootNodes(root).push_back(node);
      use(root, kLights);
    }
  }
  if (!sameViews(scene.cameras, placedCameras(model, placed))) {
    for (const Camera& camera : scene.cameras) {
      const std::size_t node = cameraNode(root, camera);
      rootNodes(root).push_back(node);
    }
  }
  return materials;
}

}  // namespace boxprobe
