// What placed probes are called and reach, where people stand, and what is made of models that are no flats.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <set>

#include "filters/fit/place_probes.h"
#include "filters/fit/room_names.h"
#include "tests/unit/made_model.h"

namespace boxprobe {
namespace {

std::optional<Placement> placedIn(Model model, std::vector<Probe> own = {}) {
  Scene scene;
  scene.models = {{"made.glb"}};
  scene.probes = std::move(own);
  return placeProbes(scene, {std::make_shared<const Model>(std::move(model))});
}

/// A thing of its own, for its name.
void addNamed(Model& model, const std::string& name, const Box& box) {
  MadeModel thing;
  thing.box(box, false);
  model.meshes.push_back(thing.model.meshes.front());
  model.instances.push_back({name, static_cast<int>(model.meshes.size()) - 1, glm::dmat4(1.0)});
}

/// Rooms of 4, 5 and 6 m along x, 2.7 m high and 3.1 m deep, without doors.
MadeModel threeRooms() {
  MadeModel made;
  made.box({glm::dvec3(0, 0, 0), glm::dvec3(4, 2.7, 3.1)}, true);
  made.box({glm::dvec3(4.3, 0, 0), glm::dvec3(9.3, 2.7, 3.1)}, true);
  made.box({glm::dvec3(9.6, 0, 0), glm::dvec3(15.6, 2.7, 3.1)}, true);
  made.model.materials.emplace_back().roughness = 0.15f;
  made.model.meshes.front().material = 0;
  return made;
}

TEST(RoomNames, AreTakenFromWords) {
  EXPECT_EQ(roomNamedBy("Kitchen_Floor.001"), "kitchen");
  EXPECT_EQ(roomNamedBy("LivingRoomSofa"), "living room");
  EXPECT_EQ(roomNamedBy("wall bathroom 2"), "bathroom");
  EXPECT_EQ(roomNamedBy("livingroom"), "living room");
  EXPECT_EQ(roomNamedBy("kitchenette"), "") << "another word";
  EXPECT_EQ(roomNamedBy("Cube.003"), "");
  EXPECT_EQ(roomNamedBy(""), "");
}

TEST(RoomNames, AreNumberedWithoutGapsThoseWithProbesFirst) {
  const std::vector<std::string> names = numberedRooms({"", "bedroom", "", "kitchen", "bedroom", ""}, {2, 1, 3, 4, 5});
  EXPECT_EQ(names, (std::vector<std::string>{"room 3", "bedroom 1", "room 1", "kitchen", "bedroom 2", "room 2"}));
}

TEST(PlacedRooms, AreCalledAsTheirObjects) {
  MadeModel made = threeRooms();
  addNamed(made.model, "Kitchen_Table", {glm::dvec3(10.5, 0, 0.6), glm::dvec3(11.5, 0.7, 1.2)});
  addNamed(made.model, "kitchen lamp", {glm::dvec3(12.5, 2.6, 1.0), glm::dvec3(12.7, 2.7, 1.2)});
  addNamed(made.model, "study", {glm::dvec3(13.9, 0, 2.0), glm::dvec3(14.4, 0.5, 2.5)});  // outvoted
  addNamed(made.model, "Box", {glm::dvec3(1.0, 0, 1.0), glm::dvec3(1.5, 0.6, 1.4)});
  const std::optional<Placement> placement = placedIn(std::move(made.model));
  ASSERT_TRUE(placement);
  ASSERT_EQ(placement->rooms.size(), 3u);
  EXPECT_EQ(placement->rooms[0].name, "kitchen") << "the largest one";
  EXPECT_EQ(placement->rooms[1].name, "room 1");
  EXPECT_EQ(placement->rooms[2].name, "room 2");
  std::set<std::string> names;
  for (const PlacedProbe& placed : placement->probes) {
    EXPECT_TRUE(names.insert(placed.probe.name).second) << placed.probe.name;
    EXPECT_EQ(placed.probe.name.rfind(placement->rooms[placed.room].name, 0), 0u) << placed.probe.name;
    EXPECT_NE(placed.reason.english().find(placement->rooms[placed.room].name), std::string::npos)
        << placed.reason.english();
  }
}

TEST(PlacedRooms, LettersTellTheProbesOfARoomApart) {
  Placement placement;
  placement.rooms.resize(2);
  placement.rooms[0].name = "kitchen";
  placement.rooms[1].name = "room 1";
  placement.kept.emplace_back().name = "room 1";
  placement.probes.resize(3);
  placement.probes[2].room = 1;
  nameProbes(placement);
  EXPECT_EQ(placement.probes[0].probe.name, "kitchen a");
  EXPECT_EQ(placement.probes[1].probe.name, "kitchen b");
  EXPECT_EQ(placement.probes[2].probe.name, "room 1 2") << "what is kept has its name already";
}

TEST(PlacedRooms, PeopleStandWithinReachOfTheFloor) {
  const std::optional<Placement> placement = placedIn(threeRooms().model);
  ASSERT_TRUE(placement);
  for (const PlacedRoom& room : placement->rooms) {
    ASSERT_EQ(room.eyes.size(), 12u) << room.name;
    for (const Camera& eye : room.eyes) {
      EXPECT_GE(eye.position.y, 1.19) << room.name;
      EXPECT_LE(eye.position.y, 1.81) << room.name;
      EXPECT_NEAR(eye.position.x, room.middleWorld.x, 0.5 * room.extent.size().x) << room.name;
    }
  }
}

TEST(PlacedRooms, ProbesReachTheFramesOfWindowsButNotTheGarden) {
  // A window niche of 0.35 m behind the wall at z = 3.1, with a pane at its end; a garden beyond.
  MadeModel made;
  const Box room{glm::dvec3(-2.3, 0, 0), glm::dvec3(2.6, 2.7, 3.1)};
  for (const int axis : {0, 1}) {
    made.side(room, axis, false);
    made.side(room, axis, true);
  }
  made.side(room, 2, false);
  const Box hole{glm::dvec3(-0.9, 0.8, 3.1), glm::dvec3(1.1, 2.1, 3.45)};
  for (const int axis : {0, 1}) {
    made.side(hole, axis, false);
    made.side(hole, axis, true);
  }
  made.side(hole, 2, true);  // the pane
  const Box pieces[] = {{glm::dvec3(-2.3, 0, 3.1), glm::dvec3(-0.9, 2.7, 3.1)},
                        {glm::dvec3(1.1, 0, 3.1), glm::dvec3(2.6, 2.7, 3.1)},
                        {glm::dvec3(-0.9, 0, 3.1), glm::dvec3(1.1, 0.8, 3.1)},
                        {glm::dvec3(-0.9, 2.1, 3.1), glm::dvec3(1.1, 2.7, 3.1)}};
  for (const Box& piece : pieces) made.side(piece, 2, true);
  made.quad({-20, -0.1f, 20}, {20, -0.1f, 20}, {20, -0.1f, -20}, {-20, -0.1f, -20});
  made.model.materials.emplace_back().roughness = 0.1f;
  made.model.meshes.front().material = 0;
  const std::optional<Placement> placement = placedIn(std::move(made.model));
  ASSERT_TRUE(placement);
  ASSERT_EQ(placement->probes.size(), 1u);
  const Probe& probe = placement->probes[0].probe;
  ASSERT_EQ(probe.rotationDegrees, glm::dvec3(0.0));
  EXPECT_NEAR(probe.box.max.z, 3.1, 0.06) << "the box follows the wall";
  EXPECT_GT(probe.influenceBox().max.z - probe.blendDistance.max.z, 3.44) << "the pane has the full weight";
  EXPECT_LT(probe.influenceBox().max.z, 3.6) << "the garden has none";
  EXPECT_LT(probe.influenceBox().max.x, 2.7) << "nothing is behind that wall";
}

/// A lounge of 5.3 x 2.7 x 3.4 m, open at z = 0 to a walled garden of 5.3 x 4.7 m.
MadeModel loungeAndGarden() {
  MadeModel made;
  const Box lounge{glm::dvec3(-2.4, 0, -3.4), glm::dvec3(2.9, 2.7, 0)},
      garden{glm::dvec3(-2.4, 0, 0), glm::dvec3(2.9, 3.7, 4.7)};
  for (const bool upper : {false, true}) {
    made.side(lounge, 0, upper);
    made.side(lounge, 1, upper);
    made.side(garden, 0, upper);
  }
  made.side(lounge, 2, false);
  made.side(garden, 2, true);
  made.side(garden, 1, false);
  made.side({glm::dvec3(-2.4, 2.7, 0), glm::dvec3(2.9, 3.7, 0)}, 2, false);  // above the opening
  made.model.materials.emplace_back().roughness = 0.1f;
  made.model.meshes.front().material = 0;
  return made;
}

bool holds(const Box& box, const glm::dvec3& p) {
  return glm::all(glm::greaterThan(p, box.min)) && glm::all(glm::lessThan(p, box.max));
}

TEST(PlacedRooms, IndoorsAndOutdoorsAreNeverInOneBox) {
  const std::optional<Placement> placement = placedIn(loungeAndGarden().model);
  ASSERT_TRUE(placement);
  ASSERT_EQ(placement->rooms.size(), 2u);
  EXPECT_TRUE(placement->indoorsAndOutdoors());
  bool indoors = false;
  for (const PlacedProbe& placed : placement->probes) {
    const Box& box = placed.probe.box;
    ASSERT_EQ(placed.probe.rotationDegrees, glm::dvec3(0.0));
    EXPECT_FALSE(holds(box, {0.3, 1.3, -1.4}) && holds(box, {0.3, 1.3, 1.9})) << placed.probe.name;
    EXPECT_EQ(placement->rooms[placed.room].outdoors, placed.probe.origin.z > 0.0) << placed.probe.name;
    if (placement->rooms[placed.room].outdoors) continue;
    indoors = true;
    EXPECT_LT(placed.probe.influenceBox().max.z, 0.5) << "the garden is not lit by the lounge";
  }
  EXPECT_TRUE(indoors);
}

TEST(PlacedRooms, AHoleInTheRoofIsNoGarden) {
  // A hall of 7.3 x 3.1 x 5.7 m with a skylight of 1.7 x 1.5 m.
  MadeModel made;
  const Box hall{glm::dvec3(-3.4, 0, -2.6), glm::dvec3(3.9, 3.1, 3.1)};
  for (const int axis : {0, 2}) {
    made.side(hall, axis, false);
    made.side(hall, axis, true);
  }
  made.side(hall, 1, false);
  for (const Box& piece : {Box{glm::dvec3(-3.4, 3.1, -2.6), glm::dvec3(-0.6, 3.1, 3.1)},
                           Box{glm::dvec3(1.1, 3.1, -2.6), glm::dvec3(3.9, 3.1, 3.1)},
                           Box{glm::dvec3(-0.6, 3.1, -2.6), glm::dvec3(1.1, 3.1, -0.4)},
                           Box{glm::dvec3(-0.6, 3.1, 1.1), glm::dvec3(1.1, 3.1, 3.1)}}) {
    made.side(piece, 1, true);
  }
  const std::optional<Placement> placement = placedIn(std::move(made.model));
  ASSERT_TRUE(placement);
  ASSERT_EQ(placement->rooms.size(), 1u);
  EXPECT_FALSE(placement->rooms[0].outdoors);
  EXPECT_GT(placement->rooms[0].volume, 0.8 * 7.3 * 3.1 * 5.7);
}

/// Does a probe that is not rotated have any weight there?
bool lights(const Probe& probe, const glm::dvec3& p) {
  EXPECT_EQ(probe.rotationDegrees, glm::dvec3(0.0));
  return holds(probe.influenceBox(), p);
}

TEST(PlacedRooms, InfluencesGrowOverDeepNichesAndBoxesDoNot) {
  // A room of 4.2 x 2.7 x 3.5 m with a slot in its wall at x = 0, 0.3 m high, 0.5 m wide and 1.2 m deep.
  MadeModel made;
  const Box room{glm::dvec3(-4.2, 0, -1.6), glm::dvec3(0, 2.7, 1.9)},
      slot{glm::dvec3(0, 1.1, -0.2), glm::dvec3(1.2, 1.4, 0.3)};
  for (const int axis : {1, 2}) {
    for (const bool upper : {false, true}) {
      made.side(room, axis, upper);
      made.side(slot, axis, upper);
    }
  }
  made.side(room, 0, false);
  made.side(slot, 0, true);
  for (const Box& piece :
       {Box{glm::dvec3(0, 0, -1.6), glm::dvec3(0, 2.7, -0.2)}, Box{glm::dvec3(0, 0, 0.3), glm::dvec3(0, 2.7, 1.9)},
        Box{glm::dvec3(0, 0, -0.2), glm::dvec3(0, 1.1, 0.3)}, Box{glm::dvec3(0, 1.4, -0.2), glm::dvec3(0, 2.7, 0.3)}}) {
    made.side(piece, 0, true);
  }
  made.model.materials.emplace_back().roughness = 0.1f;
  made.model.meshes.front().material = 0;
  const std::optional<Placement> placement = placedIn(std::move(made.model));
  ASSERT_TRUE(placement);
  ASSERT_EQ(placement->rooms.size(), 1u);
  ASSERT_FALSE(placement->probes.empty());
  const Probe& probe = placement->probes.front().probe;
  EXPECT_NEAR(probe.box.max.x, 0.0, 0.15) << "the box follows the wall";
  EXPECT_TRUE(lights(probe, {1.05, 1.1, 0.1})) << "the slot's floor";
  EXPECT_LT(placement->bareAfter, 0.005);
}

TEST(PlacedRooms, WhatIsSeenOutsideHasAProbeBelowAllOthers) {
  // A room of 4.7 x 2.7 x 3.4 m with a door to a lawn, where a wall stands 7 m away.
  MadeModel made;
  const Box room{glm::dvec3(-2.1, 0, -3.4), glm::dvec3(2.6, 2.7, 0)};
  for (const int axis : {0, 1}) {
    made.side(room, axis, false);
    made.side(room, axis, true);
  }
  made.side(room, 2, false);
  for (const bool inside : {true, false}) {
    const double z = inside ? 0.0 : 0.2;
    for (const Box& piece :
         {Box{glm::dvec3(-2.1, 0, z), glm::dvec3(-0.3, 2.7, z)}, Box{glm::dvec3(1.2, 0, z), glm::dvec3(2.6, 2.7, z)},
          Box{glm::dvec3(-0.3, 2.2, z), glm::dvec3(1.2, 2.7, z)}}) {
      made.side(piece, 2, true, inside);
    }
  }
  made.box({glm::dvec3(-6, 0, 7.2), glm::dvec3(8, 3, 7.5)}, false);
  made.quad({-25, -0.05f, 25}, {25, -0.05f, 25}, {25, -0.05f, 0.2f}, {-25, -0.05f, 0.2f});
  made.model.materials.emplace_back().roughness = 0.1f;
  made.model.meshes.front().material = 0;
  const std::optional<Placement> placement = placedIn(std::move(made.model));
  ASSERT_TRUE(placement);
  const auto outside = std::find_if(placement->probes.begin(), placement->probes.end(),
                                    [](const PlacedProbe& each) { return each.surroundings; });
  ASSERT_NE(outside, placement->probes.end());
  EXPECT_EQ(outside->probe.name, "surroundings");
  EXPECT_GT(outside->probe.origin.z, 0.2) << "it is captured outside";
  EXPECT_TRUE(lights(outside->probe, {0.5, -0.05, 3.0}));
  EXPECT_TRUE(lights(outside->probe, {0.5, 1.4, 7.2}));
  for (const PlacedProbe& each : placement->probes) {
    if (each.surroundings) continue;
    EXPECT_GT(each.probe.importance, outside->probe.importance) << each.probe.name;
  }
  EXPECT_LT(placement->bareAfter, 0.005);
}

TEST(PlacedRooms, ProbesAreCapturedAsTheScenesOwn) {
  Probe own;
  own.name = "mine";
  own.origin = {11.0, 1.3, 1.2};
  own.box = {glm::dvec3(9.6, 0, 0), glm::dvec3(15.6, 2.7, 3.1)};
  own.bounces = 4;
  own.faceSize = 128;
  own.technique = "footprint4";
  const std::optional<Placement> placement = placedIn(threeRooms().model, {own});
  ASSERT_TRUE(placement);
  ASSERT_FALSE(placement->probes.empty());
  for (const PlacedProbe& placed : placement->probes) {
    EXPECT_EQ(placed.probe.bounces, 4) << placed.probe.name;
    EXPECT_EQ(placed.probe.faceSize, 128) << placed.probe.name;
    EXPECT_EQ(placed.probe.technique, "footprint4") << placed.probe.name;
  }
}

TEST(PlacedRooms, TerrainAndASingleWallAreLeftOpen) {
  MadeModel terrain;
  const auto height = [](int x, int z) { return 0.6f * static_cast<float>((7 * x * x + 3 * z * x + z) % 5); };
  for (int x = -6; x < 6; ++x) {
    for (int z = -6; z < 6; ++z) {
      const auto at = [&](int i, int k) { return glm::vec3(3 * (x + i), height(x + i, z + k), 3 * (z + k)); };
      terrain.quad(at(0, 0), at(0, 1), at(1, 1), at(1, 0));
    }
  }
  MadeModel wall;
  wall.box({glm::dvec3(-3.5, 0, 0), glm::dvec3(3, 2.6, 0.2)}, false);
  for (MadeModel* each : {&terrain, &wall}) {
    const std::optional<Placement> placement = placedIn(std::move(each->model));
    ASSERT_TRUE(placement);
    EXPECT_TRUE(placement->probes.empty());
    ASSERT_EQ(placement->remarks.size(), 1u);
    EXPECT_FALSE(placement->remarks[0].empty());
  }
}

TEST(PlacedRooms, ARoomInARoomHasAProbeOfItsOwn) {
  MadeModel made;
  made.box({glm::dvec3(-8, 0, -7), glm::dvec3(9, 5.5, 6)}, true);
  const Box outside{glm::dvec3(-2.7, 0, -2.4), glm::dvec3(2.9, 2.9, 2.2)},
      inside{glm::dvec3(-2.6, 0, -2.3), glm::dvec3(2.8, 2.8, 2.1)};
  made.box(inside, true);
  for (const int axis : {0, 2}) {
    made.side(outside, axis, false, false);
    made.side(outside, axis, true, false);
  }
  made.side(outside, 1, true, false);
  made.model.materials.emplace_back().roughness = 0.1f;
  made.model.meshes.front().material = 0;
  const std::optional<Placement> placement = placedIn(std::move(made.model));
  ASSERT_TRUE(placement);
  ASSERT_EQ(placement->rooms.size(), 2u);
  const auto inner = std::find_if(placement->probes.begin(), placement->probes.end(),
                                  [](const PlacedProbe& each) { return each.room == 1; });
  ASSERT_NE(inner, placement->probes.end());
  const glm::dvec3 size = inner->probe.box.size();
  EXPECT_LT(size.x * size.y * size.z, 1.3 * 5.4 * 2.8 * 4.4) << "as large as the inner room";
  const auto around = std::find_if(placement->probes.begin(), placement->probes.end(),
                                   [](const PlacedProbe& each) { return each.room == 0; });
  ASSERT_NE(around, placement->probes.end());
  EXPECT_GE(inner->probe.importance, around->probe.importance);
}

/// Rooms of 4 and 4.4 m along x at the floor, 2.7 m high and 2.3 m deep, divided by a wall that leans over to x. Its
/// door is 0.9 m wide and ends 0.65 m below the ceiling. `unit`: one metre.
MadeModel roomsWithALeaningWall(float unit) {
  MadeModel made;
  const auto at = [unit](float x, float y, float z) { return unit * glm::vec3(x, y, z); };
  made.box({glm::dvec3(0.0), glm::dvec3(at(8.6f, 2.7f, 2.3f))}, true);
  const float low[3][2] = {{0.0f, 0.0f}, {0.0f, 1.5f}, {2.05f, 0.6f}},
              high[3][2] = {{2.7f, 0.6f}, {2.7f, 2.3f}, {2.7f, 1.5f}};
  const auto wall = [&](float x, float y, float z) { return at(x + 0.5f * y, y, z); };
  for (int piece = 0; piece < 3; ++piece) {
    const auto [y0, z0] = low[piece];
    const auto [y1, z1] = high[piece];
    made.quad(wall(4.0f, y0, z0), wall(4.0f, y0, z1), wall(4.0f, y1, z1), wall(4.0f, y1, z0));
    made.quad(wall(4.2f, y0, z0), wall(4.2f, y1, z0), wall(4.2f, y1, z1), wall(4.2f, y0, z1));
  }
  made.quad(wall(4.0f, 0, 0.6f), wall(4.0f, 2.05f, 0.6f), wall(4.2f, 2.05f, 0.6f), wall(4.2f, 0, 0.6f));
  made.quad(wall(4.0f, 0, 1.5f), wall(4.2f, 0, 1.5f), wall(4.2f, 2.05f, 1.5f), wall(4.0f, 2.05f, 1.5f));
  made.quad(wall(4.0f, 2.05f, 0.6f), wall(4.0f, 2.05f, 1.5f), wall(4.2f, 2.05f, 1.5f), wall(4.2f, 2.05f, 0.6f));
  made.model.materials.emplace_back().roughness = 0.15f;
  made.model.meshes.front().material = 0;
  return made;
}

TEST(PlacedRooms, ADoorInALeaningWallIsADoor) {
  for (const float unit : {1.0f, 1000.0f}) {
    SCOPED_TRACE(unit);
    const std::optional<Placement> placement = placedIn(roomsWithALeaningWall(unit).model);
    ASSERT_TRUE(placement);
    EXPECT_EQ(placement->rooms.size(), 2u);
  }
}

// Two halls of 2.7 m whose ends, 2.1 m high, lie side by side. An opening between them reaches the ceiling there: it is
// no door, whatever the height of the halls farther on.
TEST(PlacedRooms, AnOpeningUpToTheCeilingIsNoDoor) {
  MadeModel made;
  const Box lowA{glm::dvec3(0, 0, 0), glm::dvec3(4, 2.1, 2.4)}, highA{glm::dvec3(0, 0, 2.4), glm::dvec3(4, 2.7, 6)},
      lowB{glm::dvec3(4.2, 0, 0), glm::dvec3(8.3, 2.1, 2.4)}, highB{glm::dvec3(4.2, 0, -3.7), glm::dvec3(8.3, 2.7, 0)},
      passage{glm::dvec3(4, 0, 0.7), glm::dvec3(4.2, 2.1, 1.7)};
  for (const Box& box : {lowA, highA, lowB, highB, passage}) {
    made.side(box, 1, false);
    made.side(box, 1, true);
  }
  for (const bool upper : {false, true}) {
    made.side(highA, 0, upper);
    made.side(highB, 0, upper);
    made.side(passage, 2, upper);
  }
  made.side(lowA, 0, false);
  made.side(lowB, 0, true);
  made.side(lowA, 2, false);
  made.side(lowB, 2, true);
  made.side(highA, 2, true);
  made.side(highB, 2, false);
  made.side({glm::dvec3(0, 2.1, 2.4), highA.max}, 2, false);
  made.side({glm::dvec3(4.2, 2.1, -3.7), highB.max}, 2, true);
  for (const auto& [from, to] : {std::pair(0.0, 0.7), std::pair(1.7, 2.4)}) {
    made.side({glm::dvec3(0, 0, from), glm::dvec3(4, 2.1, to)}, 0, true);
    made.side({glm::dvec3(4.2, 0, from), glm::dvec3(8.3, 2.1, to)}, 0, false);
  }
  made.model.materials.emplace_back().roughness = 0.15f;
  made.model.meshes.front().material = 0;
  const std::optional<Placement> placement = placedIn(std::move(made.model));
  ASSERT_TRUE(placement);
  EXPECT_EQ(placement->rooms.size(), 1u);
}

TEST(PlacedRooms, GlassAllAroundIsNoRoom) {
  MadeModel made = threeRooms();
  made.model.materials.front().transmission = 1.0f;
  const std::optional<Placement> placement = placedIn(std::move(made.model));
  ASSERT_TRUE(placement);
  EXPECT_TRUE(placement->rooms.empty());
  ASSERT_EQ(placement->remarks.size(), 1u);
  EXPECT_EQ(placement->remarks[0].english().rfind("open: ", 0), 0u);
}

}  // namespace
}  // namespace boxprobe
