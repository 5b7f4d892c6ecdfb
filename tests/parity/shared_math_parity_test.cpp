// The same GLSL on the GPU and as C++: 131,072 random inputs for each projection of the table and each shared function.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "filters/math/cube/light_table.h"
#include "filters/math/cube/relief.h"
#include "filters/math/sampling/blue_noise.h"
#include "filters/math/sampling/brdf_table.h"
#include "filters/math/shared/shader_source.h"
#include "filters/math/shared/shared_math.h"
#include "filters/math/technique/technique_table.h"
#include "tests/support/gpu_window.h"

namespace {

using namespace boxprobe;
using glm::vec3;
using glm::vec4;

constexpr std::size_t kCount = 131072;

struct Inputs {
  std::vector<vec4> position, normal, reflection, boxMin, boxMax;
};

Inputs randomRays() {
  std::mt19937 random(20);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::normal_distribution<float> gauss;
  const auto direction = [&] { return glm::normalize(vec3(gauss(random), gauss(random), gauss(random))); };
  Inputs in;
  for (std::size_t i = 0; i < kCount; ++i) {
    const vec3 low(-10.0f * unit(random), -10.0f * unit(random), -10.0f * unit(random));
    const vec3 high(0.1f + 10.0f * unit(random), 0.1f + 10.0f * unit(random), 0.1f + 10.0f * unit(random));
    vec3 p = low + (high - low) * vec3(unit(random), unit(random), unit(random));
    if (i % 16 == 0) p.y = low.y;                             // on a face
    if (i % 17 == 0) p += 0.5f * (high - low) * direction();  // perhaps outside
    vec3 r = direction();
    if (i % 13 == 0) r = glm::normalize(vec3(0.0f, r.y, r.z));  // parallel to a pair of faces
    in.position.emplace_back(p, 0.0f);
    in.normal.emplace_back(direction(), 0.0f);
    in.reflection.emplace_back(r, 0.0f);
    in.boxMin.emplace_back(low, 0.0f);
    in.boxMax.emplace_back(high, 0.0f);
  }
  return in;
}

std::string sources(std::initializer_list<std::string_view> files) {
  std::string text;
  for (const auto file : files) text += std::string(shaderSource(file)) + "\n";
  return text;
}

// Distances that a probe might have seen, the same formula on both sides: smooth, so that only the projection is
// compared.
constexpr const char* kDistances =
    "vec3 fetchProbePlane(ProbeShape probe, vec3 d)\n{\n  vec3 u = d / max(length(d), 1e-30);\n"
    "  return u / (4.0 + 1.5 * u.x - 2.0 * u.y * u.z);\n}\n"
    "vec3 fetchProbeFar(ProbeShape probe, vec3 d)\n{\n  return reliefFar(d.x > 0.0 ? -2.0 : 5000000.0, d);\n}\n"
    "vec3 reliefFromProbe(ProbeShape probe, vec3 v) { return v; }\n"
    "float probeReliefSize(ProbeShape probe) { return 64.0; }\n"
    "vec4 fetchProbeRelief(ProbeShape probe, vec3 d, float level)\n{\n"
    "  return vec4(fetchProbePlane(probe, d) * (1.0 + 0.1 * level), 0.06 * level);\n}\n"
    "int probeBlockCount(ProbeShape probe) { return 1; }\n"
    "vec3 probeBlockLow(ProbeShape probe, int i) { return mix(probe.boxMin, probe.boxMax, 0.2); }\n"
    "vec3 probeBlockHigh(ProbeShape probe, int i) { return mix(probe.boxMin, probe.boxMax, 0.5); }\n";
struct SmoothRelief : shading::ReliefSampler {
  vec4 fetchRelief(const vec3& d, float level) const override {
    const vec3 u = d / std::max(glm::length(d), 1e-30f);
    const vec3 plane = u / (4.0f + 1.5f * u.x - 2.0f * u.y * u.z);
    if (level > 0.0f) return vec4(plane * (1.0f + 0.1f * level), 0.06f * level);
    return vec4(plane, d.x > 0.0f ? Relief::kHere : 5000000.0f);
  }
  float reliefSize() const override { return 64.0f; }
};

void expectSameHits(vtkOpenGLRenderWindow* window, const Inputs& in, const ProjectionRow& row, bool bevelled,
                    int steps = 3) {
  std::string shared;
  if (bevelled) shared += "#define BP_BEVEL\n" + sources({"shared/rounded_box.glsl"});
  if (row.distances) shared += sources({"shared/relief.glsl"}) + kDistances;
  for (const std::string_view file : row.sharedFiles) shared += sources({file});
  const auto gpu = test::evaluateOnGpu(
      window, sources({"shared/types.glsl", "shared/slab.glsl"}) + shared + sources({row.shaderFile}),
      "  ProbeShape probe; probe.boxMin = in3.xyz; probe.boxMax = in4.xyz; probe.maxLevel = 6.0; probe.projection = "
      "0; "
      "probe.slot = 0; probe.bevel = in0.w; probe.parameters.steps = " +
          std::to_string(steps) + ".0;\n  ProbeHit hit = " + std::string(row.function) +
          "(probe, in0.xyz, in1.xyz, in2.xyz);\n  out0 = vec4(hit.direction, hit.distance);\n  out1 = "
          "vec4(hit.slabFactors, float(hit.face));\n",
      {in.position, in.normal, in.reflection, in.boxMin, in.boxMax}, 2);
  const SmoothRelief relief;
  ReliefBlocks blocks;
  blocks.count = 1;
  shading::ProbeData data;
  data.relief = &relief;
  data.blocks = &blocks;
  std::size_t identical = 0, differentFace = 0, beyond = 0;
  float worst = 0.0f;
  for (std::size_t i = 0; i < kCount; ++i) {
    shading::ProbeShape probe{};
    probe.slot = &data;
    probe.bevel = bevelled ? in.position[i].w : 0.0f;
    probe.parameters.steps = static_cast<float>(steps);
    probe.boxMin = in.boxMin[i];
    probe.boxMax = in.boxMax[i];
    probe.maxLevel = 6.0f;
    blocks.low[0] = glm::mix(probe.boxMin, probe.boxMax, 0.2f);
    blocks.high[0] = glm::mix(probe.boxMin, probe.boxMax, 0.5f);
    const shading::ProbeHit hit = row.project(probe, in.position[i], in.normal[i], in.reflection[i]);
    const vec4 g = gpu[0][i];
    const vec3 size = probe.boxMax - probe.boxMin;
    const float scale = std::max({size.x, size.y, size.z});
    ASSERT_TRUE(std::isfinite(g.x) && std::isfinite(g.y) && std::isfinite(g.z) && std::isfinite(g.w)) << row.id << i;
    const float error = glm::length(vec3(g) - hit.direction) / scale;
    worst = std::max(worst, error);
    beyond += error > 1e-4f;
    identical += g.w == hit.distance && vec3(g) == hit.direction;
    differentFace += static_cast<int>(gpu[1][i].w) != hit.face;
  }
  std::printf("  %-8s%s%s identical %zu of %zu, worst difference %.2g box sizes, %zu beyond 1e-4, other face %zu\n",
              std::string(row.id).c_str(), bevelled ? " bevelled" : "", steps > 3 ? " marching" : "", identical, kCount,
              static_cast<double>(worst), beyond, differentFace);
  if (row.distances) {
    // It chooses its steps by comparisons, which rounding may decide.
    EXPECT_LE(beyond, kCount / 20000) << row.id;
  } else {
    // The sphere's root cancels near its surface; everything else is the same to the last bits.
    EXPECT_LE(worst, row.id == "sphere" ? 3e-6f : 4e-7f) << row.id;
  }
  EXPECT_LE(differentFace, kCount / 10000) << row.id << ": only rays through an edge may disagree";
}

TEST(Parity, EveryProjectionGivesTheSameHit) {
  const auto window = test::makeWindow();
  Inputs in = randomRays();
  for (const ProjectionRow& row : projectionRows()) {
    expectSameHits(window, in, row, false);
    if (row.distances) expectSameHits(window, in, row, false, 16);
  }
  for (std::size_t i = 0; i < kCount; ++i) in.position[i].w = 0.001f * static_cast<float>(i % 1500);
  expectSameHits(window, in, projectionRows()[static_cast<std::size_t>(parseTechnique("box")->projection)], true);
}

// What a technique looks up, on both sides: fetches return their direction and level.
struct EchoMap : shading::CubeSampler {
  vec4 fetch(const vec3& direction, float level) const override {
    return vec4(direction / std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z), 1e-37f}),
                level);
  }
};

