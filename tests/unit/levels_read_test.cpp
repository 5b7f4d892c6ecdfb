// What the table of techniques says of the levels they look up, against the lookups themselves: a level that is not in
// the mask is not filtered, so that no technique may read it.
#include "filters/math/technique/levels_read.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace boxprobe {
namespace {

using glm::vec3;

constexpr int kLevels = 7;

/// Notes the whole levels that each lookup mixes.
struct Levels : shading::CubeSampler {
  glm::vec4 fetch(const vec3&, float level) const override {
    const float within = std::clamp(level, 0.0f, static_cast<float>(kLevels - 1));
    // A share below this of the next level is rounding.
    constexpr float kShare = 1.0e-4f;
    const float below = std::floor(within), share = within - below;
    if (share < 1.0f - kShare) read |= LevelMask{1} << static_cast<int>(below);
    if (share > kShare) read |= LevelMask{1} << (static_cast<int>(below) + 1);
    return glm::vec4(1.0f);
  }
  mutable LevelMask read = 0;
};

class LevelsRead : public ::testing::Test {
 protected:
  float unit() { return std::uniform_real_distribution<float>(0.0f, 1.0f)(random_); }
  vec3 direction() {
    std::normal_distribution<float> gauss;
    return glm::normalize(vec3(gauss(random_), gauss(random_), gauss(random_)));
  }
  /// Over random boxes, points and views, for roughness between the two.
  LevelMask read(const Technique& technique, const shading::TechniqueParameters& parameters, float low, float high) {
    Levels levels;
    for (int i = 0; i < 400; ++i) {
      shading::ProbeShape probe{};
      probe.boxMin = -vec3(0.1f + 5 * unit(), 0.1f + 5 * unit(), 0.1f + 5 * unit());
      probe.boxMax = vec3(0.1f + 5 * unit(), 0.1f + 5 * unit(), 0.1f + 5 * unit());
      probe.maxLevel = kLevels - 1;
      probe.projection = technique.projection;
      probe.parameters = parameters;
      shading::ShadingPoint point{};
      point.position = probe.boxMin + (probe.boxMax - probe.boxMin) * vec3(unit(), unit(), unit());
      point.normal = direction();
      point.view = direction();
      if (glm::dot(point.normal, point.view) < 0.0f) point.view = -point.view;
      point.reflection = glm::reflect(-point.view, point.normal);
      point.roughness = i == 0 ? low : i == 1 ? high : low + (high - low) * unit();
      point.fresnel = unit();
      point.f0 = 1.0e-3f + unit();
      evaluationRows()[static_cast<std::size_t>(technique.evaluation)].evaluate(&levels, probe, point);
    }
    return levels.read;
  }
  std::mt19937 random_{7};
};

TEST_F(LevelsRead, NoTechniqueLooksUpALevelThatIsLeftOut) {
  const std::pair<float, float> ranges[] = {{0.0f, 0.0f}, {0.08f, 0.08f}, {0.3f, 0.3f}, {0.9f, 0.9f},
                                            {1.0f, 1.0f}, {0.1f, 0.4f},   {0.0f, 1.0f}};
  int spared = 0;
  for (std::size_t row = 0; row < evaluationRows().size(); ++row) {
    const Technique technique{parseTechnique("box")->projection, static_cast<int>(row)};
    const auto curves = static_cast<int>(findParameter("curve")->choices.size());
    for (int curve = 0; curve < curves; ++curve) {
      shading::TechniqueParameters parameters = standardParameters();
      parameters.curve = curve;
      for (const auto& [low, high] : ranges) {
        const LevelMask mask =
            levelsRead(technique, parameters, static_cast<double>(low), static_cast<double>(high), kLevels);
        const LevelMask found = read(technique, parameters, low, high);
        EXPECT_EQ(found & ~mask, 0u) << techniqueId(technique) << ", curve " << curve << ", roughness " << low << " to "
                                     << high;
        for (int level = 0; level < kLevels; ++level) spared += (mask >> level & 1u) == 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(spared, 200) << "nothing is ever left out";
}

TEST_F(LevelsRead, OneRoughnessTakesTheLevelsAboutIt) {
  const Technique box = *parseTechnique("box");
  const auto mask = [&](double low, double high) { return levelsRead(box, standardParameters(), low, high, kLevels); };
  EXPECT_EQ(mask(0.0, 0.0), 1u);
  EXPECT_EQ(mask(1.0, 1.0), 1u << 6);
  EXPECT_EQ(mask(0.9, 0.9), 3u << 5);
  EXPECT_EQ(mask(0.0, 1.0), (1u << kLevels) - 1);
  EXPECT_EQ(skyLevelsRead(0.9, 0.9, kLevels), 3u << 5);
  EXPECT_EQ(levelsRead(*parseTechnique("box+hdrp"), standardParameters(), 0.0, 0.0, kLevels), 1u);
  EXPECT_EQ(levelsRead(*parseTechnique("footprint4"), standardParameters(), 0.0, 0.0, kLevels), kAllLevels);
}

}  // namespace
}  // namespace boxprobe
