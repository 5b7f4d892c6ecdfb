// What is seen while a metal room without a scene is captured: never black metal, and the same picture in the end.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"

namespace boxprobe {
namespace {

constexpr int kWidth = 80, kHeight = 45;

/// Everything in it is metal, and nothing shines but lights.
LoadedScene metalRoom() {
  LoadedScene loaded = loadScene(BOXPROBE_DATA_DIR "/scenes/furnished.glb", {"exposure=1.1"});
  for (const auto& model : loaded.models) {
    for (const Material& material : model->materials) {
      MaterialOverride& metal = loaded.scene.materials[material.name];
      metal.metallic = 1.0;
      metal.roughness = 0.27;
      metal.baseColor = glm::vec3(0.91f, 0.83f, 0.77f);
    }
  }
  for (Probe& probe : loaded.scene.probes) {
    probe.faceSize = 128;
    probe.bounces = 2;
  }
  return loaded;
}

/// Of the picture's pixels, those no brighter than 3 of 255.
double blackShare(const ImageRgba8& picture) {
  std::size_t black = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
    black += std::max({picture.pixels[i], picture.pixels[i + 1], picture.pixels[i + 2]}) <= 3 ? 1 : 0;
  }
  return static_cast<double>(black) / static_cast<double>(picture.pixels.size() / 4);
}

struct Seen {
  double firstBlack = 1.0;       ///< share of the first frame
  double secondsToMetal = -1.0;  ///< until less than a hundredth is black
  double leastBlack = 1.0;
  ImageRgba8 final;
  Counters counters;
};

/// A step, then a frame, as the window does it.
Seen watch(const LoadedScene& loaded, bool coarse) {
  OffscreenScene shown({"coarse_first_test", kWidth, kHeight, 1, false, true});
  shown.renderer().showCoarseFirst(coarse);
  const auto begin = std::chrono::steady_clock::now();
  shown.show(loaded.scene, loaded.models, {loaded.scene.cameras.front()});
  Seen seen;
  bool first = true;
  while (shown.renderer().workPending()) {
    shown.window()->MakeCurrent();
    shown.renderer().step();
    if (!first && seen.secondsToMetal >= 0.0) continue;
    const double black = blackShare(shown.renderer().renderDisplay());
    if (first) seen.firstBlack = black;
    first = false;
    if (black < 0.01 && seen.secondsToMetal < 0.0) {
      seen.secondsToMetal = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
  }
  shown.requireHealthy();
  seen.final = shown.renderer().renderDisplay();
  seen.counters = shown.renderer().counters();
  std::printf("  %s: %.0f %% of the first frame is black, metal is seen after %.2f s\n",
              coarse ? "coarse maps first" : "captures alone", 100.0 * seen.firstBlack, seen.secondsToMetal);
  return seen;
}

TEST(CoarseFirst, NoMetalIsBlackAndTheFinalPictureIsTheSame) {
  const LoadedScene loaded = metalRoom();
  ASSERT_FALSE(loaded.scene.probes.empty());
  const Seen without = watch(loaded, false), with = watch(loaded, true);
  EXPECT_GT(without.firstBlack, 0.05) << "else nothing is tested";
  EXPECT_EQ(with.firstBlack, 0.0);
  EXPECT_EQ(with.counters.coarseFaces, 6 * loaded.scene.probes.size());
  EXPECT_EQ(without.counters.coarseFaces, 0u);
  EXPECT_EQ(with.counters.facesCaptured, without.counters.facesCaptured);
  EXPECT_TRUE(with.final.pixels == without.final.pixels);
}

// Captures of a realtime probe see whatever is shown: nothing stands in for anything.
TEST(CoarseFirst, NotBesideRealtimeProbes) {
  LoadedScene loaded = metalRoom();
  for (Probe& probe : loaded.scene.probes) {
    probe.mode = ProbeMode::Realtime;
    probe.faceSize = 32;
  }
  OffscreenScene shown({"coarse_first_test", kWidth, kHeight, 1, false, true});
  shown.renderer().showCoarseFirst(true);
  shown.show(loaded.scene, loaded.models, {loaded.scene.cameras.front()});
  shown.capture();
  EXPECT_EQ(shown.renderer().counters().coarseFaces, 0u);
}

}  // namespace
}  // namespace boxprobe
