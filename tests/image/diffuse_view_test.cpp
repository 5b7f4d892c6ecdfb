// The debug views of diffuse light: the light itself against the picture of a matte room, its error against what is
// given as truth and against paths, and which nodes of the lattice have light of their own, against nodes and weights
// worked out here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "filters/core/scene/surface_view.h"
#include "filters/explain/surface_value.h"
#include "filters/fit/rays/triangle_sight.h"
#include "filters/reference/path/reference_path.h"
#include "tests/image/quad_world.h"
#include "tests/support/scene_picture.h"

namespace boxprobe::test {
namespace diffuse_view {  // compiled together with other rooms
namespace {

using glm::dvec3;
using glm::vec3;

constexpr int kWidth = 64, kHeight = 48;
const vec3 kLow(-2.2f, 0.1f, -1.9f), kHigh(2.1f, 2.7f, 1.5f);
const vec3 kAlbedo(0.7f, 0.5f, 0.3f), kRadiance(21.0f, 18.0f, 14.0f);
const vec3 kBlockLow(0.4f, 0.1f, -1.5f), kBlockHigh(1.6f, 1.3f, -0.1f);  // holds two nodes

Material matte(const vec3& color) {
  Material material;
  material.baseColor = glm::vec4(color, 1.0f);
  material.metallic = 0.0f;
  material.roughness = 1.0f;
  material.ior = 1.0f;  // reflects nothing of its own
  return material;
}

Model room() {
  Model model;
  addBox(model, "wall", kLow, kHigh, false, matte(kAlbedo));
  addBox(model, "block", kBlockLow, kBlockHigh, true, matte(vec3(0.25f, 0.4f, 0.6f)));
  Material lamp = glowing(kRadiance);
  lamp.doubleSided = false;
  addSquare(model, "lamp", {-0.7f, 2.65f, 0.3f}, {0.3f, 0, 0}, {0, 0, 0.2f}, lamp);
  return model;
}

Scene scene() {
  Scene scene = darkScene();
  scene.lamps = LampForm::Shapes;
  Probe probe;
  probe.name = "room";
  probe.origin = {-0.9, 1.5, 0.4};
  probe.box = {dvec3(kLow), dvec3(kHigh)};
  probe.blendDistance = {dvec3(0.0), dvec3(0.0)};
  probe.faceSize = 64;
  scene.probes = {probe};
  return scene;
}

// Nodes about a metre apart, 0.15 from the walls: the weight of those outside of the block around a point.
double ownLight(const dvec3& point) {
  const dvec3 low = dvec3(kLow) + 0.15, high = dvec3(kHigh) - 0.15;
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    dvec3 node(0.0);
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double size = static_cast<double>(kHigh[axis] - kLow[axis]);
      const double last = std::round(size);
      const double place = std::clamp((point[axis] - low[axis]) / (high[axis] - low[axis]) * last, 0.0, last);
      const double first = std::min(std::floor(place), last - 1.0), share = place - first;
      const bool further = (corner >> axis & 1) != 0;
      weight *= further ? share : 1.0 - share;
      node[axis] = low[axis] + (first + (further ? 1.0 : 0.0)) * (high[axis] - low[axis]) / last;
    }
    bool within = true;
    for (int axis = 0; axis < 3; ++axis)
      within = within && node[axis] > static_cast<double>(kBlockLow[axis]) &&
               node[axis] < static_cast<double>(kBlockHigh[axis]);
    if (!within) sum += weight;
  }
  return sum;
}

struct DiffuseView : testing::Test {
  DiffuseView() : world(scene(), {room()}, kWidth, kHeight) {
    world.renderer->setSightLines(traceSightLines);
    world.show();
    Camera camera;
    camera.position = {-1.7, 2.1, 1.2};
    camera.target = {0.9, 0.6, -0.9};
    camera.verticalFovDegrees = 62.0;
    world.renderer->applyCamera(camera);
    for (int i = 0; i < 400; ++i) pixels.emplace_back((i * 37) % kWidth, (i * 23) % kHeight);
    explained = world.renderer->explain(pixels, kWidth, kHeight);
  }
  ImageRgbaF shown(const char* id) {
    world.renderer->setView({findSurfaceView(id).value(), {}, {}});
    keepPicture(world.renderer->renderDisplay(), std::string("view_") + id);
    return world.renderer->renderLinear(kWidth, kHeight, 1);
  }
  static vec3 at(const ImageRgbaF& image, const Explanation& e) {
    const float* p = &image.pixels[static_cast<std::size_t>(e.y * kWidth + e.x) * 4];
    return {p[0], p[1], p[2]};
  }
  QuadWorld world;
  std::vector<glm::ivec2> pixels;
  std::vector<Explanation> explained;
};

TEST_F(DiffuseView, LightIsThePictureOfAMatteRoomOverItsColour) {
  const ImageRgbaF picture = shown("picture"), light = shown("diffuse-light");
  const SurfaceViewRow& row = surfaceViews()[static_cast<std::size_t>(findSurfaceView("diffuse-light").value())];
  int walls = 0;
  float brightest = 0.0f, darkest = 1.0e9f;
  for (const Explanation& e : explained) {
    if (e.surface.object.rfind("wall", 0) != 0) continue;
    ++walls;
    const vec3 value = at(light, e), expected = at(picture, e) / kAlbedo;
    EXPECT_LT(glm::length(value - expected), 2.0e-3f * glm::length(expected)) << e.x << " " << e.y;
    const auto explainedValue = surfaceValue(row, e);
    ASSERT_TRUE(explainedValue.has_value());
    EXPECT_LT(glm::length(value - *explainedValue), 2.0e-3f * (1.0f + glm::length(value))) << e.x << " " << e.y;
    brightest = std::max(brightest, value.x);
    darkest = std::min(darkest, value.x);
  }
  EXPECT_GT(walls, 150);
  std::printf("  light of %d places on walls: %.3f to %.3f\n", walls, static_cast<double>(darkest),
              static_cast<double>(brightest));
  EXPECT_GT(brightest, 3.0f * darkest) << "one light everywhere would tell nothing";
}

TEST_F(DiffuseView, ValidityIsTheWeightOfNodesOutsideOfTheBlock) {
  const ImageRgbaF validity = shown("node-validity");
  const SurfaceViewRow& row = surfaceViews()[static_cast<std::size_t>(findSurfaceView("node-validity").value())];
  int whole = 0, none = 0, between = 0;
  for (const Explanation& e : explained) {
    if (!e.hit || e.surface.object == "lamp") continue;
    const double value = static_cast<double>(at(validity, e).x), expected = ownLight(e.surface.positionWorld);
    EXPECT_NEAR(value, expected, 5.0e-3) << e.surface.object << " " << e.x << " " << e.y;
    const auto explainedValue = surfaceValue(row, e);
    ASSERT_TRUE(explainedValue.has_value());
    EXPECT_NEAR(static_cast<double>(explainedValue->x), value, 2.0e-3);
    ++(expected > 0.99 ? whole : expected < 0.6 ? none : between);
  }
  std::printf("  nodes of their own light: all at %d places, few at %d, some at %d\n", whole, none, between);
  EXPECT_GT(whole, 50);
  EXPECT_GT(none, 5);
  EXPECT_GT(between, 20);
}

TEST_F(DiffuseView, ErrorIsTheDistanceFromTheGivenLightWithoutItsNoise) {
  const ImageRgbaF light = shown("diffuse-light");
  const SurfaceViewRow& row = surfaceViews()[static_cast<std::size_t>(findSurfaceView("diffuse-error").value())];
  ImageRgbaF truth = light;
  std::vector<double> expected(truth.pixels.size() / 4, -1.0);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    float* p = &truth.pixels[4 * i];
    const dvec3 drawn(p[0], p[1], p[2]);
    const auto n = static_cast<int>(i);
    const dvec3 given = glm::max(drawn, 0.0) * (0.9 + 0.03 * (n % 7)) + dvec3(0.02 * (n % 3), 0.0, 0.01 * (n % 5));
    const double noise = n % 11 == 4 ? -1.0 : 2.0e-4 * (n % 4);
    for (int c = 0; c < 3; ++c) p[c] = static_cast<float>(given[c]);
    p[3] = static_cast<float>(noise);
    if (noise < 0.0 || drawn.x < 0.0 || glm::length(given) == 0.0) continue;
    const double off = glm::length(drawn - given);
    expected[i] = std::sqrt(std::max(off * off - noise, 0.0)) / glm::length(given);
  }
  world.renderer->setDiffuseTruth(truth);
  const ImageRgbaF error = shown("diffuse-error");
  int known = 0, unknown = 0, none = 0;
  for (const Explanation& e : world.renderer->explain(pixels, kWidth, kHeight)) {
    if (!e.hit) continue;
    const double value = static_cast<double>(at(error, e).x);
    const double wanted = expected[static_cast<std::size_t>(e.y * kWidth + e.x)];
    EXPECT_NEAR(value, wanted, 2.0e-3) << e.surface.object << " " << e.x << " " << e.y;
    const auto explainedValue = surfaceValue(row, e);
    ASSERT_EQ(explainedValue.has_value(), wanted >= 0.0);
    if (explainedValue) {
      EXPECT_NEAR(static_cast<double>(explainedValue->x), wanted, 4.0e-3);
    }
    ++(wanted > 0.0 ? known : wanted < 0.0 ? unknown : none);
  }
  std::printf("  errors at %d places, nothing given at %d, noise alone at %d\n", known, unknown, none);
  EXPECT_GT(known, 200);
  EXPECT_GT(unknown, 15);
  world.renderer->setDiffuseTruth({});
  const ImageRgbaF untraced = shown("diffuse-error");
  for (const Explanation& e : explained) {
    if (e.hit) {
      EXPECT_EQ(at(untraced, e), vec3(-1.0f));
    }
  }
}

