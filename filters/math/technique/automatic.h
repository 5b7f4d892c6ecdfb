// `auto`: the cheapest technique whose error stays within a budget for the roughness of what is drawn, from a table of
// measured costs and errors. A mirror needs no contact hardening, and a rough wall no sixteen lookups; a fixed
// technique pays for both everywhere. Resolved for each draw.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "filters/math/technique/technique_table.h"

namespace boxprobe {

/// One technique as `boxprobe bench` measured it, with a box that is exactly the room.
struct MeasuredTechnique {
  std::string_view id;
  double cost = 1.0;  ///< what it adds to a frame without reflections, relative to what plain box projection adds
  /// RMSE of (x/(1+x))^(1/2.2) against the integral over the box world, the larger of the gallery's and of random
  /// rooms', at the roughnesses of measuredRoughness().
  std::array<double, 6> error{};
};

/// 0, .1, .25, .5, .75, 1.
const std::array<double, 6>& measuredRoughness();
/// In order of increasing cost.
const std::vector<MeasuredTechnique>& measuredTechniques();

struct AutomaticChoice {
  Technique technique;
  double error = 0.0;         ///< the largest over the range, interpolated
  bool withinBudget = false;  ///< false: no technique is; this one has the least error
};

/// Errors measured with one probe's own picture (technique_errors.h), used in place of the table's: in the order of
/// measuredTechniques(), at measuredRoughness().
using TechniqueErrors = std::vector<std::array<double, 6>>;

/// For surfaces whose perceptual roughness lies between the two values. Never `auto` itself. `own` null: the table's
/// errors.
AutomaticChoice chooseAutomatic(double roughnessMin, double roughnessMax, double budget,
                                const TechniqueErrors* own = nullptr);

/// Does the technique choose among others?
bool isAutomatic(Technique technique);

}  // namespace boxprobe
