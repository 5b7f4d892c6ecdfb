// For files that have a normal map but no tangents glTF 2.0 (section 3.7.2.1) requires MikkTSpace's tangents. This
// follows its rules: the gradient of u in each triangle, made perpendicular to the corner's normal, summed over the
// corners that share position, normal, coordinates and handedness, weighted by the corner's angle. It does not merge
// seams by connectivity: corners are shared wherever their values are equal.
#include "filters/io/mesh/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

namespace boxprobe {

namespace {

using CornerKey = std::array<float, 9>;  // position, normal, coordinates, handedness

CornerKey keyOf(const Mesh& mesh, const glm::vec2& uv, std::uint32_t vertex, float handedness) {
  const glm::vec3 &p = mesh.positions[vertex], &n = mesh.normals[vertex];
  return {p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y, handedness};
}

/// Any unit vector perpendicular to `n`: for corners without a texture gradient.
glm::dvec3 anyPerpendicular(const glm::dvec3& n) {
  const glm::dvec3 axis = std::fabs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(axis - glm::dot(axis, n) * n);
}

double angleAt(const glm::dvec3& corner, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = b - corner, v = c - corner;
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

template <typename Value>
void append(std::vector<Value>& values, std::uint32_t vertex) {
  if (!values.empty()) values.push_back(Value(values[vertex]));
}

}  // namespace

int tangentSet(const Mesh& mesh, const Material& material) {
  const TextureUse& direction = material.finish.anisotropyTexture;
  for (const TextureUse* use : {&material.normalTexture, &material.coatNormalTexture, &direction}) {
    if (use->image && !(use->uvSet == 1 ? mesh.uv1 : mesh.uv).empty()) return use->uvSet;
  }
  return material.finish.isAnisotropic() && !mesh.uv.empty() ? 0 : -1;
}

void addTangents(Mesh& mesh, int uvSet) {
  const std::vector<glm::vec2> uv = uvSet == 1 ? mesh.uv1 : mesh.uv;
  std::map<CornerKey, glm::dvec3> sums;
  std::vector<float> handedness(mesh.indices.size() / 3);
  for (std::size_t t = 0; t < handedness.size(); ++t) {
    const std::uint32_t* v = &mesh.indices[3 * t];
    const glm::dvec3 p[3] = {mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]};
    const glm::dvec2 d1 = glm::dvec2(uv[v[1]]) - glm::dvec2(uv[v[0]]), d2 = glm::dvec2(uv[v[2]]) - glm::dvec2(uv[v[0]]);
    const double area = d1.x * d2.y - d2.x * d1.y;
    // v grows downwards in the picture and upwards in tangent space: glTF's bitangent is cross(n, t) * w, with w = +1
    // if the picture with v flipped is not mirrored.
    handedness[t] = area > 0.0 ? -1.0f : 1.0f;
    const glm::dvec3 gradient = (area > 0.0 ? 1.0 : -1.0) * (d2.y * (p[1] - p[0]) - d1.y * (p[2] - p[0]));
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3 n(mesh.normals[v[corner]]);
      const glm::dvec3 flat = gradient - glm::dot(gradient, n) * n;
      const double length = glm::length(flat);
      if (area == 0.0 || !(length > 0.0)) continue;
      const double weight = angleAt(p[corner], p[(corner + 1) % 3], p[(corner + 2) % 3]);
      sums[keyOf(mesh, uv[v[corner]], v[corner], handedness[t])] += weight / length * flat;
    }
  }

  // A vertex takes the handedness of its first corner; corners of the other get a copy.
  std::vector<float> given(mesh.positions.size(), 0.0f);
  std::map<std::uint32_t, std::uint32_t> copies;
  for (std::size_t i = 0; i < mesh.indices.size() / 3 * 3; ++i) {
    const std::uint32_t vertex = mesh.indices[i];
    const float side = handedness[i / 3];
    if (given[vertex] == 0.0f) given[vertex] = side;
    if (given[vertex] == side) continue;
    const auto [copy, isNew] = copies.emplace(vertex, static_cast<std::uint32_t>(mesh.positions.size()));
    if (isNew) {
      append(mesh.positions, vertex);
      append(mesh.normals, vertex);
      append(mesh.uv, vertex);
      append(mesh.uv1, vertex);
      append(mesh.colors, vertex);
      given.push_back(side);
    }
    mesh.indices[i] = copy->second;
  }
  const std::vector<glm::vec2>& set = uvSet == 1 ? mesh.uv1 : mesh.uv;
  mesh.tangents.clear();
  for (std::uint32_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const float side = given[vertex] == 0.0f ? 1.0f : given[vertex];
    const glm::dvec3 n(mesh.normals[vertex]);
    const auto sum = sums.find(keyOf(mesh, set[vertex], vertex, side));
    const double length = sum == sums.end() ? 0.0 : glm::length(sum->second);
    mesh.tangents.emplace_back(length > 0.0 ? sum->second / length : anyPerpendicular(n), side);
  }
}

}  // namespace boxprobe
