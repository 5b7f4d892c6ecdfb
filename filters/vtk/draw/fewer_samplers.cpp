// See fewer_samplers.h.
#include "filters/vtk/draw/fewer_samplers.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace boxprobe {

namespace {

bool isImpostor(const Technique& technique) {
  return projectionRows()[static_cast<std::size_t>(technique.projection)].distances;
}

bool dropImpostor(ProbeBinding& binding) {
  static const int box = parseTechnique("box")->projection;
  for (std::size_t slot = binding.probes.size(); slot-- > 0;) {
    if (!isImpostor(binding.technique(slot))) continue;
    std::vector<Technique> techniques;
    for (std::size_t i = 0; i < binding.probes.size(); ++i) techniques.push_back(binding.technique(i));
    techniques[slot].projection = box;
    binding.techniques = std::move(techniques);
    ++binding.givenUp.impostors;
    return true;
  }
  return false;
}

bool dropLightTables(ProbeBinding& binding) {
  if (!binding.chooses("sampling", "luminance")) return false;
  for (auto& probe : binding.probes) {
    auto plain = std::make_shared<DrawnProbe>(*probe);
    plain->geometry.parameters.sampling = 0;
    probe = std::move(plain);
  }
  for (auto& values : binding.refinedValues) values.sampling = 0;
  binding.givenUp.lightTables = true;
  return true;
}

bool dropOpenness(ProbeBinding& binding) {
  if (!binding.sky || !binding.openness) return false;
  binding.openness = false;
  binding.givenUp.openness = true;
  return true;
}

// Its share goes to the others and to the sky. Where the sky had none, it is seen where the dropped one alone had
// weight, and the last one lights all of the object: nothing turns black.
bool dropProbe(ProbeBinding& binding) {
  if (binding.probes.size() < 2) return false;
  binding.probes.pop_back();
  const std::size_t left = binding.probes.size();
  if (binding.techniques.size() > left) binding.techniques.resize(left);
  if (binding.refinedValues.size() > left) binding.refinedValues.resize(left);
  binding.shares.clear();
  const bool covered = !binding.sky || binding.givenUp.covered;
  if (covered) {
    binding.givenUp.covered = true;
    binding.weights = binding.onlyProbes = binding.sky = left > 1;
    binding.openness = false;
  }
  ++binding.givenUp.probes;
  return true;
}

bool dropMovingShadows(ProbeBinding& binding) {
  if (binding.movingLights.empty()) return false;
  binding.movingLights.clear();
  binding.givenUp.movingShadows = true;
  return true;
}

// Giving up a texture that no program samples would gain nothing.
bool isSampled(const SurfaceMaterial& surface, SurfaceSlotIndex slot) {
  if (!surface.slots[slot].texture) return false;
  if (slot == kAnisotropySlot) return surface.brushed();
  const bool ofFinish = slot >= kSpecularSlot && slot <= kFilmThicknessSlot;
  return !ofFinish || surface.finished();
}

}  // namespace

std::shared_ptr<const ProbeBinding> withLess(const ProbeBinding& binding) {
  auto less = std::make_shared<ProbeBinding>(binding);
  for (const auto drop : {dropImpostor, dropLightTables, dropOpenness, dropProbe, dropMovingShadows}) {
    if (drop(*less)) return less;
  }
  return nullptr;
}

std::shared_ptr<const SurfaceMaterial> withTextureLess(const SurfaceMaterial& surface) {
  constexpr SurfaceSlotIndex kLeastFirst[] = {
      kFilmThicknessSlot, kSheenRoughnessSlot, kCoatNormalSlot, kCoatRoughnessSlot, kAnisotropySlot,
      kSpecularColorSlot, kSpecularSlot,       kThicknessSlot,  kOcclusionSlot,     kNormalSlot};
  for (const SurfaceSlotIndex slot : kLeastFirst) {
    if (!isSampled(surface, slot)) continue;
    auto less = std::make_shared<SurfaceMaterial>(surface);
    less->slots[slot] = {};
    return less;
  }
  return nullptr;
}

Phrase givenUpText(const GivenUp& givenUp, std::size_t textures) {
  std::vector<Phrase> parts;
  const auto count = [&parts](std::size_t n, const Phrase& one, const Phrase& many) {
    if (n > 0) parts.push_back((n == 1 ? one : many).arg(std::to_string(n)));
  };
  count(givenUp.impostors, Phrase::tr("%1 impostor is drawn by box"), Phrase::tr("%1 impostors are drawn by box"));
  if (givenUp.lightTables) parts.push_back(Phrase::tr("rays are chosen without tables of light"));
  if (givenUp.openness) parts.push_back(Phrase::tr("the sky is not occluded"));
  count(givenUp.probes, Phrase::tr("%1 probe is left out"), Phrase::tr("%1 probes are left out"));
  if (givenUp.movingShadows) parts.push_back(Phrase::tr("moving objects throw no shadow"));
  count(textures, Phrase::tr("%1 texture of its material is left out"),
        Phrase::tr("%1 textures of its material are left out"));
  return commaList(parts);
}

}  // namespace boxprobe
