// Run time against error: a technique as a point, and which points no other beats in both. Called by the benchmark, its
// chart, and whoever shows an earlier run's results; knows no renderer and no file.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

struct ParetoPoint {
  std::string id;      ///< full technique id
  std::string label;   ///< with the parameters that differ from their defaults
  double cost = 0.0;   ///< frame time over plain box projection's
  double error = 0.0;  ///< tone-mapped RMSE
  bool onParetoFront = false;
  bool ours = false;  ///< false: as published elsewhere
};

/// Sets `onParetoFront` of each: no other is at most as costly and at most as wrong, and better in one of the two.
void markParetoFront(std::vector<ParetoPoint>& points);

}  // namespace boxprobe
