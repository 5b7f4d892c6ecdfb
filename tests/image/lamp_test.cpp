// Lamps and probes light alike: a sphere that shines with radiance L, as a probe captured it, against VTK's point light
// of the same strength, I = L pi r², in its place. Only the renderer's light loop knows the one, only the capture, the
// prefilter, the technique and the split-sum table the other.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "filters/reference/light/reference_box.h"
#include "tests/support/scene_picture.h"
#include "tests/support/sphere_mesh.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kSize = 160;
constexpr float kLampRadius = 0.4f;
const glm::dvec3 kLamp(0.0, 4.0, 10.0);  // in the middle of the box's wall

class Lamp : public testing::TestWithParam<std::tuple<float, Energy>> {};

// Light of the highlight over the sphere's pixels that face the eye, both ways.
TEST_P(Lamp, ShinesAsItsCaptureDoes) {
  const auto [roughness, energy] = GetParam();
  Model model;
  Material ball, lamp;
  ball.name = "ball";
  ball.metallic = 1.0f;
  ball.roughness = roughness;
  ball.baseColor = {0.9f, 0.6f, 0.3f, 1.0f};
  lamp.name = "lamp";
  lamp.baseColor = {0.0f, 0.0f, 0.0f, 1.0f};
  lamp.ior = 1.0f;
  lamp.emissive = glm::vec3(200.0f);
  model.materials = {ball, lamp};
  model.meshes = {sphereMesh(0.5f, 96, 192), sphereMesh(kLampRadius, 96, 192)};
  model.meshes[1].material = 1;
  model.instances = {{"ball", 0, glm::dmat4(1.0)}, {"lamp", 1, glm::translate(glm::dmat4(1.0), kLamp)}};
  for (Mesh& mesh : model.meshes) mesh.material = std::max(mesh.material, 0);

  Scene scene;
  scene.models.push_back({"ball", {}, {}, 1.0});
  scene.sky = SkyColor{glm::vec3(0.0f)};
  scene.energy = energy;
  Probe probe;
  probe.box = Box{glm::dvec3(-10.0), glm::dvec3(10.0)};
  probe.blendDistance = {};
  probe.faceSize = 512;
  probe.samplesPerPixel = 16;
  scene.probes.push_back(probe);
  scene.objects["ball"].seenByProbes = false;
  Camera camera;
  camera.position = {0, 0, 5};
  camera.target = {0, 0, 0};
  camera.verticalFovDegrees = 12.0;

  ScenePicture picture(scene, kSize, kSize);
  picture.renderer->setModels({std::make_shared<Model>(model)});
  const auto light = [&](const ImageRgbaF& image) {
    glm::dvec3 sum(0.0);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        // Of the sphere, the disc whose normals are within 60 degrees of the eye.
        const double half = 5.0 * std::tan(glm::radians(6.0));
        const double across = ((x + 0.5) / kSize * 2.0 - 1.0) * half, up = ((y + 0.5) / kSize * 2.0 - 1.0) * half;
        if (std::hypot(across, up) > 0.5 * std::sin(glm::radians(60.0))) continue;
        const float* p = &image.pixels[4 * (static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x))];
        sum += glm::dvec3(p[0], p[1], p[2]);
      }
    }
    return sum;
  };

  const auto show = [&] {
    picture.renderer->sync(picture.scene, Changes::all());
    picture.renderer->applyCamera(camera);
    picture.renderer->finishWork();
  };

  Scene lit = scene;
  lit.probes.clear();
  lit.objects["lamp"].visible = false;
  Light point;
  point.type = LightType::Point;
  point.position = kLamp;
  point.intensity = static_cast<float>(lamp.emissive.x * 3.14159265f * kLampRadius * kLampRadius);
  lit.lights.push_back(point);
  picture.scene = lit;
  show();
  const ImageRgbaF byLamp = picture.linear(4);
  const glm::dvec3 expected = light(byLamp);
  keepPicture(byLamp, "lamp_light");
  ASSERT_GT(expected.r, 0.0);

  const auto print = [roughness](const char* name, const glm::dvec3& share) {
    std::printf("  roughness %.2f, %-13s light %.4f %.4f %.4f of the lamp's\n", static_cast<double>(roughness), name,
                share.r, share.g, share.b);
  };
  const auto technique = [&](const char* id, std::map<std::string, ParameterValue> parameters, const char* name) {
    picture.scene = scene;
    picture.scene.probes[0].technique = id;
    picture.scene.probes[0].parameters = std::move(parameters);
    show();
    const ImageRgbaF byProbe = picture.linear(4);
    keepPicture(byProbe, std::string("lamp_") + name);
    const glm::dvec3 share = light(byProbe) / expected;
    print(name, share);
    return share;
  };
  // By the default pattern: one that is the same in every pixel leaves ghosts of the lamp, which are off by a few more
  // in a hundred.
  const glm::dvec3 rays = technique("raytraced", {{"samples", 64.0}, {"filtered", true}}, "raytraced 64");
  const glm::dvec3 manyRays = technique("raytraced", {{"samples", 256.0}, {"filtered", true}}, "raytraced 256");
  const glm::dvec3 pieces = technique("footprint8", {}, "footprint8");
  // The same at rest, where the technique's own frame is where it starts.
  RefineSettings atRest;
  atRest.rays = RefineSettings::kRays;
  picture.renderer->refine(atRest);
  picture.renderer->finishWork();
  const glm::dvec3 rested = light(picture.renderer->renderRefined(kSize, kSize, 1, atRest)) / expected;
  print("at rest", rested);
  picture.renderer->refine({});

  // The lobe's integral over what the probe captured: no technique stands between.
  ReferenceBoxMaps maps;
  maps.probes.push_back(picture.renderer->mapsOnCpu(scene.probes[0].name));
  maps.energy = energy;
  maps.findBright();
  std::vector<glm::ivec2> places;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) places.emplace_back(x, y);
  }
  ImageRgbaF integral{kSize, kSize, {}};
  std::uint64_t seed = 1;
  for (const Explanation& e : picture.renderer->explain(places, kSize, kSize)) {
    const glm::dvec3 color = e.hit ? referenceBoxColor(litPoint(e), maps, 64, hashBits(seed++)) : glm::dvec3(0.0);
    for (const double channel : {color.r, color.g, color.b, 1.0})
      integral.pixels.push_back(static_cast<float>(channel));
  }
  const glm::dvec3 share = light(integral) / expected;
  print("reference-box", share);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(share[c], 1.0, 0.02);
    // Rougher surfaces show how a technique's few lookups weigh one small lamp, and how far filtered rays smear it,
    // the less the more there are: printed above.
    if (roughness < 0.6f) {
      EXPECT_NEAR(manyRays[c], 1.0, 0.02);
    }
    if (roughness > 0.35f) continue;
    EXPECT_NEAR(rays[c], 1.0, 0.02);
    EXPECT_NEAR(pieces[c], 1.0, 0.02);
  }
}

INSTANTIATE_TEST_SUITE_P(Roughness, Lamp,
                         testing::Combine(testing::Values(0.2f, 0.35f, 0.5f, 0.75f, 1.0f),
                                          testing::Values(Energy::Single, Energy::Multiple)));

}  // namespace
