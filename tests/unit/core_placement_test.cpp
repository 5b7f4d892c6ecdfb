// What a model's entry does to what comes with the file: every number another one, so that none is taken for another.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/geometry/model_placement.h"
#include "filters/core/geometry/world_extent.h"
#include "tests/unit/error_text.h"

namespace boxprobe {
namespace {

ModelFile centimetres() {
  ModelFile file;
  file.unit = LengthUnit::Centimetre;
  file.scale = 1.7;
  file.translation = {3.1, -0.4, 12.5};
  file.rotationDegrees = {0.0, 90.0, 0.0};
  return file;
}

TEST(Placement, ACameraOfAFileInCentimetresIsInMetres) {
  Model model;
  Camera camera;
  camera.position = {120.0, 250.0, -70.0};
  camera.target = {10.0, 40.0, 330.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.verticalFovDegrees = 37.0;
  camera.parallelHeight = 460.0;
  model.cameras.push_back(camera);
  const std::vector<Camera> placed = placedCameras(model, centimetres());
  ASSERT_EQ(placed.size(), 1u);
  // 90 degrees about +Y take +Z to +X and +X to -Z.
  constexpr double kMetres = 0.01 * 1.7;
  EXPECT_NEAR(glm::length(placed[0].position -
                          glm::dvec3(3.1 - 70.0 * kMetres, -0.4 + 250.0 * kMetres, 12.5 - 120.0 * kMetres)),
              0.0, 1e-12);
  EXPECT_NEAR(
      glm::length(placed[0].target - glm::dvec3(3.1 + 330.0 * kMetres, -0.4 + 40.0 * kMetres, 12.5 - 10.0 * kMetres)),
      0.0, 1e-12);
  EXPECT_NEAR(placed[0].parallelHeight, 460.0 * kMetres, 1e-12);
  EXPECT_EQ(placed[0].verticalFovDegrees, 37.0);
  EXPECT_NEAR(glm::length(placed[0].up), 1.0, 1e-12);
}

TEST(Placement, ALightOfAFileInCentimetresReachesAsFarInMetres) {
  Model model;
  Light light;
  light.type = LightType::Spot;
  light.position = {20.0, 310.0, 45.0};
  light.direction = {0.0, 0.0, 2.0};
  light.range = 640.0;
  light.intensity = 7.5f;
  model.lights.push_back(light);
  const std::vector<Light> placed = placedLights(model, centimetres());
  ASSERT_EQ(placed.size(), 1u);
  constexpr double kMetres = 0.01 * 1.7;
  EXPECT_NEAR(
      glm::length(placed[0].position - glm::dvec3(3.1 + 45.0 * kMetres, -0.4 + 310.0 * kMetres, 12.5 - 20.0 * kMetres)),
      0.0, 1e-12);
  EXPECT_NEAR(glm::length(placed[0].direction - glm::dvec3(1.0, 0.0, 0.0)), 0.0, 1e-12);
  EXPECT_NEAR(placed[0].range, 640.0 * kMetres, 1e-12);
  EXPECT_EQ(placed[0].intensity, 7.5f);
}

// So many triangles of one place, or each a step behind the last; half of them at each of two nodes, and as many that
// lie apart. The last corner decides whether they have an area.
void checkPile(std::size_t count, float step, const glm::vec3& last) {
  auto model = std::make_shared<Model>();
  Mesh& mesh = model->meshes.emplace_back();
  const auto add = [&mesh, &last](const glm::vec3& at) {
    for (const glm::vec3& corner : {glm::vec3(0.2f, 0.1f, 0.0f), glm::vec3(0.7f, 0.3f, 0.0f), last}) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(at + corner);
    }
  };
  for (std::size_t i = 0; i < count / 2; ++i) {
    add({1.3f, 0.1f, 0.7f + step * static_cast<float>(i)});
    add({1.3f, 0.1f, -40.0f - 0.01f * static_cast<float>(i)});
  }
  model->instances = {{"a", 0, glm::dmat4(1.0)}, {"b", 0, glm::dmat4(1.0)}};
  model->instances[1].worldFromModel[3] = {0.05, 0.0, 0.0, 1.0};
  Scene scene;
  scene.models = {centimetres()};
  scene.models[0].file = "pile.stl";
  checkGeometry(scene, {model});
}

TEST(Geometry, TooManyTrianglesInOnePlaceAreRefused) {
  const glm::vec3 corner(0.4f, 0.9f, 0.0f);
  const std::size_t most = limits::kTrianglesInOnePlace;
  EXPECT_NO_THROW(checkPile(most, 0.0f, corner));
  EXPECT_NO_THROW(checkPile(10 * most, 0.01f, corner)) << "one behind the other";
  EXPECT_NO_THROW(checkPile(10 * most, 0.0f, glm::vec3(0.2f, 0.1f, 0.0f))) << "without an area";
  const std::string line = errorText([&] { checkPile(10 * most, 0.0f, corner); });
  EXPECT_EQ(line.find("pile.stl: node \""), 0u) << line;
  EXPECT_NE(line.find(" triangles overlap; at most 20000 can be traced in one place"), std::string::npos) << line;
}

}  // namespace
}  // namespace boxprobe
