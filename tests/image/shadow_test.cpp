// Shadows by a probe's coverage: how soft they are against a traced area light, over the distance to the opening; that
// a light that moves makes none jump; coloured glass; what moves; and that lights that ask for none cost nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/geometry/light_shadow.h"
#include "filters/explain/explain_shadow.h"
#include "filters/io/gltf/model_file.h"
#include "filters/math/cube/openings.h"
#include "filters/reference/light/reference_scene.h"
#include "filters/reference/trace/shadow_light.h"
#include "tests/support/line_chart.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

Scene windowsScene() {
  Scene scene = ScenePicture::fromFile("scenes/windows.boxprobe.json", 8, 8).scene;
  scene.objects["globe"].visible = false;
  scene.probes[0].bounces = 1;
  return scene;
}

TriangleScene trianglesOf(const Scene& scene) {
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& file : scene.models) models.push_back(std::make_shared<Model>(loadModelFile(file.file)));
  return makeTriangleScene(scene, models);
}

/// What explanations, which agree with the shader, say of the light at a point of the floor.
class CoverageAt {
 public:
  CoverageAt(const Scene& scene, const BakedMaps& maps) : chain_(throughChain(maps.radiance)) {
    ExplainedProbe probe;
    probe.geometry = probeGeometry(scene.probes[0], maps.capturedAt, maps.capturedRotation);
    probe.coverage = &chain_;
    probe.shadowLights = 1;
    in_.probes = {probe};
    in_.weights = false;
    in_.shadowLights = {0};
  }
  double operator()(const glm::dvec3& point, const Light& light) {
    in_.lights = {light};
    in_.surface.positionWorld = point;
    in_.surface.normalWorld = glm::vec3(0.0f, 1.0f, 0.0f);
    return static_cast<double>(explainShadows(in_)[0].through.g);
  }

 private:
  CubeMap chain_;
  ExplainInput in_;
};

/// Of a rising edge sampled every `step`: from a tenth to nine tenths of its height.
double edgeWidth(const std::vector<double>& profile, double step) {
  const double high = *std::max_element(profile.begin(), profile.end());
  const auto crossing = [&](double level) {
    for (std::size_t i = 1; i < profile.size(); ++i) {
      const double a = profile[i - 1] / high, b = profile[i] / high;
      if (a < level && b >= level) return step * (static_cast<double>(i - 1) + (level - a) / (b - a));
    }
    return 0.0;
  };
  return crossing(0.9) - crossing(0.1);
}

/// The low opening in the south, x from -0.8 to 0.6, y from 0.4 to 1.2: the shadow of its eastern side on the floor,
/// where light that came in at height `y` and falls at `elevation` lands.
struct EdgeAt {
  double elevation, y;
  double distance() const { return y / std::sin(glm::radians(elevation)); }
  Light sun(double angleDegrees) const {
    Light light;
    const double e = glm::radians(elevation);
    light.direction = {0.0, -std::sin(e), -std::cos(e)};
    light.angleDegrees = angleDegrees;
    light.shadows = LightShadows::Coverage;
    return light;
  }
  std::vector<glm::dvec3> line(double half, double step) const {
    std::vector<glm::dvec3> points;
    const double z = 3.0 - y / std::tan(glm::radians(elevation));
    for (double x = 0.6 + half; x > 0.6 - half; x -= step) points.emplace_back(x, 0.0, z);
    return points;
  }
};

TEST(CoverageShadow, PenumbraIsAsWideAsATracedSuns) {
  ScenePicture picture(windowsScene(), 16, 16);
  picture.scene.probes[0].faceSize = 512;
  picture.show(picture.scene.cameras.front());
  const auto maps = picture.renderer->readMaps("room");
  ASSERT_TRUE(maps);
  CoverageAt coverage(picture.scene, *maps);
  const SceneTracer tracer(trianglesOf(picture.scene));
  constexpr double kStep = 0.005, kHalf = 0.55, kOff = 1.0e-4;
  for (const double angle : {2.0, 6.0}) {
    std::vector<double> at, traced, bySize, published;
    for (const EdgeAt& edge :
         {EdgeAt{55.0, 0.5}, EdgeAt{55.0, 0.8}, EdgeAt{45.0, 0.8}, EdgeAt{35.0, 0.8}, EdgeAt{30.0, 0.9},
          EdgeAt{25.0, 0.9}, EdgeAt{20.0, 0.8}, EdgeAt{16.0, 0.8}, EdgeAt{13.0, 0.8}, EdgeAt{11.0, 0.8}}) {
      Light sun = edge.sun(angle);
      std::vector<double> a, b, c;
      for (const glm::dvec3& p : edge.line(kHalf, kStep)) {
        a.push_back(lightThrough(tracer, p + glm::dvec3(0.0, kOff, 0.0), sun, 24).y);
        b.push_back(coverage(p, sun));
        Light other = sun;
        other.shadowLevel = ShadowLevel::Distance;
        c.push_back(coverage(p, other));
      }
      at.push_back(edge.distance());
      traced.push_back(edgeWidth(a, kStep));
      bySize.push_back(edgeWidth(b, kStep));
      published.push_back(edgeWidth(c, kStep));
      std::printf(
          "  sun of %.0f degrees, %.2f m from the opening: penumbra %.3f m traced, %.3f m by its size, %.3f m by "
          "the published level\n",
          angle, at.back(), traced.back(), bySize.back(), published.back());
    }
    keepPicture(lineChart("penumbra, m (10 to 90 %), sun of " + std::to_string(static_cast<int>(angle)) + " degrees",
                          "m to the opening", at,
                          {{"traced", traced, {40, 40, 40}},
                           {"by size", bySize, {200, 60, 30}},
                           {"published", published, {40, 90, 200}}}),
                "penumbra_" + std::to_string(static_cast<int>(angle)));
    double off = 0.0, offPublished = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      off += std::abs(std::log(bySize[i] / traced[i])) / static_cast<double>(at.size());
      offPublished += std::abs(std::log(published[i] / traced[i])) / static_cast<double>(at.size());
    }
    std::printf("  off by %.0f %% in the mean, the published level by %.0f %%\n", 100.0 * (std::exp(off) - 1.0),
                100.0 * (std::exp(offPublished) - 1.0));
    EXPECT_LT(off, std::log(1.2));
    EXPECT_LT(off, offPublished);
  }
}

