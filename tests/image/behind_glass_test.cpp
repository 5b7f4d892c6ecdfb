// What stands behind glass, seen through it in the frame: without a probe, blurred by roughness, and at no cost where
// the glass is clear enough to be blended or where there is none.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/scene_picture.h"
#include "tests/support/shown_light.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

/// The room without a probe below a black sky, one object of glass in it: the frame alone can show what is behind.
Scene roomWith(const std::string& object) {
  Scene scene = ScenePicture::fromFile("scenes/glass.boxprobe.json", 8, 8).scene;
  for (const char* other : {"ball", "block", "prism", "ring", "cup", "pane"}) {
    if (object != other) scene.objects[other].visible = false;
  }
  scene.probes.clear();
  scene.sky = SkyColor{{0.0f, 0.0f, 0.0f}};
  scene.materials[object].attenuationDistance = 0.0f;
  scene.materials[object].glass = GlassForm::OnePass;
  return scene;
}

/// Sum of the light of the pixels in which `b` differs from `a`, and of the differences between neighbours in a row.
struct Seen {
  double light = 0.0, detail = 0.0;
  int pixels = 0;
};
Seen whereItDiffers(const ImageRgbaF& image, const ImageRgbaF& a, const ImageRgbaF& b) {
  const auto differs = [&](std::size_t at) { return std::abs(a.pixels[4 * at + 1] - b.pixels[4 * at + 1]) > 1e-4f; };
  Seen seen;
  for (std::size_t i = 1; i < image.pixels.size() / 4; ++i) {
    if (!differs(i) || !differs(i - 1)) continue;
    const auto green = [&](std::size_t at) { return static_cast<double>(image.pixels[4 * at + 1]); };
    seen.light += green(i);
    seen.detail += std::abs(green(i) - green(i - 1));
    ++seen.pixels;
  }
  return seen;
}

TEST(BehindGlass, IsSeenWithoutAProbeAndBlurredByRoughness) {
  for (const char* object : {"pane", "block"}) {
    ScenePicture picture(roomWith(object), 160, 128);
    const Camera view = cameraNamed(picture.scene, object);
    picture.scene.objects[object].visible = false;
    picture.show(view);
    const ImageRgbaF bare = picture.linear(4);
    picture.scene.objects[object].visible = true;
    double before = 1.0;
    for (const float roughness : {0.1f, 0.5f}) {
      picture.scene.materials[object].roughness = roughness;
      picture.show(view);
      const ImageRgbaF drawn = picture.linear(4);
      keepPicture(drawn, std::string("behind ") + object + " " + std::to_string(roughness).substr(0, 3));
      const Seen behind = whereItDiffers(bare, bare, drawn), through = whereItDiffers(drawn, bare, drawn);
      const double light = through.light / behind.light, detail = through.detail / behind.detail;
      std::printf("  %-6s roughness %.1f (%d pixels): %.3f of the light behind, %.3f of its detail\n", object,
                  static_cast<double>(roughness), through.pixels, light, detail);
      EXPECT_GT(through.pixels, 500) << object;
      EXPECT_GT(light, 0.7) << object << " " << roughness;
      EXPECT_LT(light, 1.1) << object << " " << roughness;
      EXPECT_LT(detail, before) << object << " " << roughness;
      before = detail;
    }
  }
}

// In the window's picture as in the linear one.
TEST(BehindGlass, IsSeenOnTheScreen) {
  ScenePicture picture(roomWith("block"), 160, 128);
  const Camera view = cameraNamed(picture.scene, "block");
  picture.scene.materials["block"].roughness = 0.1f;
  picture.show(view);
  const ImageRgba8 shown = picture.display();
  const ImageRgbaF linear = picture.linear(1);
  double sum = 0.0, wanted = 0.0;
  for (std::size_t i = 0; i < shown.pixels.size(); i += 4) {
    sum += shown.pixels[i + 1] / 255.0;
    wanted += shownLight(linear.pixels[i + 1] * picture.scene.exposure);
  }
  EXPECT_NEAR(sum / wanted, 1.0, 0.01);
}

TEST(BehindGlass, CostsNothingWhereGlassIsClearOrAway) {
  ScenePicture picture(roomWith("pane"), 96, 72);
  picture.scene.materials["pane"].roughness = 0.0f;
  picture.show(cameraNamed(picture.scene, "pane"));
  picture.display();
  const std::uint64_t clear = picture.renderer->counters().programsCompiled;
  picture.display();
  EXPECT_EQ(picture.renderer->counters().programsCompiled, clear);
  picture.scene.materials["pane"].roughness = 0.5f;
  picture.show(cameraNamed(picture.scene, "pane"));
  picture.display();
  EXPECT_GT(picture.renderer->counters().programsCompiled, clear) << "the copy and what puts it on the screen";
}

}  // namespace
