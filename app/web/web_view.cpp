// See web_view.h.
#include "app/web/web_view.h"

#include <nlohmann/json.hpp>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

namespace {

nlohmann::ordered_json tripleOf(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

}  // namespace

std::string webView(const Scene& scene, const Camera& camera) {
  nlohmann::ordered_json hidden = nlohmann::ordered_json::array(), boxes = nlohmann::ordered_json::array();
  for (const auto& [name, object] : scene.objects) {
    if (!object.visible) hidden.push_back(name);
  }
  nlohmann::ordered_json roughness = nlohmann::ordered_json::object();
  for (const auto& [name, material] : scene.materials) {
    if (material.roughness) roughness[name] = *material.roughness;
  }
  for (const Probe& probe : scene.probes) {
    const ProbeGeometry g = probeGeometry(probe, probe.origin, probe.rotationDegrees);
    boxes.push_back({{"min", tripleOf(g.boxMin)}, {"max", tripleOf(g.boxMax)}});
  }
  const nlohmann::ordered_json json = {
      {"camera",
       {{"name", camera.name},
        {"position", tripleOf(camera.position)},
        {"target", tripleOf(camera.target)},
        {"up", tripleOf(camera.up)},
        {"verticalFovDegrees", camera.verticalFovDegrees}}},
      {"hidden", hidden},
      {"technique", scene.probes.empty() ? "box+none" : techniqueId(probeTechnique(scene.probes.front()))},
      {"roughness", roughness},
      {"boxes", boxes}};
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace boxprobe
