// A walk through a door, from the lit room into the dark one, at the step of a walk: the picture's light never jumps
// between two frames by itself. Where it changes much, the path tracer says whether the place does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "filters/reference/path/reference_path.h"
#include "tests/truth/lit/lit_pictures.h"

namespace {

using namespace boxprobe;

constexpr int kFrames = 60, kWidth = 80, kHeight = 48;
// Of a picture's light: what is asked. Mean light from frame to frame is held to what it reaches: in the doorway, which
// lies in no probe's box, the nearer edge of the door's sides is too bright.
constexpr double kMostPop = 0.02, kMostHeld = 0.07;
constexpr int kHalvings = 9;  // of the way between two frames, to a fifth of a millimetre
constexpr int kRays = 160;    // a pixel: the mean of a picture is known to some .3 %

Camera onTheWay(double frame) {
  const double t = frame / (kFrames - 1);
  Camera camera;
  camera.position = {3.5 - 6.2 * t, 1.55, 0.95 - 0.15 * t};
  camera.target = camera.position + glm::dvec3(-3.0, -0.35, -0.4 + 0.9 * t);
  camera.verticalFovDegrees = 58.0;
  return camera;
}

double meanLight(const ImageRgbaF& picture) {
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    if (i % 4 != 3) sum += static_cast<double>(picture.pixels[i]);
  }
  return sum / static_cast<double>(picture.pixels.size() / 4 * 3);
}

class Truth {
 public:
  explicit Truth(const LoadedScene& loaded) : tracer_(loaded.scene, loaded.models, loadSkyImage(loaded.scene)) {}
  double light(int frame) {
    const auto known = known_.find(frame);
    if (known != known_.end()) return known->second;
    PathSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.raysPerPixel = kRays;
    settings.seed = static_cast<std::uint64_t>(11 + frame);
    return known_[frame] = meanLight(tracer_.render(onTheWay(frame), settings).color);
  }
  std::size_t traced() const { return known_.size(); }

 private:
  ReferencePath tracer_;
  std::map<int, double> known_;
};

TEST(WalkThroughADoor, LightChangesAsItDoes) {
  const LoadedScene loaded = loadScene(loadLitIndex().scenePath("doorway"));
  OffscreenScene shown({"walk_test", kWidth, kHeight, 1, true});
  ShownSettings settings;
  settings.camera = onTheWay(0);
  shown.show(loaded.scene, loaded.models, settings);
  ASSERT_TRUE(shown.capture());
  const auto light = [&](int frame) {
    shown.renderer().applyCamera(onTheWay(frame));
    EXPECT_TRUE(shown.capture());
    return meanLight(shown.renderer().renderLinear(kWidth, kHeight, 16));
  };
  Truth truth(loaded);
  double step = 0.0, pop = 0.0, before = light(0), brightest = before, darkest = before;
  for (int frame = 1; frame < kFrames; ++frame) {
    const double now = light(frame), change = now / before - 1.0;
    step = std::max(step, std::abs(change));
    double itself = change;
    if (std::abs(change) > kMostPop) {
      const double due = truth.light(frame) / truth.light(frame - 1) - 1.0;
      itself = change - due;
      std::printf("  frame %d: light changes by %+.4f, truly by %+.4f\n", frame, change, due);
    }
    pop = std::max(pop, std::abs(itself));
    brightest = std::max(brightest, now);
    darkest = std::min(darkest, now);
    before = now;
  }
  shown.requireHealthy();
  std::printf(
      "  %d frames: light %.3f to %.3f, largest change %.4f, largest that the path tracer has not %.4f (asked %.2f), "
      "%zu traced\n",
      kFrames, darkest, brightest, step, pop, kMostPop, truth.traced());
  EXPECT_LE(pop, kMostHeld);
  EXPECT_GT(brightest, 2.0 * darkest) << "no walk from light into the dark";
}

// Of the brighter picture's light.
double changed(const ImageRgbaF& a, const ImageRgbaF& b) {
  double sum = 0.0, first = 0.0, second = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    const double p = static_cast<double>(a.pixels[i]), q = static_cast<double>(b.pixels[i]);
    sum += std::abs(p - q);
    first += p;
    second += q;
  }
  return sum / std::max({first, second, 1.0e-30});
}

TEST(WalkThroughADoor, NothingPops) {
  const LoadedScene loaded = loadScene(loadLitIndex().scenePath("doorway"));
  OffscreenScene shown({"walk_test", kWidth, kHeight, 1, true});
  ShownSettings settings;
  settings.camera = onTheWay(0.0);
  shown.show(loaded.scene, loaded.models, settings);
  ASSERT_TRUE(shown.capture());
  const auto frame = [&](double at) {
    shown.renderer().applyCamera(onTheWay(at));
    EXPECT_TRUE(shown.capture());
    return shown.renderer().renderLinear(kWidth, kHeight, 16);
  };
  double pop = 0.0, step = 0.0;
  int halved = 0;
  ImageRgbaF before = frame(0.0);
  for (int i = 1; i < kFrames; ++i) {
    const ImageRgbaF next = frame(i);
    double change = changed(before, next), low = i - 1.0, high = i;
    step = std::max(step, change);
    // What the camera's way changes falls with the way; what pops stays, in one half or the other.
    ImageRgbaF first = before, last = next;
    for (int k = 0; k < kHalvings && change > kMostPop; ++k) {
      const double middle = 0.5 * (low + high);
      const ImageRgbaF between = frame(middle);
      const double near = changed(first, between), far = changed(between, last);
      (near > far ? high : low) = middle;
      (near > far ? last : first) = between;
      change = std::max(near, far);
      ++halved;
    }
    pop = std::max(pop, change);
    before = next;
  }
  shown.requireHealthy();
  std::printf("  %d frames: largest step %.3f of the picture's light, largest pop %.4f, after %d halvings\n", kFrames,
              step, pop, halved);
  EXPECT_LE(pop, kMostPop);
  EXPECT_GT(halved, 0) << "nothing is judged";
}

}  // namespace