// Where evaluateOnGpu draws an input.
glm::ivec2 pixelOf(std::size_t i) {
  return {static_cast<int>(i % 512), static_cast<int>(i / 512)};
}

// A light table that sends draws from cell to cell but is equally dense everywhere: on the border of two cells the
// sides may disagree which one per ray meets.
LightTable evenLight() {
  LightTable table;
  table.faceSize = 4;
  for (std::size_t i = 0; i < 96; ++i) {
    table.cells.emplace_back(static_cast<float>(i % 8) / 8.0f, static_cast<float>((i * 37 + 11) % 96), 1.0f / 24.0f,
                             0.0f);
  }
  return table;
}

std::string lightSources(const LightTable& light) {
  std::string cells;
  for (const vec4& cell : light.cells) {
    char text[96];
    std::snprintf(text, sizeof text, "%svec4(%.9g, %.9g, %.9g, 0.0)", cells.empty() ? "" : ", ",
                  static_cast<double>(cell.x), static_cast<double>(cell.y), static_cast<double>(cell.z));
    cells += text;
  }
  return "const vec4 lightCells[96] = vec4[96](" + cells +
         ");\nint probeLightSize(ProbeShape probe) { return 4; }\nvec4 fetchProbeLight(ProbeShape probe, int cell) { "
         "return "
         "lightCells[clamp(cell, 0, 95)]; }\nvec3 mapFromProbe(ProbeShape probe, vec3 d) { return d; }\nvec3 "
         "probeFromMap(ProbeShape "
         "probe, "
         "vec3 d) { return d; }\n";
}

