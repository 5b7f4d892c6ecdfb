// Parts of the tuning for drivers (program_tuning.h) that can be disabled to measure their gain.
#pragma once

namespace boxprobe {

enum TuningPart : unsigned {
  kTunedFacts = 1u,        ///< programs omit what a material makes unnecessary (surface_facts.h)
  kTunedConstants = 2u,    ///< at rest, values are constants of programs (constants.h)
  kTunedFlatMaps = 4u,     ///< with these, flat pictures of maps are sampled (flat_texture.h)
  kTunedFirstBounce = 8u,  ///< first captures use programs without probe lookups
  kTunedHidden = 16u,      ///< frames of a view at rest cull what an earlier frame found hidden (still_view.h)
  kAllTuning = 31u,
};
using TuningParts = unsigned;  ///< of TuningPart

}  // namespace boxprobe
