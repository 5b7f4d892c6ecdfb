#include "filters/vtk/probes/level_needs.h"

#include <algorithm>

namespace boxprobe {

void LevelNeeds::Need::add(const Lookup& lookup) {
  if (std::find(lookups.begin(), lookups.end(), lookup) == lookups.end()) lookups.push_back(lookup);
}

// Glass looks along refracted rays as rough as its material, too, and at what its form makes of them.
void LevelNeeds::update() {
  needs_.assign(shown_->size(), {});
  sky_ = {};
  whole_ = false;
  for (const DrawnObject& object : content_->objects) {
    const ProbeBinding* binding = object.pass->GetBinding();
    if (!object.settings.visible || binding == nullptr || binding->lighting != Lighting::Probes) continue;
    const bool glass = object.surface->glass.drawn;
    const Lookup own{{}, object.roughnessMin, object.roughnessMax};
    if (binding->sky || binding->open()) {
      sky_.add(own);
      sky_.all |= glass;
    }
    for (std::size_t slot = 0; slot < binding->probes.size(); ++slot) {
      const auto index = static_cast<std::size_t>(binding->probes[slot]->index);
      if (index >= needs_.size() || !shown_->has(*binding->probes[slot])) continue;
      sky_.all |= binding->openByLookup(slot);
      Need& need = needs_[index];
      need.all |= glass;
      if (binding->lampFree(slot)) continue;  // other maps of it, which are filtered when they are drawn
      for (const Technique& technique : {binding->technique(slot), standInFor(binding->technique(slot))}) {
        need.add({technique, own.low, own.high});
      }
    }
  }
}

LevelMask LevelNeeds::ofProbe(std::size_t probe, int levels) const {
  return all_ ? kAllLevels : sampledOf(probe, levels);
}

LevelMask LevelNeeds::sampledOf(std::size_t probe, int levels) const {
  if (probe >= needs_.size() || needs_[probe].all) return kAllLevels;
  LevelMask mask = 0;
  const auto& parameters = shown_->drawn(probe).geometry.parameters;
  for (const Lookup& lookup : needs_[probe].lookups) {
    mask |= levelsRead(lookup.technique, parameters, lookup.low, lookup.high, levels);
  }
  return mask;
}

LevelMask LevelNeeds::ofSky(int levels) const {
  return all_ ? kAllLevels : sampledOfSky(levels);
}

LevelMask LevelNeeds::sampledOfSky(int levels) const {
  if (sky_.all) return kAllLevels;
  LevelMask mask = 0;
  for (const Lookup& lookup : sky_.lookups) mask |= skyLevelsRead(lookup.low, lookup.high, levels);
  return mask;
}

void LevelNeeds::also(const std::shared_ptr<const ProbeMaps>& maps, LevelMask levels) {
  if (alsoOf_.lock() == maps && also_ == levels) return;
  alsoOf_ = maps;
  also_ = levels;
  whole_ = false;
}

template <typename Each>
void LevelNeeds::forEachLack(const Each& each) const {
  const ProbeMaps* sky = state_->resources.sky.get();
  if (const auto maps = alsoOf_.lock(); maps && maps->missing(also_) != 0) {
    if (!each(maps.get(), maps->missing(also_))) return;
  }
  for (std::size_t i = 0; i < shown_->size(); ++i) {
    const ProbeMaps* maps = shown_->drawn(i).maps.get();
    if (maps == nullptr || maps->missing(kAllLevels) == 0) continue;
    const LevelMask lack = maps->missing(sampledOf(i, maps->radiance.levels()));
    if (lack != 0 && !each(maps, lack)) return;
  }
  if (sky == nullptr || sky->missing(kAllLevels) == 0) return;
  const LevelMask lack = sky->missing(sampledOfSky(sky->radiance.levels()));
  if (lack != 0) each(sky, lack);
}

std::optional<LevelNeeds::Lack> LevelNeeds::find() const {
  const ProbeMaps* sky = state_->resources.sky.get();
  if (whole_ && wholeShown_ == shown_->generation() && wholeSky_ == sky) return std::nullopt;
  std::optional<Lack> first;
  forEachLack([&first](const ProbeMaps* maps, LevelMask levels) {
    first = Lack{maps, levels};
    return false;
  });
  if (first) return first;
  whole_ = true;
  wholeShown_ = shown_->generation();
  wholeSky_ = sky;
  return std::nullopt;
}

int LevelNeeds::left() const {
  if (!lacking()) return 0;
  int count = 0;
  forEachLack([&count](const ProbeMaps*, LevelMask levels) {
    for (; levels != 0; levels &= levels - 1) ++count;
    return true;
  });
  return count;
}

bool LevelNeeds::lacking() const {
  return find().has_value();
}

bool LevelNeeds::makeOne() {
  const auto lack = find();
  if (!lack) return false;
  const LevelMask level = lack->levels & (~lack->levels + 1);
  lack->maps->need(level);
  return lack->maps != alsoOf_.lock().get() || (level & also_) == 0;
}

}  // namespace boxprobe
