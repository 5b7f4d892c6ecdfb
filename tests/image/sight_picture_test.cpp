// Shadows of lamps drawn as shapes, and of light sources beside them, against a sum over points of the lamp with rays
// of this file's own.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "filters/fit/rays/triangle_sight.h"
#include "tests/image/quad_world.h"

namespace boxprobe::test {
namespace {

using glm::dvec3;
using glm::vec3;

const vec3 kLow(-2.1f, 0.0f, -1.7f), kHigh(2.3f, 2.6f, 1.8f);
const vec3 kAlbedo(0.7f, 0.5f, 0.3f), kRadiance(30.0f, 24.0f, 17.0f);
const dvec3 kLampMiddle(-0.5, 2.55, 0.3), kLampU(0.3, 0, 0), kLampV(0, 0, 0.2);
const dvec3 kShelf(-0.2, 0.9, 0.1), kShelfU(0.5, 0, 0), kShelfV(0, 0, 0.4);  // a sheet over the floor

Material plain(const vec3& color) {
  Material material;
  material.baseColor = glm::vec4(color, 1.0f);
  material.metallic = 0.0f;
  material.roughness = 1.0f;
  material.ior = 1.0f;  // reflects nothing of its own
  material.doubleSided = true;
  return material;
}

// Black walls, so that the lamp alone lights the floor.
Model room(bool lamp = true) {
  Model model;
  const vec3 c = 0.5f * (kLow + kHigh), h = 0.5f * (kHigh - kLow);
  addSquare(model, "west", {kLow.x, c.y, c.z}, {0, 0, -h.z}, {0, h.y, 0}, plain(vec3(0.0f)));
  addSquare(model, "east", {kHigh.x, c.y, c.z}, {0, 0, h.z}, {0, h.y, 0}, plain(vec3(0.0f)));
  addSquare(model, "north", {c.x, c.y, kLow.z}, {h.x, 0, 0}, {0, h.y, 0}, plain(vec3(0.0f)));
  addSquare(model, "south", {c.x, c.y, kHigh.z}, {-h.x, 0, 0}, {0, h.y, 0}, plain(vec3(0.0f)));
  addSquare(model, "ceiling", {c.x, kHigh.y, c.z}, {h.x, 0, 0}, {0, 0, h.z}, plain(vec3(0.0f)));
  addSquare(model, "floor", {c.x, kLow.y, c.z}, {h.x, 0, 0}, {0, 0, -h.z}, plain(kAlbedo));
  addSquare(model, "shelf", vec3(kShelf), vec3(kShelfU), vec3(kShelfV), plain(vec3(0.0f)));
  if (!lamp) return model;
  Material shining = glowing(kRadiance);
  shining.doubleSided = false;
  addSquare(model, "lamp", vec3(kLampMiddle), vec3(kLampU), vec3(kLampV), shining);
  return model;
}

Scene scene() {
  Scene scene = darkScene();
  scene.lamps = LampForm::Shapes;
  Probe probe;
  probe.name = "room";
  probe.origin = {1.1, 1.6, -0.3};
  probe.box = {dvec3(kLow), dvec3(kHigh)};
  probe.blendDistance = {dvec3(0.0), dvec3(0.0)};
  probe.faceSize = 64;
  scene.probes = {probe};
  return scene;
}

bool throughShelf(const dvec3& from, const dvec3& to, const dvec3& moved) {
  const dvec3 shelf = kShelf + moved;
  const double t = (shelf.y - from.y) / (to.y - from.y);
  if (t <= 0.0 || t >= 1.0) return false;
  const dvec3 off = from + t * (to - from) - shelf;
  return std::abs(off.x) < kShelfU.x && std::abs(off.z) < kShelfV.z;
}

// What the floor sends up; of all of the lamp, or of what the shelf leaves of it.
dvec3 truth(const dvec3& point, bool shadow, const dvec3& moved = dvec3(0.0)) {
  constexpr int kPieces = 60;
  double sum = 0.0;
  for (int i = 0; i < kPieces * kPieces; ++i) {
    const dvec3 at = kLampMiddle + ((i % kPieces + 0.5) * 2.0 / kPieces - 1.0) * kLampU +
                     ((i / kPieces + 0.5) * 2.0 / kPieces - 1.0) * kLampV;
    if (shadow && throughShelf(point, at, moved)) continue;
    const dvec3 way = at - point;
    const double d2 = glm::dot(way, way);
    sum += way.y * way.y / (d2 * d2);
  }
  const double area = 4.0 * kLampU.x * kLampV.z;
  return dvec3(kAlbedo) * dvec3(kRadiance) * (sum * area / (3.14159265358979 * kPieces * kPieces));
}

dvec3 seen(QuadWorld& world, const dvec3& point) {
  return dvec3(world.look(point + dvec3(0.02, 0.5, 0.01), point, {0.0, 0.0, -1.0}));
}

const dvec3 kPoints[] = {{0.0, 0, 0.0}, {-0.1, 0, 0.1}, {0.3, 0, -0.2}, {0.75, 0, 0.0}, {1.6, 0, -1.0}, {-1.5, 0, 1.2}};

struct SightWorld : QuadWorld {
  explicit SightWorld(Scene s, const Model& model, int width = 32, int height = 32)
      : QuadWorld(std::move(s), {model}, width, height) {
    renderer->setSightLines(traceSightLines);
  }
  std::uint64_t traced() const { return renderer->counters().sightsTraced; }
};

TEST(SightPicture, AShelfShadesTheFloor) {
  QuadWorld without(scene(), {room()});
  without.show();
  SightWorld world(scene(), room());
  world.show();
  EXPECT_EQ(world.traced(), 1u);
  EXPECT_EQ(without.renderer->counters().sightsTraced, 0u);
  double worst = 0.0;
  for (const dvec3& point : kPoints) {
    const dvec3 t = truth(point, true), whole = truth(point, false), drawn = seen(world, point),
                before = seen(without, point);
    std::printf("  (%.2f, %.2f): truth %.3f, drawn %.3f, without shadows %.3f\n", point.x, point.z, t.x, drawn.x,
                before.x);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c], t[c], 0.1 * whole[c]) << point.x << " " << point.z;
    worst = std::max(worst, std::abs(before.x - t.x) / whole.x);
  }
  EXPECT_GT(worst, 0.6);  // what it mends
}

