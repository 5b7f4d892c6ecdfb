// The scene's triangles that shine much brighter than the rest: points to draw rays towards, so that a small lamp does
// not need thousands of rays before one meets it. Called by the scene reference; knows no surface that reflects.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "filters/reference/trace/scene_tracer.h"

namespace boxprobe {

class LampTriangles {
 public:
  /// By emission as materials state it; textures count as white.
  explicit LampTriangles(const TriangleScene& scene);

  /// Nothing stands out: rays by the lobe alone do as well.
  bool empty() const { return triangles_.empty(); }
  bool shines(const TracedHit& hit) const { return objects_[static_cast<std::size_t>(hit.object)]; }

  /// A point of a lamp, drawn by power, whatever hides it.
  struct Towards {
    glm::dvec3 direction{0.0};  ///< unit
    int object = 0;             ///< index into TriangleScene::objects
    std::uint32_t triangle = 0;
    /// Is that the surface which a ray in this direction met? A lamp has other sides, and things stand before it: light
    /// of those is not to be counted with this point's density.
    bool meets(const TracedHit& hit) const { return hit.object == object && hit.triangle == triangle; }
  };
  /// By two numbers in [0, 1).
  Towards towards(const glm::dvec3& fromWorld, const glm::dvec2& u) const;
  /// How densely towards() draws the point that was hit on a lamp, per solid angle about where its ray started.
  double density(const TracedHit& hit) const;

 private:
  struct Triangle {
    glm::dvec3 corner{0.0}, along{0.0}, up{0.0};  ///< world
    int object = 0;
    std::uint32_t number = 0;  ///< in its object
    double cumulated = 0.0;    ///< share of the power, with all before it
  };
  std::vector<Triangle> triangles_;
  std::vector<bool> objects_;
  std::vector<double> perArea_;  ///< of each object: how likely a point of it is drawn, per unit of area
};

}  // namespace boxprobe
