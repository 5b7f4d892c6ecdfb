#include "filters/vtk/surface/draw_numbers.h"

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

void add(NumberReader& to, const char* name, std::size_t count, const SlotValues<float>& values) {
  to.read(name, 1, values.data(), count);
}

void add(NumberReader& to, const char* name, std::size_t count, const SlotValues<glm::vec3>& values) {
  to.read(name, 3, &values[0].x, count);
}

void addSky(NumberReader& to, const SceneResources& resources) {
  const auto& sky = resources.sky;
  to.read("bpSkyMaxLevel", sky ? sky->maxLevel() : 0.0f);
  to.read("bpSkyIntensity", sky ? 1.0f : 0.0f);
  ShCoefficients sh{};
  if (sky) sh = sky->irradiance;
  to.read("bpSkySh", 3, &sh[0].x, 9);
}

// Each slot's levels, and its diffuse light as spherical harmonics.
void addLight(NumberReader& to, const DrawState& state, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  SlotValues<float> intensity{}, maxLevel{};
  std::array<glm::vec3, 9 * kMostSlots> sh{};
  for (std::size_t i = 0; i < count; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    // Without maps: no reflection, and the sky's diffuse light as the best guess.
    const ProbeMaps* maps = state.pass().firstBounce ? nullptr : probe.maps.get();
    const ProbeMaps* diffuse = maps != nullptr ? maps : state.resources.sky.get();
    intensity[i] = probe.geometry.intensity;
    maxLevel[i] = maps != nullptr ? maps->maxLevel() : 0.0f;
    if (diffuse != nullptr) {
      std::copy(diffuse->irradiance.begin(), diffuse->irradiance.end(), sh.begin() + static_cast<long>(9 * i));
    }
    // Not in a capture without the sky.
    if (maps != nullptr && probe.open && state.resources.sky) {
      for (std::size_t k = 0; k < 9; ++k) sh[9 * i + k] += probe.openSky[k];
    }
  }
  add(to, "bpIntensity", count, intensity);
  add(to, "bpMaxLevel", count, maxLevel);
  to.read("bpSh", 3, &sh[0].x, 9 * count);
}

void addBoxes(NumberReader& to, const ProbeBinding& binding) {
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
  to.read("bpWorldFromProbe", 9, &worldFromProbe[0][0].x, count);
  to.read("bpMapFromProbe", 9, &mapFromProbe[0][0].x, count);
}

// What only some bindings have: parameters of techniques, bevelled boxes, occlusion, shares in place of weights.
void addChoices(NumberReader& to, const ProbeBinding& binding) {
  const std::size_t count = binding.probes.size();
  for (const ParameterRow* row : binding.parameters()) {
    if (row->number == nullptr) continue;
    SlotValues<float> values{};
    for (std::size_t i = 0; i < count; ++i) values[i] = binding.values(i).*row->number;
    add(to, parameterUniform(*row).c_str(), count, values);
  }
  if (binding.bevelled()) {
    SlotValues<glm::vec2> bevel{};
    for (std::size_t i = 0; i < count; ++i) {
      const ProbeGeometry& g = binding.probes[i]->geometry;
      bevel[i] = glm::vec2(g.bevelRadius, g.bevelFromRoughness);
    }
    to.read("bpBevel", 2, &bevel[0].x, count);
  }
  if (binding.occluded()) {
    SlotValues<glm::vec3> occlusion{};
    for (std::size_t i = 0; i < count; ++i) occlusion[i] = binding.probes[i]->geometry.occlusion;
    add(to, "bpOcclusion", count, occlusion);
  }
  if (binding.weights && !binding.shares.empty()) {
    to.read("bpShare", 1, binding.shares.data(), count);
    to.read("bpSkyShare", binding.skyShare);
  }
}

glm::vec3 floats(const double* v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

}  // namespace

void readLighting(NumberReader& to, const DrawState& state, const ProbeBinding& binding) {
  if (binding.lighting != Lighting::Probes) return;
  if (binding.sky || binding.open()) addSky(to, state.resources);
  if (binding.probes.empty()) return;
  addLight(to, state, binding);
  addBoxes(to, binding);
  addChoices(to, binding);
}

void readMaterial(NumberReader& to, const SurfaceMaterial& surface, vtkProperty* property) {
  const auto number = [&to](const char* name, double value) { to.read(name, static_cast<float>(value)); };
  number("bpAlpha", surface.alpha);
  number("bpAlphaCutoff", surface.alphaCutoff);
  number("opacityUniform", property->GetOpacity());
  to.read("emissiveFactorUniform", floats(property->GetEmissiveFactor()));
  // Vertices and edges have colours of their own in the same uniforms.
  if (property->GetVertexVisibility() == 0 && property->GetEdgeVisibility() == 0) {
    number("ambientIntensity", property->GetAmbient());
    number("diffuseIntensity", property->GetDiffuse());
    to.read("ambientColorUniform", floats(property->GetAmbientColor()));
    to.read("diffuseColorUniform", floats(property->GetDiffuseColor()));
  }
  if (surface.unlit) return;
  number("roughnessUniform", property->GetRoughness());
  number("metallicUniform", property->GetMetallic());
  number("aoStrengthUniform", property->GetOcclusionStrength());
  number("baseF0Uniform", property->ComputeReflectanceOfBaseLayer());
  to.read("edgeTintUniform", floats(property->GetEdgeTint()));
  number("bpNormalScale", surface.normalScale);
  if (property->GetCoatStrength() > 0.0) {
    number("coatStrengthUniform", property->GetCoatStrength());
    number("coatRoughnessUniform", property->GetCoatRoughness());
    number("bpCoatNormalScale", surface.coatNormalScale);
  }
}

void NumberUpload::read(const char* name, int components, const float* values, std::size_t count) {
  if (constants_ != nullptr && constants_->find(name) != nullptr) return;
  const int n = static_cast<int>(count);
  vtkShaderProgram* program = to_.program;
  if (components == 1) program->SetUniform1fv(name, n, values);
  if (components == 2) program->SetUniform2fv(name, n, reinterpret_cast<const float(*)[2]>(values));
  if (components == 3) program->SetUniform3fv(name, n, reinterpret_cast<const float(*)[3]>(values));
  if (components != 9 || !to_.used(name)) return;
  // VTK sets one matrix per call; array elements except the first have separate names. Follows the variant, because
  // rotations may have become 0 since the program was made.
  for (std::size_t i = 0; i < count; ++i) {
    const std::string element = i == 0 ? name : std::string(name) + "[" + std::to_string(i) + "]";
    program->SetUniformMatrix3x3(element.c_str(), const_cast<float*>(values + 9 * i));
  }
}

}  // namespace boxprobe
