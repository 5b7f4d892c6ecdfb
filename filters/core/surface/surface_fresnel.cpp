#include "filters/core/surface/surface_fresnel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "filters/math/shared/finish_math.h"

namespace boxprobe {

namespace {

/// The two ends without a film.
SurfaceFresnel plainFresnel(const SurfacePoint& s) {
  const glm::vec3 dielectric = s.finish ? s.finish->f0 : glm::vec3(s.baseF0);
  const glm::vec3 f0 = glm::mix(dielectric, s.albedo, s.metallic);
  const float edge =
      s.finish && s.finish->tinted ? s.finish->edge : glm::clamp(glm::dot(f0, glm::vec3(50.0f * 0.33f)), 0.0f, 1.0f);
  return {f0, glm::mix(glm::vec3(edge), glm::vec3(1.0f), s.metallic)};
}

}  // namespace

SurfaceFresnel surfaceFresnel(const SurfacePoint& s, float nDotV) {
  SurfaceFresnel ends = plainFresnel(s);
  if (!s.finish || s.finish->iridescence <= 0.0f) return ends;
  const glm::vec3 film = shading::filmNormalReflectance(
      shading::filmReflectance(ends.f0, s.finish->filmIor, s.finish->filmThickness, nDotV), nDotV);
  ends.f0 = glm::mix(ends.f0, film, s.finish->iridescence);
  return ends;
}

float passesSheen(const SurfacePoint& s, float nDotV) {
  if (!s.finish || !s.finish->hasSheen()) return 1.0f;
  return shading::underSheen(s.finish->sheenColor, nDotV, s.finish->sheenRoughness);
}

}  // namespace boxprobe
