// Lamps as polygons and the lattice's light on the GPU and as C++: the same light of random quadrilaterals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <random>

#include "filters/io/engines/technique_text.h"
#include "filters/math/cube/diffuse_lattice.h"
#include "filters/math/shared/lamp_math.h"
#include "filters/math/shared/shader_source.h"
#include "tests/support/gpu_window.h"

namespace {

using namespace boxprobe;
using glm::vec2;
using glm::vec3;
using glm::vec4;

constexpr std::size_t kLampCount = 32768;

constexpr const char* kLamp =
    "vec3 gCorners[4];\n"
    "int lampCornerCount(int lamp) { return 4; }\n"
    "vec3 lampCorner(int lamp, int i) { return gCorners[i]; }\n"
    "vec3 lampMiddle(int lamp) { return 0.25 * (gCorners[0] + gCorners[1] + gCorners[2] + gCorners[3]); }\n"
    "vec4 lampPlane(int lamp) { return lampPlaneThrough(gCorners[0], gCorners[1], gCorners[2]); }\n"
    "bool lampShinesBothSides(int lamp) { return true; }\n";

std::string text(std::initializer_list<std::string_view> files) {
  std::string all;
  for (const std::string_view file : files) all += std::string(shaderSource(file)) + "\n";
  return all;
}

TEST(LampParity, LampsShineTheSame) {
  const auto window = test::makeWindow();
  std::mt19937 random(41);
  std::normal_distribution<float> gauss;
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  const auto direction = [&] { return glm::normalize(vec3(gauss(random), gauss(random), gauss(random))); };
  std::vector<std::vector<vec4>> in(6);
  for (std::size_t i = 0; i < kLampCount; ++i) {
    const vec3 n = direction();
    vec3 v = direction();
    if (glm::dot(n, v) < 0.0f && i % 16 != 0) v = -v;
    const vec3 middle = (0.5f + 3.0f * unit(random)) * direction(), u = (0.05f + unit(random)) * direction();
    const vec3 w = (0.05f + unit(random)) * glm::normalize(glm::cross(u, direction()));
    in[0].emplace_back(n, 0.1f + 0.9f * unit(random));  // roughness
    in[1].emplace_back(v, 0.0f);
    in[2].emplace_back(middle - u - w, 0.0f);
    in[3].emplace_back(middle + u - w, 0.0f);
    in[4].emplace_back(middle + u + w, 0.0f);
    in[5].emplace_back(middle - u + w, 0.0f);
  }
  const auto gpu = test::evaluateOnGpu(
      window,
      text({"shared/lamp_types.glsl", "shared/lobe_frame.glsl", "shared/lamp_plane.glsl"}) + kLamp +
          text({"shared/lamp.glsl", "shared/lamp_lobe.glsl"}),
      "  gCorners[0] = in2.xyz; gCorners[1] = in3.xyz; gCorners[2] = in4.xyz; gCorners[3] = in5.xyz;\n"
      "  vec2 glossy = lampGlossy(0, vec3(0.0), lampLobe(in0.xyz, in1.xyz, in0.w));\n"
      "  out0 = vec4(lampDiffuse(0, vec3(0.0), in0.xyz), glossy, 0.0);\n",
      in, 1);
  float worst[2] = {};
  std::size_t beyond = 0, lit = 0;
  for (std::size_t i = 0; i < kLampCount; ++i) {
    LampPolygon lamp;
    lamp.count = 4;
    lamp.bothSides = true;
    for (std::size_t k = 0; k < 4; ++k) lamp.corners[k] = vec3(in[2 + k][i]);
    const vec3 n(in[0][i]);
    const float diffuse = shading::lampDiffuse(&lamp, vec3(0.0f), n);
    const vec2 glossy = shading::lampGlossy(&lamp, vec3(0.0f), shading::lampLobe(n, vec3(in[1][i]), in[0][i].w));
    const vec4 g = gpu[0][i];
    ASSERT_TRUE(std::isfinite(g.x) && std::isfinite(g.y) && std::isfinite(g.z)) << i;
    const float off = std::max(std::abs(g.y - glossy.x), std::abs(g.z - glossy.y));
    worst[0] = std::max(worst[0], std::abs(g.x - diffuse));
    // Which part of an edge is longer, rounding may decide.
    if (off > 1.0e-3f) {
      ++beyond;
    } else {
      worst[1] = std::max(worst[1], off);
    }
    lit += diffuse > 0.0f ? 1 : 0;
  }
  std::printf("  diffuse: worst difference %.2g; glossy: %.2g, %zu of %zu beyond 1e-3; %zu lit\n",
              static_cast<double>(worst[0]), static_cast<double>(worst[1]), beyond, kLampCount, lit);
  EXPECT_LT(worst[0], 1.0e-4f);
  EXPECT_LE(beyond, kLampCount / 1000);
  EXPECT_GT(lit, kLampCount / 4);
}

// Flat views, from below too; lamps that touch the surface, lie in its plane, hold its point as a corner, or fill all
// that it sees; roughness at and beyond both ends. What both sides agree on there is a number, and a share of the
// light.
TEST(LampParity, ExtremeLampsGiveAShareOfTheirLight) {
  const auto window = test::makeWindow();
  std::mt19937 random(47);
  std::normal_distribution<float> gauss;
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  const auto pick = [&](std::initializer_list<float> values) {
    return *(values.begin() + std::uniform_int_distribution<int>(0, static_cast<int>(values.size()) - 1)(random));
  };
  std::vector<std::vector<vec4>> in(6);
  for (std::size_t i = 0; i < kLampCount; ++i) {
    const vec3 n = glm::normalize(vec3(gauss(random), gauss(random), gauss(random)));
    const vec3 t = glm::normalize(glm::cross(n, vec3(gauss(random), gauss(random), gauss(random))));
    const vec3 b = glm::cross(n, t);
    const float facing = pick({-0.3f, 0.0f, 1.0e-7f, 1.0e-5f, 1.0e-3f, 0.02f, 1.0f});
    const vec3 v = glm::normalize(std::sqrt(1.0f - facing * facing) * t + facing * n);
    const float height = pick({-1.0e-4f, 0.0f, 1.0e-6f, 1.0e-3f, 0.1f, 1.0f}),
                size = pick({1.0e-4f, 0.1f, 3.0f, 1.0e4f});
    const vec3 across = i % 2 == 0 ? b : n;  // over the surface, or standing on it
    const vec3 corner = i % 5 == 0 ? vec3(0.0f) : height * n + (unit(random) - 0.7f) * size * t - 0.4f * size * across;
    in[0].emplace_back(n, pick({0.0f, 0.02f, 0.1f, 0.15f, 0.4f, 1.0f, 1.5f}));
    in[1].emplace_back(v, 0.0f);
    in[2].emplace_back(corner, 0.0f);
    in[3].emplace_back(corner + size * t, 0.0f);
    in[4].emplace_back(corner + size * (t + across), 0.0f);
    in[5].emplace_back(corner + size * across, 0.0f);
  }
  const auto gpu = test::evaluateOnGpu(
      window,
      text({"shared/lamp_types.glsl", "shared/lobe_frame.glsl", "shared/lamp_plane.glsl"}) + kLamp +
          text({"shared/lamp.glsl", "shared/lamp_lobe.glsl"}),
      "  gCorners[0] = in2.xyz; gCorners[1] = in3.xyz; gCorners[2] = in4.xyz; gCorners[3] = in5.xyz;\n"
      "  out0 = vec4(lampGlossy(0, vec3(0.0), lampLobe(in0.xyz, in1.xyz, in0.w)), 0.0, 0.0);\n",
      in, 1);
  std::size_t apart = 0, lit = 0;
  for (std::size_t i = 0; i < kLampCount; ++i) {
    LampPolygon lamp;
    lamp.count = 4;
    lamp.bothSides = true;
    for (std::size_t k = 0; k < 4; ++k) lamp.corners[k] = vec3(in[2 + k][i]);
    const vec2 cpu =
        shading::lampGlossy(&lamp, vec3(0.0f), shading::lampLobe(vec3(in[0][i]), vec3(in[1][i]), in[0][i].w));
    for (const vec2& found : {cpu, vec2(gpu[0][i])}) {
      ASSERT_TRUE(std::isfinite(found.x) && std::isfinite(found.y)) << i;
      ASSERT_GE(std::min(found.x, found.y), 0.0f) << i;
      ASSERT_LE(found.x + found.y, 1.01f) << i;
    }
    apart += glm::length(vec2(gpu[0][i]) - cpu) > 0.02f ? 1 : 0;
    lit += cpu.x + cpu.y > 1.0e-3f ? 1 : 0;
  }
  std::printf("  %zu of %zu more than 0.02 apart, %zu lit\n", apart, kLampCount, lit);
  EXPECT_LE(apart, kLampCount / 100);
  EXPECT_GT(lit, kLampCount / 10);
}

// The same formula on both sides, linear in the place as a texture is between its texels.
struct Ramp : shading::LatticeSampler {
  glm::vec4 fetchLattice(const vec3& place, int part) const override {
    const auto p = static_cast<float>(part);
    const float cut = 0.9f - 0.15f * (p - 7.0f);
    if (part >= 7) return cut * vec4(1.0f, 0.3f + 0.02f * place.x, 0.6f - 0.01f * place.z, 0.0f);
    return vec4(0.3f + 0.1f * place.x, 0.2f - 0.05f * place.y * p, 0.01f * place.z + 0.02f * p, 0.1f * p);
  }
};
constexpr const char* kRamp =
    "vec4 fetchLattice(int slot, vec3 place, int part)\n{\n  float p = float(part);\n"
    "  float cut = 0.9 - 0.15 * (p - 7.0);\n"
    "  if (part >= 7) { return cut * vec4(1.0, 0.3 + 0.02 * place.x, 0.6 - 0.01 * place.z, 0.0); }\n"
    "  return vec4(0.3 + 0.1 * place.x, 0.2 - 0.05 * place.y * p, 0.01 * place.z + 0.02 * p, 0.1 * p);\n}\n";

TEST(LampParity, LatticesShineTheSame) {
  const auto window = test::makeWindow();
  std::mt19937 random(43);
  std::normal_distribution<float> gauss;
  std::vector<vec4> position, normal;
  for (std::size_t i = 0; i < kLampCount; ++i) {
    position.emplace_back(3.0f * gauss(random), 2.0f * gauss(random), 4.0f * gauss(random), i % 2 == 0 ? 1.0f : 0.0f);
    normal.emplace_back(glm::normalize(vec3(gauss(random), gauss(random), gauss(random))), 0.0f);
  }
  const auto gpu = test::evaluateOnGpu(
      window, text({"shared/lattice_types.glsl", "shared/sh.glsl"}) + kRamp + text({"shared/lattice.glsl"}),
      "  LatticeShape lattice; lattice.low = vec3(-2.0, -1.0, -3.0); lattice.perUnit = vec3(1.1, 0.9, 0.8);\n"
      "  lattice.last = vec3(4.0, 2.0, 5.0); lattice.slot = 0; lattice.cut = in0.w;\n"
      "  out0 = vec4(latticeIrradiance(lattice, in0.xyz, in1.yzx, in1.xyz), 0.0);\n",
      {position, normal}, 1);
  const Ramp ramp;
  shading::LatticeShape lattice{};
  lattice.low = vec3(-2.0f, -1.0f, -3.0f);
  lattice.perUnit = vec3(1.1f, 0.9f, 0.8f);
  lattice.last = vec3(4.0f, 2.0f, 5.0f);
  lattice.slot = &ramp;
  float worst = 0.0f;
  for (std::size_t i = 0; i < kLampCount; ++i) {
    lattice.cut = position[i].w;
    const vec3 n(normal[i]), cpu = shading::latticeIrradiance(lattice, vec3(position[i]), vec3(n.y, n.z, n.x), n);
    worst = std::max(worst, glm::length(vec3(gpu[0][i]) - cpu));
  }
  std::printf("  worst difference %.2g\n", static_cast<double>(worst));
  EXPECT_LT(worst, 1.0e-5f);
}

// The text that other programs get, against the integral over the lamps' area.
TEST(LampParity, ExportedLampsGiveTheLightOfTheirArea) {
  const auto window = test::makeWindow();
  std::vector<SceneLamp> lamps(2);
  lamps[0].corners = {{1.2, 2.3, -0.6}, {2.1, 2.3, -0.4}, {1.9, 2.3, 0.7}, {1.1, 2.3, 0.5}};
  lamps[0].radiance = {7.0, 4.0, 2.0};
  lamps[1].corners = {{-1.7, 0.4, 0.9}, {-1.5, 1.3, 0.2}, {-1.6, 0.6, -0.5}};
  lamps[1].radiance = {0.5, 3.0, 6.0};
  lamps[1].bothSides = true;
  Probe probe;
  probe.name = "p";
  const std::string code = techniqueText({probe}, "box", ShaderLanguage::Glsl, "test", lamps);
  std::mt19937 random(23);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  std::vector<std::vector<vec4>> in(2);
  for (int i = 0; i < 512; ++i) {
    in[0].emplace_back(2.5f * any(random), 0.8f * any(random), 1.7f * any(random), 0.0f);
    in[1].emplace_back(glm::normalize(vec3(any(random), any(random), any(random))), 0.0f);
  }
  const auto gpu = test::evaluateOnGpu(
      window, code,
      "  vec3 sum = vec3(0.0);\n"
      "  for (int i = 0; i < kBoxprobeLamps; ++i) { sum += boxprobeLampDiffuse(boxprobeLamp(i), in0.xyz, in1.xyz); }\n"
      "  out0 = vec4(sum, 0.0);\n",
      in, 1);
  double nearest = 0.0;
  const auto lightAt = [&](const glm::dvec3& at, const glm::dvec3& n) {
    glm::dvec3 sum(0.0);
    nearest = 1.0e9;
    for (const SceneLamp& lamp : lamps) {
      for (std::size_t t = 1; t + 1 < lamp.corners.size(); ++t) {
        const glm::dvec3 u = lamp.corners[t] - lamp.corners[0], w = lamp.corners[t + 1] - lamp.corners[0];
        const glm::dvec3 area = glm::cross(u, w);  // twice the triangle's
        constexpr int kSteps = 300;
        for (int k = 0; k < kSteps * kSteps; ++k) {
          double a = (k % kSteps + 0.5) / kSteps, b = (k / kSteps + 0.5) / kSteps;
          if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
          const glm::dvec3 way = lamp.corners[0] + a * u + b * w - at;
          const double d2 = glm::dot(way, way);
          nearest = std::min(nearest, std::sqrt(d2));
          double facing = -glm::dot(way, area);
          if (lamp.bothSides) facing = std::abs(facing);
          const double cosine = glm::dot(way, n);
          if (facing <= 0.0 || cosine <= 0.0) continue;
          sum += 0.5 / (kSteps * kSteps) * cosine * facing / (d2 * d2 * 3.14159265358979) * lamp.radiance;
        }
      }
    }
    return sum;
  };
  double worst = 0.0, most = 0.0;
  for (std::size_t i = 0; i < in[0].size(); i += 4) {
    const glm::dvec3 truth = lightAt(glm::dvec3(vec3(in[0][i])), glm::dvec3(vec3(in[1][i])));
    if (nearest < 0.2) continue;  // too coarse an integral
    for (int c = 0; c < 3; ++c) {
      worst = std::max(worst, std::abs(static_cast<double>(gpu[0][i][c]) - truth[c]));
      most = std::max(most, truth[c]);
    }
  }
  std::printf("  worst %.6f of light up to %.3f\n", worst, most);
  EXPECT_LT(worst, 2.0e-3 * most);
  EXPECT_GT(most, 0.3);
}

// The number in a texel's colour: of node (x, y, z), z counted on through the parts.
float texelOf(int x, int y, int z, int color, int partAt) {
  const int k = (7 * x + 13 * y + 29 * z + 5 * color) % 17;
  if (partAt < DiffuseLattice::kParts) return static_cast<float>(k) / 17.0f;
  const float cut = static_cast<float>((7 * x + 13 * y + 29 * z) % 17) / 17.0f;
  return color == 0 ? cut : color == 1 ? 0.3f * cut : color == 2 ? 0.6f * cut : 0.0f;
}

// A lattice looked up by the exported text is the one that is drawn here, with and without ways that are cut.
TEST(LampParity, ExportedLatticesAreLookedUpTheSame) {
  const auto window = test::makeWindow();
  const vec3 low(-1.2f, -0.4f, -0.9f), high(0.7f, 1.3f, 1.6f);
  const glm::ivec3 n(3, 4, 5);
  Probe probe;
  probe.name = "p";
  std::string code = techniqueText({probe}, "box", ShaderLanguage::Glsl, "test");
  // The texture is a formula here, blended by hand.
  const std::string sampled = "textureLod(nodes, ";
  const std::size_t at = code.find(sampled);
  ASSERT_NE(at, std::string::npos);
  code.replace(at, sampled.size(), "formula(");
  code =
      "float colorOf(ivec3 p, int color)\n{\n"
      "  int k = (7 * p.x + 13 * p.y + 29 * p.z + 5 * color) % 17;\n"
      "  if (p.z < 35) { return float(k) / 17.0; }\n"
      "  float cut = float((7 * p.x + 13 * p.y + 29 * p.z) % 17) / 17.0;\n"
      "  return color == 0 ? cut : color == 1 ? 0.3 * cut : color == 2 ? 0.6 * cut : 0.0;\n}\n"
      "int gParts;\n"
      "vec4 formula(vec3 uv, float level)\n{\n"
      "  ivec3 size = ivec3(3, 4, 5 * gParts);\n"
      "  vec3 texel = uv * vec3(size) - 0.5, t = texel - floor(texel);\n  vec4 sum = vec4(0.0);\n"
      "  for (int i = 0; i < 8; ++i)\n  {\n    ivec3 step = ivec3(i & 1, i >> 1 & 1, i >> 2);\n"
      "    vec3 w = mix(1.0 - t, t, vec3(step));\n"
      "    ivec3 p = clamp(ivec3(floor(texel)) + step, ivec3(0), size - 1);\n"
      "    sum += w.x * w.y * w.z * vec4(colorOf(p, 0), colorOf(p, 1), colorOf(p, 2), colorOf(p, 3));\n  }\n"
      "  return sum;\n}\nuniform sampler3D unbound;\n" +
      code;
  DiffuseLattice lattice;
  lattice.nodes = n;
  lattice.low = low;
  lattice.high = high;
  for (int part = 0; part < DiffuseLattice::kParts + DiffuseLattice::kCutParts; ++part) {
    for (int node = 0; node < n.x * n.y * n.z; ++node) {
      const int x = node % n.x, y = node / n.x % n.y, z = node / (n.x * n.y) + n.z * part;
      vec4 texel;
      for (int c = 0; c < 4; ++c) texel[c] = texelOf(x, y, z, c, part);
      (part < DiffuseLattice::kParts ? lattice.texels : lattice.cuts).push_back(texel);
    }
  }
  std::mt19937 random(31);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  std::vector<std::vector<vec4>> in(2);
  for (int i = 0; i < 512; ++i) {
    in[0].emplace_back(1.5f * any(random), 1.3f * any(random), 1.9f * any(random), 0.0f);
    in[1].emplace_back(glm::normalize(vec3(any(random), any(random), any(random))), 0.0f);
  }
  for (const bool cuts : {true, false}) {
    const std::string parts = cuts ? "10" : "7", is = cuts ? "true" : "false";
    const auto gpu =
        test::evaluateOnGpu(window, code,
                            "  gParts = " + parts +
                                ";\n  out0 = vec4(boxprobeLattice(unbound, boxprobe_p(), vec3(3.0, 4.0, 5.0), "
                                "vec3(-1.2, -0.4, -0.9), vec3(0.7, 1.3, 1.6), " +
                                is + ", in0.xyz, in1.xyz), 0.0);\n",
                            in, 1);
    if (!cuts) lattice.cuts.clear();
    float worst = 0.0f, most = 0.0f;
    for (std::size_t i = 0; i < in[0].size(); ++i) {
      const vec3 normal(in[1][i]);
      const vec3 here = shading::latticeIrradiance(lattice.shape(), vec3(in[0][i]), normal, normal);
      for (int c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(gpu[0][i][c] - here[c]));
        most = std::max(most, here[c]);
      }
    }
    std::printf("  %s cut ways: worst %.6f of light up to %.3f\n", cuts ? "with" : "without",
                static_cast<double>(worst), static_cast<double>(most));
    EXPECT_LT(worst, 1.0e-4f * most);
    EXPECT_GT(most, 0.5f);
  }
}

}  // namespace
