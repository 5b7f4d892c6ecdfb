// The references against what is drawn: the same surfaces, the same picture where nothing reflects, the mirrored
// camera's picture in a mirror; and against each other where the box is the truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "filters/core/geometry/probe_diffuse.h"
#include "filters/core/surface/direct_light.h"
#include "filters/fit/rays/triangle_sight.h"
#include "filters/io/gltf/model_file.h"
#include "filters/reference/light/reference_box.h"
#include "filters/reference/light/reference_scene.h"
#include "filters/reference/light/reflecting_layers.h"
#include "filters/reference/measure/metrics.h"
#include "filters/reference/trace/visible_normal_lobe.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 480, kHeight = 270;

ReferenceScene referenceOf(const Scene& scene) {
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& file : scene.models) models.push_back(std::make_shared<Model>(loadModelFile(file.file)));
  return ReferenceScene(scene, models, nullptr);
}

Scene emptyRoom(float floorRoughness) {
  Scene scene = ScenePicture::fromFile("scenes/room.boxprobe.json", 8, 8).scene;
  for (const char* sphere : {"sphere 1", "sphere 2", "sphere 3"}) scene.objects[sphere].visible = false;
  scene.materials["floor"].roughness = floorRoughness;
  return scene;
}

double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<long>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// The tracer's surfaces against what the shader itself says of the same pixels: textures, lights, back faces, culling.
TEST(Reference, SurfacesAreTheShaders) {
  ScenePicture picture = ScenePicture::fromFile("scenes/building.boxprobe.json", kWidth, kHeight);
  picture.scene.materials["stone"].coat = 0.5f;
  const ReferenceScene reference = referenceOf(picture.scene);
  for (const char* name : {"main", "low"}) {
    const Camera camera = cameraNamed(picture.scene, name);
    picture.show(camera);
    std::vector<glm::ivec2> places;
    for (int y = 5; y < kHeight; y += 9) {
      for (int x = 5; x < kWidth; x += 9) places.emplace_back(x, y);
    }
    int surfaces = 0, others = 0;
    std::vector<double> position, normal, albedo, emissive, direct, rest;
    for (const Explanation& e : picture.renderer->explain(places, kWidth, kHeight)) {
      if (!e.hit) continue;
      ++surfaces;
      const SurfacePoint& drawn = e.surface;
      const auto hit = reference.tracer().firstHit(camera.position, drawn.positionWorld - camera.position);
      if (!hit || reference.tracer().object(*hit).node != drawn.object) {
        ++others;
        continue;
      }
      const SurfacePoint traced = reference.tracer().surface(*hit, camera.position);
      position.push_back(glm::distance(drawn.positionWorld, traced.positionWorld));
      emissive.push_back(glm::distance(drawn.emissive, traced.emissive));
      if (reference.tracer().object(*hit).material.unlit) continue;
      normal.push_back(glm::distance(drawn.normalWorld, traced.normalWorld));
      albedo.push_back(glm::distance(drawn.albedo, traced.albedo));
      rest.push_back(
          std::max({std::abs(drawn.roughness - traced.roughness), std::abs(drawn.metallic - traced.metallic),
                    std::abs(drawn.baseF0 - traced.baseF0), std::abs(drawn.coatF0 - traced.coatF0) * drawn.coatStrength,
                    std::abs(drawn.coatStrength - traced.coatStrength), std::abs(drawn.occlusion - traced.occlusion)}));
      const FresnelEnds ends = fresnelEnds(traced);
      const glm::vec3 light = traced.occlusion * directLight(traced, ends.f0, ends.f90, picture.scene.lights);
      direct.push_back(glm::distance(e.direct, light));
    }
    std::printf(
        "  %-4s %d points, %d at an outline; nine in ten within: position %.1e, normal %.1e, albedo %.1e, emission "
        "%.1e, "
        "direct light %.1e\n",
        name, surfaces, others, quantile(position, 0.9), quantile(normal, 0.9), quantile(albedo, 0.9),
        quantile(emissive, 0.9), quantile(direct, 0.9));
    ASSERT_GT(surfaces, 700);
    EXPECT_LE(others, surfaces / 50);
    EXPECT_LT(quantile(position, 0.98), 2.0e-3);
    EXPECT_LT(quantile(normal, 0.98), 2.0e-3);
    EXPECT_LT(quantile(rest, 1.0), 1.0e-5);
    // Drawn with mip levels, traced without: what differs is the finest grain of the textures.
    EXPECT_LT(quantile(albedo, 0.9), 0.06);
    EXPECT_LT(quantile(emissive, 0.9), 0.01);
    EXPECT_LT(quantile(direct, 0.9), 0.03);
  }
}

