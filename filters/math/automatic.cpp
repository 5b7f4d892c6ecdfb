#include "filters/math/automatic.h"

#include <algorithm>
#include <limits>

namespace boxprobe {

namespace {

// Between two measured roughnesses as the crow flies.
double errorAt(const MeasuredTechnique& of, double roughness) {
  const auto& nodes = measuredRoughness();
  const double r = std::clamp(roughness, nodes.front(), nodes.back());
  std::size_t i = 1;
  while (i + 1 < nodes.size() && nodes[i] < r) ++i;
  const double share = (r - nodes[i - 1]) / (nodes[i] - nodes[i - 1]);
  return (1.0 - share) * of.error[i - 1] + share * of.error[i];
}

// Straight pieces are largest at their ends.
double worstBetween(const MeasuredTechnique& of, double low, double high) {
  double worst = std::max(errorAt(of, low), errorAt(of, high));
  const auto& nodes = measuredRoughness();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i] > low && nodes[i] < high) worst = std::max(worst, of.error[i]);
  }
  return worst;
}

}  // namespace

const std::array<double, 6>& measuredRoughness() {
  static const std::array<double, 6> nodes = {0.0, 0.1, 0.25, 0.5, 0.75, 1.0};
  return nodes;
}

AutomaticChoice chooseAutomatic(double roughnessMin, double roughnessMax, double budget) {
  AutomaticChoice nearest;
  nearest.error = std::numeric_limits<double>::infinity();
  for (const MeasuredTechnique& candidate : measuredTechniques()) {
    const auto technique = parseTechnique(candidate.id);
    if (!technique) continue;
    const double error = worstBetween(candidate, roughnessMin, roughnessMax);
    if (error <= budget) return {*technique, error, true};
    if (error < nearest.error) nearest = {*technique, error, false};
  }
  return nearest;
}

double smallestBudget() {
  double smallest = std::numeric_limits<double>::infinity();
  for (const MeasuredTechnique& candidate : measuredTechniques()) {
    smallest = std::min(smallest, worstBetween(candidate, 0.0, 1.0));
  }
  return smallest;
}

bool isAutomatic(Technique technique) {
  return evaluationRows()[static_cast<std::size_t>(technique.evaluation)].id == "auto";
}

}  // namespace boxprobe
