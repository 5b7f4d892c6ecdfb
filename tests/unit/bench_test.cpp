// The benchmark's parts that need no picture: which techniques it measures, rays towards lamps, kinds of noise, and how
// rows become summaries, a front and files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <random>

#include "filters/core/base/errors.h"
#include "filters/reference/bench/bench_noise.h"
#include "filters/reference/bench/bench_result.h"
#include "filters/reference/bench/bench_text.h"
#include "filters/reference/light/reference_box.h"
#include "filters/reference/study/bench_technique.h"
#include "tests/unit/error_text.h"

namespace boxprobe {
namespace {

using glm::dvec3;
using testing::HasSubstr;

TEST(BenchTechniques, EveryRowOfTheTablesIsMeasured) {
  const std::vector<BenchTechnique> all = allBenchTechniques();
  const auto measured = [&](const std::string& id) {
    return std::any_of(all.begin(), all.end(), [&](const BenchTechnique& t) { return t.id == id; });
  };
  for (const ProjectionRow& row : projectionRows()) EXPECT_TRUE(measured(std::string(row.id) + "+none")) << row.id;
  for (const EvaluationRow& row : evaluationRows())
    EXPECT_TRUE(measured(techniqueId(*parseTechnique(row.id)))) << row.id;
  for (const BenchTechnique& t : all) {
    EXPECT_TRUE(parseTechnique(t.id)) << t.id;
    EXPECT_EQ(std::count(all.begin(), all.end(), t), 1) << t.label();
  }
}

TEST(BenchTechniques, AListIsReadAndTheBaselinesAreAdded) {
  const auto chosen = chooseBenchTechniques("godot:power=2,footprint4");
  ASSERT_EQ(chosen.size(), 4u);
  EXPECT_EQ(chosen[0].label(), "godot power 2");
  EXPECT_FALSE(chosen[0].ours);
  EXPECT_EQ(chosen[1].id, "box+footprint4");
  EXPECT_TRUE(chosen[1].ours);
  EXPECT_EQ(chosen[2].id, kErrorBaseline);
  EXPECT_EQ(chosen[3].id, kCostBaseline);
  EXPECT_EQ(chooseBenchTechniques("godot:power=4")[0].label(), "godot") << "a default is no difference";
  EXPECT_THAT(errorText([] { chooseBenchTechniques("mirror"); }), HasSubstr("--techniques mirror: no such technique"));
  EXPECT_THAT(errorText([] { chooseBenchTechniques("godot:power=99"); }), HasSubstr("power must be a number from"));
  EXPECT_THAT(errorText([] { chooseBenchTechniques("impostor:steps=257"); }),
              HasSubstr("steps must be a whole number from 1 to 256"));
  EXPECT_THAT(errorText([] { chooseBenchTechniques("hdrp:power=2"); }), HasSubstr("is not a parameter of box+hdrp"));
  EXPECT_THAT(errorText([] { chooseBenchTechniques("godot:pover=2"); }), HasSubstr("did you mean \"power\""));
}

/// A dim cube with a small lamp on one face and another on an edge.
CubeMap cubeWithLamps() {
  CubeMap cube(64, 1);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < 64; ++row) {
      for (int column = 0; column < 64; ++column) {
        const bool lamp = (face == 2 && column >= 20 && column < 24 && row >= 30 && row < 33) ||
                          (face == 4 && column >= 61 && row >= 10 && row < 14);
        cube.setTexel(0, face, column, row, lamp ? glm::vec4(60, 50, 30, 1) : glm::vec4(0.3f, 0.4f, 0.2f, 1));
      }
    }
  }
  return cube;
}

TEST(BrightDirections, AreDrawnAsDenselyAsTheySay) {
  const CubeMap cube = cubeWithLamps();
  const BrightDirections bright(cube);
  ASSERT_GT(bright.groups(), 1u);
  // Densities over a fine grid sum to 1, and the share of samples that meet a lamp is that of the density there.
  constexpr int kGrid = 256;
  double whole = 0.0, lamps = 0.0;
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < kGrid; ++row) {
      for (int column = 0; column < kGrid; ++column) {
        const float s = (2.0f * static_cast<float>(column) + 1.0f) / kGrid - 1.0f;
        const float t = (2.0f * static_cast<float>(row) + 1.0f) / kGrid - 1.0f;
        const dvec3 direction(shading::cubeDirection(face, s, t));
        const double step = 2.0 / kGrid, s0 = s - 0.5 * step, t0 = t - 0.5 * step;
        const auto place = bright.at(3.0 * direction);
        if (!(place.density > 0.0)) continue;
        const double part = bright.share(place.group) * place.density * cubeSolidAngle(s0, t0, s0 + step, t0 + step);
        whole += part;
        if (bright.excess(dvec3(cube.fetch(glm::vec3(direction), 0.0f))) != dvec3(0.0)) lamps += part;
      }
    }
  }
  EXPECT_NEAR(whole, 1.0, 1e-3);
  const ShiftedPoints points(3);
  double met = 0.0;
  constexpr int kSamples = 4000;
  for (std::size_t g = 0; g < bright.groups(); ++g) {
    int here = 0;
    for (int i = 0; i < kSamples; ++i) {
      const dvec3 direction = bright.sample(g, points[i]);
      const auto place = bright.at(direction);
      EXPECT_EQ(place.group, g);
      EXPECT_GT(place.density, 0.0);
      here += bright.excess(dvec3(cube.fetch(glm::vec3(direction), 0.0f))) != dvec3(0.0) ? 1 : 0;
    }
    met += bright.share(g) * here / kSamples;
  }
  EXPECT_NEAR(met, lamps, 0.02);
  EXPECT_EQ(BrightDirections(CubeMap(64, 1)).groups(), 0u) << "nothing stands out in a black cube";
}

