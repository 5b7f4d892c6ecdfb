// What is made for the probes of a scene, in which order, and after which edit: the plan alone, without OpenGL.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "filters/vtk/gl/map_bytes.h"
#include "tests/unit/planned_scene.h"

namespace boxprobe::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double kFar = 100.0;
const Box kEverywhere{glm::dvec3(-2.0 * kFar), glm::dvec3(2.0 * kFar)};

/// Two probes that each show an object the other lights, and a third far off with an object of its own, which sees no
/// further than its room.
struct ThreeRooms : PlannedScene {
  explicit ThreeRooms(int bounces) {
    scene.probes = {probeAt("near", {0, 0, 0}, 1.2, bounces), probeAt("next", {2, 0, 0}, 1.2, bounces),
                    probeAt("far", {kFar, 0, 0}, 1.2, bounces)};
    for (Probe& probe : scene.probes) probe.farDistance = 10.0;
    objects = {cubeAt("a", {0, -1, 0}, 0.1), cubeAt("b", {2, -1, 0}, 0.1), cubeAt("c", {kFar, -1, 0}, 0.1)};
    update();
  }
};

TEST(ProbePlan, TheSkyComesFirstThenOneBounceOfAllBeforeTheNext) {
  ThreeRooms rooms(3);
  rooms.scene.probes[1].bounces = 2;
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("sky", "bounce:near1", "bounce:next1", "bounce:far1", "bounce:near2",
                                        "bounce:next2", "bounce:far2", "bounce:near3", "bounce:far3"));
  EXPECT_EQ(rooms.plan.jobs()[0].faceSize, 64);
  EXPECT_EQ(rooms.plan.jobs()[1].faceSize, 32);
  EXPECT_EQ(rooms.makeAll().size(), 9u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(rooms.entries[i].shown, rooms.entries[i].wanted);
  rooms.update();
  EXPECT_THAT(rooms.jobs(), IsEmpty()) << "nothing changed";
}

TEST(ProbePlan, WhatShowsNothingIsCapturedInFewTexelsFirst) {
  ThreeRooms rooms(2);
  rooms.scene.probes[0].faceSize = 128;
  rooms.scene.probes[2].faceSize = 256;
  rooms.update();
  const auto finals = rooms.jobs();
  rooms.plan.setCoarseFirst(true);
  rooms.replan();
  auto expected = finals;
  expected.insert(expected.begin() + 1, {"coarse:near", "coarse:far"});  // next's own faces are as small
  EXPECT_EQ(rooms.jobs(), expected);
  EXPECT_EQ(rooms.plan.jobs()[1].faceSize, 64);
  EXPECT_TRUE(rooms.plan.coarsePending());
  rooms.entries[0].shown = "something";
  rooms.replan();
  expected.erase(expected.begin() + 1);
  EXPECT_EQ(rooms.jobs(), expected) << "what shows something waits for its own";
  rooms.scene.probes[1].mode = ProbeMode::Realtime;
  rooms.update();
  EXPECT_FALSE(rooms.plan.coarsePending()) << "it would see them";
}

TEST(ProbePlan, AnImageOfTheSkyIsCapturedFiner) {
  ThreeRooms rooms(1);
  for (const auto& [columns, faceSize] : {std::pair(4096, 256), {1024, 256}, {1000, 256}, {512, 128}, {64, 64}}) {
    rooms.plan.wantSky("an image", columns);
    rooms.replan();
    EXPECT_EQ(rooms.plan.jobs()[0].faceSize, faceSize) << columns;
  }
  EXPECT_EQ(rooms.plan.jobs()[0].key, "an image");
}

TEST(ProbePlan, AProbeThatNoObjectUsesIsNotPlanned) {
  ThreeRooms rooms(2);
  rooms.notDrawnByProbes = {"a", "b"};
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("sky", "bounce:far1", "bounce:far2"));
  EXPECT_EQ(rooms.entries[0].wanted, "") << "nobody asks what it shows";
  EXPECT_EQ(rooms.plan.state("near"), BakeState::NotUsed);
  EXPECT_EQ(rooms.plan.state("far"), BakeState::Stale);
  EXPECT_EQ(rooms.plan.state("nobody"), BakeState::NotUsed);
  rooms.notDrawnByProbes.clear();
  rooms.hidden = {"a", "b"};
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("sky", "bounce:far1", "bounce:far2"));
  rooms.hidden.clear();
  // One that is used shows what an unused one lights: of that the bounces before are needed, and no more.
  rooms.notDrawnByProbes = {"b"};
  rooms.update();
  EXPECT_THAT(rooms.jobs(),
              ElementsAre("sky", "bounce:near1", "bounce:next1", "bounce:far1", "bounce:near2", "bounce:far2"));
}

