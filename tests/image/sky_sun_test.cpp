// Suns of skies' pictures, drawn as lights: a floor's light against the picture's own, integrated here; shadows; what
// is looked at, what is captured; edits.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "filters/fit/rays/triangle_sight.h"
#include "filters/io/image/image_file.h"
#include "tests/image/quad_world.h"

namespace boxprobe::test {
namespace sky_sun {
namespace {

using glm::dvec3;
using glm::vec3;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadius = 0.8 * kPi / 180.0;
const dvec3 kSun = glm::normalize(dvec3(0.6, 0.9, 0.35)), kRadiance(9000.0, 8000.0, 5000.0);
const vec3 kAlbedo(0.7f, 0.5f, 0.3f);
const dvec3 kNormal = glm::normalize(dvec3(0.2, 1.0, -0.15)), kShelf(0.1, 0.9, -0.2);

dvec3 sky(const dvec3& d) {
  return dvec3(0.5, 0.6, 0.9) * (1.0 + 0.4 * d.x + 0.3 * d.y);
}
bool inSun(const dvec3& d) {
  return glm::length(d - kSun) < 2.0 * std::sin(0.5 * kRadius);
}

dvec3 direction(double x, double y, int width, int height) {
  const double longitude = kPi - 2 * kPi * x / width, latitude = kPi / 2 - kPi * y / height;
  return {std::cos(latitude) * std::sin(longitude), std::sin(latitude), std::cos(latitude) * std::cos(longitude)};
}

/// OpenEXR's latitude-longitude map: +Z in the middle, +X in its left half. A texel near the sun is the mean of 6 x 6
/// points.
std::string pictureFile() {
  constexpr int kWidth = 512, kHeight = 256;
  ImageRgbaF image{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool near = glm::length(direction(x + 0.5, y + 0.5, kWidth, kHeight) - kSun) < kRadius + 0.03;
      const int side = near ? 6 : 1;
      dvec3 sum(0.0);
      for (int i = 0; i < side * side; ++i) {
        const dvec3 d = direction(x + (i % side + 0.5) / side, y + (i / side + 0.5) / side, kWidth, kHeight);
        sum += sky(d) + (inSun(d) ? kRadiance : dvec3(0.0));
      }
      sum /= side * side;
      for (int c = 0; c < 3; ++c) image.pixels.push_back(static_cast<float>(sum[c]));
      image.pixels.push_back(1.0f);
    }
  }
  const std::string path = testing::TempDir() + "sky_sun_" + std::to_string(::getpid()) + ".exr";
  saveExr(path, image);
  return path;
}

/// A turn about +Y: 90 degrees take +Z to +X.
dvec3 turned(const dvec3& d, double degrees) {
  const double a = degrees * kPi / 180.0;
  return {std::cos(a) * d.x + std::sin(a) * d.z, d.y, std::cos(a) * d.z - std::sin(a) * d.x};
}

/// What a surface sends: its albedo over pi, times the light of the directions above it, by 180,000 of them. Without
/// the sun in a shadow.
dvec3 rightLight(double skyTurn, bool shadow) {
  dvec3 sum(0.0);
  constexpr int kRows = 300, kColumns = 600;
  for (int row = 0; row < kRows; ++row) {
    const double y = 1.0 - 2.0 * (row + 0.5) / kRows, level = std::sqrt(1.0 - y * y);
    for (int column = 0; column < kColumns; ++column) {
      const double angle = 2.0 * kPi * (column + 0.5) / kColumns;
      const dvec3 d(level * std::cos(angle), y, level * std::sin(angle));
      const double cosine = glm::dot(d, kNormal);
      if (cosine > 0.0) sum += cosine * sky(turned(d, -skyTurn));
    }
  }
  sum *= 4.0 * kPi / (kRows * kColumns);
  // The disc, too small for that grid: its solid angle, seen from nearly one direction.
  const double sine = std::sin(kRadius);
  if (!shadow) sum += kPi * sine * sine * std::max(glm::dot(turned(kSun, skyTurn), kNormal), 0.0) * kRadiance;
  return dvec3(kAlbedo) / kPi * sum;
}

Material plain(const vec3& color) {
  Material material;
  material.baseColor = glm::vec4(color, 1.0f);
  material.metallic = 0.0f;
  material.roughness = 1.0f;
  material.ior = 1.0f;  // reflects nothing of its own
  material.doubleSided = true;
  return material;
}

/// A tilted floor through the origin, and a small black sheet above it.
Model yard() {
  Model model;
  const dvec3 right = glm::normalize(glm::cross(kNormal, dvec3(0.0, 0.0, 1.0))), up = glm::cross(kNormal, right);
  addSquare(model, "floor", vec3(0.0f), vec3(4.0 * right), vec3(4.0 * up), plain(kAlbedo));
  addSquare(model, "shelf", vec3(kShelf), {0.3f, 0, 0}, {0, 0, 0.2f}, plain(vec3(0.0f)));
  return model;
}

class SkySunPicture : public ::testing::Test {
 protected:
  void TearDown() override { std::remove(path.c_str()); }
  static Scene sceneOf(const std::string& picture, bool probe) {
    Scene scene = darkScene();
    scene.sky = SkyImage{picture};
    if (probe) scene.probes = {cubeProbe("yard", {-0.7, 1.4, 0.9}, 1.1)};
    return scene;
  }
  const std::string path = pictureFile();
};

struct YardWorld : QuadWorld {
  explicit YardWorld(const Scene& lit) : QuadWorld(lit, {yard()}) { renderer->setSightLines(traceSightLines); }
  dvec3 seen(const dvec3& point) { return look(point + dvec3(-0.3, 0.45, 0.1), point); }
};

/// Where the shelf's middle throws its shadow.
dvec3 shadowOf(const dvec3& towards) {
  return kShelf - towards * (glm::dot(kShelf, kNormal) / glm::dot(towards, kNormal));
}
dvec3 onFloor(double x, double z) {
  return {x, -(kNormal.x * x + kNormal.z * z) / kNormal.y, z};
}

void expectNear(const dvec3& drawn, const dvec3& right, const char* what) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / right[c], 1.0, 0.02) << what << ", channel " << c;
}

