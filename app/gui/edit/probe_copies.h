#pragma once

#include <array>
#include <map>
#include <set>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Copies of probes for a scene, pasted or duplicated. Time grows with n log n, also for copies of one probe.
class ProbeCopies {
 public:
  explicit ProbeCopies(const Scene& scene);

  /// The probe with a name of its own, moved along its box's X in steps of a tenth of the width until it coincides with
  /// no other, from which it could not be distinguished. The next copies avoid it as well.
  Probe add(Probe probe);

 private:
  using Place = std::array<double, 12>;  ///< box, origin, rotation; rounded
  static Place placeOf(const Probe& probe);

  ProbeNames names_;
  std::set<Place> taken_;
  std::map<Place, Probe> last_;  ///< by the place of what was copied: the last copy
};

}  // namespace boxprobe