// Where nothing reflects, and in a mirror: the picture that is drawn, through the camera and through its mirror image.
TEST(Reference, WallsAndMirrorAreAsDrawn) {
  ScenePicture picture(emptyRoom(0.0f), kWidth, kHeight);
  const ReferenceScene reference = referenceOf(picture.scene);
  ReferenceSettings settings;
  settings.width = kWidth;
  settings.height = kHeight;
  settings.samplesPerPixel = 16;
  settings.raysPerPixel = 16;
  for (const char* name : {"main", "A"}) {
    const Camera camera = cameraNamed(picture.scene, name);
    const ReferencePicture traced = reference.render(camera, settings);
    EXPECT_EQ(*std::max_element(traced.standardError.pixels.begin(), traced.standardError.pixels.end()), 0.0f)
        << "a mirror needs one ray";

    picture.show(camera);
    const ImageRgbaF drawn = picture.linear(16);
    const Scene kept = picture.scene;
    picture.scene.objects["floor"].visible = false;
    picture.show(mirroredInFloor(camera, 0.0));
    const ImageRgbaF mirrored = flippedTopToBottom(picture.linear(16));
    picture.scene = kept;
    keepPicture(traced.color, std::string("reference_scene_") + name);
    keepPicture(drawn, std::string("reference_drawn_") + name);

    std::vector<bool> floor(static_cast<std::size_t>(kWidth) * kHeight), walls(floor.size());
    std::size_t floorPixels = 0;
    for (int y = 1; y + 1 < kHeight; ++y) {
      for (int x = 1; x + 1 < kWidth; ++x) {
        // Inner pixels only: on an outline a hair's breadth decides.
        int count = 0;
        for (int k = 0; k < 9; ++k) {
          const glm::dvec3 up(0.0, 1.0, 0.0);
          const auto direction = [&](double px, double py) {
            const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
            const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
            const double tangent = std::tan(0.5 * camera.verticalFovDegrees * 3.14159265358979 / 180.0);
            return forward + tangent * ((2.0 * px / kWidth - 1.0) * kWidth / kHeight * right +
                                        (1.0 - 2.0 * py / kHeight) * glm::cross(right, forward));
          };
          const auto hit = reference.tracer().firstHit(camera.position, direction(x + k % 3 - 0.5, y + k / 3 - 0.5));
          count += hit && reference.tracer().object(*hit).node == "floor" ? 1 : 0;
        }
        const auto at = static_cast<std::size_t>(y * kWidth + x);
        floor[at] = count == 9;
        walls[at] = count == 0;
        floorPixels += floor[at] ? 1 : 0;
      }
    }
    ASSERT_GT(floorPixels, floor.size() / 20);
    const PictureError wallError = pictureError(traced.color, drawn, walls);
    const PictureError mirrorError = pictureError(traced.color, mirrored, floor);
    std::printf("  camera %-4s walls %.1f dB, brightness %.4f; mirror %.1f dB, brightness %.4f\n", name,
                -20.0 * std::log10(wallError.toneMappedRmse), wallError.brightnessRatio,
                -20.0 * std::log10(mirrorError.toneMappedRmse), mirrorError.brightnessRatio);
    EXPECT_LT(wallError.toneMappedRmse, 0.01);
    EXPECT_NEAR(wallError.brightnessRatio, 1.0, 0.005);
    EXPECT_LT(mirrorError.toneMappedRmse, 0.01);
    EXPECT_NEAR(mirrorError.brightnessRatio, 1.0, 0.005);
  }
}

struct Estimate {
  glm::dvec3 mean{0.0}, standardError{0.0};
};

template <typename Pass>
Estimate overPasses(const Pass& pass) {
  constexpr int kPasses = 16;
  glm::dvec3 sum(0.0), squares(0.0);
  for (int i = 0; i < kPasses; ++i) {
    const glm::dvec3 value = pass(i);
    sum += value;
    squares += value * value;
  }
  const glm::dvec3 mean = sum / double(kPasses);
  return {mean, glm::sqrt(glm::max(squares / double(kPasses) - mean * mean, 0.0) / double(kPasses - 1))};
}

