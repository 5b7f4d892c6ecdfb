// From mouse rays to metres.
#include "filters/vtk/widgets/handle_drag.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/rotation_degrees.h"
#include "filters/fit/rays/surface_rays.h"
#include "filters/vtk/widgets/handle_picking.h"
#include "filters/vtk/widgets/handle_readout.h"

namespace boxprobe {
namespace {

Ray towards(const glm::dvec3& from, const glm::dvec3& to) {
  return {from, glm::normalize(to - from)};
}

TEST(HandleDrag, ClosestOnLineIsWhereTheRayWasAimed) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-4.0, 4.0);
  const auto vector = [&] { return glm::dvec3(any(random), any(random), any(random)); };
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 point = vector(), axis = glm::normalize(vector()), eye = vector();
    const double t = any(random);
    const Ray ray = towards(eye, point + t * axis);
    const auto found = closestOnLine(ray, point, axis);
    if (std::abs(glm::dot(axis, ray.direction)) > 0.999) continue;
    ASSERT_TRUE(found);
    ASSERT_NEAR(*found, t, 1e-8);
  }
}

TEST(HandleDrag, WhatIsSelectedTooKeepsItsPlaceBesideWhatIsDragged) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-3.0, 3.0), angle(-170.0, 170.0);
  const auto vector = [&] { return glm::dvec3(any(random), any(random), any(random)); };
  for (int i = 0; i < 200; ++i) {
    Probe start, other;
    for (Probe* probe : {&start, &other}) {
      const glm::dvec3 middle = vector();
      probe->box = {middle - 1.0, middle + glm::dvec3(1.0, 2.0, 0.5)};
      probe->origin = middle + 0.2 * vector();
      probe->rotationDegrees = {0.4 * angle(random), angle(random), angle(random)};
    }
    Probe now = start;
    now.rotationDegrees = {0.4 * angle(random), angle(random), angle(random)};
    // Seen from the one that is turned, the other's middle, origin and axes are where they were.
    const auto seen = [](const Probe& from, const Probe& of) {
      const glm::dmat3 back = glm::transpose(rotationMatrix(from.rotationDegrees));
      return std::array<glm::dvec3, 5>{
          back * (of.box.center() - from.box.center()), back * (of.origin - from.box.center()),
          back * rotationMatrix(of.rotationDegrees)[0], back * rotationMatrix(of.rotationDegrees)[1],
          back * rotationMatrix(of.rotationDegrees)[2]};
    };
    const Probe turned = movedAlong(other, HandleKind::Turn, start, now);
    const auto before = seen(start, other), after = seen(now, turned);
    for (std::size_t k = 0; k < before.size(); ++k) EXPECT_LT(glm::length(after[k] - before[k]), 1e-9) << i;
    EXPECT_LT(glm::length(turned.box.size() - other.box.size()), 1e-9);

    const glm::dvec3 by = vector();
    EXPECT_EQ(movedAlong(other, HandleKind::Move, start, movedProbe(start, by)).rotationDegrees, other.rotationDegrees);
    now = start;
    now.origin += by;
    const Probe shifted = movedAlong(other, HandleKind::OriginAxis, start, now);
    EXPECT_LT(glm::length(shifted.origin - other.origin - by), 1e-12);
    EXPECT_EQ(shifted.box, other.box);
  }
  EXPECT_FALSE(movesOthers(HandleKind::Face));
}

TEST(HandleDrag, NothingAlongTheLineOrBehindTheViewer) {
  const Ray ray{glm::dvec3(0.0), glm::dvec3(0.0, 0.0, -1.0)};
  EXPECT_FALSE(closestOnLine(ray, glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0)));
  EXPECT_FALSE(closestOnLine(ray, glm::dvec3(0.0, 1.0, 5.0), glm::dvec3(1.0, 0.0, 0.0)));
  EXPECT_FALSE(meetPlane(ray, glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 0.0, 1.0)));
}

