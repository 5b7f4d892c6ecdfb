// Fits one probe to some cells of the free space: finds the best capture origin and the box.
#pragma once

#include "filters/fit/fit_probe.h"
#include "filters/fit/rooms/find_rooms.h"

namespace boxprobe {

/// For rays that choose and report: different from those that boxes are fitted with.
inline constexpr double kScoreTurn = 0.37;

class RoomFitter {
 public:
  /// `fitter` and `rooms` must outlive this object; `rays` as in BoxFitSettings.
  RoomFitter(ProbeFitter& fitter, const Rooms& rooms, int rays) : fitter_(fitter), rooms_(rooms), rays_(rays) {}

  /// A probe in the deepest of the cells, with the box around all of them and an influence box one cell larger.
  Probe start(const std::vector<std::size_t>& cells) const;

  /// From the best of sixteen origins, by litErrors of the fitted box. Nothing if `progress` stopped it.
  std::optional<BoxFit> fit(const std::vector<std::size_t>& cells, const FitProgress& progress) const;

 private:
  std::vector<glm::dvec3> origins(const std::vector<std::size_t>& cells) const;

  ProbeFitter& fitter_;
  const Rooms& rooms_;
  int rays_;
};

}  // namespace boxprobe