// The underside of the shelf, which no capture sees, lights the floor below it by the colour and the light that it has
// now. Nothing of what is seen is traced again for that.
TEST(SightPicture, ColoursThatNoCaptureSeesAreFollowed) {
  const dvec3 below = kPoints[1];
  const auto edit = [](Scene& s, const vec3& color, const vec3& emissive) {
    s.materials["shelf"].baseColor = color;
    s.materials["shelf"].emissive = emissive;
  };
  SightWorld world(scene(), room());
  world.show();
  dvec3 before = seen(world, below);
  for (const auto& [color, emissive] :
       {std::pair{vec3(0.9f, 0.2f, 0.4f), vec3(0.0f)}, std::pair{vec3(0.9f, 0.2f, 0.4f), vec3(0.3f, 0.7f, 0.2f)},
        std::pair{vec3(0.1f, 0.8f, 0.4f), vec3(0.1f, 0.2f, 0.5f)}}) {
    world.editAndFinish([&, c = color, e = emissive](Scene& s) { edit(s, c, e); });
    Scene changed = scene();
    edit(changed, color, emissive);
    SightWorld fresh(changed, room());
    fresh.show();
    const dvec3 edited = seen(world, below), started = seen(fresh, below);
    std::printf("  before %.4f %.4f %.4f, edited %.4f %.4f %.4f, fresh %.4f %.4f %.4f\n", before.x, before.y, before.z,
                edited.x, edited.y, edited.z, started.x, started.y, started.z);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(edited[c], started[c], 1.0e-3 * started[c]) << c;
    EXPECT_GT(glm::length(started - before), 0.01 * glm::length(before));
    before = edited;
  }
}

