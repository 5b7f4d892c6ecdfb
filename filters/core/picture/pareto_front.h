// Run time against error: techniques as points, and the Pareto front among them.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

struct ParetoPoint {
  std::string id;      ///< full technique id
  std::string label;   ///< with the parameters that differ from their defaults
  double cost = 0.0;   ///< frame time relative to plain box projection's
  double error = 0.0;  ///< tone-mapped RMSE
  bool onParetoFront = false;
  bool ours = false;  ///< false: as published elsewhere
};

/// Sets `onParetoFront` of each point: no other has at most its cost and at most its error, and less of one of them.
void markParetoFront(std::vector<ParetoPoint>& points);

}  // namespace boxprobe
