// One surface point's projection rays as plain values: the reflected ray, where it hits each probe's proxy, what is
// looked up and where the ray really hits. Only the shared mathematics, in the frame and precision the shader uses;
// called by vtkProjectionRays, which turns the values into lines. Knows no VTK.
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
  glm::dvec3 eyeWorld{0.0};              ///< perspective
  glm::dvec3 viewDirection{0, 0, -1.0};  ///< parallel projection: the way the camera looks, world; need not be unit
};

struct RayProbe {
  std::string name;
  ProbeGeometry geometry;
  float maxLevel = 0.0f;                     ///< last level of its chain
  std::shared_ptr<const CubeMap> distances;  ///< null or empty: not known
  LazyRelief relief;                         ///< of them
  std::shared_ptr<const CubeMap> coverage;   ///< what it lets through, levels of plain means; null: not known
  std::uint32_t shadowLights = 0;            ///< a bit for each light that it stands before
};

/// What there is before any probe.
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
  glm::dvec3 hitWorld{0.0};  ///< meaningless without hitDistance
  int face = -1;
  glm::vec3 direction{0.0f};  ///< what the projection looks up, probe frame
  std::vector<Lookup> lookups;
  std::optional<double> trueDistance;  ///< by the probe's own distances
};

/// `ray` must reflect.
ProbeRay probeRay(const SurfaceRay& ray, const RayProbe& probe);

/// Each probe's share of the point, as probe_lighting.glsl deals them out: by importance, then in proportion.
std::vector<float> probeShares(const glm::dvec3& positionWorld, const std::vector<RayProbe>& probes);

}  // namespace boxprobe
