// Ray-traced glass, the reference for the real-time forms: every interface with Fresnel's reflectance and Snell's law,
// both refractions and internal reflections, absorption along the true path, roughness by microfacets. Shares no line
// with shaders/shared/refraction.glsl, which it judges.
//
// Exact definition: a smooth surface splits each ray in two, until a branch carries less than a thousandth. A rough one
// draws visible half vectors of GGX and reflects or refracts at each, in proportion to Fresnel's term. No light is lost
// between facets: a direction that points back into its surface is drawn again. A thin sheet counts as one interface
// with both of its faces, without refraction. Light that has left sees what `outside` shows; if that is glass again, it
// continues through it.
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

  /// Mean radiance over `rays` rays along `direction` (unit) that meet glass at `hit`; for smooth glass one ray is
  /// exact.
  glm::dvec3 seen(const TracedHit& hit, const glm::dvec3& direction, int rays, std::uint64_t seed) const;

 private:
  struct Path;
  glm::dvec3 meet(const TracedHit& hit, const glm::dvec3& direction, double weight, int depth, Path& path) const;
  glm::dvec3 follow(const glm::dvec3& origin, const glm::dvec3& direction, int within, int passed, double weight,
                    int depth, Path& path) const;

  const SceneTracer& tracer_;
  Outside outside_;
};

/// Is the surface so smooth that one ray is enough?
bool smoothGlass(double roughness);

}  // namespace boxprobe