constexpr int kWidth = 160, kHeight = 90;

Scene smallWindows() {
  Scene scene = ScenePicture::fromFile("scenes/windows.boxprobe.json", 8, 8).scene;
  scene.probes[0].faceSize = 128;
  scene.probes[0].bounces = 1;
  return scene;
}

double largestDifference(const ImageRgbaF& a, const ImageRgbaF& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    largest = std::max(largest, static_cast<double>(std::abs(a.pixels[i] - b.pixels[i])));
  }
  return largest;
}

// A sun that moves along its way: no pixel changes by more than its share of the way, and by about half of it where the
// steps are halved. A jump would stay as large as it is, however small the steps.
TEST(CoverageShadow, ALightThatMovesMakesNothingJump) {
  ScenePicture picture(smallWindows(), kWidth, kHeight);
  picture.scene.objects["globe"].visible = false;
  picture.scene.lights[0].angleDegrees = 6.0;
  const Camera camera = cameraNamed(picture.scene, "floor");
  picture.show(camera);
  const auto largestStep = [&](int steps) {
    double largest = 0.0;
    ImageRgbaF before;
    for (int i = 0; i <= steps; ++i) {
      const Scene old = picture.scene;
      const double angle = glm::radians(20.0 + 10.0 * i / steps);
      picture.scene.lights[0].direction = {-std::cos(angle), -0.7, -std::sin(angle)};
      picture.renderer->sync(picture.scene, difference(old, picture.scene));
      picture.renderer->finishWork();
      ImageRgbaF now = picture.linear(1);
      if (i > 0) largest = std::max(largest, largestDifference(before, now));
      before = std::move(now);
    }
    return largest;
  };
  const double whole = largestStep(1), coarse = largestStep(20), fine = largestStep(40);
  std::printf(
      "  over 10 degrees of the sun a pixel changes by up to %.3f; in a step of 0.5 degrees %.3f, of 0.25 %.3f\n",
      whole, coarse, fine);
  EXPECT_GT(whole, 0.5) << "shadows that move";
  EXPECT_LT(coarse, 0.35 * whole);
  EXPECT_LT(fine, 0.75 * coarse);
}

// The colour of glass in the light it lets through, as rays through the pane have it.
TEST(CoverageShadow, ColouredGlassColoursTheLight) {
  ScenePicture picture(smallWindows(), kWidth, kHeight);
  picture.scene.objects["globe"].visible = false;
  picture.scene.probes[0].faceSize = 256;
  picture.show(cameraNamed(picture.scene, "top"));
  const SceneTracer tracer(trianglesOf(picture.scene));
  std::vector<glm::ivec2> pixels;
  for (int y = 2; y < kHeight; y += 4) {
    for (int x = 2; x < kWidth; x += 4) pixels.emplace_back(x, y);
  }
  int coloured = 0, near = 0, places = 0;
  glm::dvec3 seen(0.0), truth(0.0);
  for (const Explanation& e : picture.renderer->explain(pixels, kWidth, kHeight)) {
    if (e.surface.object != "floor" || e.shadows.empty()) continue;
    const glm::dvec3 away = e.surface.positionWorld + glm::dvec3(0.0, 1.0e-4, 0.0);
    const glm::dvec3 traced = lightThrough(tracer, away, picture.scene.lights[0], 12);
    const glm::dvec3 drawn(e.shadows[0].through);
    ++places;
    near += glm::length(traced - drawn) < 0.15 ? 1 : 0;
    if (traced.x < 0.3 || traced.z > 0.5 * traced.x) continue;
    ++coloured;
    seen += drawn;
    truth += traced;
  }
  ASSERT_GT(coloured, 5) << "no light through the glass";
  std::printf(
      "  %d of %d places of the floor within 0.15 of a traced sun; behind the glass %.3f %.3f %.3f, traced %.3f "
      "%.3f %.3f\n",
      near, places, seen.x / coloured, seen.y / coloured, seen.z / coloured, truth.x / coloured, truth.y / coloured,
      truth.z / coloured);
  EXPECT_GT(near, places * 9 / 10);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / coloured, truth[c] / coloured, 0.1);
}

