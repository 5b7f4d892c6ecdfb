// Many probes at once: found by place as each is asked for, and shared out without a crease.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/probe_index.h"
#include "filters/core/geometry/probe_shares.h"
#include "filters/math/shared/shared_math.h"

namespace boxprobe {
namespace {

Box randomBox(std::mt19937& random, double extent) {
  std::uniform_real_distribution<double> at(-extent, extent), size(0.0, 3.0);
  const glm::dvec3 low(at(random), at(random), at(random));
  return Box{low, low + glm::dvec3(size(random), size(random), size(random))};
}

TEST(ProbeIndex, FindsThoseThatMeetAndNoOthers) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-180.0, 180.0);
  std::vector<Probe> probes(700);
  for (Probe& probe : probes) {
    probe.box = randomBox(random, 12.0);
    if (random() % 2 == 0) probe.rotationDegrees = {angle(random), angle(random), angle(random)};
    if (random() % 3 == 0) probe.influence = randomBox(random, 12.0);
  }
  const ProbeIndex index(probes);
  std::size_t found = 0;
  for (int i = 0; i < 300; ++i) {
    const Box bounds = randomBox(random, 14.0);
    std::vector<std::size_t> expected;
    for (std::size_t p = 0; p < probes.size(); ++p) {
      if (boxesMeet(influenceBounds(probes[p]), bounds)) expected.push_back(p);
    }
    EXPECT_EQ(index.meeting(bounds), expected);
    found += expected.size();
  }
  EXPECT_GT(found, 200u);
  EXPECT_TRUE(ProbeIndex(std::vector<Probe>()).meeting(Box{}).empty());
}

ProbeShares sharesAt(const std::vector<Probe>& probes, const std::vector<int>& groups, const glm::dvec3& place,
                     bool onlyProbes) {
  std::vector<float> weights;
  for (const Probe& probe : probes) {
    const ProbeGeometry g = probeGeometry(probe, probe.origin);
    weights.push_back(shading::influenceWeight(glm::vec3(place - probe.origin), g.influenceMin, g.influenceMax,
                                               g.rateMin, g.rateMax));
  }
  return shareOut(weights, groups, onlyProbes);
}

// Along a line through boxes that nest and overlap: shares sum to 1, and a quarter of the second difference is left
// when the step is halved, as where a first derivative is continuous; across a crease half of it would be.
TEST(ProbeShares, HaveNoCreaseWhereBoxesMeetOrNest) {
  std::vector<Probe> probes(4);
  const double ends[4][2] = {{-4.0, 1.0}, {-1.0, 5.0}, {0.5, 3.0}, {-0.6, 0.9}};
  const double blends[4] = {1.3, 1.9, 0.8, 0.5};
  for (std::size_t i = 0; i < 4; ++i) {
    probes[i].box = Box{{ends[i][0], -1.0, -1.0}, {ends[i][1], 1.0, 1.0}};
    probes[i].blendDistance = BlendDistance{glm::dvec3(blends[i]), glm::dvec3(blends[i])};
    probes[i].blendDistance.min.y = probes[i].blendDistance.max.y = 0.2;
    probes[i].blendDistance.min.z = probes[i].blendDistance.max.z = 0.2;
  }
  for (const std::vector<int>& groups : {std::vector<int>{0, 0, 0, 0}, {0, 0, 1, 1}, {0, 1, 2, 2}}) {
    const auto worst = [&](int steps) {
      double largest = 0.0;
      std::vector<ProbeShares> line;
      for (int i = 0; i <= steps; ++i) {
        line.push_back(sharesAt(probes, groups, {-5.0 + 11.0 * i / steps, 0.1, 0.0}, false));
        float sum = line.back().sky;
        for (const float share : line.back().probes) sum += share;
        EXPECT_NEAR(sum, 1.0f, 1.0e-6f);
      }
      for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        for (std::size_t p = 0; p < 4; ++p) {
          largest =
              std::max(largest, std::abs(line[i - 1].probes[p] - 2.0 * line[i].probes[p] + line[i + 1].probes[p]));
        }
        largest = std::max<double>(largest, std::abs(line[i - 1].sky - 2.0 * line[i].sky + line[i + 1].sky));
      }
      return largest;
    };
    const double coarse = worst(800), fine = worst(1600);
    EXPECT_LT(fine, 0.3 * coarse);
  }
}

TEST(ProbeShares, OnlyProbesShareWhatTheyLeave) {
  const ProbeShares usual = shareOut({0.5f, 0.25f}, {0, 1}, false), only = shareOut({0.5f, 0.25f}, {0, 1}, true);
  EXPECT_GT(usual.sky, 0.1f);
  EXPECT_EQ(only.sky, 0.0f);
  EXPECT_NEAR(only.probes[0] + only.probes[1], 1.0f, 1.0e-6f);
  EXPECT_NEAR(only.probes[0] / only.probes[1], usual.probes[0] / usual.probes[1], 1.0e-5f);
  EXPECT_EQ(shareOut({0.0f}, {0}, true).sky, 1.0f) << "where no probe has weight there is the sky";
  EXPECT_EQ(shareOut({}, {}, true).sky, 1.0f);
}

TEST(ProbeShares, AnObjectsWeightIsWhatTheBoxHoldsOfIt) {
  Probe probe;
  probe.box = Box{{0, 0, 0}, {4, 4, 4}};
  EXPECT_EQ(objectWeight(probe, Box{{1, 1, 1}, {2, 2, 2}}), 1.0);
  EXPECT_EQ(objectWeight(probe, Box{{3, 1, 1}, {5, 2, 2}}), 0.5);
  EXPECT_EQ(objectWeight(probe, Box{{3, 3, 1}, {5, 5, 2}}), 0.25);
  EXPECT_EQ(objectWeight(probe, Box{{5, 1, 1}, {6, 2, 2}}), 0.0);
  EXPECT_EQ(objectWeight(probe, Box{{1, 2, 1}, {2, 2, 2}}), 1.0) << "a flat object";
  probe.rotationDegrees = {0.0, 90.0, 0.0};
  EXPECT_NEAR(objectWeight(probe, Box{{3, 1, 1}, {5, 2, 2}}), 0.5, 1.0e-9);
}

}  // namespace
}  // namespace boxprobe
