// Two facing mirrors, each in a bright frame: how deep the frames nest with each bounce, and what a bounce costs.
#include <gtest/gtest.h>

#include "filters/core/scene/bounces.h"
#include "tests/image/quad_world.h"
#include "tests/support/scene_picture.h"

namespace boxprobe::test {
namespace {

constexpr float kFrame = 1.8f, kMirror = 1.08f;  // half sides
constexpr int kWidth = 1024, kHeight = 9;

// Seen from the middle a mirror at distance 2 shows the other at a third of its size, that one the first at a third of
// that: frames at 1/3, 1/9, ... Each is 1.67 times as wide outside as inside, so they stay apart.
Model facingMirrors() {
  Model model;
  for (const float side : {-1.0f, 1.0f}) {
    const std::string name = side < 0.0f ? "left" : "right";
    const glm::vec3 z(0, 0, side), y(0, 1, 0);
    addSquare(model, name + " frame", {2.0f * side, 0, 0}, kFrame * z, kFrame * y, glowing(glm::vec3(1.0f)));
    addSquare(model, name + " mirror", {1.9999f * side, 0, 0}, kMirror * z, kMirror * y, mirror());
  }
  return model;
}

// Bright runs of the middle row from its middle to the right: frames within frames.
int nestedFrames(const ImageRgbaF& image) {
  int frames = 0;
  bool inside = false;
  for (int x = kWidth / 2; x < kWidth; ++x) {
    const float value =
        image.pixels[(static_cast<std::size_t>(kHeight / 2) * kWidth + static_cast<std::size_t>(x)) * 4];
    if (!inside && value > 0.4f) ++frames;
    inside = inside ? value > 0.2f : value > 0.4f;
  }
  return frames;
}

TEST(Bounces, EachNestsTheMirrorsOnceMore) {
  Scene scene = darkScene();
  scene.probes = {cubeProbe("between", glm::dvec3(0.0), 2.0, 512)};
  QuadWorld world(scene, {facingMirrors()}, kWidth, kHeight);
  Camera camera;
  camera.position = glm::dvec3(0.0);
  camera.target = {1.0, 0.0, 0.0};
  camera.verticalFovDegrees = 0.33;  // 36 degrees wide: the whole reflection of the opposite frame
  for (int bounces = 1; bounces <= 5; ++bounces) {
    world.scene.probes[0].bounces = bounces;
    const std::uint64_t before = world.faces();
    world.show();
    world.renderer->applyCamera(camera);
    const ImageRgbaF image = world.renderer->renderLinear(kWidth, kHeight, 4);
    keepPicture(image, "bounces" + std::to_string(bounces));
    EXPECT_EQ(nestedFrames(image), bounces);
    // The innermost mirror is black.
    EXPECT_LT(image.pixels[(kHeight / 2 * kWidth + kWidth / 2) * 4], 0.05f);
    const BounceCost& cost = world.renderer->times().bounces[static_cast<std::size_t>(bounces - 1)];
    // It starts from the bounce before, and the four faces that show no mirror are kept.
    EXPECT_EQ(cost.faces, bounces == 1 ? 6u : 2u);
    EXPECT_EQ(cost.faces, world.faces() - before);
    EXPECT_GT(cost.cpuSeconds, 0.0);
    std::printf("bounce %d: %llu faces captured, %.3f s of CPU time\n", bounces,
                static_cast<unsigned long long>(cost.faces), cost.cpuSeconds);
  }
}

// Only +X shows something a probe lights: the other five faces of a further bounce are those of the one before.
TEST(Bounces, FacesThatShowNothingAProbeLightsAreKept) {
  Model model;
  addSquare(model, "mirror", {2, 0, 0}, {0, 0, 0.5f}, {0, 0.5f, 0}, mirror());
  addSquare(model, "lamp", {-20, 0, 0}, {0, 0, 5}, {0, 5, 0}, glowing({1, 2, 3}));
  Scene scene = darkScene();
  scene.probes = {cubeProbe("probe", glm::dvec3(0.0), 3.0)};
  scene.probes[0].bounces = 3;
  QuadWorld world(scene, {model});
  world.show();
  EXPECT_EQ(world.faces(), 6u + 1u + 1u);
  EXPECT_EQ(world.reused(), 5u + 5u);
}

// Six matt walls of one room, each scattering .62 of what comes and shining itself: light L is E + .62 L all over, so
// that bounce n lacks .62^n of it. They end where one brings less than 1 % of what all have brought.
TEST(Bounces, AllEndByThemselves) {
  constexpr float kReflected = 0.62f, kHalf = 1.3f;
  Model model;
  Material wall = mirror();
  wall.baseColor = glm::vec4(glm::vec3(kReflected), 1.0f);
  wall.metallic = 0.0f;
  wall.roughness = 1.0f;
  wall.specular = wall.finish.specularEdge = 0.0f;
  wall.emissive = {0.9f, 0.5f, 0.2f};
  for (int side = 0; side < 6; ++side) {
    glm::vec3 middle(0.0f), u(0.0f), v(0.0f);
    middle[side / 2] = side % 2 == 0 ? kHalf : -kHalf;
    u[(side / 2 + 1) % 3] = side % 2 == 0 ? -kHalf : kHalf;
    v[(side / 2 + 2) % 3] = kHalf;
    addSquare(model, "wall " + std::to_string(side), middle, u, v, wall);
  }
  const auto light = [&](int bounces, std::uint64_t& faces) {
    Scene scene = darkScene();
    scene.lamps = LampForm::InMap;
    scene.probes = {cubeProbe("room", glm::dvec3(0.0), static_cast<double>(kHalf))};
    scene.probes[0].origin = {0.2, -0.1, 0.3};
    scene.probes[0].bounces = bounces;
    QuadWorld world(scene, {model});
    world.show();
    EXPECT_EQ(world.renderer->error(), "");
    EXPECT_EQ(world.renderer->bakeState("room"), BakeState::UpToDate);
    faces = world.faces();
    return static_cast<double>(world.renderer->readMaps("room")->radiance.texel(0, 2, 9, 14).x);
  };
  std::uint64_t five = 0, all = 0;
  const double atFive = light(5, five), atAll = light(kAllBounces, all);
  std::printf("light by 5 bounces %.4f, by all %.4f (%llu faces)\n", atFive, atAll,
              static_cast<unsigned long long>(all));
  EXPECT_EQ(five, 30u);
  EXPECT_GT(all, 36u) << "five are not all here";
  EXPECT_LT(all, 6u * kAllBounces) << "they end before the last";
  EXPECT_GT(atAll, 1.02 * atFive);
  // What is left is a geometric series: at most 1 % r / (1 - r) of all that bounces bring.
  const double ratio = 0.62, whole = 0.9 / (1.0 - ratio);
  EXPECT_NEAR(atAll / whole, 1.0, 0.04);
}

// As if all had been made at once: the faces that are kept are the right ones.
TEST(Bounces, WhatIsKeptIsWhatWouldBeCaptured) {
  Scene scene = darkScene();
  scene.probes = {cubeProbe("between", glm::dvec3(0.0), 2.0), cubeProbe("other", {0.3, 0.2, -0.4}, 2.0)};
  for (Probe& probe : scene.probes) probe.bounces = 3;
  QuadWorld fresh(scene, {facingMirrors()});
  fresh.show();

  QuadWorld edited(scene, {facingMirrors()});
  edited.scene.probes[1].origin = {-0.7, 0.1, 0.3};
  edited.scene.probes[0].bounces = 1;
  edited.show();
  edited.editAndFinish([](Scene& s) { s.probes[0].bounces = 2; });
  edited.editAndFinish([&](Scene& s) { s.probes = scene.probes; });
  for (const char* name : {"between", "other"}) {
    const auto a = fresh.renderer->readMaps(name), b = edited.renderer->readMaps(name);
    ASSERT_TRUE(a && b);
    const std::size_t size = static_cast<std::size_t>(a->radiance.levelSize(0)) * 4 * 32;
    for (int face = 0; face < 6; ++face) {
      EXPECT_EQ(std::vector<float>(a->radiance.face(0, face), a->radiance.face(0, face) + size),
                std::vector<float>(b->radiance.face(0, face), b->radiance.face(0, face) + size))
          << name << " face " << face;
    }
  }
}

}  // namespace
}  // namespace boxprobe::test
