#include "filters/vtk/probes/probe_binder.h"

#include <algorithm>

#include "filters/core/geometry/light_shadow.h"
#include "filters/core/geometry/probe_shares.h"
#include "filters/math/cube/openings.h"
#include "filters/math/shared/lamp_math.h"
#include "filters/math/technique/automatic.h"
#include "filters/math/technique/technique_errors.h"
#include "filters/vtk/capture/bake_runner.h"
#include "filters/vtk/draw/program_tuning.h"
#include "filters/vtk/maps/cube_transfer.h"
#include "filters/vtk/scene/glass_tint.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

namespace {

CubeMap level0(const ProbeMaps& maps) {
  CubeMap cube(maps.radiance.faceSize(), 1);
  readLevel0(maps.radiance, cube);
  return cube;
}

const Openings& openingsOf(const ProbeMaps& maps) {
  if (!maps.openings) {
    const CubeMap captured = level0(maps);
    maps.openings = std::make_shared<const Openings>(Openings{reducedCube(captured), anyOpening(captured)});
  }
  return *maps.openings;
}

/// Sampled in the probe's frame, although a map keeps the axes of its capture.
class TurnedCube : public shading::CubeSampler {
 public:
  TurnedCube(const CubeMap& map, const glm::dmat3& mapFromProbe) : map_(map), mapFromProbe_(mapFromProbe) {}
  glm::vec4 fetch(const glm::vec3& direction, float level) const override {
    return map_.fetch(mapFromProbe_ * direction, level);
  }

 private:
  const CubeMap& map_;
  glm::mat3 mapFromProbe_;
};

/// Reduces a list in order of importance to the first of the most important probes that contain most of the object.
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

// A picture file has no capture origin: it belongs to the probe's current position.
ProbeGeometry ProbeBinder::geometry(std::size_t index, const ProbeMaps* maps) const {
  const Probe& probe = with_.content->scene.probes[index];
  const bool captured = maps != nullptr && probe.mode != ProbeMode::Custom;
  ProbeGeometry geometry = probeGeometry(probe, captured ? maps->capturedAt : probe.origin,
                                         maps != nullptr ? maps->capturedRotation : probe.rotationDegrees);
  // Averaged frames and smoothed samples need passes over a picture that belongs to another program.
  if (with_.state->resources.foreign) geometry.animated = geometry.blurred = false;
  return geometry;
}

void ProbeBinder::rearrange(const ProbeEntries::Origins& origins) {
  std::vector<Shown> next;
  for (const auto& origin : origins) next.push_back(origin ? probes_[*origin] : Shown{});
  probes_ = std::move(next);
  ++generation_;
}

void ProbeBinder::updateShapes() {
  places_ = ProbeIndex(with_.content->scene.probes);
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    DrawnProbe& probe = *probes_[i].drawn;
    probe.index = static_cast<int>(i);
    probe.geometry = geometry(i, probe.maps.get());
  }
  updateShadowLights();
  updateLamps();
  updateOpenings();
}

bool ProbeBinder::has(const DrawnProbe& probe) const {
  const auto index = static_cast<std::size_t>(probe.index);
  return index < probes_.size() && probes_[index].drawn.get() == &probe;
}

// A change of rotation between map and box, or of openings, requires another program.
void ProbeBinder::show(std::size_t index, std::shared_ptr<const ProbeMaps> maps) {
  DrawnProbe& probe = *probes_[index].drawn;
  const bool turned = probe.geometry.mapTurned;
  probe.geometry = geometry(index, maps.get());
  probe.maps = std::move(maps);
  ++generation_;
  if (updateOpenings() || probe.geometry.mapTurned != turned) assign();
}

void ProbeBinder::showSky(std::shared_ptr<const ProbeMaps> maps) {
  with_.state->resources.sky = std::move(maps);
  if (updateOpenings()) assign();
}

void ProbeBinder::see(const std::function<std::shared_ptr<const ProbeMaps>(std::size_t)>& maps) {
  windowSees_.clear();
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    DrawnProbe& probe = *probes_[i].drawn;
    windowSees_.push_back({probe.maps, probe.geometry});
    probe.maps = maps(i);
    probe.geometry = geometry(i, probe.maps.get());
  }
}

void ProbeBinder::seeAgain() {
  for (std::size_t i = 0; i < probes_.size() && i < windowSees_.size(); ++i) {
    probes_[i].drawn->maps = std::move(windowSees_[i].maps);
    probes_[i].drawn->geometry = windowSees_[i].geometry;
  }
  windowSees_.clear();
}

