// Models of quads and boxes, made by tests of the fit.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>

#include "filters/core/scene/model.h"

namespace boxprobe {

struct MadeModel {
  Model model;

  /// Corners counter-clockwise as seen from the front.
  void quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    if (model.meshes.empty()) {
      model.meshes.emplace_back();
      model.instances.push_back({"all", 0, glm::dmat4(1.0)});
    }
    Mesh& mesh = model.meshes.front();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
  }
  /// One side of a box, seen from inside (or outside): axis 0 to 2, at its maximum or minimum.
  void side(const Box& box, int axis, bool upper, bool fromInside = true) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    glm::vec3 corner[4];
    for (int k = 0; k < 4; ++k) {
      corner[k][axis] = static_cast<float>((upper ? box.max : box.min)[axis]);
      corner[k][u] = static_cast<float>((k == 1 || k == 2 ? box.max : box.min)[u]);
      corner[k][v] = static_cast<float>((k >= 2 ? box.max : box.min)[v]);
    }
    if (upper == fromInside) std::swap(corner[1], corner[3]);
    quad(corner[0], corner[1], corner[2], corner[3]);
  }
  void box(const Box& box, bool fromInside) {
    for (int axis = 0; axis < 3; ++axis) {
      side(box, axis, false, fromInside);
      side(box, axis, true, fromInside);
    }
  }
};

}  // namespace boxprobe
