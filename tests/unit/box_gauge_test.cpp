// The error of a box face by face: which face is wrong, where it belongs, and which spot shows it the most.
#include "filters/fit/box/box_gauge.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/rays/triangle_rays.h"
#include "tests/support/random_room.h"
#include "tests/unit/made_model.h"

namespace boxprobe {
namespace {

const Box kSmoothHall{glm::dvec3(-4, 0, -3), glm::dvec3(4, 2.8, 3)};

struct SmoothHall {
  Scene scene;
  std::unique_ptr<TriangleRays> rays;
  FitPlace place() const { return {*rays, *rays, scene.cameras}; }
};

/// Of smooth surfaces; a camera in a corner looks at the floor.
SmoothHall smoothHall(double yawDegrees = 0.0) {
  MadeModel made;
  made.box(kSmoothHall, true);
  made.model.materials.emplace_back().roughness = 0.1f;
  made.model.meshes.front().material = 0;
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), glm::radians(yawDegrees), glm::dvec3(0, 1, 0));
  made.model.instances.front().worldFromModel = turn;
  SmoothHall smooth;
  smooth.scene.models = {{"made.glb"}};
  Camera camera;
  camera.position = glm::dvec3(turn * glm::dvec4(-3.5, 1.7, -2.5, 1.0));
  camera.target = glm::dvec3(turn * glm::dvec4(1.0, 0.0, 1.0, 1.0));
  smooth.scene.cameras = {camera};
  smooth.rays = std::make_unique<TriangleRays>(
      smooth.scene, TriangleRays::Models{std::make_shared<const Model>(std::move(made.model))});
  return smooth;
}

Probe probeOf(const Box& box, double yawDegrees = 0.0) {
  Probe probe;
  probe.origin = {0.5, 1.4, -0.3};
  probe.box = box;
  probe.rotationDegrees.y = yawDegrees;
  return probe;
}

TEST(BoxGauge, ABoxThatFitsHasNoWorstFace) {
  const SmoothHall made = smoothHall();
  const Probe probe = probeOf(kSmoothHall);
  const std::optional<BoxGauge> gauge = BoxGauger(made.place(), probe).measure(probe);
  ASSERT_TRUE(gauge);
  EXPECT_LT(gauge->errors.meanDegrees, 0.02);
  EXPECT_FALSE(gauge->worst);
  double share = 0.0;
  for (const FaceGauge& face : gauge->faces) share += face.share;
  EXPECT_NEAR(share, 1.0, 1e-9) << "each reflection leaves through one face";
}

TEST(BoxGauge, EachFaceThatIsOffIsFoundAndPutRight) {
  for (const double yaw : {0.0, 25.0}) {
    const SmoothHall made = smoothHall(yaw);
    const BoxGauger gauger(made.place(), probeOf(kSmoothHall, yaw));
    for (int face = 0; face < kFaces; ++face) {
      if (face == 2) continue;  // the floor, which is where the rays come from, is met by few of them
      const Probe right = probeOf(kSmoothHall, yaw);
      const double offset = offsetBox(right).offset[static_cast<std::size_t>(face)];
      const Probe wrong = withFaceAt(right, face, offset + 1.2);
      const std::optional<BoxGauge> gauge = gauger.measure(wrong);
      ASSERT_TRUE(gauge);
      ASSERT_TRUE(gauge->worst) << "face " << faceName(face) << ", turned by " << yaw;
      EXPECT_EQ(*gauge->worst, face) << "turned by " << yaw;
      const FaceGauge& found = gauge->faces[static_cast<std::size_t>(face)];
      EXPECT_NEAR(found.offset, offset, 0.02) << faceName(face);
      EXPECT_GT(found.meanDegrees, 1.0);
      const Probe mended = withFaceAt(wrong, face, found.offset);
      const std::optional<BoxGauge> after = gauger.measure(mended);
      ASSERT_TRUE(after);
      EXPECT_NEAR(after->errors.meanDegrees, gauge->errors.meanDegrees - found.gainDegrees, 1e-6)
          << "what is promised is what is gained";
      EXPECT_FALSE(after->worst);
    }
  }
}

TEST(BoxGauge, TheErrorIsThatOfTheFit) {
  const SmoothHall made = smoothHall();
  Probe probe = probeOf(kSmoothHall);
  probe.box.max.x += 0.8;
  const std::optional<BoxGauge> gauge = BoxGauger(made.place(), probe, 4096).measure(probe);
  ASSERT_TRUE(gauge);
  const LookupErrors fit = boxErrors(made.place(), probe);
  EXPECT_NEAR(gauge->errors.meanDegrees, fit.meanDegrees, 1e-9);
  EXPECT_NEAR(gauge->errors.p95Degrees, fit.p95Degrees, 1e-9);
}

