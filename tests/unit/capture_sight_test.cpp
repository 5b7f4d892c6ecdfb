// What a capture takes for its lamps and its surroundings, whatever the probe's box: in a room whose rays are this
// file's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/geometry/lamp_sight.h"

namespace {

using namespace boxprobe;
using glm::dvec3;
using ::testing::ElementsAre;

const dvec3 kLow(-1.7, 0.3, -2.6), kHigh(3.4, 2.8, 1.9);

/// A room seen from within, with a slit in its east wall, behind which there is nothing for a hundred metres.
struct SlitRoom : SightLines {
  bool open = false;
  bool empty() const override { return false; }
  Box bounds() const override { return {kLow, kHigh}; }
  bool blocked(const dvec3&, const dvec3&, bool) const override { return false; }
  std::optional<Met> first(const dvec3& from, const dvec3& d) const override {
    double nearest = 1e300;
    int wall = 0;
    for (int a = 0; a < 3; ++a) {
      if (d[a] == 0.0) continue;
      const double t = ((d[a] > 0.0 ? kHigh : kLow)[a] - from[a]) / d[a];
      if (t >= nearest) continue;
      nearest = t;
      wall = a;
    }
    const dvec3 at = from + nearest * d;
    if (open && wall == 0 && d.x > 0.0 && std::abs(at.z - 0.4) < 0.06) nearest += 100.0 / d.x;
    return Met{nearest, false, {}, {}};
  }
};

TEST(CaptureSight, TheBoxIsWhatIsSeen) {
  SlitRoom room;
  for (const bool open : {false, true}) {
    room.open = open;
    for (const dvec3& from : {dvec3(0.4, 1.1, -0.7), dvec3(2.9, 2.5, 1.2)}) {
      const Box box = boxSeenFrom(room, from);
      for (int a = 0; a < 3; ++a) {
        EXPECT_NEAR(box.min[a], kLow[a], 0.02) << a;
        EXPECT_NEAR(box.max[a], kHigh[a], 0.02) << a;
      }
    }
  }
}

SceneLamp lampAt(const char* node, const dvec3& middle, double power, std::size_t group) {
  SceneLamp lamp;
  lamp.node = node;
  lamp.middle = middle;
  lamp.corners = {middle, middle + dvec3(0.1, 0, 0), middle + dvec3(0.1, 0, 0.1)};
  lamp.normal = {0, -1, 0};
  lamp.area = 0.005;
  lamp.power = power;
  lamp.group = group;
  return lamp;
}

// The strongest where the capture is, each group whole or not at all, and none that is hidden from the probe.
TEST(CaptureSight, LampsAreChosenFromTheCaptureOrigin) {
  Probe probe;
  probe.name = "p";
  probe.origin = {0.2, 1.0, -0.4};
  probe.box = {{50, 50, 50}, {60, 60, 60}};
  probe.hides = {"hidden"};
  SceneLamps lamps;
  lamps.lamps = {lampAt("far", {40.2, 1.0, -0.4}, 160.0, 3), lampAt("hidden", {0.2, 1.6, -0.4}, 90.0, 1),
                 lampAt("pair", {0.2, 3.0, -0.4}, 2.0, 7), lampAt("near", {0.2, 2.0, -0.4}, 1.9, 4),
                 lampAt("pair", {0.2, 3.0, -0.4}, 1.4, 7)};
  EXPECT_THAT(captureLamps(lamps.lamps, probe), ElementsAre(3, 2, 4, 0));  // 1.9, .85 and .1 a square metre
  EXPECT_THAT(captureLamps(lamps.lamps, probe, 2), ElementsAre(3, 0));
  probe.origin = {38.2, 1.0, -0.4};
  EXPECT_EQ(captureLamps(lamps.lamps, probe).front(), 0u);
  const ProbeSight untraced = untracedSight(lamps, probe);
  EXPECT_THAT(untraced.lamps, ElementsAre(0, 2, 3, 4));
  for (const std::size_t lamp : untraced.lamps) EXPECT_EQ(untraced.channelOfLamp(lamp), kSeenByAll);
  EXPECT_EQ(untraced.channelOfLamp(1), kSeenByNone);
}

TEST(CaptureSight, TheTaskIsTheSameWhateverTheBox) {
  Scene scene;
  Light bulb;
  bulb.type = LightType::Point;
  bulb.position = {0.7, 2.1, 0.2};
  bulb.intensity = 3.0f;
  Light counted = bulb;
  counted.position = {0.2, 2.0, -0.4};
  scene.lights = {counted, bulb};
  SceneLamps lamps;
  lamps.lamps = {lampAt("near", {0.2, 2.0, -0.4}, 1.9, 4)};
  lamps.lamps[0].light = 0;
  Probe probe;
  probe.origin = {0.4, 1.1, -0.7};
  probe.box = {kLow, kHigh};
  const SightTask task = captureSightTask(scene, lamps, probe);
  ASSERT_EQ(task.from, std::optional<dvec3>(probe.origin));
  EXPECT_EQ(task.own, 0u);
  ASSERT_EQ(task.lamps.size(), 1u);
  ASSERT_EQ(task.sources.size(), 1u);
  EXPECT_EQ(task.sources[0].index, 1u);
  probe.box = {{0.1, 0.5, -1.0}, {0.9, 1.4, -0.2}};
  probe.rotationDegrees = {0, 31, 0};
  EXPECT_TRUE(task == captureSightTask(scene, lamps, probe));
  probe.origin.x += 0.1;
  EXPECT_FALSE(task == captureSightTask(scene, lamps, probe));
}

}  // namespace
