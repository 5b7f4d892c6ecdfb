// Shapes and places out of glTF files: number formats, primitive modes, normals, the node tree.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "filters/io/gltf/model_file.h"
#include "tests/unit/io_glb_builder.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using Json = nlohmann::json;
using vec3 = glm::vec3;

class ModelGeometry : public TemporaryFolder {
 protected:
  Model load() const {
    write("m.glb", glb.glb());
    return loadModelFile(file("m.glb"));
  }
  GlbBuilder glb;
};

/// Corner positions in triangle order, whatever the indexing.
std::vector<vec3> corners(const Mesh& mesh) {
  std::vector<vec3> list;
  for (const std::uint32_t index : mesh.indices) list.push_back(mesh.positions.at(index));
  return list;
}

vec3 windingNormal(const Model& model, const Instance& instance) {
  const Mesh& mesh = model.meshes.at(static_cast<std::size_t>(instance.mesh));
  glm::dvec3 p[3];
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = glm::dvec3(instance.worldFromModel * glm::dvec4(mesh.positions[mesh.indices[i]], 1.0));
  }
  return vec3(glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0])));
}

TEST_F(ModelGeometry, ATriangleWithoutIndicesOrNormals) {
  glb.triangle();
  const Model model = load();
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(corners(model.meshes[0]), (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(model.meshes[0].normals, std::vector<vec3>(3, vec3(0, 0, 1)));
  EXPECT_EQ(model.meshes[0].material, -1);
  ASSERT_EQ(model.instances.size(), 1u);
  EXPECT_EQ(model.instances[0].node, "tri");
  EXPECT_EQ(model.instances[0].worldFromModel, glm::dmat4(1.0));
  EXPECT_TRUE(model.warnings.empty());
}

TEST_F(ModelGeometry, IndicesOfEveryUnsignedType) {
  const int positions = glb.floats("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  const int bytes = glb.accessor(glb.view(std::vector<std::uint8_t>{0, 1, 2, 2, 1, 3}), GlbBuilder::UByte, "SCALAR", 6);
  const int shorts =
      glb.accessor(glb.view(std::vector<std::uint16_t>{0, 1, 2, 2, 1, 3}), GlbBuilder::UShort, "SCALAR", 6);
  const int ints = glb.accessor(glb.view(std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3}), GlbBuilder::UInt, "SCALAR", 6);
  for (const int indices : {bytes, shorts, ints}) {
    glb.node({{"mesh", glb.mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}})}});
  }
  const Model model = load();
  ASSERT_EQ(model.meshes.size(), 3u);
  for (const Mesh& mesh : model.meshes) {
    EXPECT_EQ(corners(mesh), (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}));
  }
  EXPECT_EQ(model.triangleCount(), 6u);
}

/// They count neither in the bounds nor among what has to be finite, and morph targets find the others.
TEST_F(ModelGeometry, VerticesThatNothingUsesAreLeftOut) {
  const float far = 1.0e6f, nan = std::nanf("");
  for (const int unused : {1, 9}) {
    for (const double weight : {0.0, 0.5}) {
      glb = GlbBuilder();
      std::vector<float> positions, normals, moves;
      const auto add = [&](const vec3& position, const vec3& move) {
        positions.insert(positions.end(), {position.x, position.y, position.z});
        normals.insert(normals.end(), {0.0f, 0.0f, 1.0f});
        moves.insert(moves.end(), {move.x, move.y, move.z});
      };
      const vec3 used[] = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, moved[] = {{1, 0, 0}, {0, 4, 0}, {0, 0, 6}};
      add({far, -far, 0}, {nan, 0, 0});
      add(used[0], moved[0]);
      add(used[1], moved[1]);
      for (int i = 1; i < unused; ++i) add({nan, 0, 0}, {0, far, 0});
      add(used[2], moved[2]);
      const std::vector<std::uint8_t> order = {static_cast<std::uint8_t>(2 + unused), 1, 2};
      const Json primitive = {
          {"attributes", {{"POSITION", glb.floats("VEC3", 3, positions)}, {"NORMAL", glb.floats("VEC3", 3, normals)}}},
          {"indices", glb.accessor(glb.view(order), GlbBuilder::UByte, "SCALAR", 3)},
          {"targets", Json::array({{{"POSITION", glb.floats("VEC3", 3, moves)}}})}};
      const int mesh = glb.mesh(primitive);
      glb.json["meshes"][static_cast<std::size_t>(mesh)]["weights"] = Json::array({weight});
      glb.node({{"mesh", mesh}});
      const Model model = load();
      ASSERT_EQ(model.meshes.size(), 1u);
      EXPECT_EQ(model.meshes[0].positions.size(), 3u);
      const auto at = [&](std::size_t i) { return used[i] + static_cast<float>(weight) * moved[i]; };
      EXPECT_EQ(corners(model.meshes[0]), (std::vector<vec3>{at(2), at(0), at(1)})) << unused << " " << weight;
    }
  }
}

