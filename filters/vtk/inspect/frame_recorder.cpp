#include "filters/vtk/inspect/frame_recorder.h"

#include <algorithm>
#include <bitset>
#include <map>
#include <set>

#include "filters/core/geometry/probe_shares.h"
#include "filters/vtk/draw/fewer_samplers.h"

namespace boxprobe {

FrameReport reportFrame(const SceneContent& content, const ProbeSet& probes, const MirrorSet& mirrors,
                        const Counters& counters) {
  FrameReport report;
  for (const Probe& probe : content.scene.probes) {
    const auto maps = probes.maps(report.probes.size());
    FrameReport::ProbeUse use{probe.name};
    if (maps) {
      use.bytes = maps->bytes();
      use.levels = static_cast<std::size_t>(maps->radiance.levels());
      use.notFiltered = std::bitset<32>(maps->missing(kAllLevels)).count();
    }
    report.probes.push_back(std::move(use));
  }
  std::set<std::string> variants;
  for (const DrawnObject& object : content.objects) {
    const ProbeBinding* binding = object.pass->GetDrawnBinding();
    if (!object.settings.visible || binding == nullptr) continue;
    FrameReport::Object line;
    line.node = object.node;
    line.material = object.materialName;
    line.drawn = object.pass->GetDrawnInFrame();
    line.unlit = object.unlit;
    line.leftOut = binding->leftOut;
    line.givenUp = givenUpText(binding->givenUp, object.pass->GetTexturesLess());
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
  report.skyCulled = counters.skyCulled;
  std::copy(counters.drawsByProbeCount.begin(), counters.drawsByProbeCount.end(), report.drawsByProbeCount.begin());
  report.variants = variants.size();
  report.bytes = probes.memoryBytes();
  for (const MirrorReport& m : mirrors.reports()) {
    report.mirrors.push_back(
        {m.node, m.state == MirrorState::Drawn, mirrorStateText(m.state), m.width, m.height, m.objects, m.hiding});
  }
  report.mirrorBytes = mirrors.memoryBytes();
  return report;
}

std::vector<DrawnProgram> drawnPrograms(const SceneContent& content) {
  std::vector<DrawnProgram> programs;
  std::map<unsigned, std::size_t> places;
  for (std::size_t i = 0; i < content.objects.size(); ++i) {
    const DrawnObject& object = content.objects[i];
    if (!object.settings.visible || !object.pass->GetDrawnInFrame()) continue;
    const auto [place, added] = places.insert({object.pass->GetProgramNumber(), programs.size()});
    if (added) programs.emplace_back();
    programs[place->second].objects.push_back({i, object.node});
  }
  return programs;
}

FrameReport::Lookups lookupsOf(const ImageRgbaF& picture) {
  FrameReport::Lookups lookups;
  std::size_t surfaces = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
    if (picture.pixels[i + 3] <= 0.0f) continue;
    const double here = std::max(0.0, static_cast<double>(picture.pixels[i]));
    lookups.mean += here;
    lookups.most = std::max(lookups.most, here);
    ++surfaces;
  }
  lookups.mean /= static_cast<double>(std::max(surfaces, std::size_t{1}));
  return lookups;
}

}  // namespace boxprobe
