// See fewer_samplers.h.
#include "filters/vtk/draw/fewer_samplers.h"

#include <algorithm>
#include <utility>

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

void add(std::string& text, std::size_t count, const char* one, const char* many) {
  if (count == 0) return;
  text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + (count == 1 ? one : many);
}

void add(std::string& text, bool said, const char* what) {
  if (said) text += std::string(text.empty() ? "" : ", ") + what;
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

std::string givenUpText(const GivenUp& givenUp, std::size_t textures) {
  std::string text;
  add(text, givenUp.impostors, "impostor is drawn by box", "impostors are drawn by box");
  add(text, givenUp.lightTables, "rays are chosen without tables of light");
  add(text, givenUp.openness, "the sky is not occluded");
  add(text, givenUp.probes, "probe is left out", "probes are left out");
  add(text, givenUp.movingShadows, "moving objects throw no shadow");
  add(text, textures, "texture of its material is left out", "textures of its material are left out");
  return text;
}

}  // namespace boxprobe
