#include "tests/unit/scene_triangles.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace boxprobe {

std::string scenesFolder() {
  return std::string(BOXPROBE_DATA_DIR) + "/scenes/";
}

glm::dvec3 Triangle::areaVector() const {
  return 0.5 * glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
}

glm::dvec3 Triangle::middle() const {
  return (corners[0] + corners[1] + corners[2]) / 3.0;
}

std::vector<Triangle> triangles(const Model& model) {
  std::vector<Triangle> all;
  for (const Instance& instance : model.instances) {
    const Mesh& mesh = model.meshes.at(static_cast<std::size_t>(instance.mesh));
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size()) << mesh.name;
    EXPECT_EQ(mesh.uv.size(), mesh.positions.size()) << mesh.name;
    const Material& material = model.materials.at(static_cast<std::size_t>(mesh.material));
    const glm::dmat3 normalMatrix = glm::transpose(glm::inverse(glm::dmat3(instance.worldFromModel)));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      Triangle t{instance.node, material.name, {}, {}, {}, &material};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t index = mesh.indices[i + k];
        t.corners[k] = glm::dvec3(instance.worldFromModel * glm::dvec4(mesh.positions.at(index), 1.0));
        t.normals[k] = glm::normalize(normalMatrix * glm::dvec3(mesh.normals.at(index)));
        t.uv[k] = mesh.uv.at(index);
      }
      all.push_back(t);
    }
  }
  return all;
}

bool startsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

}  // namespace boxprobe