TEST(VisibleNormalLobe, KnowsHowDenselyItDrawsADirection) {
  for (const double alpha : {0.1, 0.4, 1.0}) {
    const dvec3 view = glm::normalize(dvec3(0.9, 0.1, 0.4));
    const VisibleNormalLobe lobe(dvec3(0, 0, 1), view, alpha);
    const ShiftedPoints points(7);
    constexpr int kSamples = 4000;
    int above = 0;
    for (int i = 0; i < kSamples; ++i) {
      const auto sample = lobe.sample(points[i]);
      if (sample.weight <= 0.0) continue;
      ++above;
      const auto at = lobe.at(sample.direction);
      ASSERT_NEAR(at.weight, sample.weight, 1e-9);
      ASSERT_NEAR(at.hDotV, sample.hDotV, 1e-9);
      ASSERT_GT(at.density, 0.0);
    }
    // Over the hemisphere the density sums to the share of directions that lie above the surface.
    double whole = 0.0;
    constexpr int kRings = 1500, kTurns = 720;
    for (int i = 0; i < kRings; ++i) {
      const double z = (i + 0.5) / kRings, r = std::sqrt(1.0 - z * z);
      for (int k = 0; k < kTurns; ++k) {
        const double phi = 2.0 * M_PI * (k + 0.5) / kTurns;
        whole += lobe.at(dvec3(r * std::cos(phi), r * std::sin(phi), z)).density * 2.0 * M_PI / kRings / kTurns;
      }
    }
    EXPECT_NEAR(whole, static_cast<double>(above) / kSamples, 5e-3) << alpha;
  }
}

// Rays towards the lamps change how fast the mean is found, not the mean.
TEST(BoxSurroundings, RaysTowardsLampsFindTheSameMean) {
  auto baked = std::make_shared<BakedMaps>();
  baked->radiance = cubeWithLamps();
  ReferenceBoxMaps plain, helped;
  plain.probes = helped.probes = {baked};
  helped.findBright();
  LitPoint pixel;
  pixel.hit = true;
  ProbeAtPoint probe;
  probe.weight = 1.0f;
  probe.boxMin = {-3.0f, -1.0f, -2.0f};
  probe.boxMax = {2.0f, 2.0f, 4.0f};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 12; ++trial) {
    const double alpha = trial % 3 == 0 ? 0.05 : trial % 3 == 1 ? 0.3 : 1.0;
    probe.positionProbe = {-2.5 + 4.0 * unit(random), -1.0, -1.5 + 5.0 * unit(random)};
    pixel.probes = {probe};
    const dvec3 view = glm::normalize(dvec3(unit(random) - 0.5, 0.05 + unit(random), unit(random) - 0.5));
    const VisibleNormalLobe lobe(dvec3(0, 1, 0), view, alpha);
    ReflectingLayer white;
    white.fresnel.f0 = glm::vec3(1.0f);
    const auto passes = [&](const ReferenceBoxMaps& maps, int rays, int count, double* standardError) {
      const BoxSurroundings around(pixel, maps);
      double sum = 0.0, squares = 0.0;
      for (int i = 0; i < count; ++i) {
        const auto seed = hashBits(static_cast<std::uint64_t>(1000 * trial + i));
        const double value = around.reflected(lobe, white, rays, seed).x;
        sum += value;
        squares += value * value;
      }
      const double mean = sum / count;
      *standardError = std::sqrt(std::max(squares / count - mean * mean, 0.0) / (count - 1));
      return mean;
    };
    double plainError = 0.0, helpedError = 0.0;
    const double expected = passes(plain, 4096, 32, &plainError), found = passes(helped, 256, 32, &helpedError);
    EXPECT_NEAR(found, expected, 4.0 * std::hypot(plainError, helpedError) + 2e-3 * expected) << trial;
    if (alpha == 1.0) {
      EXPECT_LT(helpedError, plainError) << "with a sixteenth of the rays";
    }
  }
}

