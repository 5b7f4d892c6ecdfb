// Frames of the renderer against an independent path tracer with all bounces: Cycles' pictures of the lit scenes, see
// ../README.md. Prints a row for every scene and camera.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "filters/core/base/errors.h"
#include "tests/truth/lit/lit_pictures.h"

namespace {

using namespace boxprobe;

/// What is aimed at, and what is held: the same where the aim is reached.
struct Aim {
  double rmse = 0.0, light = 0.0;  ///< relative RMSE of the pixels; how far mean light may be from the truth's
};
struct Held {
  Aim aim, held;
};

const std::map<std::string, Held>& bounds() {
  static const std::map<std::string, Held> kBounds = {
      {"closed across", {{0.08, 0.03}, {0.08, 0.03}}},     {"closed corner", {{0.08, 0.03}, {0.09, 0.03}}},
      {"furniture shelves", {{0.08, 0.03}, {0.11, 0.03}}}, {"furniture mirror", {{0.08, 0.03}, {0.09, 0.03}}},
      {"doorway lit", {{0.10, 0.05}, {0.10, 0.05}}},       {"doorway dark", {{0.25, 0.05}, {0.20, 0.05}}},
      {"window patch", {{0.20, 0.05}, {0.10, 0.05}}},      {"window below", {{0.20, 0.05}, {0.10, 0.05}}},
      {"living-room table", {{0.30, 0.10}, {0.30, 0.10}}}, {"living-room east", {{0.30, 0.10}, {0.30, 0.10}}},
      {"cornell-box front", {{0.30, 0.10}, {0.30, 0.10}}}, {"cornell-box within", {{0.30, 0.10}, {0.30, 0.10}}},
  };
  return kBounds;
}

const Camera& cameraOf(const Scene& scene, const std::string& name) {
  for (const Camera& camera : scene.cameras) {
    if (camera.name == name) return camera;
  }
  throw InputError("the scene has no camera " + name);
}

/// Root of the sum of squared differences over that of the truth's squares, of all pixels and colours.
double pixelError(const ImageRgbaF& truth, const ImageRgbaF& drawn) {
  double differences = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    const double t = static_cast<double>(truth.pixels[i]), d = static_cast<double>(drawn.pixels[i]);
    differences += (d - t) * (d - t);
    squares += t * t;
  }
  return std::sqrt(differences / squares);
}

/// Of BOXPROBE_LIT_SET, as --set has them, apart by semicolons: another picture, which nothing is held to.
std::vector<std::string> changes() {
  std::vector<std::string> fields;
  const char* given = std::getenv("BOXPROBE_LIT_SET");
  std::istringstream text(given != nullptr ? given : "");
  for (std::string field; std::getline(text, field, ';');) fields.push_back(field);
  return fields;
}

struct Judged {
  ImageRgbaF drawn;
  LitError error;
  double rmse = 0.0;  ///< of pixels
};

Judged judge(OffscreenScene& shown, const LoadedScene& loaded, const LitIndex& index, const LitPicture& picture) {
  constexpr int kSamples = 16;
  const ImageRgbaF truth = loadLitPicture(index, picture);
  ShownSettings settings;
  settings.camera = cameraOf(loaded.scene, picture.camera);
  shown.show(loaded.scene, loaded.models, settings);
  if (!shown.capture()) throw WorkError("not captured");
  ImageRgbaF drawn = shown.renderer().renderLinear(index.width, index.height, kSamples);
  shown.requireHealthy();
  const LitError error = litError(index, picture, truth, drawn, drawn);
  const double rmse = pixelError(truth, drawn);
  return {std::move(drawn), error, rmse};
}

const LitPicture& pictureOf(const LitIndex& index, const std::string& scene, const std::string& camera) {
  const auto found = std::find_if(index.pictures.begin(), index.pictures.end(), [&](const LitPicture& picture) {
    return picture.scene == scene && picture.camera == camera && !picture.bounces;
  });
  if (found == index.pictures.end()) throw InputError("no picture of " + scene + ", " + camera);
  return *found;
}

/// The same scene in a unit so many times smaller: radiances stay, and so does the picture.
void inSmallerUnit(Scene& scene, double times) {
  for (ModelFile& model : scene.models) {
    model.scale *= times;
    model.translation *= times;
  }
  for (Light& light : scene.lights) {
    light.position *= times;
    light.radius *= times;
    light.range *= times;
    light.intensity *= static_cast<float>(times * times);
  }
  for (Camera& camera : scene.cameras) {
    camera.position *= times;
    camera.target *= times;
  }
  for (Probe& probe : scene.probes) {
    probe.origin *= times;
    probe.box = {times * probe.box.min, times * probe.box.max};
    if (probe.influence) probe.influence = Box{times * probe.influence->min, times * probe.influence->max};
    probe.blendDistance = {times * probe.blendDistance.min, times * probe.blendDistance.max};
    probe.nearDistance *= times;
    probe.farDistance *= times;
  }
}

