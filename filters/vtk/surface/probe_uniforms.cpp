#include "filters/vtk/surface/probe_uniforms.h"

#include <vtkCamera.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "filters/core/geometry/lamp_reach.h"
#include "filters/vtk/draw/static_textures.h"
#include "filters/vtk/maps/lamp_free_maps.h"
#include "filters/vtk/surface/camera_uniforms.h"
#include "filters/vtk/surface/coverage_uniforms.h"

namespace boxprobe {

namespace {

constexpr std::size_t kMax = ProbeBinding::kMaxProbesPerDraw;

// A lamp that gives less everywhere on an object, of light that is white on the screen, is left out: less than half a
// step of 8 bits unless what it falls on is nearly black.
constexpr double kLeastLight = 1.0e-5;

template <typename T>
using PerSlot = std::array<T, kMax>;

// During the first bounce no probe has been captured yet.
const ProbeMaps* mapsOf(const DrawState& state, const DrawnProbe& probe) {
  return state.pass().firstBounce ? nullptr : probe.maps.get();
}

// What rough surfaces look up shows no lamps, as soon as it is made.
const ProbeMaps* lookedUp(const ProbeBinding& binding, std::size_t slot, const ProbeMaps* maps) {
  const ProbeMaps* without = maps != nullptr && binding.lampFree(slot) ? maps->lampFree.maps.get() : nullptr;
  return without != nullptr ? without : maps;
}

// The last level of a filtered chain has 4 texels along a face, as gpu/probe_lighting.glsl takes it.
bool endsAtFour(const CubeTexture& chain) {
  return chain.faceSize() >> (chain.levels() - 1) == 4;
}

void uploadSky(const UniformUpload& to, const SceneResources& resources, bool flatMaps) {
  if (flatMaps) return to.texture2d("bpSkyMap", resources.sky->flat.handle());
  to.cube("bpSkyMap", resources.sky ? resources.sky->radiance.handle() : resources.blackCube);
}

// The captured light of each slot.
void uploadLight(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding, bool flatMaps) {
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const ProbeMaps* maps = lookedUp(binding, i, mapsOf(state, *binding.probes[i]));
    const std::string name = "bpMap" + std::to_string(i);
    if (flatMaps) {
      to.texture2d(name, maps->flat.handle());
      continue;
    }
    to.cube(name, maps != nullptr ? maps->radiance.handle() : state.resources.blackCube);
  }
}

void uploadDistances(const UniformUpload& to, const SceneResources& resources, const ProbeBinding& binding) {
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const ProbeMaps* maps = binding.probes[i]->maps.get();
    const bool known = maps != nullptr && maps->distance.allocated();
    to.cube("bpDistanceMap" + std::to_string(i), known ? maps->distance.handle() : resources.blackCube);
  }
}

void uploadRelief(const UniformUpload& to, DrawState& state, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  constexpr std::size_t kMost = ReliefBlocks::kMost;
  PerSlot<int> blocks{};
  std::array<glm::vec3, kMax * kMost> low{}, high{};
  for (std::size_t i = 0; i < count; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    const ProbeMaps* maps = mapsOf(state, probe);
    const bool known = maps != nullptr && maps->distance.allocated();
    if (known) {
      const auto found = maps->relief.blocks(maps->distance, probe.geometry, state.pass().dragging);
      if (binding.marches(i) && maps->relief.makeLevels()) ++state.counts.counters.reliefsBounded;
      blocks[i] = found->count;
      std::copy(found->low.begin(), found->low.end(), low.begin() + static_cast<long>(i * kMost));
      std::copy(found->high.begin(), found->high.end(), high.begin() + static_cast<long>(i * kMost));
    }
    to.cube("bpRelief" + std::to_string(i), known ? maps->relief.handle() : state.resources.blackCube);
  }
  to.program->SetUniform1iv("bpBlockCount", static_cast<int>(count), blocks.data());
  const int most = static_cast<int>(count * kMost);
  to.program->SetUniform3fv("bpBlockLow", most, reinterpret_cast<const float(*)[3]>(&low[0].x));
  to.program->SetUniform3fv("bpBlockHigh", most, reinterpret_cast<const float(*)[3]>(&high[0].x));
}

