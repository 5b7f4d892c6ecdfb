#include "filters/vtk/probes/probe_light.h"

#include <algorithm>

#include "filters/core/geometry/light_shadow.h"
#include "filters/math/cube/openings.h"
#include "filters/vtk/maps/cube_transfer.h"
#include "filters/vtk/scene/glass_tint.h"

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

}  // namespace

bool ProbeLight::updateOpenings() {
  bool changed = false;
  for (std::size_t i = 0; i < shown_->size(); ++i) {
    ShownProbe& probe = (*shown_)[i];
    DrawnProbe& drawn = *probe.drawn;
    const bool asked = std::holds_alternative<ClearToOpen>(content_->scene.probes[i].clear);
    const bool open = asked && drawn.maps && openingsOf(*drawn.maps).any;
    changed |= drawn.open != open;
    drawn.open = open;
    if (!open || !state_->resources.sky) continue;
    const auto of = std::make_pair(drawn.maps, state_->resources.sky);
    if (probe.openSkyOf == of) continue;
    probe.openSkyOf = of;
    drawn.openSky = skyThroughOpenings(openingsOf(*drawn.maps).reduced, rotationMatrix(drawn.maps->capturedRotation),
                                       openingsOf(*state_->resources.sky).reduced);
  }
  return changed;
}

void ProbeLight::updateShadowLights() {
  const std::vector<Light>& lights = content_->scene.lights;
  state_->resources.shadowLights.clear();
  for (const Light& light : lights) {
    const bool bySize = light.shadowLevel == ShadowLevel::Size;
    state_->resources.shadowLights.push_back(
        {lightSize(light), bySize ? -1.0f : static_cast<float>(light.levelsPerUnit)});
  }
  for (std::size_t i = 0; i < shown_->size(); ++i) {
    const Probe& probe = content_->scene.probes[i];
    DrawnProbe& drawn = shown_->drawn(i);
    drawn.shadowLights = 0;
    drawn.imported = probe.mode == ProbeMode::Custom;
    for (std::size_t light = 0; light < std::min(lights.size(), kMostShadowLights); ++light) {
      const bool asks = lights[light].shadows != LightShadows::None && lightOutside(lights[light], probe);
      if (asks) drawn.shadowLights |= 1u << light;
    }
  }
}

void ProbeLight::updateLamps() {
  const SceneLamps* lamps = content_->lamps.get();
  std::vector<std::optional<SightTask>> tasks(shown_->size());
  for (std::size_t i = 0; i < shown_->size(); ++i) {
    const Probe& probe = content_->scene.probes[i];
    DrawnProbe& drawn = shown_->drawn(i);
    drawn.shapes =
        lamps != nullptr && probe.mode == ProbeMode::Baked && !std::holds_alternative<ClearToOpen>(probe.clear);
    if (drawn.shapes && content_->sightLines) tasks[i] = sightTask(content_->scene, *lamps, probe);
  }
  sight_.ask(std::move(tasks), content_->scene, content_->given, content_->sightLines);
  showSight();
}

void ProbeLight::showSight() {
  const SceneLamps* lamps = content_->lamps.get();
  state_->resources.sightLines = lamps != nullptr ? sight_.lines() : nullptr;
  state_->resources.looseLights.clear();
  for (std::size_t i = 0; lamps != nullptr && i < content_->scene.lights.size(); ++i) {
    const bool counted = std::any_of(lamps->lamps.begin(), lamps->lamps.end(),
                                     [i](const SceneLamp& lamp) { return lamp.light && *lamp.light == i; });
    if (!counted) state_->resources.looseLights.push_back(content_->scene.lights[i]);
  }
  for (std::size_t i = 0; i < shown_->size(); ++i) {
    DrawnProbe& drawn = shown_->drawn(i);
    drawn.sight = drawn.shapes ? sight_.of(i) : nullptr;
    drawn.lamps = !drawn.shapes ? std::vector<std::size_t>()
                  : drawn.sight ? drawn.sight->lamps
                                : probeLamps(lamps->lamps, content_->scene.probes[i]);
  }
}

void ProbeLight::holdSight(bool held) {
  sight_.hold(held);
}

bool ProbeLight::makeSight() {
  if (!sight_.proceed(std::chrono::milliseconds(5))) return false;
  Counters& counters = state_->counts.counters;
  for (const auto& sight : sight_.made()) {
    ++counters.sightsTraced;
    counters.sightRays += sight->rays;
    counters.lampsSeenWhole += sight->unshadowed;
  }
  showSight();
  return true;
}

void ProbeLight::addTint(std::size_t index, const ProbeMaps& maps) const {
  const DrawnProbe& drawn = shown_->drawn(index);
  if (drawn.shadowLights == 0 || drawn.imported || maps.tint) return;
  maps.tint = glassTint(*content_, content_->scene.probes[index], maps);
}

}  // namespace boxprobe