TEST_F(ModelGeometry, StripsAndFansKeepTheFirstTrianglesWinding) {
  const int strip = glb.floats("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
  const int fan = glb.floats("VEC3", 3, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0});
  glb.node({{"mesh", glb.mesh({{"attributes", {{"POSITION", strip}}}, {"mode", 5}})}});
  glb.node({{"mesh", glb.mesh({{"attributes", {{"POSITION", fan}}}, {"mode", 6}})}});
  const Model model = load();
  for (const Mesh& mesh : model.meshes) {
    EXPECT_EQ(mesh.indices.size(), 9u);
    for (const vec3& normal : mesh.normals) EXPECT_EQ(normal, vec3(0, 0, 1));
  }
}

TEST_F(ModelGeometry, NormalizedAndInterleavedAttributes) {
  // One vertex = position (3 floats), normal (3 normalized bytes and a pad), uv (2 normalized unsigned shorts): 20
  // bytes.
  std::string vertices;
  const auto append = [&vertices](const auto& value) {
    vertices.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  const float positions[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const auto& position : positions) {
    for (const float c : position) append(c);
    for (const std::int8_t c : {0, -128, 0, 99}) append(c);  // -128 and -127 both mean -1
    for (const std::uint16_t c : {65535, 0}) append(c);
  }
  const int view = glb.view(std::vector<char>(vertices.begin(), vertices.end()));
  glb.json["bufferViews"][view]["byteStride"] = 20;
  const int position = glb.accessor(view, GlbBuilder::Float, "VEC3", 3);
  const int normal = glb.accessor(view, GlbBuilder::Byte, "VEC3", 3);
  glb.json["accessors"][normal].merge_patch({{"byteOffset", 12}, {"normalized", true}});
  const int uv = glb.accessor(view, GlbBuilder::UShort, "VEC2", 3);
  glb.json["accessors"][uv].merge_patch({{"byteOffset", 16}, {"normalized", true}});
  glb.node({{"mesh", glb.mesh({{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}}})}});
  const Model model = load();
  const Mesh& mesh = model.meshes.at(0);
  EXPECT_EQ(mesh.positions[1], vec3(1, 0, 0));
  EXPECT_EQ(mesh.normals, std::vector<vec3>(3, vec3(0, -1, 0)));
  EXPECT_EQ(mesh.uv, std::vector<glm::vec2>(3, glm::vec2(1, 0)));
}