// Defaults, and each choice of an evaluation in turn; few samples, which show as much and take less time.
std::vector<shading::TechniqueParameters> everyChoice(const EvaluationRow& row) {
  shading::TechniqueParameters standard = standardParameters();
  standard.samples = 12.0f;
  std::vector<shading::TechniqueParameters> result = {standard};
  for (const std::string_view name : row.parameters) {
    const ParameterRow& parameter = *findParameter(name);
    if (parameter.choice == nullptr) continue;
    const int count = parameter.kind == ParameterKind::Switch ? 2 : static_cast<int>(parameter.choices.size());
    for (int i = 0; i < count; ++i) {
      if (i == standard.*parameter.choice) continue;
      result.push_back(standard);
      result.back().*parameter.choice = i;
    }
  }
  if (std::find(row.parameters.begin(), row.parameters.end(), "samples") != row.parameters.end()) {
    result.push_back(standard);
    result.back().samples = 3.0f;
    // Some rays of a mean of frames.
    result.push_back(standard);
    result.back().filtered = 1;
    result.back().total = 48.0f;
  }
  return result;
}

std::string assignments(const shading::TechniqueParameters& values) {
  std::string text;
  for (const ParameterRow& row : parameterRows()) {
    const std::string field = "  probe.parameters." + std::string(row.name) + " = ";
    if (row.choice != nullptr) text += field + std::to_string(values.*row.choice) + ";\n";
    if (row.number != nullptr) text += field + std::to_string(values.*row.number) + ";\n";
  }
  return text;
}

std::string choicesText(const EvaluationRow& row, const shading::TechniqueParameters& values) {
  std::string text;
  for (const std::string_view name : row.parameters) {
    const ParameterRow& parameter = *findParameter(name);
    if (parameter.choice != nullptr) text += std::string(name) + " " + std::to_string(values.*parameter.choice) + " ";
  }
  return text;
}