/// Whether a capture's level 0 is even around a direction: the texels about it differ by less than a fiftieth. Next to
/// an edge a capture holds a mixture that no ray of the tracer sees, which is the capture's grain and no ray's noise.
bool evenAround(const CubeMap& map, const glm::dvec3& direction) {
  const CubePoint p = cubePoint(glm::vec3(direction));
  const int size = map.faceSize();
  const auto texel = [&](float x) {
    return static_cast<int>(std::floor(0.5f * (x + 1.0f) * static_cast<float>(size)));
  };
  const int column = texel(p.s), row = texel(p.t);
  if (column < 2 || row < 2 || column > size - 3 || row > size - 3) return false;
  glm::vec3 low(1.0e30f), high(0.0f);
  for (int k = 0; k < 25; ++k) {
    const glm::vec3 value(map.texel(0, p.face, column + k % 5 - 2, row + k / 5 - 2));
    low = glm::min(low, value);
    high = glm::max(high, value);
  }
  return high.x - low.x < 0.02f * high.x && high.y - low.y < 0.02f * high.y && high.z - low.z < 0.02f * high.z;
}

/// z-scores of pairs of estimates of the same numbers.
struct Scores {
  int count = 0, beyond = 0;
  double zSum = 0.0, zSquares = 0.0, difference = 0.0, variance = 0.0, total = 0.0;

  void add(const Estimate& box, const Estimate& scene) {
    for (int c = 0; c < 3; ++c) {
      const double error = std::hypot(box.standardError[c], scene.standardError[c]);
      if (!(error > 0.0)) continue;
      const double z = (box.mean[c] - scene.mean[c]) / error;
      ++count;
      zSum += z;
      zSquares += z * z;
      beyond += std::abs(z) > 2.0 ? 1 : 0;
      difference += box.mean[c] - scene.mean[c];
      variance += error * error;
      total += scene.mean[c];
    }
  }
  double beyondShare() const { return static_cast<double>(beyond) / count; }
  void print(const char* name) const {
    std::printf(
        "    %-12s %d values, mean z %+.3f, rms z %.3f, beyond 2 sigma %.1f %%, brightness %+.3f %% (its standard "
        "error "
        "%.3f %%)\n",
        name, count, zSum / count, std::sqrt(zSquares / count), 100.0 * beyondShare(), 100.0 * difference / total,
        100.0 * std::sqrt(3.0 * variance) / total);
  }
};

// Where nothing reflects, a picture whose reflection alone is traced is the picture; without the probes' diffuse light
// it is not.
TEST(Reference, WithTheProbesDiffuseLightTheReflectionAloneDiffers) {
  constexpr int kSmall = 3;
  ScenePicture picture =
      ScenePicture::fromFile("../tests/truth/lit/scenes/doorway.boxprobe.json", kWidth / kSmall, kHeight / kSmall);
  const ReferenceScene reference = referenceOf(picture.scene);
  picture.renderer->setSightLines(traceSightLines);
  for (Probe& probe : picture.scene.probes) probe.bounces = 2;
  for (const int shot : {0, 2, 1, 3}) {  // by coefficients, and by lamps as shapes with their shadows and lattices
    const Camera& camera = picture.scene.cameras[static_cast<std::size_t>(shot / 2) % picture.scene.cameras.size()];
    picture.scene.lamps = shot % 2 == 0 ? LampForm::InMap : LampForm::Shapes;
    picture.show(camera);
    const ImageRgbaF drawn = picture.linear(4);
    const auto diffuse = std::make_shared<const ProbesDiffuse>(picture.renderer->probesDiffuse());
    ReferenceSettings settings;
    settings.width = kWidth / kSmall;
    settings.height = kHeight / kSmall;
    settings.samplesPerPixel = 4;
    settings.raysPerPixel = 4;
    settings.diffuse = diffuse;
    const ImageRgbaF own = reference.render(camera, settings).color;
    const std::string name = camera.name + (shot % 2 == 0 ? "" : "-shapes");
    keepPicture(drawn, "reflection-traced-" + name + "-drawn");
    keepPicture(own, "reflection-traced-" + name);
    settings.diffuse = nullptr;
    const ImageRgbaF sky = reference.render(camera, settings).color;
    std::vector<double> off, without;
    for (std::size_t i = 0; i < drawn.pixels.size(); i += 4) {
      const auto error = [&](const ImageRgbaF& image) {
        const double d = image.pixels[i + 1] - drawn.pixels[i + 1];
        return std::abs(d) / std::max(static_cast<double>(drawn.pixels[i + 1]), 1.0e-3);
      };
      off.push_back(error(own));
      without.push_back(error(sky));
    }
    std::printf("  %s: median off by %.4f, 90 %% within %.4f; with the sky's diffuse light alone %.3f\n", name.c_str(),
                quantile(off, 0.5), quantile(off, 0.9), quantile(without, 0.5));
    EXPECT_LT(quantile(off, 0.5), 0.004) << name;
    EXPECT_LT(quantile(off, 0.9), 0.03) << name;
    EXPECT_GT(quantile(without, 0.5), 0.1) << name;
  }
}

