#include "filters/vtk/probes/probe_assignment.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "filters/core/geometry/probe_shares.h"
#include "filters/math/technique/automatic.h"

namespace boxprobe {

namespace {

/// Of a list with the most important first: the first of those of the highest importance that hold most of the object.
void keepOne(std::vector<std::size_t>& order, const Scene& scene, const Box& bounds) {
  std::optional<std::size_t> best;
  double most = -1.0;
  for (const std::size_t i : order) {
    if (scene.probes[i].importance < scene.probes[order.front()].importance) break;
    const double weight = objectWeight(scene.probes[i], bounds);
    if (weight <= most) continue;
    most = weight;
    best = i;
  }
  if (best) order = {*best};
}

}  // namespace

std::shared_ptr<const ProbeBinding> assignProbes(const DrawnObject& object, const Scene& scene,
                                                 const std::vector<std::shared_ptr<DrawnProbe>>& drawn,
                                                 std::vector<std::size_t> meeting, bool probesEnabled, bool general) {
  auto binding = std::make_shared<ProbeBinding>();
  if (object.unlit) {
    binding->lighting = Lighting::Unlit;
    return binding;
  }
  if (!probesEnabled) return binding;
  binding->lighting = Lighting::Probes;

  binding->diffuse = !object.allMetal;
  if (object.settings.probeUsage == ProbeUsage::Off) return binding;
  const Box bounds = worldBounds(object);
  std::vector<std::size_t> order = std::move(meeting);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Probe& p = scene.probes[a];
    const Probe& q = scene.probes[b];
    return p.importance != q.importance ? p.importance > q.importance : p.name < q.name;
  });
  if (object.settings.probeUsage == ProbeUsage::Simple) keepOne(order, scene, bounds);
  const auto covers = [&](std::size_t i) { return fullWeightEverywhere(scene.probes[i], bounds); };
  if (!general) {
    // Nothing is left for probes less important than one that covers the object.
    const auto cover = std::find_if(order.begin(), order.end(), covers);
    if (cover != order.end()) {
      const double importance = scene.probes[*cover].importance;
      order.erase(std::remove_if(order.begin(), order.end(),
                                 [&](std::size_t i) { return scene.probes[i].importance < importance; }),
                  order.end());
    }
  }
  if (order.size() > ProbeBinding::kMaxProbesPerDraw) {
    binding->leftOut = order.size() - ProbeBinding::kMaxProbesPerDraw;
    order.resize(ProbeBinding::kMaxProbesPerDraw);
  }
  // Asked of those that are left: the one that covers the object may have been one too many.
  if (!general && std::any_of(order.begin(), order.end(), covers)) {
    binding->sky = false;
    binding->weights = order.size() > 1;
  }
  if (object.settings.probeUsage == ProbeUsage::Simple && !order.empty()) {
    binding->weights = binding->sky = false;
  }
  binding->onlyProbes = object.settings.probeUsage == ProbeUsage::Blend;
  for (const std::size_t i : order) {
    binding->probes.push_back(drawn[i]);
    const ProbeGeometry& geometry = drawn[i]->geometry;
    binding->techniques.push_back(isAutomatic(geometry.technique)
                                      ? chooseAutomatic(object.roughnessMin, object.roughnessMax,
                                                        static_cast<double>(geometry.parameters.budget),
                                                        drawn[i]->errors.get())
                                            .technique
                                      : geometry.technique);
  }
  binding->shapes =
      std::any_of(binding->probes.begin(), binding->probes.end(), [](const auto& probe) { return probe->shapes; });
  // A perfect mirror's lobe is one direction: whatever a technique of several samples does, it does for nothing there.
  for (Technique& technique : binding->techniques) {
    const bool costly = !evaluationRows()[static_cast<std::size_t>(technique.evaluation)].standIn.empty();
    if (costly && object.roughnessMax <= 0.0) technique.evaluation = parseTechnique("none")->evaluation;
  }
  for (std::size_t light = 0; light < std::min(scene.lights.size(), kMostShadowLights); ++light) {
    const bool asked = std::any_of(binding->probes.begin(), binding->probes.end(),
                                   [&](const auto& probe) { return (probe->shadowLights >> light & 1u) != 0; });
    if (!asked) continue;
    binding->shadowLights.push_back(static_cast<int>(light));
    const bool moves = std::any_of(scene.objects.begin(), scene.objects.end(),
                                   [](const auto& entry) { return entry.second.dynamic && entry.second.visible; });
    if (moves && scene.lights[light].shadows == LightShadows::CoverageAndMap)
      binding->movingLights.push_back(static_cast<int>(light));
  }
  for (std::size_t light = 0; light < scene.lights.size(); ++light) {
    const bool hidden = std::any_of(binding->probes.begin(), binding->probes.end(), [&](const auto& probe) {
      return probe->sight && probe->sight->channelOfSource(light) != kSeenByAll;
    });
    if (hidden) binding->sightLights.push_back(static_cast<int>(light));
  }
  if (object.settings.weights == WeightMode::Object && binding->weights && !order.empty()) {
    std::vector<float> weights;
    for (const std::size_t i : order) weights.push_back(static_cast<float>(objectWeight(scene.probes[i], bounds)));
    ProbeShares shares = shareOut(weights, binding->groups(), binding->onlyProbes);
    binding->shares = std::move(shares.probes);
    binding->skyShare = shares.sky;
    if (!general && shares.sky <= 0.0f) binding->sky = false;
  }
  return binding;
}

}  // namespace boxprobe
