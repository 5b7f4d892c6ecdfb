// What few materials have on top of metalness and roughness (MaterialFinish), drawn: what the shader makes of factors
// and textures, the explanation of it, the ray tracer's, and how much light comes back.
#include <gmock/gmock.h>

#include "filters/reference/path/reference_path.h"
#include "tests/image/gltf_picture.h"

namespace boxprobe::test {
namespace {

class FinishPicture : public GltfPicture {
 protected:
  /// One material's extensions on a rough non-metal.
  void showWith(const Json& extensions, const Json& pbr = {{"metallicFactor", 0.0}, {"roughnessFactor", 0.5}}) {
    show(square(), {{"pbrMetallicRoughness", pbr}, {"extensions", extensions}});
  }
  void addLamp() {
    glb.json["extensions"]["KHR_lights_punctual"]["lights"] =
        Json::array({{{"type", "directional"}, {"intensity", 2.0}}});
    glb.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"rotation", {-0.3, 0.2, 0.0, 0.932738}}});
  }
  Explanation at(int x, int y) const { return picture->renderer->explain(x, y, kSize, kSize); }
  TracedHit hitAt(const ReferenceScene& reference, int x, int y) const {
    const glm::dvec3 eye(2.0 * share(x) - 1.0, 1.0 - 2.0 * share(y), 5.0);
    return *reference.tracer().firstHit(eye, {0.0, 0.0, -1.0});
  }
  /// The pixel, its explanation and the ray tracer tell of one surface and one light.
  void expectExplained() const {
    const ReferenceScene reference(picture->scene, {model}, nullptr);
    for (const auto& [x, y] : {std::pair(6, 9), std::pair(40, 33), std::pair(60, 50)}) {
      const Explanation e = at(x, y);
      const glm::vec3 drawn(pixel(x, y));
      const float scale = std::max({drawn.r, drawn.g, drawn.b, 1e-3f});
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(e.color[i], drawn[i], 2e-3f * scale) << x << ", " << y << " channel " << i;
      const SurfacePoint traced = reference.tracer().surface(hitAt(reference, x, y), e.surface.eyeWorld);
      ASSERT_TRUE(e.surface.finish.has_value() && traced.finish.has_value());
      const PointFinish &a = *e.surface.finish, &b = *traced.finish;
      EXPECT_LT(glm::length(a.f0 - b.f0), 2e-3f);
      EXPECT_LT(glm::length(a.sheenColor - b.sheenColor), 5e-3f);
      EXPECT_NEAR(a.edge, b.edge, 1e-5f);
      EXPECT_NEAR(a.sheenRoughness, b.sheenRoughness, 1e-5f);
      EXPECT_NEAR(a.anisotropy, b.anisotropy, 1e-5f);
      EXPECT_LT(glm::length(a.acrossWorld - b.acrossWorld), 1e-4f);
      EXPECT_NEAR(a.iridescence, b.iridescence, 1e-5f);
      EXPECT_NEAR(a.filmThickness, b.filmThickness, 1e-2f);
    }
  }
};

TEST_F(FinishPicture, EveryFactorAndTextureReachesTheSurface) {
  const Json color = {{"index", oneColor({255, 188, 128, 102})}};
  showWith({{"KHR_materials_specular",
             {{"specularFactor", 0.8},
              {"specularTexture", color},
              {"specularColorFactor", {0.5, 1.0, 2.0}},
              {"specularColorTexture", color}}},
            {"KHR_materials_sheen",
             {{"sheenColorFactor", {0.9, 0.5, 0.25}},
              {"sheenColorTexture", color},
              {"sheenRoughnessFactor", 0.5},
              {"sheenRoughnessTexture", color}}},
            {"KHR_materials_anisotropy",
             {{"anisotropyStrength", 0.6},
              {"anisotropyRotation", 0.5},
              {"anisotropyTexture", {{"index", oneColor({255, 128, 204, 255})}}}}},
            {"KHR_materials_iridescence",
             {{"iridescenceFactor", 0.5},
              {"iridescenceIor", 1.4},
              {"iridescenceTexture", {{"index", oneColor({128, 51, 0, 255})}}},
              {"iridescenceThicknessMinimum", 200},
              {"iridescenceThicknessMaximum", 700},
              {"iridescenceThicknessTexture", {{"index", oneColor({128, 51, 0, 255})}}}}}});
  addLamp();
  sky = SkyGradient{};
  probes = true;
  draw();
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  const PointFinish f = *at(32, 32).surface.finish;
  const float alpha = 102.0f / 255.0f;
  EXPECT_NEAR(f.edge, 0.8f * alpha, 1e-5f);
  EXPECT_NEAR(f.f0.r, 0.04f * 0.5f * 0.8f * alpha, 1e-4f);
  EXPECT_NEAR(f.f0.b, 0.04f * 2.0f * 0.8f * alpha * linear(128), 1e-4f);
  EXPECT_NEAR(f.sheenColor.g, 0.5f * linear(188), 2e-3f);
  EXPECT_NEAR(f.sheenRoughness, 0.5f * alpha, 1e-5f);
  EXPECT_NEAR(f.anisotropy, 0.6f * 0.8f, 1e-5f);
  // The tangent is +x, the bitangent +y; across the direction, which is turned by 0.5 from the tangent (a texel of 128
  // is 0.004 off the middle).
  EXPECT_NEAR(f.acrossWorld.x, -std::sin(0.5f), 5e-3f);
  EXPECT_NEAR(f.acrossWorld.y, std::cos(0.5f), 5e-3f);
  EXPECT_NEAR(f.iridescence, 0.5f * 128.0f / 255.0f, 1e-5f);
  EXPECT_NEAR(f.filmThickness, 200.0f + 500.0f * 0.2f, 1e-2f);
  EXPECT_EQ(f.filmIor, 1.4f);
  expectExplained();
}

