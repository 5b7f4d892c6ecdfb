#include "filters/io/obj/obj_meshes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

#include "filters/core/base/one_line.h"
#include "filters/io/mesh/far_positions.h"
#include "filters/io/mesh/polygon_triangles.h"
#include "filters/math/cube/srgb.h"

namespace boxprobe {

namespace {

/// What makes corners of a part one vertex.
struct VertexKey {
  std::uint32_t part, position, uv;
  std::uint64_t normal;
  bool operator==(const VertexKey& other) const {
    return part == other.part && position == other.position && uv == other.uv && normal == other.normal;
  }
};
struct VertexHash {
  std::size_t operator()(const VertexKey& key) const {
    std::uint64_t hash = key.normal * 0x9e3779b97f4a7c15ull;
    for (const std::uint64_t value : {key.part, key.position, key.uv}) {
      hash = (hash ^ (hash >> 29) ^ value) * 0xbf58476d1ce4e5b9ull;
    }
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

constexpr std::uint64_t kSmooth = std::uint64_t(1) << 62, kFlat = std::uint64_t(2) << 62;

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 0.0 && std::isfinite(length) ? v / length : otherwise;
}

class PartMaker {
 public:
  PartMaker(ObjGeometry& geometry, const std::string& path, const std::function<void(double)>& progress)
      : geometry_(geometry), progress_(progress) {
    keepUsedPositions();
    near_ = nearPositions(geometry_.positions, path);
  }

  ObjParts make() {
    choosePartNames();
    addSmoothNormals();
    for (std::size_t f = 0; f < geometry_.faces.size(); ++f) {
      addFace(f);
      constexpr std::size_t kBetween = 1 << 14;
      if (f % kBetween == 0) progress_(static_cast<double>(f) / static_cast<double>(geometry_.faces.size()));
    }
    for (ObjPart& part : parts_) {
      if (!part.hasUv) part.mesh.uv.clear();
      if (!part.hasColors) part.mesh.colors.clear();
    }
    if (tests_.left == 0) geometry_.warnings.emplace_back(kPolygonsTooHard);
    ObjParts result;
    result.parts = std::move(parts_);
    result.worldFromModel = near_.worldFromModel;
    return result;
  }

 private:
  /// Positions that no face uses would count in the bounds.
  void keepUsedPositions() {
    std::vector<bool> used(geometry_.positions.size(), false);
    for (const ObjCorner& corner : geometry_.corners) used[corner.position] = true;
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i] && !geometry_.corners.empty()) {
        geometry_.positions[i] = geometry_.positions[geometry_.corners.front().position];
      }
    }
  }

  /// By objects, else by groups; of very many there are only materials.
  void choosePartNames() {
    constexpr std::size_t kMostObjects = 1000;
    std::set<std::uint32_t> objects, groups;
    for (const ObjFace& face : geometry_.faces) {
      objects.insert(face.object);
      groups.insert(face.group);
    }
    byGroup_ = objects.size() < 2 && groups.size() > 1;
    if (objects.size() < 2 && geometry_.objects.size() < 2) byGroup_ = true;
    const std::size_t count = byGroup_ ? groups.size() : objects.size();
    if (count <= kMostObjects) return;
    named_ = false;
    geometry_.warnings.push_back("has " + std::to_string(count) +
                                 " groups; what has one material is drawn as one object");
  }

  std::string objectOf(const ObjFace& face) const {
    if (!named_) return {};
    return byGroup_ ? geometry_.groups[face.group] : geometry_.objects[face.object];
  }

