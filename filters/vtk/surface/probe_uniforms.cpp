#include "filters/vtk/surface/probe_uniforms.h"

#include <vtkCamera.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLCamera.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <string>

#include "filters/core/geometry/lamp_reach.h"
#include "filters/core/picture/probe_color.h"
#include "filters/vtk/draw/probe_lamps.h"
#include "filters/vtk/draw/probe_lattice.h"
#include "filters/vtk/draw/static_textures.h"
#include "filters/vtk/surface/camera_uniforms.h"
#include "filters/vtk/surface/glass_draw.h"

namespace boxprobe {

namespace {

constexpr std::size_t kMax = ProbeBinding::kMaxProbesPerDraw;

template <typename T>
using PerSlot = std::array<T, kMax>;

// During the first bounce no probe has been captured yet.
const ProbeMaps* mapsOf(const DrawState& state, const DrawnProbe& probe) {
  return state.pass().firstBounce ? nullptr : probe.maps.get();
}

void uploadSky(const UniformUpload& to, const SceneResources& resources, bool flatMaps) {
  if (flatMaps) return to.texture2d("bpSkyMap", resources.sky->flat.handle());
  to.cube("bpSkyMap", resources.sky ? resources.sky->radiance.handle() : resources.blackCube);
}

// The captured light of each slot.
void uploadLight(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding, bool flatMaps) {
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const ProbeMaps* maps = state.pass().firstBounce ? nullptr : binding.lookedUp(i, state.pass().capture);
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
      const ProbeMaps* maps = state.pass().firstBounce ? nullptr : binding.lookedUp(i, state.pass().capture);
      if (maps != nullptr) {
        maps->light.make(maps->radiance);
        size[i] = maps->light.faceSize();
      }
      const GLuint handle = size[i] > 0 ? maps->light.handle() : state.resources.brdfTable;  // not read
      to.texture2d("bpLight" + std::to_string(i), handle);
    }
    to.program->SetUniform1iv("bpLightSize", static_cast<int>(count), size.data());
  }
  if (binding.blueNoise()) {
    makeBlueNoise(to.window(), state.resources);
    to.texture2d("bpBlueNoise", state.resources.blueNoise);
  }
  if (to.used("bpPixelOrigin")) to.program->SetUniform2i("bpPixelOrigin", &state.pass().pixelOrigin.x);
  if (to.used("bpFrame")) to.program->SetUniformi("bpFrame", state.pass().frame);
}

// Nothing of the lamp reaches the object: it lies behind the lamp's plane, or so far away that the light is below a
// fifth of the darkest step of an 8-bit picture. A capture is seen at any exposure, and a lobe may be narrow.
bool outOfReach(const SceneLamp& lamp, const UniformUpload& to, const PassSettings& pass, bool glossy) {
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
  if (glossy || pass.exposure == kLinearOutput) return false;
  constexpr double kDarkestStep = 1.0 / (255.0 * 12.92), kPi = 3.14159265358979323846;
  double radius = 0.0;
  for (const glm::dvec3& corner : lamp.corners) radius = std::max(radius, glm::length(corner - lamp.middle));
  const double distance = glm::length(beyond) - radius;
  const double brightest = std::max({lamp.radiance.x, lamp.radiance.y, lamp.radiance.z});
  return distance > 0.0 &&
         static_cast<double>(pass.exposure) * brightest * lamp.area / (kPi * distance * distance) < 0.2 * kDarkestStep;
}

// What the slot sees of lamps and light sources. In a first capture the first slot has what the capture does.
const std::shared_ptr<const ProbeSight>& sightOf(const PassSettings& pass, const ProbeBinding& binding,
                                                 std::size_t slot) {
  static const std::shared_ptr<const ProbeSight> kNone;
  if (!pass.firstBounce) return binding.probes[slot]->sight;
  return slot == 0 ? pass.sight : kNone;
}

// Where the visibility of a lamp stands in each slot's lattice.
glm::vec4 lampChannels(const PassSettings& pass, const ProbeBinding& binding, std::size_t lamp) {
  glm::vec4 channels(static_cast<float>(kSeenByAll));
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const auto& sight = sightOf(pass, binding, i);
    if (sight) channels[static_cast<int>(i)] = static_cast<float>(sight->channelOfLamp(lamp));
  }
  return channels;
}

