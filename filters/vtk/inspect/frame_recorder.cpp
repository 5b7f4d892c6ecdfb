#include "filters/vtk/inspect/frame_recorder.h"

#include <algorithm>
#include <set>

#include "filters/core/geometry/probe_shares.h"

namespace boxprobe {

FrameReport reportFrame(const SceneContent& content, const ProbeSet& probes, const DrawState& state) {
  FrameReport report;
  for (const Probe& probe : content.scene.probes) {
    const auto maps = probes.maps(report.probes.size());
    report.probes.push_back({probe.name, 0, 0, maps ? maps->bytes() : 0});
  }
  std::set<std::string> variants;
  for (const DrawnObject& object : content.objects) {
    const ProbeBinding* binding = object.mapper->GetDrawnBinding();
    if (!object.settings.visible || binding == nullptr) continue;
    FrameReport::Object line;
    line.node = object.node;
    line.material = object.materialName;
    line.drawn = object.mapper->GetDrawnInFrame();
    line.unlit = object.unlit;
    line.leftOut = binding->leftOut;
    line.weights = binding->weights && !binding->probes.empty();
    line.variant = binding->variantKey();
    std::vector<float> weights;
    const Box bounds = worldBounds(object);
    for (const auto& probe : binding->probes) {
      const auto index = static_cast<std::size_t>(probe->index);
      ++report.probes[index].objects;
      if (line.drawn) ++report.probes[index].drawn;
      weights.push_back(binding->weights ? static_cast<float>(objectWeight(content.scene.probes[index], bounds))
                                         : 1.0f);
    }
    const ProbeShares shares = shareOut(weights, binding->groups(), binding->onlyProbes);
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const auto index = static_cast<std::size_t>(binding->probes[k]->index);
      line.probes.push_back({report.probes[index].name, static_cast<double>(shares.probes[k])});
    }
    line.sky = binding->lighting != Lighting::Probes || !binding->sky ? 0.0 : static_cast<double>(shares.sky);
    if (line.drawn) variants.insert(line.variant);
    report.objects.push_back(std::move(line));
  }
  std::copy(state.counters.drawsByProbeCount.begin(), state.counters.drawsByProbeCount.end(),
            report.drawsByProbeCount.begin());
  report.variants = variants.size();
  report.bytes = probes.memoryBytes();
  return report;
}

}  // namespace boxprobe
