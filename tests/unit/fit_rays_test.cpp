// The rays of the fit: boxes left as the shaders leave them, distances in place of triangles, who sees what.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/box/fit_box.h"
#include "filters/fit/rays/distance_rays.h"
#include "filters/fit/rays/triangle_rays.h"
#include "filters/math/sampling/van_der_corput.h"
#include "tests/support/distance_cube.h"
#include "tests/unit/made_model.h"

namespace boxprobe {
namespace {

const Box kStudy{glm::dvec3(-2.5, 0, -2), glm::dvec3(3, 2.6, 2.2)};

TEST(FitRays, LeaveABoxWhereTheShadersDo) {
  const std::array<double, kFaces> offset = {1.5, 2.0, 1.0, 3.0, -0.1, 2.5};  // one face behind the origin
  const glm::vec3 low(-1.5f, -1.0f, 0.1f), high(2.0f, 3.0f, 2.5f);
  for (int i = 1; i < 500; ++i) {
    LookupRay ray;
    ray.from = glm::dvec3(vanDerCorput(i, 2), vanDerCorput(i, 3), vanDerCorput(i, 5)) * 4.0 - 1.5;
    ray.along = sphereDirection(vanDerCorput(i, 7), vanDerCorput(i, 11));
    if (i % 10 == 0) ray.along = {0.0, 1.0, 0.0};
    const glm::vec3 factors = shading::slabFactors(glm::vec3(ray.from), glm::vec3(ray.along), low, high);
    const double shader = std::min({factors.x, factors.y, factors.z});
    EXPECT_NEAR(boxExit(ray, offset).distance, shader, 1e-5 * (1.0 + shader)) << i;
  }
}

// Where the surfaces lie is told by the triangles that have a place.
TEST(FitRays, ACornerThatIsNoNumberDoesNotMoveTheCore) {
  MadeModel made;
  made.box(kStudy, true);
  Scene scene;
  scene.models = {{"made.glb"}};
  const Box whole = TriangleRays(scene, {std::make_shared<const Model>(made.model)}).core();
  made.quad({-1, 1, -1}, {1, 1, -1}, {1, std::nanf(""), 1}, {-1, std::nanf(""), 1});
  const Box broken = TriangleRays(scene, {std::make_shared<const Model>(made.model)}).core();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_DOUBLE_EQ(broken.min[axis], whole.min[axis]) << axis;
    EXPECT_DOUBLE_EQ(broken.max[axis], whole.max[axis]) << axis;
  }
}

// A hundred thousand rays and as many triangles in one place: tried one by one they would take many minutes. The
// sliver has little area, and some.
TEST(FitRays, TrianglesWithoutAreaAreNotTried) {
  MadeModel made;
  made.box(kStudy, true);
  Scene scene;
  scene.models = {{"made.glb"}};
  const TriangleRays alone(scene, {std::make_shared<const Model>(made.model)});
  const glm::vec3 point(1.1f, 1.3f, 0.7f), end(1.7f, 0.6f, 0.9f);
  made.quad(point, end, end + glm::vec3(0, 0, 1e-4f), point + glm::vec3(0, 0, 1e-4f));
  Mesh& mesh = made.model.meshes.back();
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {point, end, point});
  for (int i = 0; i < 50000; ++i) {
    for (const std::uint32_t k : {0u, 2u, 0u, 0u, 2u, 1u}) mesh.indices.push_back(first + k);
  }
  const TriangleRays among(scene, {std::make_shared<const Model>(made.model)});
  const glm::dvec3 from(-0.4, 1.2, 0.3);
  for (int i = 1; i < 100000; ++i) {
    const glm::dvec3 to(point + 0.01f * static_cast<float>(i % 99) * (end - point));
    const std::optional<SurfaceHit> hit = among.first(from, to - from), wall = alone.first(from, to - from);
    ASSERT_TRUE(hit && wall) << i;
    if (hit->distance > 1.01) {
      EXPECT_DOUBLE_EQ(hit->distance, wall->distance) << i;
    }
  }
  const std::optional<SurfaceHit> sliver = among.first({1.4, 2.0, 0.80005}, {0.0, -1.0, 0.0});
  ASSERT_TRUE(sliver);
  EXPECT_NEAR(2.0 - sliver->distance, 0.95, 1e-3);
}

