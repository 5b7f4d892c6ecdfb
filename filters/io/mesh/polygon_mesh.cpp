#include "filters/io/mesh/polygon_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/io/mesh/far_positions.h"
#include "filters/io/mesh/polygon_triangles.h"
#include "filters/io/mesh/smooth_normals.h"

namespace boxprobe {

namespace {

class Builder {
 public:
  Builder(const Polygons& polygons, std::size_t parts, const std::string& place)
      : polygons_(polygons), place_(place), near_(nearPositions(polygons.positions, place)) {
    result_.meshes.resize(parts);
    result_.worldFromModel = near_.worldFromModel;
    // What belongs to corners or polygons needs vertices of its own for each.
    shared_ = polygons.cornerUvs.empty() && polygons.faceColors.empty();
    if (shared_) vertices_.assign(parts, std::vector<std::uint32_t>(parts == 1 ? 0 : polygons.positions.size(), kNone));
  }

  PolygonMeshes build() {
    if (shared_ && result_.meshes.size() == 1) addAll();
    std::size_t first = 0;
    for (std::size_t p = 0; p < polygons_.ends.size(); ++p) {
      add(p, first, polygons_.ends[p]);
      first = polygons_.ends[p];
    }
    result_.tooHard = tests_.left == 0;
    for (Mesh& mesh : result_.meshes) {
      if (polygons_.normals.empty() && !mesh.indices.empty()) computeNormals(mesh);
    }
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// One mesh with the vertices of the file, in its order.
  void addAll() {
    for (std::uint32_t i = 0; i < polygons_.positions.size(); ++i) addVertex(result_.meshes[0], i, nullptr, nullptr);
  }

  void addVertex(Mesh& mesh, std::uint32_t position, const glm::dvec2* uv, const glm::vec4* color) {
    mesh.positions.push_back(near_.positions[position]);
    if (!polygons_.normals.empty()) {
      const glm::dvec3& n = polygons_.normals[position];
      const double length = glm::length(n);
      // A point with degenerate triangles only, or with NaN in the file: never visible, but must be a unit vector.
      mesh.normals.push_back(length > 0.0 && std::isfinite(length) ? glm::vec3(n / length) : glm::vec3(0, 1, 0));
    }
    if (uv == nullptr && !polygons_.uvs.empty()) uv = &polygons_.uvs[position];
    if (uv != nullptr) {
      const auto finite = [](double x, double otherwise) { return std::fabs(x) < limits::kNumber ? x : otherwise; };
      mesh.uv.emplace_back(finite(uv->x, 0.0), 1.0 - finite(uv->y, 1.0));
    }
    if (color == nullptr && polygons_.colors.empty()) return;
    const glm::vec4 own = polygons_.colors.empty() ? glm::vec4(1.0f) : polygons_.colors[position];
    mesh.colors.push_back(color == nullptr ? own : own * *color);
  }

  std::uint32_t vertexOf(std::size_t part, std::size_t polygon, std::size_t corner) {
    Mesh& mesh = result_.meshes[part];
    const std::uint32_t position = polygons_.corners[corner];
    if (shared_ && result_.meshes.size() == 1) return position;
    const auto next = static_cast<std::uint32_t>(mesh.positions.size());
    if (shared_) {
      std::uint32_t& known = vertices_[part][position];
      if (known != kNone) return known;
      known = next;
    }
    addVertex(mesh, position, polygons_.cornerUvs.empty() ? nullptr : &polygons_.cornerUvs[corner],
              polygons_.faceColors.empty() ? nullptr : &polygons_.faceColors[polygon]);
    return next;
  }

  void add(std::size_t polygon, std::size_t first, std::size_t end) {
    const std::size_t count = end - first;
    if (count > limits::kPolygonCorners) {
      throw InputError(place_ + ": polygon " + std::to_string(polygon) + " has more than " +
                       std::to_string(limits::kPolygonCorners) + " corners; split it");
    }
    const std::size_t part = polygons_.parts.empty() ? 0 : polygons_.parts[polygon];
    corners_.clear();
    points_.clear();
    for (std::size_t c = first; count >= 3 && c < end; ++c) {
      corners_.push_back(vertexOf(part, polygon, c));
      points_.push_back(polygons_.positions[polygons_.corners[c]]);
    }
    for (const auto& triangle : polygonTriangles(points_, tests_)) {
      for (const std::uint32_t c : triangle) result_.meshes[part].indices.push_back(corners_[c]);
    }
  }

  const Polygons& polygons_;
  const std::string& place_;
  const NearPositions near_;
  PolygonMeshes result_;
  bool shared_ = true;
  std::vector<std::vector<std::uint32_t>> vertices_;  ///< by part and position
  std::vector<std::uint32_t> corners_;
  std::vector<glm::dvec3> points_;
  PolygonTests tests_;
};

}  // namespace

PolygonMeshes meshesOf(const Polygons& polygons, std::size_t parts, const std::string& place) {
  return Builder(polygons, parts, place).build();
}

}  // namespace boxprobe