TEST(HandleDrag, AFaceSeenHeadOnFollowsUpAndDown) {
  Probe probe;
  probe.box = {glm::dvec3(-2.0), glm::dvec3(2.0)};
  const ViewAxes view{glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 1.0, 0.0)};
  const glm::dvec3 eye(0.0, 0.0, 1.0);
  ProbeDrag drag(probe, {HandleKind::Face, 0, {2, false}}, view, towards(eye, glm::dvec3(0.0, 0.0, -2.0)));
  const Box away = drag.at({towards(eye, glm::dvec3(0.0, 0.5, -2.0))}).box;
  EXPECT_NEAR(away.min.z, -2.5, 1e-12) << "up moves it away from the viewer";
  const Box closer = drag.at({towards(eye, glm::dvec3(0.0, -0.5, -2.0))}).box;
  EXPECT_NEAR(closer.min.z, -1.5, 1e-12);
  EXPECT_EQ(away.max, probe.box.max);
}

TEST(HandleDrag, WhatTheGrabMissedTheHandleByStaysBetweenThem) {
  Probe probe;
  probe.box = {glm::dvec3(-2.0), glm::dvec3(2.0)};
  const ViewAxes view{glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 1.0, 0.0)};
  const glm::dvec3 eye(0.5, 1.0, 9.0);
  ProbeDrag drag(probe, {HandleKind::Face, 0, {0, true}}, view, towards(eye, glm::dvec3(2.1, 0.0, 0.0)));
  EXPECT_NEAR(drag.at({towards(eye, glm::dvec3(2.1, 0.0, 0.0))}).box.max.x, 2.0, 1e-12);
  EXPECT_NEAR(drag.at({towards(eye, glm::dvec3(3.1, 0.0, 0.0))}).box.max.x, 3.0, 1e-9);
}

TEST(HandleDrag, TheOriginStaysInItsPlaneOrOnItsAxis) {
  Probe probe;
  probe.origin = {0.5, 1.0, -2.0};
  const glm::dvec3 forward = glm::normalize(glm::dvec3(0.3, -0.2, -1.0));
  const glm::dvec3 eye(0.0, 2.0, 5.0);
  ProbeDrag drag(probe, {}, {forward, glm::dvec3(0.0, 1.0, 0.0)}, towards(eye, probe.origin));
  const glm::dvec3 moved = drag.at({towards(eye, glm::dvec3(1.5, 1.4, -2.5))}).origin;
  EXPECT_NEAR(glm::dot(moved - probe.origin, forward), 0.0, 1e-12);
  EXPECT_GT(glm::length(moved - probe.origin), 0.5);
  const glm::dvec3 raised = drag.at({towards(eye, probe.origin + glm::dvec3(0.0, 0.7, 0.0)), false, 1}).origin;
  EXPECT_NEAR(glm::length(raised - probe.origin - glm::dvec3(0.0, 0.7, 0.0)), 0.0, 1e-9);
}

TEST(HandleDrag, DegreesAreFoundAgainFromARotation) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-180.0, 180.0);
  for (int i = 0; i < 1000; ++i) {
    const glm::dmat3 rotation = rotationMatrix({any(random), any(random), any(random)});
    const glm::dmat3 again = rotationMatrix(rotationDegreesOf(rotation));
    for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(glm::length(rotation[axis] - again[axis]), 0.0, 1e-9);
  }
  for (const double x : {30.0, -100.0}) {
    const glm::dmat3 pole = rotationMatrix({x, 90.0, 20.0});
    const glm::dmat3 again = rotationMatrix(rotationDegreesOf(pole));
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(glm::length(pole[axis] - again[axis]), 0.0, 1e-6);
  }
}

TEST(HandleDrag, TurnedAboutAnAxisOfItsOwnTheWholeGoesWithIt) {
  Probe probe;
  probe.box = {glm::dvec3(-2.0, 0.0, -1.0), glm::dvec3(2.0, 3.0, 1.0)};
  probe.origin = {1.5, 1.0, 0.5};
  probe.rotationDegrees = {20.0, 30.0, -10.0};
  probe.influence = Box{probe.box.min - 0.5, probe.box.max + 0.25};
  const glm::dvec3 eye(3.0, 9.0, 8.0);
  const ViewAxes view{glm::normalize(probe.box.center() - eye), glm::dvec3(0.0, 1.0, 0.0)};
  const auto inBox = [](const Probe& p, const glm::dvec3& point) {
    return glm::transpose(rotationMatrix(p.rotationDegrees)) * (point - p.box.center());
  };
  for (int axis = 0; axis < 3; ++axis) {
    const Handle ring{HandleKind::Turn, 0, {axis, true}};
    const glm::dmat3 frame = rotationMatrix(probe.rotationDegrees);
    const glm::dvec3 grabbed = probe.box.center() + frame[(axis + 1) % 3];
    ProbeDrag drag(probe, ring, view, towards(eye, grabbed));
    // A quarter turn takes the next axis to the one after it.
    const Probe turned = drag.at({towards(eye, probe.box.center() + frame[(axis + 2) % 3])});
    const glm::dmat3 now = rotationMatrix(turned.rotationDegrees);
    EXPECT_NEAR(glm::length(now[(axis + 1) % 3] - frame[(axis + 2) % 3]), 0.0, 1e-9);
    EXPECT_NEAR(glm::length(now[axis] - frame[axis]), 0.0, 1e-9);
    EXPECT_NEAR(glm::length(inBox(turned, turned.origin) - inBox(probe, probe.origin)), 0.0, 1e-9);
    EXPECT_EQ(turned.box, probe.box);
    EXPECT_EQ(turned.influence, probe.influence);
  }
}

