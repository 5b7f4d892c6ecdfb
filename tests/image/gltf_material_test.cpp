// Materials of glTF, drawn: the colour of known pixels, and what the shader makes of the surface there, against what
// the specification says of these files.
#include <gmock/gmock.h>

#include "tests/image/gltf_picture.h"

namespace boxprobe::test {
namespace {

TEST_F(GltfPicture, FactorsCountWithoutTextures) {
  show(square(), merged(unlit(), {{"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 1}}}}}));
  draw();
  expectPixel(32, 32, {0.1f, 0.2f, 0.3f});
}

// VTK 9.1's importer has them only beside a base-colour texture.
TEST_F(GltfPicture, EveryTextureCountsWithoutABaseColorTexture) {
  const int packed = oneColor({77, 51, 204, 255});
  const int glow = oneColor({188, 0, 255, 255});
  show(square(),
       {{"pbrMetallicRoughness",
         {{"metallicFactor", 0.5}, {"roughnessFactor", 0.75}, {"metallicRoughnessTexture", {{"index", packed}}}}},
        {"occlusionTexture", {{"index", packed}, {"strength", 0.5}}},
        {"emissiveTexture", {{"index", glow}}},
        {"emissiveFactor", {1, 1, 0.5}},
        {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 6}}}}}});
  draw();
  const SurfacePoint s = surfaceAt(20, 40);
  EXPECT_NEAR(s.roughness, 0.75f * 51 / 255, 1e-6f);
  EXPECT_NEAR(s.metallic, 0.5f * 204 / 255, 1e-6f);
  EXPECT_NEAR(s.occlusion, 1.0f + 0.5f * (77.0f / 255 - 1.0f), 1e-6f);
  // Software OpenGL decodes sRGB to within 0.2 %.
  EXPECT_NEAR(s.emissive.x, 6.0f * linear(188), 0.01f);
  EXPECT_NEAR(s.emissive.z, 3.0f, 1e-5f);
  expectPixel(20, 40, {6.0f * linear(188), 0.0f, 3.0f}, 0.01f);
}

TEST_F(GltfPicture, OcclusionHasAnImageOfItsOwn) {
  show(square(), {{"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", oneColor({9, 128, 64, 255})}}}}},
                  {"occlusionTexture", {{"index", oneColor({51, 200, 200, 255})}}}});
  draw();
  const SurfacePoint s = surfaceAt(32, 32);
  EXPECT_NEAR(s.occlusion, 0.2f, 1e-6f);
  EXPECT_NEAR(s.roughness, 128.0f / 255, 1e-6f);
  EXPECT_NEAR(s.metallic, 64.0f / 255, 1e-6f);
}

// An even sky of radiance 1 on white chalk shows 1, and a fifth of it under occlusion; a lamp's light is not occluded.
TEST_F(GltfPicture, OcclusionIsOfTheSurroundingsOnly) {
  const Json chalk = {{"pbrMetallicRoughness", {{"metallicFactor", 0}}},
                      {"occlusionTexture", {{"index", oneColor({51, 0, 0, 255})}}},
                      {"extensions", {{"KHR_materials_ior", {{"ior", 1}}}}}};
  show(square(), chalk);
  glb.json["extensions"]["KHR_lights_punctual"]["lights"] =
      Json::array({{{"type", "directional"}, {"intensity", glm::pi<float>()}}});
  glb.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  draw();
  expectPixel(32, 32, glm::vec3(1.0f), 1e-4f);
}

TEST_F(GltfPicture, IndexOfRefractionSetsTheReflectance) {
  show(square(),
       {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"extensions", {{"KHR_materials_ior", {{"ior", 2.4}}}}}});
  draw();
  EXPECT_NEAR(surfaceAt(32, 32).baseF0, (1.4f / 3.4f) * (1.4f / 3.4f), 1e-6f);
}

