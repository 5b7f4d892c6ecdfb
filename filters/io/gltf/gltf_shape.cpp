// Deforms vertices by morph targets and skins, once, when the file is read.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "filters/core/base/file_limits.h"
#include "filters/core/base/number_text.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

/// For one attribute: the weighted sum of its targets' differences.
template <typename Vector>
void addTargets(const GltfFile& file, const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                const char* name, const GltfVertices& vertices, std::vector<Vector>& values, const std::string& place) {
  if (values.empty()) return;
  const std::size_t count = std::min(weights.size(), primitive.targets.size());
  for (std::size_t t = 0; t < count; ++t) {
    const auto found = primitive.targets[t].find(name);
    if (found == primitive.targets[t].end() || weights[t] == 0.0) continue;
    const std::string where = place + ": target " + std::to_string(t) + ": " + name;
    if (const std::size_t entries = elementCount(file, found->second, where); entries != vertices.count) {
      file.fail(where,
                "has " + std::to_string(entries) + " entries for " + std::to_string(vertices.count) + " positions");
    }
    const std::vector<float> moves = readFloats(file, found->second, 3, where, vertices.list());
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        values[i][c] +=
            static_cast<float>(weights[t] * static_cast<double>(moves[3 * i + static_cast<std::size_t>(c)]));
      }
    }
  }
}

/// One set of four joints and weights per vertex.
struct Influences {
  std::vector<float> joints, weights;
};

std::vector<Influences> influencesOf(const GltfFile& file, const tinygltf::Primitive& primitive,
                                     const GltfVertices& vertices, const std::string& place) {
  std::vector<Influences> sets;
  for (const char* number : {"0", "1"}) {
    const auto joints = primitive.attributes.find(std::string("JOINTS_") + number);
    const auto weights = primitive.attributes.find(std::string("WEIGHTS_") + number);
    if (joints == primitive.attributes.end() || weights == primitive.attributes.end()) break;
    const std::string where = place + ": JOINTS_" + number;
    if (elementCount(file, joints->second, where) != vertices.count ||
        elementCount(file, weights->second, where) != vertices.count) {
      file.fail(where, "has not one entry a position; export it again");
    }
    sets.push_back({readFloats(file, joints->second, 4, where, vertices.list()),
                    readFloats(file, weights->second, 4, where, vertices.list())});
  }
  return sets;
}

/// The joints' transforms blended by the vertex's weights, which need not sum to 1.
glm::dmat4 skinOf(const GltfFile& file, const std::vector<Influences>& sets, std::size_t vertex,
                  const GltfVertices& vertices, const std::vector<glm::dmat4>& joints, const std::string& place) {
  glm::dmat4 skin(0.0);
  double sum = 0.0;
  for (const Influences& set : sets) {
    for (std::size_t k = 4 * vertex; k < 4 * vertex + 4; ++k) {
      const double weight = static_cast<double>(set.weights[k]);
      if (weight == 0.0) continue;
      const float joint = set.joints[k];
      if (!(joint >= 0.0f && joint < static_cast<float>(joints.size()))) {
        file.fail(place, "vertex " + std::to_string(vertices.entry(vertex)) + " hangs on joint " + numberText(joint) +
                             ", but the skin has " + std::to_string(joints.size()) + "; the file is damaged");
      }
      skin += weight * joints[static_cast<std::size_t>(joint)];
      sum += weight;
    }
  }
  // A vertex without weights follows the first joint.
  return std::fabs(sum) > 1.0e-6 ? skin / sum : joints.front();
}

/// Transforms normals, up to a factor: the inverse transpose times the determinant, which needs no division.
glm::dmat3 cofactors(const glm::dmat3& m) {
  const glm::dmat3 matrix(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::dot(m[0], matrix[0]) < 0.0 ? -matrix : matrix;
}

void applySkin(const GltfFile& file, const tinygltf::Primitive& primitive, const std::vector<glm::dmat4>& joints,
               const GltfVertices& vertices, Mesh& mesh, const std::string& place) {
  const std::vector<Influences> sets = influencesOf(file, primitive, vertices, place);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dmat4 skin = skinOf(file, sets, i, vertices, joints, place);
    mesh.positions[i] = glm::vec3(skin * glm::dvec4(mesh.positions[i], 1.0));
    if (!mesh.normals.empty()) {
      const glm::dvec3 normal = cofactors(glm::dmat3(skin)) * glm::dvec3(mesh.normals[i]);
      const double length = glm::length(normal);
      if (length > 0.0) mesh.normals[i] = glm::vec3(normal / length);
    }
    if (!mesh.tangents.empty()) {
      const glm::dvec3 tangent = glm::dmat3(skin) * glm::dvec3(mesh.tangents[i]);
      const double length = glm::length(tangent);
      if (length > 0.0) mesh.tangents[i] = glm::vec4(glm::vec3(tangent / length), mesh.tangents[i].w);
    }
  }
}

}  // namespace

bool GltfShape::atRest() const {
  return joints.empty() && std::all_of(weights.begin(), weights.end(), [](double weight) { return weight == 0.0; });
}

void applyShape(GltfFile& file, const tinygltf::Primitive& primitive, const GltfShape& shape,
                const GltfVertices& vertices, Mesh& mesh, const std::string& place) {
  if (shape.atRest()) return;
  file.shapedPositions += mesh.positions.size();
  if (file.shapedPositions > limits::kGltfShapedPositions) {
    file.fail(place, "skins and morph targets come to more than " + std::to_string(limits::kGltfShapedPositions) +
                         " positions in all; split the file");
  }
  addTargets(file, primitive, shape.weights, "POSITION", vertices, mesh.positions, place);
  addTargets(file, primitive, shape.weights, "NORMAL", vertices, mesh.normals, place);
  addTargets(file, primitive, shape.weights, "TANGENT", vertices, mesh.tangents, place);
  if (!shape.joints.empty()) applySkin(file, primitive, shape.joints, vertices, mesh, place);
}

}  // namespace boxprobe
