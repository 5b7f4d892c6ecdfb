// What refining the box's hit by the probe's distances gains, against the ray-traced scene: in the pavilion and in the
// furnished room, whose surfaces are not the box's, and that it costs nothing where they are. Errors are what is drawn,
// on metals only.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "filters/io/model_file.h"
#include "filters/reference/metrics.h"
#include "filters/reference/reference_scene.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 64, kHeight = 36;

struct Case {
  const char* scene;
  std::vector<const char*> materials, cameras;
  float roughness;
  double bound;  // of the error relative to the box's, measured plus a twentieth
};

class Impostor : public testing::TestWithParam<Case> {};

TEST_P(Impostor, ErrorAgainstTheTracedScene) {
  const Case& c = GetParam();
  ScenePicture picture = ScenePicture::fromFile("scenes/" + std::string(c.scene) + ".boxprobe.json", kWidth, kHeight);
  Probe& probe = picture.scene.probes.front();
  probe.bounces = 1;
  for (const char* material : c.materials) picture.scene.materials[material].roughness = c.roughness;
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& file : picture.scene.models) {
    models.push_back(std::make_shared<Model>(loadModelFile(file.file)));
  }
  const ReferenceScene reference(picture.scene, models, nullptr);
  ReferenceSettings settings;
  settings.width = kWidth;
  settings.height = kHeight;
  settings.samplesPerPixel = 1;
  settings.raysPerPixel = c.roughness > 0.0f ? 32 : 1;

  for (const char* evaluation : {"none", "footprint8"}) {
    double box = 0.0, impostor = 0.0, fetches = 0.0;
    std::size_t pixels = 0;
    for (const char* name : c.cameras) {
      const Camera camera = cameraNamed(picture.scene, name);
      const ImageRgbaF traced = reference.render(camera, settings).color;
      const auto error = [&](const std::string& technique, const std::vector<bool>& mask) {
        probe.technique = technique;
        picture.show(camera);
        const double rmse = pictureError(picture.linear(1), traced, mask).toneMappedRmse;
        return rmse * rmse;
      };
      std::vector<glm::ivec2> places;
      for (int i = 0; i < kWidth * kHeight; ++i) places.emplace_back(i % kWidth, i / kWidth);
      probe.technique = std::string("impostor+") + evaluation;
      picture.show(camera);
      std::vector<bool> metals(places.size());
      for (const Explanation& e : picture.renderer->explain(places, kWidth, kHeight)) {
        if (!e.hit || e.surface.metallic < 0.5f || e.surface.object == "lamp" || e.probes.empty()) continue;
        metals[static_cast<std::size_t>(e.y * kWidth + e.x)] = true;
        fetches += static_cast<double>(e.probes.front().distanceLookups) /
                   static_cast<double>(e.probes.front().lookups.size());
        ++pixels;
      }
      box += error(std::string("box+") + evaluation, metals);
      keepPicture(picture.display(), std::string("impostor_") + c.scene + "_" + name + "_box");
      impostor += error(std::string("impostor+") + evaluation, metals);
      keepPicture(picture.display(), std::string("impostor_") + c.scene + "_" + name);
      keepPicture(traced, std::string("impostor_") + c.scene + "_" + name + "_traced");
    }
    const double ratio = std::sqrt(impostor / box);
    fetches /= static_cast<double>(pixels);
    std::printf("  %-9s roughness %.2f, %-10s: box %.4f, impostor %.3f of that, %.2f distances a lookup\n", c.scene,
                static_cast<double>(c.roughness), evaluation, std::sqrt(box / static_cast<double>(c.cameras.size())),
                ratio, fetches);
    EXPECT_LE(ratio, c.bound) << evaluation;
    EXPECT_LE(fetches, 3.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Impostor,
                         testing::Values(Case{"room", {"floor", "sphere"}, {"main", "A"}, 0.0f, 1.02},
                                         Case{"room", {"floor", "sphere"}, {"main"}, 0.25f, 1.02},
                                         Case{"furnished", {"floor", "sphere"}, {"main", "low"}, 0.0f, 0.9},
                                         Case{"furnished", {"floor", "sphere"}, {"main"}, 0.25f, 0.97},
                                         Case{"building", {"mirror", "sphere"}, {"main", "low"}, 0.0f, 0.88},
                                         Case{"building", {"mirror", "sphere"}, {"main"}, 0.25f, 0.99}),
                         [](const auto& test) {
                           return std::string(test.param.scene) + (test.param.roughness > 0.0f ? "Rough" : "Mirror");
                         });

}  // namespace
