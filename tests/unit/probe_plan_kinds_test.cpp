// Planned jobs that are no plain bounces: maps from files and pictures, drags, realtime probes; and what becomes of a
// job under way. Without OpenGL.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "filters/io/image/image_file.h"
#include "filters/vtk/gl/map_bytes.h"
#include "tests/unit/planned_scene.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A floor that two probes light and both show, and a lamp that moves.
struct TwoProbes : PlannedScene {
  explicit TwoProbes(int bounces = 1) {
    scene.probes = {probeAt("left", {-1, 0, 0}, 2.0, bounces), probeAt("right", {1, 0, 0}, 2.0, bounces)};
    objects = {cubeAt("floor", {0, -1.5, 0}, 0.2), cubeAt("lamp", {-9, 0, 0}, 0.5, false)};
    objects[1].dynamic = true;
    update();
  }
};

class PlannedFiles : public TemporaryFolder {
 protected:
  void save(const Probe& probe, const BakeRecord& record) const {
    BakedMaps maps;
    maps.radiance = CubeMap(16, 1);
    BakeFolder::save(folder_.string(), probe, record, maps, {"test", {}});
  }
};

TEST_F(PlannedFiles, AFileIsReadInPlaceOfAllBouncesOfItsProbe) {
  {
    TwoProbes first(3);
    first.makeAll();
    for (const Probe& probe : first.scene.probes) save(probe, first.plan.record(probe.name).value());
    save(Probe{}, BakeRecord{"unused", "unused", {}, {}});
    Probe sky;
    sky.name.clear();
    save(sky, first.plan.record("").value());
  }
  TwoProbes world(3);
  world.sources.folder = BakeFolder(folder_.string());
  const Box elsewhere{{8, 8, 8}, {9, 9, 9}};
  world.scene.probes[0].influence = elsewhere;
  world.update();
  EXPECT_THAT(world.jobs(), ElementsAre("file", "bounce:right1", "bounce:right2", "bounce:right3"))
      << "left is not used, whose light its bounces had when it was baked";
  world.scene.probes[0].influence.reset();
  world.scene.probes[1].influence = elsewhere;
  world.update();
  EXPECT_THAT(world.jobs(), ElementsAre("file", "bounce:left1", "bounce:left2", "bounce:left3"));
  world.scene.probes[1].influence.reset();
  world.update();
  EXPECT_THAT(world.jobs(), ElementsAre("file", "file:left", "file:right"));
  // A file that was damaged since it was looked at is as good as none.
  world.sources.folder.forget(world.entries[1].wanted);
  world.update();
  EXPECT_THAT(world.jobs(), ElementsAre("file", "file:left", "bounce:left1", "bounce:right1", "bounce:left2",
                                        "bounce:right2", "bounce:right3"));
  EXPECT_EQ(world.plan.jobs()[1].bounce, 3);
  EXPECT_EQ(world.plan.state("left"), BakeState::FromFile) << "as it will be";
  EXPECT_FALSE(world.plan.record("left"));
  world.makeAll();
  EXPECT_EQ(world.plan.state("left"), BakeState::FromFile);
  EXPECT_EQ(world.plan.state("right"), BakeState::UpToDate);
  EXPECT_EQ(world.plan.record("left")->key, world.entries[0].wanted);

  // Targets are baked: one whose file holds is not made again, another is.
  TwoProbes targets(3);
  targets.sources.folder = BakeFolder(folder_.string());
  targets.plan.setTargets({"left"});
  targets.update();
  EXPECT_THAT(targets.jobs(), IsEmpty());
  targets.sources.folder.forget(targets.entries[0].wanted);
  targets.update();
  EXPECT_THAT(targets.jobs(),
              ElementsAre("file", "bounce:left1", "bounce:right1", "bounce:left2", "bounce:right2", "bounce:left3"));
}

TEST_F(PlannedFiles, OnePictureOfSeveralProbesIsReadOnce) {
  saveExr(file("sky.exr"), ImageRgbaF{16, 8, std::vector<float>(4 * 16 * 8, 0.25f)});
  TwoProbes world(1);
  for (Probe& probe : world.scene.probes) {
    probe.mode = ProbeMode::Custom;
    probe.image = file("sky.exr");
  }
  world.scene.probes[1].imageRotationDegrees = 30.0;
  CustomPictures pictures;
  pictures.update(world.scene);
  EXPECT_NE(pictures.picture("left"), pictures.picture("right")) << "turned, it is another one";
  world.scene.probes[1].imageRotationDegrees = 0.0;
  CustomPictures equal;
  equal.update(world.scene);
  ASSERT_NE(equal.picture("left"), nullptr);
  EXPECT_EQ(equal.picture("left"), equal.picture("right"));
  equal.forget("right");
  equal.update(world.scene);
  EXPECT_NE(equal.picture("left"), equal.picture("right")) << "asked for anew: the file may have changed";
}

