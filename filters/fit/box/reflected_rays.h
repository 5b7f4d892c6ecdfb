// The rays by which a probe's box is judged: eyes look at reflecting surfaces, and each reflected ray is followed to
// what it really meets. Called by fit_box.
#pragma once

#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/fit/rays/surface_rays.h"

namespace boxprobe {

/// A place as a fit sees it.
struct FitPlace {
  const SurfaceRays& shown;     ///< what eyes see
  const SurfaceRays& captured;  ///< what the probe and reflections see
  std::vector<Camera> eyes;     ///< whoever looks; may be empty
};

/// World space.
struct ReflectedRay {
  glm::dvec3 from{0.0}, along{0.0};  ///< unit
  glm::dvec3 hit{0.0};               ///< what the ray meets
  glm::dvec3 hitNormal{0.0};
  double weight = 0.0;
  bool seen = false;           ///< by an eye; else one of the even rays, and what follows is 0
  glm::dvec3 eye{0.0};         ///< who sees it
  glm::dvec3 fromNormal{0.0};  ///< of the reflecting surface, unit
  double roughness = 0.0;      ///< of the reflecting surface, perceptual
};

struct ReflectedRays {
  std::vector<ReflectedRay> rays;  ///< weights sum to 1
  double open = 0.0;               ///< share of the weight that leaves for the sky, which no box puts right
};

/// About `count` rays, the same on every call with the same `turn` (0 to 1; another one draws others). Four fifths of
/// the weight: reflections seen by the cameras - by people who stand about the probe where those see too few - by
/// pixel, Fresnel's term and gloss (surfaces rougher than 0.6 count only where nothing else reflects). A fifth: even
/// over what the probe lights, so that the fit is not one camera's. The surfaces that count are those in the probe's
/// influence, if it has one of its own, else those that its origin sees.
ReflectedRays reflectedRays(const FitPlace& place, const Probe& probe, int count, double turn = 0.0);

}  // namespace boxprobe