class FrameTruth : public ::testing::TestWithParam<const char*> {};

TEST_P(FrameTruth, HoldsToCycles) {
  const LitIndex index = loadLitIndex();
  const LoadedScene loaded = loadScene(index.scenePath(GetParam()), changes());
  OffscreenScene shown({"frame_truth_test", index.width, index.height, 1, true});
  std::printf(
      "  scene, camera: light, relative RMSE of pixels (asked light, RMSE); RMSE of blocks, dim half's light\n");
  int rows = 0;
  for (const LitPicture& picture : index.pictures) {
    if (picture.scene != GetParam() || picture.bounces) continue;
    const Judged judged = judge(shown, loaded, index, picture);
    const LitError& error = judged.error;
    const double rmse = judged.rmse;
    const auto known = bounds().find(picture.scene + " " + picture.camera);
    ASSERT_NE(known, bounds().end()) << picture.file;
    const Held& bound = known->second;
    const bool misses = std::abs(error.meanLight - 1.0) > bound.aim.light || rmse > bound.aim.rmse;
    std::printf("  %-12s %-8s %.3f  %.3f (1 +- %.2f, %.2f)%s  %.3f  %.3f\n", picture.scene.c_str(),
                picture.camera.c_str(), error.meanLight, rmse, bound.aim.light, bound.aim.rmse, misses ? "!" : " ",
                error.relativeRmse, error.dimLight);
    ++rows;
    if (!changes().empty()) continue;
    EXPECT_NEAR(error.meanLight, 1.0, bound.held.light) << picture.file;
    EXPECT_LE(rmse, bound.held.rmse) << picture.file;
  }
  EXPECT_EQ(rows, 2);
}

// One probe, whose box is the lit room and whose influence both: the dark room has nodes, too, and not the light of
// the nearest ones in the lit room.
TEST(OneProbe, LightsTheNextRoom) {
  const LitIndex index = loadLitIndex();
  LoadedScene loaded = loadScene(index.scenePath("doorway"));
  ASSERT_EQ(loaded.scene.probes.size(), 2u);
  loaded.scene.probes.resize(1);
  Probe& probe = loaded.scene.probes.front();
  ASSERT_EQ(probe.name, "lit room");
  probe.influence = Box{{-3.5, -0.1, -2.3}, {4.4, 2.8, 2.7}};
  probe.blendDistance = {glm::dvec3(0.1), glm::dvec3(0.1)};
  OffscreenScene shown({"frame_truth_test", index.width, index.height, 1, true});
  for (const char* camera : {"dark", "lit"}) {
    const Judged judged = judge(shown, loaded, index, pictureOf(index, "doorway", camera));
    std::printf("  %-6s %.3f  %.3f\n", camera, judged.error.meanLight, judged.rmse);
    EXPECT_NEAR(judged.error.meanLight, 1.0, 0.15) << camera;
    EXPECT_LE(judged.rmse, 0.35) << camera;
  }
}

// Files come in millimetres, too, and say nothing of it: the same picture, and as near to Cycles'.
TEST(Units, MakeNoDifference) {
  const LitIndex index = loadLitIndex();
  OffscreenScene shown({"frame_truth_test", index.width, index.height, 1, true});
  std::vector<ImageRgbaF> drawn;
  for (const double times : {1.0, 1000.0}) {
    LoadedScene loaded = loadScene(index.scenePath("doorway"));
    inSmallerUnit(loaded.scene, times);
    shown.forget();
    for (const char* camera : {"dark", "lit"}) {
      Judged judged = judge(shown, loaded, index, pictureOf(index, "doorway", camera));
      const Aim& aim = bounds().at("doorway " + std::string(camera)).aim;
      std::printf("  times %-5g %-6s %.3f  %.3f\n", times, camera, judged.error.meanLight, judged.rmse);
      EXPECT_NEAR(judged.error.meanLight, 1.0, aim.light) << camera << ", " << times;
      EXPECT_LE(judged.rmse, aim.rmse) << camera << ", " << times;
      drawn.push_back(std::move(judged.drawn));
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const double apart = pixelError(drawn[i], drawn[i + 2]);
    std::printf("  apart %.3f\n", apart);
    EXPECT_LE(apart, 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Lit, FrameTruth,
                         ::testing::Values("closed", "furniture", "doorway", "window", "living-room", "cornell-box"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