TEST_F(ModelGeometry, SparseAccessorsOverDataAndOverZeros) {
  for (const bool overData : {true, false}) {
    const int position = overData ? glb.trianglePositions() : glb.accessor(-1, GlbBuilder::Float, "VEC3", 3);
    const int indices = glb.view(std::vector<std::uint16_t>{1, 2});
    const int values = glb.view(std::vector<float>{5, 0, 0, 0, 7, 0});
    glb.json["accessors"][position]["sparse"] = {{"count", 2},
                                                 {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                                 {"values", {{"bufferView", values}}}};
    glb.node({{"mesh", glb.mesh({{"attributes", {{"POSITION", position}}}})}});
  }
  const Model model = load();
  for (const Mesh& mesh : model.meshes) {
    EXPECT_EQ(mesh.positions, (std::vector<vec3>{{0, 0, 0}, {5, 0, 0}, {0, 7, 0}}));
  }
}

TEST_F(ModelGeometry, GivenNormalsAndTangentsStayAndAreUnit) {
  const int normals = glb.floats("VEC3", 3, {0, 0, 2, 0, 0, 1, 0, 0, 0});
  const int tangents = glb.floats("VEC4", 4, {1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1});
  glb.triangle({{"attributes", {{"NORMAL", normals}, {"TANGENT", tangents}}}});
  const Model model = load();
  EXPECT_EQ(model.meshes[0].normals, (std::vector<vec3>{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
  EXPECT_EQ(model.meshes[0].tangents[0], glm::vec4(1, 0, 0, -1));
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("normals of length 0"), std::string::npos);
}

TEST_F(ModelGeometry, MissingNormalsSplitSharedCorners) {
  // A roof: two triangles that share an edge and must not be smoothed over it.
  const int positions = glb.floats("VEC3", 3, {0, 1, 0, 0, 1, 1, 1, 0, 0, -1, 0, 0});
  const int indices =
      glb.accessor(glb.view(std::vector<std::uint8_t>{0, 1, 2, 1, 0, 3}), GlbBuilder::UByte, "SCALAR", 6);
  const int tangents = glb.floats("VEC4", 4, std::vector<float>(16, 1.0f));
  glb.node(
      {{"mesh", glb.mesh({{"attributes", {{"POSITION", positions}, {"TANGENT", tangents}}}, {"indices", indices}})}});
  const Model model = load();
  const Mesh& mesh = model.meshes.at(0);
  ASSERT_EQ(mesh.positions.size(), 6u);
  EXPECT_NEAR(mesh.normals[0].x, std::sqrt(0.5f), 1e-6f);
  EXPECT_NEAR(mesh.normals[3].x, -std::sqrt(0.5f), 1e-6f);
  EXPECT_TRUE(mesh.tangents.empty());
}

TEST_F(ModelGeometry, PrimitivesBecomeMeshesOfOneNode) {
  const int a = glb.trianglePositions();
  glb.json["materials"] = Json::array({{{"name", "red"}}, {{"name", "blue"}}});
  glb.json["meshes"] =
      Json::array({{{"name", "wall"},
                    {"primitives", Json::array({{{"attributes", {{"POSITION", a}}}, {"material", 1}},
                                                {{"attributes", {{"POSITION", a}}}, {"material", 0}}})}}});
  glb.node({{"mesh", 0}});
  const Model model = load();
  ASSERT_EQ(model.instances.size(), 2u);
  EXPECT_EQ(model.instances[0].node, "wall");  // the mesh's name: the node has none
  EXPECT_EQ(model.instances[1].node, "wall");
  EXPECT_EQ(model.meshes[0].material, 1);
  EXPECT_EQ(model.meshes[1].material, 0);
}

// A file of a few bytes may ask for a million copies in one place.
TEST_F(ModelGeometry, CopiesInOnePlaceAreOne) {
  glb.triangle();
  const int places = glb.floats("VEC3", 3, {0, 0, 0, 1, 2, 3, 0, 0, 0, 4, 0, 0, 1, 2, 3});
  Json& extensions = glb.json["nodes"][0]["extensions"];
  extensions["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = places;
  const Model model = load();
  ASSERT_EQ(model.instances.size(), 3u);
  EXPECT_EQ(model.instances[0].worldFromModel[3], glm::dvec4(0, 0, 0, 1));
  EXPECT_EQ(model.instances[1].worldFromModel[3], glm::dvec4(1, 2, 3, 1));
  EXPECT_EQ(model.instances[2].worldFromModel[3], glm::dvec4(4, 0, 0, 1));
  extensions["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
      glb.accessor(-1, GlbBuilder::Float, "VEC3", 1u << 20);
  EXPECT_EQ(load().instances.size(), 1u);
}

TEST_F(ModelGeometry, NodesWithoutAnyNameAreCounted) {
  const int mesh = glb.mesh({{"attributes", {{"POSITION", glb.trianglePositions()}}}});
  glb.node({{"name", "first"}, {"mesh", mesh}});
  glb.node({{"mesh", mesh}});
  const Model model = load();
  EXPECT_EQ(model.instances[1].node, "node1");
  EXPECT_EQ(model.meshes.size(), 1u);  // shared
}

TEST_F(ModelGeometry, TheNodeTreeMultipliesInDouble) {
  const int mesh = glb.mesh({{"attributes", {{"POSITION", glb.trianglePositions()}}}});
  const double half = std::sqrt(0.5);
  glb.json["nodes"] = Json::array(
      {{{"name", "site"}, {"translation", {1000000.125, 0, 0}}, {"children", {1}}},
       {{"name", "turn"},
        {"rotation", {0, 0, half, half}},
        {"scale", {2, 3, 4}},
        {"children", {2}}},  // 90 degrees about z
       {{"name", "leaf"}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0.25, 0, 1}}, {"mesh", mesh}}});
  glb.json["scenes"] = Json::array({{{"nodes", {0}}}});
  const Model model = load();
  ASSERT_EQ(model.instances.size(), 1u);
  const glm::dvec4 point = model.instances[0].worldFromModel * glm::dvec4(1, 0, 0, 1);
  // (1, 0) + (0.5, 0.25) = (1.5, 0.25); scaled (3, 0.75); turned (-0.75, 3); moved.
  EXPECT_NEAR(point.x, 1000000.125 - 0.75, 1e-9);
  EXPECT_NEAR(point.y, 3.0, 1e-12);
}

TEST_F(ModelGeometry, MirroredNodesKeepTheirFronts) {
  const int normals = glb.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
  const int tangents = glb.floats("VEC4", 4, {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
  const int mesh =
      glb.mesh({{"attributes", {{"POSITION", glb.trianglePositions()}, {"NORMAL", normals}, {"TANGENT", tangents}}}});
  glb.node({{"mesh", mesh}});
  glb.node({{"mesh", mesh}, {"scale", {-1, 1, 1}}});
  glb.node({{"mesh", mesh}, {"scale", {1, -2, 1}}});
  glb.node({{"mesh", mesh}, {"scale", {-1, -1, 1}}});  // a turn, not a mirror
  const Model model = load();
  ASSERT_EQ(model.instances.size(), 4u);
  for (const Instance& instance : model.instances) EXPECT_EQ(windingNormal(model, instance), vec3(0, 0, 1));
  EXPECT_EQ(model.meshes.size(), 2u);  // the mirrored copy is made once
  EXPECT_EQ(model.instances[3].mesh, model.instances[0].mesh);
  EXPECT_EQ(model.meshes[1].tangents[0].w, -1.0f);
}

TEST_F(ModelGeometry, OnlyTheDefaultSceneIsShown) {
  const int mesh = glb.mesh({{"attributes", {{"POSITION", glb.trianglePositions()}}}});
  glb.json["nodes"] = Json::array({{{"name", "a"}, {"mesh", mesh}}, {{"name", "b"}, {"mesh", mesh}}});
  glb.json["scenes"] = Json::array({{{"nodes", {0}}}, {{"nodes", {1}}}});
  glb.json["scene"] = 1;
  const Model second = load();
  EXPECT_EQ(second.instances.at(0).node, "b");
  ASSERT_EQ(second.warnings.size(), 1u);
  EXPECT_EQ(second.warnings[0], "has 2 scenes, of which the default one is shown");
  glb.json.erase("scenes");
  glb.json.erase("scene");
  EXPECT_EQ(load().instances.size(), 2u);  // no scenes: all roots
}

TEST_F(ModelGeometry, DeepTreesDoNotExhaustTheStack) {
  const int mesh = glb.mesh({{"attributes", {{"POSITION", glb.trianglePositions()}}}});
  constexpr int kDepth = 50000;
  for (int i = 0; i < kDepth; ++i) {
    glb.json["nodes"].push_back({{"children", {i + 1}}, {"translation", {1, 0, 0}}});
  }
  glb.json["nodes"].push_back({{"name", "deep"}, {"mesh", mesh}});
  glb.json["scenes"] = Json::array({{{"nodes", {0}}}});
  EXPECT_EQ(load().instances.at(0).worldFromModel[3].x, kDepth);
}

TEST_F(ModelGeometry, TextFilesWithBuffersBesideThemAndDataUris) {
  glb.triangle();
  write("sub dir/m.gltf", glb.gltf("my%20data.bin"));
  write("sub dir/my data.bin", glb.buffer);
  EXPECT_EQ(loadModelFile(file("sub dir/m.gltf")).triangleCount(), 1u);
  GlbBuilder empty;
  // 36 bytes: three positions (0, 0, 0), (1, 0, 0), (0, 1, 0).
  const std::string data = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  empty.triangle();
  empty.json["bufferViews"][0]["byteLength"] = 36;
  write("data.gltf", empty.gltf(data));
  EXPECT_EQ(corners(loadModelFile(file("data.gltf")).meshes.at(0))[2], vec3(0, 1, 0));
  write("data.gltf", empty.gltf("DATA:Application/Octet-Stream;Base64," + data.substr(data.find(',') + 1)));
  EXPECT_EQ(corners(loadModelFile(file("data.gltf")).meshes.at(0))[2], vec3(0, 1, 0)) << "schemes in capitals";
}

// Between keys with tangents lies a cubic: here by its Bezier points, halved towards each other.
TEST_F(ModelGeometry, AnAnimationFollowsItsTangents) {
  glb.triangle();
  const int times = glb.floats("SCALAR", 1, {1.5f, 4.0f});
  const vec3 in0(9, 8, 7), a(1, -2, 0.5f), out0(0.7f, -1.3f, 2.9f), in1(-1.9f, 0.6f, 1.1f), b(3, 4, -1), out1(5, 6, 4);
  std::vector<float> keys;
  for (const vec3& key : {in0, a, out0, in1, b, out1}) keys.insert(keys.end(), {key.x, key.y, key.z});
  const int moves = glb.floats("VEC3", 3, keys);
  glb.json["animations"] = Json::array(
      {{{"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}})},
        {"samplers", Json::array({{{"input", times}, {"output", moves}, {"interpolation", "CUBICSPLINE"}}})}}});
  write("moving.glb", glb.glb());
  for (const double time : {1.5, 2.25, 3.5, 4.0}) {
    ModelState state;
    state.seconds = time;
    const Model model = loadModelFile(file("moving.glb"), {}, state);
    const double t = (time - 1.5) / 2.5;
    std::vector<glm::dvec3> points = {glm::dvec3(a), glm::dvec3(a) + 2.5 / 3.0 * glm::dvec3(out0),
                                      glm::dvec3(b) - 2.5 / 3.0 * glm::dvec3(in1), glm::dvec3(b)};
    for (std::size_t left = 3; left > 0; --left) {
      for (std::size_t i = 0; i < left; ++i) points[i] = (1.0 - t) * points[i] + t * points[i + 1];
    }
    const glm::dvec3 place(model.instances.at(0).worldFromModel[3]);
    EXPECT_LT(glm::length(place - points[0]), 1e-6) << time;
  }
}

// The triangle stands 5 before the camera, from 0 to 1 in x and y.
TEST_F(ModelGeometry, ManyCamerasOfOneNameAreCounted) {
  constexpr int kCount = 4000;
  glb.json["cameras"] = Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}});
  for (int i = 0; i < kCount; ++i) glb.node({{"camera", 0}, {"name", i == 1 ? "a 3" : "a"}});
  const Model model = load();
  ASSERT_EQ(model.cameras.size(), std::size_t(kCount));
  const std::vector<std::string> first = {"a", "a 3", "a 2", "a 4"};
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(model.cameras[i].name, first[i]);
  EXPECT_EQ(model.cameras.back().name, "a " + std::to_string(kCount));
}

TEST_F(ModelGeometry, PlanesThatCutTheModelAreNamed) {
  glb.triangle();
  glb.json["nodes"].push_back({{"camera", 0}, {"translation", {0.3, 0.3, 5.0}}, {"name", "cut"}});
  if (glb.json.contains("scenes")) glb.json["scenes"][0]["nodes"].push_back(glb.json["nodes"].size() - 1);
  const auto warningsWith = [&](const Json& camera) {
    glb.json["cameras"] = Json::array({camera});
    return load().warnings;
  };
  const auto perspective = [](double near, double far) {
    return Json{{"type", "perspective"}, {"perspective", {{"yfov", 0.6}, {"znear", near}, {"zfar", far}}}};
  };
  EXPECT_TRUE(warningsWith(perspective(0.1, 20.0)).empty());
  ASSERT_EQ(warningsWith(perspective(6.0, 20.0)).size(), 1u);
  EXPECT_EQ(
      warningsWith(perspective(6.0, 20.0))[0],
      "has cameras whose near or far plane cuts off a part of the model, which is drawn all the same (cut: 6 to 20)");
  EXPECT_EQ(warningsWith(perspective(0.1, 4.0)).size(), 1u);
  const Json parallel = {{"type", "orthographic"},
                         {"orthographic", {{"xmag", 16.0 / 9}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 4.5}}}};
  EXPECT_EQ(warningsWith(parallel).size(), 1u);
  glb.json["nodes"].back()["translation"] = {100.3, 0.3, 5.0};
  EXPECT_TRUE(warningsWith(perspective(6.0, 20.0)).empty()) << "what a camera does not see is not cut off";
}

TEST_F(ModelGeometry, ACameraOfAnotherShapeIsNamed) {
  glb.triangle();
  glb.json["nodes"].push_back({{"camera", 0}, {"translation", {0.3, 0.3, 5.0}}, {"name", "film"}});
  if (glb.json.contains("scenes")) glb.json["scenes"][0]["nodes"].push_back(glb.json["nodes"].size() - 1);
  const auto warningsOf = [&](const Json& camera) {
    glb.json["cameras"] = Json::array({camera});
    return load().warnings;
  };
  const auto perspective = [](double aspect) {
    return Json{{"type", "perspective"}, {"perspective", {{"yfov", 0.6}, {"znear", 0.1}, {"aspectRatio", aspect}}}};
  };
  EXPECT_TRUE(warningsOf(perspective(1.7778)).empty());
  const std::string wide = "has a camera whose picture is not 16:9 (film); render it with --size 1692x720";
  EXPECT_EQ(warningsOf(perspective(2.35)), std::vector<std::string>{wide});
  const std::string square = "has a camera whose picture is not 16:9 (film); render it with --size 720x720";
  EXPECT_EQ(warningsOf(
                {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 3}, {"znear", 0.1}, {"zfar", 20}}}}),
            std::vector<std::string>{square});
}