// What techniques that draw samples go by.
void uploadSampling(const UniformUpload& to, DrawState& state, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  if (binding.chooses("sampling", "luminance")) {
    PerSlot<int> size{};
    for (std::size_t i = 0; i < count; ++i) {
      const ProbeMaps* maps = lookedUp(binding, i, mapsOf(state, *binding.probes[i]));
      if (maps != nullptr) {
        maps->light.make(maps->radiance);
        size[i] = maps->light.faceSize();
      }
      const GLuint handle = size[i] > 0 ? maps->light.handle() : state.resources.brdfTable;  // not read
      to.texture2d("bpLight" + std::to_string(i), handle);
    }
    to.program->SetUniform1iv("bpLightSize", static_cast<int>(count), size.data());
  }
  if (binding.chooses("pattern", "blue")) {
    makeBlueNoise(to.window(), state.resources);
    to.texture2d("bpBlueNoise", state.resources.blueNoise);
  }
  if (to.used("bpPixelOrigin")) to.program->SetUniform2i("bpPixelOrigin", &state.pass().pixelOrigin.x);
  if (to.used("bpFrame")) to.program->SetUniformi("bpFrame", state.pass().frame);
}

LatticeSource latticeSource(const SceneLamps& lamps, const DrawnProbe& probe) {
  const ProbeGeometry& g = probe.geometry;
  LatticeSource source;
  source.boxMin = g.boxMin;
  source.boxMax = g.boxMax;
  source.mapFromProbe = glm::mat3(g.mapFromProbe);
  source.worldFromProbe = glm::mat3(g.worldFromProbe);
  // What follows rays by the distances is for reflections: for light from all around the box is near enough.
  const bool distances = projectionRows()[static_cast<std::size_t>(g.technique.projection)].distances;
  source.projection = distances ? parseTechnique("box")->projection : g.technique.projection;
  const glm::dmat3 worldFromMap = g.worldFromProbe * glm::transpose(g.mapFromProbe);
  for (const std::size_t i : probe.lamps)
    source.lamps.push_back(lampPolygon(lamps.lamps[i], g.originWorld, worldFromMap));
  return source;
}

void setVectors(const UniformUpload& to, const char* name, const glm::vec3* values, std::size_t size) {
  to.program->SetUniform3fv(name, static_cast<int>(size), reinterpret_cast<const float(*)[3]>(values));
}

// Which slots' diffuse light is a lattice's. Of a probe whose lattice cannot be made, lamps are not shapes either.
PerSlot<bool> uploadLattices(const UniformUpload& to, DrawState& state, const ProbeBinding& binding) {
  const SceneLamps* lamps = state.resources.lamps.get();
  const std::size_t count = binding.probes.size();
  PerSlot<glm::vec3> at{}, low{}, perUnit{}, last{};
  PerSlot<bool> shapes{};
  for (std::size_t i = 0; i < count && lamps != nullptr; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    if (!probe.shapes) continue;
    const ProbeMaps* maps = mapsOf(state, probe);
    shapes[i] = maps != nullptr || state.pass().firstBounce;
    if (maps == nullptr || !binding.diffuse) continue;
    const auto lattice =
        maps->lattice.of(maps->radiance, maps->distance, latticeSource(*lamps, probe), state.pass().dragging);
    shapes[i] = lattice && !lattice->empty();
    if (!shapes[i]) continue;
    const shading::LatticeShape shape = lattice->shape();
    at[i] = state.resources.lattices->place(lattice);
    low[i] = shape.low;
    perUnit[i] = shape.perUnit;
    last[i] = shape.last;
  }
  if (!binding.diffuse) return shapes;
  setVectors(to, "bpLatticeAt", at.data(), count);
  setVectors(to, "bpLatticeLow", low.data(), count);
  setVectors(to, "bpLatticePerUnit", perUnit.data(), count);
  setVectors(to, "bpLatticeLast", last.data(), count);
  const glm::vec3 texel = state.resources.lattices->texelSize();
  to.program->SetUniform3f("bpLatticeTexel", &texel.x);
  to.texture("bpLattices", GL_TEXTURE_3D, state.resources.lattices->handle());
  return shapes;
}

