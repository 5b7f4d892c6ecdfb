#include "filters/core/geometry/world_extent.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
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

/// A triangle's bounds in the world, and whose it is.
struct BoundedTriangle {
  Box bounds;
  glm::dvec3 middle{0.0};
  std::size_t model = 0;
  const Instance* instance = nullptr;
};

/// One in `stride` triangles, without those that have no area: no ray hits them.
std::vector<BoundedTriangle> sampledTriangles(const Scene& scene,
                                              const std::vector<std::shared_ptr<const Model>>& models,
                                              std::size_t stride) {
  std::vector<BoundedTriangle> sample;
  std::uint32_t random = 1;
  std::size_t number = 0, wanted = 0;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const glm::dmat4 placement = worldFromFile(scene.models[i]);
    for (const Instance& instance : models[i]->instances) {
      const Mesh& mesh = models[i]->meshes[static_cast<std::size_t>(instance.mesh)];
      const std::size_t triangles = mesh.indices.size() / 3;
      if (wanted < number + triangles) {
        const glm::dmat4 worldFromMesh = movedInstance(placement * instance.worldFromModel, scene, instance.node);
        while (wanted < number + triangles) {
          glm::dvec3 corner[3];
          for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3& position = mesh.positions[mesh.indices[3 * (wanted - number) + k]];
            corner[k] = glm::dvec3(worldFromMesh * glm::dvec4(glm::dvec3(position), 1.0));
          }
          if (glm::cross(corner[1] - corner[0], corner[2] - corner[0]) != glm::dvec3(0.0)) {
            const Box bounds{glm::min(glm::min(corner[0], corner[1]), corner[2]),
                             glm::max(glm::max(corner[0], corner[1]), corner[2])};
            const glm::dvec3 middle = (corner[0] + corner[1] + corner[2]) / 3.0;
            // Rounded, it may leave the plane of a flat one.
            sample.push_back({bounds, glm::clamp(middle, bounds.min, bounds.max), i, &instance});
          }
          random = random * 1664525u + 1013904223u;  // no pattern of a file meets a fixed step
          wanted += stride == 1 ? 1 : 1 + (random >> 8) % (2 * stride - 1);
        }
      }
      number += triangles;
    }
  }
  return sample;
}

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

void checkOverlap(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models) {
  constexpr std::size_t kPlaces = 64, kSampled = 65536;
  std::size_t triangles = 0;
  for (const auto& model : models) {
    for (const Instance& instance : model->instances) {
      triangles += model->meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3;
    }
  }
  if (triangles <= limits::kTrianglesInOnePlace) return;
  const std::size_t stride = (triangles - 1) / kSampled + 1;
  const std::vector<BoundedTriangle> sample = sampledTriangles(scene, models, stride);
  for (std::size_t place = 0; place < kPlaces && !sample.empty(); ++place) {
    const BoundedTriangle& at = sample[place * sample.size() / kPlaces];
    std::size_t here = 0;
    for (const BoundedTriangle& each : sample) {
      if (glm::all(glm::lessThanEqual(each.bounds.min, at.middle)) &&
          glm::all(glm::lessThanEqual(at.middle, each.bounds.max))) {
        here += stride;
      }
    }
    if (here <= limits::kTrianglesInOnePlace) continue;
    throw InputError(scene.models[at.model].file + ": node \"" + at.instance->node + "\" lies where about " +
                     numberText(static_cast<double>(here)) + " triangles overlap; at most " +
                     numberText(static_cast<double>(limits::kTrianglesInOnePlace)) +
                     " can be traced in one place, so merge or remove doubled geometry");
  }
}

}  // namespace

void checkGeometry(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models) {
  checkExtent(scene, models);
  checkOverlap(scene, models);
}

}  // namespace boxprobe
