// The path-traced reference against an independent path tracer: Cycles' pictures of the lit scenes, see ../README.md.
// Prints a row for every scene, camera and count of bounces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>

#include "app/session/load_scene.h"
#include "filters/core/base/errors.h"
#include "filters/reference/path/reference_path.h"
#include "tests/truth/lit/lit_pictures.h"

namespace {

using namespace boxprobe;

constexpr double kLargestLightError = 0.015, kLargestRmse = 0.02, kLargestDimError = 0.02;

/// Relative RMS over blocks that the tracer's own noise is to have. Its square is taken off, but not its chance: a
/// fifth of it is left.
double aimedNoise() {
  const char* given = std::getenv("BOXPROBE_LIT_NOISE");
  return given != nullptr ? std::max(std::atof(given), 1e-4) : 0.025;
}

/// As many as bring Cycles to that noise, for each of two pictures.
int raysFor(const LitPicture& picture) {
  const double rays = picture.samples * std::pow(picture.noise / aimedNoise(), 2.0);
  return static_cast<int>(std::clamp(rays, 16.0, 65536.0));
}

const Camera& cameraOf(const Scene& scene, const std::string& name) {
  for (const Camera& camera : scene.cameras) {
    if (camera.name == name) return camera;
  }
  throw InputError("the scene has no camera " + name);
}

class PathTruth : public ::testing::TestWithParam<const char*> {};

TEST_P(PathTruth, HoldsToCycles) {
  const LitIndex index = loadLitIndex();
  const LoadedScene loaded = loadScene(index.scenePath(GetParam()));
  const ReferencePath tracer(loaded.scene, loaded.models, loadSkyImage(loaded.scene));
  std::printf("  scene, camera, bounces; light, relative RMSE, light of the darker half; noise of Cycles, own; rays\n");
  std::size_t rows = 0;
  for (const LitPicture& picture : index.pictures) {
    if (picture.scene != GetParam()) continue;
    ImageRgbaF seen[2];
    PathSettings settings;
    settings.width = index.width;
    settings.height = index.height;
    settings.raysPerPixel = raysFor(picture);
    settings.bounces = picture.bounces;
    for (std::uint64_t i = 0; i < 2; ++i) {
      settings.seed = 101 + i;
      seen[i] = tracer.render(cameraOf(loaded.scene, picture.camera), settings).color;
    }
    const LitError error = litError(index, picture, loadLitPicture(index, picture), seen[0], seen[1]);
    const auto mark = [](bool holds) { return holds ? ' ' : '!'; };
    const bool light = std::abs(error.meanLight - 1.0) <= kLargestLightError;
    const bool rmse = error.relativeRmse <= kLargestRmse;
    const bool dim = std::abs(error.dimLight - 1.0) <= kLargestDimError + 2.0 * error.dimNoise;
    std::printf("  %-12s %-8s %3s  %.4f%c  %.4f%c  %.3f (+-%.3f)%c  %.4f  %.4f  %5d\n", picture.scene.c_str(),
                picture.camera.c_str(), picture.bounceText().c_str(), error.meanLight, mark(light), error.relativeRmse,
                mark(rmse), error.dimLight, error.dimNoise, mark(dim), picture.noise, error.noise,
                settings.raysPerPixel);
    EXPECT_TRUE(light) << picture.file;
    EXPECT_TRUE(rmse) << picture.file;
    EXPECT_TRUE(dim) << picture.file;
    ++rows;
  }
  EXPECT_EQ(rows, 8u);
}

INSTANTIATE_TEST_SUITE_P(Lit, PathTruth,
                         ::testing::Values("closed", "doorway", "window", "furniture", "object", "cornell-box",
                                           "living-room"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