TEST(Parity, EveryEvaluationLooksUpTheSame) {
  const auto window = test::makeWindow();
  const Inputs in = randomRays();
  std::vector<vec4> view = in.normal, other = in.normal, table = in.normal;
  std::mt19937 random(22), reflectances(23);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  for (std::size_t i = 0; i < kCount; ++i) {
    // V = reflect(-R, N), so that R = reflect(-V, N); roughness and parameters beside it.
    const vec3 n(in.normal[i]), r(in.reflection[i]);
    view[i] = vec4(2.0f * glm::dot(n, r) * n - r, unit(random));
    other[i] = vec4(0.1f + 10.0f * unit(random), 1.0f + 5.0f * unit(random), blueNoiseAt(pixelOf(i)));
    const shading::ShadingPoint point{vec3(0.0f), n, vec3(view[i]), r, view[i].w, {}, 0, 0.0f, 1.0f};
    const glm::vec2 split = splitSum(shading::footprintLobe(point, 1.0f).view.z, point.roughness);
    table[i] = vec4(split, unit(reflectances) < 0.3f ? 1.0f : 0.99f * unit(reflectances) + 0.01f, 0.0f);
  }
  const ProjectionRow& box = projectionRows()[static_cast<std::size_t>(parseTechnique("box")->projection)];
  const EchoMap map;
  const LightTable light = evenLight();
  shading::ProbeData data;
  data.light = &light;
  for (const EvaluationRow& row : evaluationRows()) {
    if (row.function.empty()) continue;  // chosen on the host
    std::string shared;
    for (const std::string_view file : row.sharedFiles) shared += sources({file});
    for (const auto& parameters : everyChoice(row)) {
      std::vector<vec4> splitSums = table;
      if (parameters.total > parameters.samples) {
        // Rays of a mean are drawn from a narrower lobe, and the table is asked for that one.
        for (std::size_t i = 0; i < kCount; ++i) {
          const shading::ShadingPoint point{
              vec3(0.0f), vec3(in.normal[i]), vec3(view[i]), vec3(in.reflection[i]), view[i].w, {}, 0, 0.0f, 1.0f};
          const float narrowed = view[i].w * std::max(1.0f - 0.56f / parameters.total, 0.775f);
          const glm::vec2 split = splitSum(shading::footprintLobe(point, 1.0f).view.z, narrowed);
          splitSums[i].x = split.x;
          splitSums[i].y = split.y;
        }
      }
      const auto gpu = test::evaluateOnGpu(
          window,
          sources({"shared/types.glsl", "shared/slab.glsl", "shared/roughness.glsl", box.shaderFile}) +
              "ProbeHit projectRay(ProbeShape probe, vec3 p, vec3 n, vec3 r) { return " + std::string(box.function) +
              "(probe, p, n, r); }\n#define PROBE_MAP int\nvec4 fetchProbe(int map, ProbeShape probe, vec3 d, float "
              "level) { return vec4(d / max(max(abs(d.x), abs(d.y)), max(abs(d.z), 1e-37)), level); }\n"
              "vec2 mask;\nvec2 fetchBlueNoise(ivec2 pixel) { return mask; }\n"
              "vec2 table;\nvec2 splitSumAt(float cosine, float roughness) { return table; }\n" +
              lightSources(light) + sources({"shared/level_curve.glsl"}) + shared + sources({row.shaderFile}),
          "  ProbeShape probe; probe.boxMin = in3.xyz; probe.boxMax = in4.xyz; probe.maxLevel = 6.0; probe.slot = "
          "0;\n" +
              assignments(parameters) +
              "  probe.parameters.hardeningLength = in6.x; probe.parameters.power = in6.y; mask = in6.zw; table = "
              "in7.xy;\n"
              "  ShadingPoint point; point.position = in0.xyz; point.normal = in1.xyz; point.view = in5.xyz; "
              "point.reflection = in2.xyz; point.roughness = in5.w; point.pixel = ivec2(gl_FragCoord.xy); "
              "point.frame = 3; point.fresnel = 0.09 * in6.x; point.f0 = in7.z;\n  out0 = " +
              std::string(row.function) + "(0, probe, point);\n",
          {in.position, in.normal, in.reflection, in.boxMin, in.boxMax, view, other, splitSums}, 1);
      double worst = 0.0;
      std::size_t otherWall = 0;
      for (std::size_t i = 0; i < kCount; ++i) {
        shading::ProbeShape probe{};
        probe.boxMin = in.boxMin[i];
        probe.boxMax = in.boxMax[i];
        probe.maxLevel = 6.0f;
        probe.projection = parseTechnique("box")->projection;
        probe.slot = &data;
        probe.parameters = parameters;
        probe.parameters.hardeningLength = other[i].x;
        probe.parameters.power = other[i].y;
        const shading::ShadingPoint point{in.position[i], in.normal[i], view[i], in.reflection[i],
                                          view[i].w,      pixelOf(i),   3,       0.09f * other[i].x,
                                          table[i].z};
        const vec4 cpu = row.evaluate(&map, probe, point);
        const vec4 d = glm::abs(gpu[0][i] - cpu);
        const double error = std::max({d.x, d.y, d.z, d.w});
        // A ray at an edge of the box meets one wall here and the other there, from which it is as likely as not when
        // it was aimed; of a ray that is blurred little the two walls' levels differ, and its direction does not.
        const bool sameDirection = std::max({d.x, d.y, d.z}) <= 2.0e-4f;
        const bool few = parameters.sampling == 1 || (parameters.total > parameters.samples && sameDirection);
        if (few && error > 2.0e-4 && ++otherWall <= kCount / 10000) continue;
        if (!(error <= worst)) worst = error;
      }
      std::printf("  %-12s %s: worst difference %.2g\n", std::string(row.id).c_str(),
                  choicesText(row, parameters).c_str(), worst);
      // Levels go through logarithms and powers, which a GPU has to a few digits.
      EXPECT_LE(worst, 2.0e-4) << row.id << choicesText(row, parameters);
    }
  }
}

