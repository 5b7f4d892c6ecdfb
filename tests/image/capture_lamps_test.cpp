// Lamps drawn as shapes in captures: which light them depends on where they are captured, not on a probe's box. And
// lamps that are hardly any: a probe within one, light beyond half floats, none at all.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "filters/fit/rays/triangle_sight.h"
#include "tests/image/edited_room.h"
#include "tests/image/quad_world.h"

namespace boxprobe::test {
namespace {

using glm::dvec3;
using glm::vec3;

const vec3 kLow(-2.4f, 0.0f, -1.5f), kHigh(2.9f, 2.7f, 1.9f);

Material plain(const vec3& color, float metallic = 0.0f, float roughness = 1.0f) {
  Material material;
  material.baseColor = glm::vec4(color, 1.0f);
  material.metallic = metallic;
  material.roughness = roughness;
  if (metallic == 0.0f) material.ior = 1.0f;  // reflects nothing of its own
  material.doubleSided = true;
  return material;
}

/// Walls of one colour around a floor of another.
Model room(const vec3& walls, const vec3& floor) {
  Model model;
  const vec3 c = 0.5f * (kLow + kHigh), h = 0.5f * (kHigh - kLow);
  addSquare(model, "west", {kLow.x, c.y, c.z}, {0, 0, -h.z}, {0, h.y, 0}, plain(walls));
  addSquare(model, "east", {kHigh.x, c.y, c.z}, {0, 0, h.z}, {0, h.y, 0}, plain(walls));
  addSquare(model, "north", {c.x, c.y, kLow.z}, {h.x, 0, 0}, {0, h.y, 0}, plain(walls));
  addSquare(model, "south", {c.x, c.y, kHigh.z}, {-h.x, 0, 0}, {0, h.y, 0}, plain(walls));
  addSquare(model, "ceiling", {c.x, kHigh.y, c.z}, {h.x, 0, 0}, {0, 0, h.z}, plain(walls));
  addSquare(model, "floor", {c.x, kLow.y, c.z}, {h.x, 0, 0}, {0, 0, -h.z}, plain(floor));
  return model;
}

struct Lamp {
  dvec3 middle, u, v;  // half sides; it shines along u x v
};

void addLamp(Model& model, const char* name, const Lamp& lamp, const vec3& radiance) {
  Material shining = glowing(radiance);
  shining.doubleSided = false;
  addSquare(model, name, vec3(lamp.middle), vec3(lamp.u), vec3(lamp.v), shining);
}

// Of radiance 1, by the middles of many pieces: irradiance over pi.
double lightOf(const Lamp& lamp, const dvec3& point, const dvec3& normal) {
  constexpr int kPieces = 80;
  const dvec3 cross = glm::cross(lamp.u, lamp.v), shines = glm::normalize(cross);
  double sum = 0.0;
  for (int i = 0; i < kPieces * kPieces; ++i) {
    const dvec3 way = lamp.middle + ((i % kPieces + 0.5) * 2.0 / kPieces - 1.0) * lamp.u +
                      ((i / kPieces + 0.5) * 2.0 / kPieces - 1.0) * lamp.v - point;
    const double d2 = glm::dot(way, way);
    sum += std::max(glm::dot(way, normal), 0.0) * std::max(-glm::dot(way, shines), 0.0) / (d2 * d2);
  }
  return sum * 4.0 * glm::length(cross) / (3.14159265358979 * kPieces * kPieces);
}

Probe probeIn(const dvec3& origin, const Box& box) {
  Probe probe;
  probe.name = "room";
  probe.origin = origin;
  probe.box = box;
  probe.influence = Box{dvec3(kLow) - 0.1, dvec3(kHigh) + 0.1};
  probe.blendDistance = {dvec3(0.0), dvec3(0.0)};
  probe.faceSize = 32;
  return probe;
}

Scene sceneOf(const Probe& probe) {
  Scene scene = darkScene();
  scene.lamps = LampForm::Shapes;
  scene.probes = {probe};
  return scene;
}

struct TracedWorld : QuadWorld {
  TracedWorld(Scene s, const Model& model, bool traced = true) : QuadWorld(std::move(s), {model}) {
    if (traced) renderer->setSightLines(traceSightLines);
  }
  vec3 floorAt(double x, double z) { return look(dvec3(x + 0.02, 0.4, z + 0.01), dvec3(x, 0.0, z), {0.0, 0.0, -1.0}); }
  std::string key() const {
    const auto keys = renderer->bakeKeys("room");
    return keys.empty() ? std::string() : keys.back();
  }
};

const Lamp kWest{{-1.3, 2.62, 0.4}, {0.3, 0, 0}, {0, 0, 0.2}}, kEast{{1.9, 2.62, -0.5}, {0.2, 0, 0}, {0, 0, 0.35}};

// A wall across the room that leaves a door, a lamp on either side, a rough metal panel.
Model twoHalves() {
  Model model = room(vec3(0.6f, 0.5f, 0.4f), vec3(0.7f, 0.6f, 0.3f));
  addSquare(model, "wall", {0.5f, 1.35f, -0.4f}, {0, 0, 1.1f}, {0, 1.35f, 0}, plain(vec3(0.5f)));
  addSquare(model, "panel", {-2.3f, 1.2f, 0.2f}, {0, 0, -0.7f}, {0, 0.6f, 0}, plain(vec3(0.8f), 1.0f, 0.4f));
  addLamp(model, "lamp west", kWest, {30.0f, 24.0f, 17.0f});
  addLamp(model, "lamp east", kEast, {19.0f, 26.0f, 33.0f});
  return model;
}

TEST(CaptureLamps, NoBoxHasAPartInAFirstCapture) {
  const Box whole{dvec3(kLow), dvec3(kHigh)}, west{dvec3(kLow), dvec3(0.5, kHigh.y, kHigh.z)},
      upper{{-1.0, 1.1, -0.9}, {2.2, 2.5, 1.2}};
  for (const bool traced : {true, false}) {
    SCOPED_TRACE(traced ? "shadows traced" : "without shadows");
    const dvec3 origin(-0.7, 1.3, 0.2);
    TracedWorld edited(sceneOf(probeIn(origin, whole)), twoHalves(), traced);
    edited.show();
    const std::string key = edited.key();
    const auto before = edited.renderer->readMaps("room");
    ASSERT_TRUE(before.has_value());
    for (const Box& box : {west, upper}) {
      edited.editAndFinish([&](Scene& s) { s.probes[0].box = box; });
      TracedWorld fresh(edited.scene, twoHalves(), traced);
      fresh.show();
      EXPECT_EQ(edited.key(), key);
      EXPECT_EQ(fresh.key(), key);
      const auto shown = edited.renderer->readMaps("room"), expected = fresh.renderer->readMaps("room");
      ASSERT_TRUE(shown && expected);
      EXPECT_EQ(edited.faces(), 6u) << "a box that is edited captures nothing";
      EXPECT_LE(farthestTexel(*shown, *before), 1e-6);
      EXPECT_LE(farthestTexel(*shown, *expected), 1e-6);
    }
    // From elsewhere it is another one, and its key says so; so does one from which a lamp is hidden.
    TracedWorld other(edited.scene, twoHalves(), traced);
    other.scene.probes[0].hides = {"lamp east"};
    other.show();
    EXPECT_NE(other.key(), key);
    EXPECT_GT(farthestTexel(*other.renderer->readMaps("room"), *before), 0.02);
  }
}

// Behind the wall the other half's lamp gives nothing, to a capture either: as seen beside the door, from the west.
TEST(CaptureLamps, ACaptureHasTheLampsShadows) {
  Model model = twoHalves();
  Scene scene = sceneOf(probeIn({-0.7, 1.3, 0.2}, {dvec3(kLow), dvec3(kHigh)}));
  scene.materials["lamp west"].emissive = vec3(0.0f);
  TracedWorld with(scene, model), without(scene, model, false);
  with.show();
  without.show();
  const auto shadowed = with.renderer->readMaps("room"), all = without.renderer->readMaps("room");
  ASSERT_TRUE(shadowed && all);
  const vec3 floorUnderWest = glm::normalize(vec3(-0.9f, -1.3f, -0.9f)),
             floorAtDoor = glm::normalize(vec3(1.6f, -1.3f, 1.1f));
  const auto seen = [](const BakedMaps& maps, const vec3& way) { return maps.radiance.fetch(way, 0.0f).y; };
  EXPECT_GT(seen(*all, floorUnderWest), 0.02f);
  EXPECT_LT(seen(*shadowed, floorUnderWest), 0.1f * seen(*all, floorUnderWest));
  EXPECT_GT(seen(*shadowed, floorAtDoor), 0.3f * seen(*all, floorAtDoor));
}

// The panel's reflection of the lamps in a later capture is the map's, whichever program draws it.
TEST(CaptureLamps, LaterCapturesShowLampsInReflectionsAsMapsDo) {
  Scene scene = sceneOf(probeIn({-0.7, 1.3, 0.2}, {dvec3(kLow), dvec3(kHigh)}));
  scene.probes[0].bounces = 5;
  TracedWorld tuned(scene, twoHalves()), general(scene, twoHalves());
  general.renderer->useGeneralPrograms(true);
  tuned.show();
  general.show();
  const auto a = tuned.renderer->readMaps("room"), b = general.renderer->readMaps("room");
  ASSERT_TRUE(a && b);
  EXPECT_LE(farthestTexel(*a, *b), 4e-3);
  const vec3 panel = glm::normalize(vec3(-1.6f, 0.5f, 0.1f));
  EXPECT_GT(a->radiance.fetch(panel, 0.0f).x, 0.2f) << "rough metal is not black in a later capture";
}

TEST(CaptureLamps, AProbeWithinALampIsLitByItAllTheSame) {
  const dvec3 middle(0.3, 1.4, -0.2), half(0.2, 0.15, 0.25);
  Model model = room(vec3(0.0f), vec3(0.7f, 0.5f, 0.3f));
  std::vector<Lamp> faces;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, a = (axis + 1) % 3, b = (axis + 2) % 3;
    const double side = face % 2 == 0 ? 1.0 : -1.0;
    Lamp lamp{middle, dvec3(0.0), dvec3(0.0)};
    lamp.middle[axis] += side * half[axis];
    lamp.u[a] = side * half[a];
    lamp.v[b] = half[b];
    faces.push_back(lamp);
    addLamp(model, ("lamp " + std::to_string(face)).c_str(), lamp, {9.0f, 8.0f, 6.0f});
  }
  TracedWorld world(sceneOf(probeIn(middle + dvec3(0.05, 0.02, -0.04), {dvec3(kLow), dvec3(kHigh)})), model);
  world.show();
  for (const dvec3& at : {dvec3(0.3, 0, -0.2), dvec3(1.4, 0, 0.6), dvec3(-1.6, 0, 1.1)}) {
    double truth = 0.0;
    for (const Lamp& lamp : faces) truth += lightOf(lamp, at, {0.0, 1.0, 0.0});
    const vec3 drawn = world.floorAt(at.x, at.z);
    std::printf("  (%.1f, %.1f): truth %.4f, drawn %.4f\n", at.x, at.z, 0.7 * 9.0 * truth, drawn.x);
    EXPECT_NEAR(drawn.x, 0.7 * 9.0 * truth, 0.05 * 0.7 * 9.0 * truth);
    EXPECT_NEAR(drawn.z, 0.3 * 6.0 * truth, 0.05 * 0.3 * 6.0 * truth);
  }
}

// A light source at a lamp's place is counted with it unless it is ten times as strong, which its colour may decide.
TEST(CaptureLamps, ALightsColourMayTakeItOutOfItsLamp) {
  Scene scene = sceneOf(probeIn({-0.7, 1.3, 0.2}, {dvec3(kLow), dvec3(kHigh)}));
  Light light;
  light.type = LightType::Point;
  light.position = kWest.middle - dvec3(0.0, 0.05, 0.0);
  light.color = {0.5f, 0.4f, 0.3f};
  light.intensity = 9.0f;
  scene.lights = {light};
  TracedWorld edited(scene, twoHalves());
  edited.show();
  const std::string key = edited.key();
  const vec3 before = edited.floorAt(-1.2, 0.5);
  for (const float factor : {20.0f, 1.0f}) {
    edited.editAndFinish([&](Scene& s) { s.lights[0].color = factor * light.color; });
    TracedWorld fresh(edited.scene, twoHalves());
    fresh.show();
    EXPECT_EQ(edited.key(), fresh.key());
    const vec3 shown = edited.floorAt(-1.2, 0.5), expected = fresh.floorAt(-1.2, 0.5);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], expected[c], 1e-3f * expected[c]);
    if (factor == 1.0f) continue;
    EXPECT_NE(edited.key(), key);
    EXPECT_GT(shown.x, 1.5f * before.x);
  }
  EXPECT_EQ(edited.key(), key);
}