TEST(HandleDrag, WithoutTiltAYawStaysOneNumber) {
  Probe probe;
  probe.box = {glm::dvec3(-2.0), glm::dvec3(2.0)};
  probe.rotationDegrees.y = 170.0;
  const glm::dvec3 eye(0.0, 10.0, 0.1);
  const ViewAxes view{glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(0.0, 0.0, -1.0)};
  const Handle ring{HandleKind::Turn, 0, {1, true}};
  ProbeDrag drag(probe, ring, view, towards(eye, {1.0, 0.0, 0.0}));
  DragWish wish{towards(eye, {std::cos(0.61), 0.0, -std::sin(0.61)})};  // 35 degrees
  EXPECT_NEAR(drag.at(wish).rotationDegrees.y, -155.0, 0.1);
  EXPECT_EQ(drag.at(wish).rotationDegrees.x, 0.0);
  DragSnap snap(nullptr, wish.ray, 0.01);
  wish.snap = &snap;
  EXPECT_DOUBLE_EQ(drag.at(wish).rotationDegrees.y, -150.0) << "the angle itself is a multiple of 15 degrees";
}

/// A wall at x = 3.07.
class OneWall : public SurfaceRays {
 public:
  std::optional<SurfaceHit> first(const glm::dvec3& origin, const glm::dvec3& direction) const override {
    const auto at = meetPlane({origin, direction}, {3.07, 0.0, 0.0}, {1.0, 0.0, 0.0});
    if (!at) return std::nullopt;
    SurfaceHit hit;
    hit.distance = glm::length(*at - origin);
    hit.normalWorld = {-1.0, 0.0, 0.0};
    return hit;
  }
  const Box& bounds() const override { return bounds_; }

 private:
  Box bounds_;
};

TEST(HandleDrag, SnapsToTheWallPointedAtThenTheWallAheadThenTheGrid) {
  const OneWall wall;
  const glm::dvec3 point(2.0, 0.0, 0.0), axis(1.0, 0.0, 0.0), inside(0.0);
  DragSnap pointed(&wall, {{0.0, 0.0, 5.0}, glm::normalize(glm::dvec3(1.0, 0.0, -1.0))}, 0.01);
  EXPECT_NEAR(pointed.face(point, axis, 0.3, inside), 1.07, 1e-12);
  EXPECT_EQ(pointed.target(), SnapTarget::Pointed);
  DragSnap away(&wall, {{0.0, 0.0, 5.0}, {-1.0, 0.0, 0.0}}, 0.01);
  EXPECT_NEAR(away.face(point, axis, 1.0, inside), 1.07, 1e-12);
  EXPECT_EQ(away.target(), SnapTarget::Opposite);
  EXPECT_NEAR(away.face(point, axis, 0.33, inside), 0.3, 1e-12);
  EXPECT_EQ(away.target(), SnapTarget::Grid);
  DragSnap none(nullptr, {}, 0.01);
  EXPECT_NEAR(none.face(point, axis, 1.04, inside), 1.0, 1e-12);
}

