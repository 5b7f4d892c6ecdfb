// A living room of others: "3d/physical_light_camera_units/living_room.glb" of
// github.com/godotengine/godot-demo-projects, MIT licence, copyright 2014-present Godot Engine contributors, 2007-2014
// Juan Linietsky, Ariel Manzur. Every surface becomes Lambert's, and where the model has one twice it is there once:
// which of two in one place a ray meets is chance.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/truth/lit/scenes/lit_parts.h"
#include "tests/truth/lit/scenes/lit_scenes.h"

namespace boxprobe::scenes {
namespace {

/// Readers make normals unit, which may change the last digit to and fro: the same one of both, whichever is given.
glm::vec3 settled(glm::vec3 normal) {
  const auto unit = [](const glm::vec3& n) { return glm::vec3(glm::dvec3(n) / glm::length(glm::dvec3(n))); };
  for (int i = 0; i < 100; ++i) normal = unit(normal);
  const glm::vec3 other = unit(normal);
  return std::make_tuple(other.x, other.y, other.z) < std::make_tuple(normal.x, normal.y, normal.z) ? other : normal;
}

struct Triangle {
  std::size_t mesh = 0, first = 0;  ///< of its indices
  std::array<glm::dvec3, 3> corners;
  glm::dvec3 normal{0.0};  ///< unit
  double area = 0.0;
  bool kept = true;

  bool holds(const glm::dvec3& point) const {
    constexpr double kNear = 1e-5;  // metres
    if (std::abs(glm::dot(point - corners[0], normal)) > kNear) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 edge = corners[(i + 1) % 3] - corners[i];
      if (glm::dot(glm::cross(edge, point - corners[i]), normal) < -kNear * glm::length(edge)) return false;
    }
    return true;
  }
};

/// Does what is kept of the others hold each of a grid of points of it?
bool covered(const Triangle& t, const std::vector<Triangle>& all) {
  constexpr int kGrid = 16;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; i + j < kGrid; ++j) {
      const double u = (i + 1.0 / 3.0) / kGrid, v = (j + 1.0 / 3.0) / kGrid;
      const glm::dvec3 point = t.corners[0] + u * (t.corners[1] - t.corners[0]) + v * (t.corners[2] - t.corners[0]);
      const auto other = [&](const Triangle& o) {
        return &o != &t && o.kept && std::abs(glm::dot(o.normal, t.normal)) > 0.999 && o.holds(point);
      };
      if (std::none_of(all.begin(), all.end(), other)) return false;
    }
  }
  return true;
}

/// Vertices of no triangle.
void dropUnused(Mesh& mesh) {
  Mesh used;
  std::map<std::uint32_t, std::uint32_t> places;
  for (std::uint32_t& index : mesh.indices) {
    const auto [place, added] = places.try_emplace(index, static_cast<std::uint32_t>(places.size()));
    if (added) {
      used.positions.push_back(mesh.positions.at(index));
      used.normals.push_back(mesh.normals.at(index));
    }
    index = place->second;
  }
  mesh.positions = std::move(used.positions);
  mesh.normals = std::move(used.normals);
  mesh.uv.clear();
}

/// Without triangles that have no area or that others cover; of what the others are, the first meshes give way.
Model eachSurfaceOnce(const Model& model) {
  std::vector<Triangle> triangles;
  for (const Instance& instance : model.instances) {
    const Mesh& mesh = model.meshes.at(static_cast<std::size_t>(instance.mesh));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      Triangle t;
      t.mesh = static_cast<std::size_t>(instance.mesh);
      t.first = i;
      for (std::size_t k = 0; k < 3; ++k) {
        t.corners[k] = glm::dvec3(instance.worldFromModel * glm::dvec4(mesh.positions[mesh.indices[i + k]], 1.0));
      }
      t.normal = glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
      t.area = 0.5 * glm::length(t.normal);
      constexpr double kNoArea = 1e-7;  // square metres
      if (t.area < kNoArea) continue;
      t.normal /= 2.0 * t.area;
      triangles.push_back(t);
    }
  }
  std::stable_sort(triangles.begin(), triangles.end(), [](const Triangle& a, const Triangle& b) {
    return std::make_pair(a.mesh, a.area) < std::make_pair(b.mesh, b.area);
  });
  for (Triangle& t : triangles) t.kept = !covered(t, triangles);
  Model once = model;
  for (Mesh& mesh : once.meshes) mesh.indices.clear();
  std::sort(triangles.begin(), triangles.end(), [](const Triangle& a, const Triangle& b) { return a.first < b.first; });
  for (const Triangle& t : triangles) {
    const std::vector<std::uint32_t>& from = model.meshes[t.mesh].indices;
    if (t.kept)
      once.meshes[t.mesh].indices.insert(once.meshes[t.mesh].indices.end(), &from[t.first], &from[t.first] + 3);
  }
  for (Mesh& mesh : once.meshes) dropUnused(mesh);
  return once;
}

}  // namespace

Model litLivingRoom(const Model& livingRoom) {
  Model model;
  for (const Material& source : livingRoom.materials) {
    model.materials.push_back(lambert(source.name, glm::vec3(source.baseColor)));
    model.materials.back().doubleSided = source.doubleSided;
  }
  for (Mesh mesh : eachSurfaceOnce(livingRoom).meshes) {
    mesh.uv.assign(mesh.positions.size(), glm::vec2(0.0f));  // no surface has a picture
    for (glm::vec3& normal : mesh.normals) normal = settled(normal);
    mesh.uv1.clear();
    mesh.tangents.clear();
    mesh.colors.clear();
    model.meshes.push_back(std::move(mesh));
  }
  model.instances = livingRoom.instances;
  return model;
}

}  // namespace boxprobe::scenes
