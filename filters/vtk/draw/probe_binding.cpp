#include "filters/vtk/draw/probe_binding.h"

#include <algorithm>

namespace boxprobe {

namespace {

constexpr int kRefinedPattern = 4;  // in shared/sample_pattern.glsl

}  // namespace

Technique ProbeBinding::technique(std::size_t slot) const {
  return slot < techniques.size() ? techniques[slot] : probes[slot]->geometry.technique;
}

bool ProbeBinding::rotated() const {
  return std::any_of(probes.begin(), probes.end(),
                     [](const auto& probe) { return probe->geometry.rotated || probe->geometry.mapTurned; });
}

bool ProbeBinding::sights() const {
  const auto some = [](const std::shared_ptr<const ProbeSight>& sight) { return sight && !sight->lattice.empty(); };
  return !sightLights.empty() || (captureSights && !probes.empty()) ||
         std::any_of(probes.begin(), probes.end(), [&some](const auto& probe) { return some(probe->sight); });
}

bool ProbeBinding::bevelled() const {
  return std::any_of(probes.begin(), probes.end(), [](const auto& probe) { return probe->geometry.bevelled; });
}

bool ProbeBinding::occluded() const {
  return std::any_of(probes.begin(), probes.end(), [](const auto& probe) { return probe->geometry.occluded; });
}

bool ProbeBinding::open() const {
  return std::any_of(probes.begin(), probes.end(), [](const auto& probe) { return probe->open; });
}

bool ProbeBinding::openByLookup(std::size_t slot) const {
  return probes[slot]->open && looksUpPieces(technique(slot));
}

bool ProbeBinding::lampFree(std::size_t slot) const {
  const DrawnProbe& probe = *probes[slot];
  // A filter that blurs the capture itself has spread the lamps' light over their surroundings.
  return lampLobes && probe.shapes && !probe.lamps.empty() && !probe.open && !probe.realtime &&
         probe.prefilter.filter == FilterLobe::Kind::Ggx;
}

const ProbeMaps* ProbeBinding::lookedUp(std::size_t slot, bool capture) const {
  const ProbeMaps* own = probes[slot]->maps.get();
  const ProbeMaps* without = own != nullptr && !capture && lampFree(slot) ? own->lampFree.maps.get() : nullptr;
  return without != nullptr ? without : own;
}

bool ProbeBinding::distances() const {
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (projectionRows()[static_cast<std::size_t>(technique(i).projection)].distances) return true;
  }
  return false;
}

bool ProbeBinding::marches(std::size_t slot) const {
  return projectionRows()[static_cast<std::size_t>(technique(slot).projection)].distances && values(slot).steps > 3.5f;
}

bool ProbeBinding::chooses(std::string_view parameter, std::string_view choice) const {
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (boxprobe::chooses(technique(i), values(i), parameter, choice)) return true;
  }
  return false;
}

std::shared_ptr<const ProbeBinding> ProbeBinding::standIn() const {
  auto cheap = std::make_shared<ProbeBinding>(*this);
  cheap->techniques.clear();
  bool differs = false;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    cheap->techniques.push_back(standInFor(technique(i)));
    differs |= !(cheap->techniques[i] == technique(i));
  }
  return differs ? cheap : nullptr;
}

// The sky shows through openings, whether captured or not.
std::shared_ptr<const ProbeBinding> ProbeBinding::forFirstBounce() const {
  if (lighting != Lighting::Probes || probes.empty() || open()) return nullptr;
  auto unlit = std::make_shared<ProbeBinding>(*this);
  unlit->firstBounce = true;
  unlit->lampLobes = false;
  return unlit;
}

