// See made_flat.h.
#include "tests/support/made_flat.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <utility>

namespace boxprobe::test {

namespace {

class FlatMaker {
 public:
  explicit FlatMaker(const FlatWishes& wishes) : wishes_(wishes) {}

  /// From `corner` along `u` and `v`; seen from where u to v runs counter-clockwise.
  void quad(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const glm::vec3 normal = (wishes_.inverted ? -1.0f : 1.0f) * glm::normalize(turned(glm::cross(u, v)));
    for (const glm::dvec2& uv : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1), glm::dvec2(0, 1)}) {
      mesh.positions.push_back(static_cast<float>(wishes_.unitsPerMetre) * turned(corner + uv.x * u + uv.y * v));
      mesh.normals.push_back(normal);
      mesh.uv.emplace_back(uv);
    }
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
    if (!wishes_.inverted) return;
    for (std::size_t i = mesh.indices.size() - 6; i < mesh.indices.size(); i += 3) {
      std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
  }
  /// All sides seen from inside, or from outside; a wall at x = `open` has the door's hole.
  void box(const glm::dvec3& low, const glm::dvec3& high, bool fromInside, double open = 1e9) {
    const glm::dvec3 s = high - low;
    const auto side = [&](const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
      fromInside ? quad(corner, u, v) : quad(corner, v, u);
    };
    side(low, {0, 0, s.z}, {s.x, 0, 0});
    side({low.x, high.y, low.z}, {s.x, 0, 0}, {0, 0, s.z});
    side(low, {s.x, 0, 0}, {0, s.y, 0});
    side({high.x, low.y, high.z}, {-s.x, 0, 0}, {0, s.y, 0});
    for (const bool upper : {false, true}) {
      const double x = upper ? high.x : low.x;
      const auto wall = [&](double z0, double z1, double y0, double y1) {
        const glm::dvec3 z(0, 0, z1 - z0), y(0, y1 - y0, 0);
        upper ? side({x, y0, z0}, z, y) : side({x, y0, z0}, y, z);
      };
      if (std::abs(x - open) > 1e-9) {
        wall(low.z, high.z, low.y, high.y);
      } else {
        wall(low.z, -kHalfDoor, low.y, high.y);
        wall(kHalfDoor, high.z, low.y, high.y);
        wall(-kHalfDoor, kHalfDoor, kDoorHeight, high.y);
      }
    }
  }
  void doorFrame(double x0, double x1) {
    const glm::dvec3 x(x1 - x0, 0, 0), y(0, kDoorHeight, 0), z(0, 0, 2.0 * kHalfDoor);
    quad({x0, 0, -kHalfDoor}, z, x);
    quad({x0, kDoorHeight, -kHalfDoor}, x, z);
    quad({x0, 0, -kHalfDoor}, x, y);
    quad({x0, 0, kHalfDoor}, y, x);
  }

  Mesh mesh;

 private:
  static constexpr double kHalfDoor = 0.45, kDoorHeight = 2.0;

  glm::vec3 turned(const glm::dvec3& p) const {
    const double a = glm::radians(wishes_.yawDegrees), c = std::cos(a), s = std::sin(a);
    return {c * p.x + s * p.z, p.y, -s * p.x + c * p.z};
  }

  const FlatWishes& wishes_;
};

}  // namespace

Model madeFlat(const FlatWishes& wishes) {
  FlatMaker make(wishes);
  make.box({-4.1, 0, -1.5}, {-0.1, 2.6, 1.5}, true, -0.1);
  make.box({0.1, 0, -1.5}, {5.1, 2.6, 1.5}, true, 0.1);
  make.doorFrame(-0.1, 0.1);
  make.box({3.0, 0.0, -1.3}, {4.2, 0.75, -0.6}, false);  // a table, closed to the floor
  if (wishes.groundMetres > 0.0) {
    const double side = wishes.groundMetres;
    make.quad({-0.5 * side, -0.1, 0.5 * side}, {side, 0, 0}, {0, 0, -side});
  }
  Model model;
  model.materials.emplace_back().roughness = wishes.roughness;
  model.meshes.push_back(std::move(make.mesh));
  model.meshes.front().material = 0;
  model.instances.push_back({"flat", 0, glm::dmat4(1.0)});
  return model;
}

}  // namespace boxprobe::test
