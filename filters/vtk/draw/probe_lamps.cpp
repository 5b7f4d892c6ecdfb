#include "filters/vtk/draw/probe_lamps.h"

#include <algorithm>
#include <glm/matrix.hpp>

#include "filters/math/cube/lamp_free.h"
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

glm::vec3 lampReflected(const DrawState& state, const ProbeBinding& binding, std::size_t lamp) {
  glm::vec3 sum(0.0f);
  float count = 0.0f;
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    if (!binding.lampFree(i) || !probe.maps || !probe.maps->lampFree.maps) continue;
    const std::vector<glm::vec3>& backgrounds = probe.maps->lampFree.backgrounds;
    const auto found = std::find(probe.lamps.begin(), probe.lamps.end(), lamp);
    const auto k = static_cast<std::size_t>(found - probe.lamps.begin());
    if (k >= backgrounds.size()) continue;
    sum += backgrounds[k];
    count += 1.0f;
  }
  return withoutBackground(glm::vec3(state.resources.lamps->lamps[lamp].radiance), sum / std::max(count, 1.0f));
}

}  // namespace boxprobe