TEST_F(PlannedFiles, APictureIsFilteredAtItsOwnSize) {
  const int width = 256;
  const ImageRgbaF picture{width, width / 2, std::vector<float>(static_cast<std::size_t>(width * width * 2), 0.5f)};
  saveExr(file("sky.exr"), picture);
  TwoProbes world(3);
  world.scene.probes[1].mode = ProbeMode::Custom;
  world.scene.probes[1].image = file("missing.exr");
  world.update();
  EXPECT_THAT(world.sources.pictures.error(), HasSubstr("probes.right.image: "));
  EXPECT_THAT(world.jobs(), ElementsAre("sky", "bounce:left1", "bounce:left2", "bounce:left3"));
  world.scene.probes[1].image = file("sky.exr");
  world.update();
  EXPECT_EQ(world.sources.pictures.error(), "");
  EXPECT_THAT(world.jobs(), ElementsAre("sky", "picture:right", "bounce:left1", "bounce:left2", "bounce:left3"));
  const int size = world.sources.pictures.picture("right")->faceSize();
  EXPECT_NE(size, world.scene.probes[1].faceSize);
  EXPECT_EQ(world.plan.jobs()[1].faceSize, size);
  const std::size_t need = probeMapsBytes(size, false) + 2 * probeMapsBytes(32, true) + captureScratchBytes(size);
  EXPECT_TRUE(world.plan.checkMemory(need));
  EXPECT_FALSE(world.plan.checkMemory(need - 1));
  world.makeAll();
  world.scene.probes[1].origin.y += 0.1;
  world.scene.probes[1].faceSize = 16;
  world.scene.probes[1].bounces = 2;
  world.update();
  EXPECT_THAT(world.jobs(), IsEmpty()) << "it has no capture origin";
}

TEST(ProbePlanDrag, CapturesOneBounceForTheTimeBeing) {
  TwoProbes world(2);
  world.makeAll();
  world.plan.setInteractive(true);
  world.replan();
  EXPECT_THAT(world.jobs(), IsEmpty());
  world.scene.probes[0].origin.y = 0.1;
  world.update();
  EXPECT_THAT(world.jobs(), ElementsAre("drag:left", "drag:right")) << "which shows what the other lights";
  const ProbeJob drag = world.plan.jobs()[0];
  EXPECT_EQ(drag.key, world.entries[0].wanted + kDuringDrag);
  world.plan.begin(drag);
  EXPECT_EQ(world.plan.state("left"), BakeState::Capturing);
  EXPECT_FALSE(world.plan.capturesLast());
  world.scene.probes[0].origin.y = 0.2;
  world.update();
  EXPECT_TRUE(world.plan.current()) << "a picture a little late is better than none";
  EXPECT_THAT(world.makeAll(), ElementsAre("drag:left", "drag:right"));
  EXPECT_THAT(world.jobs(), IsEmpty());
  EXPECT_EQ(world.plan.state("left"), BakeState::Stale);

  world.plan.begin(drag);
  world.plan.setInteractive(false);
  world.replan();
  EXPECT_FALSE(world.plan.current()) << "what a drag captures does not count";
  EXPECT_THAT(world.jobs(), ElementsAre("bounce:left1", "bounce:left2", "bounce:right2"));
  EXPECT_TRUE(world.plan.capturesLast());
}

TEST(ProbePlanCurrent, GoesOnWhileThePlanStillWantsIt) {
  TwoProbes world(1);
  const ProbeJob left = world.plan.jobs()[1];
  ASSERT_EQ(PlannedScene::word(left), "bounce:left1");
  world.plan.begin(left);
  world.scene.probes[1].origin.y = 0.1;
  world.scene.probes[1].name = "renamed";
  world.update();
  EXPECT_TRUE(world.plan.current()) << "an edit elsewhere";
  world.scene.probes[0].origin.y = 0.1;
  world.update();
  EXPECT_FALSE(world.plan.current());
}

TEST(ProbePlanRealtime, FollowsWhatMovesAndKeepsOtherFaces) {
  TwoProbes world(1);
  world.scene.probes[0].mode = ProbeMode::Realtime;
  world.update();
  EXPECT_THAT(world.jobs(), ElementsAre("sky", "realtime:left", "bounce:right1"));
  EXPECT_EQ(world.plan.jobs()[1].key, "");
  world.makeAll();
  const FaceKeys before = world.entries[0].faces;
  world.objects[1].worldFromModel[3].y = 1.0;
  world.objects[1].boundsWorld.min.y += 1.0;
  world.objects[1].boundsWorld.max.y += 1.0;
  world.update();
  EXPECT_THAT(world.jobs(), ElementsAre("realtime:left")) << "baked probes leave out what moves";
  world.makeAll();
  EXPECT_EQ(PlannedScene::kept(before, world.entries[0].faces), "=x====");
  EXPECT_THAT(world.jobs(), IsEmpty()) << "nothing moves";

  // What it is at is completed though the scene has moved on, unless its size is another.
  world.scene.lights.emplace_back();
  world.update();
  world.plan.begin(world.plan.jobs()[0]);
  world.objects[1].worldFromModel[3].y = 2.0;
  world.update();
  EXPECT_TRUE(world.plan.current());
  world.scene.probes[0].faceSize = 64;
  world.update();
  EXPECT_FALSE(world.plan.current());
}

TEST(ProbePlanRealtime, SettlesInAsManyRoundsAsItHasBounces) {
  TwoProbes world(3);
  world.scene.probes.pop_back();
  world.scene.probes[0].mode = ProbeMode::Realtime;
  world.update();
  EXPECT_THAT(world.makeAll(), ElementsAre("sky", "realtime:left", "realtime:left", "realtime:left"));
  world.objects[0].contentKey = "another floor";
  world.update();
  EXPECT_THAT(world.makeAll(), ElementsAre("realtime:left", "realtime:left", "realtime:left"));
  world.scene.probes[0].hides = {"floor"};
  world.update();
  EXPECT_THAT(world.makeAll(), ElementsAre("realtime:left")) << "it shows nothing that a probe lights";
}

TEST(ProbePlanRealtime, IsInNobodysBounces) {
  TwoProbes world(2);
  world.scene.probes[0].mode = ProbeMode::Realtime;
  world.update();
  world.makeAll();
  world.scene.probes[0].origin.y = 0.3;
  world.update();
  EXPECT_THAT(world.makeAll(), ElementsAre("realtime:left", "realtime:left"));
}

}  // namespace
}  // namespace boxprobe::test