// Nothing on the object sees the lamp.
bool hiddenEverywhere(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding, std::size_t slot,
                      std::size_t lamp) {
  const double* b = to.boundsWorld;
  const auto& sight = sightOf(state.pass(), binding, slot);
  if (!binding.sights() || !sight || b == nullptr || b[0] > b[1]) return false;
  const int channel = sight->channelOfLamp(lamp);
  if (channel >= 0 && !state.resources.sights->place(sight)) return false;  // without a lattice all is seen
  thread_local LampReach known;
  return !known.seen(sight, channel, {b[0], b[1], b[2], b[3], b[4], b[5]});
}

// Of each slot its lattice; with that, and where nothing is captured yet, its lamps as shapes. Where maps show no
// lamps, so that reflections need them, those as well.
void uploadLampsAndLattices(const UniformUpload& to, DrawState& state, const ProbeBinding& binding) {
  const SceneLamps* lamps = state.resources.lamps.get();
  const std::size_t count = binding.probes.size();
  PerSlot<glm::vec3> at{}, low{}, perUnit{}, last{};
  PerSlot<float> free{}, cut{};
  glm::vec4 lit(0.0f);                      // slots whose diffuse light is that of lamps
  std::map<std::size_t, glm::vec4> lampOf;  // by falling power
  const auto addLamps = [&](const std::vector<std::size_t>& which, std::size_t slot) {
    for (const std::size_t lamp : which) {
      const bool reaches = !outOfReach(lamps->lamps[lamp], to, state.pass(), binding.lampLobes) &&
                           !hiddenEverywhere(to, state, binding, slot, lamp);
      if (reaches) lampOf[lamp][static_cast<int>(slot)] = 1.0f;
    }
  };
  const auto latticeOf = [&](const DrawnProbe& probe) {
    return binding.diffuse && !state.pass().firstBounce ? probeLattice(state, probe) : nullptr;
  };
  // What comes anew may move what stands there: all come first, then each is asked for its place.
  for (std::size_t i = 0; i < count && lamps != nullptr; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    if (!probe.shapes) continue;
    if (const auto lattice = latticeOf(probe)) state.resources.lattices->place(lattice);
  }
  for (std::size_t i = 0; i < count && lamps != nullptr; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    if (!probe.shapes) continue;
    const auto lattice = latticeOf(probe);
    if (lattice) {
      const shading::LatticeShape shape = lattice->shape();
      at[i] = state.resources.lattices->place(lattice);
      low[i] = shape.low;
      perUnit[i] = shape.perUnit;
      last[i] = shape.last;
      cut[i] = shape.cut;
    }
    lit[static_cast<int>(i)] = lattice ? 1.0f : 0.0f;
    const bool without = binding.lookedUp(i, state.pass().capture) != probe.maps.get();
    free[i] = binding.lampFree(i) && without ? 1.0f : 0.0f;
    if (state.pass().firstBounce || (lit[static_cast<int>(i)] <= 0.0f && free[i] <= 0.0f)) continue;
    addLamps(probe.lamps, i);
  }
  if (state.pass().firstBounce) {
    lit = glm::vec4(1.0f);
    if (lamps != nullptr && state.pass().sight) addLamps(state.pass().sight->lamps, 0);
  }
  const auto vectors = [&](const char* name, const glm::vec3* values, std::size_t size) {
    to.program->SetUniform3fv(name, static_cast<int>(size), reinterpret_cast<const float(*)[3]>(values));
  };
  if (binding.diffuse) {
    vectors("bpLatticeAt", at.data(), count);
    vectors("bpLatticeLow", low.data(), count);
    vectors("bpLatticePerUnit", perUnit.data(), count);
    vectors("bpLatticeLast", last.data(), count);
    to.program->SetUniform1fv("bpLatticeCut", static_cast<int>(count), cut.data());
    const glm::vec3 texel = state.resources.lattices->texelSize();
    to.program->SetUniform3f("bpLatticeTexel", &texel.x);
    to.texture("bpLattices", GL_TEXTURE_3D, state.resources.lattices->handle());
  }
  if (!binding.lampsDrawn()) return;
  to.program->SetUniform4f("bpLampLit", &lit.x);
  if (binding.lampLobes) to.program->SetUniform1fv("bpLampFree", static_cast<int>(count), free.data());
  constexpr std::size_t kLamps = LampNumbers::kLamps, kCorners = LampNumbers::kCorners;
  static_assert(kCorners == shading::kLampCorners);
  LampNumbers numbers;
  numbers.middle[0].w = 3.0f;  // the loop has one turn at least: of a lamp that is a point and gives nothing
  std::vector<std::size_t> drawn;
  for (const auto& entry : lampOf) {
    if (drawn.size() < kLamps) drawn.push_back(entry.first);
  }
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const SceneLamp& lamp = lamps->lamps[drawn[k]];
    const LampPolygon polygon = lampPolygon(lamp, to.eyeWorld());
    for (std::size_t i = 0; i < kCorners; ++i) numbers.corner[k * kCorners + i] = glm::vec4(polygon.corners[i], 0.0f);
    const int shape = polygon.count + (polygon.bothSides ? 16 : 0);
    numbers.middle[k] = glm::vec4(shading::lampMiddle(&polygon), static_cast<float>(shape));
    numbers.plane[k] = shading::lampPlane(&polygon);
    numbers.light[k] = glm::vec4(glm::vec3(lamp.radiance), 0.0f);
    if (binding.lampLobes) numbers.glossy[k] = glm::vec4(lampReflected(state, binding, drawn[k]), 0.0f);
    numbers.of[k] = lampOf[drawn[k]];
    numbers.channel[k] = lampChannels(state.pass(), binding, drawn[k]);
  }
  if (binding.lampLobes) {
    const auto lampsEnd = numbers.glossy.begin() + static_cast<long>(drawn.size());
    const auto hue = [](const glm::vec4& l) { return glm::vec3(l) / std::max(l.x + l.y + l.z, 1.0e-30f); };
    const bool several = std::any_of(numbers.glossy.begin(), lampsEnd, [&](const glm::vec4& l) {
      return glm::length(hue(l) - hue(numbers.glossy[0])) > 1.0e-3f;
    });
    to.program->SetUniformf("bpLampColors", several ? 1.0f : 0.0f);
    to.program->SetUniformi("bpLobeCount", state.pass().capture ? 0 : static_cast<int>(drawn.size()));
  }
  to.program->SetUniformf("bpLampsWhole", state.pass().firstBounce ? 1.0f : 0.0f);
  to.program->SetUniformi("bpLampCount", static_cast<int>(drawn.size()));
  state.resources.lampBlock->upload(to.program, numbers);
}

