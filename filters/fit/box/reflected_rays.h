// The rays by which a probe's box is rated: eyes look at reflecting surfaces, and each reflected ray is traced to what
// it meets.
#pragma once

#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/fit/rays/surface_rays.h"

namespace boxprobe {

/// The scene as a fit sees it.
struct FitPlace {
  const SurfaceRays& shown;     ///< what eyes see
  const SurfaceRays& captured;  ///< what the probe and reflections see
  std::vector<Camera> eyes;     ///< of viewers; may be empty
};

/// World space.
struct ReflectedRay {
  glm::dvec3 from{0.0}, along{0.0};  ///< unit
  glm::dvec3 hit{0.0};               ///< what the ray meets
  glm::dvec3 hitNormal{0.0};
  double weight = 0.0;
  bool seen = false;           ///< by an eye; else one of the evenly distributed rays, and the members below are 0
  glm::dvec3 eye{0.0};         ///< the viewer
  glm::dvec3 fromNormal{0.0};  ///< of the reflecting surface, unit
  double roughness = 0.0;      ///< of the reflecting surface, perceptual
};

struct ReflectedRays {
  std::vector<ReflectedRay> rays;  ///< weights sum to 1
  double open = 0.0;               ///< share of the weight that reaches the sky; no box can fix it
};

/// About `count` rays, the same for the same `turn` (0 to 1). Four fifths of the weight are reflections seen by the
/// cameras, or by people standing around the probe where the cameras see too few, weighted by pixel, Fresnel term and
/// gloss (surfaces rougher than 0.6 count only if nothing else reflects). One fifth is distributed evenly over what the
/// probe lights, so that the fit does not depend on one camera. Surfaces count if they are in the probe's influence, if
/// that is separate, else if its origin sees them.
ReflectedRays reflectedRays(const FitPlace& place, const Probe& probe, int count, double turn = 0.0);

}  // namespace boxprobe
