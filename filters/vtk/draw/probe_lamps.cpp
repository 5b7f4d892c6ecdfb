#include "filters/vtk/draw/probe_lamps.h"

#include <algorithm>
#include <glm/matrix.hpp>

#include "filters/math/cube/lamp_free.h"
#include "filters/vtk/draw/probe_lattice.h"
#include "filters/vtk/maps/lamp_free_maps.h"

namespace boxprobe {

void makeLampFree(const DrawState& state, const ProbeBinding& binding) {
  const SceneResources& resources = state.resources;
  if (!binding.lampLobes || !resources.lamps || !resources.filterLevels || state.pass().capture) return;
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    if (!binding.lampFree(i) || !probe.maps) continue;
    const ProbeMaps& maps = *probe.maps;
    const ProbeGeometry& g = probe.geometry;
    const glm::dmat3 worldFromMap = g.worldFromProbe * glm::transpose(g.mapFromProbe);
    std::vector<LampPolygon> lamps;
    for (const std::size_t lamp : probe.lamps) {
      lamps.push_back(lampPolygon(resources.lamps->lamps[lamp], g.originWorld, worldFromMap));
    }
    const LevelMask levels =
        levelsRead(binding.technique(i), binding.values(i), static_cast<double>(binding.roughnessMin),
                   static_cast<double>(binding.roughnessMax), maps.radiance.levels());
    const bool made = makeLampFreeMaps(
        maps, lamps, levels, state.pass().dragging,
        [&](const CubeTexture& chain, LevelMask missing) { resources.filterLevels(chain, missing, probe.prefilter); });
    if (!made) maps.need(levels);
  }
}

LampLight lampLight(const DrawState& state, const ProbeBinding& binding, std::size_t lamp) {
  const glm::vec3 radiance(state.resources.lamps->lamps[lamp].radiance);
  struct Mean {
    void add(const std::vector<glm::vec3>& standIns, std::size_t k) {
      if (k >= standIns.size()) return;
      sum += standIns[k];
      ++count;
    }
    glm::vec3 get() const { return count > 0 ? sum / static_cast<float>(count) : glm::vec3(0.0f); }
    glm::vec3 sum{0.0f};
    int count = 0;
  } diffuse, glossy;
  for (std::size_t i = 0; i < binding.probes.size() && !state.pass().firstBounce; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    const auto found = std::find(probe.lamps.begin(), probe.lamps.end(), lamp);
    if (found == probe.lamps.end() || !probe.maps) continue;
    const auto k = static_cast<std::size_t>(found - probe.lamps.begin());
    if (const auto lattice = binding.diffuse ? probeLattice(state, probe) : nullptr) diffuse.add(lattice->standIns, k);
    if (binding.lampFree(i) && probe.maps->lampFree.maps) glossy.add(probe.maps->lampFree.standIns, k);
  }
  return {withoutStandIn(radiance, diffuse.get()), withoutStandIn(radiance, glossy.get())};
}

}  // namespace boxprobe
