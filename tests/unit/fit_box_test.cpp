// Boxes fitted to rooms: right where the room is a box, near the best one where it is not, and left alone where there
// is nothing to fit to.
#include "filters/fit/box/fit_box.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/fit_probe.h"
#include "filters/math/sampling/van_der_corput.h"
#include "tests/support/random_room.h"
#include "tests/unit/made_model.h"

namespace boxprobe {
namespace {

const Box kHall{glm::dvec3(-4, 0, -3), glm::dvec3(4, 2.8, 3)};

struct Place {
  Scene scene;
  std::shared_ptr<const Model> model;
  std::optional<BoxFit> fit(const Probe& probe, const BoxFitSettings& settings = {}, const FitProgress& progress = {}) {
    return ProbeFitter(scene, {model}).fit(probe, settings, progress);
  }
};

Place placeOf(MadeModel made, const glm::dmat4& world = glm::dmat4(1.0)) {
  made.model.instances.front().worldFromModel = world;
  Place place;
  place.scene.models = {{"made.glb"}};
  place.model = std::make_shared<const Model>(std::move(made.model));
  return place;
}

Place hall(const glm::dmat4& world = glm::dmat4(1.0), bool inverted = false) {
  MadeModel made;
  made.box(kHall, !inverted);
  return placeOf(made, world);
}

Probe probeAt(const glm::dvec3& origin, const Box& box) {
  Probe probe;
  probe.origin = origin;
  probe.box = box;
  return probe;
}

void expectHall(const Box& box, const std::string& what) {
  const glm::dvec3 size = kHall.size();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.min[axis], kHall.min[axis], 0.01 * size[axis]) << what << ", axis " << axis;
    EXPECT_NEAR(box.max[axis], kHall.max[axis], 0.01 * size[axis]) << what << ", axis " << axis;
  }
}

TEST(FitBox, FindsWallsFromBoxesOffByHalf) {
  Place place = hall();
  for (int i = 1; i <= 6; ++i) {
    Probe probe = probeAt({0.7, 1.4, -0.5}, kHall);
    for (int axis = 0; axis < 3; ++axis) {
      const double size = kHall.size()[axis];
      probe.box.min[axis] += size * (vanDerCorput(i, 2 + axis) - 0.5);
      probe.box.max[axis] += size * (vanDerCorput(7 * i, 2 + axis) - 0.5);
    }
    const std::optional<BoxFit> fit = place.fit(probe);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->outcome, FitOutcome::Fitted);
    EXPECT_EQ(fit->probe.rotationDegrees, glm::dvec3(0.0)) << "an upright room is not turned for nothing";
    expectHall(fit->probe.box, "box " + std::to_string(i));
    EXPECT_LT(fit->after.meanDegrees, 0.05);
    EXPECT_GT(fit->before.meanDegrees, 1.0);
  }
}

TEST(FitBox, FindsHowARoomIsTurned) {
  for (const double degrees : {-37.0, -12.0, 1.5, 25.0, 44.0}) {
    const glm::dmat4 world = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(100.0, 3.0, -50.0)),
                                         glm::radians(degrees), glm::dvec3(0.0, 1.0, 0.0));
    Place place = hall(world);
    const glm::dvec3 origin(world * glm::dvec4(0.7, 1.4, -0.5, 1.0));
    const std::optional<BoxFit> fit = place.fit(probeAt(origin, {origin - 2.0, origin + 2.0}));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->probe.rotationDegrees.y, degrees, 0.5);
    const glm::dvec3 size = fit->probe.box.size();
    EXPECT_LT(glm::length(size - kHall.size()), 0.01 * 8.0) << degrees;
    const glm::dvec3 middle(world * glm::dvec4(kHall.center(), 1.0));
    EXPECT_LT(glm::length(fit->probe.box.center() - middle), 0.01 * 8.0) << degrees;
  }
}