// Of each slot its lattice of visibilities, and where those of light sources stand.
void uploadSights(const UniformUpload& to, DrawState& state, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  PerSlot<glm::vec3> at{}, low{}, perUnit{}, last{};
  PerSlot<int> parts{};
  PerSlot<glm::mat3> turn;
  turn.fill(glm::mat3(1.0f));
  const bool first = state.pass().firstBounce;
  // What comes anew may move what stands there: all come first, then each is asked for its place.
  for (std::size_t i = 0; i < count; ++i) state.resources.sights->place(sightOf(state.pass(), binding, i));
  for (std::size_t i = 0; i < count; ++i) {
    const auto& sight = sightOf(state.pass(), binding, i);
    const auto place = state.resources.sights->place(sight);
    if (!place) continue;
    const ProbeGeometry& g = binding.probes[i]->geometry;
    const shading::LatticeShape shape =
        first ? sight->lattice.shape(g.originWorld - sight->middleWorld) : sightShape(*sight, g);
    if (!first) turn[i] = glm::mat3(g.worldFromProbe);
    at[i] = *place;
    low[i] = shape.low;
    perUnit[i] = shape.perUnit;
    last[i] = shape.last;
    parts[i] = sight->lattice.parts();
  }
  const auto vectors = [&](const char* name, const PerSlot<glm::vec3>& values) {
    to.program->SetUniform3fv(name, static_cast<int>(count), reinterpret_cast<const float(*)[3]>(&values[0].x));
  };
  vectors("bpSightAt", at);
  vectors("bpSightLow", low);
  vectors("bpSightPerUnit", perUnit);
  vectors("bpSightLast", last);
  to.program->SetUniform1iv("bpSightParts", static_cast<int>(count), parts.data());
  to.program->SetUniformf("bpSightWhole", first ? 1.0f : 0.0f);
  for (std::size_t i = 0; i < count && binding.rotated(); ++i) {
    to.program->SetUniformMatrix3x3(("bpSightTurn[" + std::to_string(i) + "]").c_str(), &turn[i][0].x);
  }
  to.texture("bpSights", GL_TEXTURE_3D, state.resources.sights->handle());
  const glm::vec3 texel = state.resources.sights->texelSize();
  to.program->SetUniform3f("bpSightTexel", &texel.x);
  std::vector<glm::vec4> channels;
  for (const int light : binding.sightLights) {
    glm::vec4 of(static_cast<float>(kSeenByAll));
    for (std::size_t i = 0; i < count; ++i) {
      const auto& sight = sightOf(state.pass(), binding, i);
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

// Lights and the probes' coverage: shaders/gpu/coverage*.glsl.
void uploadCoverage(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding) {
  std::vector<glm::vec4> lights;
  for (const int light : binding.shadowLights) {
    const auto i = static_cast<std::size_t>(light);
    const bool known = i < state.resources.shadowLights.size();
    const ShadowLight of = known ? state.resources.shadowLights[i] : ShadowLight{};
    lights.emplace_back(of.size.tangent, of.size.radius, of.levelsPerUnit, 0.0f);
  }
  to.program->SetUniform4fv("bpShadowLight", static_cast<int>(lights.size()),
                            reinterpret_cast<const float(*)[4]>(&lights[0].x));
  std::array<int, ProbeBinding::kMaxProbesPerDraw> masks{};
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    const std::string slot = std::to_string(i);
    masks[i] = static_cast<int>(probe.shadowLights);
    // Before the first capture nothing is known of openings: nothing comes through.
    const ProbeMaps* maps = state.pass().firstBounce ? nullptr : probe.maps.get();
    if (maps != nullptr) maps->coverage.make(maps->radiance, maps->tint.get(), probe.imported);
    to.cube("bpThroughMap" + slot, maps != nullptr ? maps->coverage.handle() : state.resources.blackCube);
    to.program->SetUniformf(("bpThroughFaceSize" + slot).c_str(),
                            maps != nullptr ? static_cast<float>(maps->radiance.faceSize()) : 1.0f);
    const float maxLevel = maps != nullptr ? maps->coverage.chain()->maxLevel() : 0.0f;
    to.program->SetUniformf(("bpThroughPerUnit" + slot).c_str(),
                            levelsPerUnit(probe.geometry.boxMin, probe.geometry.boxMax, maxLevel));
  }
  to.program->SetUniform1iv("bpShadowMask", static_cast<int>(binding.probes.size()), masks.data());
}

// Maps of what moves and of what stands before suns: shaders/gpu/moving_shadow.glsl, sun_shadow.glsl. A sampler of its
// kind needs a texture of its own kind, read or not.
void uploadShadowMaps(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding) {
  const SceneResources& resources = state.resources;
  const GLuint any = !resources.movingShadows.empty() ? resources.movingShadows.front().texture
                     : !resources.sunShadows.empty()  ? resources.sunShadows.front().texture
                                                      : 0;
  for (const int light : binding.movingLights) {
    const auto map = std::find_if(resources.movingShadows.begin(), resources.movingShadows.end(),
                                  [&](const MovingShadow& shadow) { return shadow.light == light; });
    const bool on = map != resources.movingShadows.end() && state.pass().movingShadowsOn;
    const std::string n = std::to_string(light);
    to.program->SetUniformf(("bpMovingOn" + n).c_str(), on ? 1.0f : 0.0f);
    to.texture2d("bpMovingMap" + n, on ? map->texture : any);
    glm::mat4 matrix(1.0f);
    if (on) matrix = glm::mat4(glm::translate(map->mapFromWorld, to.eyeWorld()));
    to.program->SetUniformMatrix4x4(("bpMovingFromEye" + n).c_str(), &matrix[0][0]);
  }
  for (const SunUse& sun : binding.sunLights) {
    const SunShadow* map = sun.map < resources.sunShadows.size() ? &resources.sunShadows[sun.map] : nullptr;
    const bool on = map != nullptr && map->light == sun.light && map->texture != 0;
    const std::string n = std::to_string(sun.light);
    to.texture2d("bpSunMap" + n, on ? map->texture : any);
    glm::mat4 matrix(on ? glm::translate(map->mapFromWorld, to.eyeWorld()) : glm::dmat4(0.0));
    to.program->SetUniformMatrix4x4(("bpSunFromEye" + n).c_str(), &matrix[0][0]);
    const glm::vec3 taps = on ? glm::vec3(map->apart, map->off) : glm::vec3(0.0f);
    to.program->SetUniform3f(("bpSunTaps" + n).c_str(), &taps.x);
  }
}

// Captures go without, and so does everything until it is traced.
void uploadOpenness(const UniformUpload& to, const DrawState& state) {
  const SkyOpenness* open = state.pass().capture ? nullptr : state.resources.openness.get();
  OpennessTexture& texture = *state.resources.opennessTexture;
  to.texture("bpOpenMap", GL_TEXTURE_3D, texture.handle(open != nullptr ? state.resources.openness : nullptr));
  to.program->SetUniformf("bpOpenOn", open != nullptr ? 1.0f : 0.0f);
  const glm::vec3 low(open != nullptr ? open->low - 0.5 * open->spacing - to.eyeWorld() : glm::dvec3(0.0));
  const glm::vec3 scale(open != nullptr ? 1.0 / (open->spacing * glm::dvec3(open->nodes)) : glm::dvec3(1.0));
  to.program->SetUniform3f("bpOpenLow", &low.x);
  to.program->SetUniform3f("bpOpenScale", &scale.x);
  to.program->SetUniformf("bpOpenOff", open != nullptr ? static_cast<float>(open->off()) : 0.0f);
}

void uploadSurroundings(const UniformUpload& to, const SceneResources& resources, const ProbeBinding& binding,
                        bool flatMaps) {
  to.program->SetUniformMatrix3x3("bpViewToWorld", viewToWorldRotation(to.camera()).data());
  uploadSplitSum(to, resources);
  if (binding.sky || binding.open()) uploadSky(to, resources, flatMaps);
}

// The slots' maps and origins; the debug view's own maps, too.
void uploadSlots(const UniformUpload& to, DrawState& state, const ProbeBinding& binding, bool debug, bool flatMaps) {
  uploadLight(to, state, binding, flatMaps);
  if (debug) uploadDistances(to, state.resources, binding);
  if (binding.distances() && !binding.firstBounce) uploadRelief(to, state, binding);
  if (!binding.firstBounce) uploadSampling(to, state, binding);
  if (binding.shapes && (binding.diffuse || binding.lampLobes)) uploadLampsAndLattices(to, state, binding);
  if (binding.sights()) uploadSights(to, state, binding);
  uploadOrigins(to, binding);
}

}  // namespace

void uploadSplitSum(const UniformUpload& to, const SceneResources& resources) {
  to.texture2d("bpBrdf", resources.brdfTable);
}

void uploadOutput(const UniformUpload& to, const PassSettings& pass) {
  to.program->SetUniformf("bpExposure", pass.exposure);
  to.program->SetUniformf("bpParallel", to.camera()->GetParallelProjection() ? 1.0f : 0.0f);
}

void uploadLighting(const UniformUpload& to, DrawState& state, const ProbeBinding& binding, bool debug,
                    const Constants* constants, bool flatMaps) {
  ++state.counts.counters.uniformUpdates;
  uploadSurroundings(to, state.resources, binding, flatMaps);
  if (binding.sky && binding.openness) uploadOpenness(to, state);
  NumberUpload numbers(to, constants);
  readLighting(numbers, state, binding);
  if (!binding.probes.empty()) uploadSlots(to, state, binding, debug, flatMaps);
  if (!binding.shadowLights.empty()) uploadCoverage(to, state, binding);
  uploadShadowMaps(to, state, binding);
}

void uploadView(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding, int object) {
  const ShownDebugView& debug = state.pass().debug;
  to.program->SetUniformi("bpView", debug.view);
  to.program->SetUniformi("bpFinishShown", debug.finish ? 1 : 0);
  const float range[2] = {debug.low, debug.high};
  to.program->SetUniform2f("bpViewRange", range);
  if (state.resources.viewColors != 0) to.texture2d("bpViewColors", state.resources.viewColors);
  std::array<GLint, 4> viewport{0, 0, 1, 1};
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  const glm::vec2 perPixel = 1.0f / glm::vec2(viewport[2], viewport[3]);
  to.program->SetUniform2f("bpPerPixel", &perPixel.x);
  const auto& faces = faceColors();
  to.program->SetUniform3fv("bpFaceColors", 6, reinterpret_cast<const float(*)[3]>(&faces[0].x));
  to.program->SetUniformf("bpObject", static_cast<float>(object));
  if (binding.lighting != Lighting::Probes) {
    to.program->SetUniformMatrix3x3("bpViewToWorld", viewToWorldRotation(to.camera()).data());
    return;
  }
  const glm::vec3 sky = skyColor();
  to.program->SetUniform3f("bpSkyColor", &sky.x);
  std::array<glm::vec3, kMax> color;
  std::array<float, kMax> faceSize{};
  const std::size_t count = binding.probes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    color[i] = probeColor(probe.index);
    const bool known = probe.maps != nullptr && probe.maps->distance.allocated();
    faceSize[i] = known ? static_cast<float>(probe.maps->distance.faceSize()) : 0.0f;
  }
  if (count == 0) return;
  const int n = static_cast<int>(count);
  to.program->SetUniform3fv("bpProbeColor", n, reinterpret_cast<const float(*)[3]>(&color[0].x));
  to.program->SetUniform1fv("bpDistanceFaceSize", n, faceSize.data());
}

