// Capture origins proposed by measured error.
#include "filters/fit/box/fit_origin.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "filters/fit/rays/triangle_rays.h"
#include "tests/unit/made_model.h"

namespace boxprobe {
namespace {

struct Hall {
  Scene scene;
  std::unique_ptr<TriangleRays> rays;
  FitPlace place() const { return {*rays, *rays, scene.cameras}; }
};

/// A hall with a screen across it, 2 m high; cameras look at the floor from both sides.
Hall hallWithScreen() {
  MadeModel made;
  made.box({glm::dvec3(-5, 0, -3), glm::dvec3(5, 4, 3)}, true);
  made.box({glm::dvec3(-0.1, 0, -3), glm::dvec3(0.1, 2, 3)}, false);
  Hall hall;
  made.model.materials.emplace_back().roughness = 0.1f;
  made.model.meshes.front().material = 0;
  hall.scene.models = {{"made.glb"}};
  for (const double side : {-1.0, 1.0}) {
    Camera camera;
    camera.name = side < 0.0 ? "left" : "right";
    camera.position = {4.5 * side, 1.7, 0.0};
    camera.target = {0.0, 0.0, 0.0};
    hall.scene.cameras.push_back(camera);
  }
  hall.rays = std::make_unique<TriangleRays>(
      hall.scene, TriangleRays::Models{std::make_shared<const Model>(std::move(made.model))});
  return hall;
}

Probe lowProbe() {
  Probe probe;
  probe.origin = {-3.0, 0.5, 1.5};
  probe.box = {glm::dvec3(-5, 0, -3), glm::dvec3(5, 4, 3)};
  probe.influence = probe.box;
  return probe;
}

TEST(FitOrigin, LeavesACornerThatSeesHalfTheRoom) {
  const Hall hall = hallWithScreen();
  const FitPlace place = hall.place();
  const Probe probe = lowProbe();
  const ReflectedRays reflected = reflectedRays(place, probe, 2048, 0.5);
  const std::optional<BoxFit> kept = fitBox(place, probe), proposed = proposeOrigin(place, probe);
  ASSERT_TRUE(kept && proposed);
  EXPECT_EQ(kept->probe.origin, probe.origin);
  EXPECT_GT(glm::length(proposed->probe.origin - probe.origin), 0.5);
  EXPECT_LT(originCost(place, reflected, proposed->probe), 0.9 * originCost(place, reflected, kept->probe));
  EXPECT_LT(proposed->hidden, 0.5 * proposed->hiddenBefore);
  const OffsetBox box = offsetBox(proposed->probe);
  for (const double offset : box.offset) EXPECT_GT(offset, 0.03) << "the origin is in its box";
}

TEST(FitOrigin, StaysWhereItSeesEverything) {
  MadeModel made;
  made.box({glm::dvec3(-5, 0, -3), glm::dvec3(5, 4, 3)}, true);
  Scene scene;
  scene.models = {{"made.glb"}};
  const TriangleRays rays(scene, {std::make_shared<const Model>(std::move(made.model))});
  Camera camera;
  camera.position = {3.0, 1.7, 2.0};
  camera.target = {-4.0, 1.0, -3.0};
  const Probe probe = lowProbe();
  const std::optional<BoxFit> fit = proposeOrigin({rays, rays, {camera}}, probe);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->probe.origin, probe.origin) << "finer texels of one wall are no reason to leave the others";
}

TEST(FitOrigin, StopsWhenAsked) {
  const Hall hall = hallWithScreen();
  double last = 0.0;
  EXPECT_FALSE(proposeOrigin(hall.place(), lowProbe(), {}, [&](double done) {
    EXPECT_GE(done, last);
    last = done;
    return done < 0.6;
  }));
  EXPECT_GE(last, 0.6);
}

}  // namespace
}  // namespace boxprobe
