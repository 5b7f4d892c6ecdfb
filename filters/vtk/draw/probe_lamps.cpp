#include "filters/vtk/draw/probe_lamps.h"

#include <glm/matrix.hpp>

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

}  // namespace boxprobe
