// What refining the box's hit by what the probe saw gains, against the ray-traced scene: in the pavilion and in the
// furnished room, whose surfaces are not the box's, and that it costs nothing where they are. Errors are of what is
// drawn, on metals only; the technique runs on the CPU, on maps captured by the GPU (explain_test holds its picture
// against the GPU's).
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>

#include "filters/io/gltf/model_file.h"
#include "filters/math/sampling/brdf_table.h"
#include "filters/math/technique/technique_table.h"
#include "filters/reference/light/reference_scene.h"
#include "filters/reference/light/reflecting_layers.h"
#include "filters/reference/measure/metrics.h"
#include "filters/reference/trace/visible_normal_lobe.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 128, kHeight = 72, kSide = 2, kRays = 32;
constexpr int kSteps[] = {1, 2, 3, 8, 24};
constexpr int kMarched = 24;  // steps that are held to a bound of their own

struct Case {
  const char* scene;
  std::vector<const char*> materials, cameras;
  float roughness;
  double boundNone, boundFootprint8;      // of the error relative to the box's by 3 steps, measured plus a twentieth
  double marchedNone, marchedFootprint8;  // by kMarched steps
};

/// A reflecting surface under a quarter of a pixel.
struct Sample {
  std::size_t pixel = 0;
  SurfacePoint surface;
  ReflectingLayer layer;
  glm::dvec3 factor;  // what the renderer multiplies a lobe's mean by
  glm::dvec3 other{0.0}, reflected{0.0};
  glm::dvec3 start{0.0};     // of reflected rays
  std::uint64_t seed = 0;    // of those that `reflected` is the mean of
  glm::dvec3 hitWorld{0.0};  // where R truly ends; far along it if nowhere
};

class Impostor : public testing::TestWithParam<Case> {};

glm::dvec3 trueEnd(const ReferenceScene& reference, const glm::dvec3& start, const glm::dvec3& along) {
  const auto hit = reference.tracer().firstHit(start, along, RaySees::Probes);
  return hit ? hit->positionWorld : start + 1.0e4 * along;
}

std::vector<Sample> samplesOf(const ReferenceScene& reference, const Camera& camera, float roughness) {
  std::vector<Sample> samples;
  const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
  const double tangent = std::tan(0.5 * glm::radians(camera.verticalFovDegrees));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  const glm::dvec3 up = glm::cross(right, forward);
  std::vector<glm::dvec3> starts;
  for (int y = 0; y < kHeight * kSide; ++y) {
    for (int x = 0; x < kWidth * kSide; ++x) {
      const glm::dvec3 direction = forward +
                                   tangent * ((2.0 * x + 1.0) / (kWidth * kSide) - 1.0) * kWidth / kHeight * right +
                                   tangent * (1.0 - (2.0 * y + 1.0) / (kHeight * kSide)) * up;
      const auto hit = reference.tracer().firstHit(camera.position, direction);
      if (!hit || reference.tracer().object(*hit).material.unlit) continue;
      Sample sample;
      sample.surface = reference.tracer().surface(*hit, camera.position);
      if (sample.surface.metallic < 0.5f) continue;
      const auto layers = reflectingLayers(sample.surface, Energy::Single);
      if (layers.empty()) continue;
      sample.pixel = static_cast<std::size_t>(y / kSide * kWidth + x / kSide);
      sample.layer = layers.front();
      const glm::vec2 split =
          splitSum(glm::dot(sample.surface.normalWorld, sample.surface.viewWorld), sample.surface.roughness);
      sample.factor = glm::dvec3(sample.layer.fresnel.f0 * split.x + sample.layer.fresnel.f90 * split.y);
      sample.other = glm::dvec3(reference.light().unreflected(sample.surface, false));
      samples.push_back(sample);
      starts.push_back(reference.tracer().awayFrom(*hit));
    }
  }
  tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) {
    samples[i].start = starts[i];
    samples[i].seed = 17 * i + 1;
    samples[i].reflected = reference.reflectedFrom(samples[i].surface, starts[i], RaySees::Probes,
                                                   roughness > 0.0f ? kRays : 1, samples[i].seed);
    const SurfacePoint& at = samples[i].surface;
    const glm::dvec3 along(shading::reflectedView(at.normalWorld, at.viewWorld));
    samples[i].hitWorld = trueEnd(reference, starts[i], along);
  });
  return samples;
}