TEST(ProbePlan, NothingThatTakesLightNeedsNoSky) {
  ThreeRooms rooms(2);
  for (PlacedObject& object : rooms.objects) object.unlit = true;
  rooms.update();
  EXPECT_THAT(rooms.jobs(), IsEmpty());
}

TEST(ProbePlan, OfManyProbesThoseAreMadeThatTheFrameShows) {
  PlannedScene row;
  for (int i = 0; i < 8; ++i) {
    const std::string name(1, static_cast<char>('a' + i));
    row.scene.probes.push_back(probeAt(name, {kFar * i, 0, 0}, 1.0));
    row.objects.push_back(cubeAt(name, {kFar * i, 0, 0}, 0.5));
  }
  row.entries.setSeen(std::vector<std::size_t>{2});
  row.update();
  EXPECT_EQ(row.jobs().size(), 1u + 8u) << "eight are few";
  row.scene.probes.push_back(probeAt("i", {kFar * 8, 0, 0}, 1.0));
  row.objects.push_back(cubeAt("i", {kFar * 8, 0, 0}, 0.5));
  row.update();
  EXPECT_THAT(row.jobs(), ElementsAre("sky", "bounce:c1"));
  EXPECT_FALSE(row.entries.setSeen(std::vector<std::size_t>{2, 2}));
  EXPECT_TRUE(row.entries.setSeen(std::vector<std::size_t>{8, 2}));
  row.update();
  EXPECT_THAT(row.jobs(), ElementsAre("sky", "bounce:c1", "bounce:i1"));
  EXPECT_TRUE(row.entries.setSeen(std::nullopt));
  row.update();
  EXPECT_EQ(row.jobs().size(), 1u + 9u) << "nobody knows what is seen";
}

TEST(ProbePlan, OfOneBounceAMovedBoxLeavesNoJobAndAMovedOriginMakesOne) {
  ThreeRooms rooms(1);
  rooms.makeAll();
  Probe& near = rooms.scene.probes[0];
  near.box.max.y += 0.3;
  near.influence = Box{{-3, -3, -3}, {3, 3, 3}};  // lights what it did not light before
  near.blendDistance.min.x = 0.2;
  near.technique = "sphere";
  near.importance = 3.0;
  near.intensity = 0.5;
  rooms.scene.probes[2].influence = kEverywhere;
  rooms.update();
  EXPECT_THAT(rooms.jobs(), IsEmpty());
  near.origin.x += 0.25;
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("bounce:near1"));
}

// Reflections within reflections: whatever changes how a probe lights, and whom.
TEST(ProbePlan, LaterBouncesFollowBoxesAndTechniques) {
  using Edit = void (*)(Probe&);
  const std::vector<std::pair<const char*, Edit>> edits = {
      {"box", [](Probe& probe) { probe.box.max.y += 0.3; }},
      {"influence",
       [](Probe& probe) {
         probe.influence = Box{{-1.3, -1.2, -1.4}, {1.2, 1.5, 1.1}};
       }},
      {"blendDistance", [](Probe& probe) { probe.blendDistance.min.x = 0.2; }},
      {"technique", [](Probe& probe) { probe.technique = "sphere"; }},
      {"parameters", [](Probe& probe) { probe.parameters["budget"] = 0.07; }},
      {"projection", [](Probe& probe) { probe.projection = false; }},
      {"importance", [](Probe& probe) { probe.importance = 3.0; }},
      {"intensity", [](Probe& probe) { probe.intensity = 0.5; }},
      {"bevel",
       [](Probe& probe) {
         probe.bevel = Bevel{0.2, 0.1};
       }},
      {"occlusion",
       [](Probe& probe) {
         probe.occlusion = BoxOcclusion{0.3, 1.2, 0.7};
       }},
      {"lattice",
       [](Probe& probe) {
         probe.lattice = ProbeLattice{true, 0.7};
       }},
      {"no lattice", [](Probe& probe) { probe.lattice = ProbeLattice{false}; }}};
  for (const auto& [name, edit] : edits) {
    SCOPED_TRACE(name);
    ThreeRooms rooms(3);
    rooms.makeAll();
    const Probe before = rooms.scene.probes[0];
    edit(rooms.scene.probes[0]);
    rooms.update();
    EXPECT_THAT(rooms.jobs(), ElementsAre("bounce:near2", "bounce:next2", "bounce:near3", "bounce:next3"));
    rooms.scene.probes[0] = before;
    rooms.update();
    EXPECT_THAT(rooms.jobs(), IsEmpty()) << "as it was";
  }
}