TEST(FitRays, ADistanceCubeIsEnough) {
  MadeModel made;
  made.box(kStudy, true);
  Scene scene;
  scene.models = {{"made.glb"}};
  const TriangleRays triangles(scene, {std::make_shared<const Model>(made.model)});
  const glm::dvec3 origin(0.3, 1.2, -0.4);
  const glm::dmat3 worldFromMap = rotationMatrix({0.0, 20.0, 0.0});
  constexpr int kSize = 64;
  CubeMap distance = test::distanceCube(triangles, origin, worldFromMap, kSize);
  for (int face = 0; face < 6; ++face) {  // a window at +x: nothing was seen there
    for (int row = 0; row < kSize; ++row) {
      for (int column = 0; column < kSize; ++column) {
        const auto centre = [](int i) { return (2.0f * static_cast<float>(i) + 1.0f) / kSize - 1.0f; };
        const glm::dvec3 along(glm::normalize(shading::cubeDirection(face, centre(column), centre(row))));
        const double length = distance.texel(0, face, column, row).x;
        const bool open = (worldFromMap * along).x * length > 3.3 - 0.31 && std::abs(along.y) < 0.1;
        if (open) distance.setTexel(0, face, column, row, glm::vec4(0.0f));
      }
    }
  }
  const DistanceRays rays(distance, origin, worldFromMap);
  for (int i = 1; i < 200; ++i) {
    const glm::dvec3 along = sphereDirection(vanDerCorput(i, 2), vanDerCorput(i, 3));
    const glm::dvec3 from = origin + 0.5 * sphereDirection(vanDerCorput(i, 5), vanDerCorput(i, 7));
    const std::optional<SurfaceHit> truth = triangles.first(from, along), marched = rays.first(from, along);
    if (!marched || (from + truth->distance * along).x > 2.9) continue;
    EXPECT_NEAR(marched->distance, truth->distance, 0.08 * truth->distance) << i;
  }
  Probe probe;
  probe.origin = origin;
  probe.box = {origin - 1.0, origin + 1.0};
  const std::optional<BoxFit> fit = fitBox({rays, rays, {}}, probe);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->outcome, FitOutcome::Fitted);
  EXPECT_NEAR(fit->probe.rotationDegrees.y, 0.0, 0.5);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(fit->probe.box.min[axis], kStudy.min[axis], 0.06) << axis;
    EXPECT_NEAR(fit->probe.box.max[axis], kStudy.max[axis], 0.06) << axis;
  }
}

TEST(FitRays, EyesAndProbesSeeDifferentObjects) {
  MadeModel made;
  made.box(kStudy, true);
  Model model = made.model;
  MadeModel block;
  block.box({glm::dvec3(-1, 0, -1), glm::dvec3(1, 1, 1)}, false);
  model.meshes.push_back(block.model.meshes.front());
  model.meshes.back().material = 0;
  model.materials.emplace_back().roughness = 0.25f;
  model.instances.push_back({"block", 1, glm::dmat4(1.0)});
  const auto shared = std::make_shared<const Model>(std::move(model));
  Scene scene;
  scene.models = {{"made.glb"}};
  scene.objects["block"].seenByProbes = false;
  const glm::dvec3 above(0.0, 2.0, 0.0), down(0.0, -1.0, 0.0);
  const std::optional<SurfaceHit> seen = TriangleRays(scene, {shared}).first(above, down);
  EXPECT_NEAR(seen->distance, 1.0, 1e-5);
  EXPECT_FLOAT_EQ(static_cast<float>(seen->roughness), 0.25f);
  EXPECT_NEAR(TriangleRays(scene, {shared}, SeenBy::Probes).first(above, down)->distance, 2.0, 1e-5);
  scene.objects["block"].seenByProbes = true;
  EXPECT_NEAR(TriangleRays(scene, {shared}, SeenBy::Probes).first(above, down)->distance, 1.0, 1e-5);
  EXPECT_NEAR(TriangleRays(scene, {shared}, SeenBy::Probes, {"block"}).first(above, down)->distance, 2.0, 1e-5);
}

}  // namespace
}  // namespace boxprobe