namespace {

void uploadFinish(const UniformUpload& to, const MaterialFinish& finish) {
  to.program->SetUniform3f("bpSpecularTint", &finish.specularTint.x);
  to.program->SetUniformf("bpSpecularEdge", finish.specularEdge);
  to.program->SetUniform3f("bpSheenColor", &finish.sheenColor.x);
  to.program->SetUniformf("bpSheenRoughness", finish.sheenRoughness);
  const float turn = finish.anisotropyRotation;
  const glm::vec3 anisotropy(std::cos(turn), std::sin(turn), finish.anisotropy);
  to.program->SetUniform3f("bpAnisotropy", &anisotropy.x);
  const glm::vec4 film(finish.iridescence, finish.filmIor, finish.filmThicknessMin, finish.filmThicknessMax);
  to.program->SetUniform4f("bpFilm", &film.x);
}

}  // namespace

void uploadListedLights(const UniformUpload& to, ListedLights& listed) {
  const ListedLights::Reaching reaching = listed.reaching(to.boundsWorld);
  const int range[2] = {reaching.from, reaching.count};
  to.texture2d("bpLightList", listed.texture());
  to.program->SetUniform2i("bpReaching", range);
  // Exact at great distances from the origin: subtracted in double.
  glm::mat4 viewFromList(1.0f);
  const std::array<float, 9> worldFromView = viewToWorldRotation(to.camera());
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row)
      viewFromList[column][row] = worldFromView[static_cast<std::size_t>(row * 3 + column)];
  }
  const glm::dvec3 center = glm::dmat3(glm::mat3(viewFromList)) * (listed.center() - to.eyeWorld());
  viewFromList[3] = glm::vec4(glm::vec3(center), 1.0f);
  to.program->SetUniformMatrix4x4("bpViewFromLightList", &viewFromList[0][0]);
}

