// Plan and elevation: every point where the calculation has it, the deciding plane marked, labels clear of the lines.
#include "filters/explain/schematic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "tests/unit/explained_room.h"

namespace boxprobe {
namespace {

const SchematicView::Point& point(const SchematicView& view, SchematicPoint kind) {
  const auto found =
      std::find_if(view.points.begin(), view.points.end(), [&](const auto& p) { return p.kind == kind; });
  EXPECT_NE(found, view.points.end());
  return *found;
}

const SchematicView::Line& line(const SchematicView& view, SchematicLine kind) {
  const auto found = std::find_if(view.lines.begin(), view.lines.end(), [&](const auto& l) { return l.kind == kind; });
  EXPECT_NE(found, view.lines.end());
  return *found;
}

void expectAt(const glm::dvec2& at, double right, double up) {
  EXPECT_NEAR(at.x, right, 1e-6);
  EXPECT_NEAR(at.y, up, 1e-6);
}

// P is at (0.5, -1, 0) from C, the ray goes (1, 1, 0)/sqrt 2 and meets x = 2 at (2, 0.5, 0).
TEST(Schematic, DrawsTheCalculation) {
  const auto drawn = schematic(ExplainedRoom().explain());
  ASSERT_TRUE(drawn);
  const SchematicView& side = drawn->elevation;
  EXPECT_EQ(side.right, 0);
  expectAt(point(side, SchematicPoint::Shading).at, 0.5, -1.0);
  expectAt(point(side, SchematicPoint::Hit).at, 2.0, 0.5);
  expectAt(point(side, SchematicPoint::Origin).at, 0.0, 0.0);
  expectAt(point(side, SchematicPoint::Eye).at, -0.7, 0.2);
  expectAt(*side.boxLow, -2.0, -1.0);
  expectAt(*side.boxHigh, 2.0, 2.0);
  expectAt(line(side, SchematicLine::Lookup).from, 0.0, 0.0);
  expectAt(line(side, SchematicLine::Lookup).to, 2.0, 0.5);
  const glm::dvec2 normal = line(side, SchematicLine::Normal).to - line(side, SchematicLine::Normal).from;
  EXPECT_NEAR(normal.x, 0.0, 1e-6);
  EXPECT_GT(normal.y, 0.1);
  // Seen from above +z points at the reader: down on the paper.
  expectAt(point(drawn->plan, SchematicPoint::Hit).at, 2.0, 0.0);
  EXPECT_TRUE(drawn->plan.upFlipped);
}

TEST(Schematic, MarksThePlaneThatDecidesAndShowsTheOthersBeyond) {
  const auto drawn = schematic(ExplainedRoom().explain());
  const auto& planes = drawn->elevation.planes;
  ASSERT_EQ(planes.size(), 2u);
  EXPECT_TRUE(planes[0].smallest);
  EXPECT_EQ(planes[0].label, "t_x = 2.12");
  expectAt(planes[0].from, 2.0, -1.0);
  expectAt(planes[0].to, 2.0, 2.0);
  EXPECT_FALSE(planes[1].smallest);
  expectAt(planes[1].crossing, 3.5, 2.0);
  EXPECT_GE(drawn->elevation.high.x, 3.5) << "what is drawn must be seen";
  // R has no part along z: that plane is never crossed and not drawn.
  EXPECT_EQ(drawn->plan.planes.size(), 1u);
  EXPECT_NE(drawn->caption.english().find("min(2.12, 4.24, infinite) = 2.12"), std::string::npos)
      << drawn->caption.english();
}

TEST(Schematic, ChoosesTheElevationThatShowsTheRayLongest) {
  ExplainedRoom room;
  room.surface.eyeWorld = {0.5, 1.2, -1.2};
  room.surface.viewWorld = glm::normalize(glm::vec3(room.surface.eyeWorld - room.surface.positionWorld));
  const auto drawn = schematic(room.explain());
  EXPECT_EQ(drawn->elevation.right, 2);
  EXPECT_TRUE(drawn->elevation.rightFlipped) << "from the +x side -z is to the right";
  EXPECT_LT(point(drawn->elevation, SchematicPoint::Hit).at.x, 0.0);
}

TEST(Schematic, LabelsKeepAwayFromTheLinesOfTheirPoint) {
  const auto drawn = schematic(ExplainedRoom().explain());
  for (const SchematicView* view : {&drawn->plan, &drawn->elevation}) {
    for (const auto& p : view->points) {
      EXPECT_NEAR(glm::length(p.labelDirection), 1.0, 1e-9);
      for (const auto& l : view->lines) {
        if (glm::length(l.to - l.from) < 1e-6) continue;
        if (glm::length(l.from - p.at) < 1e-6) {
          EXPECT_LT(glm::dot(glm::normalize(l.to - l.from), p.labelDirection), 0.95) << p.label.english();
        }
      }
    }
  }
}

TEST(Schematic, ABoxTurnedWithItsSceneDrawsTheSame) {
  ExplainedRoom room, turned;
  const auto drawn = schematic(room.explain());
  turned.probe.rotationDegrees = {0.0, 90.0, 0.0};
  // A quarter turn about the box's centre, which is at x = z = 0: x becomes -z.
  turned.surface.positionWorld = {0.0, 0.0, -0.5};
  turned.surface.eyeWorld = {0.0, 1.2, 0.7};
  turned.surface.viewWorld = glm::normalize(glm::vec3(turned.surface.eyeWorld - turned.surface.positionWorld));
  const auto drawnTurned = schematic(turned.explain());
  const glm::dvec2 hit = point(drawn->elevation, SchematicPoint::Hit).at;
  const glm::dvec2 eye = point(drawn->elevation, SchematicPoint::Eye).at;
  expectAt(point(drawnTurned->elevation, SchematicPoint::Hit).at, hit.x, hit.y);
  expectAt(point(drawnTurned->elevation, SchematicPoint::Eye).at, eye.x, eye.y);
}

TEST(Schematic, WithoutABoxTheRayGoesOnAndTheCaptionSaysSo) {
  ExplainedRoom room;
  room.probe.technique = "infinite";
  const auto drawn = schematic(room.explain());
  ASSERT_TRUE(drawn);
  EXPECT_FALSE(drawn->plan.boxLow);
  EXPECT_TRUE(drawn->elevation.planes.empty());
  EXPECT_NE(drawn->caption.english().find("undefined"), std::string::npos);
}

// The same points, and the eye always on the paper.
TEST(Schematic, AnInsetHasTheRayAndNoDistances) {
  const Explanation room = ExplainedRoom().explain();
  for (const bool elevation : {false, true}) {
    const auto inset = insetView(room, elevation);
    ASSERT_TRUE(inset);
    EXPECT_TRUE(inset->boxUsed);
    EXPECT_TRUE(inset->planes.empty());
    for (const auto& shown : inset->points) {
      EXPECT_NE(shown.kind, SchematicPoint::SlabPlane);
      EXPECT_TRUE(shown.at.x >= inset->low.x && shown.at.x <= inset->high.x) << shown.label.english();
      EXPECT_TRUE(shown.at.y >= inset->low.y && shown.at.y <= inset->high.y) << shown.label.english();
    }
    expectAt(line(*inset, SchematicLine::Reflected).to, 2.0, elevation ? 0.5 : 0.0);
    expectAt(line(*inset, SchematicLine::Lookup).from, 0.0, 0.0);
    expectAt(line(*inset, SchematicLine::Lookup).to, 2.0, elevation ? 0.5 : 0.0);
  }
}

// R alone: from P to what it meets, and the same direction from C until it leaves the box.
TEST(Schematic, AnInsetWithoutAHitDrawsRTwice) {
  ExplainedRoom room;
  room.probe.technique = "infinite";
  const auto inset = insetView(room.explain(), true);
  ASSERT_TRUE(inset);
  EXPECT_FALSE(inset->boxUsed);
  expectAt(line(*inset, SchematicLine::Reflected).to, 2.0, 0.5);
  expectAt(line(*inset, SchematicLine::Lookup).to, 2.0, 2.0);
  EXPECT_TRUE(std::none_of(inset->points.begin(), inset->points.end(),
                           [](const auto& p) { return p.kind == SchematicPoint::Hit; }));
}

TEST(Schematic, ThereIsNoneWithoutSurfaceNormalOrProbe) {
  EXPECT_FALSE(schematic(Explanation{}));
  ExplainedRoom room;
  room.surface.normalWorld = glm::vec3(0.0f);
  EXPECT_FALSE(schematic(room.explain()));
}

}  // namespace
}  // namespace boxprobe
