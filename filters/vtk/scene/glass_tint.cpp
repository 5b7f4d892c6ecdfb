#include "filters/vtk/scene/glass_tint.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

namespace {

bool seesObject(const Probe& probe, const DrawnObject& object) {
  return object.settings.visible && object.settings.seenByProbes &&
         (!object.settings.dynamic || probe.mode == ProbeMode::Realtime) &&
         std::find(probe.hides.begin(), probe.hides.end(), object.node) == probe.hides.end();
}

glm::vec3 tintOf(const DrawnObject& object, const Scene& scene) {
  glm::vec3 color(object.material.baseColor);
  const auto found = scene.materials.find(object.materialName);
  if (found != scene.materials.end() && found->second.baseColor) color = *found->second.baseColor;
  return glm::clamp(color, 0.0f, 1.0f);
}

/// Adds one triangle, with corners relative to the capture origin along the map's axes, to the texels of one face.
void tintFace(CubeMap& tint, int face, const glm::dvec3 (&corners)[3], const glm::vec3& color) {
  const glm::dvec3 forward(shading::cubeDirection(face, 0.0f, 0.0f));
  const glm::dvec3 right = glm::dvec3(shading::cubeDirection(face, 1.0f, 0.0f)) - forward;
  const glm::dvec3 up = glm::dvec3(shading::cubeDirection(face, 0.0f, 1.0f)) - forward;
  const int size = tint.faceSize();
  int low[2] = {0, 0}, high[2] = {size - 1, size - 1};
  // A triangle that extends behind the face's camera is tested at every texel.
  const auto ahead = [&](const glm::dvec3& c) { return glm::dot(c, forward); };
  if (ahead(corners[0]) <= 0.0 && ahead(corners[1]) <= 0.0 && ahead(corners[2]) <= 0.0) return;
  if (ahead(corners[0]) > 0.0 && ahead(corners[1]) > 0.0 && ahead(corners[2]) > 0.0) {
    for (int axis = 0; axis < 2; ++axis) {
      double least = 1.0e300, most = -1.0e300;
      for (const glm::dvec3& c : corners) {
        const double at = glm::dot(c, axis == 0 ? right : up) / ahead(c);
        least = std::min(least, at);
        most = std::max(most, at);
      }
      const auto texel = [size](double at) { return (0.5 * std::clamp(at, -2.0, 2.0) + 0.5) * size; };
      low[axis] = std::max(static_cast<int>(std::floor(texel(least))), 0);
      high[axis] = std::min(static_cast<int>(std::floor(texel(most))), size - 1);
    }
  }
  // Inside if the direction is on the same side of all three planes through the origin and an edge.
  const glm::dvec3 planes[3] = {glm::cross(corners[0], corners[1]), glm::cross(corners[1], corners[2]),
                                glm::cross(corners[2], corners[0])};
  const double side = glm::dot(planes[0], corners[2]);
  for (int row = low[1]; row <= high[1]; ++row) {
    for (int column = low[0]; column <= high[0]; ++column) {
      const double s = (2.0 * column + 1.0) / size - 1.0, t = (2.0 * row + 1.0) / size - 1.0;
      const glm::dvec3 direction = forward + s * right + t * up;
      const bool inside = std::all_of(std::begin(planes), std::end(planes),
                                      [&](const glm::dvec3& plane) { return glm::dot(plane, direction) * side > 0.0; });
      if (!inside) continue;
      const glm::vec4 before = tint.texel(0, face, column, row);
      tint.setTexel(0, face, column, row, glm::vec4(glm::vec3(before) * color, before.a));
    }
  }
}

}  // namespace

std::shared_ptr<const CubeMap> glassTint(const SceneContent& content, const Probe& probe, const ProbeMaps& maps) {
  std::shared_ptr<CubeMap> tint;
  const glm::dmat3 mapFromWorld = glm::transpose(rotationMatrix(maps.capturedRotation));
  std::size_t index = 0;
  for (const auto& model : content.models) {
    for (const Instance& instance : model->instances) {
      if (index == content.objects.size()) return tint;
      const DrawnObject& object = content.objects[index++];
      const glm::vec3 color = tintOf(object, content.scene);
      if (object.material.alphaMode != AlphaMode::Blend || !seesObject(probe, object) || color == glm::vec3(1.0f)) {
        continue;
      }
      if (!tint) {
        tint = std::make_shared<CubeMap>(maps.radiance.faceSize(), 1);
        for (int face = 0; face < 6; ++face) {
          std::fill_n(tint->face(0, face), 4 * tint->faceSize() * tint->faceSize(), 1.0f);
        }
      }
      const Mesh& mesh = model->meshes[static_cast<std::size_t>(instance.mesh)];
      for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        glm::dvec3 corners[3];
        for (std::size_t k = 0; k < 3; ++k) {
          const glm::dvec4 world =
              object.worldFromModel * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1.0);
          corners[k] = mapFromWorld * (glm::dvec3(world) - maps.capturedAt);
        }
        for (int face = 0; face < 6; ++face) tintFace(*tint, face, corners, color);
      }
    }
  }
  return tint;
}

}  // namespace boxprobe