TEST_F(FinishPicture, SheenIsExplainedUnderLampsAndACoat) {
  showWith({{"KHR_materials_sheen", {{"sheenColorFactor", {0.9, 0.5, 0.25}}, {"sheenRoughnessFactor", 0.4}}},
            {"KHR_materials_clearcoat", {{"clearcoatFactor", 0.5}, {"clearcoatRoughnessFactor", 0.2}}}});
  addLamp();
  sky = SkyColor{{0.5f, 0.5f, 0.5f}};
  probes = true;
  draw();
  expectExplained();
  const Explanation e = at(32, 32);
  EXPECT_GT(e.sheen.r, 0.0f);
  EXPECT_NEAR(e.sheen.r / e.sheen.g, 0.9f / 0.5f, 1e-4f);
}

// Nothing is absorbed, so that an even world of 1 shows 1, whatever the angle: what the sheen sends back its base does
// not get. The fit of the sheen's share is 0.04 off at most, and stands on both sides.
TEST_F(FinishPicture, WhiteClothKeepsItsLight) {
  showWith({{"KHR_materials_sheen", {{"sheenColorFactor", {1, 1, 1}}, {"sheenRoughnessFactor", 0.6}}},
            {"KHR_materials_ior", {{"ior", 1}}}});
  sky = SkyColor{{1.0f, 1.0f, 1.0f}};
  probes = true;
  draw();
  expectPixel(32, 32, glm::vec3(1.0f), 2e-3f);
  const Explanation e = at(32, 32);
  EXPECT_GT(e.sheen.r, 0.03f);
  EXPECT_NEAR(e.diffuse.r + e.sheen.r, 1.0f, 2e-3f);
  // The ray tracer's sheen, evaluated ray by ray, is as bright.
  const ReferenceScene reference(picture->scene, {model}, nullptr);
  const TracedHit hit = hitAt(reference, 32, 32);
  const SurfacePoint s = reference.tracer().surface(hit, e.surface.eyeWorld);
  const glm::dvec3 sent = reference.reflectedFrom(s, reference.tracer().awayFrom(hit), RaySees::Picture, 4096, 1);
  EXPECT_NEAR(sent.r, static_cast<double>(e.sheen.r), 0.01);
}

TEST_F(FinishPicture, TintIsOfTheReflectionAlone) {
  showWith({{"KHR_materials_specular", {{"specularColorFactor", {1, 0, 0}}}}},
           {{"metallicFactor", 0.0}, {"roughnessFactor", 0.3}, {"baseColorFactor", {0, 0, 0, 1}}});
  sky = SkyColor{{1.0f, 1.0f, 1.0f}};
  probes = true;
  draw();
  const glm::vec4 p = pixel(32, 32);
  EXPECT_NEAR(p.r, 0.04f, 0.004f);
  EXPECT_LT(p.g, 0.003f);
  expectExplained();
}

// A factor of 0 leaves no reflection at all, at its edge neither.
TEST_F(FinishPicture, NoSpecularReflectsNothing) {
  showWith({{"KHR_materials_specular", {{"specularFactor", 0}}}},
           {{"metallicFactor", 0.0}, {"roughnessFactor", 0.3}, {"baseColorFactor", {0, 0, 0, 1}}});
  addLamp();
  sky = SkyColor{{1.0f, 1.0f, 1.0f}};
  probes = true;
  draw();
  expectPixel(32, 32, glm::vec3(0.0f), 1e-4f);
}

