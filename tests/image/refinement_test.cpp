// A picture at rest goes on to the truth: the box's lobes integrated on the CPU judge it.
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <cstdio>

#include "filters/core/scene/document.h"
#include "filters/io/gltf/model_file.h"
#include "filters/reference/measure/metrics.h"
#include "tests/image/noisy_room.h"
#include "tests/support/shown_light.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

RefineSettings by(int rays) {
  RefineSettings settings;
  settings.rays = rays;
  return settings;
}

Scene restingRoom(const std::string& technique) {
  Scene scene = noisyRoom(1);
  scene.probes[0].technique = technique;
  scene.probes[0].parameters.clear();
  return scene;
}

/// Relative to the truth, where a probe reflects in something rough: RMSE, and the mean.
struct Error {
  double rmse = 0.0, light = 0.0;
};
Error errorOf(const ImageRgbaF& picture, const NoisyRoomTruth& truth) {
  double squares = 0.0, truths = 0.0, light = 0.0, all = 0.0;
  for (std::size_t i = 0; i < truth.rough.size(); ++i) {
    if (!truth.rough[i] || truth.edges[i]) continue;
    for (std::size_t c = 4 * i; c < 4 * i + 3; ++c) {
      const double t = truth.picture.pixels[c], p = picture.pixels[c];
      squares += (p - t) * (p - t);
      truths += t * t;
      light += p;
      all += t;
    }
  }
  return {std::sqrt(squares / truths), light / all};
}

/// Of what the window shows: in display values, where lamps are clipped.
Error shownError(const ImageRgba8& shown, double exposure, const NoisyRoomTruth& truth) {
  NoisyRoomTruth encoded = truth;
  for (float& value : encoded.picture.pixels) {
    value = static_cast<float>(std::pow(std::clamp(static_cast<double>(value) * exposure, 0.0, 1.0), 1.0 / 2.2));
  }
  ImageRgbaF picture{shown.width, shown.height, {}};
  for (const unsigned char value : shown.pixels) {
    picture.pixels.push_back(static_cast<float>(std::pow(lightShown(value / 255.0), 1.0 / 2.2)));
  }
  return errorOf(picture, encoded);
}

/// How alike neighbours' deviations from the mean around them are: 1 of a smooth pattern, negative of blue noise.
double grain(const ImageRgbaF& few, const ImageRgbaF& all, const NoisyRoomTruth& truth) {
  constexpr int kReach = 3;
  const int width = few.width;
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * width + x); };
  std::vector<double> deviation(truth.rough.size(), 0.0);
  std::vector<bool> known(truth.rough.size(), false);
  for (int y = kReach; y < few.height - kReach; ++y) {
    for (int x = kReach; x < width - kReach; ++x) {
      double mean = 0.0;
      bool whole = true;
      for (int dy = -kReach; dy <= kReach; ++dy) {
        for (int dx = -kReach; dx <= kReach; ++dx) {
          const std::size_t i = at(x + dx, y + dy);
          whole = whole && truth.rough[i] && !truth.edges[i];
          mean += few.pixels[4 * i + 1] - all.pixels[4 * i + 1];
        }
      }
      known[at(x, y)] = whole;
      mean /= (2 * kReach + 1) * (2 * kReach + 1);
      deviation[at(x, y)] = few.pixels[4 * at(x, y) + 1] - all.pixels[4 * at(x, y) + 1] - mean;
    }
  }
  double together = 0.0, squares = 0.0;
  int pairs = 0;
  for (std::size_t i = 0; i + 1 < known.size(); ++i) {
    if (!known[i] || !known[i + 1]) continue;
    together += deviation[i] * deviation[i + 1];
    squares += 0.5 * (deviation[i] * deviation[i] + deviation[i + 1] * deviation[i + 1]);
    ++pairs;
  }
  EXPECT_GT(pairs, 500);
  return together / squares;
}

// Where neighbours draw alike, few rays show rings around every lamp.
TEST(RefinedPicture, TheNoiseOfFewRaysIsFineGrained) {
  ScenePicture picture(restingRoom("box"), kWidth, kHeight);
  picture.show(mainCamera(picture.scene));
  const NoisyRoomTruth truth = truthOf(picture);
  const ImageRgbaF all = picture.renderer->renderRefined(kWidth, kHeight, 1, by(1024));
  for (const int rays : {8, 16}) {
    const double of = grain(picture.renderer->renderRefined(kWidth, kHeight, 1, by(rays)), all, truth);
    std::printf("  %d rays: %.3f\n", rays, of);
    EXPECT_LT(of, 0.2) << rays;
  }
}

