// Parts of what is done for a driver's sake (program_tuning.h) that can be switched off, to find what each gains.
#pragma once

namespace boxprobe {

enum TuningPart : unsigned {
  kTunedFacts = 1u,        ///< programs leave out what a material makes needless (surface_facts.h)
  kTunedConstants = 2u,    ///< at rest, numbers are constants of programs (constants.h)
  kTunedFlatMaps = 4u,     ///< with these, maps are looked up in flat pictures of them (flat_texture.h)
  kTunedFirstBounce = 8u,  ///< first captures are drawn by programs without lookups of probes
  kTunedHidden = 16u,      ///< frames of a view at rest cull what the one before hid (still_view.h)
  kAllTuning = 31u,
};
using TuningParts = unsigned;  ///< of TuningPart

}  // namespace boxprobe
