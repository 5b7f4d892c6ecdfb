// Ambient occlusion under the sky: the picture against the account of its pixels, which reads the lattice on the CPU.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <vector>

#include "filters/explain/explanation.h"
#include "filters/fit/rays/triangle_sight.h"
#include "tests/support/scene_picture.h"

namespace boxprobe::test {
namespace {

// A driver may filter with weights of 8 bits: one for each of three axes, for the share and for a moment of at most 1.
const float kFilter = 3.0f / 256.0f * (1.0f + std::sqrt(3.0f));

// Without probes the sky lights the building, past what stands in it.
TEST(SkyOcclusion, IsThatOfTheExplanation) {
  constexpr int kWidth = 240, kHeight = 135;
  std::vector<glm::ivec2> pixels;
  for (int i = 0; i < 6000; ++i) pixels.emplace_back((i * 37) % kWidth, (i * 53) % kHeight);
  Scene scene = ScenePicture::fromFile("scenes/building.boxprobe.json", 8, 8).scene;
  scene.probes.clear();
  for (auto& [name, material] : scene.materials) material.roughness = 0.7f;
  ScenePicture picture(scene, kWidth, kHeight);
  picture.renderer->setSightLines(traceSightLines);
  for (const Camera& camera : {picture.scene.cameras.front(), picture.scene.cameras.back()}) {
    picture.scene.ambientOcclusion = false;
    picture.show(camera);
    const ImageRgbaF open = picture.linear(1);
    picture.scene.ambientOcclusion = true;
    picture.show(camera);
    const ImageRgbaF image = picture.linear(1);
    keepPicture(image, "partly_hidden_sky_" + camera.name);
    std::size_t compared = 0, beyond = 0, darker = 0;
    for (const Explanation& e : picture.renderer->explain(pixels, kWidth, kHeight)) {
      if (!e.hit) continue;
      const auto at = static_cast<std::size_t>(e.y * kWidth + e.x) * 4;
      const glm::vec3 drawn(image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]);
      const glm::vec3 d = glm::abs(drawn - e.color);
      const glm::vec3 all(open.pixels[at], open.pixels[at + 1], open.pixels[at + 2]);
      ++compared;
      beyond += std::max({d.x, d.y, d.z}) <= kFilter * std::max({all.x, all.y, all.z}) ? 0 : 1;
      darker += drawn.y < 0.8f * open.pixels[at + 1] ? 1 : 0;
    }
    std::printf("  %s: %zu of %zu pixels differ, %zu are darker by a fifth\n", camera.name.c_str(), beyond, compared,
                darker);
    EXPECT_GT(compared, 2000u);
    EXPECT_GT(darker, compared / 10);
    EXPECT_LE(beyond, compared / 500);
  }
}

}  // namespace
}  // namespace boxprobe::test
