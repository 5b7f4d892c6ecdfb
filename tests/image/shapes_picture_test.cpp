// Diffuse light drawn from lamps as shapes and a lattice (`"lamps": "shapes"`), against quadrature over the walls and
// the lamp of a room: long double, of tests/support/lamp_truth.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "tests/image/quad_world.h"
#include "tests/support/lamp_truth.h"

namespace boxprobe::test {
namespace {

using glm::dvec3;
using glm::vec3;

const vec3 kLow(-2.0f, 0.0f, -1.6f), kHigh(2.4f, 2.7f, 1.9f);
const vec3 kAlbedo(0.7f, 0.5f, 0.3f);

struct Panel {
  const char* name;
  vec3 center, right, up;  // half sides; faces along cross(right, up)
  vec3 radiance;
};

// Dim walls, and a lamp that hangs 5 cm below the ceiling and shines down.
std::vector<Panel> panels() {
  const vec3 c = 0.5f * (kLow + kHigh), h = 0.5f * (kHigh - kLow);
  return {{"west", {kLow.x, c.y, c.z}, {0, 0, -h.z}, {0, h.y, 0}, {0.30f, 0.10f, 0.05f}},
          {"east", {kHigh.x, c.y, c.z}, {0, 0, h.z}, {0, h.y, 0}, {0.05f, 0.22f, 0.08f}},
          {"north", {c.x, c.y, kLow.z}, {h.x, 0, 0}, {0, h.y, 0}, {0.12f, 0.14f, 0.31f}},
          {"south", {c.x, c.y, kHigh.z}, {-h.x, 0, 0}, {0, h.y, 0}, {0.21f, 0.18f, 0.02f}},
          {"ceiling", {c.x, kHigh.y, c.z}, {h.x, 0, 0}, {0, 0, h.z}, {0.09f, 0.07f, 0.11f}},
          {"lamp", {-0.6f, kHigh.y - 0.05f, 0.4f}, {0.35f, 0, 0}, {0, 0, 0.22f}, {30.0f, 24.0f, 17.0f}}};
}

Model room() {
  Model model;
  for (const Panel& p : panels()) {
    Material material = glowing(p.radiance);
    material.doubleSided = false;
    addSquare(model, p.name, p.center, p.right, p.up, material);
  }
  Material floor;
  floor.baseColor = glm::vec4(kAlbedo, 1.0f);
  floor.metallic = 0.0f;
  floor.roughness = 1.0f;
  floor.ior = 1.0f;  // reflects nothing of its own
  const vec3 c = 0.5f * (kLow + kHigh), h = 0.5f * (kHigh - kLow);
  addSquare(model, "floor", {c.x, kLow.y, c.z}, {h.x, 0, 0}, {0, 0, -h.z}, floor);
  return model;
}

Scene scene(LampForm form) {
  Scene scene = darkScene();
  scene.lamps = form;
  Probe probe;
  probe.name = "room";
  probe.origin = {0.5, 1.1, -0.3};
  probe.box = {dvec3(kLow), dvec3(kHigh)};
  probe.blendDistance = {dvec3(0.0), dvec3(0.0)};
  probe.faceSize = 128;
  scene.probes = {probe};
  return scene;
}

// Light that a Lambert floor sends up from a point; the lamp hides its part of the ceiling.
dvec3 truth(const dvec3& point, const dvec3& lampMoved = dvec3(0.0)) {
  dvec3 sum(0.0), ceiling(0.0);
  for (const Panel& p : panels()) {
    const bool lamp = std::string(p.name) == "lamp";
    std::vector<LongVec> corners;
    for (const vec3& corner :
         {p.center - p.right - p.up, p.center + p.right - p.up, p.center + p.right + p.up, p.center - p.right + p.up}) {
      corners.emplace_back(dvec3(corner) + (lamp ? lampMoved : dvec3(0.0)) - point);
    }
    const auto share = static_cast<double>(trueFormFactor(corners, LongVec(0.0L, 1.0L, 0.0L)));
    if (std::string(p.name) == "ceiling") ceiling = dvec3(p.radiance);
    sum += share * (dvec3(p.radiance) - (lamp ? ceiling : dvec3(0.0)));
  }
  return dvec3(kAlbedo) * sum;
}

const dvec3 kPoints[] = {{-0.5, 0, 0.3}, {0.4, 0, -0.6}, {1.7, 0, 1.1},
                         {2.2, 0, -1.4}, {-1.8, 0, 1.7}, {-1.1, 0, -0.9}};

dvec3 seen(QuadWorld& world, const dvec3& point) {
  return dvec3(world.look(point + dvec3(0.02, 1.2, 0.01), point, {0.0, 0.0, -1.0}));
}

TEST(ShapesPicture, AFloorIsLitAsItsWallsAndItsLampLightIt) {
  QuadWorld before(scene(LampForm::InMap), {room()}), world(scene(LampForm::Shapes), {room()});
  before.show();
  world.show();
  double worst = 0.0;
  for (const dvec3& point : kPoints) {
    const dvec3 t = truth(point), drawn = seen(world, point), inMap = seen(before, point);
    std::printf("  (%.1f, %.1f): truth %.3f %.3f %.3f, shapes %.3f %.3f %.3f, in-map %.3f %.3f %.3f\n", point.x,
                point.z, t.x, t.y, t.z, drawn.x, drawn.y, drawn.z, inMap.x, inMap.y, inMap.z);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / t[c], 1.0, 0.03) << point.x << " " << point.z;
    worst = std::max(worst, std::abs(inMap.x / t.x - 1.0));
  }
  EXPECT_GT(worst, 0.4);  // what it mends
}

TEST(ShapesPicture, AnExplanationHasTheSameLight) {
  QuadWorld world(scene(LampForm::Shapes), {room()}, 64, 48);
  world.show();
  Camera camera;
  camera.position = {1.2, 1.5, 1.4};
  camera.target = {-0.4, 0.0, -0.2};
  world.renderer->applyCamera(camera);
  int floors = 0;
  for (const glm::ivec2& pixel : {glm::ivec2(20, 10), glm::ivec2(33, 21), glm::ivec2(50, 7), glm::ivec2(8, 18)}) {
    const Explanation e = world.renderer->explain(pixel.x, pixel.y, 64, 48);
    if (e.surface.object != "floor") continue;
    ++floors;
    ASSERT_TRUE(e.rendered.has_value());
    EXPECT_LT(glm::length(e.color - *e.rendered), 2.0e-3f * (1.0f + glm::length(*e.rendered))) << pixel.x;
  }
  EXPECT_GE(floors, 2);
}

// A moved lamp, a box that is dragged, and back again: the picture follows.
TEST(ShapesPicture, EditsAreFollowed) {
  QuadWorld world(scene(LampForm::Shapes), {room()});
  world.show();
  const dvec3 point = kPoints[1], first = seen(world, point), moved(0.9, -0.4, -0.5);
  world.editAndFinish([&](Scene& s) { s.objects["lamp"].translation = moved; });
  const dvec3 t = truth(point, moved), drawn = seen(world, point);
  EXPECT_GT(drawn.x, 1.2 * first.x);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / t[c], 1.0, 0.03);
  world.editAndFinish([&](Scene& s) {
    s.objects.clear();
    s.materials["lamp"].emissive = vec3(0.0f);
  });
  const dvec3 dark = seen(world, point);
  EXPECT_LT(dark.x, 0.5 * first.x);
  world.editAndFinish([&](Scene& s) { s.materials.clear(); });
  EXPECT_NEAR(seen(world, point).x, first.x, 1e-4 * first.x);
  world.editAndFinish([&](Scene& s) { s.probes[0].box.max.x += 3.0; });  // walls are farther away, and darker the light
  EXPECT_NE(seen(world, point).x, first.x);
  world.editAndFinish([&](Scene& s) { s.probes[0].box.max.x -= 3.0; });
  EXPECT_NEAR(seen(world, point).x, first.x, 1e-4 * first.x);
  const std::uint64_t faces = world.faces();
  world.editAndFinish([&](Scene& s) { s.lamps = LampForm::InMap; });
  EXPECT_EQ(world.faces(), faces + 6);  // the floor in it is lit otherwise
  EXPECT_GT(std::abs(seen(world, point).x / first.x - 1.0), 0.1);
}

// The same box, turned a quarter with its sides exchanged, and captured along its own axes.
TEST(ShapesPicture, ATurnedBoxGivesTheSameLight) {
  QuadWorld world(scene(LampForm::Shapes), {room()});
  Probe& probe = world.scene.probes[0];
  const dvec3 center = probe.box.center(), half = 0.5 * probe.box.size();
  probe.rotationDegrees = {0, 90, 0};
  probe.box = {center - dvec3(half.z, half.y, half.x), center + dvec3(half.z, half.y, half.x)};
  world.show();
  for (const dvec3& point : kPoints) {
    const dvec3 t = truth(point), drawn = seen(world, point);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / t[c], 1.0, 0.03) << point.x << " " << point.z;
  }
}

}  // namespace
}  // namespace boxprobe::test
