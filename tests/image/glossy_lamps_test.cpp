// What rough surfaces reflect of lamps drawn as shapes (`"lamps": "shapes"`), against quadrature over the lamp: long
// double, of tests/support/lamp_truth. There is nothing else to see, so that all light is the lamps'.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "tests/image/quad_world.h"
#include "tests/support/lamp_truth.h"

namespace boxprobe::test {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::vec3;

struct Panel {
  const char* name;
  vec3 center, right, up;  // half sides; shines along cross(right, up)
  vec3 radiance;
};

const Panel kCeiling = {"ceiling lamp", {-0.6f, 2.6f, 0.4f}, {0.35f, 0, 0}, {0, 0, 0.22f}, {30.0f, 24.0f, 17.0f}};
const Panel kWall = {"wall lamp", {2.3f, 1.1f, -0.5f}, {0, 0, 0.3f}, {0, 0.45f, 0}, {3.0f, 9.0f, 14.0f}};

std::vector<dvec3> corners(const Panel& p) {
  return {dvec3(p.center - p.right - p.up), dvec3(p.center + p.right - p.up), dvec3(p.center + p.right + p.up),
          dvec3(p.center - p.right + p.up)};
}

Model model(const Material& floor) {
  Model model;
  for (const Panel& p : {kCeiling, kWall}) {
    Material material = glowing(p.radiance);
    material.doubleSided = false;
    addSquare(model, p.name, p.center, p.right, p.up, material);
  }
  addSquare(model, "floor", {0.2f, 0.0f, 0.15f}, {2.2f, 0, 0}, {0, 0, -1.75f}, floor);
  return model;
}

Material floorOf(float metallic, float roughness) {
  Material floor;
  floor.baseColor = metallic > 0.0f ? glm::vec4(0.9f, 0.7f, 0.5f, 1.0f) : glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  floor.metallic = metallic;
  floor.roughness = roughness;
  return floor;
}

Scene scene(LampForm form, const char* technique = "footprint8") {
  Scene scene = darkScene();
  scene.lamps = form;
  Probe probe;
  probe.name = "room";
  probe.origin = {0.5, 1.1, -0.3};
  probe.box = {{-2.0, 0.0, -1.6}, {2.4, 2.7, 1.9}};
  probe.blendDistance = {dvec3(0.0), dvec3(0.0)};
  probe.faceSize = 128;
  probe.technique = technique;
  scene.probes = {probe};
  return scene;
}

/// What the floor sends from `point` to `eye` by lamps alone.
dvec3 truth(const dvec3& point, const dvec3& eye, const dvec3& f0, double roughness) {
  dvec3 sum(0.0);
  for (const Panel& p : {kCeiling, kWall}) {
    LampCase lamp;
    for (const dvec3& corner : corners(p)) lamp.corners.emplace_back(corner - point);
    lamp.normal = {0.0L, 1.0L, 0.0L};
    lamp.view = LongVec(glm::normalize(eye - point));
    const dvec2 share = trueGlossy(lamp, roughness);
    sum += dvec3(p.radiance) * (f0 * share.x + dvec3(share.y));
  }
  return sum;
}

const dvec3 kPoints[] = {{-0.5, 0, 0.3}, {0.4, 0, -0.6}, {1.7, 0, 1.1},
                         {1.9, 0, -1.2}, {-1.5, 0, 1.4}, {-1.1, 0, -0.9}};
const double kTurns[] = {20.0, 140.0, 290.0};

dvec3 eyeOver(const dvec3& point, double elevation, double turn) {
  const double e = glm::radians(elevation), t = glm::radians(turn);
  return point + 1.3 * dvec3(std::cos(e) * std::cos(t), std::sin(e), std::cos(e) * std::sin(t));
}

struct Judged {
  double off = 0.0, whole = 0.0, light = 0.0, all = 0.0;
  void add(const dvec3& drawn, const dvec3& t) {
    off += glm::dot(drawn - t, drawn - t);
    whole += glm::dot(t, t);
    light += drawn.x + drawn.y + drawn.z;
    all += t.x + t.y + t.z;
  }
  double error() const { return std::sqrt(off / whole); }  ///< rms over rms of the light
  double ratio() const { return light / all; }
};

TEST(GlossyLamps, AFloorReflectsThemAsQuadratureDoes) {
  for (const bool metal : {true, false}) {
    const dvec3 f0 = metal ? dvec3(floorOf(1.0f, 0.0f).baseColor) : dvec3(0.04);
    double worstBefore = 0.0;
    for (const float roughness : {0.25f, 0.5f, 1.0f}) {
      const Model floor = model(floorOf(metal ? 1.0f : 0.0f, roughness));
      QuadWorld before(scene(LampForm::InMap), {floor}), world(scene(LampForm::Shapes), {floor});
      before.show();
      world.show();
      for (const double elevation : {8.0, 14.0, 30.0}) {
        Judged was, is;
        for (const dvec3& point : kPoints) {
          for (const double turn : kTurns) {
            const dvec3 eye = eyeOver(point, elevation, turn);
            const dvec3 t = truth(point, eye, f0, static_cast<double>(roughness));
            was.add(dvec3(before.look(eye, point)), t);
            is.add(dvec3(world.look(eye, point)), t);
          }
        }
        std::printf("  %s, roughness %.2f, %2.0f degrees: error %.3f, light %.3f; lamps in the map %.3f, %.3f\n",
                    metal ? "metal" : "dielectric", static_cast<double>(roughness), elevation, is.error(), is.ratio(),
                    was.error(), was.ratio());
        EXPECT_LT(is.error(), metal ? 0.05 : 0.08) << roughness << " " << elevation;
        EXPECT_NEAR(is.ratio(), 1.0, 0.04) << roughness << " " << elevation;
        worstBefore = std::max(worstBefore, was.error());
      }
    }
    EXPECT_GT(worstBefore, 0.25);  // what it mends
  }
}

// Below a roughness of 0.1 the map shows lamps, from 0.2 on their shapes do. Neither end of that has a step.
TEST(GlossyLamps, TheMapGivesWayToTheShapesWithoutAStep) {
  QuadWorld world(scene(LampForm::Shapes), {model(floorOf(1.0f, 0.05f))}),
      map(scene(LampForm::InMap), {model(floorOf(1.0f, 0.05f))});
  world.show();
  map.show();
  const dvec3 point = kPoints[0], eye = eyeOver(point, 30.0, 165.0);
  const auto at = [&](QuadWorld& w, float roughness) {
    w.editAndFinish([&](Scene& s) { s.materials["floor"].roughness = roughness; });
    return w.look(eye, point).x;
  };
  EXPECT_EQ(at(world, 0.06f), at(map, 0.06f));
  EXPECT_EQ(at(world, 0.1f), at(map, 0.1f));
  EXPECT_GT(std::abs(at(world, 0.3f) / at(map, 0.3f) - 1.0f), 0.02f);
  // Each of the two lamps is of another colour, which alpha does not hold.
  for (const auto& [edge, most] : {std::pair{0.1f, 0.03f}, std::pair{0.2f, 0.02f}}) {
    const float below = at(world, edge - 0.0005f), above = at(world, edge + 0.0005f);
    std::printf("  at %.1f: %.4f, %.4f\n", static_cast<double>(edge), static_cast<double>(below),
                static_cast<double>(above));
    EXPECT_NEAR(above / below, 1.0f, most) << edge;
  }
}

Material coated() {
  Material floor = floorOf(0.0f, 0.45f);
  floor.baseColor = {0.4f, 0.3f, 0.6f, 1.0f};
  floor.coat = 0.7f;
  floor.coatRoughness = 0.3f;
  return floor;
}

void expectTheSame(const Material& floor, const char* technique, Energy energy) {
  Scene s = scene(LampForm::Shapes, technique);
  s.energy = energy;
  QuadWorld world(s, {model(floor)}, 64, 48);
  world.show();
  Camera camera;
  camera.position = {1.6, 0.5, 1.4};
  camera.target = {-0.4, 0.0, -0.2};
  world.renderer->applyCamera(camera);
  int floors = 0;
  for (const glm::ivec2& pixel : {glm::ivec2(20, 30), glm::ivec2(33, 41), glm::ivec2(50, 37), glm::ivec2(8, 44)}) {
    const Explanation e = world.renderer->explain(pixel.x, pixel.y, 64, 48);
    if (e.surface.object != "floor") continue;
    ++floors;
    ASSERT_TRUE(e.rendered.has_value());
    EXPECT_GT(glm::length(*e.rendered), 0.0f);
    EXPECT_LT(glm::length(e.color - *e.rendered), 3.0e-3f * (1.0f + glm::length(*e.rendered)))
        << technique << " " << floor.roughness << " " << pixel.x;
  }
  EXPECT_GE(floors, 3);
}

TEST(GlossyLamps, AnExplanationHasTheSameLight) {
  expectTheSame(floorOf(1.0f, 0.15f), "footprint8", Energy::Single);
  expectTheSame(floorOf(1.0f, 0.6f), "raytraced", Energy::Multiple);
  expectTheSame(floorOf(0.0f, 0.35f), "box", Energy::Single);
  expectTheSame(coated(), "box", Energy::Single);
  expectTheSame(coated(), "footprint8", Energy::Multiple);
}

}  // namespace
}  // namespace boxprobe::test