// A lamp brighter than a map can hold still gives all of its light.
TEST(CaptureLamps, AMillionIsALampLikeAnyOther) {
  const Lamp spark{{-0.4, 2.5, 0.3}, {0.012, 0, 0}, {0, 0, 0.009}};
  Model model = room(vec3(0.0f), vec3(0.7f, 0.5f, 0.3f));
  addLamp(model, "spark", spark, vec3(1.0e6f));
  TracedWorld world(sceneOf(probeIn({0.6, 1.2, -0.3}, {dvec3(kLow), dvec3(kHigh)})), model);
  world.show();
  for (const dvec3& at : {dvec3(-0.4, 0, 0.3), dvec3(1.7, 0, -0.8)}) {
    const double truth = 0.7e6 * lightOf(spark, at, {0.0, 1.0, 0.0});
    EXPECT_NEAR(world.floorAt(at.x, at.z).x, truth, 0.05 * truth);
  }
}

TEST(CaptureLamps, WithoutAnyLightAllIsBlack) {
  TracedWorld world(sceneOf(probeIn({0.6, 1.2, -0.3}, {dvec3(kLow), dvec3(kHigh)})), room(vec3(0.6f), vec3(0.7f)));
  world.show();
  const vec3 floor = world.floorAt(0.4, 0.2);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(floor[c], 0.0f);
  EXPECT_EQ(world.renderer->counters().sightRays, 0u);
}

}  // namespace
}  // namespace boxprobe::test