TEST_F(SkySunPicture, LightsAFloorAsThePictureDoesAndThrowsAShadow) {
  YardWorld world(sceneOf(path, false));
  world.show();
  expectNear(world.seen(onFloor(-1.2, 0.8)), rightLight(0.0, false), "lit");
  expectNear(world.seen(onFloor(1.4, 1.1)), rightLight(0.0, false), "lit");
  expectNear(world.seen(shadowOf(kSun)), rightLight(0.0, true), "in the shadow");
  // Looked at, it is a disc of its radiance; beside it there is sky.
  const dvec3 far(0.0, 2.0, 0.0), beside = glm::normalize(kSun + dvec3(0.0, 0.06, -0.04));
  const vec3 disc = world.look(far, far + kSun), around = world.look(far, far + beside);
  EXPECT_NEAR(disc.y / kRadiance.y, 1.0, 0.2) << "the picture has two texels across the disc";
  EXPECT_NEAR(around.y / sky(beside).y, 1.0, 0.02);
  // Turned, the light comes from elsewhere.
  world.editAndFinish([](Scene& s) { s.skyRotationDegrees = 70.0; });
  expectNear(world.seen(onFloor(-1.2, 0.8)), rightLight(70.0, false), "lit, turned");
  expectNear(world.seen(shadowOf(turned(kSun, 70.0))), rightLight(70.0, true), "in the shadow, turned");
  expectNear(world.seen(shadowOf(kSun)), rightLight(70.0, false), "where the shadow was");
  // On request it stays in the picture, whose light no shadow stops.
  world.editAndFinish([](Scene& s) { std::get<SkyImage>(s.sky).sun = SkySunForm::InPicture; });
  EXPECT_GT(world.seen(shadowOf(turned(kSun, 70.0))).x, 1.2 * rightLight(70.0, true).x);
}

TEST_F(SkySunPicture, IsInNoCaptureAndAnEditIsAFreshStart) {
  YardWorld edited(sceneOf(path, true));
  edited.show();
  const auto maps = edited.renderer->readMaps("yard");
  const CubeMap& cube = maps->radiance;
  float most = 0.0f;
  for (int i = 0; i < 6 * cube.faceSize() * cube.faceSize(); ++i) most = std::max(most, cube.face(0, 0)[4 * i]);
  EXPECT_LT(most, 1.02 * std::max(rightLight(0.0, false).x, 0.5 * 1.5));
  const auto same = [&](const char* what) {
    YardWorld fresh(edited.scene);
    fresh.show();
    const auto a = edited.renderer->readMaps("yard"), b = fresh.renderer->readMaps("yard");
    for (int i = 0; i < 6 * 4 * cube.faceSize() * cube.faceSize(); ++i) {
      ASSERT_EQ(a->radiance.face(0, 0)[i], b->radiance.face(0, 0)[i]) << what;
    }
    const dvec3 at = onFloor(-1.2, 0.8);
    EXPECT_NEAR(edited.seen(at).x, fresh.seen(at).x, 1e-6) << what;
  };
  edited.editAndFinish([](Scene& s) { s.skyRotationDegrees = -130.0; });
  same("turned");
  edited.editAndFinish([](Scene& s) { std::get<SkyImage>(s.sky).sun = SkySunForm::InPicture; });
  const std::uint64_t faces = edited.faces();
  edited.editAndFinish([](Scene& s) { s.exposure = 0.5; });
  EXPECT_EQ(edited.faces(), faces) << "captured again for nothing";
  edited.editAndFinish([](Scene& s) {
    std::get<SkyImage>(s.sky).sun = SkySunForm::Lamp;
    s.skyRotationDegrees = 40.0;
  });
  same("taken out again");
}

}  // namespace
}  // namespace sky_sun
}  // namespace boxprobe::test
