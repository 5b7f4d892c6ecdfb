// Probes of a scene by name.
#include "filters/core/scene/scene.h"

#include <algorithm>
#include <unordered_set>

namespace boxprobe {

std::optional<std::size_t> findProbe(const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.probes.begin(), scene.probes.end(), [&](const Probe& probe) { return probe.name == name; });
  if (found == scene.probes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - scene.probes.begin());
}

std::string unusedProbeName(const Scene& scene, const std::string& stem) {
  std::unordered_set<std::string> taken;
  for (const Probe& probe : scene.probes) taken.insert(probe.name);
  std::string base = stem.empty() ? "probe" : stem;
  if (taken.count(base) == 0) return base;
  for (std::size_t number = 2;; ++number) {  // ends: one of the first probes.size() + 1 numbers is free
    std::string name = base + " " + std::to_string(number);
    if (taken.count(name) == 0) return name;
  }
}

}  // namespace boxprobe