TEST(FitBox, IsNearTheBestOfRoomsThatAreNoBoxes) {
  // Mean errors in degrees of the best boxes that `fit_rooms tune` found by brute force.
  const std::pair<std::uint32_t, double> rooms[] = {{1002, 3.219}, {1003, 3.713}, {1006, 1.948}, {1010, 0.601},
                                                    {1011, 0.334}, {1020, 2.227}, {1033, 0.855}, {1053, 0.001}};
  for (const auto& [seed, best] : rooms) {
    const test::RandomRoom room = test::randomRoom(seed);
    const TriangleRays rays(room.scene, {room.model});
    const FitPlace place{rays, rays, room.scene.cameras};
    const std::optional<BoxFit> fit = fitBox(place, room.scene.probes.front());
    ASSERT_TRUE(fit);
    EXPECT_LT(boxErrors(place, fit->probe, 4096, 0.5).meanDegrees, 1.15 * best + 0.05) << seed << ": " << room.what;
  }
}

// The walls of a hexagon favour no direction: yaws all around are tried.
TEST(FitBox, AHexagonIsFittedAsWellHoweverItIsTurned) {
  constexpr int kAround = 6;
  MadeModel made;
  const auto corner = [](int i, double y) {
    const double angle = glm::radians(360.0 * i / kAround);
    return glm::vec3(3.0 * std::cos(angle), y, 3.0 * std::sin(angle));
  };
  for (int i = 0; i < kAround; ++i) {
    made.quad(corner(i, 0.0), corner(i, 2.8), corner(i + 1, 2.8), corner(i + 1, 0.0));
  }
  made.quad({-5, 0, 5}, {5, 0, 5}, {5, 0, -5}, {-5, 0, -5});
  made.quad({-5, 2.8, -5}, {5, 2.8, -5}, {5, 2.8, 5}, {-5, 2.8, 5});
  double least = 1e9, most = 0.0;
  for (const double yaw : {0.0, 7.0, 15.0, 22.0, -11.0}) {
    Place place = placeOf(made, glm::rotate(glm::dmat4(1.0), glm::radians(yaw), {0.0, 1.0, 0.0}));
    const std::optional<BoxFit> fit = place.fit(probeAt({0.1, 1.4, -0.05}, {glm::dvec3(-1), glm::dvec3(1, 3, 1)}));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(std::remainder(fit->probe.rotationDegrees.y - yaw, 30.0), 0.0, 0.1) << "along one of its walls";
    least = std::min(least, fit->after.meanDegrees);
    most = std::max(most, fit->after.meanDegrees);
  }
  EXPECT_LT(most, 1.3 * least);
  std::printf("  a hexagon: %.2f to %.2f degrees\n", least, most);
}

TEST(FitBox, MovesTheFacesThatItMayAndSaysWhatTheyGain) {
  Place place = hall();
  const Probe probe = probeAt({0, 1.4, 0}, {glm::dvec3(-3, 0.3, -2), glm::dvec3(3, 2.5, 2)});
  BoxFitSettings settings;
  settings.faces = {false, true, false, false, true, false};
  settings.yaw = false;
  const std::optional<BoxFit> fit = place.fit(probe, settings);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->outcome, FitOutcome::Fitted);
  EXPECT_EQ(fit->probe.box.min.x, probe.box.min.x);
  EXPECT_EQ(fit->probe.box.min.y, probe.box.min.y);
  EXPECT_EQ(fit->probe.box.max.y, probe.box.max.y);
  EXPECT_EQ(fit->probe.box.max.z, probe.box.max.z);
  EXPECT_GT(fit->faces[1].gainDegrees, 0.1);
  EXPECT_GT(fit->faces[4].gainDegrees, 0.1);
  EXPECT_EQ(fit->faces[0].gainDegrees, 0.0);
}

TEST(FitBox, SensitivityIsWhatAFaceOffCosts) {
  Place place = hall();
  const TriangleRays rays(place.scene, {place.model});
  const FitPlace seen{rays, rays, {}};
  const Probe probe = probeAt({0.7, 1.4, -0.5}, kHall);
  const LookupRays lookups = lookupRays(seen, reflectedRays(seen, probe, 4096), probe.origin, glm::dmat3(1.0));
  const OffsetBox exact = offsetBox(probe);
  EXPECT_LT(meanError(lookups, exact), 1e-3);
  for (std::size_t face = 0; face < kFaces; ++face) {
    OffsetBox off = exact;
    off.offset[face] += 0.002;
    const double expected = 0.002 * faceSensitivities(lookups, exact)[face];
    EXPECT_NEAR(meanError(lookups, off) - meanError(lookups, exact), expected, 0.15 * expected) << faceName(face);
  }
}

