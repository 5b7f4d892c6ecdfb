// The studio's levels come with the program: nothing of the sky is captured for a bare model, and what is read is what
// would be captured.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "filters/io/cube/sky_levels.h"

namespace boxprobe {
namespace {

namespace fs = std::filesystem;

class ShippedSky : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder);
    fs::copy_file(studioFile(), folder / "studio.hdr", fs::copy_options::overwrite_existing);
    fs::copy_file(skyLevelsFile(studioFile()), folder / "studio.levels", fs::copy_options::overwrite_existing);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::shared_ptr<const BakedMaps> sky() {
    const LoadedScene loaded = loadScene(BOXPROBE_DATA_DIR "/scenes/room.glb", {"probes=[]"});
    Scene scene = loaded.scene;
    scene.sky = SkyImage{(folder / "studio.hdr").string()};
    shown.show(scene, loaded.models, {scene.cameras.front()});
    shown.capture();
    shown.requireHealthy();
    return shown.renderer().mapsOnCpu("");
  }
  const Counters& counters() { return shown.renderer().counters(); }

  const fs::path folder = fs::path(::testing::TempDir()) / ("shipped_sky_" + std::to_string(::getpid()));
  OffscreenScene shown{{"shipped_sky_test", 16, 16, 1, false, true}};
};

TEST_F(ShippedSky, IsReadAndNotCaptured) {
  const auto maps = sky();
  EXPECT_EQ(counters().mapsLoaded, 1u);
  EXPECT_EQ(counters().skyFacesCaptured, 0u);
  EXPECT_EQ(counters().levelsFiltered + counters().levelsMadeLater, 0u);
  EXPECT_GT(maps->radiance.levels(), 4);
}

// On Mesa's software renderer, which made the file, to the bit; cards and other releases round differently.
// `generate_levels data/environments` writes the file again if a change is meant.
TEST_F(ShippedSky, IsWhatACaptureMakes) {
  const auto shipped = sky();
  fs::remove(folder / "studio.levels");
  shown.forget();
  const auto made = sky();
  EXPECT_EQ(counters().mapsLoaded, 0u);
  EXPECT_EQ(counters().skyFacesCaptured, 6u);
  ASSERT_EQ(shipped->radiance.faceSize(), made->radiance.faceSize());
  ASSERT_EQ(shipped->radiance.levels(), made->radiance.levels());
  double worst = 0.0;
  for (int level = 0; level < made->radiance.levels(); ++level) {
    const int size = made->radiance.levelSize(level);
    for (int i = 0; i < 6 * 4 * size * size; ++i) {
      const double a = shipped->radiance.face(level, 0)[i], b = made->radiance.face(level, 0)[i];
      worst = std::max(worst, std::abs(a - b) / std::max(std::abs(b), 0.05));
    }
  }
  EXPECT_LE(worst, 0.004) << "of a texel's value; a display step of white is .009";
  for (std::size_t i = 0; i < 9; ++i) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(shipped->irradiance[i][c], made->irradiance[i][c], 0.001);
  }
}

TEST_F(ShippedSky, IsCapturedWhereTheFileIsDamagedOrOfAnotherPicture) {
  {
    std::fstream file(folder / "studio.levels", std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(5000);
    file.put('x');
  }
  sky();
  EXPECT_EQ(counters().skyFacesCaptured, 6u);
  EXPECT_EQ(counters().mapsLoaded, 0u);
  shown.forget();
  fs::copy_file(skyLevelsFile(studioFile()), folder / "studio.levels", fs::copy_options::overwrite_existing);
  fs::copy_file(BOXPROBE_DATA_DIR "/scenes/sky.hdr", folder / "studio.hdr", fs::copy_options::overwrite_existing);
  sky();
  EXPECT_EQ(counters().skyFacesCaptured, 6u);
  EXPECT_EQ(counters().mapsLoaded, 0u);
}

}  // namespace
}  // namespace boxprobe
