// Smoothing of sampled reflections: nearer to the integral with few rays, at edges too, and nothing else touched.
#include <gtest/gtest.h>

#include "filters/io/gltf/model_file.h"
#include "filters/reference/measure/metrics.h"
#include "tests/image/noisy_room.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

ImageRgbaF drawn(ScenePicture& picture, double samples, bool blur, int frames = 1) {
  setParameters(picture, {{"samples", samples}, {"blur", blur}, {"animated", frames > 1}});
  return picture.renderer->renderLinear(kWidth, kHeight, 1, frames);
}

TEST(ReflectionBlur, LowersTheErrorOfFewRays) {
  for (const float roughness : {0.2f, 0.35f, 0.5f, 0.75f}) {
    ScenePicture picture(noisyRoom(4), kWidth, kHeight);
    picture.scene.materials["floor"].roughness = roughness;
    picture.show(mainCamera(picture.scene));
    const NoisyRoomTruth truth = truthOf(picture);
    for (const double samples : {1.0, 4.0, 16.0, 64.0}) {
      const ImageRgbaF sharp = drawn(picture, samples, false), smooth = drawn(picture, samples, true);
      const double before = pictureError(sharp, truth.picture, truth.rough).toneMappedRmse;
      const double after = pictureError(smooth, truth.picture, truth.rough).toneMappedRmse;
      const double edgesBefore = pictureError(sharp, truth.picture, truth.edges).toneMappedRmse;
      const double edgesAfter = pictureError(smooth, truth.picture, truth.edges).toneMappedRmse;
      std::printf("  roughness %.2f, %2.0f rays: %.4f -> %.4f, at edges %.4f -> %.4f\n", static_cast<double>(roughness),
                  samples, before, after, edgesBefore, edgesAfter);
      if (samples == 1.0 || samples == 64.0) continue;
      EXPECT_LT(after, before) << roughness << ", " << samples;
      // Below, it reaches less than a pixel, and what is within two of an object is a sharp contact's reflection.
      if (roughness < 0.3f) continue;
      EXPECT_LT(edgesAfter, 1.05 * edgesBefore) << roughness << ", " << samples;
    }
    const double plain = pictureError(drawn(picture, 1.0, false, 16), truth.picture, truth.rough).toneMappedRmse;
    const double both = pictureError(drawn(picture, 1.0, true, 16), truth.picture, truth.rough).toneMappedRmse;
    std::printf("  roughness %.2f, 16 frames of one ray: %.4f -> %.4f\n", static_cast<double>(roughness), plain, both);
    EXPECT_LT(both, plain) << roughness;
  }
}

TEST(ReflectionBlur, TouchesNothingElse) {
  ScenePicture picture(noisyRoom(4), kWidth, kHeight);
  picture.show(mainCamera(picture.scene));
  const NoisyRoomTruth truth = truthOf(picture);
  const ImageRgbaF sharp = drawn(picture, 4.0, false), smooth = drawn(picture, 4.0, true);
  int unlit = 0;
  for (std::size_t i = 0; i < truth.rough.size(); ++i) {
    if (truth.reflecting[i]) continue;
    ++unlit;
    for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(smooth.pixels[4 * i + c], sharp.pixels[4 * i + c]) << i;
  }
  EXPECT_GT(unlit, 500);
  // A mirror's picture is all detail.
  picture.scene.materials["floor"].roughness = 0.0f;
  const ImageRgbaF mirror = drawn(picture, 4.0, false), same = drawn(picture, 4.0, true);
  EXPECT_LT(pictureError(same, mirror).toneMappedRmse, 1e-6);
}

// What is smoothed is put back under the factors it was drawn with. On a metal floor without lights everything is
// reflection, so that half of it is half of the picture, smoothed or not.
TEST(ReflectionBlur, SmoothsUnderTheOcclusionOfTheSurface) {
  constexpr float kByte = 94.0f / 255.0f, kStrength = 0.8f;
  std::vector<ImageRgbaF> pictures;
  for (const bool occluded : {false, true}) {
    Scene scene = noisyRoom(4);
    scene.lights.clear();
    scene.materials["floor"].metallic = 1.0f;
    std::vector<std::shared_ptr<const Model>> models;
    for (const ModelFile& file : scene.models) {
      Model model = loadModelFile(file.file);
      for (Mesh& mesh : model.meshes) mesh.uv.resize(mesh.positions.size());
      for (Material& material : model.materials) {
        if (!occluded || material.name != "floor") continue;
        auto image = std::make_shared<ImageRgba8>();
        image->width = image->height = 1;
        image->pixels = {94, 201, 33, 255};
        material.occlusionTexture.image = std::move(image);
        material.occlusionStrength = kStrength;
      }
      models.push_back(std::make_shared<const Model>(std::move(model)));
    }
    ScenePicture picture(scene, kWidth, kHeight);
    picture.show(mainCamera(picture.scene));
    picture.renderer->setModels(std::move(models));  // in place of the files'
    picture.show(mainCamera(picture.scene));
    for (const bool blur : {false, true}) pictures.push_back(drawn(picture, 4.0, blur));
  }
  const float share = 1.0f + kStrength * (kByte - 1.0f);
  int compared = 0, smoothed = 0;
  for (std::size_t i = 0; i < pictures[0].pixels.size(); ++i) {
    const float plain = pictures[0].pixels[i], soft = pictures[1].pixels[i];
    // Of the floor: what the occlusion changed.
    if (i % 4 == 3 || plain < 0.02f || std::abs(pictures[2].pixels[i] - plain) < 0.01f * plain) continue;
    ++compared;
    smoothed += std::abs(soft - plain) > 0.02f * plain ? 1 : 0;
    EXPECT_NEAR(pictures[2].pixels[i], share * plain, 2e-3f * plain) << i;
    EXPECT_NEAR(pictures[3].pixels[i], share * soft, 2e-3f * (plain + soft)) << i;
  }
  EXPECT_GT(compared, 3000);
  EXPECT_GT(smoothed, 1000);
}

// The window shows what the linear picture holds; switched off, its programs and its picture are those of before.
TEST(ReflectionBlur, IsTheSameInTheWindowAndLeavesNothingBehind) {
  ScenePicture picture(noisyRoom(4), kWidth, kHeight);
  setParameters(picture, {{"samples", 4.0}});
  const ImageRgba8 before = picture.display();
  const ImageRgbaF smooth = drawn(picture, 4.0, true);
  const ImageRgba8 shown = picture.display();
  const std::uint64_t programs = picture.renderer->counters().programsCompiled;
  EXPECT_FALSE(shown.pixels == before.pixels);
  EXPECT_LE(largestDifference(shown, smooth, picture.scene.exposure), 0.6);
  EXPECT_TRUE(picture.display().pixels == shown.pixels);
  setParameters(picture, {{"samples", 4.0}});
  EXPECT_TRUE(picture.display().pixels == before.pixels);
  EXPECT_EQ(picture.renderer->counters().programsCompiled, programs);
}

}  // namespace
