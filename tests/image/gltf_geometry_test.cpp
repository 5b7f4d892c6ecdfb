// Geometry, lights and cameras of glTF, drawn: known pixels against what the specification says of these files.
#include <gmock/gmock.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "tests/image/gltf_picture.h"

namespace boxprobe::test {
namespace {

class GltfNormals : public GltfPicture {
 protected:
  static constexpr int kNorth = 230;  // of the green channel: a slope towards the picture's top

  int slope() { return oneColor({128, kNorth, 200, 255}); }
  /// The map's vector with x along the picture's right, y along its top.
  static glm::vec3 mapped(float scale = 1.0f) {
    const glm::vec3 v = glm::vec3(128, kNorth, 200) / 255.0f * 2.0f - 1.0f;
    return glm::normalize(v * glm::vec3(scale, scale, 1.0f));
  }
  void expectNormal(const glm::vec3& expected) {
    const glm::vec3 n = surfaceAt(20, 44).normalWorld;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(n[i], expected[i], 2e-5f) << i;
  }
};

TEST_F(GltfNormals, WithoutTangentsInTheFile) {
  show(square(), {{"normalTexture", {{"index", slope()}}}});
  draw();
  expectNormal(mapped());
}

TEST_F(GltfNormals, ScaleIsOfXAndY) {
  show(square(), {{"normalTexture", {{"index", slope()}, {"scale", 0.5}}}});
  draw();
  expectNormal(mapped(0.5f));
}

// The picture turned by a quarter: its top points to the left.
TEST_F(GltfNormals, FollowTheCoordinates) {
  show(square({0, 0, 0, 1, 1, 1, 1, 0}), {{"normalTexture", {{"index", slope()}}}});
  draw();
  // u grows upwards, v to the right: the picture's right is +Y, its top -X.
  expectNormal({-mapped().y, mapped().x, mapped().z});
}

// Mirrored left to right: its top stays the top, its right becomes -X.
TEST_F(GltfNormals, FollowAMirroredPicture) {
  show(square({1, 1, 0, 1, 0, 0, 1, 0}), {{"normalTexture", {{"index", slope()}}}});
  draw();
  expectNormal({-mapped().x, mapped().y, mapped().z});
}

TEST_F(GltfNormals, TangentsOfTheFileAndTheirHandednessCount) {
  Json attributes = square();
  attributes["TANGENT"] = glb.floats("VEC4", 4, {0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1});
  show(attributes, {{"normalTexture", {{"index", slope()}}}});
  draw();
  // Tangent +Y; bitangent -(Z x Y) = +X.
  expectNormal({mapped().y, mapped().x, mapped().z});
}

TEST_F(GltfNormals, FollowANodesUnevenScale) {
  Json attributes = square();
  attributes["TANGENT"] =
      glb.floats("VEC4", 4, {0.6f, 0.8f, 0, 1, 0.6f, 0.8f, 0, 1, 0.6f, 0.8f, 0, 1, 0.6f, 0.8f, 0, 1});
  show(attributes, {{"normalTexture", {{"index", slope()}}}}, {{"scale", {3, 1, 1}}});
  draw();
  const glm::vec3 t = glm::normalize(glm::vec3(1.8f, 0.8f, 0.0f)), b = glm::cross(glm::vec3(0, 0, 1), t);
  const glm::vec3 m = mapped();
  expectNormal(glm::normalize(m.x * t + m.y * b + m.z * glm::vec3(0, 0, 1)));
}

TEST_F(GltfNormals, AreFlatWhereTheFileHasNone) {
  Json attributes = {{"POSITION", glb.floats("VEC3", 3, {-1, -1, 0, 1, -1, 0, 1, 1, 1, -1, 1, 1})}};
  show(attributes, Json::object());
  draw();
  expectNormal(glm::normalize(glm::vec3(0, -1, 2)));
}

// Mirrored by a negative scale: the front stays in front and keeps its own normals.
TEST_F(GltfNormals, StayInFrontUnderANegativeScale) {
  show(square(), {{"normalTexture", {{"index", slope()}}}}, {{"scale", {-1, 1, 1}}});
  draw();
  expectNormal({-mapped().x, mapped().y, mapped().z});
}

// Both halves of a square share the vertices of the middle, whose picture is mirrored across it.
TEST_F(GltfNormals, SplitVerticesWhereThePictureIsMirrored) {
  glb.json["materials"].push_back({{"normalTexture", {{"index", oneColor({230, 128, 200, 255})}}}});
  const Json attributes = {
      {"POSITION", glb.floats("VEC3", 3, {-1, -1, 0, 0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0})},
      {"NORMAL", glb.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1})},
      {"TEXCOORD_0", glb.floats("VEC2", 2, {0, 1, 1, 1, 0, 1, 0, 0, 1, 0, 0, 0})}};
  const int indices = glb.accessor(glb.view(std::vector<std::uint16_t>{0, 1, 4, 0, 4, 5, 1, 2, 3, 1, 3, 4}),
                                   GlbBuilder::UShort, "SCALAR", 12);
  glb.node({{"mesh", glb.mesh({{"attributes", attributes}, {"indices", indices}, {"material", 0}})}});
  draw();
  for (const int x : {2, 16, 30}) EXPECT_GT(surfaceAt(x, 32).normalWorld.x, 0.7f) << x;
  for (const int x : {34, 48, 62}) EXPECT_LT(surfaceAt(x, 32).normalWorld.x, -0.7f) << x;
}

