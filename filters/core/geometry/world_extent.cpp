#include "filters/core/geometry/world_extent.h"

#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <optional>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/base/number_text.h"
#include "filters/core/geometry/model_placement.h"

namespace boxprobe {

namespace {

/// NaN positions are left out; the readers refuse them.
Box boundsOf(const Mesh& mesh) {
  Box bounds{glm::dvec3(mesh.positions.front()), glm::dvec3(mesh.positions.front())};
  for (const glm::vec3& position : mesh.positions) {
    bounds.min = glm::min(bounds.min, glm::dvec3(position));
    bounds.max = glm::max(bounds.max, glm::dvec3(position));
  }
  return bounds;
}

/// The coordinate farthest from 0, or NaN.
double reach(const Box& bounds, const glm::dmat4& worldFromMesh) {
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 local((corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                           (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                           (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
    const glm::dvec3 world(worldFromMesh * glm::dvec4(local, 1.0));
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(world[axis]) <= farthest)) farthest = std::abs(world[axis]);
      if (std::isnan(farthest)) return farthest;
    }
  }
  return farthest;
}

}  // namespace

void checkExtent(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models) {
  for (std::size_t i = 0; i < models.size(); ++i) {
    const glm::dmat4 placement = worldFromFile(scene.models[i]);
    std::vector<std::optional<Box>> bounds(models[i]->meshes.size());
    for (const Instance& instance : models[i]->instances) {
      const auto index = static_cast<std::size_t>(instance.mesh);
      const Mesh& mesh = models[i]->meshes[index];
      if (mesh.positions.empty()) continue;
      if (!bounds[index]) bounds[index] = boundsOf(mesh);
      const double farthest =
          reach(*bounds[index], movedInstance(placement * instance.worldFromModel, scene, instance.node));
      if (farthest <= limits::kWorldCoordinate) continue;
      char reached[40];
      std::snprintf(reached, sizeof reached, "reaches to %.3g", farthest);
      const std::string far = std::isfinite(farthest) ? reached : "is nowhere";
      throw InputError(scene.models[i].file + ": node \"" + instance.node + "\" " + far +
                       " once scaled, turned and moved; the largest coordinate supported is " +
                       numberText(limits::kWorldCoordinate) + ", so scale the model down or move it nearer");
    }
  }
}

}  // namespace boxprobe
