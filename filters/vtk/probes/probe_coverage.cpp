// The probe set's coverage: which lights a probe's coverage stands before, and the colour of the glass in it. See
// probe_set.h.
#include "filters/core/geometry/light_shadow.h"
#include "filters/vtk/probes/glass_tint.h"
#include "filters/vtk/probes/probe_set.h"

namespace boxprobe {

void ProbeSet::updateShadowLights() {
  const std::vector<Light>& lights = content_->scene.lights;
  state_->resources.shadowLights.clear();
  for (const Light& light : lights) {
    const bool bySize = light.shadowLevel == ShadowLevel::Size;
    state_->resources.shadowLights.push_back(
        {lightSize(light), bySize ? -1.0f : static_cast<float>(light.levelsPerUnit)});
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    DrawnProbe& drawn = *entries_[i].drawn;
    drawn.shadowLights = 0;
    drawn.imported = probe(i).mode == ProbeMode::Custom;
    for (std::size_t light = 0; light < std::min(lights.size(), kMostShadowLights); ++light) {
      const bool asks = lights[light].shadows != LightShadows::None && lightOutside(lights[light], probe(i));
      if (asks) drawn.shadowLights |= 1u << light;
    }
  }
}

void ProbeSet::addTint(std::size_t index, const ProbeMaps& maps) const {
  if (entries_[index].drawn->shadowLights == 0 || entries_[index].drawn->imported || maps.tint) return;
  maps.tint = glassTint(*content_, probe(index), maps);
}

}  // namespace boxprobe