// The globe's shadow: none without the map, and with it where a ray to the sun meets the globe.
TEST(CoverageShadow, WhatMovesThrowsItsShadowByAMap) {
  ScenePicture picture(smallWindows(), kWidth, kHeight);
  picture.show(cameraNamed(picture.scene, "top"));
  picture.window->Render();
  keepPicture(picture.display(), "windows_top");
  const auto& counters = picture.renderer->counters();
  const std::uint64_t maps = counters.shadowMapsDrawn;
  EXPECT_EQ(maps, 1u);
  picture.window->Render();
  EXPECT_EQ(counters.shadowMapsDrawn, maps) << "drawn again although nothing moved";
  const SceneTracer tracer(trianglesOf(picture.scene));
  const auto tally = [&] {
    std::vector<glm::ivec2> pixels;
    for (int y = 1; y < kHeight; y += 2) {
      for (int x = 1; x < kWidth; x += 2) pixels.emplace_back(x, y);
    }
    int shadowed = 0, agree = 0;
    for (const Explanation& e : picture.renderer->explain(pixels, kWidth, kHeight)) {
      if (e.surface.object != "floor" || e.shadows.empty()) continue;
      const glm::dvec3 away = e.surface.positionWorld + glm::dvec3(0.0, 1.0e-4, 0.0);
      const glm::dvec3 toSun = -glm::normalize(picture.scene.lights[0].direction);
      const auto hit = tracer.firstHit(away, toSun, RaySees::Picture);
      if (!hit || tracer.object(*hit).node != "globe") continue;
      ++shadowed;
      agree += e.shadows[0].moving && *e.shadows[0].moving < 0.5f ? 1 : 0;
    }
    return std::make_pair(shadowed, agree);
  };
  const auto [shadowed, agree] = tally();
  std::printf("  %d pixels in the globe's shadow by rays, %d of them by the map\n", shadowed, agree);
  ASSERT_GT(shadowed, 10);
  EXPECT_GT(agree, shadowed * 8 / 10);
  // Moved: the map follows, and no probe is captured for it.
  const std::uint64_t faces = counters.facesCaptured;
  const Scene old = picture.scene;
  picture.scene.objects["globe"].visible = false;
  picture.renderer->sync(picture.scene, difference(old, picture.scene));
  picture.renderer->finishWork();
  picture.window->Render();
  EXPECT_EQ(counters.facesCaptured, faces);
  EXPECT_EQ(counters.shadowMapsDrawn, maps) << "nothing moves any more";
}

TEST(CoverageShadow, LightsThatAskForNoneOrLieInsideAreNotLookedUp) {
  const auto draws = [](const std::function<void(Scene&)>& change) {
    ScenePicture picture(smallWindows(), 64, 36);
    picture.scene.probes[0].faceSize = 32;
    change(picture.scene);
    picture.show(picture.scene.cameras.front());
    picture.window->Render();
    EXPECT_EQ(picture.renderer->error(), "");
    const Counters& c = picture.renderer->counters();
    return std::make_pair(c.drawsWithCoverage, c.shadowMapsDrawn);
  };
  const auto lamp = [](Scene& scene, const glm::dvec3& position) {
    Light light;
    light.type = LightType::Point;
    light.position = position;
    light.shadows = LightShadows::CoverageAndMap;
    scene.lights = {light};
  };
  using Counts = std::pair<std::uint64_t, std::uint64_t>;
  EXPECT_GT(draws([](Scene&) {}).first, 0u);
  EXPECT_EQ(draws([](Scene& s) { s.lights[0].shadows = LightShadows::None; }), Counts(0, 0));
  EXPECT_EQ(draws([&](Scene& s) { lamp(s, {0.0, 1.5, 0.0}); }), Counts(0, 0));
  EXPECT_GT(draws([&](Scene& s) { lamp(s, {6.0, 1.5, 0.0}); }).first, 0u);
  EXPECT_EQ(draws([](Scene& s) { s.lights[0].shadows = LightShadows::Coverage; }).second, 0u);
  EXPECT_EQ(draws([](Scene& s) { s.objects["globe"].dynamic = false; }).second, 0u);
}

// The remark of `info` on a light that lies in a box.
TEST(CoverageShadow, ALightInsideIsRemarkedOn) {
  Scene scene = smallWindows();
  EXPECT_TRUE(featuresNotUsed(scene).empty());
  scene.lights[0].type = LightType::Point;
  scene.lights[0].position = {0.0, 1.0, 0.0};
  const std::vector<std::string> remarks = featuresNotUsed(scene);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("lights[0].shadows: has no effect in probe \"room\""), std::string::npos) << remarks[0];
}

}  // namespace