std::function<void(bool)> ProbeBinder::withoutSky(std::function<void(bool)> drawing) {
  return [this, drawing = std::move(drawing)](bool begins) {
    if (begins) skyKept_ = with_.state->resources.sky;
    if (begins) with_.state->resources.sky = nullptr;
    if (drawing) drawing(begins);
    if (!begins) with_.state->resources.sky = std::move(skyKept_);
  };
}

void ProbeBinder::release() {
  for (Shown& probe : probes_) {
    probe.openSkyOf = {};
    probe.drawn->maps.reset();
    probe.drawn->latticeBefore.reset();
  }
  with_.state->resources.sky.reset();
}

// Computed on the CPU from small levels, only for new maps or a new sky, so that another sky costs no capture. Returns
// whether the sky starts or stops showing through a probe, which requires another program.
bool ProbeBinder::updateOpenings() {
  bool changed = false;
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    Shown& probe = probes_[i];
    DrawnProbe& drawn = *probe.drawn;
    const bool asked = std::holds_alternative<ClearToOpen>(with_.content->scene.probes[i].clear);
    const bool open = asked && drawn.maps && openingsOf(*drawn.maps).any;
    changed |= drawn.open != open;
    drawn.open = open;
    if (!with_.state->resources.sky) continue;
    // Nodes of diffuse light are traced to the sky, too.
    if (drawn.seesSky && drawn.shapes && with_.content->sightLines) openingsOf(*with_.state->resources.sky);
    if (!open) continue;
    const auto of = std::make_pair(drawn.maps, with_.state->resources.sky);
    if (probe.openSkyOf == of) continue;
    probe.openSkyOf = of;
    drawn.openSky = skyThroughOpenings(openingsOf(*drawn.maps).reduced, rotationMatrix(drawn.maps->capturedRotation),
                                       openingsOf(*with_.state->resources.sky).reduced);
  }
  return changed;
}

// Finds the scene's lights that cast shadows and, for each probe, those outside its box.
void ProbeBinder::updateShadowLights() {
  const std::vector<Light>& lights = with_.content->scene.lights;
  with_.state->resources.shadowLights.clear();
  for (const Light& light : lights) {
    const bool bySize = light.shadowLevel == ShadowLevel::Size;
    with_.state->resources.shadowLights.push_back(
        {lightSize(light), bySize ? -1.0f : static_cast<float>(light.levelsPerUnit)});
  }
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    const Probe& probe = with_.content->scene.probes[i];
    DrawnProbe& drawn = *probes_[i].drawn;
    drawn.shadowLights = 0;
    drawn.imported = probe.mode == ProbeMode::Custom;
    drawn.seesSky = !drawn.imported && (std::holds_alternative<ClearToSky>(probe.clear) ||
                                        std::holds_alternative<ClearToOpen>(probe.clear));
    for (std::size_t light = 0; light < std::min(lights.size(), kMostShadowLights); ++light) {
      const bool asks = lights[light].shadows != LightShadows::None && lightOutside(lights[light], probe);
      if (asks) drawn.shadowLights |= 1u << light;
    }
  }
}

// Finds the probes whose diffuse light comes from lamps as shapes and a lattice, and their lamps. For pictures, whose
// lamps are unknown, only a lattice.
void ProbeBinder::updateLamps() {
  const SceneContent& content = *with_.content;
  std::vector<std::optional<SightTask>> tasks(2 * probes_.size());  // of drawn probes, then of their captures
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    const Probe& probe = content.scene.probes[i];
    DrawnProbe& drawn = *probes_[i].drawn;
    drawn.shapes = content.lamps != nullptr;
    drawn.prefilter = prefilterSettings(probe);
    drawn.realtime = probe.mode == ProbeMode::Realtime;
    drawn.lattice = probe.lattice;
    if (!drawn.shapes || !probe.hasLattice()) drawn.latticeBefore.reset();
    static const SceneLamps kNotKnown;
    const bool known = probe.mode != ProbeMode::Custom;
    if (drawn.shapes && content.sightLines) {
      tasks[i] = sightTask(content.scene, known ? *content.lamps : kNotKnown, probe);
      if (known) tasks[probes_.size() + i] = captureSightTask(content.scene, *content.lamps, probe);
    }
  }
  sight_.ask(std::move(tasks), content.scene, content.given, content.sightLines);
  wantSight();
  showSight();
}

void ProbeBinder::wantSight() {
  std::vector<bool> wanted(2 * probes_.size(), false);
  for (std::size_t i = 0; i < std::min(probes_.size(), with_.plan->entries().size()); ++i) {
    wanted[i] = wanted[probes_.size() + i] = with_.plan->entries()[i].asked;
  }
  sight_.want(wanted);
}