TEST(NoiseFigures, TellGrainFromStains) {
  constexpr int kWidth = 200, kHeight = 120;
  std::mt19937 random(2);
  std::normal_distribution<float> gauss(0.0f, 0.1f);
  std::vector<float> white(kWidth * kHeight), stains(white.size()), checks(white.size());
  const std::vector<bool> mask(white.size(), true);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const auto at = static_cast<std::size_t>(y * kWidth + x);
      white[at] = gauss(random);
      stains[at] = std::sin(0.05f * static_cast<float>(x)) * std::cos(0.04f * static_cast<float>(y));
      checks[at] = (x + y) % 2 == 0 ? 0.1f : -0.1f;
    }
  }
  const NoiseFigures of = noiseFigures(white, mask, kWidth, kHeight);
  EXPECT_NEAR(of.lowFrequencyShare, M_PI / 64.0, 0.006);
  EXPECT_NEAR(of.errorAfterBlur, 0.1 / 3.0, 0.002);
  EXPECT_GT(noiseFigures(stains, mask, kWidth, kHeight).lowFrequencyShare, 0.97);
  EXPECT_LT(noiseFigures(checks, mask, kWidth, kHeight).lowFrequencyShare, 0.01);
}

TEST(MarkFront, LeavesOutWhatAnotherBeats) {
  std::vector<ParetoPoint> points = {{"a", "", 1.0, 0.5}, {"b", "", 2.0, 0.2}, {"c", "", 2.0, 0.3}, {"d", "", 3.0, 0.2},
                                     {"e", "", 9.0, 0.1}, {"f", "", 0.9, 0.6}, {"g", "", 0.9, 0.6}};
  markParetoFront(points);
  std::string front;
  for (const ParetoPoint& p : points) front += p.onParetoFront ? p.id : "";
  EXPECT_EQ(front, "abefg") << "equal points do not beat each other";
}

BenchResult smallResult() {
  BenchResult result;
  result.scene = "a \"scene\"";
  result.techniques = {{"box+none", {}, false}, {"box+hdrp", {}, false}, {"box+footprint4", {}, true}};
  result.cameras = {"main"};
  result.roughnesses = {0.25, 0.5};
  for (std::size_t t = 0; t < 3; ++t) {
    for (const double r : result.roughnesses) {
      BenchRow row;
      row.technique = t;
      row.camera = "main";
      row.roughness = r;
      row.pixels = r < 0.3 ? 100 : 300;
      row.error = 0.1 / static_cast<double>(t + 1) * (r < 0.3 ? 1.0 : 2.0);
      row.meanTruthSquare = 0.25;
      row.relativeRmse = row.error;
      result.rows.push_back(row);
      FrameCost cost{t, r, {}, {}};
      for (int i = 0; i < 5; ++i) {
        cost.cpuSeconds.a.push_back(0.1 * static_cast<double>(t + 1) + 0.001 * i);
        cost.cpuSeconds.b.push_back(0.1 + 0.001 * i);
      }
      result.costs.push_back(cost);
    }
    result.energy.push_back({t, Truth::Box, 0.25, 0.0, 0.25, 1.1, 500});
    result.energy.push_back({t, Truth::Box, 0.5, 0.0, 0.25, 0.7, 5});
  }
  return result;
}

TEST(Summaries, PutRowsTogetherByTheirPixels) {
  const auto list = summaries(smallResult(), Truth::Box);
  ASSERT_EQ(list.size(), 3u);
  EXPECT_NEAR(list[0].error, std::sqrt((100 * 0.01 + 300 * 0.04) / 400), 1e-12);
  EXPECT_NEAR(list[0].relativeRmse, list[0].error, 1e-12) << "relative errors are weighed by the truth's squares";
  EXPECT_NEAR(list[2].errorRatioToHdrp, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(list[1].cpuRatioToBox.value, 0.202 / 0.102, 1e-9);
  EXPECT_LE(list[1].cpuRatioToBox.low, list[1].cpuRatioToBox.value);
  EXPECT_GE(list[1].cpuRatioToBox.high, list[1].cpuRatioToBox.value);
  EXPECT_EQ(list[0].worstEnergy.brightnessRatio, 1.1) << "five pixels say nothing";
  EXPECT_TRUE(list[0].onParetoFront);
}

TEST(BenchText, IsJsonWithARowForEachAndATableForPeople) {
  const BenchResult result = smallResult();
  const nlohmann::json json = nlohmann::json::parse(benchJson(result));
  EXPECT_EQ(json["rows"].size(), 6u);
  EXPECT_EQ(json["rows"][4]["technique"], "box+footprint4");
  EXPECT_EQ(json["rows"][4]["reference"], "box");
  EXPECT_NEAR(json["rows"][4]["frameCpuRatioToBox"].get<double>(), 0.302 / 0.102, 1e-3);
  EXPECT_EQ(json["summary"].size(), 6u);
  const std::string csv = benchCsv(result);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
  EXPECT_THAT(benchReport(result), HasSubstr("| **footprint4 \\*** |"));
}

}  // namespace
}  // namespace boxprobe
