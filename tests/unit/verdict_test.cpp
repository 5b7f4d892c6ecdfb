// The sentence that stands before an explanation, and the edit that it proposes.
#include "filters/explain/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "filters/core/geometry/probe_frame.h"
#include "tests/unit/explained_room.h"

namespace boxprobe {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// The room of the explained pixel, turned about the capture origin as its box is, with walls where `kWalls` has them.
const Box kWalls{{-2.0, 0.0, -3.0}, {2.0, 3.0, 3.0}};

struct JudgedRoom : ExplainedRoom {
  // What the captured distances hold: along R from the point to the walls.
  float trueDistance(const ProbeExplanation& p) const {
    double nearest = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
      const double along = p.reflectionProbe[axis];
      if (std::abs(along) < 1e-6) continue;
      const double plane = (along > 0.0 ? kWalls.max : kWalls.min)[axis] - probe.origin[axis];
      nearest = std::min(nearest, (plane - p.positionProbe[axis]) / along);
    }
    return static_cast<float>(nearest);
  }

  Verdict judge() const {
    Scene scene;
    scene.probes = {probe};
    Explanation e = explain();
    for (ProbeExplanation& p : e.probes) p.trueDistance = trueDistance(p);
    e.specular = e.color = glm::vec3(0.5f);  // of a mirror
    return verdictOf(e, scene);
  }
};

TEST(Verdict, ABoxOnTheWallsIsRight) {
  const Verdict verdict = JudgedRoom().judge();
  EXPECT_THAT(verdict.sentence.english(), StartsWith("Probe \"room\", right to less than 0.1 degrees"));
  EXPECT_FALSE(verdict.mend);
}

TEST(Verdict, AWrongFaceIsNamedAndItsMendMakesItRight) {
  for (const double turned : {0.0, 25.0}) {
    JudgedRoom room;
    room.probe.rotationDegrees.y = turned;
    const Box right = room.probe.box;
    setBox(room.probe, withFaceMoved(right, room.probe.rotationDegrees, {0, true}, 0.6, false, kMinimumThickness));
    const Verdict verdict = room.judge();
    EXPECT_THAT(verdict.sentence.english(), HasSubstr("degrees off: the ray meets the +x face of its box 0."));
    EXPECT_THAT(verdict.sentence.english(), HasSubstr(" m behind the surface that is there."));
    ASSERT_TRUE(verdict.mend);
    EXPECT_EQ(verdict.mend->words.english(), "Move the +x face of \"room\" in by 0.60 m");
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(verdict.mend->after.box.min[axis], right.min[axis], 1e-5);
      EXPECT_NEAR(verdict.mend->after.box.max[axis], right.max[axis], 1e-5);
    }
    room.probe = verdict.mend->after;
    EXPECT_THAT(room.judge().sentence.english(), HasSubstr("right to less than 0.1 degrees"));
  }
}

TEST(Verdict, TheReflectionVectorAloneIsToldToUseTheBox) {
  JudgedRoom room;
  room.probe.technique = "infinite+footprint4";
  Verdict verdict = room.judge();
  EXPECT_THAT(verdict.sentence.english(), HasSubstr("sampled by the reflection vector alone"));
  ASSERT_TRUE(verdict.mend);
  EXPECT_EQ(verdict.mend->after.technique, "footprint4");
  room.probe.technique = "box";
  room.probe.projection = false;
  verdict = room.judge();
  ASSERT_TRUE(verdict.mend);
  EXPECT_TRUE(verdict.mend->after.projection);
  room.probe = verdict.mend->after;
  EXPECT_THAT(room.judge().sentence.english(), HasSubstr("right to"));
}

TEST(Verdict, TheSkyNamesTheInfluenceBoxThatEndsShort) {
  JudgedRoom room;
  room.probe.influence = Box{{-2.0, 0.0, -3.0}, {0.42, 3.0, 3.0}};
  room.probe.blendDistance = {glm::dvec3(0.0), glm::dvec3(0.25, 0.0, 0.0)};
  const Verdict verdict = room.judge();
  EXPECT_EQ(verdict.sentence.english(),
            "The sky, because the influence box of \"room\" ends 0.08 m short of this point at +x.");
  ASSERT_TRUE(verdict.mend);
  EXPECT_EQ(verdict.mend->words.english(), "Widen the influence box of \"room\": 0.33 m at +x");
  EXPECT_NEAR(verdict.mend->after.influence->max.x, 0.75, 1e-9);
  room.probe = verdict.mend->after;
  EXPECT_THAT(room.judge().sentence.english(), HasSubstr("right to"));
  // Far away, widening is no mend.
  room.probe.influence = Box{{-30.0, 0.0, -3.0}, {-28.0, 3.0, 3.0}};
  EXPECT_FALSE(room.judge().mend);
}

TEST(Verdict, WithoutAProbeOrACaptureItSaysSo) {
  JudgedRoom room;
  room.captured = false;
  EXPECT_THAT(room.judge().sentence.english(), HasSubstr("not captured yet"));
  Explanation e = ExplainedRoom().explain();
  e.hit = false;
  EXPECT_THAT(verdictOf(e, {}).sentence.english(), StartsWith("The background"));
  e.hit = true;
  e.probes.clear();
  e.dominant = -1;
  e.skyWeight = 1.0f;
  e.specular = e.color = glm::vec3(1.0f);
  EXPECT_EQ(verdictOf(e, {}).sentence.english(), "The sky: the scene has no probe.");
}

TEST(Verdict, LightThatIsHardlyReflectedIsCalledSo) {
  Explanation e = ExplainedRoom().explain();
  e.emissive = glm::vec3(4.0f);
  e.color = e.emissive + e.specular + e.diffuse + e.direct;
  Scene scene;
  scene.probes = {ExplainedRoom().probe};
  EXPECT_THAT(verdictOf(e, scene).sentence.english(), StartsWith("Hardly a reflection: "));
  EXPECT_THAT(verdictOf(e, scene).sentence.english(), HasSubstr("is from the surface itself"));
}

}  // namespace
}  // namespace boxprobe
