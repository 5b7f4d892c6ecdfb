// Rooms found in the free space of models, and the probes placed in them.
#include "filters/fit/place_probes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "tests/support/made_flat.h"
#include "tests/unit/made_model.h"

namespace boxprobe {
namespace {

struct Flat {
  Scene scene;
  TriangleRays::Models models;
  std::optional<Placement> place(const PlaceSettings& settings = {}, const FitProgress& progress = {}) const {
    return placeProbes(scene, models, settings, progress);
  }
};

Flat flatOf(Model model) {
  Flat flat;
  flat.scene.models = {{"made.glb"}};
  flat.models = {std::make_shared<const Model>(std::move(model))};
  return flat;
}

/// Does the box hold the room, and hardly more? `low`, `high`: metres, before the flat was turned.
void expectRoom(const Probe& probe, const test::FlatWishes& made, const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dmat3 worldFromFlat = rotationMatrix({0.0, made.yawDegrees, 0.0});
  const glm::dvec3 middle = worldFromFlat * (0.5 * (low + high)) * made.unitsPerMetre;
  const double allowed = 0.01 * made.unitsPerMetre * (high.x - low.x);
  EXPECT_LT(glm::length(probe.box.center() - middle), 2.0 * allowed) << probe.name;
  const double turned = std::remainder(probe.rotationDegrees.y - made.yawDegrees, 90.0);
  EXPECT_NEAR(turned, 0.0, 0.5) << probe.name;
  const bool across = std::abs(std::remainder(probe.rotationDegrees.y - made.yawDegrees, 180.0)) > 45.0;
  const glm::dvec3 size = probe.box.size();
  EXPECT_NEAR(across ? size.z : size.x, made.unitsPerMetre * (high.x - low.x), 2.0 * allowed) << probe.name;
  EXPECT_NEAR(size.y, made.unitsPerMetre * (high.y - low.y), 2.0 * allowed) << probe.name;
  EXPECT_NEAR(across ? size.x : size.z, made.unitsPerMetre * (high.z - low.z), 2.0 * allowed) << probe.name;
}

void expectFlat(const Placement& placement, const test::FlatWishes& made) {
  ASSERT_EQ(placement.rooms.size(), 2u);
  ASSERT_EQ(placement.probes.size(), 2u);
  expectRoom(placement.probes[0].probe, made, {0.1, 0.0, -1.5}, {5.1, 2.6, 1.5});
  expectRoom(placement.probes[1].probe, made, {-4.1, 0.0, -1.5}, {-0.1, 2.6, 1.5});
  EXPECT_EQ(placement.probes[0].probe.name, "room 1");
  EXPECT_EQ(placement.probes[1].probe.name, "room 2");
  ASSERT_EQ(placement.rooms[0].doorways.size(), 1u);
  EXPECT_EQ(placement.rooms[0].doorways[0].b, 1u);
  const double door = 1.8 * made.unitsPerMetre * made.unitsPerMetre;
  EXPECT_NEAR(placement.rooms[0].doorways[0].area, door, 0.35 * door);
}

TEST(PlaceProbes, FindsTwoRoomsInAnyUnitTurnedAndOnALargePlain) {
  test::FlatWishes wishes;
  wishes.groundMetres = 80.0;
  for (const double units : {1.0, 100.0, 0.01}) {
    wishes.unitsPerMetre = units;
    wishes.yawDegrees = units == 1.0 ? 0.0 : 25.0;
    const std::optional<Placement> placement = flatOf(test::madeFlat(wishes)).place();
    ASSERT_TRUE(placement);
    expectFlat(*placement, wishes);
    EXPECT_LT(placement->after.meanDegrees, 1.3) << units;
    EXPECT_LT(placement->after.unlit, 0.01) << "within the door's frame one probe fades into the other";
    EXPECT_NEAR(placement->before.meanDegrees, kHiddenDegrees, 1e-9) << "there was none";
  }
}

TEST(PlaceProbes, IsTheSameTwice) {
  const Flat flat = flatOf(test::madeFlat());
  const std::optional<Placement> once = flat.place(), again = flat.place();
  ASSERT_TRUE(once && again);
  EXPECT_TRUE(once->all() == again->all());
}

TEST(PlaceProbes, PlacesNoMoreThanAskedAndSaysSo) {
  PlaceSettings settings;
  settings.most = 1;
  const std::optional<Placement> placement = flatOf(test::madeFlat()).place(settings);
  ASSERT_TRUE(placement);
  EXPECT_EQ(placement->rooms.size(), 2u);
  ASSERT_EQ(placement->probes.size(), 1u);
  EXPECT_EQ(placement->probes[0].room, 0u) << "the larger room comes first";
  ASSERT_FALSE(placement->rooms[1].decisions.empty());
  EXPECT_EQ(placement->rooms[1].decisions[0].english(), "left out: no more than 1 probes were asked for");
}

TEST(PlaceProbes, KeepsProbesAndFillsTheOtherRooms) {
  Flat flat = flatOf(test::madeFlat());
  Probe own;
  own.name = "room 1";  // by chance
  own.origin = {2.0, 1.5, 0.5};
  own.box = {glm::dvec3(0.1, 0, -1.5), glm::dvec3(5.1, 2.6, 1.5)};
  Probe lost = own;
  lost.name = "in the wall";
  lost.origin = {0.0, 2.3, 0.0};
  flat.scene.probes = {own, lost};
  PlaceSettings settings;
  settings.keep = true;
  const std::optional<Placement> placement = flat.place(settings);
  ASSERT_TRUE(placement);
  ASSERT_EQ(placement->probes.size(), 1u);
  EXPECT_EQ(placement->probes[0].room, 1u);
  EXPECT_EQ(placement->probes[0].probe.name, "room 2");
  EXPECT_EQ(placement->kept.size(), 2u);
  ASSERT_EQ(placement->remarks.size(), 1u);
  EXPECT_EQ(placement->remarks[0].english().rfind("in the wall: its origin is in no room", 0), 0u);
}

TEST(PlaceProbes, WhatIsLeftOutLaterIsRatedAgain) {
  Flat flat = flatOf(test::madeFlat());
  Probe own;
  own.name = "own";
  own.origin = {2.0, 1.5, 0.5};
  own.box = {glm::dvec3(0.3, 0.1, -1.2), glm::dvec3(4.6, 2.3, 1.4)};
  flat.scene.probes = {own};
  std::optional<Placement> placement = flat.place();
  ASSERT_TRUE(placement);
  ASSERT_LT(placement->after.meanDegrees, 0.5 * placement->before.meanDegrees);
  ASSERT_LT(placement->bareAfter, 0.5 * placement->bareBefore);
  placement->probes.clear();
  placement->kept = flat.scene.probes;
  placement->rate();
  EXPECT_EQ(placement->after.meanDegrees, placement->before.meanDegrees);
  EXPECT_EQ(placement->after.p95Degrees, placement->before.p95Degrees);
  EXPECT_EQ(placement->after.hidden, placement->before.hidden);
  EXPECT_EQ(placement->after.unlit, placement->before.unlit);
  EXPECT_EQ(placement->bareAfter, placement->bareBefore);
  for (const PlacedRoom& room : placement->rooms) {
    EXPECT_EQ(room.after.meanDegrees, room.before.meanDegrees) << room.name;
  }
}

TEST(PlaceProbes, ALongRoomGetsMoreWhereTheyGain) {
  // A hall whose middle is hidden from both ends by two screens.
  MadeModel made;
  made.box({glm::dvec3(-9, 0, -2), glm::dvec3(9, 3, 2)}, true);
  for (const double x : {-3.0, 3.0}) made.box({glm::dvec3(x - 0.05, 0, -2), glm::dvec3(x + 0.05, 1.7, 2)}, false);
  made.model.materials.emplace_back().roughness = 0.1f;
  made.model.meshes.front().material = 0;
  const Flat flat = flatOf(std::move(made.model));
  const std::optional<Placement> placement = flat.place();
  ASSERT_TRUE(placement);
  ASSERT_EQ(placement->rooms.size(), 1u) << "what is open above the screens is one room";
  EXPECT_GT(placement->probes.size(), 1u);
  PlaceSettings one;
  one.leastGain = 1.0;
  const std::optional<Placement> single = flat.place(one);
  ASSERT_TRUE(single);
  ASSERT_EQ(single->probes.size(), 1u);
  EXPECT_NEAR(single->probes[0].gainDegrees, kHiddenDegrees - single->after.meanDegrees, 1e-6) << "all that it leaves";
  EXPECT_LT(placement->after.meanDegrees, 0.9 * single->after.meanDegrees);
  // Where the influences of two overlap, the one that is better there comes before the room's.
  const Probe& room = placement->probes.front().probe;
  for (std::size_t i = 1; i < placement->probes.size(); ++i) {
    const Probe& part = placement->probes[i].probe;
    EXPECT_GT(part.importance, room.importance) << part.name;
    EXPECT_EQ(part.importance, 2.0) << part.name << ": one more than what lies below it";
    const Box& smaller = part.influenceBox();
    const Box& larger = room.influenceBox();
    EXPECT_LT(smaller.size().x, 0.8 * larger.size().x) << part.name;
  }
  // What it was chosen for is what it brings: candidates are judged with the importance that they get.
  double gains = 0.0;
  for (std::size_t i = 1; i < placement->probes.size(); ++i) gains += placement->probes[i].gainDegrees;
  EXPECT_NEAR(gains, single->after.meanDegrees - placement->after.meanDegrees, 1e-6);
}

TEST(PlaceProbes, LeavesARoomsFirstProbeOutWhereTheOthersCoverIt) {
  // Two parts of a hall and a wide opening between two blocks: two probes do what the first one did.
  MadeModel made;
  made.box({glm::dvec3(-9, 0, -4), glm::dvec3(9, 3, 4)}, true);
  made.box({glm::dvec3(-1.5, 0, -4), glm::dvec3(1.5, 3, -0.5)}, false);
  made.box({glm::dvec3(-1.5, 0, 2.5), glm::dvec3(1.5, 3, 4)}, false);
  made.model.materials.emplace_back().roughness = 0.1f;
  made.model.meshes.front().material = 0;
  PlaceSettings settings;
  settings.leastGain = 0.004;
  const std::optional<Placement> placement = flatOf(std::move(made.model)).place(settings);
  ASSERT_TRUE(placement);
  ASSERT_EQ(placement->rooms.size(), 1u);
  const std::vector<std::string> decisions = english(placement->rooms.front().decisions);
  ASSERT_FALSE(decisions.empty());
  EXPECT_NE(decisions.back().find("the others cover its first probe"), std::string::npos) << decisions.back();
  ASSERT_EQ(placement->probes.size(), 2u);
  for (const PlacedProbe& each : placement->probes) EXPECT_TRUE(each.part) << each.probe.name;
  EXPECT_LT(placement->after.meanDegrees, 0.8);
  EXPECT_LT(placement->after.unlit, 0.01) << "no place is left without a probe";
}

TEST(PlaceProbes, SaysWhatStandsInTheWay) {
  MadeModel plain;
  plain.quad({-40, 0, 40}, {40, 0, 40}, {40, 0, -40}, {-40, 0, -40});
  const std::optional<Placement> open = flatOf(plain.model).place();
  ASSERT_TRUE(open);
  EXPECT_TRUE(open->probes.empty());
  ASSERT_EQ(open->remarks.size(), 1u);
  EXPECT_EQ(open->remarks[0].english().rfind("open: ", 0), 0u);

  MadeModel block;  // a thing with nothing to stand in
  block.box({glm::dvec3(-2), glm::dvec3(2)}, false);
  block.quad({-40, -2, 40}, {40, -2, 40}, {40, -2, -40}, {-40, -2, -40});
  const std::optional<Placement> solid = flatOf(block.model).place();
  ASSERT_TRUE(solid);
  EXPECT_TRUE(solid->probes.empty());
  EXPECT_NE(solid->remarks[0].english().find("inverted"), std::string::npos);
}

TEST(PlaceProbes, InvertedFacesAreWallsWhereACameraStandsAmongThem) {
  test::FlatWishes wishes;
  wishes.inverted = true;
  Flat flat = flatOf(test::madeFlat(wishes));
  flat.scene.cameras.emplace_back().position = {2.0, 1.6, 0.0};
  const std::optional<Placement> placement = flat.place();
  ASSERT_TRUE(placement);
  expectFlat(*placement, wishes);
  ASSERT_FALSE(placement->remarks.empty());
  EXPECT_NE(placement->remarks[0].english().find("inverted"), std::string::npos);
}

TEST(PlaceProbes, MirrorsAllAroundAreWalls) {
  test::FlatWishes wishes;
  wishes.roughness = 0.0f;
  Model model = test::madeFlat(wishes);
  model.materials.front().metallic = 1.0f;
  model.instances.front().worldFromModel = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, -1.0));  // and mirrored
  std::vector<std::uint32_t>& indices = model.meshes.front().indices;  // as readers turn them over for such an instance
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
  const std::optional<Placement> placement = flatOf(std::move(model)).place();
  ASSERT_TRUE(placement);
  expectFlat(*placement, wishes);
}

