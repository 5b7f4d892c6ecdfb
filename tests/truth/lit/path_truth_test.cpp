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

constexpr double kLargestLightError = 0.015, kLargestRmse = 0.02;

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
    const double lightOff = std::abs(error.meanLight - 1.0);
    std::printf("  %-12s %-8s bounces %-3s  light %.4f%s  RMSE %.4f%s  (noise: Cycles %.4f, own %.4f, %d rays)\n",
                picture.scene.c_str(), picture.camera.c_str(), picture.bounceText().c_str(), error.meanLight,
                lightOff > kLargestLightError ? " !" : "  ", error.relativeRmse,
                error.relativeRmse > kLargestRmse ? " !" : "  ", picture.noise, error.noise, settings.raysPerPixel);
    EXPECT_LE(lightOff, kLargestLightError) << picture.file;
    EXPECT_LE(error.relativeRmse, kLargestRmse) << picture.file;
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
