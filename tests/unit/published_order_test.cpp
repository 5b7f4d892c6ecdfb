// The published techniques and the ray-traced form in rooms that are boxes, against the integral of the lobe: how far
// each is off, over HDRP's error, which is the order that users of those techniques know them by. The integral is a
// plain evaluation in double precision that shares nothing with the shader files.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "filters/math/technique_table.h"
#include "tests/unit/box_room.h"

namespace boxprobe {
namespace {

constexpr int kFaceSize = 128;
constexpr int kPointsEach = 40;

struct Form {
  const char* id;
  float samples = 64.0f;
  int levelOffset = 0, filtered = 0;
  std::string name() const {
    return std::string(id) + (levelOffset != 0 ? " levelOffset" : "") + (filtered != 0 ? " filtered" : "");
  }
};

shading::ProbeShape shapeOf(const test::BoxRoom& room, const CubeMap& chain, const Form& form) {
  shading::ProbeShape probe{};
  probe.boxMin = glm::vec3(room.low);
  probe.boxMax = glm::vec3(room.high);
  probe.maxLevel = chain.maxLevel();
  probe.projection = parseTechnique(form.id)->projection;
  probe.parameters = standardParameters();
  probe.parameters.samples = form.samples;
  probe.parameters.levelOffset = form.levelOffset;
  probe.parameters.filtered = form.filtered;
  return probe;
}

glm::dvec3 valueOf(const Form& form, const shading::ProbeShape& probe, const CubeMap& chain,
                   const shading::ShadingPoint& point) {
  const auto evaluation = static_cast<std::size_t>(parseTechnique(form.id)->evaluation);
  return glm::dvec3(evaluationRows()[evaluation].evaluate(&chain, probe, point));
}

TEST(PublishedTechniques, StandInTheOrderTheyAreKnownBy) {
  const std::vector<Form> forms = {{"infinite"},
                                   {"sphere"},
                                   {"approximate"},
                                   {"box"},
                                   {"godot"},
                                   {"hdrp"},
                                   {"raytraced"},
                                   {"raytraced", 64.0f, 1, 0},
                                   {"raytraced", 64.0f, 0, 1}};
  const std::vector<test::BoxRoom> rooms = {{{-3.0, -1.2, -2.2}, {2.6, 1.9, 3.4}, 5.0, 0.10, 25.0},
                                            {{-1.8, -1.5, -3.6}, {4.4, 1.3, 1.6}, 7.0, 0.16, 12.0}};
  std::mt19937 random(23);
  std::map<std::string, test::ErrorTally> tallies;
  for (const test::BoxRoom& room : rooms) {
    const CubeMap chain = test::prefilteredRoom(room, kFaceSize);
    for (const float roughness : {0.1f, 0.3f, 0.5f, 0.7f, 1.0f}) {
      for (int i = 0; i < kPointsEach; ++i) {
        shading::ShadingPoint point = test::pointInRoom(room, roughness, i, random);
        point.pixel = {i, 7 * i % 31};
        const glm::dvec3 truth = test::reflectedMean(room, chain, point, 4096);
        for (const Form& form : forms)
          tallies[form.name()].add(valueOf(form, shapeOf(room, chain, form), chain, point), truth);
      }
    }
  }
  const double hdrp = tallies["hdrp"].rmse();
  for (const Form& form : forms)
    std::printf("  %-24s error %.4f, over hdrp's %.2f\n", form.name().c_str(), tallies[form.name()].rmse(),
                tallies[form.name()].rmse() / hdrp);
  const auto ratio = [&](const char* name) { return tallies[name].rmse() / hdrp; };
  EXPECT_GT(ratio("infinite"), ratio("sphere"));
  EXPECT_GT(ratio("sphere"), ratio("approximate"));
  EXPECT_GT(ratio("approximate"), ratio("box"));
  EXPECT_NEAR(ratio("godot"), 1.0, 0.1);
  EXPECT_GT(ratio("box"), 0.98);
  EXPECT_GT(ratio("raytraced"), 1.5 * ratio("raytraced levelOffset")) << "64 rays alone leave ghosts of small lamps";
  EXPECT_GT(ratio("raytraced levelOffset"), 1.5 * ratio("raytraced filtered"));
}

// Rays without any filter, over many pixels: what they average to is the integral itself.
TEST(PublishedTechniques, RaysAverageToTheIntegral) {
  const test::BoxRoom room{{-2.0, -1.6, -3.0}, {4.0, 1.4, 2.0}, 6.0, 0.12, 10.0};
  const CubeMap chain = test::prefilteredRoom(room, 64);
  std::mt19937 random(4);
  for (int trial = 0; trial < 12; ++trial) {
    const float roughness = 0.3f + 0.06f * static_cast<float>(trial);
    shading::ShadingPoint point = test::pointInRoom(room, roughness, trial, random);
    const glm::dvec3 truth = test::reflectedMean(room, chain, point, 1 << 17);
    const Form form{"raytraced", 64.0f};
    const shading::ProbeShape probe = shapeOf(room, chain, form);
    glm::dvec3 sum(0.0), squares(0.0);
    constexpr int kPixels = 32;
    for (int y = 0; y < kPixels; ++y) {
      for (int x = 0; x < kPixels; ++x) {
        point.pixel = {x, y};
        const glm::dvec3 value = valueOf(form, probe, chain, point);
        sum += value;
        squares += value * value;
      }
    }
    const double count = kPixels * kPixels;
    for (int c = 0; c < 3; ++c) {
      const double mean = sum[c] / count;
      const double standardError = std::sqrt(std::max(squares[c] / count - mean * mean, 0.0) / count);
      // A quotient of sums is off by a share of its variance; 64 samples leave about a hundredth of that.
      EXPECT_NEAR(mean, truth[c], 4.0 * standardError + 0.01 * truth[c]) << "trial " << trial;
    }
  }
}

}  // namespace
}  // namespace boxprobe
