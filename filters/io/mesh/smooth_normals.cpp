#include "filters/io/mesh/smooth_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace boxprobe {

namespace {

constexpr double kSmoothCosine = 0.8660254;  // of 30 degrees

/// A triangle at a point, or several with almost the same normal.
struct FacingShare {
  glm::dvec3 facing{0.0};  ///< unit
  glm::dvec3 sum{0.0};     ///< facing, weighted by the angle at the point
};

using Around = std::map<std::array<float, 3>, std::vector<FacingShare>>;

/// The index, among 6 x 9 x 9 cells on a cube around the origin, of the cell that a direction meets.
std::size_t directionCell(const glm::dvec3& d) {
  constexpr double kCells = 9.0;
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::fabs(d[i]) > std::fabs(d[axis])) axis = i;
  }
  const auto cell = [&](int other) {
    const double t = 0.5 * (d[other] / std::fabs(d[axis]) + 1.0);
    return static_cast<std::size_t>(std::clamp(t * kCells, 0.0, kCells - 1.0));
  };
  const std::size_t face = 2 * static_cast<std::size_t>(axis) + (d[axis] < 0.0 ? 1 : 0);
  return (face * 9 + cell((axis + 1) % 3)) * 9 + cell((axis + 2) % 3);
}

void joinAlike(std::vector<FacingShare>& shares) {
  constexpr std::size_t kFew = 64;
  if (shares.size() <= kFew) return;
  std::map<std::size_t, glm::dvec3> sums;
  for (const FacingShare& share : shares) sums.emplace(directionCell(share.facing), 0.0).first->second += share.sum;
  shares.clear();
  for (const auto& [cell, sum] : sums) {
    const double length = glm::length(sum);
    if (length > 0.0) shares.push_back({sum / length, sum});
  }
}

}  // namespace

void computeNormals(Mesh& mesh) {
  const std::size_t triangles = mesh.indices.size() / 3;
  std::vector<glm::dvec3> facing(triangles, glm::dvec3(0.0));  // unit, or 0 for degenerate triangles
  Around around;
  for (std::size_t t = 0; t < triangles; ++t) {
    glm::dvec3 p[3];
    for (std::size_t k = 0; k < 3; ++k) p[k] = glm::dvec3(mesh.positions[mesh.indices[3 * t + k]]);
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double size = glm::length(normal);
    if (!(size > 0.0)) continue;
    facing[t] = normal / size;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3& at = mesh.positions[mesh.indices[3 * t + k]];
      const double cosine = glm::dot(p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
      around[{at.x, at.y, at.z}].push_back({facing[t], std::atan2(size, cosine) * facing[t]});
    }
  }
  for (auto& [point, shares] : around) joinAlike(shares);
  Mesh flat;
  for (std::size_t c = 0; c < 3 * triangles; ++c) {
    const std::uint32_t vertex = mesh.indices[c];
    const glm::vec3& at = mesh.positions[vertex];
    const glm::dvec3 own = facing[c / 3];
    glm::dvec3 sum(0.0);
    const auto found = around.find({at.x, at.y, at.z});
    if (found != around.end()) {
      for (const FacingShare& share : found->second) {
        if (glm::dot(share.facing, own) >= kSmoothCosine) sum += share.sum;
      }
    }
    const double length = glm::length(sum);
    flat.positions.push_back(at);
    // A degenerate triangle is never visible.
    flat.normals.push_back(length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0, 1, 0));
    if (!mesh.uv.empty()) flat.uv.push_back(mesh.uv[vertex]);
    if (!mesh.colors.empty()) flat.colors.push_back(mesh.colors[vertex]);
    flat.indices.push_back(static_cast<std::uint32_t>(c));
  }
  mesh = std::move(flat);
}

}  // namespace boxprobe
