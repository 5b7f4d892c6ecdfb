// How often probes are captured in turn when a scene asks for all bounces.
#pragma once

#include <algorithm>
#include <optional>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Probe::bounces of `"bounces": "all"`: bounces end when one of them changes the light that bounces have brought by
/// less than kBouncesAtRest in every probe that is made with it, and at the latest after so many.
constexpr int kAllBounces = 16;
constexpr double kBouncesAtRest = 0.01;

inline bool allBounces(const Probe& probe) {
  return probe.bounces == kAllBounces;
}

/// The most of a scene's probes, at least 1; nothing: all.
inline std::optional<int> mostBounces(const Scene& scene) {
  int most = 1;
  for (const Probe& probe : scene.probes) {
    if (allBounces(probe)) return std::nullopt;
    most = std::max(most, probe.bounces);
  }
  return most;
}

}  // namespace boxprobe