TEST(ProbePlan, LaterBouncesAreThoseOfAFreshStart) {
  ThreeRooms rooms(2);
  rooms.makeAll();
  rooms.scene.probes[2].influence = kEverywhere;  // lights what the others show
  rooms.update();
  EXPECT_THAT(rooms.makeAll(), ElementsAre("bounce:near2", "bounce:next2", "bounce:far2"));
  ThreeRooms fresh(2);
  fresh.scene = rooms.scene;
  fresh.update();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(rooms.entries[i].shown, fresh.entries[i].wanted) << i;
  rooms.scene.probes[2].influence.reset();
  rooms.scene.probes[2].origin.x += 0.25;
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("bounce:far1", "bounce:far2")) << "no bounce of another shows it any more";
}

TEST(ProbePlan, WhileABoxIsDraggedBouncesStayAndFollowAtItsEnd) {
  ThreeRooms rooms(2);
  rooms.makeAll();
  rooms.plan.setInteractive(true);
  Probe& far = rooms.scene.probes[2];
  for (const double half : {30.0, 150.0}) {
    far.box = {far.origin - half, far.origin + half};  // at last it lights what the others show
    far.technique = "sphere";
    rooms.update();
    EXPECT_THAT(rooms.jobs(), IsEmpty());
  }
  rooms.plan.setInteractive(false);
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("bounce:near2", "bounce:next2", "bounce:far2"));
}

// A host that never tells of a drag: bounces stay as they were captured.
TEST(ProbePlan, WhatDoesNotFollowBoxesKeepsItsBounces) {
  ThreeRooms rooms(2);
  rooms.plan.setFollowsBoxes(false);
  rooms.update();
  rooms.makeAll();
  rooms.scene.probes[0].box.max.y += 0.3;
  rooms.scene.probes[0].technique = "sphere";
  rooms.update();
  EXPECT_THAT(rooms.jobs(), IsEmpty());
  rooms.scene.probes[2].influence = kEverywhere;
  rooms.update();
  EXPECT_THAT(rooms.jobs(), IsEmpty()) << "they were made as the boxes were";

  rooms.scene.probes[0].origin.x += 0.25;
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("bounce:near1", "bounce:near2", "bounce:next2")) << "next1 is there";
  const std::string before = rooms.entries[0].shown;
  rooms.makeAll();
  rooms.cache.clear();
  rooms.scene.probes[0].origin.x -= 0.25;
  rooms.update();
  EXPECT_NE(rooms.entries[0].wanted, before) << "maps that are gone are made by the boxes as they are";
}

// Where lattices bring the light of the sky, a first capture has none of it if another follows. So another does,
// whatever is lit: a box that is moved away does not leave the first one as the last.
TEST(ProbePlan, BeforeTheSkyIsNeverTheLastBounce) {
  ThreeRooms rooms(2);
  CaptureWorld world = rooms.plan.world();
  for (CaptureObject& object : world.objects) object.probes.clear();
  world.lattices = true;
  for (const bool sky : {false, true}) {
    world.latticeSky = sky ? world.sky : std::string();
    rooms.plan.setWorld(world);
    rooms.plan.updateKeys();
    EXPECT_EQ(rooms.plan.bounces().key(0, 2) != rooms.plan.bounces().key(0, 1), sky);
    EXPECT_EQ(rooms.plan.faceKey(0, 2, 3) != rooms.plan.faceKey(0, 1, 3), sky);
  }
}

