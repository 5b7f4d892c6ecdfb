#include "filters/math/technique/levels_read.h"

#include <algorithm>
#include <cmath>

namespace boxprobe {

namespace {

// Rounding may take a lookup this far beyond an integer level; the share of the next level is then invisible.
constexpr float kRounding = 1.0e-4f;
constexpr int kThreeLevels = 5;  // the curve that uses only the first, the middle and the last level

}  // namespace

LevelMask levelsBetween(float low, float high, int levels) {
  const auto within = [levels](float level) { return std::clamp(static_cast<int>(level), 0, levels - 1); };
  const int first = within(std::floor(low + kRounding)), last = within(std::ceil(high - kRounding));
  LevelMask mask = 0;
  for (int level = first; level <= std::max(first, last); ++level) mask |= LevelMask{1} << level;
  return mask;
}

LevelMask levelsRead(const Technique& technique, const shading::TechniqueParameters& parameters, double low,
                     double high, int levels) {
  const LevelReach reach = evaluationRows()[static_cast<std::size_t>(technique.evaluation)].levels;
  if (reach == LevelReach::Any || parameters.curve == kThreeLevels) return kAllLevels;
  shading::ProbeShape probe{};
  probe.maxLevel = static_cast<float>(levels - 1);
  probe.parameters = parameters;
  const float most = shading::levelForCurve(probe, static_cast<float>(high));
  if (reach == LevelReach::Own) {
    return levelsBetween(shading::levelForCurve(probe, static_cast<float>(low)), most, levels);
  }
  // Godot's form begins at alpha² times the last level, which some curves do not reach.
  const auto p = static_cast<float>(std::clamp(high, 0.0, 1.0));
  return levelsBetween(0.0f, std::max(most, p * p * p * p * probe.maxLevel), levels);
}

LevelMask skyLevelsRead(double low, double high, int levels) {
  const auto maxLevel = static_cast<float>(levels - 1);
  return levelsBetween(shading::levelForRoughness(static_cast<float>(low), maxLevel),
                       shading::levelForRoughness(static_cast<float>(high), maxLevel), levels);
}

}  // namespace boxprobe
