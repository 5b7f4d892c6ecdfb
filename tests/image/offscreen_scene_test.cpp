// A scene off the screen: what it makes again for another scene and what it keeps, work that is stopped and goes on,
// two scenes in one window, and what it refuses.
#include "app/session/offscreen_scene.h"

#include <gtest/gtest.h>

#include "app/session/load_scene.h"
#include "filters/core/base/errors.h"

namespace boxprobe {
namespace {

class OffscreenSceneTest : public ::testing::Test {
 protected:
  static LoadedScene smallRoom() {
    return loadScene(BOXPROBE_DATA_DIR "/scenes/room.boxprobe.json",
                     {"probes.room.faceSize=16", "probes.room.samplesPerPixel=1", "probes.room.bounces=1"});
  }
  std::uint64_t faces() const { return shown.renderer().counters().facesCaptured; }

  const LoadedScene loaded = smallRoom();
  OffscreenScene shown{{"offscreen_scene_test", 64, 48, 1, false, true}};
};

TEST_F(OffscreenSceneTest, ASecondSceneMakesOnlyWhatDiffers) {
  shown.show(loaded.scene, loaded.models, {loaded.scene.cameras.front()});
  EXPECT_TRUE(shown.renderer().workPending()) << "show() must capture nothing";
  EXPECT_TRUE(shown.capture());
  const std::uint64_t first = faces();
  EXPECT_GT(first, 0u);
  Scene other = loaded.scene;
  other.exposure *= 2.0;
  shown.show(other, loaded.models);
  EXPECT_FALSE(shown.renderer().workPending());
  other.probes[0].origin.x += 0.25;
  shown.show(other, loaded.models);
  EXPECT_TRUE(shown.capture());
  EXPECT_EQ(faces(), 2 * first);
  shown.requireHealthy();
}

TEST_F(OffscreenSceneTest, StoppedWorkGoesOnWhereItWas) {
  shown.show(loaded.scene, loaded.models);
  int steps = 0;
  EXPECT_FALSE(shown.capture([&](double) { return ++steps < 2; }));
  EXPECT_EQ(steps, 2);
  EXPECT_TRUE(shown.renderer().workPending());
  EXPECT_TRUE(shown.capture());
  EXPECT_FALSE(shown.renderer().workPending());
}

TEST_F(OffscreenSceneTest, WhatIsForgottenIsMadeAnew) {
  shown.show(loaded.scene, loaded.models);
  shown.capture();
  const std::uint64_t first = faces();
  shown.forget();
  EXPECT_EQ(faces(), 0u);
  shown.show(loaded.scene, loaded.models);
  shown.capture();
  EXPECT_EQ(faces(), first);
}

TEST_F(OffscreenSceneTest, WithoutProbesNothingIsCaptured) {
  ShownSettings settings;
  settings.probes = false;
  shown.show(loaded.scene, loaded.models, settings);
  EXPECT_TRUE(shown.capture());
  EXPECT_EQ(faces(), 0u);
}

TEST_F(OffscreenSceneTest, OfTwoInOneWindowTheDrawnOneMakesThePicture) {
  const Camera& camera = loaded.scene.cameras.front();
  shown.show(loaded.scene, loaded.models, {camera});
  shown.capture();
  const ImageRgba8 alone = shown.renderer().renderDisplay();
  OffscreenScene dark(shown.window());
  Scene without = loaded.scene;
  without.exposure = 0.0001;
  dark.show(without, loaded.models, {camera});
  dark.capture();
  shown.setDrawn(false);
  EXPECT_NE(dark.renderer().renderDisplay().pixels, alone.pixels);
  shown.setDrawn(true);
  dark.setDrawn(false);
  EXPECT_EQ(shown.renderer().renderDisplay().pixels, alone.pixels);
  EXPECT_GT(shown.timedFrame(), 0.0);
}

TEST_F(OffscreenSceneTest, ACustomProbeWhosePictureIsMissingIsRefused) {
  Scene scene = loaded.scene;
  scene.probes[0].mode = ProbeMode::Custom;
  scene.probes[0].image = "/there/is/no/such.exr";
  EXPECT_THROW(shown.show(scene, loaded.models), InputError);
}

}  // namespace
}  // namespace boxprobe