TEST_F(GltfPicture, ClearCoatHasFactorsAndTextures) {
  const int coat = oneColor({128, 64, 0, 255});
  show(square(), {{"extensions",
                   {{"KHR_materials_clearcoat",
                     {{"clearcoatFactor", 0.5},
                      {"clearcoatTexture", {{"index", coat}}},
                      {"clearcoatRoughnessFactor", 0.8},
                      {"clearcoatRoughnessTexture", {{"index", coat}}},
                      {"clearcoatNormalTexture", {{"index", oneColor({255, 128, 128, 255})}}}}}}}});
  draw();
  const SurfacePoint s = surfaceAt(32, 32);
  EXPECT_NEAR(s.coatStrength, 0.5f * 128 / 255, 1e-6f);
  EXPECT_NEAR(s.coatRoughness, 0.8f * 64 / 255, 1e-6f);
  EXPECT_GT(s.coatNormalWorld.x, 0.99f);
  EXPECT_GT(s.normalWorld.z, 0.999f) << "the base keeps its own";
}

// A white square before a white sky: its left half reflects it all around, its right half lets it in and keeps it.
TEST_F(GltfPicture, TransmissionHasAFactorAndATexture) {
  const Json halves = {
      {"index", texture(2, {0, 9, 9, 255, 255, 9, 9, 255}, {{"magFilter", 9728}, {"minFilter", 9728}})}};
  show(square(),
       {{"pbrMetallicRoughness", {{"metallicFactor", 0}}},
        {"extensions",
         {{"KHR_materials_transmission", {{"transmissionFactor", 0.75}, {"transmissionTexture", halves}}},
          {"KHR_materials_volume",
           {{"thicknessFactor", 1}, {"attenuationDistance", 0.01}, {"attenuationColor", {0.01, 0.01, 0.01}}}}}}});
  sky = SkyColor{{1.0f, 1.0f, 1.0f}};
  probes = true;
  draw();
  EXPECT_EQ(model->materials[0].transmission, 0.75f);
  const float reflected = pixel(58, 32).r;
  std::printf("  left %g, right %g\n", static_cast<double>(pixel(6, 32).r), static_cast<double>(reflected));
  EXPECT_NEAR(pixel(6, 32).r, 1.0f, 0.05f);
  EXPECT_NEAR(reflected, 0.25f, 0.05f);
}

TEST_F(GltfPicture, VertexColorsMultiplyAndAreInterpolated) {
  Json attributes = square();
  attributes["COLOR_0"] = glb.floats("VEC3", 3, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  show(attributes, merged(unlit(), {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 1, 1, 1}}}}}));
  draw();
  for (const auto& [x, y] : {std::pair(3, 60), std::pair(40, 20), std::pair(62, 1)}) {
    expectPixel(x, y, {0.5 * share(x), 1.0 - share(y), 0.0f}, 1e-5f);
  }
}

TEST_F(GltfPicture, VertexColorsOfBytesAreNormalized) {
  Json attributes = square();
  const std::vector<std::uint8_t> rgba = {51, 102, 255, 128, 51, 102, 255, 128, 51, 102, 255, 128, 51, 102, 255, 128};
  const int colors = glb.accessor(glb.view(rgba), GlbBuilder::UByte, "VEC4", 4);
  glb.json["accessors"][static_cast<std::size_t>(colors)]["normalized"] = true;
  attributes["COLOR_0"] = colors;
  show(attributes, unlit());
  draw();
  expectTracedAlike();
  expectPixel(32, 32, {0.2f, 0.4f, 1.0f});  // and alpha means nothing to an opaque material
}

