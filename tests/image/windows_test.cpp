// The sky through windows: what a floor reflects of it against a ray-traced picture, over the edge of an opening, after
// the sky has become another one, and that a room without openings pays nothing for them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/geometric.hpp>

#include "filters/io/gltf/model_file.h"
#include "filters/io/image/image_file.h"
#include "filters/reference/light/reference_scene.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 320, kHeight = 180;

/// The room without sun and globe; the floor a metal, walls that only glow, so that all that reaches the eye by way of
/// the floor is what walls and sky send out, the same in every kind of capture.
Scene emptyWindows(double floorRoughness) {
  Scene scene = ScenePicture::fromFile("scenes/windows.boxprobe.json", 8, 8).scene;
  scene.lights.clear();
  for (const char* node : {"globe", "coloured glass"}) {
    scene.objects[node].visible = false;
    scene.objects[node].seenByProbes = false;
  }
  for (const char* wall : {"ceiling", "wall north", "wall west", "wall east", "wall south"})
    scene.materials[wall].baseColor = glm::vec3(0.0f);
  scene.materials["floor"].metallic = 1.0f;
  scene.materials["floor"].roughness = static_cast<float>(floorRoughness);
  scene.probes[0].bounces = 1;
  return scene;
}

ReferenceScene referenceOf(const Scene& scene) {
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& file : scene.models) models.push_back(std::make_shared<Model>(loadModelFile(file.file)));
  return ReferenceScene(scene, models, nullptr);
}

/// Pixels whose middle shows the floor.
std::vector<bool> floorMask(const ReferenceScene& reference, const Camera& camera) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
  const double tangent = std::tan(0.5 * camera.verticalFovDegrees * 3.14159265358979 / 180.0);
  std::vector<bool> mask;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double u = (2.0 * x + 1.0) / kWidth - 1.0, v = 1.0 - (2.0 * y + 1.0) / kHeight;
      const auto hit =
          reference.tracer().firstHit(camera.position, forward + tangent * (u * kWidth / kHeight * right + v * up));
      mask.push_back(hit && reference.tracer().object(*hit).node == "floor");
    }
  }
  return mask;
}

class WindowSky : public ::testing::TestWithParam<double> {};

TEST_P(WindowSky, CoverageIsNearerToTheTruthThanASkyPaintedOnTheWalls) {
  const double roughness = GetParam();
  ScenePicture picture(emptyWindows(roughness), kWidth, kHeight);
  picture.scene.probes[0].technique = "box+footprint4";
  const ReferenceScene reference = referenceOf(picture.scene);
  const Camera camera = cameraNamed(picture.scene, "floor");
  ReferenceSettings settings;
  settings.width = kWidth;
  settings.height = kHeight;
  settings.samplesPerPixel = 4;
  settings.raysPerPixel = roughness > 0.0 ? 256 : 4;
  const ImageRgbaF truth = reference.render(camera, settings).color;
  const std::vector<bool> floor = floorMask(reference, camera);

  picture.show(camera);
  const ImageRgbaF open = picture.linear();
  picture.scene.probes[0].clear = ClearToSky{};
  picture.show(camera);
  const ImageRgbaF painted = picture.linear();
  const std::string name = "windows_" + std::to_string(static_cast<int>(10.0 * roughness));
  keepPicture(truth, name + "_truth");
  keepPicture(open, name + "_open");
  keepPicture(painted, name + "_painted");
  const double with = psnr(open, truth, floor), without = psnr(painted, truth, floor);
  std::printf("  roughness %.1f: floor reflection %.2f dB with coverage, %.2f dB with the sky in the probe\n",
              roughness, with, without);
  EXPECT_GT(with, without + 0.2);
}

INSTANTIATE_TEST_SUITE_P(Roughness, WindowSky, ::testing::Values(0.0, 0.3, 0.6));