// Which slots' maps show no lamps, so that these are drawn; where nothing is captured yet, there is nothing to show.
void uploadLampFree(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding) {
  PerSlot<float> free{};
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    if (!binding.lampFree(i)) continue;
    const ProbeMaps* maps = mapsOf(state, *binding.probes[i]);
    const bool without = maps != nullptr ? maps->lampFree.maps != nullptr : state.pass().firstBounce;
    free[i] = without ? 1.0f : 0.0f;
  }
  to.program->SetUniform1fv("bpLampFree", static_cast<int>(binding.probes.size()), free.data());
}

void uploadLamps(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding,
                 const PerSlot<bool>& shapes) {
  const double least = kLeastLight / std::max(static_cast<double>(state.exposure()), 1.0e-6);
  const double roughness =
      binding.lampLobes ? static_cast<double>(std::max(binding.roughnessMin, shading::kLampMapRoughness)) : 1.0;
  std::map<std::size_t, glm::vec4> lampOf;  // by falling power
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    if (!shapes[i]) continue;
    for (const std::size_t lamp : binding.probes[i]->lamps) {
      const bool lit = lampReaches(state.resources.lamps->lamps[lamp], to.bounds, roughness, least);
      if (lit) lampOf[lamp][static_cast<int>(i)] = 1.0f;
    }
  }
  constexpr std::size_t kLamps = ProbeBinding::kMaxLampsPerDraw, kCorners = shading::kLampCorners;
  std::array<glm::vec3, kLamps * kCorners> corners{};
  std::array<glm::vec3, kLamps> light{};
  std::array<glm::vec4, kLamps> slots{};
  std::array<int, kLamps> shape{};
  std::size_t used = 0;
  for (const auto& [index, of] : lampOf) {
    if (used == kLamps) break;
    const SceneLamp& lamp = state.resources.lamps->lamps[index];
    const LampPolygon polygon = lampPolygon(lamp, to.eyeWorld());
    std::copy(polygon.corners.begin(), polygon.corners.end(), corners.begin() + static_cast<long>(used * kCorners));
    shape[used] = polygon.count + (polygon.bothSides ? 16 : 0);
    light[used] = glm::vec3(lamp.radiance);
    slots[used++] = of;
  }
  to.program->SetUniformi("bpLampCount", static_cast<int>(used));
  if (binding.lampLobes) {
    const bool several = std::any_of(light.begin(), light.begin() + static_cast<long>(used), [&](const glm::vec3& l) {
      return glm::length(glm::normalize(l) - glm::normalize(light[0])) > 1.0e-3f;
    });
    to.program->SetUniformf("bpLampColors", several ? 1.0f : 0.0f);
  }
  if (used == 0) return;
  setVectors(to, "bpLampCorner", corners.data(), used * kCorners);
  setVectors(to, "bpLampLight", light.data(), used);
  to.program->SetUniform1iv("bpLampShape", static_cast<int>(used), shape.data());
  to.program->SetUniform4fv("bpLampOf", static_cast<int>(used), reinterpret_cast<const float(*)[4]>(&slots[0].x));
}

void uploadOrigins(const UniformUpload& to, const ProbeBinding& binding) {
  PerSlot<glm::vec3> origin;
  const glm::dvec3 eye = to.eyeWorld();
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    origin[i] = glm::vec3(binding.probes[i]->geometry.originWorld - eye);
  }
  to.program->SetUniform3fv("bpOrigin", static_cast<int>(binding.probes.size()),
                            reinterpret_cast<const float(*)[3]>(&origin[0].x));
}

}  // namespace

