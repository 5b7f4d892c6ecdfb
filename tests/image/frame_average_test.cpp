// Pictures of techniques that draw another pattern every frame: their mean, what begins it again, and what it costs
// where nothing asks for it.
#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include <functional>

#include "filters/core/scene/document.h"
#include "filters/reference/measure/metrics.h"
#include "tests/image/noisy_room.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

TEST(FrameAverage, FramesOfOneRayComeToOneFrameOfAsManyRays) {
  ScenePicture picture(noisyRoom(1), kWidth, kHeight);
  picture.show(mainCamera(picture.scene));
  const ImageRgbaF truth = truthOf(picture).picture;
  for (const char* pattern : {"white", "blue", "r2"}) {
    setParameters(picture, {{"samples", 64.0}, {"pattern", std::string(pattern)}});
    const double atOnce = pictureError(picture.linear(1), truth).toneMappedRmse;
    setParameters(picture, {{"samples", 1.0}, {"animated", true}, {"pattern", std::string(pattern)}});
    const double one = pictureError(picture.linear(1), truth).toneMappedRmse;
    const ImageRgbaF mean = picture.renderer->renderLinear(kWidth, kHeight, 1, 64);
    const double averaged = pictureError(mean, truth).toneMappedRmse;
    std::printf("  %-5s one ray %.5f, 64 in one frame %.5f, in 64 frames %.5f\n", pattern, one, atOnce, averaged);
    EXPECT_LT(averaged, 1.1 * atOnce) << pattern;
    EXPECT_GT(averaged, 0.9 * atOnce) << pattern;
    EXPECT_GT(one, 1.5 * averaged) << pattern;

    // The window's own path: frame after frame, shown exposed.
    picture.renderer->setFrameLimit(64);
    ImageRgba8 shown;
    for (int i = 0; i < 64; ++i) shown = picture.display();
    EXPECT_EQ(picture.renderer->frameCount().averaged, 64);
    EXPECT_FALSE(picture.renderer->frameCount().more());
    EXPECT_LE(largestDifference(shown, mean, picture.scene.exposure), 0.6) << pattern << ": rounding and no more";
  }
}

// Whatever is edited: the picture that follows is the first frame of a renderer that never saw anything else.
TEST(FrameAverage, NothingOfAnEarlierMomentIsLeft) {
  struct Edit {
    const char* name;
    std::function<void(Scene&)> change;
  };
  const std::vector<Edit> edits = {
      {"box", [](Scene& s) { s.probes[0].box.max.x += 0.3; }},
      {"origin", [](Scene& s) { s.probes[0].origin.y += 0.2; }},
      {"material", [](Scene& s) { s.materials["floor"].roughness = 0.2f; }},
      {"light",
       [](Scene& s) {
         if (s.lights.empty()) s.lights.emplace_back();
         s.lights[0].intensity += 0.5f;
       }},
      {"technique", [](Scene& s) { s.probes[0].technique = "infinite+raytraced"; }},
      {"samples", [](Scene& s) { s.probes[0].parameters["samples"] = 3.0; }},
      {"exposure", [](Scene& s) { s.exposure *= 1.5; }},
      {"object", [](Scene& s) { s.objects["sphere 1"].visible = false; }},
  };
  const auto fresh = [](const Scene& scene, const Camera& camera) {
    ScenePicture picture(scene, kWidth, kHeight);
    picture.show(camera);
    return picture.display();
  };
  const Scene original = noisyRoom(2);
  const Camera camera = mainCamera(original);
  const ImageRgba8 before = fresh(original, camera);
  ScenePicture picture(original, kWidth, kHeight);
  picture.show(camera);
  SceneRenderer& renderer = *picture.renderer;
  const auto average = [&](int frames) {
    for (int i = 0; i < frames; ++i) picture.display();
  };
  const auto sync = [&](const Scene& next) {
    const Changes changes = difference(picture.scene, next);
    picture.scene = next;
    renderer.sync(picture.scene, changes);
    renderer.finishWork();
  };
  for (const Edit& edit : edits) {
    average(3);
    EXPECT_GT(renderer.frameCount().averaged, 2) << edit.name;
    Scene edited = original;
    edit.change(edited);
    sync(edited);
    EXPECT_TRUE(picture.display().pixels == fresh(edited, camera).pixels) << edit.name;
    EXPECT_EQ(renderer.frameCount().averaged, 1) << edit.name;
    average(2);
    sync(original);
    EXPECT_TRUE(picture.display().pixels == before.pixels) << edit.name << ", undone";
  }
  average(3);
  Camera moved = camera;
  moved.position.x += 0.05;
  renderer.applyCamera(moved);
  EXPECT_TRUE(picture.display().pixels == fresh(original, moved).pixels) << "camera";
  renderer.applyCamera(camera);
  average(3);
  picture.window->SetSize(kWidth / 2, kHeight);
  picture.display();
  EXPECT_EQ(renderer.frameCount().averaged, 1) << "size";
  picture.window->SetSize(kWidth, kHeight);
  EXPECT_TRUE(picture.display().pixels == before.pixels) << "size, back";
  average(2);
  renderer.setProbesEnabled(false);
  picture.display();
  renderer.setProbesEnabled(true);
  EXPECT_TRUE(picture.display().pixels == before.pixels) << "reflections off and on";
}

TEST(FrameAverage, ACompletePictureIsNotDrawnAgainButShown) {
  ScenePicture picture(noisyRoom(1), kWidth, kHeight);
  picture.show(mainCamera(picture.scene));
  EXPECT_EQ(framesWanted(1), 1024);
  EXPECT_EQ(framesWanted(64), 64);
  EXPECT_EQ(framesWanted(256), 16);
  EXPECT_TRUE(picture.renderer->averagesFrames());
  picture.renderer->setFrameLimit(3);
  ImageRgba8 third;
  for (int i = 0; i < 3; ++i) third = picture.display();
  const std::uint64_t uploads = picture.renderer->counters().uniformUpdates;
  EXPECT_TRUE(picture.display().pixels == third.pixels);
  EXPECT_EQ(picture.renderer->counters().uniformUpdates, uploads) << "no surface was drawn";
  picture.renderer->setFrameLimit(4);
  EXPECT_FALSE(picture.display().pixels == third.pixels);
}

TEST(FrameAverage, CostsNothingWhereNoTechniqueAsksForIt) {
  ScenePicture picture(noisyRoom(4), kWidth, kHeight);
  picture.scene.probes[0].parameters["animated"] = false;
  picture.show(mainCamera(picture.scene));
  const ImageRgba8 first = picture.display();
  const std::uint64_t programs = picture.renderer->counters().programsCompiled;
  EXPECT_TRUE(picture.display().pixels == first.pixels);
  EXPECT_EQ(picture.renderer->renderer()->GetPass(), nullptr);
  EXPECT_EQ(picture.renderer->frameCount().wanted, 0);
  setParameters(picture, {{"samples", 4.0}, {"animated", true}});
  picture.display();
  EXPECT_EQ(picture.renderer->counters().programsCompiled, programs + 2) << "adding a frame, and showing the mean";
  setParameters(picture, {{"samples", 4.0}});
  EXPECT_TRUE(picture.display().pixels == first.pixels);
  EXPECT_EQ(picture.renderer->renderer()->GetPass(), nullptr);
}

}  // namespace