TEST(RefinedPicture, FallsAtEveryStageAndEndsWhereAllRaysOfOneFrameEnd) {
  ScenePicture picture(restingRoom("footprint8"), kWidth, kHeight);
  picture.show(mainCamera(picture.scene));
  const NoisyRoomTruth truth = truthOf(picture);
  for (const char* technique : {"footprint8", "box", "hdrp"}) {
    picture.scene.probes[0].technique = technique;
    picture.scene.probes[0].parameters.clear();
    picture.renderer->refine({});
    picture.show(mainCamera(picture.scene));
    const Error own = errorOf(picture.linear(1), truth);
    std::printf("  %-10s own %.4f/%.3f", technique, own.rmse, own.light);
    picture.renderer->refine(by(256));
    picture.renderer->finishWork();
    double last = own.rmse;
    Error error;
    for (const int rays : {64, 256}) {
      error = errorOf(picture.renderer->renderRefined(kWidth, kHeight, 1, by(rays)), truth);
      std::printf(", %d rays %.4f/%.3f", rays, error.rmse, error.light);
      // A small lamp in a map is what rays find last, and footprints first.
      EXPECT_LT(error.rmse, rays == 64 ? std::max(last, 0.11) : last) << technique << " " << rays;
      EXPECT_NEAR(error.light, 1.0, rays == 64 ? 0.02 : 0.01) << technique << " " << rays;
      last = error.rmse;
    }
    const double left = picture.renderer->refineState().left;
    std::printf(", estimated %.4f\n", left);
    EXPECT_EQ(picture.renderer->refineState().rays, 256);
    EXPECT_LT(left, 2.0 * error.rmse);
    EXPECT_GT(left, 0.4 * error.rmse);

    picture.renderer->refine({});
    picture.scene.probes[0].technique = "raytraced";
    setParameters(picture, {{"samples", 256.0}, {"filtered", true}, {"pattern", std::string("r2")}});
    const Error atOnce = errorOf(picture.linear(1), truth);
    std::printf("  in one frame %.4f/%.3f\n", atOnce.rmse, atOnce.light);
    EXPECT_NEAR(error.rmse, atOnce.rmse, 0.15 * atOnce.rmse);
    EXPECT_NEAR(error.light, atOnce.light, 0.01);
  }
}

// Frame after frame in the window: nothing jumps, and what is there at the end stays and costs nothing.
TEST(RefinedPicture, GrowsFrameByFrameAndStaysAsItIs) {
  ScenePicture picture(restingRoom("footprint8"), kWidth, kHeight);
  picture.show(mainCamera(picture.scene));
  const NoisyRoomTruth truth = truthOf(picture);
  picture.renderer->refine(by(256));
  picture.renderer->finishWork();
  Error own, before;
  double worst = 0.0;
  int frames = 0;
  ImageRgba8 shown;
  do {
    shown = picture.display();
    const Error error = shownError(shown, picture.scene.exposure, truth);
    if (frames++ > 0) {
      EXPECT_LT(error.rmse, own.rmse) << "frame " << frames << " is worse than the technique's own";
      EXPECT_NEAR(error.light, before.light, 0.02) << "frame " << frames;
      worst = std::max(worst, std::abs(error.light - before.light));
    }
    if (frames == 1 || frames % 8 == 0) std::printf("  frame %d: %.4f/%.3f\n", frames, error.rmse, error.light);
    if (frames == 1) own = error;
    before = error;
    ASSERT_LT(frames, 100);
  } while (picture.renderer->frameCount().more());
  std::printf("  %d frames, largest step of light %.4f\n", frames, worst);
  EXPECT_TRUE(picture.renderer->frameCount().refined);
  EXPECT_EQ(picture.renderer->frameCount().wanted, frames);

  const std::uint64_t draws = picture.renderer->counters().drawsByProbeCount[1];
  EXPECT_GT(draws, 0u);
  for (int i = 0; i < 3; ++i) {
    const ImageRgba8 again = picture.display();
    EXPECT_EQ(again.pixels, shown.pixels);
    EXPECT_EQ(picture.renderer->counters().drawsByProbeCount[1], 0u) << "no surface is drawn again";
  }
  EXPECT_EQ(picture.renderer->refineState().rays, 256);
  EXPECT_FALSE(picture.renderer->refineState().more);
  const ImageRgbaF linear = picture.renderer->renderRefined(kWidth, kHeight, 1, by(256));
  EXPECT_LE(largestDifference(shown, linear, picture.scene.exposure), 0.6) << "rounding and no more";
}