void uploadMaterial(const UniformUpload& to, const SurfaceMaterial& surface) {
  to.program->SetUniformf("bpAlpha", surface.alpha);
  to.program->SetUniformf("bpAlphaCutoff", surface.alphaCutoff);
  to.program->SetUniformf("bpNormalScale", surface.normalScale);
  to.program->SetUniformf("bpCoatNormalScale", surface.coatNormalScale);
  if (surface.slots[kThicknessSlot].texture && to.used("bpThicknessScale")) {
    to.program->SetUniformf("bpThicknessScale", surface.thicknessScale);
  }
  if (surface.finished()) uploadFinish(to, surface.finish);
  for (std::size_t i = 0; i < surface.slots.size(); ++i) {
    const SurfaceSlot& slot = surface.slots[i];
    if (!slot.texture) continue;
    const std::string name = surfaceSlotNames()[i];
    // A slot that this variant does not read would only take a unit.
    if (!to.used("bpTex" + name)) continue;
    to.texture2d("bpTex" + name, slot.texture->handle());
    if (!to.used("bpUv" + name)) continue;
    const glm::mat3x2& m = slot.uvTransform;
    const float rows[2][3] = {{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}};
    to.program->SetUniform3fv(("bpUv" + name).c_str(), 2, rows);
  }
}

