// The projection rays of one surface point: the reflected ray, its hit on each probe's proxy, what is sampled, and the
// true hit. Uses only the shared mathematics, in the frame and precision of the shader.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/explain/explanation.h"
#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/relief.h"
#include "filters/vtk/rays/ray_arrays.h"

namespace boxprobe {

struct RayView {
  bool parallel = false;
  glm::dvec3 eyeWorld{0.0};              ///< perspective projection
  glm::dvec3 viewDirection{0, 0, -1.0};  ///< parallel projection: the camera's direction, world; need not be unit
};

struct RayProbe {
  std::string name;
  ProbeGeometry geometry;
  float maxLevel = 0.0f;                     ///< last level of its chain
  std::shared_ptr<const CubeMap> distances;  ///< null or empty: unknown
  LazyRelief relief;                         ///< of the distances
  std::shared_ptr<const CubeMap> coverage;   ///< transmittance, levels of plain means; null: unknown
  std::uint32_t shadowLights = 0;            ///< one bit per light that it shadows
};

/// The part that does not depend on probes.
struct SurfaceRay {
  int status = 0;  ///< kRayNoNormal, kRayEyeOnPoint, kRayFromBehind
  glm::dvec3 positionWorld{0.0};
  glm::dvec3 normalWorld{0.0};  ///< unit; zero if kRayNoNormal
  glm::dvec3 viewWorld{0.0};    ///< towards the eye, unit; zero if kRayEyeOnPoint
  glm::dvec3 reflectionWorld{0.0};
  float roughness = 0.0f;
  bool reflects() const { return (status & (kRayNoNormal | kRayEyeOnPoint)) == 0; }
};

/// `normalWorld` need not be unit, nor finite. The position must be finite.
SurfaceRay surfaceRay(const glm::dvec3& positionWorld, const glm::dvec3& normalWorld, float roughness,
                      const RayView& view);

struct ProbeRay {
  int status = 0;  ///< kRayNoProxy, kRayPointOutside, kRayOriginOutside
  std::optional<double> hitDistance;
  glm::dvec3 hitWorld{0.0};  ///< undefined without hitDistance
  int face = -1;
  glm::vec3 direction{0.0f};  ///< what the projection samples, probe frame
  std::vector<Lookup> lookups;
  std::optional<double> trueDistance;  ///< from the probe's own distances
};

/// `ray` must have a reflection.
ProbeRay probeRay(const SurfaceRay& ray, const RayProbe& probe);

/// Each probe's share of the point, as in probe_lighting.glsl: by importance, then in proportion.
std::vector<float> probeShares(const glm::dvec3& positionWorld, const std::vector<RayProbe>& probes);

}  // namespace boxprobe
