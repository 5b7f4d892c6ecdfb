// The ray tracer on scenes whose answer is known beforehand: what is hit, what it looks like, what is reflected.
#include "filters/reference/light/reference_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "filters/explain/explain_pixel.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/math/sampling/brdf_integral.h"
#include "filters/reference/trace/surface_texture.h"

namespace boxprobe {
namespace {

// A square of 2 x 2 in the plane y = 0, its front up, with texture coordinates 0..1 (u along x, v along -z).
std::shared_ptr<Model> floorModel(const Material& material) {
  auto model = std::make_shared<Model>();
  Mesh mesh;
  mesh.positions = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
  mesh.normals.assign(4, {0, 1, 0});
  mesh.tangents.assign(4, {1, 0, 0, 1});
  mesh.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.material = 0;
  model->meshes.push_back(mesh);
  model->materials.push_back(material);
  model->instances.push_back({"floor", 0, glm::dmat4(1.0)});
  return model;
}

Scene sceneOf(const std::vector<std::shared_ptr<Model>>& models) {
  Scene scene;
  scene.models.resize(models.size());
  scene.sky = SkyColor{glm::vec3(0.5f)};
  return scene;
}

std::vector<std::shared_ptr<const Model>> constant(const std::vector<std::shared_ptr<Model>>& models) {
  return {models.begin(), models.end()};
}

TEST(SceneTracer, HitsFrontsOnlyUnlessDoubleSided) {
  Material material;
  for (const bool doubleSided : {false, true}) {
    material.doubleSided = doubleSided;
    const std::vector<std::shared_ptr<Model>> models = {floorModel(material)};
    const SceneTracer tracer(makeTriangleScene(sceneOf(models), constant(models)));
    const auto above = tracer.firstHit({0.25, 2.0, 0.5}, {0.0, -3.0, 0.0});
    ASSERT_TRUE(above.has_value());
    EXPECT_NEAR(above->distance, 2.0, 1e-6) << "the direction need not be unit";
    EXPECT_LT(glm::distance(above->positionWorld, glm::dvec3(0.25, 0.0, 0.5)), 1e-6);
    EXPECT_GT(above->frontWorld.y, 0.99);
    EXPECT_FALSE(above->backSide);
    const auto below = tracer.firstHit({0.25, -2.0, 0.5}, {0.0, 1.0, 0.0});
    EXPECT_EQ(below.has_value(), doubleSided);
    if (below.has_value()) {
      EXPECT_TRUE(below->backSide);
      EXPECT_LT(tracer.surface(*below, {0.25, -2.0, 0.5}).normalWorld.y, -0.99f);
    }
    EXPECT_FALSE(tracer.firstHit({0.25, 2.0, 0.5}, {0.0, 1.0, 0.0}).has_value());
    EXPECT_FALSE(tracer.firstHit({0.25, 2.0, 0.5}, glm::dvec3(0.0)).has_value());
  }
}

TEST(SceneTracer, KeepsItsDigitsFarFromTheOrigin) {
  const std::vector<std::shared_ptr<Model>> models = {floorModel({})};
  Scene scene = sceneOf(models);
  scene.models[0].translation = {1.0e6, -2.0e6, 3.0e6};
  scene.models[0].rotationDegrees = {0.0, 0.0, 90.0};  // the front now looks along -x
  const SceneTracer tracer(makeTriangleScene(scene, constant(models)));
  const glm::dvec3 from = scene.models[0].translation + glm::dvec3(-1.5, 0.125, 0.25);
  const auto hit = tracer.firstHit(from, {1.0, 0.0, 0.0});
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->distance, 1.5, 1e-6);
  EXPECT_LT(tracer.surface(*hit, from).normalWorld.x, -0.999f);
}

TEST(SceneTracer, StandInsAreSeenByProbesOnlyAndHiddenObjectsByThePictureOnly) {
  auto model = floorModel({});
  model->instances.push_back({"stand-in", 0, glm::translate(glm::dmat4(1.0), glm::dvec3(0, 1, 0))});
  model->instances.push_back({"vase", 0, glm::translate(glm::dmat4(1.0), glm::dvec3(0, 2, 0))});
  const std::vector<std::shared_ptr<Model>> models = {model};
  Scene scene = sceneOf(models);
  scene.objects["stand-in"].visible = false;
  scene.probes.resize(1);
  scene.probes[0].hides = {"vase"};
  const SceneTracer tracer(makeTriangleScene(scene, constant(models)));
  const auto distance = [&](RaySees sees) { return tracer.firstHit({0, 5, 0.3}, {0, -1, 0}, sees)->distance; };
  EXPECT_NEAR(distance(RaySees::Picture), 3.0, 1e-5) << "the vase";
  EXPECT_NEAR(distance(RaySees::Probes), 4.0, 1e-5) << "the stand-in";
}

TEST(SceneTracer, TexturesAndNormalMapsShapeTheSurface) {
  auto picture = std::make_shared<ImageRgba8>();
  picture->width = 2;
  picture->height = 1;
  picture->pixels = {255, 0, 188, 255, 0, 255, 188, 255};
  Material material;
  material.baseColor = {0.5f, 1.0f, 1.0f, 1.0f};
  material.roughness = 0.8f;
  for (TextureUse* use : {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture}) {
    *use = {picture, Wrap::ClampToEdge, Wrap::ClampToEdge};
  }
  const std::vector<std::shared_ptr<Model>> models = {floorModel(material)};
  const SceneTracer tracer(makeTriangleScene(sceneOf(models), constant(models)));
  const auto at = [&](double x) {
    const glm::dvec3 eye(x, 1.0, 0.0);
    return tracer.surface(*tracer.firstHit(eye, {0.0, -1.0, 0.0}), eye);
  };
  const SurfacePoint left = at(-0.9), right = at(0.9), middle = at(0.0);
  EXPECT_NEAR(left.albedo.r, 0.5f, 1e-5f);
  EXPECT_NEAR(left.albedo.g, 0.0f, 1e-5f);
  EXPECT_NEAR(left.albedo.b, 0.503f, 1e-3f) << "sRGB 188 is linear 0.503";
  EXPECT_NEAR(middle.albedo.r, 0.25f, 1e-3f);
  EXPECT_NEAR(left.roughness, 0.0f, 1e-5f);
  EXPECT_NEAR(right.roughness, 0.8f, 1e-5f);
  EXPECT_NEAR(left.metallic, 188.0f / 255.0f, 1e-5f) << "not sRGB";
  EXPECT_GT(left.normalWorld.x, 0.6f) << "tangent +x";
  EXPECT_GT(left.normalWorld.z, 0.6f) << "green 0 leans against the bitangent, cross(normal, tangent) = -z";
  EXPECT_LT(right.normalWorld.x, -0.6f);
  EXPECT_NEAR(left.coatNormalWorld.y, 1.0f, 1e-6f) << "a coat is smooth";
}

TEST(SurfaceTexture, WrapsAsAsked) {
  auto picture = std::make_shared<ImageRgba8>();
  picture->width = 4;
  picture->height = 1;
  for (const int value : {0, 51, 102, 255}) {
    for (int c = 0; c < 4; ++c) picture->pixels.push_back(static_cast<std::uint8_t>(value));
  }
  const auto red = [&](Wrap wrap, float u) { return sampleTexture({picture, wrap, wrap}, {u, 0.5f}, false).r; };
  EXPECT_NEAR(red(Wrap::Repeat, 0.375f), 0.2f, 1e-6f);
  EXPECT_NEAR(red(Wrap::Repeat, -3.625f), 0.2f, 1e-6f);
  EXPECT_NEAR(red(Wrap::Repeat, 1.0f), 0.5f, 1e-6f) << "half way from the last texel to the first";
  EXPECT_NEAR(red(Wrap::ClampToEdge, 7.0f), 1.0f, 1e-6f);
  EXPECT_NEAR(red(Wrap::ClampToEdge, 1.0e20f), 1.0f, 1e-6f);
  EXPECT_NEAR(red(Wrap::MirroredRepeat, 1.125f), 1.0f, 1e-6f);
  EXPECT_NEAR(red(Wrap::MirroredRepeat, 1.375f), 0.4f, 1e-6f);
  EXPECT_NEAR(red(Wrap::MirroredRepeat, -0.375f), 0.2f, 1e-6f);
  EXPECT_EQ(red(Wrap::Repeat, std::nanf("")), 0.0f);
}

// Below an even sky a floor reflects the sky times its albedo, at every roughness and view. The albedo is integrated by
// other means than rays; a mirror's is exact, others scatter with their rays.
TEST(ReferenceScene, AFurnaceReturnsTheAlbedo) {
  struct Surface {
    const char* name;
    Material material;
    glm::dvec3 f0, f90;
  };
  Material metal, chalk;
  metal.metallic = 1.0f;
  metal.baseColor = {1.0f, 0.5f, 0.25f, 1.0f};
  chalk.metallic = 0.0f;
  chalk.baseColor = {0.0f, 0.0f, 0.0f, 1.0f};
  double worst = 0.0;
  for (const Surface& surface : {Surface{"metal", metal, {1.0, 0.5, 0.25}, glm::dvec3(1.0)},
                                 Surface{"dielectric", chalk, glm::dvec3(0.04), glm::dvec3(1.0)}}) {
    for (const float roughness : {0.0f, 0.1f, 0.25f, 0.5f, 0.75f, 1.0f}) {
      Material material = surface.material;
      material.roughness = roughness;
      const std::vector<std::shared_ptr<Model>> models = {floorModel(material)};
      const ReferenceScene reference(sceneOf(models), constant(models), nullptr);
      for (const double cosine : {0.02, 0.17, 0.25, 0.5, 0.9, 1.0}) {
        const glm::dvec3 eye(100.0 * std::sqrt(1.0 - cosine * cosine), 100.0 * cosine, 0.0);
        const auto hit = reference.tracer().firstHit(eye, -eye);
        ASSERT_TRUE(hit.has_value());
        const SurfacePoint s = reference.tracer().surface(*hit, eye);
        const glm::dvec3 color =
            reference.reflectedFrom(s, reference.tracer().awayFrom(*hit), RaySees::Probes, 1 << 14, 1);
        const glm::dvec2 albedo = integrateBrdf(cosine, static_cast<double>(roughness));
        for (int c = 0; c < 3; ++c) {
          const double expected = 0.5 * (albedo.x * surface.f0[c] + albedo.y * surface.f90[c]);
          worst = std::max(worst, std::abs(color[c] - expected) / 0.5);
          EXPECT_NEAR(color[c], expected, 0.5e-3) << surface.name << ", " << roughness << " at " << cosine;
        }
      }
    }
  }
  std::printf("  a white furnace: off by at most %.1e of its light\n", worst);
}

TEST(ReferenceScene, DiffuseLightIsTheSkysAndUnlitShowsItsColour) {
  Material chalk;
  chalk.metallic = 0.0f;
  chalk.ior = 1.0f;  // reflects nothing at normal incidence, nothing at the edge either
  chalk.baseColor = {0.6f, 0.4f, 0.2f, 1.0f};
  const std::vector<std::shared_ptr<Model>> models = {floorModel(chalk)};
  Scene scene = sceneOf(models);
  scene.lights.resize(1);
  scene.lights[0].direction = {0.0, -2.0, 0.0};
  scene.lights[0].intensity = 3.0f;
  const ReferenceScene reference(scene, constant(models), nullptr);
  const glm::dvec3 seen = reference.seenFrom({0.1, 1.0, 0.1}, {0.0, -1.0, 0.0}, RaySees::Probes);
  EXPECT_NEAR(seen.r, 0.6 * (0.5 + 3.0 / 3.14159265), 1e-3);
  EXPECT_NEAR(seen.b, 0.2 * (0.5 + 3.0 / 3.14159265), 1e-3);

  chalk.unlit = true;
  const std::vector<std::shared_ptr<Model>> flat = {floorModel(chalk)};
  const glm::dvec3 shown =
      ReferenceScene(scene, constant(flat), nullptr).seenFrom({0.1, 1.0, 0.1}, {0, -1, 0}, RaySees::Probes);
  EXPECT_NEAR(shown.r, 0.6, 1e-6);
}

// A highlight moves with the eye: a probe keeps it as it is from its origin, and so do rays that see as probes do.
TEST(ReferenceScene, RaysThatSeeAsProbesSeeGlossFromTheProbesOrigin) {
  Material metal;
  metal.metallic = 1.0f;
  metal.roughness = 0.3f;
  const std::vector<std::shared_ptr<Model>> models = {floorModel(metal)};
  Scene scene = sceneOf(models);
  scene.sky = SkyColor{glm::vec3(0.0f)};
  scene.lights.resize(1);
  scene.lights[0].direction = {-1.0, -1.0, 0.0};
  const glm::dvec3 from(-0.5, 1.0, 0.0), to(0.6, -1.0, 0.0);  // away from the mirrored light
  const glm::dvec3 bare = ReferenceScene(scene, constant(models), nullptr).seenFrom(from, to, RaySees::Probes);
  Probe probe;
  probe.origin = {-0.9, 1.0, 0.0};  // in it
  probe.box = Box{glm::dvec3(-2.0), glm::dvec3(2.0)};
  probe.blendDistance = {glm::dvec3(0.0), glm::dvec3(0.0)};
  scene.probes.push_back(probe);
  const ReferenceScene reference(scene, constant(models), nullptr);
  const glm::dvec3 hit(0.1, 0.0, 0.0);
  const glm::dvec3 captured = reference.seenFrom(probe.origin, hit - probe.origin, RaySees::Probes);
  EXPECT_GT(captured.r, 2.0 * bare.r);
  EXPECT_NEAR(reference.seenFrom(from, hit - from, RaySees::Probes).r, captured.r, 1e-4 * captured.r);
  EXPECT_NEAR(reference.seenFrom(from, hit - from, RaySees::Picture).r, bare.r, 1e-4 * captured.r);
  EXPECT_NEAR(reference.seenFrom({-0.5, 9.0, 0.0}, {0.0, -1.0, 0.0}, RaySees::Probes).r,
              reference.seenFrom({-0.5, 9.0, 0.0}, {0.0, -1.0, 0.0}, RaySees::Picture).r, 1e-6)
      << "where no probe reaches";
}

// The floor of the closed room, glossy: standard errors must be what they say.
TEST(ReferenceScene, StandardErrorsAreHonestAndFallWithRays) {
  const std::string folder = std::string(BOXPROBE_DATA_DIR) + "/scenes/";
  Scene scene = loadSceneFile(folder + "room.boxprobe.json");
  scene.materials["floor"].roughness = 0.5f;
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& file : scene.models) models.push_back(std::make_shared<Model>(loadModelFile(file.file)));
  const ReferenceScene reference(scene, models, nullptr);
  ReferenceSettings settings;
  settings.width = 48;
  settings.height = 27;
  settings.samplesPerPixel = 1;
  const auto picture = [&](int rays, std::uint64_t seed) {
    settings.raysPerPixel = rays;
    settings.seed = seed;
    return reference.render(scene.cameras[0], settings);
  };
  const ReferencePicture few = picture(128, 1), again = picture(128, 1), other = picture(128, 2);
  EXPECT_EQ(few.color.pixels, again.color.pixels) << "the same seed gives the same picture, whatever the threads do";
  int count = 0, beyond = 0;
  double zSum = 0.0, errorSum = 0.0;
  for (std::size_t i = 0; i < few.color.pixels.size(); ++i) {
    const double e = std::hypot(few.standardError.pixels[i], other.standardError.pixels[i]);
    if (i % 4 == 3 || e <= 0.0) continue;
    const double z = (few.color.pixels[i] - other.color.pixels[i]) / e;
    ++count;
    zSum += z;
    beyond += std::abs(z) > 2.0 ? 1 : 0;
    errorSum += few.standardError.pixels[i];
  }
  ASSERT_GT(count, 500);
  EXPECT_LT(std::abs(zSum / count), 3.0 * 1.1 / std::sqrt(count / 3.0)) << "the three components go together";
  EXPECT_GT(static_cast<double>(beyond) / count, 0.02);
  EXPECT_LT(static_cast<double>(beyond) / count, 0.10);