// Applies the visibilities known so far.
void ProbeBinder::showSight() {
  const SceneLamps* lamps = with_.content->lamps.get();
  SceneResources& resources = with_.state->resources;
  resources.sightLines = lamps != nullptr ? sight_.lines() : nullptr;
  auto loose = std::make_shared<std::vector<Light>>();
  for (std::size_t i = 0; lamps != nullptr && i < with_.content->scene.lights.size(); ++i) {
    const bool counted = std::any_of(lamps->lamps.begin(), lamps->lamps.end(),
                                     [i](const SceneLamp& lamp) { return lamp.light && *lamp.light == i; });
    if (!counted) loose->push_back(with_.content->scene.lights[i]);
  }
  resources.looseLights = std::move(loose);
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    DrawnProbe& drawn = *probes_[i].drawn;
    drawn.sight = drawn.shapes ? sight_.of(i) : nullptr;
    const Probe& probe = with_.content->scene.probes[i];
    const bool known = drawn.shapes && probe.mode != ProbeMode::Custom;
    drawn.lamps = !known        ? std::vector<std::size_t>()
                  : drawn.sight ? drawn.sight->lamps
                                : probeLamps(lamps->lamps, probe);
    drawn.captureSight = !known ? nullptr : sight_.of(probes_.size() + i);
    if (known && !drawn.captureSight) {
      drawn.captureSight = std::make_shared<const ProbeSight>(untracedSight(*lamps, probe));
    }
  }
  inCaptures_ = {};
  for (const Shown& probe : probes_) {
    const ProbeSight* sight = probe.drawn->captureSight.get();
    if (sight == nullptr) continue;
    inCaptures_.lamps |= !sight->lamps.empty();
    inCaptures_.sights |= !sight->lattice.empty();
    for (std::size_t light = 0; light < with_.content->scene.lights.size(); ++light) {
      if (sight->channelOfSource(light) != kSeenByAll) inCaptures_.hiddenLights.insert(light);
    }
  }
}

bool ProbeBinder::makeSight() {
  constexpr std::chrono::milliseconds kTurn(5);  // so that a window stays responsive
  if (!sight_.proceed(kTurn)) return false;
  Counters& counters = with_.state->counts.counters;
  for (const SightWork::Made& made : sight_.made()) {
    counters.sightRays += made.sight->rays;
    if (made.ofCapture || made.sight->rays == 0) continue;
    ++counters.sightsTraced;
    counters.lampsSeenWhole += made.sight->unshadowed;
  }
  showSight();
  return true;
}

void ProbeBinder::addTint(std::size_t index, const ProbeMaps& maps) const {
  const DrawnProbe& probe = drawn(index);
  if (probe.shadowLights == 0 || probe.imported || maps.tint) return;
  maps.tint = glassTint(*with_.content, with_.content->scene.probes[index], maps);
}

void ProbeBinder::assign(std::size_t object) {
  DrawnObject& lit = with_.content->objects[object];
  lit.pass->SetBinding(bindingOf(lit, with_.plan->interactive()));
}

// A box dragged over further objects would need programs that are not compiled yet; that waits for the end of the drag.
void ProbeBinder::assign(bool anyProgram) {
  const bool waits = with_.state->tuning != nullptr && with_.plan->interactive() && !anyProgram;
  for (DrawnObject& object : with_.content->objects) {
    auto binding = bindingOf(object, with_.plan->interactive());
    const ProbeBinding* current = object.pass->GetBinding();
    if (waits && current != nullptr && !with_.state->tuning->known(*current, *binding)) continue;
    object.pass->SetBinding(std::move(binding));
  }
  recordUse();
  needs_.update();
  if (with_.state->tuning != nullptr) with_.state->tuning->assigned();
}

