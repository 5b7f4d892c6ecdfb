// The colours that techniques are judged by, at the very points that the renderer shades: both references for a list of
// explained pixels, estimated on all cores until their own noise is small. Called by the benchmark; knows no renderer.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "filters/reference/bench/bench_surfaces.h"
#include "filters/reference/light/reference_box.h"
#include "filters/reference/light/reference_scene.h"

namespace boxprobe {

struct TruthSettings {
  int raysPerPass = 64;
  int leastPasses = 4;
  int mostPasses = 64;
  double standardError = 0.001;  ///< of tone-mapped values: a pixel that is at it gets no more rays
  std::uint64_t seed = 1;
};

struct TruthColors {
  std::vector<glm::dvec3> color;  ///< one per pixel, everything but the reflection being the point's own
  /// Root mean square of the standard error of tone-mapped values, over pixels and components.
  double standardError = 0.0;
  double raysPerPixel = 0.0;
  bool complete = true;  ///< false: `progress` stopped it
};

/// Against the probe's box.
TruthColors boxTruth(const std::vector<BenchPixel>& pixels, const ReferenceBoxMaps& maps, const TruthSettings& settings,
                     const ReferenceProgress& progress);

/// Against the traced scene: what it differs in from `box`, sampled, on top of that (a control variate), since where
/// the room is the box next to nothing is left to sample. Pixels the tracer does not find keep the box's colour.
TruthColors sceneTruth(const std::vector<BenchPixel>& pixels, const TruthColors& box, const ReferenceBoxMaps& maps,
                       const ReferenceScene& scene, const TruthSettings& settings, const ReferenceProgress& progress);

}  // namespace boxprobe