  double manySum = 0.0;
  for (const float e : picture(1024, 3).standardError.pixels) manySum += e;
  // Points spread evenly do better than the square root of 8.
  EXPECT_LT(manySum, errorSum / std::sqrt(8.0));
}

// A square of 2 x 2 in a picture 8 high and as wide: a sixteenth of it, from however far away.
TEST(ReferenceScene, ParallelCamerasSeeByTheHeightOfThePicture) {
  const std::vector<std::shared_ptr<Model>> models = {floorModel({})};
  const Scene scene = sceneOf(models);
  ReferenceSettings settings;
  settings.width = settings.height = 64;
  settings.samplesPerPixel = 1;
  settings.raysPerPixel = 1;
  for (const double distance : {2.0, 50.0}) {
    Camera camera;
    camera.position = {0.0, distance, 0.0};
    camera.target = {0.0, 0.0, 0.0};
    camera.up = {0.0, 0.0, -1.0};
    camera.parallelHeight = 8.0;
    const ImageRgbaF picture = ReferenceScene(scene, constant(models), nullptr).render(camera, settings).color;
    double covered = 0.0;
    for (std::size_t i = 3; i < picture.pixels.size(); i += 4) covered += picture.pixels[i];
    EXPECT_NEAR(covered / (64.0 * 64.0), 1.0 / 16.0, 1e-9) << distance;
  }
}

