#include "filters/core/geometry/mirror_plane.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "filters/core/base/field_error.h"
#include "filters/core/base/number_text.h"
#include "filters/core/geometry/model_placement.h"

namespace boxprobe {

namespace {

/// How far geometry may deviate from the plane, relative to its size: above the rounding of single-precision positions,
/// below what moves a reflected edge by a pixel.
constexpr double kFlat = 1.0e-4;

/// A node's triangles in the world, and whether they are double-sided.
struct Surface {
  std::vector<std::array<glm::dvec3, 3>> triangles;
  bool bothSides = true;
};

Surface surfaceOf(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                  const std::string& node) {
  Surface surface;
  for (std::size_t i = 0; i < models.size() && i < scene.models.size(); ++i) {
    const glm::dmat4 placement = worldFromFile(scene.models[i]);
    for (const Instance& instance : models[i]->instances) {
      if (instance.node != node) continue;
      const Mesh& mesh = models[i]->meshes[static_cast<std::size_t>(instance.mesh)];
      const glm::dmat4 world = movedInstance(placement * instance.worldFromModel, scene, node);
      for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
        std::array<glm::dvec3, 3> t;
        for (std::size_t c = 0; c < 3; ++c) {
          t[c] = glm::dvec3(world * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[k + c]]), 1.0));
        }
        surface.triangles.push_back(t);
      }
      surface.bothSides &=
          mesh.material >= 0 && models[i]->materials[static_cast<std::size_t>(mesh.material)].doubleSided;
    }
  }
  return surface;
}

}  // namespace

std::optional<MirrorPlane> mirrorPlane(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                                       const std::string& node) {
  const Surface surface = surfaceOf(scene, models, node);
  if (surface.triangles.empty()) return std::nullopt;
  const auto fail = [&node](const std::string& reason) { throw FieldError({"mirrors", node}, reason); };
  MirrorPlane plane;
  plane.bothSides = surface.bothSides;
  glm::dvec3 sum(0.0), low(std::numeric_limits<double>::max()), high(-low);
  double area = 0.0;
  for (const auto& t : surface.triangles) {
    const glm::dvec3 twice = glm::cross(t[1] - t[0], t[2] - t[0]);
    sum += twice;
    area += glm::length(twice);
    for (const glm::dvec3& p : t) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  const double size = glm::length(high - low);
  plane.center = 0.5 * (low + high);
  // Normals of triangles that face all ways cancel out; those of one plane add up.
  if (!(area > 0.0) || glm::length(sum) < 0.5 * area) {
    fail("is not a planar mirror: its triangles face different ways; name a node that is one flat surface");
  }
  plane.normal = glm::normalize(sum);
  // The middle of the bounds need not lie in the plane: that of a tilted triangle does not.
  double below = std::numeric_limits<double>::max(), above = -below;
  for (const auto& t : surface.triangles) {
    for (const glm::dvec3& p : t) {
      const double height = glm::dot(p - plane.center, plane.normal);
      below = std::min(below, height);
      above = std::max(above, height);
    }
  }
  plane.center += 0.5 * (below + above) * plane.normal;
  const double off = 0.5 * (above - below);
  if (off > kFlat * size) {
    fail("is not planar: its geometry stands " + numberText(static_cast<float>(off)) +
         " off its plane, and may no more than " + numberText(static_cast<float>(kFlat * size)) +
         "; name a node that is one flat surface");
  }
  // Along the longest edge: for a rectangle, one of its sides.
  glm::dvec3 along(0.0);
  for (const auto& t : surface.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const glm::dvec3 edge = t[(c + 1) % 3] - t[c];
      // A quad's diagonals are longer than its sides: only legs at a right angle count.
      const glm::dvec3 other = t[(c + 2) % 3] - t[(c + 1) % 3];
      const bool square = std::fabs(glm::dot(edge, other)) < 1.0e-3 * glm::length(edge) * glm::length(other);
      const bool longer = glm::dot(edge, edge) > glm::dot(along, along);
      if (square && longer) along = edge;
    }
  }
  if (along == glm::dvec3(0.0)) along = surface.triangles[0][1] - surface.triangles[0][0];
  const glm::dvec3 u = glm::normalize(along), v = glm::cross(plane.normal, u);
  double u0 = 1.0e300, u1 = -1.0e300, v0 = 1.0e300, v1 = -1.0e300;
  for (const auto& t : surface.triangles) {
    for (const glm::dvec3& p : t) {
      const double a = glm::dot(p - plane.center, u), b = glm::dot(p - plane.center, v);
      u0 = std::min(u0, a), u1 = std::max(u1, a), v0 = std::min(v0, b), v1 = std::max(v1, b);
    }
  }
  plane.corners = {plane.center + u0 * u + v0 * v, plane.center + u1 * u + v0 * v, plane.center + u1 * u + v1 * v,
                   plane.center + u0 * u + v1 * v};
  return plane;
}

void checkMirrors(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models) {
  for (const auto& [node, mirror] : scene.mirrors) mirrorPlane(scene, models, node);
}

}  // namespace boxprobe