// In the empty room the walls stand on the box, so the two references are two ways to the same number: one looks a
// capture up at box hits, the other traces triangles and textures. Rays that meet an edge of a picture or a lamp are
// left out of both, by what the capture shows there.
TEST(Reference, BoxAndSceneAgreeWhereTheBoxIsTheTruth) {
  for (const float roughness : {0.25f, 0.5f}) {
    ScenePicture picture(emptyRoom(roughness), kWidth, kHeight);
    picture.scene.probes[0].faceSize = 512;
    const ReferenceScene reference = referenceOf(picture.scene);
    Scores apart, everything;
    double leftOut = 0.0, rays = 0.0;
    for (const char* name : {"main", "B"}) {
      const Camera camera = cameraNamed(picture.scene, name);
      picture.show(camera);
      ReferenceBoxMaps maps;
      maps.probes.push_back(picture.renderer->mapsOnCpu(picture.scene.probes[0].name));
      const CubeMap& capture = maps.probes[0]->radiance;
      std::vector<glm::ivec2> places;
      for (int y = 4; y < kHeight; y += 14) {
        for (int x = 4; x < kWidth; x += 14) places.emplace_back(x, y);
      }
      constexpr int kRays = 32;
      for (const Explanation& e : picture.renderer->explain(places, kWidth, kHeight)) {
        if (e.surface.object != "floor") continue;
        const auto hit = reference.tracer().firstHit(camera.position, e.surface.positionWorld - camera.position);
        ASSERT_TRUE(hit.has_value());
        const glm::dvec3 away = reference.tracer().awayFrom(*hit);
        const ReflectingLayer layer = reflectingLayers(e.surface, Energy::Single).at(0);
        const VisibleNormalLobe lobe(glm::normalize(layer.normalWorld), glm::normalize(glm::dvec3(e.surface.viewWorld)),
                                     roughness * roughness);
        const BoxWorld world(e.probes.at(0), capture);
        const auto mean = [&](std::uint64_t seed, const auto& radiance) {
          return lobeMean(lobe, glm::dvec3(layer.fresnel.f0), glm::dvec3(layer.fresnel.f90), kRays, seed, radiance);
        };
        const auto boxSees = [&](const glm::dvec3& l) { return world.radiance(l); };
        const auto tracerSees = [&](const glm::dvec3& l) { return reference.seenFrom(away, l, RaySees::Probes); };
        // The quotient of two means over the same rays: the mean over those that count.
        const auto evenMean = [&](std::uint64_t seed, const auto& radiance) {
          const glm::dvec3 sum = mean(seed, [&](const glm::dvec3& l) {
            const bool even = evenAround(capture, world.hit(l));
            leftOut += even ? 0.0 : 1.0;
            rays += 1.0;
            return even ? radiance(l) : glm::dvec3(0.0);
          });
          const double share = mean(seed, [&](const glm::dvec3& l) {
                                 return glm::dvec3(evenAround(capture, world.hit(l)) ? 1.0 : 0.0);
                               }).x;
          return share > 0.0 ? sum / share : glm::dvec3(0.0);
        };
        const std::uint64_t seed = hashBits(static_cast<std::uint64_t>(e.y * kWidth + e.x));
        const auto boxSeed = [&](int pass) { return hashBits(seed + static_cast<std::uint64_t>(2 * pass)); };
        const auto sceneSeed = [&](int pass) { return hashBits(seed + static_cast<std::uint64_t>(2 * pass + 1)); };
        everything.add(overPasses([&](int pass) { return mean(boxSeed(pass), boxSees); }),
                       overPasses([&](int pass) { return mean(sceneSeed(pass), tracerSees); }));
        apart.add(overPasses([&](int pass) { return evenMean(boxSeed(pass), boxSees); }),
                  overPasses([&](int pass) { return evenMean(sceneSeed(pass), tracerSees); }));
      }
    }
    std::printf("  roughness %.2f, %.0f %% of the rays meet an edge\n", static_cast<double>(roughness),
                100.0 * leftOut / rays);
    everything.print("all rays");
    apart.print("edges apart");
    ASSERT_GT(apart.count, 900);
    // The three components of a point go together: a third of them is independent.
    EXPECT_LT(std::abs(apart.zSum / apart.count), 3.0 / std::sqrt(apart.count / 3.0));
    EXPECT_GT(apart.beyondShare(), 0.02);
    EXPECT_LT(apart.beyondShare(), 0.08);
    for (const Scores& scores : {apart, everything}) {
      EXPECT_LT(std::abs(scores.difference), 3.0 * std::sqrt(3.0 * scores.variance));
    }
  }
}

}  // namespace