class CountedRelief : public shading::ReliefSampler {
 public:
  explicit CountedRelief(const Relief& relief) : relief_(relief) {}
  glm::vec4 fetchRelief(const glm::vec3& direction, float level) const override {
    ++count;
    return relief_.fetchRelief(direction, level);
  }
  float reliefSize() const override { return relief_.reliefSize(); }
  mutable int count = 0;

 private:
  const Relief& relief_;
};

// In place of a technique: the plain lookup in the direction of the true hit. What no projection can mend is left: what
// the probe did not see, and the roughness that `none` looks up whatever the distance.
constexpr const char* kExactHit = "exact hit";
// The same by every ray of the lobe, those that the truth is the mean of: what no projection and no evaluation can mend
// is left alone.
constexpr const char* kExactRays = "exact rays";

glm::dvec3 exactRays(const ReferenceScene& reference, const Sample& s, const Probe& probe, const BakedMaps& maps) {
  const VisibleNormalLobe lobe(glm::normalize(s.layer.normalWorld), glm::normalize(glm::dvec3(s.surface.viewWorld)),
                               s.layer.roughness * s.layer.roughness);
  return lobeMean(lobe, glm::dvec3(s.layer.fresnel.f0), glm::dvec3(s.layer.fresnel.f90),
                  s.layer.roughness > 0.0 ? kRays : 1, s.seed, [&](const glm::dvec3& along) {
                    const glm::vec3 seen(trueEnd(reference, s.start, along) - probe.origin);
                    return glm::dvec3(glm::vec3(maps.radiance.fetch(seen, 0.0f)));
                  });
}

struct Tally {
  double square = 0.0;  // of the tone-mapped error, sum over cameras
  double fetches = 0.0;
  int most = 0;
  std::size_t lookups = 0;
};

void add(Tally& tally, const std::string& id, float steps, const ReferenceScene& reference, const Probe& probe,
         const BakedMaps& maps, const std::vector<Sample>& samples) {
  ProbeGeometry geometry = probeGeometry(probe, probe.origin);
  geometry.technique = parseTechnique(id == kExactHit || id == kExactRays ? "box+none" : id).value();
  geometry.parameters.steps = steps;
  const auto relief = maps.relief.of(maps.distance);
  const auto blocks = maps.relief.blocks(*relief, geometry.boxMin, geometry.boxMax, glm::mat3(1.0f));
  const auto pixels = static_cast<std::size_t>(kWidth * kHeight);
  ImageRgbaF drawn{kWidth, kHeight, std::vector<float>(4 * pixels)}, traced = drawn;
  std::vector<bool> mask(pixels);
  std::vector<float> count(pixels);
  for (const Sample& s : samples) count[s.pixel] += 1.0f;
  for (const Sample& s : samples) {
    const CountedRelief counted(*relief);
    shading::ProbeData data;
    data.relief = &counted;
    data.blocks = blocks.get();
    shading::ProbeShape shape = probeShape(geometry, maps.radiance.maxLevel(), s.surface.roughness);
    shape.slot = &data;
    shading::ShadingPoint point{};
    point.position = glm::vec3(s.surface.positionWorld - probe.origin);
    point.normal = s.surface.normalWorld;
    point.view = s.surface.viewWorld;
    point.reflection = shading::reflectedView(point.normal, point.view);
    point.roughness = s.surface.roughness;
    point.f0 = 1.0f;
    shading::projectRay(shape, point.position, point.normal, point.reflection);
    tally.fetches += counted.count;
    tally.most = std::max(tally.most, counted.count);
    ++tally.lookups;
    const auto evaluate = evaluationRows()[static_cast<std::size_t>(geometry.technique.evaluation)].evaluate;
    const float level = shading::levelForRoughness(point.roughness, shape.maxLevel);
    const glm::dvec3 value =
        id == kExactRays  ? exactRays(reference, s, probe, maps)
        : id == kExactHit ? glm::dvec3(glm::vec3(maps.radiance.fetch(glm::vec3(s.hitWorld - probe.origin), level)))
                          : glm::dvec3(glm::vec3(evaluate(&maps.radiance, shape, point)));
    const glm::dvec3 ours = s.other + s.factor * value, right = s.other + s.reflected;
    for (int c = 0; c < 3; ++c) {
      drawn.pixels[4 * s.pixel + static_cast<std::size_t>(c)] += static_cast<float>(ours[c]) / count[s.pixel];
      traced.pixels[4 * s.pixel + static_cast<std::size_t>(c)] += static_cast<float>(right[c]) / count[s.pixel];
    }
    mask[s.pixel] = true;
  }
  const double error = pictureError(drawn, traced, mask).toneMappedRmse;
  tally.square += error * error;
  keepPicture(drawn, "impostor_" + id);
}

