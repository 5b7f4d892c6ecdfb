// Diffuse light of a scene's probes as its picture has it: the coefficients of each or, with lamps as shapes, the lamps
// and the lattice. The same mathematics as in the shader, for references that take everything but the reflection from
// the picture.
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
  std::shared_ptr<const DiffuseLattice> lattice;  ///< with `lamps`: used in place of the coefficients unless null
  std::vector<SceneLamp> lamps;
  std::vector<int> lampChannels;            ///< of each of `lamps` in `sight`
  std::shared_ptr<const ProbeSight> sight;  ///< visibility of lamps and light sources; null: all visible
};

struct ProbesDiffuse {
  std::vector<std::optional<ProbeDiffuse>> probes;  ///< in the scene's order; empty for probes without maps
  std::set<std::size_t> countedLights;              ///< of the scene: those that a lamp stands for, which give no light
};

/// Irradiance over pi at a point (world), before weight and intensity. `probe`: as it is drawn.
glm::vec3 diffuseAt(const ProbeDiffuse& diffuse, const ProbeGeometry& probe, const glm::dvec3& positionWorld,
                    const glm::vec3& normalWorld);

/// The visibility, 0 to 1, in a channel of the sight at a point; kSeenByAll and kSeenByNone are valid channels.
float seenAt(const ProbeSight* sight, int channel, const ProbeGeometry& probe, const glm::dvec3& positionWorld,
             const glm::vec3& normalWorld);

}  // namespace boxprobe