/// A picture of all around; `texel(longitude, latitude)` in parts of it.
std::string pictureFile(const std::string& name, const std::function<glm::vec4(double, double)>& texel) {
  ImageRgbaF image{256, 128, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const glm::vec4 value = texel((x + 0.5) / image.width, (y + 0.5) / image.height);
      image.pixels.insert(image.pixels.end(), {value.r, value.g, value.b, value.a});
    }
  }
  const std::string path = testing::TempDir() + name;
  saveExr(path, image);
  return path;
}

// Walls and a sky of one and the same light: then no edge of an opening may be seen, at any level. The probe is a
// picture with openings of every size, so that filtering and lookups are what is tested.
TEST(WindowEdge, VanishesWhereWallAndSkyAreAlike) {
  constexpr float kLight = 0.6f;
  const std::string file = pictureFile("windows_edges.exr", [](double u, double v) {
    const bool open = std::fmod(7.0 * u, 1.0) < 0.45 && std::fmod(5.0 * v, 1.0) > 0.3;
    return open ? glm::vec4(0.0f) : glm::vec4(kLight, kLight, kLight, 1.0f);
  });
  for (const double roughness : {0.0, 0.15, 0.3, 0.6, 1.0}) {
    ScenePicture picture(emptyWindows(roughness), kWidth, kHeight);
    picture.scene.probes[0].mode = ProbeMode::Custom;
    picture.scene.probes[0].image = file;
    picture.scene.sky = SkyColor{glm::vec3(kLight)};
    picture.show(cameraNamed(picture.scene, "floor"));
    std::vector<glm::ivec2> line;
    for (int x = 0; x < kWidth; ++x) line.emplace_back(x, kHeight * 3 / 4);
    int edges = 0;
    float off = 0.0f, wrong = 0.0f;
    for (const Explanation& e : picture.renderer->explain(line, kWidth, kHeight)) {
      if (e.surface.object != "floor" || e.probes.empty() || !e.probes[0].coverage) continue;
      const ProbeExplanation& p = e.probes[0];
      const float a = *p.coverage;
      edges += a > 0.02f && a < 0.98f ? 1 : 0;
      off = std::max(off, std::abs(p.specular.g + (1.0f - a) * p.openSky.g - kLight));
      // As if the light were not yet multiplied by its coverage.
      wrong = std::max(wrong, std::abs(a * p.specular.g + (1.0f - a) * p.openSky.g - kLight));
      ASSERT_TRUE(e.rendered);
      EXPECT_LT(glm::length(*e.rendered - e.color), 2.0e-3f) << "the shader agrees";
    }
    std::printf("  roughness %.2f: %d lookups across edges, off by %.5f of %.1f; %.3f as if not premultiplied\n",
                roughness, edges, off, kLight, wrong);
    ASSERT_GT(edges, 10);
    EXPECT_LT(off, 2.0e-3f) << "half floats resolve 0.0005 here";
    EXPECT_GT(wrong, 0.1f) << "no edge where a rim could show";
  }
}

// And that a capture is premultiplied to begin with: a texel that an opening's edge divides is as dark as its wall
// part.
TEST(WindowEdge, CapturedTexelsAreAsMuchWallAsTheyAreCovered) {
  ScenePicture picture(emptyWindows(0.0), 16, 16);
  picture.show(picture.scene.cameras.front());
  const auto maps = picture.renderer->readMaps("room");
  ASSERT_TRUE(maps);
  const CubeMap& cube = maps->radiance;
  int divided = 0;
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < cube.faceSize() * cube.faceSize(); ++i) {
      const glm::vec4 t = cube.texel(0, face, i % cube.faceSize(), i / cube.faceSize());
      if (t.a <= 0.0f) {
        EXPECT_EQ(t.g, 0.0f);
      }
      if (t.a <= 0.2f || t.a >= 0.8f) continue;
      ++divided;
      // Plaster of 0.56 that glows with 0.12 of that, 0.9 to 1.1 of it.
      EXPECT_NEAR(t.g / t.a, 0.067f, 0.010f);
    }
  }
  EXPECT_GT(divided, 300);
}

