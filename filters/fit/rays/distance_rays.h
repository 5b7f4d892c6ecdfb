// Traces rays where only a probe's captured distances are known: marches until the ray passes behind what the probe
// saw.
#pragma once

#include <glm/mat3x3.hpp>

#include "filters/fit/rays/surface_rays.h"
#include "filters/math/cube/cube_map.h"

namespace boxprobe {

class DistanceRays : public SurfaceRays {
 public:
  /// `distance`: red channel, scene units, 0 where nothing was seen; must outlive this object. `worldFromMap`: rotation
  /// from the axes along which it was captured.
  DistanceRays(const CubeMap& distance, const glm::dvec3& originWorld, const glm::dmat3& worldFromMap);

  /// Surfaces face the capture origin; their reflectance is unknown. What the origin did not see does not exist here.
  std::optional<SurfaceHit> first(const glm::dvec3& origin, const glm::dvec3& direction) const override;
  const Box& bounds() const override { return bounds_; }

 private:
  glm::dvec3 normalAt(const glm::dvec3& positionMap) const;

  const CubeMap& distance_;
  glm::dvec3 origin_;
  glm::dmat3 worldFromMap_;
  Box bounds_;
  double farthest_ = 0.0;
};

}  // namespace boxprobe