TEST_F(GltfPicture, TexturesChooseTheirSetOfCoordinates) {
  Json attributes = square({0, 0, 0, 0, 0, 0, 0, 0});
  attributes["TEXCOORD_1"] = glb.floats("VEC2", 2, {0, 1, 1, 1, 1, 0, 0, 0});
  const int two = texture(2, {255, 0, 0, 255, 0, 255, 0, 255}, {{"magFilter", 9728}, {"minFilter", 9728}});
  show(attributes,
       merged(unlit(), {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", two}, {"texCoord", 1}}}}}}));
  draw();
  expectPixel(10, 32, {1, 0, 0});
  expectPixel(50, 32, {0, 1, 0});
  expectTracedAlike();
  EXPECT_THAT(warnings, testing::Not(testing::Contains(testing::HasSubstr("coordinates"))));
}

// The four texels of a picture after offset, rotation and scale, by the matrices of the extension's text, at many
// pixels.
TEST_F(GltfPicture, TextureTransformsAreTheExtensionsMatrix) {
  const std::vector<std::uint8_t> texels = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  const double offset[2] = {0.125, 0.375}, scale[2] = {1.5, 0.75}, turn = 0.5;
  const int four = texture(2, texels, {{"magFilter", 9728}, {"minFilter", 9728}});
  const Json transform = {{"offset", {offset[0], offset[1]}}, {"scale", {scale[0], scale[1]}}, {"rotation", turn}};
  show(square(),
       merged(unlit(),
              {{"pbrMetallicRoughness",
                {{"baseColorTexture", {{"index", four}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}}));
  draw();
  int compared = 0;
  for (int y = 1; y < kSize; y += 3) {
    for (int x = 1; x < kSize; x += 3) {
      const double u = scale[0] * share(x), v = scale[1] * share(y);
      const double tu = std::cos(turn) * u + std::sin(turn) * v + offset[0];
      const double tv = -std::sin(turn) * u + std::cos(turn) * v + offset[1];
      const double s = (tu - std::floor(tu)) * 2.0, t = (tv - std::floor(tv)) * 2.0;
      // On the border of two texels rounding decides.
      if (std::abs(s - std::round(s)) < 0.01 || std::abs(t - std::round(t)) < 0.01) continue;
      const std::uint8_t* texel = &texels[4 * static_cast<std::size_t>(static_cast<int>(t) * 2 + static_cast<int>(s))];
      expectPixel(x, y, glm::vec3(texel[0], texel[1], texel[2]) / 255.0f);
      ++compared;
    }
  }
  EXPECT_GT(compared, 380);
  expectTracedAlike();
}

TEST_F(GltfPicture, TheTransformMayNameAnotherSet) {
  Json attributes = square({0, 0, 0, 0, 0, 0, 0, 0});
  attributes["TEXCOORD_1"] = glb.floats("VEC2", 2, {0, 1, 1, 1, 1, 0, 0, 0});
  const int two = texture(2, {255, 0, 0, 255, 0, 255, 0, 255}, {{"magFilter", 9728}, {"minFilter", 9728}});
  show(attributes,
       merged(unlit(), {{"emissiveFactor", {1, 1, 1}},
                        {"pbrMetallicRoughness",
                         {{"baseColorTexture",
                           {{"index", two}, {"extensions", {{"KHR_texture_transform", {{"texCoord", 1}}}}}}}}}}));
  draw();
  expectPixel(10, 32, {1, 0, 0});
  expectPixel(50, 32, {0, 1, 0});
}

// Coordinates from -1 to 2: three copies along each axis, by each pair of wrap modes.
TEST_F(GltfPicture, SamplersWrapEachAxisTheirOwnWay) {
  const std::vector<std::uint8_t> texels = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  constexpr int kModes[] = {10497, 33071, 33648};
  const auto wrapped = [](double x, int mode) {
    if (mode == 33071) return std::min(std::max(x, 0.0), 0.999);
    const double whole = std::floor(x), rest = x - whole;
    return mode == 33648 && std::fmod(std::abs(whole), 2.0) == 1.0 ? 1.0 - rest : rest;
  };
  for (const int s : kModes) {
    for (const int t : kModes) {
      glb = GlbBuilder();
      const int four = texture(2, texels, {{"magFilter", 9728}, {"minFilter", 9728}, {"wrapS", s}, {"wrapT", t}});
      show(square({-1, 2, 2, 2, 2, -1, -1, -1}),
           merged(unlit(), {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", four}}}}}}));
      draw();
      for (int y = 2; y < kSize; y += 5) {
        for (int x = 2; x < kSize; x += 5) {
          const double u = wrapped(3.0 * share(x) - 1.0, s), v = wrapped(3.0 * share(y) - 1.0, t);
          const auto at = static_cast<std::size_t>(static_cast<int>(2 * v) * 2 + static_cast<int>(2 * u));
          expectPixel(x, y, glm::vec3(texels[4 * at], texels[4 * at + 1], texels[4 * at + 2]) / 255.0f);
        }
      }
      expectTracedAlike();
    }
  }
}

// Red with alpha 0.5 in the texture and 0.8 as a factor, in front of a green wall.
class GltfAlpha : public GltfPicture {
 protected:
  void drawInFront(const Json& mode) {
    show(square({0, 1, 1, 1, 1, 0, 0, 0}, -1.0f),
         merged(unlit(), {{"pbrMetallicRoughness", {{"baseColorFactor", {0, 1, 0, 1}}}}}));
    const int half = texture(2, {255, 0, 0, 64, 255, 0, 0, 191}, {{"magFilter", 9728}, {"minFilter", 9728}});
    show(square(), merged(merged(unlit(), mode),
                          {{"pbrMetallicRoughness",
                            {{"baseColorFactor", {1, 1, 1, 0.8}}, {"baseColorTexture", {{"index", half}}}}}}));
    draw();
  }
};

TEST_F(GltfAlpha, OpaqueIgnoresIt) {
  drawInFront({{"alphaMode", "OPAQUE"}});
  expectPixel(10, 32, {1, 0, 0});
  expectPixel(50, 32, {1, 0, 0});
}

TEST_F(GltfAlpha, MaskCutsAtHalf) {
  drawInFront({{"alphaMode", "MASK"}});
  expectPixel(10, 32, {0, 1, 0});
  expectPixel(50, 32, {1, 0, 0});  // 0.8 * 191/255 = 0.6
  expectTracedAlike();
}

TEST_F(GltfAlpha, MaskCutsWhereTheFileSays) {
  drawInFront({{"alphaMode", "MASK"}, {"alphaCutoff", 0.61}});
  expectPixel(50, 32, {0, 1, 0});
}

TEST_F(GltfAlpha, BlendCoversByThatMuch) {
  drawInFront({{"alphaMode", "BLEND"}});
  const float left = 0.8f * 64 / 255, right = 0.8f * 191 / 255;
  expectPixel(10, 32, {left, 1.0f - left, 0.0f}, 1e-4f);
  expectPixel(50, 32, {right, 1.0f - right, 0.0f}, 1e-4f);
}

// Three panes, the nearest first in the file.
TEST_F(GltfPicture, PanesCoverEachOtherFromBackToFront) {
  const std::vector<glm::vec3> colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  float z = 0.0f;
  for (const glm::vec3& c : colors) {
    show(square({0, 1, 1, 1, 1, 0, 0, 0}, z),
         merged(unlit(),
                {{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {c.x, c.y, c.z, 0.5}}}}}));
    z -= 0.5f;
  }
  draw();
  expectPixel(32, 32, {0.5f, 0.25f, 0.125f}, 1e-5f);
}

TEST_F(GltfPicture, BacksShowOnDoubleSidedSurfacesOnly) {
  const Json behind = {{"rotation", {0, 1, 0, 0}}};  // turned round the Y axis
  show(square(), merged(unlit(), {{"doubleSided", false}}), behind);
  draw();
  EXPECT_EQ(pixel(32, 32).a, 0.0f);
  glb.json["materials"][0]["doubleSided"] = true;
  draw();
  expectPixel(32, 32, {1, 1, 1});
}

TEST_F(GltfPicture, BacksAreLitByAReversedNormal) {
  show(square(), {{"doubleSided", true}}, {{"rotation", {0, 1, 0, 0}}});
  draw();
  EXPECT_GT(surfaceAt(32, 32).normalWorld.z, 0.9999f);
}

}  // namespace
}  // namespace boxprobe::test
