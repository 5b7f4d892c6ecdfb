#include "filters/vtk/surface/probe_uniforms.h"

#include <vtkCamera.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <map>

#include "filters/vtk/draw/static_textures.h"
#include "filters/vtk/surface/camera_uniforms.h"
#include "filters/vtk/surface/coverage_uniforms.h"

namespace boxprobe {

namespace {

constexpr std::size_t kMax = ProbeBinding::kMaxProbesPerDraw;

template <typename T>
using PerSlot = std::array<T, kMax>;

// During the first bounce no probe has been captured yet.
const ProbeMaps* mapsOf(const DrawState& state, const DrawnProbe& probe) {
  return state.pass().firstBounce ? nullptr : probe.maps.get();
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
    const ProbeMaps* maps = mapsOf(state, *binding.probes[i]);
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
      const ProbeMaps* maps = mapsOf(state, *binding.probes[i]);
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

LatticeSource latticeSource(const SceneResources& resources, const DrawnProbe& probe) {
  const SceneLamps& lamps = *resources.lamps;
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
  if (!resources.sightLines) return source;
  source.traced = {resources.sightLines, g.originWorld, g.worldFromProbe,     g.mapFromProbe,
                   resources.lamps,      probe.lamps,   resources.looseLights};
  return source;
}

// Where the visibility of a lamp stands in each slot's lattice.
glm::vec4 lampChannels(const ProbeBinding& binding, std::size_t lamp) {
  glm::vec4 channels(static_cast<float>(kSeenByAll));
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const auto& sight = binding.probes[i]->sight;
    if (sight) channels[static_cast<int>(i)] = static_cast<float>(sight->channelOfLamp(lamp));
  }
  return channels;
}

// Of each slot its lattice; with that, and where nothing is captured yet, its lamps as shapes.
void uploadLampsAndLattices(const UniformUpload& to, DrawState& state, const ProbeBinding& binding) {
  const SceneLamps* lamps = state.resources.lamps.get();
  const std::size_t count = binding.probes.size();
  PerSlot<glm::vec3> at{}, low{}, perUnit{}, last{};
  std::map<std::size_t, glm::vec4> lampOf;  // by falling power
  for (std::size_t i = 0; i < count && lamps != nullptr; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    if (!probe.shapes) continue;
    const ProbeMaps* maps = mapsOf(state, probe);
    if (maps != nullptr) {
      const auto lattice = maps->lattice.of(maps->radiance, maps->distance, latticeSource(state.resources, probe),
                                            state.pass().dragging);
      if (!lattice || lattice->empty()) continue;
      const shading::LatticeShape shape = lattice->shape();
      at[i] = state.resources.lattices->place(lattice);
      low[i] = shape.low;
      perUnit[i] = shape.perUnit;
      last[i] = shape.last;
    } else if (!state.pass().firstBounce) {
      continue;
    }
    for (const std::size_t lamp : probe.lamps) lampOf[lamp][static_cast<int>(i)] = 1.0f;
  }
  constexpr std::size_t kLamps = ProbeBinding::kMaxLampsPerDraw, kCorners = shading::kLampCorners;
  std::array<glm::vec3, kLamps * kCorners> corners{};
  std::array<glm::vec3, kLamps> light{};
  std::array<glm::vec4, kLamps> slots{};
  std::array<int, kLamps> shape{};
  std::array<glm::vec4, kLamps> channels{};
  std::size_t used = 0;
  for (const auto& [index, of] : lampOf) {
    if (used == kLamps) break;
    const SceneLamp& lamp = lamps->lamps[index];
    const LampPolygon polygon = lampPolygon(lamp, to.eyeWorld());
    std::copy(polygon.corners.begin(), polygon.corners.end(), corners.begin() + static_cast<long>(used * kCorners));
    shape[used] = polygon.count + (polygon.bothSides ? 16 : 0);
    light[used] = glm::vec3(lamp.radiance);
    channels[used] = lampChannels(binding, index);
    slots[used++] = of;
  }
  const auto vectors = [&](const char* name, const glm::vec3* values, std::size_t size) {
    to.program->SetUniform3fv(name, static_cast<int>(size), reinterpret_cast<const float(*)[3]>(values));
  };
  vectors("bpLatticeAt", at.data(), count);
  vectors("bpLatticeLow", low.data(), count);
  vectors("bpLatticePerUnit", perUnit.data(), count);
  vectors("bpLatticeLast", last.data(), count);
  const glm::vec3 texel = state.resources.lattices->texelSize();
  to.program->SetUniform3f("bpLatticeTexel", &texel.x);
  to.texture("bpLattices", GL_TEXTURE_3D, state.resources.lattices->handle());
  to.program->SetUniformi("bpLampCount", static_cast<int>(used));
  if (used == 0) return;
  vectors("bpLampCorner", corners.data(), used * kCorners);
  vectors("bpLampLight", light.data(), used);
  to.program->SetUniform1iv("bpLampShape", static_cast<int>(used), shape.data());
  to.program->SetUniform4fv("bpLampOf", static_cast<int>(used), reinterpret_cast<const float(*)[4]>(&slots[0].x));
  if (!binding.sights()) return;
  to.program->SetUniform4fv("bpLampChannel", static_cast<int>(used),
                            reinterpret_cast<const float(*)[4]>(&channels[0].x));
}

// Of each slot its lattice of visibilities, and where those of light sources stand.
void uploadSights(const UniformUpload& to, DrawState& state, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  PerSlot<glm::vec3> at{}, low{}, perUnit{}, last{};
  PerSlot<int> parts{};
  for (std::size_t i = 0; i < count; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    const auto place = state.resources.sights->place(probe.sight);
    if (!place) continue;
    const shading::LatticeShape shape = sightShape(*probe.sight, probe.geometry);
    at[i] = *place;
    low[i] = shape.low;
    perUnit[i] = shape.perUnit;
    last[i] = shape.last;
    parts[i] = probe.sight->lattice.parts();
  }
  const auto vectors = [&](const char* name, const PerSlot<glm::vec3>& values) {
    to.program->SetUniform3fv(name, static_cast<int>(count), reinterpret_cast<const float(*)[3]>(&values[0].x));
  };
  vectors("bpSightAt", at);
  vectors("bpSightLow", low);
  vectors("bpSightPerUnit", perUnit);
  vectors("bpSightLast", last);
  to.program->SetUniform1iv("bpSightParts", static_cast<int>(count), parts.data());
  to.texture("bpSights", GL_TEXTURE_3D, state.resources.sights->handle());
  const glm::vec3 texel = state.resources.sights->texelSize();
  to.program->SetUniform3f("bpSightTexel", &texel.x);
  std::vector<glm::vec4> channels;
  for (const int light : binding.sightLights) {
    glm::vec4 of(static_cast<float>(kSeenByAll));
    for (std::size_t i = 0; i < count; ++i) {
      const auto& sight = binding.probes[i]->sight;
      if (sight) {
        of[static_cast<int>(i)] = static_cast<float>(sight->channelOfSource(static_cast<std::size_t>(light)));
      }
    }
    channels.push_back(of);
  }
  if (channels.empty()) return;
  to.program->SetUniform4fv("bpSightChannel", static_cast<int>(channels.size()),
                            reinterpret_cast<const float(*)[4]>(&channels[0].x));
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

// What is not captured yet has no picture, and what of the sky no draw of the binding looks up needs none.
bool makeFlatMaps(DrawState& state, const ProbeBinding& binding) {
  if (!state.resources.flatMaps || state.pass().firstBounce || binding.lighting != Lighting::Probes) return false;
  std::vector<const ProbeMaps*> all;
  if (binding.sky || binding.open()) all.push_back(state.resources.sky.get());
  for (const auto& probe : binding.probes) all.push_back(probe->maps.get());
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
  if (binding.shapes && binding.diffuse) uploadLampsAndLattices(to, state, binding);
  if (binding.sights()) uploadSights(to, state, binding);
  uploadOrigins(to, binding);
}

}  // namespace boxprobe