std::shared_ptr<const ProbeBinding> ProbeBinding::refined(int samples, int total) const {
  if (lighting != Lighting::Probes || firstBounce) return nullptr;
  constexpr float kStepsAtRest = 24.0f;
  static const int rays = parseTechnique("raytraced")->evaluation;
  static const int alongNormal = parseTechnique("normal")->projection;
  auto made = std::make_shared<ProbeBinding>(*this);
  made->techniques.clear();
  made->refinedValues.clear();
  bool differs = false;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    Technique t = technique(i);
    shading::TechniqueParameters of = values(i);
    // All rays along the normal sample the same value; a mirror has a single ray.
    if (t.projection != alongNormal && roughnessMax > 0.0f) {
      t.evaluation = rays;
      of.samples = static_cast<float>(samples);
      of.total = static_cast<float>(total);
      of.pattern = kRefinedPattern;
      of.filtered = 1;
      of.levelOffset = of.sampling = 0;
      differs = true;
    }
    if (projectionRows()[static_cast<std::size_t>(t.projection)].distances && of.steps < kStepsAtRest) {
      of.steps = kStepsAtRest;
      differs = true;
    }
    made->techniques.push_back(t);
    made->refinedValues.push_back(of);
  }
  return differs ? made : nullptr;
}

int ProbeBinding::animatedSamples() const {
  int samples = 0;
  if (!refinedValues.empty()) return samples;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const ProbeGeometry& g = probes[i]->geometry;
    if (!g.animated || !(technique(i) == g.technique)) continue;
    samples = std::max(samples, static_cast<int>(g.parameters.samples));
  }
  return samples;
}

bool ProbeBinding::blurred(std::size_t slot) const {
  return refinedValues.empty() && probes[slot]->geometry.blurred && technique(slot) == probes[slot]->geometry.technique;
}

int ProbeBinding::blurredSamples() const {
  int samples = 0;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (blurred(i)) samples = std::max(samples, static_cast<int>(probes[i]->geometry.parameters.samples));
  }
  return samples;
}

std::vector<int> ProbeBinding::groups() const {
  std::vector<int> result;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const bool same = i > 0 && probes[i]->geometry.importance == probes[i - 1]->geometry.importance;
    result.push_back(i == 0 ? 0 : result.back() + (same ? 0 : 1));
  }
  return result;
}

std::vector<const ParameterRow*> ProbeBinding::parameters() const {
  std::vector<const ParameterRow*> rows;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    for (const ParameterRow* row : parametersOf(technique(i))) {
      if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
    }
  }
  return rows;
}

std::string ProbeBinding::variantKey() const {
  std::string key(1, static_cast<char>('0' + static_cast<int>(lighting)));
  if (rotated()) key += 'r';
  if (weights) key += shares.empty() ? 'w' : 'c';
  if (weights && onlyProbes) key += 'p';
  if (sky) key += openness ? 'S' : 's';
  if (diffuse) key += 'd';
  if (diffuse && shapes) key += lamps ? 'L' : 'l';
  if (lampLobes) key += 'g';
  if (firstBounce) key += 'k';
  const std::vector<int> group = groups();
  for (std::size_t i = 0; i < probes.size(); ++i) {
    key += " " + std::to_string(group[i]) + ":" + techniqueId(technique(i)) + (blurred(i) ? "~" : "");
    for (const ParameterRow* row : parametersOf(technique(i))) {
      if (row->choice != nullptr) key += "/" + std::to_string(values(i).*row->choice);
    }
    if (marches(i)) key += 'm';
    if (lampFree(i)) key += 'f';
    if (probes[i]->geometry.bevelled) key += 'b';
    if (probes[i]->geometry.occluded) key += 'o';
    if (probes[i]->open) key += 'y';
  }
  for (const int light : shadowLights) key += " L" + std::to_string(light);
  for (const int light : movingLights) key += " M" + std::to_string(light);
  for (const SunUse& sun : sunLights) key += " S" + std::to_string(sun.light);
  if (sights()) key += " v";
  for (const int light : sightLights) key += " V" + std::to_string(light);
  return key;
}

}  // namespace boxprobe
