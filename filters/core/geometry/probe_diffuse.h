// Diffuse light of a scene's probes as its picture has it: of each its coefficients, or, with lamps drawn as shapes,
// these and the lattice. The same mathematics as the shader's, for references that take everything but the reflection
// from the picture. Plain values; knows neither VTK nor rays.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "filters/core/geometry/lamp_sight.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/scene_lamps.h"
#include "filters/math/cube/diffuse_lattice.h"
#include "filters/math/cube/spherical_harmonics.h"

namespace boxprobe {

struct ProbeDiffuse {
  ShCoefficients coefficients{};
  std::shared_ptr<const DiffuseLattice> lattice;  ///< in place of the coefficients, with `lamps`; null: those
  std::vector<SceneLamp> lamps;
  std::vector<int> lampChannels;            ///< of each of `lamps` in `sight`
  std::shared_ptr<const ProbeSight> sight;  ///< what is seen of lamps and light sources; null: all of them
};

struct ProbesDiffuse {
  std::vector<std::optional<ProbeDiffuse>> probes;  ///< in the scene's order; nothing for one without maps
  std::set<std::size_t> countedLights;              ///< of the scene, those that a lamp stands for: they give nothing
};

/// Irradiance over pi at a point (world), before weight and intensity. `probe`: as it is drawn.
glm::vec3 diffuseAt(const ProbeDiffuse& diffuse, const ProbeGeometry& probe, const glm::dvec3& positionWorld,
                    const glm::vec3& normalWorld);

/// Share that a channel of the sight says is seen from there; kSeenByAll and kSeenByNone are channels, too.
float seenAt(const ProbeSight* sight, int channel, const ProbeGeometry& probe, const glm::dvec3& positionWorld,
             const glm::vec3& normalWorld);

}  // namespace boxprobe
