#include "filters/vtk/surface/probe_uniforms.h"

#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "filters/vtk/draw/static_textures.h"
#include "filters/vtk/surface/camera_uniforms.h"
#include "filters/vtk/surface/probe_source.h"

namespace boxprobe {

namespace {

constexpr std::size_t kMax = ProbeBinding::kMaxProbesPerDraw;

template <typename T>
using PerSlot = std::array<T, kMax>;

void upload(const UniformUpload& to, const char* name, std::size_t count, const PerSlot<glm::vec3>& values) {
  to.program->SetUniform3fv(name, static_cast<int>(count), reinterpret_cast<const float(*)[3]>(&values[0].x));
}

// VTK sets one matrix a call; array elements have names of their own, but for the first.
void upload(const UniformUpload& to, const std::string& name, std::size_t count, PerSlot<glm::mat3>& values) {
  for (std::size_t i = 0; i < count; ++i) {
    to.program->SetUniformMatrix3x3((i == 0 ? name : name + "[" + std::to_string(i) + "]").c_str(), &values[i][0].x);
  }
}

// During the first bounce no probe has been captured yet.
const ProbeMaps* mapsOf(const DrawState& state, const DrawnProbe& probe) {
  return state.pass().firstBounce ? nullptr : probe.maps.get();
}

void uploadSky(const UniformUpload& to, const SceneResources& resources) {
  const auto& sky = resources.sky;
  to.cube("bpSkyMap", sky ? sky->radiance.handle() : resources.blackCube);
  to.program->SetUniformf("bpSkyMaxLevel", sky ? sky->maxLevel() : 0.0f);
  to.program->SetUniformf("bpSkyIntensity", sky ? 1.0f : 0.0f);
  ShCoefficients skySh{};
  if (sky) skySh = sky->irradiance;
  to.program->SetUniform3fv("bpSkySh", 9, reinterpret_cast<const float(*)[3]>(&skySh[0].x));
}

// The captured light of each slot: its map, and its diffuse light as spherical harmonics.
void uploadLight(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  PerSlot<float> intensity{}, maxLevel{};
  std::array<glm::vec3, 9 * kMax> sh{};
  for (std::size_t i = 0; i < count; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    // Without maps: no reflection, and the sky's diffuse light, which is the best guess there is.
    const ProbeMaps* maps = mapsOf(state, probe);
    const ProbeMaps* diffuse = maps != nullptr ? maps : state.resources.sky.get();
    intensity[i] = probe.geometry.intensity;
    maxLevel[i] = maps != nullptr ? maps->maxLevel() : 0.0f;
    if (diffuse != nullptr) {
      std::copy(diffuse->irradiance.begin(), diffuse->irradiance.end(), sh.begin() + static_cast<long>(9 * i));
    }
    // Not in a capture that goes without the sky.
    if (maps != nullptr && probe.open && state.resources.sky) {
      for (std::size_t k = 0; k < 9; ++k) sh[9 * i + k] += probe.openSky[k];
    }
    to.cube("bpMap" + std::to_string(i), maps != nullptr ? maps->radiance.handle() : state.resources.blackCube);
  }
  const int n = static_cast<int>(count);
  to.program->SetUniform1fv("bpIntensity", n, intensity.data());
  to.program->SetUniform1fv("bpMaxLevel", n, maxLevel.data());
  to.program->SetUniform3fv("bpSh", 9 * n, reinterpret_cast<const float(*)[3]>(&sh[0].x));
}

void uploadDistances(const UniformUpload& to, const SceneResources& resources, const ProbeBinding& binding) {
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const ProbeMaps* maps = binding.probes[i]->maps.get();
    const bool known = maps != nullptr && maps->distance.allocated();
    to.cube("bpDistanceMap" + std::to_string(i), known ? maps->distance.handle() : resources.blackCube);
  }
}

void uploadRelief(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding) {
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

void uploadBoxes(const UniformUpload& to, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  PerSlot<glm::vec3> origin, boxMin, boxMax, influenceMin, influenceMax, rateMin, rateMax;
  PerSlot<glm::mat3> worldFromProbe{}, mapFromProbe{};
  const glm::dvec3 eye = to.eyeWorld();
  for (std::size_t i = 0; i < count; ++i) {
    const ProbeGeometry& g = binding.probes[i]->geometry;
    origin[i] = glm::vec3(g.originWorld - eye);
    boxMin[i] = g.boxMin;
    boxMax[i] = g.boxMax;
    influenceMin[i] = g.influenceMin;
    influenceMax[i] = g.influenceMax;
    rateMin[i] = g.rateMin;
    rateMax[i] = g.rateMax;
    worldFromProbe[i] = glm::mat3(g.worldFromProbe);
    mapFromProbe[i] = glm::mat3(g.mapFromProbe);
  }
  upload(to, "bpOrigin", count, origin);
  upload(to, "bpBoxMin", count, boxMin);
  upload(to, "bpBoxMax", count, boxMax);
  upload(to, "bpInfluenceMin", count, influenceMin);
  upload(to, "bpInfluenceMax", count, influenceMax);
  upload(to, "bpRateMin", count, rateMin);
  upload(to, "bpRateMax", count, rateMax);
  // As the program was made: what a box is turned by, or against its maps, may have come to 0 since.
  if (to.used("bpWorldFromProbe")) {
    upload(to, "bpWorldFromProbe", count, worldFromProbe);
    upload(to, "bpMapFromProbe", count, mapFromProbe);
  }
}

// What not every binding has: parameters of its techniques, bevelled boxes, occlusion, shares in place of weights.
void uploadChoices(const UniformUpload& to, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  const int n = static_cast<int>(count);
  for (const ParameterRow* row : binding.parameters()) {
    if (row->number == nullptr) continue;
    PerSlot<float> values{};
    for (std::size_t i = 0; i < count; ++i) values[i] = binding.probes[i]->geometry.parameters.*row->number;
    to.program->SetUniform1fv(parameterUniform(*row).c_str(), n, values.data());
  }
  if (binding.bevelled()) {
    PerSlot<glm::vec2> bevel{};
    for (std::size_t i = 0; i < count; ++i) {
      const ProbeGeometry& g = binding.probes[i]->geometry;
      bevel[i] = glm::vec2(g.bevelRadius, g.bevelFromRoughness);
    }
    to.program->SetUniform2fv("bpBevel", n, reinterpret_cast<const float(*)[2]>(&bevel[0].x));
  }
  if (binding.occluded()) {
    PerSlot<glm::vec3> occlusion{};
    for (std::size_t i = 0; i < count; ++i) occlusion[i] = binding.probes[i]->geometry.occlusion;
    upload(to, "bpOcclusion", count, occlusion);
  }
  if (binding.weights && !binding.shares.empty()) {
    to.program->SetUniform1fv("bpShare", n, binding.shares.data());
    to.program->SetUniformf("bpSkyShare", binding.skyShare);
  }
}

}  // namespace

void uploadSplitSum(const UniformUpload& to, const SceneResources& resources) {
  to.texture2d("bpBrdf", resources.brdfTable);
}

void uploadSurroundings(const UniformUpload& to, const SceneResources& resources, const ProbeBinding& binding) {
  to.program->SetUniformMatrix3x3("bpViewToWorld", viewToWorldRotation(to.camera()).data());
  uploadSplitSum(to, resources);
  if (binding.sky || binding.open()) uploadSky(to, resources);
}

void uploadSlots(const UniformUpload& to, DrawState& state, const ProbeBinding& binding, bool debug) {
  uploadLight(to, state, binding);
  if (debug) uploadDistances(to, state.resources, binding);
  if (binding.distances()) uploadRelief(to, state, binding);
  uploadSampling(to, state, binding);
  uploadBoxes(to, binding);
  uploadChoices(to, binding);
}

}  // namespace boxprobe
