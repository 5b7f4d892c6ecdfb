// A technique added as shaders/technique/README.md says is known everywhere by its row alone: to scene files, to the
// picture and to the explanation, which agree about it.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/common.hpp>

#include "filters/math/technique/technique_table.h"
#include "tests/support/scene_picture.h"

namespace boxprobe {
namespace {

constexpr int kWidth = 160, kHeight = 90;

TEST(AddedTechnique, IsARowLikeAnyOther) {
  const auto technique = parseTechnique("halved");
  ASSERT_TRUE(technique);
  EXPECT_EQ(techniqueId(*technique), "box+halved");
  EXPECT_NE(techniqueIdList().find("halved"), std::string::npos);
  Scene scene;
  scene.models.push_back({});
  scene.models.back().file = "room.glb";
  scene.cameras.emplace_back();
  scene.probes.emplace_back();
  scene.probes.back().technique = "sphere+halved";
  EXPECT_NO_THROW(validate(scene));
}

TEST(AddedTechnique, DrawsAndIsExplained) {
  test::ScenePicture picture = test::ScenePicture::fromFile("scenes/room.boxprobe.json", kWidth, kHeight);
  for (auto& [name, material] : picture.scene.materials) material.roughness = 0.5f;
  for (Probe& probe : picture.scene.probes) probe.technique = "halved";
  const Camera camera = test::cameraNamed(picture.scene, "main");
  picture.show(camera);
  std::vector<glm::ivec2> pixels;
  for (int y = 5; y < kHeight; y += 10) {
    for (int x = 5; x < kWidth; x += 10) pixels.emplace_back(x, y);
  }
  int halved = 0;
  for (const Explanation& e : picture.renderer->explain(pixels, kWidth, kHeight)) {
    if (e.probes.empty() || e.probes[0].lookups.size() != 1) continue;
    EXPECT_EQ(e.probes[0].technique, "box+halved");
    EXPECT_NEAR(e.probes[0].lookups[0].roughness, 0.5f * e.surface.roughness, 1e-3f);
    ASSERT_TRUE(e.rendered);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(e.color[i], (*e.rendered)[i], 2e-3f * std::max(1.0f, e.brightestTexel));
    ++halved;
  }
  EXPECT_GT(halved, 20);
  EXPECT_TRUE(picture.renderer->error().empty()) << picture.renderer->error();
}

}  // namespace
}  // namespace boxprobe
