// Rays against the triangles of a scene's models (Embree): how far the first surface is, whether its front was met, and
// how its material reflects. Called by the rest of filters/fit; knows no VTK and no files.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/fit/rays/surface_rays.h"

namespace boxprobe {

/// Whose view it is: objects may be hidden from one and shown to the other.
enum class SeenBy {
  Eyes,    ///< every visible object
  Probes,  ///< what captures show: stand-ins too, neither what moves nor what is hidden from probes
  Lamps,   ///< what throws their shadows: every visible object that does not move
};

/// Every triangle that is drawn and hides what is behind it, where the scene puts it. Left out: objects that are not
/// seen, glass (transmission) and what blends, through which light passes, and a dome with a painted sky about
/// everything else.
class TriangleRays : public SurfaceRays {
 public:
  using Models = std::vector<std::shared_ptr<const Model>>;

  /// `models` in the order of scene.models; `hidden`: nodes left out besides. Throws WorkError where the ray tracer
  /// cannot take them.
  TriangleRays(const Scene& scene, const Models& models, SeenBy seenBy = SeenBy::Eyes,
               const std::vector<std::string>& hidden = {});
  ~TriangleRays() override;
  TriangleRays(const TriangleRays&) = delete;
  TriangleRays& operator=(const TriangleRays&) = delete;

  bool empty() const { return triangles_ == 0; }
  const Box& bounds() const override { return bounds_; }
  /// Bounds without the far hundredth of the surfaces on every side, each counted by the root of its area: a lone thing
  /// far away, or a large plain under everything, does not stretch it.
  const Box& core() const { return core_; }

  std::optional<SurfaceHit> first(const glm::dvec3& origin, const glm::dvec3& direction) const override;
  /// Does any surface stand between two points?
  bool between(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  struct Structure;
  std::unique_ptr<Structure> structure_;
  glm::dvec3 anchor_{0.0};  ///< middle of everything: keeps the digits of a scene far from the origin
  Box bounds_, core_;
  std::size_t triangles_ = 0;
  struct Look {
    std::uint32_t firstTriangle = 0;
    double roughness = 0.0, reflectance = 0.0;
    glm::vec3 albedo{0.0f};
  };
  std::vector<Look> looks_;  ///< of one placed mesh after another
};

}  // namespace boxprobe