  /// Faces of a group share the mean of the normals around a vertex, weighted by their angles there.
  void addSmoothNormals() {
    for (const ObjFace& face : geometry_.faces) {
      if (face.smoothing <= 0 || hasNormals(face)) continue;
      const std::vector<glm::dvec3> corners = positionsOf(face);
      const glm::dvec3 normal = unitOr(polygonNormal(corners), glm::dvec3(0.0));
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 before = corners[(i + corners.size() - 1) % corners.size()] - corners[i];
        const glm::dvec3 after = corners[(i + 1) % corners.size()] - corners[i];
        const double angle = std::atan2(glm::length(glm::cross(after, before)), glm::dot(after, before));
        smooth_[smoothKey(geometry_.corners[face.first + i], face)] += angle * normal;
      }
    }
  }
  static std::uint64_t smoothKey(const ObjCorner& corner, const ObjFace& face) {
    return (static_cast<std::uint64_t>(face.smoothing) << 32) | corner.position;
  }

  bool hasNormals(const ObjFace& face) const {
    for (std::size_t c = face.first; c < face.first + face.count; ++c) {
      if (geometry_.corners[c].normal == kNoObjEntry) return false;
    }
    return true;
  }

  std::vector<glm::dvec3> positionsOf(const ObjFace& face) const {
    std::vector<glm::dvec3> corners;
    corners.reserve(face.count);
    for (std::size_t c = face.first; c < face.first + face.count; ++c) {
      corners.push_back(geometry_.positions[geometry_.corners[c].position]);
    }
    return corners;
  }

  void addFace(std::size_t index) {
    const ObjFace& face = geometry_.faces[index];
    const bool given = hasNormals(face), known = given || face.smoothing >= 0;
    const std::uint32_t part = partOf(face, known);
    const std::vector<glm::dvec3> corners = positionsOf(face);
    const glm::dvec3 facing = unitOr(polygonNormal(corners), glm::dvec3(0, 1, 0));  // the latter is never visible
    vertices_.clear();
    for (std::size_t c = face.first; c < face.first + face.count; ++c) {
      const ObjCorner& corner = geometry_.corners[c];
      const std::uint64_t normal = given                ? corner.normal
                                   : face.smoothing > 0 ? kSmooth | smoothKey(corner, face)
                                   : known              ? kFlat | index
                                                        : 0;
      vertices_.push_back(vertexOf({part, corner.position, corner.uv, normal}, facing));
    }
    for (const auto& triangle : polygonTriangles(corners, tests_)) {
      for (const std::uint32_t c : triangle) parts_[part].mesh.indices.push_back(vertices_[c]);
    }
  }

  std::uint32_t partOf(const ObjFace& face, bool known) {
    const auto key = std::make_tuple(named_ ? (byGroup_ ? face.group : face.object) : 0u, face.material, known);
    const auto [entry, isNew] = partIndices_.emplace(key, static_cast<std::uint32_t>(parts_.size()));
    if (isNew) {
      ObjPart part;
      part.object = objectOf(face);
      part.mesh.material = static_cast<int>(face.material);
      part.hasNormals = known;
      parts_.push_back(std::move(part));
    }
    return entry->second;
  }

  std::uint32_t vertexOf(const VertexKey& key, const glm::dvec3& facing) {
    Mesh& mesh = parts_[key.part].mesh;
    const auto [entry, isNew] = indices_.emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
    if (!isNew) return entry->second;
    mesh.positions.push_back(near_.positions[key.position]);
    if (parts_[key.part].hasNormals) mesh.normals.emplace_back(normalOf(key.normal, facing));
    if (!geometry_.uvs.empty()) {
      if (key.uv != kNoObjEntry) parts_[key.part].hasUv = true;
      const glm::dvec2 uv = key.uv == kNoObjEntry ? glm::dvec2(0.0, 1.0) : geometry_.uvs[key.uv];
      const auto finite = [](double x) { return std::isfinite(x) && std::fabs(x) < 1e18 ? x : 0.0; };
      mesh.uv.emplace_back(finite(uv.x), 1.0 - finite(uv.y));
    }
    if (!geometry_.colors.empty()) {
      const glm::vec3& c = geometry_.colors[key.position];
      glm::vec4 color(1.0f);
      if (c.r >= 0.0f) parts_[key.part].hasColors = true;
      for (int i = 0; c.r >= 0.0f && i < 3; ++i) {
        color[i] = static_cast<float>(linearOfSrgbValue(static_cast<double>(c[i])));
      }
      mesh.colors.push_back(color);
    }
    return entry->second;
  }

  glm::dvec3 normalOf(std::uint64_t key, const glm::dvec3& facing) const {
    if ((key & kFlat) != 0) return facing;
    if ((key & kSmooth) != 0) return unitOr(smooth_.at(key & ~kSmooth), facing);
    return unitOr(geometry_.normals[key], facing);
  }

  ObjGeometry& geometry_;
  const std::function<void(double)>& progress_;
  NearPositions near_;
  bool byGroup_ = false, named_ = true;
  std::vector<ObjPart> parts_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, bool>, std::uint32_t> partIndices_;
  std::unordered_map<VertexKey, std::uint32_t, VertexHash> indices_;
  std::unordered_map<std::uint64_t, glm::dvec3> smooth_;
  std::vector<std::uint32_t> vertices_;  ///< of the face being added
  PolygonTests tests_;
};

}  // namespace

ObjParts partsOf(ObjGeometry& geometry, const std::string& path, const std::function<void(double)>& progress) {
  return PartMaker(geometry, path, progress).make();
}

}  // namespace boxprobe
