// Shadows of suns, on by themselves: against rays of this file's own, in pictures, captures and explanations; where
// none shows there is no map.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "filters/fit/rays/triangle_sight.h"
#include "filters/vtk/frame/sun_shadows.h"
#include "tests/image/quad_world.h"

namespace boxprobe::test {
namespace {

using glm::dvec3;
using glm::vec3;

const vec3 kAlbedo(0.7f, 0.5f, 0.3f);
const dvec3 kFloorHalf(3.1, 0.0, 2.6), kShelf(0.4, 0.9, -0.2), kShelfHalf(0.6, 0.0, 0.35), kSun(0.5, -1.0, 0.2);
constexpr float kIrradiance = 4.0f;

Material plain(const vec3& color) {
  Material material;
  material.baseColor = glm::vec4(color, 1.0f);
  material.metallic = 0.0f;
  material.roughness = 1.0f;
  material.ior = 1.0f;  // reflects nothing of its own
  material.doubleSided = true;
  return material;
}

// A floor under a black sheet, and nothing else.
Model yard(bool shelf = true) {
  Model model;
  addSquare(model, "floor", vec3(0.3f, 0.0f, -0.1f), {static_cast<float>(kFloorHalf.x), 0, 0},
            {0, 0, -static_cast<float>(kFloorHalf.z)}, plain(kAlbedo));
  if (shelf) {
    addSquare(model, "shelf", vec3(kShelf), {static_cast<float>(kShelfHalf.x), 0, 0},
              {0, 0, static_cast<float>(kShelfHalf.z)}, plain(vec3(0.0f)));
  }
  return model;
}

Scene sunny() {
  Scene scene = darkScene();
  scene.lamps = LampForm::Shapes;
  Light sun;
  sun.type = LightType::Directional;
  sun.direction = kSun;
  sun.color = {1.0f, 0.9f, 0.7f};
  sun.intensity = kIrradiance;
  scene.lights = {sun};
  Probe probe;
  probe.name = "yard";
  probe.origin = {-1.3, 1.4, 0.9};
  probe.box = {{-2.9, 0.0, -2.8}, {3.5, 2.7, 2.6}};
  probe.blendDistance = {dvec3(0.0), dvec3(0.0)};
  probe.faceSize = 64;
  scene.probes = {probe};
  return scene;
}

// How far from the shadow's edge a point of the floor is: below 0 within the shadow, across the nearer edge.
double outside(const dvec3& point, const dvec3& moved = dvec3(0.0)) {
  const dvec3 at = point - kSun * ((kShelf.y + moved.y - point.y) / -kSun.y) - (kShelf + moved);
  return std::max(std::abs(at.x) - kShelfHalf.x, std::abs(at.z) - kShelfHalf.z);
}

dvec3 sunlit() {
  const double cosine = -kSun.y / glm::length(kSun);
  return dvec3(kAlbedo) * dvec3(1.0, 0.9, 0.7) * (static_cast<double>(kIrradiance) * cosine / 3.14159265358979);
}

struct SunWorld : QuadWorld {
  explicit SunWorld(Scene s, const Model& model = yard(), bool traced = true)
      : QuadWorld(std::move(s), {model}, 64, 48) {
    if (traced) renderer->setSightLines(traceSightLines);
  }
  double seen(const dvec3& point) { return static_cast<double>(look(point + dvec3(-0.3, 0.45, 0.1), point).x); }
  std::uint64_t maps() const { return renderer->counters().shadowMapsDrawn; }
};

// A walk over the floor: dark within, lit without, and no steps but at the edge.
void walk(SunWorld& world, const dvec3& moved, int* dark, int* lit) {
  for (int i = 0; i < 60; ++i) {
    const dvec3 point(-0.9 + 0.047 * i, 0.0, -0.55 + 0.013 * i);
    const double edge = outside(point, moved), whole = sunlit().x, drawn = world.seen(point);
    if (edge < -0.02) {
      EXPECT_LT(drawn, 0.02 * whole) << point.x << " " << point.z;
      ++*dark;
    } else if (edge > 0.02) {
      EXPECT_NEAR(drawn, whole, 0.02 * whole) << point.x << " " << point.z;
      ++*lit;
    } else {
      EXPECT_LT(drawn, 1.02 * whole);
    }
  }
}

TEST(SunShadow, FallsWhereTheSunsRaysAreCutOff) {
  SunWorld world(sunny());
  world.show();
  EXPECT_EQ(world.maps(), 1u);
  int dark = 0, lit = 0;
  walk(world, dvec3(0.0), &dark, &lit);
  EXPECT_GE(dark, 10);
  EXPECT_GE(lit, 10);
  EXPECT_EQ(world.maps(), 1u) << "drawn again although nothing moved";
}

// The yard in a wide field, with a sheet over the grass: the floor's shadow is as sharp as without a field.
TEST(SunShadow, IsFineInAWideField) {
  const dvec3 sheet(9.3, 2.1, -6.2);
  constexpr double kField = -0.7;
  Model model = yard();
  addSquare(model, "field", vec3(13.0f, static_cast<float>(kField), -9.0f), {71, 0, 0}, {0, 0, -83}, plain(kAlbedo));
  addSquare(model, "sheet", vec3(sheet), {1.1f, 0, 0}, {0, 0, 0.8f}, plain(vec3(0.0f)));
  SunWorld world(sunny(), model);
  world.show();
  EXPECT_EQ(world.maps(), 2u);
  int dark = 0, lit = 0;
  walk(world, dvec3(0.0), &dark, &lit);
  EXPECT_GE(dark, 10);
  EXPECT_GE(lit, 10);
  const dvec3 under = sheet + kSun * (sheet.y - kField);
  EXPECT_LT(world.seen(under), 0.02 * sunlit().x);
  EXPECT_NEAR(world.seen(under + dvec3(2.3, 0.0, 0.4)), sunlit().x, 0.02 * sunlit().x);
  // They follow from no probe: an edit of one leaves every capture's shadows as they are.
  world.editAndFinish([](Scene& s) {
    s.probes[0].box = {{20.1, 0.0, -2.8}, {24.0, 2.7, 2.6}};
    s.probes[0].origin = {22.0, 1.4, 0.2};
  });
  EXPECT_EQ(world.maps(), 2u);
  EXPECT_LT(world.seen(kShelf + kSun * kShelf.y), 0.02 * sunlit().x);
}

TEST(SunShadow, FollowsEdits) {
  SunWorld world(sunny());
  world.show();
  const dvec3 moved(-0.3, 0.35, 0.15);
  world.editAndFinish([&](Scene& s) { s.objects["shelf"].translation = moved; });
  EXPECT_EQ(world.maps(), 2u);
  int dark = 0, lit = 0;
  walk(world, moved, &dark, &lit);
  EXPECT_GE(dark, 5);
  EXPECT_GE(lit, 10);
  const dvec3 under = kShelf + kSun * kShelf.y;
  world.editAndFinish([&](Scene& s) { s.objects.clear(); });
  const std::uint64_t before = world.maps();
  EXPECT_LT(world.seen(under), 0.02 * sunlit().x);
  world.editAndFinish([](Scene& s) { s.materials["floor"].roughness = 0.9f; });
  EXPECT_EQ(world.maps(), before) << "a material throws no shadow";
  // What moves has a map of its own, which no capture shows.
  world.editAndFinish([](Scene& s) { s.objects["shelf"].dynamic = true; });
  EXPECT_LT(world.seen(under), 0.02 * sunlit().x);
  world.editAndFinish([](Scene& s) {
    s.objects.clear();
    s.lamps = LampForm::InMap;
  });
  EXPECT_NEAR(world.seen(under), sunlit().x, 0.02 * sunlit().x) << "without shapes lights shine through everything";
}

// A first capture has the shadow: the probe has no light but what it captured.
TEST(SunShadow, IsInFirstCaptures) {
  Scene scene = sunny();
  scene.probes[0].bounces = 1;
  SunWorld world(scene), through(scene, yard(), false);
  world.show();
  through.show();
  // Texels that show the floor's light: those in the shadow are dark.
  const auto lit = [](SunWorld& w) {
    const auto maps = w.renderer->readMaps("yard");
    const CubeMap& cube = maps->radiance;
    int count = 0;
    for (int face = 0; face < 6; ++face) {
      for (int i = 0; i < cube.faceSize() * cube.faceSize(); ++i) {
        count += static_cast<double>(cube.face(0, face)[4 * i]) > 0.5 * sunlit().x ? 1 : 0;
      }
    }
    return count;
  };
  const int with = lit(world), without = lit(through);
  std::printf("  lit texels: %d, without shadows %d\n", with, without);
  EXPECT_LT(with, without - 50);
  EXPECT_GT(with, without / 2);
}

TEST(SunShadow, NoneWhereNoneShows) {
  SunWorld world(sunny(), yard(false));
  world.show();
  EXPECT_NEAR(world.seen({0.5, 0.0, 0.3}), sunlit().x, 0.02 * sunlit().x);
  EXPECT_EQ(world.maps(), 0u);
  SunWorld night(sunny());
  night.scene.lights[0].intensity = 0.0f;
  night.show();
  EXPECT_EQ(night.maps(), 0u);
  SunWorld own(sunny());
  own.scene.lights[0].shadows = LightShadows::Coverage;
  own.show();
  EXPECT_EQ(own.maps(), 0u);
}

TEST(SunShadow, ReceiversAreThoseBehindSomething) {
  const Box wall{{-1.0, 0.0, 4.0}, {1.5, 2.0, 4.2}}, behind{{0.5, 0.5, 7.0}, {1.0, 1.0, 8.0}},
      beside{{3.0, 0.5, 7.0}, {4.0, 1.0, 8.0}}, before{{0.0, 0.5, 1.0}, {1.0, 1.0, 1.0}};
  const auto view = sunView({0.0, 0.0, 3.0}, {wall});
  ASSERT_TRUE(view.has_value());
  EXPECT_EQ(sunReceivers(*view, {wall, behind, beside, before}, {wall}), (std::vector<bool>{true, true, false, false}));
  EXPECT_EQ(sunReceivers(*view, {before}, {before}), std::vector<bool>{false}) << "flat";
  const Box floor{{-3.0, 0.2, -2.0}, {4.0, 0.2, 5.0}}, on{{0.5, 0.2, 1.0}, {1.0, 0.9, 1.5}},
      through{{-1.0, -0.3, 1.0}, {-0.5, 0.9, 1.5}};
  const auto slanting = sunView({0.4, -1.0, 0.3}, {floor});
  ASSERT_TRUE(slanting.has_value());
  EXPECT_EQ(sunReceivers(*slanting, {on, through}, {floor}, false), (std::vector<bool>{false, true}));
  EXPECT_EQ(sunReceivers(*slanting, {on, through}, {floor}), (std::vector<bool>{true, true}));
  EXPECT_FALSE(sunView({0.0, 0.0, 0.0}, {wall}).has_value());
  EXPECT_FALSE(sunView({0.0, 0.0, 1.0}, {}).has_value());
}

// With one map and with two.
class ExplainedSunShadow : public ::testing::TestWithParam<bool> {};
TEST_P(ExplainedSunShadow, IsThePictures) {
  Model model = yard();
  if (GetParam()) addSquare(model, "field", {13.0f, -0.7f, -9.0f}, {71, 0, 0}, {0, 0, -83}, plain(kAlbedo));
  SunWorld world(sunny(), model);
  world.show();
  EXPECT_EQ(world.maps(), GetParam() ? 2u : 1u);
  Camera camera;
  camera.position = {-0.9, 1.7, 1.6};
  camera.target = {0.8, 0.0, -0.1};
  world.renderer->applyCamera(camera);
  std::vector<glm::ivec2> pixels;
  for (int i = 0; i < 80; ++i) pixels.emplace_back((i * 17) % 64, (i * 11) % 48);
  int dark = 0, lit = 0;
  for (const Explanation& e : world.renderer->explain(pixels, 64, 48)) {
    if (e.surface.object != "floor") continue;
    ASSERT_TRUE(e.rendered.has_value());
    EXPECT_LT(glm::length(e.color - *e.rendered), 2.0e-3f * (1.0f + glm::length(*e.rendered))) << e.x << " " << e.y;
    (static_cast<double>(e.direct.x) < 0.1 * sunlit().x ? dark : lit) += 1;
  }
  EXPECT_GE(dark, 3);
  EXPECT_GE(lit, 10);
}
INSTANTIATE_TEST_SUITE_P(Fields, ExplainedSunShadow, ::testing::Bool());

}  // namespace
}  // namespace boxprobe::test
