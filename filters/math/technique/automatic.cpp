#include "filters/math/technique/automatic.h"

#include <algorithm>
#include <limits>

namespace boxprobe {

namespace {

// Linear between two measured roughnesses.
double errorAt(const std::array<double, 6>& error, double roughness) {
  const auto& nodes = measuredRoughness();
  const double r = std::clamp(roughness, nodes.front(), nodes.back());
  std::size_t i = 1;
  while (i + 1 < nodes.size() && nodes[i] < r) ++i;
  const double share = (r - nodes[i - 1]) / (nodes[i] - nodes[i - 1]);
  return (1.0 - share) * error[i - 1] + share * error[i];
}

// The largest error in a range: piecewise linear functions are largest at their ends.
double worstBetween(const std::array<double, 6>& error, double low, double high) {
  double worst = std::max(errorAt(error, low), errorAt(error, high));
  const auto& nodes = measuredRoughness();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i] > low && nodes[i] < high) worst = std::max(worst, error[i]);
  }
  return worst;
}

}  // namespace

const std::array<double, 6>& measuredRoughness() {
  static const std::array<double, 6> nodes = {0.0, 0.1, 0.25, 0.5, 0.75, 1.0};
  return nodes;
}

AutomaticChoice chooseAutomatic(double roughnessMin, double roughnessMax, double budget, const TechniqueErrors* own) {
  AutomaticChoice nearest;
  nearest.error = std::numeric_limits<double>::infinity();
  const auto& candidates = measuredTechniques();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto technique = parseTechnique(candidates[i].id);
    if (!technique) continue;
    const double error = worstBetween(own != nullptr ? (*own)[i] : candidates[i].error, roughnessMin, roughnessMax);
    if (error <= budget) return {*technique, error, true};
    if (error < nearest.error) nearest = {*technique, error, false};
  }
  return nearest;
}

bool isAutomatic(Technique technique) {
  return evaluationRows()[static_cast<std::size_t>(technique.evaluation)].id == "auto";
}

}  // namespace boxprobe
