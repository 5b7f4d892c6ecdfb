// The world as box projection has it, integrated: a lobe's mean of what the probe's own unfiltered capture shows where
// its rays meet the box, in double precision. What is left of a technique's error against this is the technique's
// alone: neither the box's nor the capture's. Called by the command line, the benchmark and tests, with explanations of
// pixels, which say what the surface is and which probes light it; knows no GL.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "filters/core/baked_probe.h"
#include "filters/core/explanation.h"
#include "filters/math/brdf_table.h"

namespace boxprobe {

/// What a probe holds where a ray meets its box.
class BoxWorld {
 public:
  /// `radiance`: the probe's chain, of which level 0 is read; it must outlive this. Box and position are the
  /// explanation's.
  BoxWorld(const ProbeExplanation& probe, const CubeMap& radiance);

  /// `directionWorld` unit. The exit from the box; a position outside counts as on the nearest face.
  glm::dvec3 radiance(const glm::dvec3& directionWorld) const;
  /// That point, world axes, relative to the capture origin.
  glm::dvec3 hit(const glm::dvec3& directionWorld) const;

 private:
  const CubeMap& map_;
  glm::dmat3 worldFromProbe_;
  glm::dvec3 position_, low_, high_;  ///< probe frame
};

struct ReferenceBoxMaps {
  std::vector<std::shared_ptr<const BakedMaps>> probes;  ///< in the scene's order; null: gives nothing
  std::shared_ptr<const BakedMaps> sky;                  ///< null: black
};

/// One estimate of the colour of an explained pixel, all of whose probes are taken as box worlds whatever their
/// technique, the sky as it is. Everything but reflections is the explanation's own. `exact`: says whether another seed
/// would give the same. Mean of estimates with independent seeds: the reference; their spread: its standard error.
glm::dvec3 referenceBoxColor(const Explanation& pixel, const ReferenceBoxMaps& maps, const BrdfTable& brdf, int rays,
                             std::uint64_t seed, bool* exact = nullptr);

}  // namespace boxprobe
