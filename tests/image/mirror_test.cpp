// The floor mirror of `room` against the truth: the same room seen by a camera mirrored in the floor. Spheres are
// hidden, so the room is exactly the probe's box and whatever differs is this program's error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 640, kHeight = 360;

Scene emptyRoom() {
  Scene scene = ScenePicture::fromFile("scenes/room.boxprobe.json", 8, 8).scene;
  for (const char* sphere : {"sphere 1", "sphere 2", "sphere 3"}) scene.objects[sphere].visible = false;
  scene.materials["floor"].roughness = 0.0f;
  return scene;
}

// Where the floor is on the screen: it alone is made to glow.
std::vector<bool> floorMask(ScenePicture& picture, const Camera& camera) {
  const Scene kept = picture.scene;
  picture.scene.materials["floor"].emissive = glm::vec3(1000.0f, 0.0f, 1000.0f);
  picture.show(camera);
  const ImageRgbaF image = picture.linear(1);
  std::vector<bool> mask(image.pixels.size() / 4);
  for (std::size_t i = 0; i < mask.size(); ++i)
    mask[i] = image.pixels[4 * i] > 500.0f && image.pixels[4 * i + 2] > 500.0f;
  picture.scene = kept;
  // Pixels on the floor's border show wall as well.
  std::vector<bool> inner = mask;
  const auto texel = [](int x, int y) { return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x); };
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const auto& [dx, dy] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
        const int nx = std::clamp(x + dx, 0, kWidth - 1), ny = std::clamp(y + dy, 0, kHeight - 1);
        if (!mask[texel(nx, ny)]) inner[texel(x, y)] = false;
      }
    }
  }
  return inner;
}

ImageRgbaF truth(ScenePicture& picture, const Camera& camera) {
  const Scene kept = picture.scene;
  picture.scene.objects["floor"].visible = false;
  picture.show(mirroredInFloor(camera, 0.0));
  ImageRgbaF image = flippedTopToBottom(picture.fineLinear());
  picture.scene = kept;
  return image;
}

ImageRgbaF reflection(ScenePicture& picture, const Camera& camera, const std::string& technique, int faceSize) {
  picture.scene.probes[0].technique = technique;
  picture.scene.probes[0].faceSize = faceSize;
  picture.show(camera);
  return picture.linear();
}

TEST(Mirror, BoxProjectionAgainstTheMirroredCamera) {
  ScenePicture picture(emptyRoom(), kWidth, kHeight);
  // B and C see walls that meet the cube's faces at a grazing angle, where a texel covers 7 cm of wall, and the lamp's
  // edge, where a texel's mean of 50 and 0.5 clips: the same directions, less resolution.
  const struct {
    const char* camera;
    double atLeast, aboveInfinite;
  } targets[] = {{"main", 36.0, 20.0}, {"A", 36.0, 20.0}, {"B", 32.0, 19.0}, {"C", 32.0, 19.0}};
  for (const auto& target : targets) {
    const std::string name = target.camera;
    const Camera camera = cameraNamed(picture.scene, name);
    const std::vector<bool> mask = floorMask(picture, camera);
    const auto pixels = std::count(mask.begin(), mask.end(), true);
    ASSERT_GT(pixels, kWidth * kHeight / 20) << "camera " << name << " hardly sees the floor";
    const ImageRgbaF expected = truth(picture, camera);
    keepPicture(expected, "mirror_" + name + "_truth");

    const ImageRgbaF infinite = reflection(picture, camera, "infinite", 256);
    keepPicture(infinite, "mirror_" + name + "_infinite");
    const double infinitePsnr = psnr(infinite, expected, mask);
    std::printf("  camera %-4s %6ld floor pixels: infinite %5.2f dB, box", target.camera, pixels, infinitePsnr);
    double previous = 0.0;
    for (const int size : {128, 256, 512, 1024}) {
      const ImageRgbaF image = reflection(picture, camera, "box", size);
      keepPicture(image, "mirror_" + name + "_box" + std::to_string(size));
      const double value = psnr(image, expected, mask);
      std::printf(" | %d: %5.2f dB", size, value);
      if (size == 256) {
        EXPECT_GE(value, target.atLeast) << target.camera;
        EXPECT_GE(value, infinitePsnr + target.aboveInfinite) << target.camera;
      }
      // What is left falls with the texel size, so none of it is a wrong direction or a shift.
      EXPECT_GE(value, previous + (size <= 512 ? 1.5 : 0.5)) << target.camera << " at " << size;
      previous = value;
    }
    std::printf("\n");
  }
}

}  // namespace
