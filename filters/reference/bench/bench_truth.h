// The reference colours of techniques at the very points that the renderer shades: both references for a list of
// explained pixels, sampled until their own noise is small.
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
  double standardError = 0.001;  ///< of tone-mapped values: sampling of a pixel stops there
  std::uint64_t seed = 1;
};

struct TruthColors {
  std::vector<glm::dvec3> color;  ///< one per pixel; everything except the reflection is from the explained pixel
  /// RMS of the standard error of tone-mapped values, over pixels and components.
  double standardError = 0.0;
  double raysPerPixel = 0.0;
  bool complete = true;  ///< false: `progress` stopped it
};

/// The reference for the probe's box.
TruthColors boxTruth(const std::vector<BenchPixel>& pixels, const ReferenceBoxMaps& maps, const TruthSettings& settings,
                     const ReferenceProgress& progress);

/// The reference for the traced scene: samples its difference from `box` and adds it (a control variate), because where
/// the room equals the box hardly anything is left to sample. Pixels that the tracer misses keep the box's colour.
TruthColors sceneTruth(const std::vector<BenchPixel>& pixels, const TruthColors& box, const ReferenceBoxMaps& maps,
                       const ReferenceScene& scene, const TruthSettings& settings, const ReferenceProgress& progress);

}  // namespace boxprobe