TEST_F(FinishPicture, AMetalUnderAFilmIsExplained) {
  showWith({{"KHR_materials_iridescence", {{"iridescenceFactor", 1}, {"iridescenceThicknessMaximum", 350}}}},
           {{"metallicFactor", 1.0}, {"roughnessFactor", 0.2}, {"baseColorFactor", {0.9, 0.8, 0.7, 1}}});
  addLamp();
  sky = SkyGradient{};
  probes = true;
  draw();
  expectExplained();
}

// The traced film is exact, the drawn one a series of two terms on Schlick's curves: alike straight on, apart by a
// fifth of the light at 60 degrees.
TEST_F(FinishPicture, AFilmIsNearWhatThePathTracerHas) {
  showWith({{"KHR_materials_iridescence",
             {{"iridescenceFactor", 1}, {"iridescenceIor", 1.6}, {"iridescenceThicknessMaximum", 250}}}},
           {{"metallicFactor", 1.0}, {"roughnessFactor", 0.0}, {"baseColorFactor", {0.9, 0.7, 0.4, 1}}});
  sky = SkyColor{{1.0f, 1.0f, 1.0f}};
  probes = true;
  draw();
  const ReferencePath path(picture->scene, {model}, nullptr);
  for (const auto& [aside, bound] : {std::pair(0.0, 0.01), std::pair(45.0, 0.04), std::pair(60.0, 0.2)}) {
    Camera camera;
    const double angle = aside * glm::pi<double>() / 180.0;
    camera.position = {5.0 * std::sin(angle), 0.0, 5.0 * std::cos(angle)};
    camera.target = {0.0, 0.0, 0.0};
    camera.parallelHeight = 0.5;
    PathSettings settings;
    settings.width = settings.height = 4;
    settings.raysPerPixel = 8;
    const ReferencePicture traced = path.render(camera, settings);
    picture->renderer->applyCamera(camera);
    const ImageRgbaF drawn = picture->renderer->renderLinear(4, 4, 1);
    double worst = 0.0;
    for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
      if (i % 4 < 3) worst = std::max(worst, static_cast<double>(std::abs(drawn.pixels[i] - traced.color.pixels[i])));
    }
    std::printf("  %2.0f degrees aside: %.3f of the light\n", aside, worst);
    EXPECT_LT(worst, bound);
  }
}

TEST_F(FinishPicture, BrushedMetalStretchesALampsHighlight) {
  showWith({{"KHR_materials_anisotropy", {{"anisotropyStrength", 0.9}}}},
           {{"metallicFactor", 1.0}, {"roughnessFactor", 0.25}});
  glb.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({{{"type", "point"}, {"intensity", 1.0}}});
  glb.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"translation", {0, 0, 1}}});
  draw();
  const float along = pixel(56, 32).r, across = pixel(32, 56).r;
  std::printf("  along the brushing %g, across it %g\n", static_cast<double>(along), static_cast<double>(across));
  EXPECT_GT(along, 4.0f * across);
  expectExplained();
}

// A thickness texture's mean is the object's; each pixel's own is absorbed.
TEST_F(FinishPicture, GlassHasItsThicknessByPixel) {
  const Json halves = {
      {"index", texture(2, {0, 51, 0, 255, 0, 255, 0, 255}, {{"magFilter", 9728}, {"minFilter", 9728}})}};
  show(square(), {{"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.0}}},
                  {"extensions",
                   {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                    {"KHR_materials_ior", {{"ior", 1}}},
                    {"KHR_materials_volume",
                     {{"thicknessFactor", 2},
                      {"thicknessTexture", halves},
                      {"attenuationDistance", 1},
                      {"attenuationColor", {0.5, 0.5, 0.5}}}}}}});
  sky = SkyColor{{1.0f, 1.0f, 1.0f}};
  probes = true;
  draw();
  EXPECT_NEAR(model->materials[0].thickness, 2.0f * 0.6f, 1e-5f);
  EXPECT_NEAR(pixel(6, 32).r, std::pow(0.5f, 2.0f * 0.2f), 0.01f);
  EXPECT_NEAR(pixel(58, 32).r, std::pow(0.5f, 2.0f), 0.01f);
  for (const int x : {6, 58}) EXPECT_NEAR(at(x, 32).color.r, pixel(x, 32).r, 0.01f);
}

}  // namespace
}  // namespace boxprobe::test