void makeLampFree(DrawState& state, const ProbeBinding& binding) {
  const SceneResources& resources = state.resources;
  if (!binding.lampLobes || !resources.lamps || state.pass().firstBounce) return;
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    if (!binding.lampFree(i) || !probe.maps) continue;
    const ProbeMaps& maps = *probe.maps;
    const ProbeGeometry& g = probe.geometry;
    const glm::dmat3 worldFromMap = g.worldFromProbe * glm::transpose(g.mapFromProbe);
    std::vector<LampPolygon> lamps;
    for (const std::size_t lamp : probe.lamps) {
      lamps.push_back(lampPolygon(resources.lamps->lamps[lamp], g.originWorld, worldFromMap));
    }
    const LevelMask levels = levelsRead(binding.technique(i), g.parameters, static_cast<double>(binding.roughnessMin),
                                        static_cast<double>(binding.roughnessMax), maps.radiance.levels());
    const bool made = makeLampFreeMaps(
        maps, lamps, levels, state.pass().dragging,
        [&](const CubeTexture& chain, LevelMask missing) { resources.filterLevels(chain, missing, probe.prefilter); });
    if (!made) maps.need(levels);
  }
}

// What is not captured yet has no picture, and what of the sky no draw of the binding looks up needs none.
bool makeFlatMaps(DrawState& state, const ProbeBinding& binding) {
  if (!state.resources.flatMaps || state.pass().firstBounce || binding.lighting != Lighting::Probes) return false;
  std::vector<const ProbeMaps*> all;
  if (binding.sky || binding.open()) all.push_back(state.resources.sky.get());
  for (std::size_t i = 0; i < binding.probes.size(); ++i)
    all.push_back(lookedUp(binding, i, binding.probes[i]->maps.get()));
  std::size_t more = 0;
  for (const ProbeMaps* maps : all) {
    if (maps == nullptr || !FlatTexture::fits(maps->radiance) || !endsAtFour(maps->radiance)) return false;
    more += maps->flat.bytesToMake(maps->radiance);
  }
  if (more > 0 && *state.resources.flatBytes + more > FlatTexture::kMostBytes) return false;
  return std::all_of(all.begin(), all.end(), [&state](const ProbeMaps* maps) {
    const bool before = maps->flat.handle() != 0;
    const bool there = maps->flat.make(maps->radiance, state.resources.flatBytes);
    if (there && !before) ++state.counts.counters.mapsFlattened;
    return there;
  });
}

void uploadSplitSum(const UniformUpload& to, const SceneResources& resources) {
  to.texture2d("bpBrdf", resources.brdfTable);
}

void uploadSurroundings(const UniformUpload& to, const SceneResources& resources, const ProbeBinding& binding,
                        bool flatMaps) {
  to.program->SetUniformMatrix3x3("bpViewToWorld", viewToWorldRotation(to.camera()).data());
  uploadSplitSum(to, resources);
  if (binding.sky || binding.open()) uploadSky(to, resources, flatMaps);
}

void uploadOutput(const UniformUpload& to, const PassSettings& pass) {
  to.program->SetUniformf("bpExposure", pass.exposure);
  to.program->SetUniformf("bpParallel", to.camera()->GetParallelProjection() ? 1.0f : 0.0f);
}

void uploadLighting(const UniformUpload& to, DrawState& state, const ProbeBinding& binding, bool debug,
                    const RestingValues& resting, const RestingValues* constants, bool flatMaps) {
  ++state.counts.counters.uniformUpdates;
  uploadSurroundings(to, state.resources, binding, flatMaps);
  uploadResting(to, resting, constants);
  if (!binding.probes.empty()) uploadSlots(to, state, binding, debug, flatMaps);
  if (!binding.shadowLights.empty()) uploadCoverage(to, state, binding);
}

void uploadSlots(const UniformUpload& to, DrawState& state, const ProbeBinding& binding, bool debug, bool flatMaps) {
  uploadLight(to, state, binding, flatMaps);
  if (debug) uploadDistances(to, state.resources, binding);
  if (binding.distances() && !binding.firstBounce) uploadRelief(to, state, binding);
  if (!binding.firstBounce) uploadSampling(to, state, binding);
  if (binding.lampLobes) uploadLampFree(to, state, binding);
  if (binding.lampsDrawn()) uploadLamps(to, state, binding, uploadLattices(to, state, binding));
  uploadOrigins(to, binding);
}

}  // namespace boxprobe
