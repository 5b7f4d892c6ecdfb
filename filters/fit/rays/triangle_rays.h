// Traces rays against the triangles of a scene's models with Embree: the distance, the side that was met, and how the
// material reflects.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/fit/rays/surface_rays.h"

namespace boxprobe {

/// Who sees the scene: objects may be hidden from one and visible to another.
enum class SeenBy {
  Eyes,    ///< every visible object
  Probes,  ///< what captures show: includes stand-ins, excludes moving objects and those hidden from probes
  Lamps,   ///< what casts their shadows: every visible static object
};

/// Every triangle that is drawn and opaque, as the scene places it. Excludes invisible objects, materials that transmit
/// or blend, and a dome with a painted sky around everything else.
class TriangleRays : public SurfaceRays {
 public:
  using Models = std::vector<std::shared_ptr<const Model>>;

  /// `models` in the order of scene.models; `hidden`: further nodes to exclude. Throws WorkError if the ray tracer
  /// cannot take the models.
  TriangleRays(const Scene& scene, const Models& models, SeenBy seenBy = SeenBy::Eyes,
               const std::vector<std::string>& hidden = {});
  ~TriangleRays() override;
  TriangleRays(const TriangleRays&) = delete;
  TriangleRays& operator=(const TriangleRays&) = delete;

  bool empty() const { return triangles_ == 0; }
  const Box& bounds() const override { return bounds_; }
  /// Bounds without the outermost hundredth of the surfaces on each side, each weighted by the root of its area: a lone
  /// object far away, or a large ground plane, does not extend it.
  const Box& core() const { return core_; }

  std::optional<SurfaceHit> first(const glm::dvec3& origin, const glm::dvec3& direction) const override;
  /// Is there a surface between two points?
  bool between(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  struct Structure;
  std::unique_ptr<Structure> structure_;
  glm::dvec3 anchor_{0.0};  ///< the middle of everything: preserves precision in a scene far from the origin
  Box bounds_, core_;
  std::size_t triangles_ = 0;
  struct Look {
    std::uint32_t firstTriangle = 0;
    double roughness = 0.0, reflectance = 0.0;
    glm::vec3 albedo{0.0f}, emitted{0.0f};
    bool bothSides = false;  ///< shine
  };
  std::vector<Look> looks_;  ///< one per placed mesh
};

}  // namespace boxprobe
