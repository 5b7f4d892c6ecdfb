#include "filters/explain/explain_glass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

shading::GlassView lookThrough(const ExplainedGlass& glass, const SurfacePoint& s) {
  const glm::vec3 position(s.positionWorld - s.eyeWorld);
  return shading::lookThroughGlass(glass.shell, glass.object, position, s.normalWorld, s.viewWorld, s.roughness,
                                   s.backSide, glm::length(position));
}

glm::vec3 mirrorTransmittance(const ExplainedGlass& glass, const SurfacePoint& s, const shading::GlassView& seen) {
  if (!s.backSide || glass.object.sheet) return glm::vec3(1.0f);
  const float distance = seen.followed ? seen.mirrored.distance : glm::length(glm::vec3(s.positionWorld - s.eyeWorld));
  return shading::glassTransmittance(glass.attenuationColor, glass.attenuationDistance, distance);
}

GlassExplanation explainGlass(const ExplainedGlass& glass, const SurfacePoint& s, const shading::GlassView& seen,
                              float reflected, const GatherGlass& gather) {
  GlassExplanation e;
  e.form = glass.form;
  e.back = s.backSide;
  e.ior = glass.object.ior;
  e.eta = s.backSide && !glass.object.sheet ? e.ior : 1.0f / e.ior;
  e.reflectance = seen.reflectance;
  e.followed = seen.followed;
  e.directionWorld = seen.through.direction;
  e.exitWorld = s.eyeWorld + glm::dvec3(seen.through.position);
  e.distance = seen.through.distance;
  e.roughness = std::sqrt(seen.through.alpha);
  e.mirrored = seen.through.mirrored;
  e.transmittance = shading::glassTransmittance(glass.attenuationColor, glass.attenuationDistance, e.distance);
  e.passed = glass.transmission * (1.0f - s.metallic) * (1.0f - reflected) * s.albedo * e.transmittance;
  const GatheredGlass light = gather(e.exitWorld, e.directionWorld, e.roughness);
  e.looked = light.specular;
  e.lookups = light.lookups;
  e.brightestTexel = light.brightestTexel;
  e.sources = light.sources;
  const glm::vec3 position(s.positionWorld - s.eyeWorld);
  const float bent = std::clamp(
      shading::glassDeviation(glass.object, seen.through, position, s.viewWorld) / glass.straightAngle, 0.0f, 1.0f);
  const float behind = s.backSide ? 0.0f : glass.behind;
  e.stands = (1.0f - bent * (1.0f - behind)) * std::min({e.passed.x, e.passed.y, e.passed.z});
  return e;
}

}  // namespace boxprobe