TEST(HandleDrag, BlendAndInfluenceGoFaceByFace) {
  Probe probe;
  probe.box = {glm::dvec3(-2.0), glm::dvec3(2.0)};
  probe.blendDistance = {glm::dvec3(0.5), glm::dvec3(0.5)};
  const ViewAxes view{glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 1.0, 0.0)};
  const glm::dvec3 eye(0.5, 1.0, 9.0);
  const auto pulled = [&](HandleKind kind, double metres, bool symmetric = false) {
    const Handle handle{kind, 0, {0, true}};
    const glm::dvec3 at = handleAnchorWorld(probe, handle);
    ProbeDrag drag(probe, handle, view, towards(eye, at));
    return drag.at({towards(eye, at + glm::dvec3(metres, 0.0, 0.0)), symmetric});
  };
  EXPECT_NEAR(pulled(HandleKind::Blend, -0.25).blendDistance.max.x, 0.75, 1e-9);
  EXPECT_NEAR(pulled(HandleKind::Blend, 0.25).blendDistance.max.x, 0.25, 1e-9);
  EXPECT_EQ(pulled(HandleKind::Blend, 5.0).blendDistance.max.x, 0.0);
  EXPECT_EQ(pulled(HandleKind::Blend, 0.25).blendDistance.min.x, 0.5);
  const Probe wider = pulled(HandleKind::Influence, 1.0);
  ASSERT_TRUE(wider.influence);
  EXPECT_NEAR(wider.influence->max.x, 3.0, 1e-9);
  EXPECT_EQ(wider.influence->min, probe.box.min);
  EXPECT_EQ(wider.box, probe.box) << "the projection box stays";
  EXPECT_NEAR(pulled(HandleKind::Influence, 1.0, true).influence->min.x, -3.0, 1e-9);
  // Pushed beyond the middle: both faces stop beside it, each half of what is left.
  const Probe thin = pulled(HandleKind::Influence, -7.0, true);
  EXPECT_NEAR(thin.influence->max.x, 0.5 * kMinimumThickness, 1e-9);
  EXPECT_NEAR(thin.influence->min.x, -0.5 * kMinimumThickness, 1e-9);
  EXPECT_NEAR(pulled(HandleKind::Influence, -7.0).influence->max.x, -2.0 + kMinimumThickness, 1e-9);
}

TEST(HandleReadout, NumbersWithTheirUnitInAnyWords) {
  Probe before;
  before.box = {glm::dvec3(-1.0, 0.0, -2.5), glm::dvec3(2.0, 3.125, 2.0)};
  before.origin = {0.5, 1.25, -0.0625};
  before.influence = Box{glm::dvec3(-1.5, -0.25, -3.0), glm::dvec3(2.25, 4.0, 3.0)};
  before.blendDistance = {glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(0.4, 0.5, 0.6)};
  Probe now = before;
  now.origin += glm::dvec3(0.3, 0.0, -0.4);
  now.rotationDegrees = {-4.25, 17.0, -0.01};
  const ReadoutStyle metres{"m", {}}, none;
  const auto text = [&](HandleKind kind, const BoxFace& face, const ReadoutStyle& style) {
    return handleReadout({kind, 0, face}, before, now, style);
  };
  EXPECT_EQ(text(HandleKind::Face, {1, true}, metres), "+Y  3.125 m\nsize 3.000 × 3.125 × 4.500 m");
  EXPECT_EQ(text(HandleKind::Face, {2, false}, none), "-Z  -2.500\nsize 3.000 × 3.125 × 4.500");
  EXPECT_EQ(text(HandleKind::Influence, {0, false}, metres), "influence -X  -1.500 m\nsize 3.750 × 4.250 × 6.000 m");
  EXPECT_EQ(text(HandleKind::Blend, {2, true}, metres), "blend +Z  0.600 m");
  EXPECT_EQ(text(HandleKind::Move, {0, true}, metres), "moved by 0.500 m");
  EXPECT_EQ(text(HandleKind::Turn, {1, true}, metres), "rotation\n-4.2°  17.0°  -0.0°");
  EXPECT_EQ(text(HandleKind::Origin, {}, metres), "origin\n0.800  1.250  -0.463 m");
  const ReadoutStyle german{"m", [](const char* form) {
                              return std::string(form) == "moved by %1 %2" ? "um %1 %2 verschoben" : std::string(form);
                            }};
  EXPECT_EQ(text(HandleKind::Move, {0, true}, german), "um 0.500 m verschoben");
  DragSnap snap(nullptr, {}, 0.0123);
  snap.grid(glm::dvec3(0.0));
  EXPECT_EQ(snapReadout(snap, {HandleKind::Origin, 0, {}}, metres), "grid 0.1 m");
  EXPECT_EQ(snapReadout(snap, {HandleKind::Turn, 0, {}}, metres), "steps of 15°");
}

}  // namespace
}  // namespace boxprobe