std::shared_ptr<const ProbeBinding> ProbeBinder::bindingOf(const DrawnObject& object, bool general) const {
  const Scene& scene = with_.content->scene;
  auto binding = std::make_shared<ProbeBinding>();
  if (object.unlit) {
    binding->lighting = Lighting::Unlit;
    return binding;
  }
  if (!with_.plan->enabled()) return binding;
  binding->lighting = Lighting::Probes;

  binding->diffuse = !object.allMetal;
  binding->openness = scene.ambientOcclusion;
  if (object.settings.probeUsage == ProbeUsage::Off) return binding;
  const Box bounds = worldBounds(object);
  std::vector<std::size_t> order = places_.meeting(bounds);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Probe& p = scene.probes[a];
    const Probe& q = scene.probes[b];
    return p.importance != q.importance ? p.importance > q.importance : p.name < q.name;
  });
  if (object.settings.probeUsage == ProbeUsage::Simple) keepOne(order, scene, bounds);
  const auto covers = [&](std::size_t i) { return fullWeightEverywhere(scene.probes[i], bounds); };
  if (!general) {
    // A probe that covers the object leaves nothing to less important ones.
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
  // Checked after truncation, which may have removed the probe that covers the object.
  if (!general && std::any_of(order.begin(), order.end(), covers)) {
    binding->sky = false;
    binding->weights = order.size() > 1;
  }
  if (object.settings.probeUsage == ProbeUsage::Simple && !order.empty()) {
    binding->weights = binding->sky = false;
  }
  binding->onlyProbes = object.settings.probeUsage == ProbeUsage::Blend;
  for (const std::size_t i : order) {
    binding->probes.push_back(probes_[i].drawn);
    const ProbeGeometry& geometry = drawn(i).geometry;
    binding->techniques.push_back(isAutomatic(geometry.technique)
                                      ? chooseAutomatic(object.roughnessMin, object.roughnessMax,
                                                        static_cast<double>(geometry.parameters.budget),
                                                        drawn(i).errors.get())
                                            .technique
                                      : geometry.technique);
  }
  binding->shapes =
      std::any_of(binding->probes.begin(), binding->probes.end(), [](const auto& probe) { return probe->shapes; });
  // A first capture divides by what its own probe sees, whatever probes light the object: those of all probes count.
  binding->lamps = std::any_of(binding->probes.begin(), binding->probes.end(),
                               [](const auto& probe) { return !probe->lamps.empty(); }) ||
                   inCaptures_.lamps;
  binding->captureSights = inCaptures_.sights;
  binding->roughnessMin = static_cast<float>(object.roughnessMin);
  binding->roughnessMax = static_cast<float>(object.roughnessMax);
  // Glass is sampled along refracted rays, whose lobes have no lamps as shapes.
  const bool glass = object.surface && object.surface->glass.drawn;
  binding->lampLobes = !glass && binding->roughnessMax > shading::kLampMapRoughness;
  bool anyFree = false;
  for (std::size_t slot = 0; slot < order.size(); ++slot) anyFree |= binding->lampFree(slot);
  binding->lampLobes = anyFree;
  // The lobe of a perfect mirror is one direction: several samples are wasted on it.
  for (Technique& technique : binding->techniques) {
    const bool costly = !evaluationRows()[static_cast<std::size_t>(technique.evaluation)].standIn.empty();
    if (costly && object.roughnessMax <= 0.0) technique.evaluation = parseTechnique("none")->evaluation;
  }
  const bool moves = std::any_of(scene.objects.begin(), scene.objects.end(),
                                 [](const auto& entry) { return entry.second.dynamic && entry.second.visible; });
  const auto at = static_cast<std::size_t>(&object - with_.content->objects.data());
  const std::vector<SunShadow>& suns = with_.state->resources.sunShadows;
  for (std::size_t map = 0; map < suns.size(); ++map) {
    if (at < suns[map].shades.size() && suns[map].shades[at]) binding->sunLights.push_back({suns[map].light, map});
    const bool another = map > 0 && suns[map - 1].light == suns[map].light;
    if (moves && !another) binding->movingLights.push_back(suns[map].light);
  }
  for (std::size_t light = 0; light < std::min(scene.lights.size(), kMostShadowLights); ++light) {
    const bool asked = std::any_of(binding->probes.begin(), binding->probes.end(),
                                   [&](const auto& probe) { return (probe->shadowLights >> light & 1u) != 0; });
    if (!asked) continue;
    binding->shadowLights.push_back(static_cast<int>(light));
    if (moves && scene.lights[light].shadows == LightShadows::CoverageAndMap)
      binding->movingLights.push_back(static_cast<int>(light));
  }
  for (std::size_t light = 0; light < scene.lights.size(); ++light) {
    const bool hidden = std::any_of(binding->probes.begin(), binding->probes.end(), [&](const auto& probe) {
      return probe->sight && probe->sight->channelOfSource(light) != kSeenByAll;
    });
    const bool hiddenInCapture = !binding->probes.empty() && inCaptures_.hiddenLights.count(light) > 0;
    if (hidden || hiddenInCapture) binding->sightLights.push_back(static_cast<int>(light));
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

// By the probes that objects are drawn with, not those that reach them.
void ProbeBinder::recordUse() {
  with_.state->resources.movingLightsInUse.clear();
  std::vector<ObjectUse> uses;
  // Probes of other programs are captured whether or not they light anything.
  if (with_.state->resources.foreign) {
    ObjectUse any;
    any.lit = true;
    for (std::size_t i = 0; i < probes_.size(); ++i) any.probes.push_back(i);
    return with_.plan->entries().setUse({std::move(any)});
  }
  for (const DrawnObject& object : with_.content->objects) {
    ObjectUse use;
    use.lit = !object.unlit && object.settings.visible;
    if (const ProbeBinding* binding = object.pass->GetBinding()) {
      with_.state->resources.movingLightsInUse.insert(binding->movingLights.begin(), binding->movingLights.end());
      for (const auto& probe : binding->probes) {
        // During a drag an object may still be drawn with a probe that was removed.
        if (has(*probe)) use.probes.push_back(static_cast<std::size_t>(probe->index));
      }
    }
    uses.push_back(std::move(use));
  }
  with_.plan->entries().setUse(std::move(uses));
}

// Called between frames, so it only compares. The errors of a realtime probe are measured once per box.
bool ProbeBinder::errorsStale(std::size_t index) const {
  const ProbeEntry& entry = with_.plan->entries()[index];
  const Shown& probe = probes_[index];
  const DrawnProbe& drawn = *probe.drawn;
  const ProbeGeometry& geometry = drawn.geometry;
  if (!entry.used || !drawn.maps || !isAutomatic(geometry.technique)) return false;
  const bool realtime = with_.plan->entries().probe(index).mode == ProbeMode::Realtime;
  if (!realtime && entry.shown != entry.wanted) return false;
  return !drawn.errors || probe.measuredMin != geometry.boxMin || probe.measuredMax != geometry.boxMax ||
         probe.measuredMapFromProbe != geometry.mapFromProbe || (!realtime && probe.measuredKey != entry.shown);
}

std::optional<std::size_t> ProbeBinder::toMeasure() const {
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    if (errorsStale(i)) return i;
  }
  return std::nullopt;
}

void ProbeBinder::measure(std::size_t index) {
  Shown& probe = probes_[index];
  const ProbeGeometry& geometry = probe.drawn->geometry;
  probe.measuredKey = with_.plan->entries()[index].shown;
  probe.measuredMin = geometry.boxMin;
  probe.measuredMax = geometry.boxMax;
  probe.measuredMapFromProbe = geometry.mapFromProbe;
  const CubeMap chain = readRadiance(*probe.drawn->maps);
  const TurnedCube turned(chain, geometry.mapFromProbe);
  probe.drawn->errors = std::make_shared<const TechniqueErrors>(
      measureTechniqueErrors(turned, probeShape(geometry, chain.maxLevel(), 0.0f)));
  ++with_.state->counts.counters.errorsMeasured;
  assign();
}

void LevelNeeds::Need::add(const Lookup& lookup) {
  if (std::find(lookups.begin(), lookups.end(), lookup) == lookups.end()) lookups.push_back(lookup);
}

// Glass also samples along refracted rays, with its material's roughness and that which its form produces.
void LevelNeeds::update() {
  needs_.assign(shown_->size(), {});
  sky_ = {};
  whole_ = false;
  for (const DrawnObject& object : content_->objects) {
    const ProbeBinding* binding = object.pass->GetBinding();
    if (!object.settings.visible || binding == nullptr || binding->lighting != Lighting::Probes) continue;
    const bool glass = object.surface && object.surface->glass.drawn;
    const Lookup own{{}, object.roughnessMin, object.roughnessMax};
    const bool rays = refined_ && binding->refined(1, 1) != nullptr;
    if (binding->sky || binding->open()) {
      sky_.add(own);
      sky_.all |= glass;
    }
    for (std::size_t slot = 0; slot < binding->probes.size(); ++slot) {
      const auto index = static_cast<std::size_t>(binding->probes[slot]->index);
      if (index >= needs_.size() || !shown_->has(*binding->probes[slot])) continue;
      sky_.all |= binding->openByLookup(slot) || (rays && binding->probes[slot]->open);
      Need& need = needs_[index];
      need.all |= glass || rays;
      for (const Technique& technique : {binding->technique(slot), standInFor(binding->technique(slot))}) {
        need.add({technique, own.low, own.high});
      }
    }
  }
}

void LevelNeeds::setRefined(bool refined) {
  if (refined == refined_) return;
  refined_ = refined;
  update();
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