TEST(FitBox, TurnsTheInfluenceWithoutLosingSpace) {
  const glm::dmat4 world = glm::rotate(glm::dmat4(1.0), glm::radians(30.0), glm::dvec3(0.0, 1.0, 0.0));
  Place place = hall(world);
  Probe probe = probeAt({0, 1.4, 0}, {glm::dvec3(-2, 0, -2), glm::dvec3(2, 2, 2)});
  probe.influence = Box{glm::dvec3(-6, -0.5, -6), glm::dvec3(6, 3, 6)};
  const std::optional<BoxFit> fit = place.fit(probe);
  ASSERT_TRUE(fit);
  const glm::dvec3 pivot = fit->probe.box.center();
  const glm::dmat3 boxFromWorld = glm::transpose(rotationMatrix(fit->probe.rotationDegrees));
  for (const double x : {-6.0, 6.0}) {
    for (const double z : {-6.0, 6.0}) {
      const glm::dvec3 p = pivot + boxFromWorld * (glm::dvec3(x, 1.0, z) - pivot);
      EXPECT_TRUE(glm::all(glm::lessThanEqual(p, fit->probe.influence->max + 1e-9)));
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(p, fit->probe.influence->min - 1e-9)));
    }
  }
}

TEST(FitBox, FindsTheSameTwiceReportsAndStops) {
  const test::RandomRoom room = test::randomRoom(1021);
  ProbeFitter fitter(room.scene, {room.model});
  const Probe& probe = room.scene.probes.front();
  double last = 0.0;
  int calls = 0;
  const std::optional<BoxFit> first = fitter.fit(probe, {}, [&](double done) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.0);
    last = done;
    ++calls;
    return true;
  });
  EXPECT_GT(calls, 5);
  EXPECT_GT(last, 0.3);
  const std::optional<BoxFit> second = fitter.fit(probe);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->probe, second->probe);
  EXPECT_FALSE(fitter.fit(probe, {}, [](double) { return false; }));
}

TEST(FitBox, LeavesABoxAloneWhereThereAreNoWalls) {
  MadeModel made;
  made.side({glm::dvec3(-40, 0, -40), glm::dvec3(40, 2, 40)}, 1, false);
  made.box({glm::dvec3(-1, 0, -1), glm::dvec3(1, 2, 1)}, false);
  Place place = placeOf(made);
  const Probe probe = probeAt({4, 1.5, 0}, {glm::dvec3(-5, 0, -5), glm::dvec3(5, 3, 5)});
  const std::optional<BoxFit> fit = place.fit(probe);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->outcome, FitOutcome::Open);
  EXPECT_EQ(fit->probe, probe);
  Place nothing;
  nothing.model = std::make_shared<const Model>();
  nothing.scene.models = {{"nothing.glb"}};
  EXPECT_EQ(nothing.fit(probe)->outcome, FitOutcome::Open);
}

TEST(FitBox, KnowsAnOriginInAWallFromInvertedFaces) {
  MadeModel walls;
  walls.box(kHall, true);
  walls.box({kHall.min - 0.4, kHall.max + 0.4}, false);
  walls.box({glm::dvec3(1, 0.5, 1), glm::dvec3(2, 2, 2)}, false);
  Place place = placeOf(walls);
  const Box box{glm::dvec3(-2, 0, -2), glm::dvec3(2, 2, 2)};
  EXPECT_EQ(place.fit(probeAt({4.2, 1.4, 0}, box))->outcome, FitOutcome::Inside) << "in the wall at +x";
  EXPECT_EQ(place.fit(probeAt({1.5, 1.2, 1.5}, box))->outcome, FitOutcome::Inside) << "in a block";
  EXPECT_EQ(place.fit(probeAt({0, 1.4, 0}, box))->outcome, FitOutcome::Fitted);

  Place inverted = hall(glm::dmat4(1.0), true);
  const std::optional<BoxFit> fit = inverted.fit(probeAt({0, 1.4, 0}, box));
  EXPECT_EQ(fit->outcome, FitOutcome::Fitted);
  expectHall(fit->probe.box, "inverted");
}

}  // namespace
}  // namespace boxprobe