// It is another picture than the only one of a single bounce, also where another run makes those that follow. But not
// of a probe without nodes, which has the sky's light from its map.
TEST(ProbePlan, BeforeTheSkyIsNoSingleBounce) {
  ThreeRooms rooms(3);
  CaptureWorld world = rooms.plan.world();
  world.lattices = true;
  for (const int turn : {0, 1, 2}) {
    const bool sky = turn == 1;
    world.latticeSky = turn == 0 ? std::string() : world.sky;
    if (turn == 2) rooms.scene.probes[0].lattice = ProbeLattice{false};
    rooms.scene.probes[0].bounces = 3;
    rooms.plan.setCutShort({});
    rooms.plan.setWorld(world);
    rooms.plan.updateKeys();
    const std::string first = rooms.plan.bounces().key(0, 1), face = rooms.plan.faceKey(0, 1, 2);
    rooms.scene.probes[0].bounces = 1;
    rooms.plan.updateKeys();
    EXPECT_EQ(rooms.plan.bounces().finalKey(0) != first, sky);
    EXPECT_EQ(rooms.plan.faceKey(0, 1, 2) != face, sky);
    rooms.plan.setCutShort({"near"});
    rooms.plan.setWorld(world);
    rooms.plan.updateKeys();
    EXPECT_EQ(rooms.plan.bounces().finalKey(0), first);
    EXPECT_EQ(rooms.plan.faceKey(0, 1, 2), face);
  }
}

TEST(ProbePlan, AnEditMakesWhatShowsItAgain) {
  ThreeRooms rooms(1);
  rooms.makeAll();
  rooms.objects[2].contentKey = "another geometry";
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("bounce:far1"));
  rooms.makeAll();
  rooms.scene.materials["a material"].emissive = glm::vec3(1.0f);
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("bounce:near1", "bounce:next1"));
  rooms.makeAll();
  rooms.scene.sky = SkyColor{{0.1f, 0.2f, 0.3f}};
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("sky", "bounce:near1", "bounce:next1", "bounce:far1"));
  rooms.makeAll();
  rooms.scene.lights.emplace_back();
  rooms.scene.probes[2].hides = {"c"};
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("bounce:near1", "bounce:next1", "bounce:far1"));
}

// Only +X shows something a probe lights: the other five faces of a further bounce are those of the one before.
TEST(ProbePlan, ABounceKeepsFacesThatShowNothingAProbeLights) {
  PlannedScene world;
  world.scene.probes = {probeAt("probe", {0, 0, 0}, 3.0, 3)};
  world.objects = {cubeAt("mirror", {2, 0, 0}, 0.2), cubeAt("wall", {-2, 0, 0}, 0.2, false)};
  world.update();
  EXPECT_THAT(world.makeAll(), ElementsAre("sky", "bounce:probe1", "bounce:probe2", "bounce:probe3"));
  ASSERT_EQ(world.facesMade.size(), 3u);
  EXPECT_EQ(PlannedScene::kept(world.facesMade[0], world.facesMade[1]), "x=====");
  EXPECT_EQ(PlannedScene::kept(world.facesMade[1], world.facesMade[2]), "x=====");
  // An edit of the wall leaves the five that do not show it, of each bounce.
  world.objects[1].contentKey = "another wall";
  const std::vector<FaceKeys> before = world.facesMade;
  world.update();
  EXPECT_EQ(world.makeAll().size(), 3u);
  ASSERT_EQ(world.facesMade.size(), 6u);
  EXPECT_EQ(PlannedScene::kept(before[0], world.facesMade[3]), "=x====");
  EXPECT_EQ(PlannedScene::kept(before[1], world.facesMade[4]), "xx====") << "the mirror shows another first bounce";
  // The frosty filter blurs the capture: no face of it is used again.
  world.scene.probes[0].filter = FilterKind::Gaussian;
  world.update();
  world.makeAll();
  EXPECT_EQ(PlannedScene::kept(world.facesMade.back(), world.facesMade.back()), "xxxxxx");
}

TEST(ProbePlan, ABounceThatShowsNothingNewIsTheOneBefore) {
  PlannedScene world;
  world.scene.probes = {probeAt("probe", {0, 0, 0}, 3.0, 5)};
  world.objects = {cubeAt("behind", {0, 0, 2.9}, 0.05), cubeAt("wall", {-2, 0, 0}, 0.2, false)};
  world.scene.probes[0].hides = {"behind"};
  world.update();
  EXPECT_THAT(world.jobs(), ElementsAre("sky", "bounce:probe1"));
}