TEST(RefinedPicture, WhateverChangesBeginsAgainAndOffIsTheTechniquesOwn) {
  ScenePicture picture(restingRoom("footprint4"), kWidth, kHeight);
  picture.show(mainCamera(picture.scene));
  const ImageRgba8 own = picture.display();
  picture.renderer->refine(by(64));
  picture.renderer->finishWork();
  for (int i = 0; i < 6; ++i) picture.display();
  EXPECT_GT(picture.renderer->frameCount().averaged, 2);

  vtkCamera* camera = picture.renderer->renderer()->GetActiveCamera();
  camera->Azimuth(7.0);
  picture.display();
  EXPECT_EQ(picture.renderer->frameCount().averaged, 1) << "camera";
  for (int i = 0; i < 3; ++i) picture.display();
  picture.scene.materials["floor"].roughness = 0.5f;
  picture.renderer->sync(picture.scene, Changes::all());
  picture.renderer->finishWork();
  picture.display();
  EXPECT_EQ(picture.renderer->frameCount().averaged, 1) << "material";

  picture.renderer->refine({});
  picture.scene.materials["floor"].roughness = 0.35f;
  picture.show(mainCamera(picture.scene));
  EXPECT_EQ(picture.display().pixels, own.pixels);
  EXPECT_FALSE(picture.renderer->frameCount().refined);
}

/// The mean of each square of `times` by `times` pixels.
ImageRgbaF smaller(const ImageRgbaF& picture, int times) {
  ImageRgbaF result{picture.width / times, picture.height / times, {}};
  result.pixels.assign(static_cast<std::size_t>(4 * result.width * result.height), 0.0f);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto from = static_cast<std::size_t>(4 * (y * picture.width + x));
      const auto to = static_cast<std::size_t>(4 * ((y / times) * result.width + x / times));
      for (std::size_t c = 0; c < 4; ++c)
        result.pixels[to + c] += picture.pixels[from + c] / static_cast<float>(times * times);
    }
  }
  return result;
}

// What a mirror shows is narrower than a pixel, and so are edges: at rest a pixel is the mean of its area.
TEST(RefinedPicture, AMirrorsRoomIsAveragedOverPixels) {
  Scene scene = restingRoom("box");
  for (auto& [name, material] : scene.materials) material.roughness = 0.0f;
  scene.materials["floor"].roughness = 0.0f;
  ScenePicture picture(scene, kWidth, kHeight);
  picture.show(mainCamera(picture.scene));
  const ImageRgbaF refined = picture.renderer->renderRefined(kWidth, kHeight, 1, by(256));
  constexpr int kTimes = 8;
  const ImageRgbaF all = smaller(picture.renderer->renderLinear(kTimes * kWidth, kTimes * kHeight, 1), kTimes);
  const ImageRgbaF own = picture.renderer->renderLinear(kWidth, kHeight, 1);
  // Above the floor, whose mirror gets more texels in a larger picture.
  constexpr std::size_t above = 4 * kWidth * (kHeight / 3);
  const auto off = [&](const ImageRgbaF& shown) {
    double squares = 0.0;
    for (std::size_t i = above; i < all.pixels.size(); ++i)
      squares += std::pow(std::min(shown.pixels[i], 1.0f) - std::min(all.pixels[i], 1.0f), 2.0);
    return std::sqrt(squares / static_cast<double>(all.pixels.size()));
  };
  std::printf("  %.4f, its own frame %.4f\n", off(refined), off(own));
  EXPECT_LT(off(refined), 0.6 * off(own));
  // Nothing is left of where the last frame looked through.
  EXPECT_EQ(picture.renderer->renderLinear(kWidth, kHeight, 1).pixels, own.pixels);
}

// Many objects are culled by the renderer itself, and are none of its own props.
TEST(RefinedPicture, OfManyObjectsShowsWhatIsInView) {
  const auto refined = [](int others) {
    ScenePicture picture(restingRoom("footprint2"), kWidth, kHeight);
    Model model = loadModelFile(picture.scene.models.at(0).file);
    const Instance first = model.instances.at(0);
    for (int i = 0; i < others; ++i) {
      Instance below = first;
      below.node = "below " + std::to_string(i);
      below.worldFromModel[3] += glm::dvec4(0.7 * i, -31.0 - 1.3 * i, 0.4 * i, 0.0);
      model.instances.push_back(below);
    }
    picture.show(mainCamera(picture.scene));
    picture.renderer->setModels({std::make_shared<Model>(model)});
    picture.show(mainCamera(picture.scene));
    picture.renderer->refine(by(16));
    picture.renderer->finishWork();
    ImageRgba8 shown;
    do {
      shown = picture.display();
    } while (picture.renderer->frameCount().more());
    shown = picture.display();  // the stage ends
    EXPECT_EQ(picture.renderer->refineState().rays, 16);
    return shown;
  };
  const ImageRgba8 few = refined(0), many = refined(70);
  int apart = 0;
  for (std::size_t i = 0; i < few.pixels.size(); ++i) apart += std::abs(few.pixels[i] - many.pixels[i]) > 2 ? 1 : 0;
  std::printf("  %d of %zu values are apart\n", apart, few.pixels.size());
  EXPECT_LT(apart, static_cast<int>(few.pixels.size() / 200));
}

}  // namespace