TEST_P(Impostor, ErrorAgainstTheTracedScene) {
  const Case& c = GetParam();
  ScenePicture picture = ScenePicture::fromFile("scenes/" + std::string(c.scene) + ".boxprobe.json", 16, 9);
  Probe& probe = picture.scene.probes.front();
  probe.bounces = 1;
  picture.scene.lamps = LampForm::InMap;  // bounds are of what techniques make of one map
  for (const char* material : c.materials) picture.scene.materials[material].roughness = c.roughness;
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& file : picture.scene.models) {
    models.push_back(std::make_shared<Model>(loadModelFile(file.file)));
  }
  const ReferenceScene reference(picture.scene, models, nullptr);
  picture.show(cameraNamed(picture.scene, c.cameras.front()));
  const BakedMaps maps = picture.renderer->readMaps(probe.name).value();

  std::map<std::string, Tally> tallies;
  for (const char* name : c.cameras) {
    const std::vector<Sample> samples = samplesOf(reference, cameraNamed(picture.scene, name), c.roughness);
    add(tallies[kExactHit], kExactHit, 3.0f, reference, probe, maps, samples);
    add(tallies[kExactRays], kExactRays, 3.0f, reference, probe, maps, samples);
    for (const char* evaluation : {"none", "footprint8"}) {
      add(tallies[std::string("box+") + evaluation], std::string("box+") + evaluation, 3.0f, reference, probe, maps,
          samples);
      for (const int steps : kSteps) {
        add(tallies["impostor+" + std::string(evaluation) + " " + std::to_string(steps)],
            std::string("impostor+") + evaluation, static_cast<float>(steps), reference, probe, maps, samples);
      }
    }
  }
  std::printf("  %-9s roughness %.2f, none in the direction of the true hit: %.3f of the box's error\n", c.scene,
              static_cast<double>(c.roughness), std::sqrt(tallies[kExactHit].square / tallies["box+none"].square));
  std::printf("  %-9s roughness %.2f, all rays in the directions of their true hits: %.3f of footprint8's by the box\n",
              c.scene, static_cast<double>(c.roughness),
              std::sqrt(tallies[kExactRays].square / tallies["box+footprint8"].square));
  for (const char* evaluation : {"none", "footprint8"}) {
    const Tally& box = tallies[std::string("box+") + evaluation];
    for (const int steps : kSteps) {
      const Tally& tally = tallies["impostor+" + std::string(evaluation) + " " + std::to_string(steps)];
      const double ratio = std::sqrt(tally.square / box.square);
      std::printf(
          "  %-9s roughness %.2f, %-10s: box %.4f, impostor of %d steps %.3f of that, %.2f lookups more, at most %d\n",
          c.scene, static_cast<double>(c.roughness), evaluation,
          std::sqrt(box.square / static_cast<double>(c.cameras.size())), steps, ratio,
          tally.fetches / static_cast<double>(tally.lookups), tally.most);
      EXPECT_LE(tally.most, steps);
      const bool plain = evaluation == std::string("none");
      if (steps == 3) {
        EXPECT_LE(ratio, plain ? c.boundNone : c.boundFootprint8);
      }
      if (steps == kMarched) {
        EXPECT_LE(ratio, plain ? c.marchedNone : c.marchedFootprint8);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Impostor,
    testing::Values(
        Case{"room", {"floor", "sphere"}, {"main", "A"}, 0.0f, 1.02, 1.02, 1.02, 1.02},
        Case{"room", {"floor", "sphere"}, {"main"}, 0.25f, 1.02, 1.02, 1.02, 1.02},
        Case{"furnished", {"floor", "sphere"}, {"main", "low", "steep"}, 0.0f, 0.45, 0.45, 0.385, 0.385},
        Case{"furnished", {"floor", "sphere"}, {"main", "low", "steep"}, 0.25f, 0.86, 0.59, 0.83, 0.5},
        Case{"building", {"mirror", "sphere"}, {"main", "low", "top", "corner"}, 0.0f, 0.49, 0.49, 0.48, 0.48},
        Case{"building", {"mirror", "sphere"}, {"main", "low", "top", "corner"}, 0.25f, 0.89, 0.52, 0.905, 0.54}),
    [](const auto& test) {
      return std::string(test.param.scene) + (test.param.roughness > 0.0f ? "Rough" : "Mirror");
    });

}  // namespace