// What is moved throws its shadow where it is now; what is marked as moving throws none; a lamp's colour alone is no
// reason to trace again.
TEST(SightPicture, EditsAreFollowed) {
  SightWorld world(scene(), room());
  world.show();
  const dvec3 point = kPoints[0], first = seen(world, point), moved(1.4, 0, -0.9), far = kPoints[4];
  EXPECT_LT(first.x, 0.2 * truth(point, false).x);
  world.editAndFinish([&](Scene& s) { s.objects["shelf"].translation = moved; });
  EXPECT_EQ(world.traced(), 2u);
  EXPECT_NEAR(seen(world, point).x, truth(point, true, moved).x, 0.1 * truth(point, false).x);
  EXPECT_NEAR(seen(world, far).x, truth(far, true, moved).x, 0.1 * truth(far, false).x);
  world.editAndFinish([&](Scene& s) { s.objects["shelf"].dynamic = true; });
  EXPECT_EQ(world.traced(), 3u);
  EXPECT_EQ(world.renderer->counters().lampsSeenWhole, 1u);
  EXPECT_NEAR(seen(world, far).x, truth(far, false).x, 0.03 * truth(far, false).x);
  world.editAndFinish([&](Scene& s) { s.objects.clear(); });
  EXPECT_NEAR(seen(world, point).x, first.x, 1e-3 * truth(point, false).x);
  const std::uint64_t before = world.traced();
  world.editAndFinish([&](Scene& s) { s.materials["lamp"].emissive = 2.0f * kRadiance; });
  EXPECT_EQ(world.traced(), before);
  EXPECT_NEAR(seen(world, kPoints[5]).x, 2.0 * truth(kPoints[5], true).x, 0.05 * truth(kPoints[5], false).x);
  world.editAndFinish([&](Scene& s) { s.lamps = LampForm::InMap; });
  EXPECT_EQ(world.traced(), before);
}

// A point light, without a lamp: under the shelf it is dark, and beside it the light is the light's own.
TEST(SightPicture, ALightSourceIsShadowedToo) {
  Scene lit = scene();
  Light light;
  light.type = LightType::Point;
  light.position = {-0.1, 2.1, 0.2};
  light.intensity = 5.0f;
  lit.lights = {light};
  SightWorld world(lit, room(false));
  QuadWorld without(lit, {room(false)});
  world.show();
  without.show();
  EXPECT_EQ(world.traced(), 1u);
  const dvec3 under(-0.2, 0, 0.1), beside(1.5, 0, -1.0);
  EXPECT_GT(seen(without, under).x, 0.1);
  EXPECT_LT(seen(world, under).x, 0.01 * seen(without, under).x);
  EXPECT_NEAR(seen(world, beside).x, seen(without, beside).x, 0.01 * seen(without, beside).x);
}

TEST(SightPicture, AnExplanationHasTheSameLight) {
  Scene lit = scene();
  Light light;
  light.type = LightType::Spot;
  light.position = {1.3, 2.2, 1.1};
  light.direction = {-0.6, -1.0, -0.5};
  light.intensity = 7.0f;
  light.outerConeDegrees = 60.0;
  lit.lights = {light};
  SightWorld world(lit, room(), 64, 48);
  world.show();
  Camera camera;
  camera.position = {1.4, 1.9, 1.3};
  camera.target = {-0.2, 0.0, -0.1};
  world.renderer->applyCamera(camera);
  int floors = 0, dim = 0;
  std::vector<glm::ivec2> pixels;
  for (int i = 0; i < 60; ++i) pixels.emplace_back((i * 17) % 64, (i * 11) % 48);
  for (const Explanation& e : world.renderer->explain(pixels, 64, 48)) {
    if (e.surface.object != "floor") continue;
    ++floors;
    ASSERT_TRUE(e.rendered.has_value());
    EXPECT_LT(glm::length(e.color - *e.rendered), 2.0e-3f * (1.0f + glm::length(*e.rendered))) << e.x << " " << e.y;
    const double whole = truth(e.surface.positionWorld, false).x;
    dim += static_cast<double>(e.diffuse.x) < 0.7 * whole ? 1 : 0;
  }
  EXPECT_GE(floors, 15);
  EXPECT_GE(dim, 2);
}

}  // namespace
}  // namespace boxprobe::test
