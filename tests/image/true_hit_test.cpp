// The true hit that a probe's distances tell, against rays traced through the scene's triangles, which know nothing of
// any capture: what is told is right, and where a ray ends out of the capture origin's sight nothing is told.
#include <gtest/gtest.h>

#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <ostream>

#include "filters/io/gltf/model_file.h"
#include "filters/reference/trace/scene_tracer.h"
#include "tests/support/scene_picture.h"

namespace boxprobe {
namespace {

using test::ScenePicture;

struct Case {
  const char* scene;
  double right;  ///< of what is told, at least
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.scene;
}

struct Told {
  int right = 0;    ///< by less than a degree from the capture origin
  int wrong = 0;    ///< another direction
  int nothing = 0;  ///< wrong as well: the ray leaves the scene
  int unknown = 0;  ///< not told, though the ray hits something
  int told() const { return right + wrong + nothing; }
};

class TrueHit : public ::testing::TestWithParam<Case> {};

TEST_P(TrueHit, IsTheTracedOneOrIsNotTold) {
  ScenePicture picture = ScenePicture::fromFile(std::string("scenes/") + GetParam().scene + ".boxprobe.json", 64, 64);
  for (Probe& probe : picture.scene.probes) probe.bounces = 1;
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& file : picture.scene.models)
    models.push_back(std::make_shared<Model>(loadModelFile(file.file)));
  const SceneTracer tracer(makeTriangleScene(picture.scene, models));
  Told told;
  for (const Camera& camera : picture.scene.cameras) {
    picture.show(camera);
    std::vector<glm::ivec2> pixels;
    for (int i = 0; i < 3000; ++i) pixels.emplace_back((i * 37) % 320, (i * 53) % 180);
    for (const Explanation& e : picture.renderer->explain(pixels, 320, 180)) {
      if (!e.hit) continue;
      const glm::dvec3 along(e.reflectionWorld);
      const glm::dvec3 start = e.surface.positionWorld + 1e-4 * glm::dvec3(e.surface.normalWorld);
      const auto hit = tracer.firstHit(start, along, RaySees::Probes);
      for (const ProbeExplanation& p : e.probes) {
        if (!p.trueDistance) {
          told.unknown += hit ? 1 : 0;
          continue;
        }
        if (!hit) {
          ++told.nothing;
          continue;
        }
        const glm::dvec3 said = e.surface.positionWorld + double(*p.trueDistance) * along;
        const double cosine =
            glm::dot(glm::normalize(said - p.originWorld), glm::normalize(hit->positionWorld - p.originWorld));
        ++(cosine > std::cos(glm::radians(1.0)) ? told.right : told.wrong);
      }
    }
  }
  ASSERT_GT(told.told(), 1000);
  const auto percent = [&](int count) { return 100.0 * count / told.told(); };
  std::printf("  %-9s %5d told: right %.2f %%, elsewhere %.2f %%, of rays that leave the scene %.2f %%; %d not told\n",
              GetParam().scene, told.told(), percent(told.right), percent(told.wrong), percent(told.nothing),
              told.unknown);
  EXPECT_GE(told.right, GetParam().right * told.told());
  EXPECT_LE(told.nothing, 0.025 * told.told());
  EXPECT_LE(told.unknown, 0.25 * told.told()) << "silence is not always right";
}

INSTANTIATE_TEST_SUITE_P(Scenes, TrueHit,
                         ::testing::Values(Case{"room", 0.995}, Case{"building", 0.94}, Case{"furnished", 0.95},
                                           Case{"gallery", 0.995}),
                         [](const auto& scene) { return std::string(scene.param.scene); });

}  // namespace
}  // namespace boxprobe