TEST(BoxGauge, TheWorstSpotIsSeenAndReflectsWhatIsWrong) {
  const SmoothHall made = smoothHall();
  Probe probe = probeOf(kSmoothHall);
  probe.box.max.x += 2.0;
  const std::optional<BoxGauge> gauge = BoxGauger(made.place(), probe).measure(probe);
  ASSERT_TRUE(gauge && gauge->spot);
  EXPECT_GT(gauge->spot->degrees, 2.0 * gauge->errors.meanDegrees);
  // Somebody sees it, and what it mirrors lies at the wall that the box misses.
  const glm::dvec3 towards = glm::normalize(gauge->spot->positionWorld - gauge->spot->eyeWorld);
  const std::optional<SurfaceHit> seen = made.rays->first(gauge->spot->eyeWorld, towards);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->distance, glm::length(gauge->spot->positionWorld - gauge->spot->eyeWorld), 1e-3);
  const glm::dvec3 mirrored = glm::reflect(towards, seen->normalWorld);
  const std::optional<SurfaceHit> wall =
      made.rays->first(gauge->spot->positionWorld + 1e-3 * seen->normalWorld, mirrored);
  ASSERT_TRUE(wall);
  const glm::dvec3 met = gauge->spot->positionWorld + wall->distance * mirrored;
  EXPECT_NEAR(met.x, 4.0, 0.05);
}

/// What a panel says of one box does not contradict itself: the mean is that of a fit, and nothing seen through a face
/// is worse on the whole than the worst spot.
TEST(BoxGauge, FiguresOfOneBoxAgree) {
  int judged = 0;
  for (std::uint32_t seed = 300; seed < 312; ++seed) {
    const test::RandomRoom room = test::randomRoom(seed);
    Probe probe = room.scene.probes.front();
    const glm::dvec3 off(0.11 * (seed % 7), 0.07 * (seed % 5), 0.13 * (seed % 3));
    const glm::dmat3 turn = rotationMatrix({0.0, room.yawDegrees, 0.0});
    probe.rotationDegrees = {0.0, room.yawDegrees, 0.0};
    const glm::dvec3 middle = turn * glm::dvec3(0.0, room.halfSize.y, 0.0);
    probe.box = {middle - room.halfSize - off, middle + room.halfSize + 0.4 * off};
    const TriangleRays rays(room.scene, {room.model});
    const FitPlace place{rays, rays, room.scene.cameras};
    const std::optional<BoxGauge> gauge = BoxGauger(place, probe).measure(probe);
    ASSERT_TRUE(gauge && gauge->spot) << room.what;
    EXPECT_NEAR(gauge->errors.meanDegrees, boxErrors(place, probe).meanDegrees, 1e-9) << room.what;
    const ReflectedRays reflected = reflectedRays(place, probe, kBoxRays);
    const LookupRays lookups = lookupRays(place, reflected, probe.origin, rotationMatrix(probe.rotationDegrees));
    std::array<bool, kFaces> seen{};
    for (const LookupRay& ray : lookups.rays) {
      if (reflected.rays[ray.reflected].seen) {
        seen[static_cast<std::size_t>(boxExit(ray, offsetBox(probe).offset).face)] = true;
      }
    }
    for (int face = 0; face < kFaces; ++face) {
      const FaceGauge& each = gauge->faces[static_cast<std::size_t>(face)];
      if (!seen[static_cast<std::size_t>(face)]) continue;
      ++judged;
      EXPECT_LE(each.meanDegrees, gauge->spot->degrees) << faceName(face) << " of " << room.what << ", seed " << seed;
    }
  }
  EXPECT_GT(judged, 30);
}

TEST(BoxGauge, StopsWhenAskedAndKnowsNothingInTheOpen) {
  const SmoothHall made = smoothHall();
  const Probe probe = probeOf(kSmoothHall);
  EXPECT_FALSE(BoxGauger(made.place(), probe).measure(probe, [](double) { return false; }));
  Scene empty;
  const TriangleRays none(empty, {});
  EXPECT_FALSE(BoxGauger({none, none, {}}, probe).measure(probe));
}

}  // namespace
}  // namespace boxprobe