void uploadMirror(const UniformUpload& to, const MirrorPicture& mirror, const SceneResources& resources) {
  to.program->SetUniformf("bpMirrorOn", mirror.shown ? 1.0f : 0.0f);
  const GLuint none = resources.brdfTable;  // not read
  to.texture2d("bpMirrorColor", mirror.shown ? mirror.color : none);
  to.texture2d("bpMirrorHeight", mirror.shown ? mirror.height : none);
  const shading::MirrorLook& look = mirror.look;
  const std::array<glm::vec4, 3> places = {look.toU, look.toV, look.toW};
  to.program->SetUniform4fv("bpMirrorPlaces", 3, reinterpret_cast<const float(*)[4]>(&places[0].x));
  const glm::vec4 normal(look.normal, look.farHeight), eye(look.eye, look.texelSize);
  to.program->SetUniform4f("bpMirrorNormal", &normal.x);
  to.program->SetUniform4f("bpMirrorEye", &eye.x);
  const glm::vec3 levels(look.parallel, look.maxLevel, look.sharpLevel);
  to.program->SetUniform3f("bpMirrorLevels", &levels.x);
  const glm::vec2 size(look.sizeX, look.sizeY);
  to.program->SetUniform2f("bpMirrorSize", &size.x);
}

namespace {

// By the very matrix that the vertices are placed with.
void uploadBehind(const UniformUpload& to, const BehindPicture& behind, const SceneResources& resources) {
  if (!to.used("bpBehindOn")) return;
  const bool there = behind.color != 0;
  to.program->SetUniformf("bpBehindOn", there ? 1.0f : 0.0f);
  to.texture2d("bpBehindColor", there ? behind.color : resources.brdfTable);  // else not read
  to.texture2d("bpBehindDepth", there ? behind.depth : resources.brdfTable);
  vtkMatrix4x4 *clipFromWorld = nullptr, *viewFromWorld = nullptr, *clipFromView = nullptr;
  vtkMatrix3x3* normals = nullptr;
  vtkOpenGLCamera::SafeDownCast(to.camera())
      ->GetKeyMatrices(to.renderer, viewFromWorld, normals, clipFromView, clipFromWorld);
  to.program->SetUniformMatrix("bpBehindClip", clipFromView);
  const float size[2] = {static_cast<float>(behind.width), static_cast<float>(behind.height)};
  to.program->SetUniform2f("bpBehindSize", size);
}

}  // namespace

void uploadGlassOf(const UniformUpload& to, const GlassSurface& glass, const ProbeBinding& binding,
                   const SceneResources& resources, const BehindPicture& behind) {
  int faceSize = resources.sky ? resources.sky->radiance.faceSize() : 0;
  for (const auto& probe : binding.probes) {
    if (probe->maps) faceSize = std::max(faceSize, probe->maps->radiance.faceSize());
  }
  const bool followed = glass.shell && to.used("bpGlassShell");
  const int unit = followed ? to.bind(GL_TEXTURE_CUBE_MAP, glass.shell->handle()) : -1;
  uploadGlass(to.program, glass, to.eyeWorld(), faceSize, unit);
  uploadBehind(to, behind, resources);
}

}  // namespace boxprobe