TEST_F(ModelGeometry, WhatIsNotSupportedIsNamedOnce) {
  const int positions = glb.trianglePositions();
  const Json attributes = {{"POSITION", positions}, {"COLOR_1", positions}};
  glb.json["meshes"] = Json::array(
      {{{"primitives", Json::array({{{"attributes", attributes}, {"targets", Json::array({{{"POSITION", positions}}})}},
                                    {{"attributes", attributes}},
                                    {{"attributes", {{"POSITION", positions}}}, {"mode", 1}}})}}});
  glb.json["skins"] = Json::array({{{"joints", {0}}}});
  glb.json["extensionsUsed"] = {"KHR_materials_dispersion", "KHR_materials_unlit", "KHR_xmp"};
  glb.node({{"mesh", 0}, {"skin", 0}});
  const int times = glb.floats("SCALAR", 1, {0, 1});
  const int moves = glb.floats("VEC3", 3, {0, 0, 0, 1, 0, 0});
  glb.json["animations"] =
      Json::array({{{"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}})},
                    {"samplers", Json::array({{{"input", times}, {"output", moves}}})}}});
  const Model model = load();
  EXPECT_EQ(model.instances.size(), 2u);
  std::string all;
  for (const std::string& warning : model.warnings) all += warning + "\n";
  EXPECT_EQ(model.warnings.size(), 4u) << all;
  for (const char* word : {"KHR_materials_dispersion", "KHR_xmp", "COLOR_1", "lines"}) {
    EXPECT_NE(all.find(word), std::string::npos) << word;
  }
}

TEST_F(ModelGeometry, ExtensionsThatTheFileDoesNotListAreNamed) {
  glb.triangle();
  glb.json["nodes"][0]["extensions"]["KHR_node_visibility"] = {{"visible", false}};
  glb.json["nodes"][0]["extras"]["extensions"]["ACME_own"] = Json::object();
  glb.json["materials"] = Json::array({{{"extensions", {{"KHR_materials_unlit", Json::object()}}}}});
  glb.json["extensions"]["ACME_lights"] = {{"list", Json::array({{{"extensions", {{"ACME_rays", 1}}}}})}};
  EXPECT_EQ(load().warnings,
            (std::vector<std::string>{"uses the extension ACME_lights, which is not supported and is ignored",
                                      "uses the extension ACME_rays, which is not supported and is ignored",
                                      "uses the extension KHR_node_visibility, which is not supported: every node is "
                                      "drawn"}));
}

}  // namespace
}  // namespace boxprobe