TEST_F(GltfPicture, SparseAccessorsMoveVertices) {
  Json attributes = square();
  const int indices = glb.view(std::vector<std::uint16_t>{1, 2});
  const int values = glb.view(std::vector<float>{0, -1, 0, 0, 1, 0});
  glb.json["accessors"][attributes["POSITION"].get<std::size_t>()]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
      {"values", {{"bufferView", values}}}};
  show(attributes, unlit());
  draw();
  EXPECT_EQ(pixel(30, 32).a, 1.0f);
  EXPECT_EQ(pixel(34, 32).a, 0.0f) << "the right edge has moved to the middle";
}

TEST_F(GltfPicture, NodesMultiply) {
  const int child = show(square(), unlit(), {{"translation", {1, 0, 0}}, {"scale", {0.5, 0.5, 1}}});
  glb.json["scenes"][0]["nodes"] = Json::array();
  glb.node({{"children", {child}}, {"translation", {0, 0.5, 0}}, {"rotation", {0, 0, 1, 0}}});  // half a turn
  draw();
  // Centre (1, 0) turned to (-1, 0) and lifted: x from -1.5 to -0.5, y from 0 to 1.
  EXPECT_EQ(pixel(14, 20).a, 1.0f);
  EXPECT_EQ(pixel(18, 20).a, 0.0f);
  EXPECT_EQ(pixel(14, 34).a, 0.0f);
}

TEST_F(GltfPicture, BuffersAndImagesMayBeFilesOrText) {
  ImageRgba8 red{1, 1, {255, 0, 0, 255}, "red"};
  savePng(file("red picture.png"), red);
  glb.json["images"] = Json::array({{{"uri", "red%20picture.png"}}});
  glb.json["textures"] = Json::array({{{"source", 0}}});
  show(square(), merged(unlit(), {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}));
  write("parts.bin", glb.buffer);
  drawFile(write("model.gltf", glb.gltf("parts.bin")));
  expectPixel(32, 32, {1, 0, 0});
}

// White chalk without a reflection of its own (index 1) under one lamp: albedo / pi times the lamp's irradiance.
class GltfLights : public GltfPicture {
 protected:
  void drawUnder(const Json& light, const Json& node) {
    show(square(),
         {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"extensions", {{"KHR_materials_ior", {{"ior", 1}}}}}});
    glb.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
    glb.node(merged(node, {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}));
    draw();
  }
  static glm::dvec3 place(int x, int y) { return {2.0 * share(x) - 1.0, 1.0 - 2.0 * share(y), 0.0}; }
  void expectIrradiance(int x, int y, double irradiance, const glm::vec3& color = glm::vec3(1.0f)) {
    expectPixel(x, y, color * static_cast<float>(irradiance / glm::pi<double>()),
                2e-5f + 2e-4f * static_cast<float>(irradiance));
  }
};

TEST_F(GltfLights, DirectionalInLux) {
  // Turned by 60 degrees from -Z.
  drawUnder({{"type", "directional"}, {"intensity", 3}, {"color", {1, 0.5, 0.25}}},
            {{"rotation", {0, std::sin(glm::radians(30.0)), 0, std::cos(glm::radians(30.0))}}, {"scale", {2, 2, 2}}});
  expectIrradiance(10, 50, 3.0 * 0.5, {1.0f, 0.5f, 0.25f});
}

