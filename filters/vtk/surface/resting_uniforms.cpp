#include "filters/vtk/surface/resting_uniforms.h"

#include <vtkProperty.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <glm/mat3x3.hpp>

#include "filters/vtk/surface/probe_source.h"

namespace boxprobe {

namespace {

constexpr std::size_t kMostSlots = ProbeBinding::kMaxProbesPerDraw;

template <typename T>
using SlotValues = std::array<T, kMostSlots>;

void add(RestingValues& to, const char* name, std::size_t count, const SlotValues<float>& values) {
  to.add(name, 1, values.data(), count);
}

void add(RestingValues& to, const char* name, std::size_t count, const SlotValues<glm::vec3>& values) {
  to.add(name, 3, &values[0].x, count);
}

void addSky(RestingValues& to, const SceneResources& resources) {
  const auto& sky = resources.sky;
  to.add("bpSkyMaxLevel", sky ? sky->maxLevel() : 0.0f);
  to.add("bpSkyIntensity", sky ? 1.0f : 0.0f);
  ShCoefficients sh{};
  if (sky) sh = sky->irradiance;
  to.add("bpSkySh", 3, &sh[0].x, 9);
}

// The captured light of each slot: its levels, and its diffuse light as spherical harmonics.
void addLight(RestingValues& to, const DrawState& state, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  SlotValues<float> intensity{}, maxLevel{};
  std::array<glm::vec3, 9 * kMostSlots> sh{};
  for (std::size_t i = 0; i < count; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    // Without maps: no reflection, and the sky's diffuse light, which is the best guess there is.
    const ProbeMaps* maps = state.pass().firstBounce ? nullptr : probe.maps.get();
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
  }
  add(to, "bpIntensity", count, intensity);
  add(to, "bpMaxLevel", count, maxLevel);
  to.add("bpSh", 3, &sh[0].x, 9 * count);
}

void addBoxes(RestingValues& to, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  SlotValues<glm::vec3> boxMin, boxMax, influenceMin, influenceMax, rateMin, rateMax;
  SlotValues<glm::mat3> worldFromProbe{}, mapFromProbe{};
  for (std::size_t i = 0; i < count; ++i) {
    const ProbeGeometry& g = binding.probes[i]->geometry;
    boxMin[i] = g.boxMin;
    boxMax[i] = g.boxMax;
    influenceMin[i] = g.influenceMin;
    influenceMax[i] = g.influenceMax;
    rateMin[i] = g.rateMin;
    rateMax[i] = g.rateMax;
    worldFromProbe[i] = glm::mat3(g.worldFromProbe);
    mapFromProbe[i] = glm::mat3(g.mapFromProbe);
  }
  add(to, "bpBoxMin", count, boxMin);
  add(to, "bpBoxMax", count, boxMax);
  add(to, "bpInfluenceMin", count, influenceMin);
  add(to, "bpInfluenceMax", count, influenceMax);
  add(to, "bpRateMin", count, rateMin);
  add(to, "bpRateMax", count, rateMax);
  to.add("bpWorldFromProbe", 9, &worldFromProbe[0][0].x, count);
  to.add("bpMapFromProbe", 9, &mapFromProbe[0][0].x, count);
}

// What not every binding has: parameters of its techniques, bevelled boxes, occlusion, shares in place of weights.
void addChoices(RestingValues& to, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  for (const ParameterRow* row : binding.parameters()) {
    if (row->number == nullptr) continue;
    SlotValues<float> values{};
    for (std::size_t i = 0; i < count; ++i) values[i] = binding.probes[i]->geometry.parameters.*row->number;
    add(to, parameterUniform(*row).c_str(), count, values);
  }
  if (binding.bevelled()) {
    SlotValues<glm::vec2> bevel{};
    for (std::size_t i = 0; i < count; ++i) {
      const ProbeGeometry& g = binding.probes[i]->geometry;
      bevel[i] = glm::vec2(g.bevelRadius, g.bevelFromRoughness);
    }
    to.add("bpBevel", 2, &bevel[0].x, count);
  }
  if (binding.occluded()) {
    SlotValues<glm::vec3> occlusion{};
    for (std::size_t i = 0; i < count; ++i) occlusion[i] = binding.probes[i]->geometry.occlusion;
    add(to, "bpOcclusion", count, occlusion);
  }
  if (binding.weights && !binding.shares.empty()) {
    to.add("bpShare", 1, binding.shares.data(), count);
    to.add("bpSkyShare", binding.skyShare);
  }
}

glm::vec3 floats(const double* v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

// VTK sets one matrix a call; array elements have names of their own, but for the first. As the program was made: what
// a box is turned by, or against its maps, may have come to 0 since.
void uploadMatrices(const UniformUpload& to, const RestingValue& value) {
  if (!to.used(value.name)) return;
  std::vector<float> numbers = value.values;
  for (std::size_t i = 0; i < numbers.size() / 9; ++i) {
    const std::string name = i == 0 ? value.name : value.name + "[" + std::to_string(i) + "]";
    to.program->SetUniformMatrix3x3(name.c_str(), &numbers[9 * i]);
  }
}

}  // namespace

RestingValues lightingValues(const DrawState& state, const ProbeBinding& binding) {
  RestingValues values;
  if (binding.lighting != Lighting::Probes) return values;
  values.reserve(24);
  if (binding.sky || binding.open()) addSky(values, state.resources);
  if (binding.probes.empty()) return values;
  addLight(values, state, binding);
  addBoxes(values, binding);
  addChoices(values, binding);
  return values;
}

RestingValues materialValues(const SurfaceMaterial& surface, vtkProperty* property) {
  RestingValues values;
  values.reserve(16);
  const auto number = [&values](const char* name, double value) { values.add(name, static_cast<float>(value)); };
  number("bpAlpha", surface.alpha);
  number("bpAlphaCutoff", surface.alphaCutoff);
  number("opacityUniform", property->GetOpacity());
  values.add("emissiveFactorUniform", floats(property->GetEmissiveFactor()));
  // Vertices and edges are drawn in colours of their own by the same names.
  if (property->GetVertexVisibility() == 0 && property->GetEdgeVisibility() == 0) {
    number("ambientIntensity", property->GetAmbient());
    number("diffuseIntensity", property->GetDiffuse());
    values.add("ambientColorUniform", floats(property->GetAmbientColor()));
    values.add("diffuseColorUniform", floats(property->GetDiffuseColor()));
  }
  if (surface.unlit) return values;
  number("roughnessUniform", property->GetRoughness());
  number("metallicUniform", property->GetMetallic());
  number("aoStrengthUniform", property->GetOcclusionStrength());
  number("baseF0Uniform", property->ComputeReflectanceOfBaseLayer());
  values.add("edgeTintUniform", floats(property->GetEdgeTint()));
  number("bpNormalScale", surface.normalScale);
  if (property->GetCoatStrength() > 0.0) {
    number("coatStrengthUniform", property->GetCoatStrength());
    number("coatRoughnessUniform", property->GetCoatRoughness());
    number("bpCoatNormalScale", surface.coatNormalScale);
  }
  return values;
}

void uploadResting(const UniformUpload& to, const RestingValues& values, const RestingValues* constants) {
  for (const RestingValue& value : values.all()) {
    if (constants != nullptr && constants->find(value.name) != nullptr) continue;
    const int count = static_cast<int>(value.values.size()) / value.components;
    const char* name = value.name.c_str();
    const float* numbers = value.values.data();
    if (value.components == 1) to.program->SetUniform1fv(name, count, numbers);
    if (value.components == 2) to.program->SetUniform2fv(name, count, reinterpret_cast<const float(*)[2]>(numbers));
    if (value.components == 3) to.program->SetUniform3fv(name, count, reinterpret_cast<const float(*)[3]>(numbers));
    if (value.components == 9) uploadMatrices(to, value);
  }
}

}  // namespace boxprobe
