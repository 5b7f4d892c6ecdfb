// Realtime probes: what one frame costs while something moves, how many frames later it shows, and that nothing runs
// when nothing moves.
#include <gtest/gtest.h>

#include "tests/image/quad_world.h"

namespace boxprobe::test {
namespace {

// The frames from a change to its picture: one a face that changed, then mip chain, level 1, further levels.
constexpr int kFilterFrames = 3;

Model walls() {
  Model model;
  addSquare(model, "floor", {0, -1, 0}, {0.2f, 0, 0}, {0, 0, -0.2f}, mirror());
  return model;
}
Model lamp() {
  Model model;
  addSquare(model, "lamp", {3, 0, 0}, {0, 0, 0.4f}, {0, 0.4f, 0}, glowing({4, 2, 1}));
  return model;
}

QuadWorld movingLamp(ProbeMode mode) {
  Scene scene = darkScene();
  scene.probes = {cubeProbe("probe", glm::dvec3(0.0), 2.0, 64)};
  scene.probes[0].mode = mode;
  scene.objects["lamp"].dynamic = true;
  return QuadWorld(scene, {walls(), lamp()});
}

float redTowards(QuadWorld& world, const glm::vec3& direction) {
  return world.renderer->readMaps("probe")->radiance.fetch(direction, 0.0f).x;
}

TEST(Realtime, OneFaceAFrameAndAStatedLatency) {
  QuadWorld world = movingLamp(ProbeMode::Realtime);
  world.show();
  EXPECT_GT(redTowards(world, {1, 0, 0}), 3.9f);
  EXPECT_FALSE(world.renderer->workPending()) << "an idle window does nothing";

  // Within one face: that one alone is captured.
  const std::uint64_t faces = world.faces(), programs = world.renderer->counters().programsCompiled;
  world.edit([](Scene& s) { s.models[1].translation.y = 1.0; });
  int frames = 0;
  while (world.renderer->workPending()) {
    EXPECT_GT(redTowards(world, {1, 0, 0}), 3.9f) << "no half of a new picture shows, frame " << frames;
    world.renderer->step();
    ++frames;
  }
  EXPECT_EQ(frames, 1 + kFilterFrames);
  EXPECT_EQ(world.faces(), faces + 1);
  EXPECT_EQ(world.reused(), 5u);
  EXPECT_LT(redTowards(world, {1, 0, 0}), 0.1f);
  EXPECT_GT(redTowards(world, {3, 1, 0}), 3.9f);
  EXPECT_EQ(world.renderer->counters().programsCompiled, programs) << "a model that moves keeps its programs";

  // A light changes all six.
  world.edit([](Scene& s) { s.lights.push_back(Light{}); });
  for (frames = 0; world.renderer->workPending(); ++frames) world.renderer->step();
  EXPECT_LE(frames, 6 + kFilterFrames);
  EXPECT_EQ(world.faces(), faces + 1 + 6);
}

TEST(Realtime, EveryFrameOfAMovementIsFlat) {
  QuadWorld world = movingLamp(ProbeMode::Realtime);
  world.scene.probes[0].bounces = 2;
  world.show();
  int shown = 0;
  auto last = redTowards(world, {3, 0.5f, 0});
  for (int frame = 0; frame < 60; ++frame) {
    // Round the probe, through four faces.
    const double angle = 0.1 * frame;
    world.edit([&](Scene& s) { s.models[1].translation = {3.0 * std::cos(angle) - 3.0, 0.0, 3.0 * std::sin(angle)}; });
    const std::uint64_t faces = world.faces(), levels = world.levels();
    world.renderer->step();
    const std::uint64_t captured = world.faces() - faces, filtered = world.levels() - levels;
    EXPECT_LE(captured, 1u);
    if (captured > 0) {
      EXPECT_EQ(filtered, 0u) << "a frame captures or filters";
    }
    const float now = redTowards(world, {3, 0.0f, 0});
    shown += now != last ? 1 : 0;
    last = now;
  }
  EXPECT_GE(shown, 1) << "the movement shows while it goes on";
  world.renderer->finishWork();
  // At rest it is what a probe that never saw another place shows.
  QuadWorld still = movingLamp(ProbeMode::Realtime);
  still.scene = world.scene;
  still.show();
  for (const glm::vec3& d : {glm::vec3(1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(-1, 0.1f, 0.2f), glm::vec3(0, 0, -1)}) {
    EXPECT_EQ(redTowards(world, d), redTowards(still, d));
  }
}

TEST(Realtime, WhatMovesIsLeftOutOfBakedProbes) {
  QuadWorld world = movingLamp(ProbeMode::Baked);
  world.show();
  EXPECT_EQ(redTowards(world, {1, 0, 0}), 0.0f);
  const std::uint64_t faces = world.faces();
  world.edit([](Scene& s) { s.models[1].translation.y = 1.0; });
  EXPECT_FALSE(world.renderer->workPending());
  EXPECT_EQ(world.faces(), faces);
}

}  // namespace
}  // namespace boxprobe::test
