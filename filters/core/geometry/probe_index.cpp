#include "filters/core/geometry/probe_index.h"

#include <algorithm>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

namespace {

std::vector<Box> boundsOf(const std::vector<Probe>& probes) {
  std::vector<Box> bounds;
  bounds.reserve(probes.size());
  for (const Probe& probe : probes) bounds.push_back(influenceBounds(probe));
  return bounds;
}

}  // namespace

ProbeIndex::ProbeIndex(const std::vector<Probe>& probes) : tree_(boundsOf(probes)) {}

std::vector<std::size_t> ProbeIndex::meeting(const Box& boundsWorld) const {
  std::vector<std::size_t> found;
  tree_.search([&](const Box& box) { return boxesMeet(box, boundsWorld); },
               [&](std::size_t probe) { found.push_back(probe); });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace boxprobe
