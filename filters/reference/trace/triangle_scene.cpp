// Placement and overrides follow filters/vtk/scene/model_actors.cpp.
#include "filters/reference/trace/triangle_scene.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "filters/core/geometry/model_placement.h"
#include "filters/core/scene/material_override.h"

namespace boxprobe {

namespace {

bool seenByAnyProbe(const Scene& scene, const std::string& node, const ObjectOverride& settings) {
  if (!settings.seenByProbes) return false;
  if (scene.probes.empty()) return !settings.dynamic;
  return std::any_of(scene.probes.begin(), scene.probes.end(), [&](const Probe& probe) {
    if (settings.dynamic && probe.mode != ProbeMode::Realtime) return false;
    return std::find(probe.hides.begin(), probe.hides.end(), node) == probe.hides.end();
  });
}

struct Placed {
  TracedObject object;
  glm::dmat4 worldFromModel;
  const Mesh* mesh;
};

void placeMesh(Placed& placed, const glm::dvec3& anchor) {
  const Mesh& mesh = *placed.mesh;
  TracedObject& object = placed.object;
  const glm::dmat3 linear(placed.worldFromModel);
  const glm::dmat3 normalMatrix = glm::transpose(glm::inverse(linear));
  for (const glm::vec3& p : mesh.positions) {
    object.positions.emplace_back(glm::dvec3(placed.worldFromModel * glm::dvec4(p, 1.0)) - anchor);
  }
  for (const glm::vec3& n : mesh.normals) object.normals.emplace_back(normalMatrix * glm::dvec3(n));
  for (const glm::vec4& t : mesh.tangents) object.tangents.emplace_back(linear * glm::dvec3(t), t.w);
  object.uv = mesh.uv;
  object.uv1 = mesh.uv1;
  object.colors = mesh.colors;
  object.indices = mesh.indices;
}

}  // namespace

TriangleScene makeTriangleScene(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models) {
  std::vector<Placed> all;
  glm::dvec3 low(1.0e300), high(-1.0e300);
  for (std::size_t i = 0; i < models.size() && i < scene.models.size(); ++i) {
    const glm::dmat4 placement = worldFromFile(scene.models[i]);
    for (const Instance& instance : models[i]->instances) {
      const Mesh& mesh = models[i]->meshes[static_cast<std::size_t>(instance.mesh)];
      Placed placed{{}, movedInstance(placement * instance.worldFromModel, scene, instance.node), &mesh};
      TracedObject& object = placed.object;
      object.node = instance.node;
      if (mesh.material >= 0) object.material = models[i]->materials[static_cast<std::size_t>(mesh.material)];
      object.material = overriddenMaterial(std::move(object.material), scene);
      // Light inside meets the back of its faces.
      object.material.doubleSided |= object.material.transmits();
      const auto found = scene.objects.find(object.node);
      const ObjectOverride settings = found != scene.objects.end() ? found->second : ObjectOverride{};
      object.inPicture = settings.visible;
      object.inProbes = seenByAnyProbe(scene, object.node, settings);
      for (const glm::vec3& p : mesh.positions) {
        const glm::dvec3 world(placed.worldFromModel * glm::dvec4(p, 1.0));
        low = glm::min(low, world);
        high = glm::max(high, world);
      }
      all.push_back(std::move(placed));
    }
  }
  TriangleScene result;
  if (low.x <= high.x) {
    result.anchorWorld = 0.5 * (low + high);
    result.radius = std::max(0.5 * glm::length(high - low), 1.0e-30);
  }
  for (Placed& placed : all) {
    placeMesh(placed, result.anchorWorld);
    result.objects.push_back(std::move(placed.object));
  }
  return result;
}

}  // namespace boxprobe
