// Planes of planar mirrors: found, or refused with their place.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "filters/core/field_error.h"
#include "filters/core/mirror_plane.h"
#include "tests/unit/error_text.h"

namespace boxprobe {
namespace {

/// A node "pane" of two triangles: corner, and what stands off the plane at the last corner.
std::vector<std::shared_ptr<const Model>> pane(float off, bool turned = false) {
  auto model = std::make_shared<Model>();
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, off}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  if (turned) mesh.indices = {0, 1, 2, 0, 3, 2};
  model->meshes.push_back(mesh);
  glm::dmat4 at(1.0);
  at[3] = glm::dvec4(1.0e6, 5.0, -2.0, 1.0);
  model->instances.push_back({"pane", 0, at});
  return {model};
}

Scene paneScene() {
  Scene scene;
  scene.models.push_back({"pane.glb"});
  scene.mirrors["pane"] = {};
  return scene;
}

TEST(MirrorPlane, IsFoundWithItsRectangle) {
  Scene scene = paneScene();
  const auto plane = mirrorPlane(scene, pane(0.0f), "pane");
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->normal, glm::dvec3(0, 0, 1));
  EXPECT_FALSE(plane->bothSides);
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& corner : plane->corners) middle += 0.25 * corner;
  EXPECT_NEAR(glm::distance(middle, glm::dvec3(1.0e6 + 1.5, 6.0, -2.0)), 0.0, 1.0e-9);
  EXPECT_NEAR(glm::distance(plane->corners[0], plane->corners[1]) * glm::distance(plane->corners[1], plane->corners[2]),
              6.0, 1.0e-9);
  // The override moves it: turned about its node's origin, then moved.
  scene.objects["pane"].rotationDegrees = {0, 90, 0};
  scene.objects["pane"].translation = {0, 1, 0};
  const auto moved = mirrorPlane(scene, pane(0.0f), "pane");
  EXPECT_NEAR(glm::distance(moved->normal, glm::dvec3(1, 0, 0)), 0.0, 1.0e-12);
  EXPECT_NEAR(glm::distance(moved->center, glm::dvec3(1.0e6, 7.0, -3.5)), 0.0, 1.0e-9);
}

TEST(MirrorPlane, WhatIsNotFlatIsRefusedByName) {
  const Scene scene = paneScene();
  EXPECT_NO_THROW(checkMirrors(scene, pane(1.0e-4f)));
  const std::string bent = errorText([&] { checkMirrors(scene, pane(0.01f)); });
  EXPECT_EQ(bent.rfind("mirrors.pane: is not planar", 0), 0u) << bent;
  const std::string both = errorText([&] { checkMirrors(scene, pane(0.0f, true)); });
  EXPECT_NE(both.find("mirrors.pane"), std::string::npos) << both;
  EXPECT_FALSE(mirrorPlane(scene, pane(0.0f), "else"));
}

}  // namespace
}  // namespace boxprobe