TEST(WindowSky, AnotherSkyCostsNoCapture) {
  ScenePicture picture(emptyWindows(0.2), kWidth, kHeight);
  picture.scene.probes[0].bounces = 2;
  picture.scene.probes[0].faceSize = 64;
  picture.scene.sky = SkyImage{pictureFile("windows_sky.exr", [](double u, double v) {
    const float bright = std::cos(6.2831853 * u) > 0.5 ? 2.0f : 0.2f;
    return glm::vec4(bright, 0.6f, static_cast<float>(v), 1.0f);
  })};
  const Camera camera = cameraNamed(picture.scene, "floor");
  picture.show(camera);
  const ImageRgbaF before = picture.linear();
  const auto edit = [&](const std::function<void(Scene&)>& change) {
    const Scene old = picture.scene;
    change(picture.scene);
    picture.renderer->sync(picture.scene, difference(old, picture.scene));
    picture.renderer->finishWork();
    return picture.linear();
  };
  const std::uint64_t faces = picture.renderer->counters().facesCaptured;
  ASSERT_GE(faces, 6u);
  const ImageRgbaF turned = edit([](Scene& s) { s.skyRotationDegrees = 180.0; });
  EXPECT_LT(psnr(before, turned, {}), 45.0) << "the turned sky is not seen";
  ScenePicture fresh(picture.scene, kWidth, kHeight);
  fresh.show(camera);
  EXPECT_GT(psnr(turned, fresh.linear(), {}), 70.0) << "as if the sky had been so from the start";
  const ImageRgbaF other = edit([](Scene& s) { s.sky = SkyColor{glm::vec3(2.0f, 0.1f, 0.1f)}; });
  EXPECT_LT(psnr(turned, other, {}), 30.0);
  EXPECT_EQ(picture.renderer->counters().facesCaptured, faces);
}

// A picture without alpha covers everything: no sky shows through it, and lights outside shine through walls it says
// nothing of.
TEST(WindowSky, APictureWithoutCoverageIsWhole) {
  ScenePicture picture = ScenePicture::fromFile("scenes/windows.boxprobe.json", 64, 36);
  picture.scene.objects["globe"].visible = false;
  Probe& probe = picture.scene.probes[0];
  probe.mode = ProbeMode::Custom;
  probe.image = pictureFile("windows_whole.exr", [](double, double) { return glm::vec4(0.4f, 0.4f, 0.4f, 1.0f); });
  picture.show(picture.scene.cameras.front());
  picture.window->Render();
  EXPECT_EQ(picture.renderer->counters().drawsWithOpenSky, 0u);
  const Explanation e = picture.renderer->explain(32, 30, 64, 36);
  ASSERT_EQ(e.surface.object, "floor");
  ASSERT_EQ(e.shadows.size(), 1u);
  EXPECT_EQ(e.shadows[0].through, glm::vec3(1.0f));
}

TEST(WindowSky, ARoomWithoutOpeningsLooksUpNoSky) {
  const auto draws = [](const std::string& scene, const Clear& clear) {
    ScenePicture picture = ScenePicture::fromFile("scenes/" + scene + ".boxprobe.json", 64, 36);
    for (Probe& probe : picture.scene.probes) {
      probe.clear = clear;
      probe.faceSize = 32;
    }
    picture.show(picture.scene.cameras.front());
    picture.window->Render();
    return picture.renderer->counters().drawsWithOpenSky;
  };
  EXPECT_GT(draws("windows", ClearToOpen{}), 0u);
  EXPECT_EQ(draws("windows", ClearToSky{}), 0u);
  EXPECT_EQ(draws("room", ClearToOpen{}), 0u);
  EXPECT_EQ(draws("six-faces", ClearToOpen{}), 0u);
}

}  // namespace
