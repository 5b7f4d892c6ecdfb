// Which probe a click, or where one stands, selects.
#include <gtest/gtest.h>

#include "filters/core/geometry/probe_at.h"

namespace boxprobe {
namespace {

Probe room(const char* name, double from, double to) {
  Probe probe;
  probe.name = name;
  probe.box = {glm::dvec3(from, 0, -2), glm::dvec3(to, 3, 2)};
  probe.origin = probe.box.center();
  probe.blendDistance = {glm::dvec3(0.5), glm::dvec3(0.5)};
  return probe;
}

TEST(ProbeAt, TheOneWithTheLargestShare) {
  const std::vector<Probe> rooms = {room("left", -4, 0.5), room("right", -0.5, 4)};
  EXPECT_EQ(probeLighting(rooms, {-2, 1, 0}), std::optional<std::size_t>(0));
  EXPECT_EQ(probeLighting(rooms, {2, 1, 0}), std::optional<std::size_t>(1));
  EXPECT_EQ(probeLighting(rooms, {0.2, 1, 0}), std::optional<std::size_t>(1)) << "both light it, this one more";
  EXPECT_EQ(probeLighting(rooms, {9, 1, 0}), std::nullopt);
  EXPECT_EQ(probeNearest(rooms, {9, 1, 0}), std::optional<std::size_t>(1));
  EXPECT_EQ(probeNearest({}, {0, 1, 0}), std::nullopt);
}

TEST(ProbeAt, TheMoreImportantOne) {
  std::vector<Probe> probes = {room("house", -8, 8), room("cupboard", 1, 3)};
  EXPECT_EQ(probeLighting(probes, {2, 1, 0}), std::optional<std::size_t>(1)) << "of equal shares the smaller";
  probes[0].importance = 2.0;
  EXPECT_EQ(probeLighting(probes, {2, 1, 0}), std::optional<std::size_t>(0));
}

TEST(ProbeAt, ATurnedBoxIsMeantAsItIsTurned) {
  Probe slab = room("slab", -4, 4);
  slab.box = {glm::dvec3(-4, 0, -0.5), glm::dvec3(4, 3, 0.5)};
  slab.blendDistance = {glm::dvec3(0.1), glm::dvec3(0.1)};
  EXPECT_EQ(probeLighting({slab}, {3, 1, 0}), std::optional<std::size_t>(0));
  slab.rotationDegrees.y = 90.0;
  EXPECT_EQ(probeLighting({slab}, {3, 1, 0}), std::nullopt);
  EXPECT_EQ(probeLighting({slab}, {0, 1, 3}), std::optional<std::size_t>(0));
}

}  // namespace
}  // namespace boxprobe
