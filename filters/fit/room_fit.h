// One probe for some cells of the free space: captured where that is best, its box fitted. Called by place_probes.
#pragma once

#include "filters/fit/fit_probe.h"
#include "filters/fit/rooms/find_rooms.h"

namespace boxprobe {

/// Of rays to choose by and to report: not those that boxes are fitted with.
inline constexpr double kScoreTurn = 0.37;

class RoomFitter {
 public:
  /// `fitter` and `rooms` must outlive this; `rays` as BoxFitSettings has them.
  RoomFitter(ProbeFitter& fitter, const Rooms& rooms, int rays) : fitter_(fitter), rooms_(rooms), rays_(rays) {}

  /// In the deepest of the cells, with the box about all of them and an influence that reaches a cell further.
  Probe start(const std::vector<std::size_t>& cells) const;

  /// From the best of sixteen origins, by litErrors of that box. Nothing, if `progress` stopped it.
  std::optional<BoxFit> fit(const std::vector<std::size_t>& cells, const FitProgress& progress) const;

 private:
  std::vector<glm::dvec3> origins(const std::vector<std::size_t>& cells) const;

  ProbeFitter& fitter_;
  const Rooms& rooms_;
  int rays_;
};

}  // namespace boxprobe