TEST_F(GltfLights, PointInCandela) {
  drawUnder({{"type", "point"}, {"intensity", 5}}, {{"translation", {0.25, 0.5, 1.5}}});
  for (const auto& [x, y] : {std::pair(8, 8), std::pair(40, 16), std::pair(60, 62)}) {
    const glm::dvec3 to = glm::dvec3(0.25, 0.5, 1.5) - place(x, y);
    const double d = glm::length(to);
    expectIrradiance(x, y, 5.0 / (d * d) * to.z / d);
  }
}

TEST_F(GltfLights, RangeFadesToNothing) {
  drawUnder({{"type", "point"}, {"intensity", 5}, {"range", 1.6}}, {{"translation", {0.0, 0.0, 1.5}}});
  int dark = 0;
  for (const auto& [x, y] : {std::pair(32, 32), std::pair(40, 28), std::pair(60, 62)}) {
    const glm::dvec3 to = glm::dvec3(0, 0, 1.5) - place(x, y);
    const double d = glm::length(to), window = std::max(std::min(1.0 - std::pow(d / 1.6, 4.0), 1.0), 0.0);
    expectIrradiance(x, y, 5.0 * window / (d * d) * to.z / d);
    dark += window == 0.0 ? 1 : 0;
  }
  EXPECT_EQ(dark, 1);
}

TEST_F(GltfLights, SpotHasTwoCones) {
  const double inner = glm::radians(15.0), outer = glm::radians(35.0);
  drawUnder({{"type", "spot"}, {"intensity", 5}, {"spot", {{"innerConeAngle", inner}, {"outerConeAngle", outer}}}},
            {{"translation", {0.1, 0.0, 1.25}}});
  int whole = 0, dark = 0, between = 0;
  for (int x = 2; x < kSize; x += 4) {
    const glm::dvec3 to = glm::dvec3(0.1, 0.0, 1.25) - place(x, 32);
    const double d = glm::length(to), cosine = to.z / d;
    const double share = std::max(std::min((cosine - std::cos(outer)) / (std::cos(inner) - std::cos(outer)), 1.0), 0.0);
    expectIrradiance(x, 32, 5.0 * share * share / (d * d) * cosine);
    (share >= 1.0 ? whole : share <= 0.0 ? dark : between) += 1;
  }
  EXPECT_GT(whole, 2);
  EXPECT_GT(dark, 1);
  EXPECT_GT(between, 2);
}

TEST_F(GltfPicture, CamerasLookAlongMinusZ) {
  show(square(), unlit());
  glb.json["cameras"] = Json::array(
      {{{"type", "perspective"}, {"name", "eye"}, {"perspective", {{"yfov", 2.0 * std::atan(0.5)}, {"znear", 0.1}}}}});
  glb.node({{"camera", 0}, {"translation", {1, 0, 2}}, {"scale", {5, 5, 5}}});
  ownCamera = true;
  draw();
  EXPECT_EQ(picture->scene.cameras.front().name, "eye");
  // At 2 units' distance the picture is 2 units high: x from 0 to 2, so the square ends in the middle.
  EXPECT_EQ(pixel(30, 32).a, 1.0f);
  EXPECT_EQ(pixel(34, 32).a, 0.0f);
}

TEST_F(GltfPicture, OrthographicCamerasAreHalfAsHighAsYmagSays) {
  show(square(), unlit());
  glb.json["cameras"] = Json::array(
      {{{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", 2}, {"znear", 0.1}, {"zfar", 9}}}}});
  glb.node({{"camera", 0}, {"translation", {0, 0, 2}}});
  ownCamera = true;
  draw();
  EXPECT_EQ(pixel(17, 32).a, 1.0f);
  EXPECT_EQ(pixel(14, 32).a, 0.0f);
  EXPECT_EQ(pixel(32, 46).a, 1.0f);
  EXPECT_EQ(pixel(32, 50).a, 0.0f);
}

TEST_F(GltfPicture, WhatIsNotSupportedIsNamedOnceAndTheRestShows) {
  glb.json["extensionsUsed"] = {"KHR_materials_dispersion", "KHR_materials_unlit", "EXT_made_up"};
  show(square(), unlit());
  show(square({0, 1, 1, 1, 1, 0, 0, 0}, -1.0f), {{"extensions", {{"KHR_materials_dispersion", Json::object()}}}});
  draw();
  expectPixel(32, 32, {1, 1, 1});
  for (const char* name : {"KHR_materials_dispersion", "EXT_made_up"}) {
    EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                            [&](const std::string& w) { return w.find(name) != std::string::npos; }),
              1)
        << name;
  }
}

}  // namespace
}  // namespace boxprobe::test