TEST(Parity, LevelsWeightsAndLobes) {
  const auto window = test::makeWindow();
  std::mt19937 random(21);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<vec4> a, b;
  for (std::size_t i = 0; i < kCount; ++i) {
    a.emplace_back(unit(random), unit(random), unit(random), 1.0f + std::floor(8.0f * unit(random)));
    b.emplace_back(2.0f * unit(random) - 1.0f, 2.0f * unit(random) - 1.0f, 2.0f * unit(random) - 1.0f, unit(random));
  }
  const auto gpu = test::evaluateOnGpu(
      window,
      sources(
          {"shared/roughness.glsl", "shared/weights.glsl", "shared/ggx.glsl", "shared/sky.glsl", "shared/cube.glsl"}),
      "  out0 = vec4(levelForRoughness(in0.x, in0.w), roughnessForLevel(in0.y * in0.w, in0.w),"
      " influenceWeight(in1.xyz, vec3(-0.7), vec3(0.8), in0.xyz, vec3(9.0)), ggxMasking(in0.z, in0.x));\n"
      "  out1 = vec4(ggxHalfVector(in0.xy, in0.z), ggxDistribution(normalize(in1.xyz), in0.x + 0.01));\n"
      "  out2 = vec4(skyGradient(in1.xyz, vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)), 0.0);\n"
      "  out3 = vec4(cubeDirection(int(in0.w) - 1, in1.x, in1.y), 0.0);\n",
      {a, b}, 4);
  double worst[8] = {};
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto note = [&](int what, float x, float y) {
      worst[what] =
          std::max(worst[what], std::abs(static_cast<double>(x) - y) / std::max(1.0, std::abs(static_cast<double>(y))));
    };
    note(0, gpu[0][i].x, shading::levelForRoughness(a[i].x, a[i].w));
    note(1, gpu[0][i].y, shading::roughnessForLevel(a[i].y * a[i].w, a[i].w));
    note(2, gpu[0][i].z, shading::influenceWeight(vec3(b[i]), vec3(-0.7f), vec3(0.8f), vec3(a[i]), vec3(9.0f)));
    note(3, gpu[0][i].w, shading::ggxMasking(a[i].z, a[i].x));
    const vec3 half = shading::ggxHalfVector(glm::vec2(a[i].x, a[i].y), a[i].z);
    note(4, glm::length(vec3(gpu[1][i]) - half), 0.0f);
    note(5, gpu[1][i].w, shading::ggxDistribution(glm::normalize(vec3(b[i])), a[i].x + 0.01f));
    const vec3 sky = shading::skyGradient(vec3(b[i]), vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1));
    note(6, glm::length(vec3(gpu[2][i]) - sky), 0.0f);
    const vec3 cube = shading::cubeDirection(static_cast<int>(a[i].w) - 1, b[i].x, b[i].y);
    note(7, glm::length(vec3(gpu[3][i]) - cube), 0.0f);
  }
  const char* names[8] = {"level",        "roughness", "influence weight", "masking", "half vector",
                          "distribution", "sky",       "cube direction"};
  // Transcendental functions are only a few digits exact on a GPU; arithmetic is exact to rounding.
  const double bounds[8] = {2e-5, 2e-5, 2e-6, 2e-6, 5e-5, 2e-5, 2e-6, 0.0};
  for (int i = 0; i < 8; ++i) {
    std::printf("  %-17s worst difference %.2g\n", names[i], worst[i]);
    EXPECT_LE(worst[i], bounds[i]) << names[i];
  }
}

}  // namespace
