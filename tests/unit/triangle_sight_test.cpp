// What stands before a lamp and what does not: sight lines among the triangles of a scene.
#include "filters/fit/rays/triangle_sight.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace boxprobe {
namespace {

// Squares across the x axis, 2 wide, each a node of its own.
struct Row {
  Model model;
  Scene scene;

  Row() { scene.models = {{"row.glb"}}; }
  Material& square(const std::string& node, float x) {
    Mesh mesh;
    mesh.positions = {{x, -1, -1}, {x, 1, -1}, {x, 1, 1}, {x, -1, 1}};  // faces +x
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = static_cast<int>(model.materials.size());
    model.materials.emplace_back();
    model.materials.back().name = node;
    model.instances.push_back({node, static_cast<int>(model.meshes.size()), glm::dmat4(1.0)});
    model.meshes.push_back(std::move(mesh));
    return model.materials.back();
  }
  std::shared_ptr<const SightLines> lines() const {
    return traceSightLines(scene, {std::make_shared<const Model>(model)});
  }
};

bool blockedAt(const SightLines& lines, double x, bool shining = true) {
  return lines.blocked({x - 0.4, 0.1, 0.2}, {x + 0.3, 0.3, -0.1}, shining);
}

TEST(TriangleSight, KnowsWhatHidesALamp) {
  Row row;
  row.square("wall", 1.0f);
  row.square("glass", 3.0f).transmission = 1.0f;
  row.square("leaf", 5.0f).alphaMode = AlphaMode::Blend;
  row.square("cart", 7.0f);
  row.square("gone", 9.0f);
  row.square("shade", 11.0f).emissive = {2.0f, 1.0f, 0.5f};
  row.square("not captured", 13.0f);
  row.scene.objects["cart"].dynamic = true;
  row.scene.objects["gone"].visible = false;
  row.scene.objects["not captured"].seenByProbes = false;
  const auto lines = row.lines();
  ASSERT_FALSE(lines->empty());
  EXPECT_TRUE(blockedAt(*lines, 1.0));
  EXPECT_FALSE(blockedAt(*lines, 3.0));
  EXPECT_FALSE(blockedAt(*lines, 5.0));
  EXPECT_FALSE(blockedAt(*lines, 7.0));
  EXPECT_FALSE(blockedAt(*lines, 9.0));
  EXPECT_TRUE(blockedAt(*lines, 11.0));
  EXPECT_FALSE(blockedAt(*lines, 11.0, false)) << "a shade does not hide the bulb within";
  EXPECT_TRUE(blockedAt(*lines, 13.0));
  EXPECT_FALSE(lines->blocked({1.1, 0, 0}, {2.9, 0, 0}, true)) << "nothing stands between";
  EXPECT_FALSE(lines->blocked({0.5, 1.6, 0}, {1.5, 1.6, 0}, true)) << "past the wall";
}

TEST(TriangleSight, TellsFrontsFromBacks) {
  Row row;
  row.square("wall", 1.0f);
  row.square("lamp", 4.0f).emissive = {1.0f, 1.0f, 1.0f};
  const auto lines = row.lines();
  const auto front = lines->first({3.0, 0.2, 0.1}, {-1, 0, 0}), back = lines->first({0.25, 0.2, 0.1}, {1, 0, 0});
  ASSERT_TRUE(front && back);
  EXPECT_NEAR(front->distance, 2.0, 1e-5);
  EXPECT_FALSE(front->back);
  EXPECT_NEAR(back->distance, 0.75, 1e-5);
  EXPECT_TRUE(back->back);
  const auto lamp = lines->first({3.0, 0.2, 0.1}, {1, 0, 0});
  ASSERT_TRUE(lamp);
  EXPECT_NEAR(lamp->distance, 1.0, 1e-5);
  EXPECT_FALSE(lines->first({3.0, 0.2, 0.1}, {0, 1, 0}));
}

// An override that makes a material shine makes it a shade, and one that puts it out a wall.
TEST(TriangleSight, FollowsOverridesOfWhatShines) {
  Row row;
  row.square("a", 1.0f);
  row.square("b", 3.0f).emissive = {1.0f, 0.0f, 0.0f};
  row.scene.materials["a"].emissive = glm::vec3(0.5f);
  row.scene.materials["b"].emissive = glm::vec3(0.0f);
  const auto lines = row.lines();
  EXPECT_FALSE(blockedAt(*lines, 1.0, false));
  EXPECT_TRUE(blockedAt(*lines, 1.0, true));
  EXPECT_TRUE(blockedAt(*lines, 3.0, false));
}

TEST(TriangleSight, AnEmptySceneHidesNothing) {
  const auto lines = traceSightLines(Scene{}, {});
  EXPECT_TRUE(lines->empty());
  EXPECT_FALSE(lines->blocked({0, 0, 0}, {1, 0, 0}, true));
  EXPECT_FALSE(lines->first({0, 0, 0}, {1, 0, 0}));
}

}  // namespace
}  // namespace boxprobe
