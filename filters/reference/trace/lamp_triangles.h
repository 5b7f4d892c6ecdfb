// Triangles that are much brighter than the rest of the scene, for sampling: otherwise it would take thousands of rays
// to meet a small lamp.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "filters/reference/trace/scene_tracer.h"

namespace boxprobe {

class LampTriangles {
 public:
  /// By the emission of materials; textures count as white.
  explicit LampTriangles(const TriangleScene& scene);

  /// Nothing is much brighter than the rest: sampling the lobe is enough.
  bool empty() const { return triangles_.empty(); }
  bool shines(const TracedHit& hit) const { return objects_[static_cast<std::size_t>(hit.object)]; }

  /// A point of a lamp, drawn by power, whether or not it is visible.
  struct Towards {
    glm::dvec3 direction{0.0};  ///< unit
    int object = 0;             ///< index into TriangleScene::objects
    std::uint32_t triangle = 0;
    /// Is that the surface which a ray in this direction met? Light from other sides of a lamp, or from things in
    /// front, must not be counted with this point's density.
    bool meets(const TracedHit& hit) const { return hit.object == object && hit.triangle == triangle; }
  };
  /// From two numbers in [0, 1).
  Towards towards(const glm::dvec3& fromWorld, const glm::dvec2& u) const;
  /// The density of towards() at the point that was hit on a lamp, per solid angle from the start of its ray.
  double density(const TracedHit& hit) const;

 private:
  struct Triangle {
    glm::dvec3 corner{0.0}, along{0.0}, up{0.0};  ///< world
    int object = 0;
    std::uint32_t number = 0;  ///< in its object
    double cumulated = 0.0;    ///< cumulative share of the power
  };
  std::vector<Triangle> triangles_;
  std::vector<bool> objects_;
  std::vector<double> perArea_;  ///< per object: probability density of its points, per unit of area
};

}  // namespace boxprobe