double medianError(const ImageRgbaF& error) {
  std::vector<float> known;
  for (std::size_t i = 0; i < error.pixels.size(); i += 4) {
    if (error.pixels[i] >= 0.0f) known.push_back(error.pixels[i]);
  }
  EXPECT_GT(known.size(), error.pixels.size() / 8);
  std::nth_element(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2), known.end());
  return static_cast<double>(known[known.size() / 2]);
}

// Nine coefficients for all of the room are what the view was made to see through.
TEST_F(DiffuseView, AgainstPathsShapesAreNearAndCoefficientsAreNot) {
  PathSettings settings;
  settings.width = kWidth;
  settings.height = kHeight;
  settings.raysPerPixel = 256;
  settings.bounces = 1;  // as the probe has
  settings.quantity = PathQuantity::DiffuseLight;
  const ReferencePath path(world.scene, {std::make_shared<const Model>(room())}, nullptr);
  world.renderer->setDiffuseTruth(diffuseTruthImage(path.render(world.renderer->currentCamera(), settings)));
  const double shapes = medianError(shown("diffuse-error"));
  world.editAndFinish([](Scene& s) { s.lamps = LampForm::InMap; });
  const double coefficients = medianError(shown("diffuse-error"));
  std::printf("  median error of diffuse light: %.3f, by nine coefficients %.3f\n", shapes, coefficients);
  EXPECT_LT(shapes, 0.06);
  EXPECT_GT(coefficients, 4.0 * shapes);
}

// A surface that scatters nothing has no diffuse light to show, and a lattice of none of its own.
TEST_F(DiffuseView, AMetalHasNone) {
  world.editAndFinish([](Scene& s) {
    for (int i = 0; i < 6; ++i) s.materials["wall" + std::to_string(i)].metallic = 1.0f;
  });
  const std::vector<Explanation> again = world.renderer->explain({{5, 5}, {40, 3}, {60, 20}}, kWidth, kHeight);
  for (const char* id : {"diffuse-light", "node-validity"}) {
    const ImageRgbaF image = shown(id);
    const SurfaceViewRow& row = surfaceViews()[static_cast<std::size_t>(findSurfaceView(id).value())];
    int metals = 0;
    for (const Explanation& e : again) {
      if (e.surface.object.rfind("wall", 0) != 0) continue;
      ++metals;
      EXPECT_EQ(at(image, e), vec3(-1.0f)) << id;
      EXPECT_FALSE(surfaceValue(row, e).has_value()) << id;
    }
    EXPECT_GE(metals, 2) << id;
  }
}

}  // namespace
}  // namespace diffuse_view
}  // namespace boxprobe::test
