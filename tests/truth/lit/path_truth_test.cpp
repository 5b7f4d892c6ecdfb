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

/// Relative RMS over blocks that the tracer's own noise is to have. Its square is taken off, but not its chance, which
/// leaves some .4 of it.
double aimedNoise() {
  const char* given = std::getenv("BOXPROBE_LIT_NOISE");
  return given != nullptr ? std::max(std::atof(given), 1e-4) : 0.02;
}

const Camera& cameraOf(const Scene& scene, const std::string& name) {
  for (const Camera& camera : scene.cameras) {
    if (camera.name == name) return camera;
  }
  throw InputError("the scene has no camera " + name);
}

/// Two estimates of one picture with independent noise.
struct Pair {
  ImageRgbaF first, second;
  int rays = 0;  ///< per pixel of each
};

void addTo(ImageRgbaF& sum, int rays, const ImageRgbaF& more, int moreRays) {
  const float share = static_cast<float>(moreRays) / static_cast<float>(rays + moreRays);
  for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += share * (more.pixels[i] - sum.pixels[i]);
}

class PathTruth : public ::testing::TestWithParam<const char*> {
 protected:
  PathTruth()
      : loaded_(loadScene(index_.scenePath(GetParam()))),
        tracer_(loaded_.scene, loaded_.models, loadSkyImage(loaded_.scene)) {}

  Pair trace(const LitPicture& picture, int rays, std::uint64_t seed) const {
    PathSettings settings;
    settings.width = index_.width;
    settings.height = index_.height;
    settings.raysPerPixel = rays;
    settings.bounces = picture.bounces;
    settings.seed = seed;
    const Camera& camera = cameraOf(loaded_.scene, picture.camera);
    Pair pair{tracer_.render(camera, settings).color, {}, rays};
    settings.seed = seed + 1;
    pair.second = tracer_.render(camera, settings).color;
    return pair;
  }

  /// With as many rays as the noise takes that is aimed at.
  Pair quiet(const LitPicture& picture, const ImageRgbaF& truth) const {
    constexpr int kFirst = 32, kMost = 1 << 16;
    Pair pair = trace(picture, kFirst, 101);
    const double loud = litError(index_, picture, truth, pair.first, pair.second).noise / aimedNoise();
    const int more = static_cast<int>(std::min<double>(kFirst * (loud * loud - 1.0), kMost));
    if (more <= 0) return pair;
    const Pair added = trace(picture, more, 201);
    addTo(pair.first, pair.rays, added.first, more);
    addTo(pair.second, pair.rays, added.second, more);
    pair.rays += more;
    return pair;
  }

  LitIndex index_ = loadLitIndex();
  LoadedScene loaded_;
  ReferencePath tracer_;
};

TEST_P(PathTruth, HoldsToCycles) {
  std::printf("  scene, camera, bounces; light, relative RMSE, light of the darker half; noise of Cycles, own; rays\n");
  std::size_t rows = 0;
  for (const LitPicture& picture : index_.pictures) {
    if (picture.scene != GetParam()) continue;
    const ImageRgbaF truth = loadLitPicture(index_, picture);
    const Pair seen = quiet(picture, truth);
    const LitError error = litError(index_, picture, truth, seen.first, seen.second);
    const auto mark = [](bool holds) { return holds ? ' ' : '!'; };
    const bool light = std::abs(error.meanLight - 1.0) <= kLargestLightError;
    const bool rmse = error.relativeRmse <= kLargestRmse;
    const bool dim = std::abs(error.dimLight - 1.0) <= kLargestDimError + 2.0 * error.dimNoise;
    std::printf("  %-12s %-8s %3s  %.4f%c  %.4f%c  %.3f (+-%.3f)%c  %.4f  %.4f  %5d\n", picture.scene.c_str(),
                picture.camera.c_str(), picture.bounceText().c_str(), error.meanLight, mark(light), error.relativeRmse,
                mark(rmse), error.dimLight, error.dimNoise, mark(dim), picture.noise, error.noise, seen.rays);
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