// Without ceilings walls count that are near, wherever in the model that is.
TEST(PlaceProbes, CourtsInARowAreARoomEach) {
  MadeModel made;
  constexpr int kCourts = 5;
  for (int i = 0; i < kCourts; ++i) {
    const Box court{glm::dvec3(5.2 * i, 0, 0), glm::dvec3(5.2 * i + 5.0, 2.6, 4.0 + 0.2 * i)};
    made.side(court, 1, false);
    for (const int axis : {0, 2}) {
      made.side(court, axis, false);
      made.side(court, axis, true);
    }
  }
  const std::optional<Placement> placement = flatOf(std::move(made.model)).place();
  ASSERT_TRUE(placement);
  EXPECT_EQ(placement->rooms.size(), static_cast<std::size_t>(kCourts));
  for (const auto& room : placement->rooms) EXPECT_GT(room.volume, 35.0);
}

TEST(PlaceProbes, StopsWhenAsked) {
  const Flat flat = flatOf(test::madeFlat());
  for (const double stop : {0.1, 0.4, 0.9}) {
    double last = 0.0;
    EXPECT_FALSE(flat.place({}, [&](double done) {
      EXPECT_GE(done, last - 1e-12);
      last = done;
      return done < stop;
    }));
    EXPECT_GE(last, stop);
  }
}

}  // namespace
}  // namespace boxprobe
