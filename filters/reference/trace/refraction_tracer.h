// Glass, ray traced: every interface with Fresnel's reflectance and Snell's law, both bends and what is mirrored
// within, absorption on the true way, roughness by microfacets. What the real-time forms of glass are measured against.
// Called by the scene reference; knows no probe. Shares no line with shaders/shared/refraction.glsl, which it judges.
//
// What it is, exactly: a smooth surface splits each ray in two, until a branch carries less than a thousandth; a rough
// one draws half vectors of GGX visible from the ray and either mirrors or bends each, by Fresnel's share. No light is
// lost between facets: a direction that points back into its surface is drawn again. A thin sheet is met once, with
// both of its faces, and bends nothing. Light that has left sees what `outside` shows; if that is glass again, it goes
// on through it.
#pragma once

#include <cstdint>
#include <functional>

#include "filters/reference/trace/scene_tracer.h"

namespace boxprobe {

class RefractionTracer {
 public:
  /// Radiance along a ray that meets no glass.
  using Outside = std::function<glm::dvec3(const glm::dvec3& origin, const glm::dvec3& direction)>;
  RefractionTracer(const SceneTracer& tracer, Outside outside) : tracer_(tracer), outside_(std::move(outside)) {}

  /// Mean radiance over `rays` rays that look along `direction` (unit) and meet glass at `hit`; of smooth glass one is
  /// all there is to know.
  glm::dvec3 seen(const TracedHit& hit, const glm::dvec3& direction, int rays, std::uint64_t seed) const;

 private:
  struct Path;
  glm::dvec3 meet(const TracedHit& hit, const glm::dvec3& direction, double weight, int depth, Path& path) const;
  glm::dvec3 follow(const glm::dvec3& origin, const glm::dvec3& direction, int within, int passed, double weight,
                    int depth, Path& path) const;

  const SceneTracer& tracer_;
  Outside outside_;
};

/// Is the surface so smooth that one ray tells all?
bool smoothGlass(double roughness);

}  // namespace boxprobe