TEST(ProbePlan, TargetsAreMadeWhetherUsedOrNotAndNothingElse) {
  ThreeRooms rooms(1);
  rooms.notDrawnByProbes = {"c"};
  rooms.scene.probes[0].mode = ProbeMode::Realtime;
  rooms.plan.setTargets({"far", "near"});
  rooms.update();
  EXPECT_THAT(rooms.jobs(), ElementsAre("sky", "bounce:far1")) << "a realtime probe is not baked";
  rooms.makeAll();
  EXPECT_EQ(rooms.plan.state("far"), BakeState::UpToDate);
  rooms.scene.sky = SkyColor{};
  rooms.plan.setTargets({"nobody"});
  rooms.update();
  EXPECT_THAT(rooms.jobs(), IsEmpty()) << "not even a sky";
}

TEST(ProbePlan, WhatIsAskedForAgainIsMadeAlthoughNothingUsesIt) {
  ThreeRooms rooms(1);
  rooms.notDrawnByProbes = {"c"};
  rooms.update();
  rooms.makeAll();
  rooms.entries[2].again = true;
  rooms.update();
  EXPECT_THAT(rooms.makeAll(), ElementsAre("bounce:far1"));
  EXPECT_FALSE(rooms.entries[2].again);
  EXPECT_THAT(rooms.jobs(), IsEmpty());
}

TEST(ProbePlan, NothingIsMadeWhileProbesAreOff) {
  ThreeRooms rooms(1);
  rooms.plan.begin(rooms.plan.jobs()[1]);
  rooms.plan.setEnabled(false);
  rooms.replan();
  EXPECT_THAT(rooms.jobs(), IsEmpty());
  EXPECT_FALSE(rooms.plan.current()) << "nor finished";
  rooms.scene.probes[0].mode = ProbeMode::Realtime;
  rooms.plan.begin({JobKind::Realtime, "near", 1, {}, 32});
  rooms.update();
  EXPECT_FALSE(rooms.plan.current());
}

TEST(ProbePlan, AProbeKeepsItsEntryThroughAChangeOfTheList) {
  ThreeRooms rooms(2);
  rooms.makeAll();
  const std::string far = rooms.entries[2].shown;
  std::swap(rooms.scene.probes[0], rooms.scene.probes[2]);
  EXPECT_FALSE(rooms.entries.matched());
  const auto origins = rooms.entries.match();
  ASSERT_TRUE(origins);
  EXPECT_THAT(*origins, ElementsAre(2u, 1u, 0u));
  EXPECT_EQ(rooms.entries[0].shown, far);
  EXPECT_FALSE(rooms.entries.match()) << "the same list";
  rooms.update();
  EXPECT_THAT(rooms.jobs(), IsEmpty()) << "the order is nothing a picture shows";
  rooms.scene.probes[0].name = "renamed";
  rooms.update();
  EXPECT_THAT(rooms.jobs(), IsEmpty()) << "its maps are found again by key";
  EXPECT_EQ(rooms.entries[0].shown, far);
  rooms.scene.probes.erase(rooms.scene.probes.begin() + 1);
  rooms.update();
  EXPECT_EQ(rooms.entries.size(), 2u);
  EXPECT_EQ(rooms.entries[0].shown, far);
  EXPECT_THAT(rooms.jobs(), ElementsAre("bounce:near2")) << "it showed the one that is gone";
}

void lightByLattices(ThreeRooms& rooms) {
  rooms.update();
  CaptureWorld world = rooms.plan.world();
  world.lattices = true;
  rooms.plan.setWorld(world);
  rooms.plan.updateKeys();
  rooms.replan();
}