TEST(ReferenceScene, StopsWhenAsked) {
  const std::vector<std::shared_ptr<Model>> models = {floorModel({})};
  Scene scene = sceneOf(models);
  ReferenceSettings settings;
  settings.width = settings.height = 64;
  int calls = 0;
  double last = 0.0;
  const ReferencePicture picture =
      ReferenceScene(scene, constant(models), nullptr).render(Camera{}, settings, [&](double done) {
        EXPECT_GE(done, last);
        last = done;
        return ++calls < 5;
      });
  EXPECT_FALSE(picture.complete);
  EXPECT_EQ(calls, 5);
  EXPECT_LT(last, 1.0);
}

TEST(RayPlan, SpendsWhatItIsGiven) {
  for (const int positions : {1, 4, 16}) {
    for (const int rays : {1, 16, 64, 256, 1024, 65536}) {
      const RayPlan plan = planRays(rays, positions);
      SCOPED_TRACE(std::to_string(rays) + " rays at " + std::to_string(positions));
      EXPECT_GE(plan.passes, 1);
      EXPECT_LE(plan.passes, 16);
      EXPECT_LE(plan.passes * plan.raysPerPass * positions, std::max(rays, positions));
      EXPECT_GE(2 * plan.passes * plan.raysPerPass * positions, rays);
      if (rays >= 16 * positions) {
        EXPECT_GE(plan.raysPerPass, 8);
        EXPECT_GE(plan.passes, 2) << "one estimate has no spread";
      }
    }
  }
}

}  // namespace
}  // namespace boxprobe
