#include "filters/vtk/surface/probe_uniforms.h"

#include <vtkCamera.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "filters/vtk/draw/probe_lattice.h"
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

// Nothing of the lamp reaches the object: it lies behind the lamp's plane, or so far away that the light is below a
// fifth of the darkest step of an 8-bit picture. A capture is seen at any exposure.
bool outOfReach(const SceneLamp& lamp, const UniformUpload& to, const PassSettings& pass) {
  if (to.boundsWorld == nullptr || to.boundsWorld[0] > to.boundsWorld[1]) return false;
  const double* b = to.boundsWorld;
  double highest = -1.0e300, size = 0.0;
  glm::dvec3 beyond(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const double low = b[2 * axis], high = b[2 * axis + 1];
    size += high - low;
    beyond[axis] = std::max({low - lamp.middle[axis], lamp.middle[axis] - high, 0.0});
  }
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at(b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2)]);
    highest = std::max(highest, glm::dot(at - lamp.middle, lamp.normal));
  }
  if (!lamp.bothSides && highest < -1.0e-6 * size) return true;
  if (pass.exposure == kLinearOutput) return false;
  constexpr double kDarkestStep = 1.0 / (255.0 * 12.92), kPi = 3.14159265358979323846;
  double radius = 0.0;
  for (const glm::dvec3& corner : lamp.corners) radius = std::max(radius, glm::length(corner - lamp.middle));
  const double distance = glm::length(beyond) - radius;
  const double brightest = std::max({lamp.radiance.x, lamp.radiance.y, lamp.radiance.z});
  return distance > 0.0 &&
         static_cast<double>(pass.exposure) * brightest * lamp.area / (kPi * distance * distance) < 0.2 * kDarkestStep;
}

// Opposite faces of a lamp that is a box: where one is seen, the other is not, and both are worked out in one turn.
// Orders `drawn` by turns, then the others of turns; returns how many turns there are.
std::size_t pairLamps(const std::vector<SceneLamp>& lamps, std::vector<std::size_t>& drawn, int* other) {
  const auto backToBack = [&](std::size_t a, std::size_t b) {
    const SceneLamp &first = lamps[a], &second = lamps[b];
    return !first.bothSides && !second.bothSides && glm::dot(first.normal, second.normal) < -0.9999999 &&
           glm::dot(second.middle - first.middle, first.normal) <= 0.0;
  };
  std::vector<std::size_t> firsts, seconds;
  std::vector<bool> paired(drawn.size(), false);
  std::vector<std::ptrdiff_t> partner;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (paired[i]) continue;
    firsts.push_back(drawn[i]);
    partner.push_back(-1);
    for (std::size_t k = i + 1; k < drawn.size(); ++k) {
      if (paired[k] || !backToBack(drawn[i], drawn[k])) continue;
      paired[k] = true;
      partner.back() = static_cast<std::ptrdiff_t>(seconds.size());
      seconds.push_back(drawn[k]);
      break;
    }
  }
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    other[i] = static_cast<int>(partner[i] < 0 ? i : firsts.size() + static_cast<std::size_t>(partner[i]));
  }
  drawn = firsts;
  drawn.insert(drawn.end(), seconds.begin(), seconds.end());
  return firsts.size();
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
    if (!state.pass().firstBounce) {
      const auto lattice = probeLattice(state, probe);
      if (!lattice) continue;
      const shading::LatticeShape shape = lattice->shape();
      at[i] = state.resources.lattices->place(lattice);
      low[i] = shape.low;
      perUnit[i] = shape.perUnit;
      last[i] = shape.last;
    }
    for (const std::size_t lamp : probe.lamps) {
      if (!outOfReach(lamps->lamps[lamp], to, state.pass())) lampOf[lamp][static_cast<int>(i)] = 1.0f;
    }
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
  if (!binding.lamps) return;
  constexpr std::size_t kLamps = ProbeBinding::kMaxLampsPerDraw, kCorners = shading::kLampCorners;
  std::array<glm::vec3, kLamps * kCorners> corners{};
  std::array<glm::vec3, kLamps> light{};
  std::array<glm::vec4, kLamps> slots{};
  std::array<int, kLamps> shape{}, other{};
  shape[0] = 3;  // the loop has one turn at least: of a lamp that is a point and gives nothing
  std::vector<std::size_t> drawn;
  for (const auto& entry : lampOf) {
    if (drawn.size() < kLamps) drawn.push_back(entry.first);
  }
  const bool first = state.pass().firstBounce;
  const std::size_t turns = pairLamps(lamps->lamps, drawn, other.data());
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const SceneLamp& lamp = lamps->lamps[drawn[k]];
    const LampPolygon polygon = lampPolygon(lamp, to.eyeWorld());
    std::copy(polygon.corners.begin(), polygon.corners.end(), corners.begin() + static_cast<long>(k * kCorners));
    shape[k] = polygon.count + (polygon.bothSides ? 16 : 0);
    light[k] = glm::vec3(lamp.radiance);
    slots[k] = first ? glm::vec4(0.0f) : lampOf[drawn[k]];
  }
  const std::size_t used = std::max<std::size_t>(drawn.size(), 1);
  to.program->SetUniformf("bpLampLeast", first && !drawn.empty() ? 1.0f : 0.0f);
  to.program->SetUniformi("bpLampCount", static_cast<int>(turns));
  to.program->SetUniform1iv("bpLampOther", static_cast<int>(used), other.data());
  vectors("bpLampCorner", corners.data(), used * kCorners);
  vectors("bpLampLight", light.data(), used);
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
  uploadOrigins(to, binding);
}

}  // namespace boxprobe