// Nodes half a unit apart, 16 along an axis at most, 40 numbers each.
TEST(ProbePlan, LatticesAreCountedBeforeAnythingIsMade) {
  ThreeRooms rooms(1);
  rooms.scene.probes[1].box.max = rooms.scene.probes[1].box.min + glm::dvec3(90.0, 4.2, 31.0);
  lightByLattices(rooms);
  std::size_t nodes = 0;
  for (const Probe& probe : rooms.scene.probes) {
    std::size_t of = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const double size = probe.box.max[axis] - probe.box.min[axis];
      of *= static_cast<std::size_t>(std::min(std::max(std::floor(2.0 * size + 0.5) + 1.0, 2.0), 16.0));
    }
    nodes += of;
  }
  EXPECT_GT(nodes, 16u * 9u * 16u);
  // Beside them the texture, whose tiles of 16 x 16 x 16 nodes in half floats are doubled: four for three probes.
  const std::size_t seen = 12345, lattices = nodes * 40 * 4 + std::size_t{4} * 16 * 16 * 16 * 40 * 2;
  const std::size_t all = 3 * probeMapsBytes(32, true) + captureScratchBytes(32) + lattices;
  EXPECT_TRUE(rooms.plan.checkMemory(all));
  EXPECT_FALSE(rooms.plan.checkMemory(all - 1));
  EXPECT_THAT(rooms.plan.memoryError(), HasSubstr(memoryText(lattices) + " of lattices need "));
  EXPECT_TRUE(rooms.plan.checkMemory(all + seen, seen)) << "visibilities of lamps";
  EXPECT_FALSE(rooms.plan.checkMemory(all + seen - 1, seen));
  EXPECT_THAT(rooms.plan.memoryError(), HasSubstr(memoryText(all + seen) + " of texture memory"));
}

// As many nodes as a lattice can have: what is asked for stands in the message before anything is captured.
TEST(ProbePlan, ThreeHundredLatticesOfSixteenCubedAreSaidBefore) {
  ThreeRooms rooms(1);
  const Probe pattern = rooms.scene.probes[0];
  rooms.scene.probes.clear();
  rooms.objects.clear();
  for (int i = 0; i < 300; ++i) {
    const double at = 20.0 * i;
    Probe probe = pattern;
    probe.name = "hall " + std::to_string(i);
    probe.origin = {at, 0, 0};
    probe.box = {{at - 4.1, -4.2, -4.3}, {at + 4.4, 4.5, 4.6}};
    rooms.scene.probes.push_back(probe);
    rooms.objects.push_back(cubeAt("cube " + std::to_string(i), {at, -1, 0}, 0.1));
  }
  lightByLattices(rooms);
  const std::size_t one = std::size_t{16} * 16 * 16 * 40;
  const std::size_t lattices = 300 * one * 4 + 512 * one * 2;
  const std::size_t all = 300 * probeMapsBytes(32, true) + captureScratchBytes(32) + lattices;
  EXPECT_TRUE(rooms.plan.checkMemory(all));
  EXPECT_FALSE(rooms.plan.checkMemory(all - 1));
  EXPECT_THAT(rooms.plan.memoryError(), HasSubstr("the maps of 300 probes with faces of up to 32 texels and 348 MB of "
                                                  "lattices need "));
}

TEST(ProbePlan, MapsThatDoNotFitAreNotMade) {
  ThreeRooms rooms(2);
  EXPECT_TRUE(rooms.plan.memoryUnchecked());
  const std::size_t one = probeMapsBytes(32, true), scratch = captureScratchBytes(32);
  EXPECT_TRUE(rooms.plan.checkMemory(6 * one + scratch)) << "the bounce before the last is there at the same time";
  EXPECT_FALSE(rooms.plan.memoryUnchecked());
  EXPECT_EQ(rooms.plan.memoryError(), "");
  EXPECT_FALSE(rooms.plan.checkMemory(6 * one + scratch - 1));
  EXPECT_THAT(rooms.plan.memoryError(), HasSubstr("the maps of 3 probes with faces of up to 32 texels need "));
  EXPECT_THAT(rooms.plan.memoryError(), HasSubstr(memoryText(6 * one + scratch)));
  EXPECT_THAT(rooms.plan.memoryError(), Not(HasSubstr("\n")));
  rooms.notDrawnByProbes = {"c"};
  rooms.update();
  EXPECT_EQ(rooms.plan.memoryError(), "") << "another plan";
  EXPECT_TRUE(rooms.plan.memoryUnchecked());
  EXPECT_TRUE(rooms.plan.checkMemory(4 * one + scratch)) << "a probe that is not used needs none";
  rooms.makeAll();
  EXPECT_FALSE(rooms.plan.memoryUnchecked()) << "nothing is planned";
  rooms.notDrawnByProbes = {"b", "c"};
  rooms.update();
  EXPECT_TRUE(rooms.plan.checkMemory(2 * one + scratch)) << "one that has maps but is used no more";
  EXPECT_FALSE(rooms.plan.checkMemory(2 * one + scratch - 1));
}

}  // namespace
}  // namespace boxprobe::test
