// Probes of a scene by name.
#include "filters/core/scene/scene.h"

#include <algorithm>

namespace boxprobe {

std::optional<std::size_t> findProbe(const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.probes.begin(), scene.probes.end(), [&](const Probe& probe) { return probe.name == name; });
  if (found == scene.probes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - scene.probes.begin());
}

ProbeNames::ProbeNames(const Scene& scene) {
  for (const Probe& probe : scene.probes) taken_.insert(probe.name);
}

std::string ProbeNames::take(const std::string& stem) {
  const std::string base = stem.empty() ? "probe" : stem;
  if (taken_.insert(base).second) return base;
  std::size_t& number = next_.try_emplace(base, 2).first->second;
  for (;; ++number) {  // ends: one of the first taken_.size() + 1 numbers is free
    std::string name = base + " " + std::to_string(number);
    if (taken_.insert(name).second) return name;
  }
}

std::string unusedProbeName(const Scene& scene, const std::string& stem) {
  return ProbeNames(scene).take(stem);
}

}  // namespace boxprobe
