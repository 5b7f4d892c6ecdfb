// Broken glTF files: each must be refused in one line that names file and place, never read out of bounds.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <type_traits>

#include "filters/io/gltf/gltf_chunks.h"
#include "filters/io/gltf/gltf_parts.h"
#include "filters/io/gltf/model_file.h"
#include "tests/unit/error_text.h"
#include "tests/unit/io_glb_builder.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using Json = nlohmann::json;

class ModelDamage : public TemporaryFolder {
 protected:
  /// The message, without the file it must start with, for a sound file of an indexed triangle after `damage`.
  std::string problem(const std::function<void(GlbBuilder&)>& damage) const {
    GlbBuilder glb;
    const int indices = glb.accessor(glb.view(std::vector<std::uint16_t>{0, 1, 2, 0}), GlbBuilder::UShort, "SCALAR", 3);
    glb.triangle({{"indices", indices}});  // accessor 0: indices, view 0; accessor 1: positions, view 1; node 0
    damage(glb);
    return fileProblem(glb.glb());
  }
  std::string fileProblem(const std::string& bytes) const {
    const std::string path = write("m.glb", bytes);
    const std::string text = errorText([&] { loadModelFile(path); });
    EXPECT_EQ(text.rfind(path + ":", 0), 0u) << text;
    return text.substr(std::min(text.size(), path.size() + 2));
  }
};

TEST_F(ModelDamage, TheUndamagedFileLoads) {
  GlbBuilder glb;
  glb.triangle();
  EXPECT_EQ(loadModelFile(write("m.glb", glb.glb())).triangleCount(), 1u);
}

TEST_F(ModelDamage, AccessorsThatLeaveTheirViewsAreRefused) {
  EXPECT_EQ(
      problem([](GlbBuilder& g) { g.json["accessors"][1]["count"] = 4; }),
      "mesh 0 \"mesh0\": primitive 0: POSITION: accessor 1: 4 elements from byte 0 do not fit into bufferView 1 of 36 "
      "bytes; the file is damaged");
  const std::vector<std::function<void(GlbBuilder&)>> cases = {
      [](GlbBuilder& g) { g.json["accessors"][1]["count"] = 4294967295u; },
      [](GlbBuilder& g) { g.json["accessors"][1]["count"] = 18446744073709551615u; },
      [](GlbBuilder& g) { g.json["accessors"][1]["count"] = 1537228672809129302u; },  // times 12 overflows to little
      [](GlbBuilder& g) { g.json["accessors"][1]["byteOffset"] = 4; },
      [](GlbBuilder& g) { g.json["accessors"][1]["byteOffset"] = 18446744073709551612u; },
      [](GlbBuilder& g) { g.json["accessors"][1]["bufferView"] = 7; },
      [](GlbBuilder& g) { g.json["accessors"][1]["componentType"] = 5124; },
      [](GlbBuilder& g) { g.json["accessors"][1]["componentType"] = 5130; },
      [](GlbBuilder& g) { g.json["accessors"][1]["type"] = "VEC2"; },
      [](GlbBuilder& g) { g.json["accessors"][1]["type"] = "MAT4"; },
      [](GlbBuilder& g) { g.json["accessors"][0]["type"] = "VEC3"; },
      [](GlbBuilder& g) { g.json["accessors"][0]["componentType"] = 5126; },
      [](GlbBuilder& g) { g.json["accessors"][0]["bufferView"] = 9; },
      [](GlbBuilder& g) { g.json["bufferViews"][1]["byteOffset"] = 400; },
      [](GlbBuilder& g) { g.json["bufferViews"][1]["byteOffset"] = 18446744073709551612u; },
      [](GlbBuilder& g) { g.json["bufferViews"][1]["byteLength"] = 18446744073709551615u; },
      [](GlbBuilder& g) { g.json["bufferViews"][1]["buffer"] = 3; },
      [](GlbBuilder& g) { g.json["bufferViews"][1]["buffer"] = -1; },
      [](GlbBuilder& g) { g.json["bufferViews"][1]["byteStride"] = 4; },
      [](GlbBuilder& g) { g.json["bufferViews"][1]["byteStride"] = 3; },
      [](GlbBuilder& g) { g.json["accessors"][1].erase("bufferView"), g.json["accessors"][1]["count"] = 1u << 30; },
  };
  for (std::size_t i = 0; i < cases.size(); ++i) EXPECT_NE(problem(cases[i]), "") << "case " << i;
}

TEST_F(ModelDamage, SparsePartsAreCheckedAlike) {
  const auto sparse = [](const Json& change) {
    return [change](GlbBuilder& g) {
      const int indices = g.view(std::vector<std::uint16_t>{1, 9});
      const int values = g.view(std::vector<float>{5, 0, 0, 0, 7, 0});
      Json part = {{"count", 1},
                   {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                   {"values", {{"bufferView", values}}}};
      part.merge_patch(change);
      g.json["accessors"][1]["sparse"] = part;
    };
  };
  EXPECT_EQ(problem(sparse({{"count", 2}})),
            "mesh 0 \"mesh0\": primitive 0: POSITION: accessor 1: sparse index 9 is beyond its 3 elements");
  for (const Json& change : std::vector<Json>{{{"count", 3}},
                                              {{"count", 4}},
                                              {{"count", -1}},
                                              {{"indices", {{"componentType", 5126}}}},
                                              {{"indices", {{"bufferView", 99}}}},
                                              {{"indices", {{"byteOffset", 3}}}},
                                              {{"values", {{"bufferView", -7}}}},
                                              {{"values", {{"byteOffset", 100}}}}}) {
    EXPECT_NE(problem(sparse(change)), "") << change;
  }
  // tinygltf from 2.9 on reads a negative offset as 0.
  if constexpr (std::is_signed_v<decltype(tinygltf::Accessor{}.sparse.indices.byteOffset)>) {
    EXPECT_NE(problem(sparse({{"indices", {{"byteOffset", -2}}}})), "");
  }
}

TEST_F(ModelDamage, IndicesBeyondThePositionsAreRefused) {
  EXPECT_EQ(problem([](GlbBuilder& g) { g.buffer[2] = 7; }),
            "mesh 0 \"mesh0\": primitive 0: indices: index 1 is 7, but there are 3 positions; the file is damaged");
  EXPECT_NE(problem([](GlbBuilder& g) { g.buffer[0] = g.buffer[1] = '\xff'; }), "");
}

TEST_F(ModelDamage, NumbersThatAreNotFiniteAreRefused) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(problem([bad](GlbBuilder& g) { std::memcpy(g.buffer.data() + 8 + 16, &bad, 4); }),
              "mesh 0 \"mesh0\": primitive 0: POSITION: accessor 1: element 1 is not finite; repair the model");
  }
}

TEST_F(ModelDamage, PositionsOutOfReachAreRefusedAlongEachAxis) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float far = axis == 1 ? -3e18f : 2e18f;
    EXPECT_EQ(problem([=](GlbBuilder& g) { std::memcpy(g.buffer.data() + 8 + 12 + 4 * axis, &far, 4); }),
              "mesh 0 \"mesh0\": primitive 0: POSITION: entry 1 lies beyond 1e18; repair the model");
  }
}

TEST_F(ModelDamage, ReferencesToNothingAreRefused) {
  EXPECT_EQ(problem([](GlbBuilder& g) { g.json["nodes"][0]["mesh"] = 4; }),
            "node 0 \"tri\": mesh 4 does not exist; the file has 1");
  EXPECT_EQ(problem([](GlbBuilder& g) { g.json["nodes"][0]["children"] = {8}; }),
            "node 0 \"tri\": node 8 does not exist; the file has 1");
  EXPECT_EQ(problem([](GlbBuilder& g) { g.json["scene"] = 5; }), "scene: scene 5 does not exist; the file has 1");
  EXPECT_EQ(problem([](GlbBuilder& g) { g.json["meshes"][0]["primitives"][0]["indices"] = -5; }),
            "mesh 0 \"mesh0\": primitive 0: indices must be the number of an accessor");
  EXPECT_EQ(problem([](GlbBuilder& g) { g.json["meshes"][0]["primitives"][0]["material"] = 2; }),
            "mesh 0 \"mesh0\": primitive 0: material 2 does not exist; the file has 0");
  EXPECT_EQ(problem([](GlbBuilder& g) { g.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 44; }),
            "mesh 0 \"mesh0\": primitive 0: NORMAL: accessor 44 does not exist; the file has 2");
  EXPECT_EQ(problem([](GlbBuilder& g) {
              g.json["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"),
                  g.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 1;
            }),
            "mesh 0 \"mesh0\": primitive 0: has no POSITION attribute; export it again");
  const std::vector<Json> textures = {{{"materials", Json::array({{{"emissiveTexture", {{"index", 3}}}}})}},
                                      {{"materials", Json::array({{{"emissiveTexture", {{"index", 0}}}}})},
                                       {"textures", Json::array({{{"source", 3}}})}},
                                      {{"materials", Json::array({{{"emissiveTexture", {{"index", 0}}}}})},
                                       {"textures", Json::array({{{"sampler", 3}}})}},
                                      {{"materials", Json::array({{{"emissiveTexture", {{"index", 0}}}}})},
                                       {"textures", Json::array({{{"source", 0}}})},
                                       {"images", Json::array({{{"bufferView", 8}, {"mimeType", "image/png"}}})}}};
  for (const Json& change : textures) {
    EXPECT_NE(problem([&](GlbBuilder& g) { g.json.merge_patch(change); }), "") << change;
  }
}

TEST_F(ModelDamage, AttributesOfAnotherLengthAreRefused) {
  EXPECT_EQ(problem([](GlbBuilder& g) {
              const int two = g.floats("VEC3", 3, {0, 0, 1, 0, 0, 1});
              g.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = two;
            }),
            "mesh 0 \"mesh0\": primitive 0: NORMAL: has 2 entries for 3 positions");
}

TEST_F(ModelDamage, NodesInCirclesOrWithTwoParentsAreRefused) {
  const std::string self = problem([](GlbBuilder& g) { g.json["nodes"][0]["children"] = {0}; });
  EXPECT_EQ(self, "node 0 \"tri\": stands in the tree twice, or is its own ancestor; repair the model");
  EXPECT_NE(problem([](GlbBuilder& g) {
              g.json["nodes"] = Json::array({{{"children", {1}}}, {{"children", {2}}}, {{"children", {1}}}});
            }),
            "");
  EXPECT_NE(problem([](GlbBuilder& g) {
              g.json["nodes"] = Json::array({{{"children", {1, 2}}}, {{"children", {2}}}, {{"name", "shared"}}});
            }),
            "");
}

TEST_F(ModelDamage, TransformsAreChecked) {
  EXPECT_EQ(problem([](GlbBuilder& g) {
              g.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
            }),
            "node 0 \"tri\": rotation is a quaternion of length 0; repair the model");
  EXPECT_EQ(problem([](GlbBuilder& g) {
              g.json["nodes"][0]["translation"] = {0, 0};
            }),
            "node 0 \"tri\": translation must have 3 numbers");
  EXPECT_NE(problem([](GlbBuilder& g) { g.json["nodes"][0]["matrix"] = {1, 0, 0}; }), "");
}

TEST_F(ModelDamage, MessagesStayOneLineWhateverNamesHold) {
  EXPECT_EQ(problem([](GlbBuilder& g) {
              g.json["nodes"][0].merge_patch({{"name", "two\nlines"}, {"mesh", 4}});
            }),
            "node 0 \"two lines\": mesh 4 does not exist; the file has 1");
}

TEST_F(ModelDamage, RequiredExtensionsMustBeKnown) {
  EXPECT_EQ(problem([](GlbBuilder& g) { g.json["extensionsRequired"] = {"ACME_cubes"}; }),
            "extensionsRequired: needs ACME_cubes, which is not supported; export without it");
  EXPECT_EQ(problem([](GlbBuilder& g) { g.json["asset"]["version"] = "1.0"; }),
            "asset: is glTF version \"1.0\"; export it as glTF 2.0");
}

TEST_F(ModelDamage, ContainersThatAreCutOffOrOtherwiseWrong) {
  GlbBuilder glb;
  glb.triangle();
  const std::string whole = glb.glb();
  for (std::size_t length = 0; length < whole.size(); length += 3) EXPECT_NE(fileProblem(whole.substr(0, length)), "");
  std::string version = whole;
  version[4] = 1;
  EXPECT_EQ(fileProblem(version), "is GLB version 1, not 2; export it again");
  std::string chunk = whole;
  chunk[12] = chunk[13] = chunk[14] = '\x7f';
  EXPECT_NE(fileProblem(chunk).find("runs past the end; export it again"), std::string::npos);
  EXPECT_NE(fileProblem("this is text"), "");
  EXPECT_NE(fileProblem("{}"), "");
  EXPECT_NE(fileProblem("[1, 2]"), "");
  EXPECT_NE(fileProblem("{\"asset\": {\"version\": \"2.0\"}, \"extras\": " + std::string(100000, '[')), "");
  EXPECT_NE(fileProblem("{\"asset\": {\"version\": \"2.0\"}, \"extras\": " + std::string(100000, '[') +
                        std::string(100000, ']') + "}"),
            "");
}

TEST_F(ModelDamage, SyntaxErrorsOfTextFilesHaveTheirPlace) {
  const std::string path = write("m.gltf", "{\n \"asset\": {\"version\" \"2.0\"}\n}");
  const std::string text = errorText([&] { loadModelFile(path); });
  EXPECT_EQ(text.rfind(path + ":2:22: not valid JSON: ", 0), 0u) << text;
}

TEST_F(ModelDamage, FilesThatAreMissingOrOfAnotherKindAreNamed) {
  EXPECT_EQ(errorText([&] { loadModelFile(file("gone.glb")); }), file("gone.glb") + ": does not exist; check the path");
  EXPECT_EQ(errorText([&] { loadModelFile(file("a.obj")); }),
            file("a.obj") + ": .obj files are not supported; export the model as glTF (.glb or .gltf)");
  GlbBuilder glb;
  glb.triangle();
  const std::string path = write("m.gltf", glb.gltf("gone.bin"));
  EXPECT_EQ(errorText([&] { loadModelFile(path); }),
            path + ": " + file("gone.bin") + ": does not exist; check the path");
}

TEST_F(ModelDamage, OnlyTheFirstBufferIsTheBinaryChunk) {
  GlbBuilder glb;
  glb.triangle();
  glb.json["extras"] = std::string(100, 'x');  // gives way to the second buffer
  std::string bytes = glb.glb();
  const std::string from = R"("buffers":[{"byteLength":36}],"extras":")" + std::string(100, 'x') + '"';
  std::string to = R"("buffers":[{"byteLength":36},{"byteLength":36}])";
  to.resize(from.size(), ' ');
  ASSERT_NE(bytes.find(from), std::string::npos);
  bytes.replace(bytes.find(from), from.size(), to);
  EXPECT_EQ(fileProblem(bytes), "buffer 1: has no uri, and only buffer 0 may be the binary chunk; export it again");
}

TEST_F(ModelDamage, ManyDifferentWarningsAreEachAddedOnce) {
  GlbBuilder glb;
  glb.triangle();
  constexpr int kCount = 30000;
  for (const int round : {0, 1}) {
    for (int i = 0; i < kCount; ++i) glb.json["extensionsUsed"].push_back("ACME_" + std::to_string(i + round));
  }
  EXPECT_EQ(loadModelFile(write("m.glb", glb.glb())).warnings.size(), kCount + 1u);
}

/// Small files that name the same bytes many times, or bytes that unpack to many: no single use is beyond a limit.
class RepeatedData : public ModelDamage {
 protected:
  RepeatedData() { readBudgetBytes() = 1 << 20; }
  ~RepeatedData() override { readBudgetBytes() = usual_; }
  void expectTooMuch(const std::string& text, const std::string& place) const {
    EXPECT_EQ(text.rfind(place, 0), 0u) << text;
    EXPECT_NE(text.find(": comes, with all before it, to more than 0.00"), std::string::npos) << text;
    EXPECT_NE(text.find(" bytes may become on this machine; split the file, or let fewer parts share the same data"),
              std::string::npos)
        << text;
  }
  static Json::array_t copies(std::size_t count, const Json& of) { return Json::array_t(count, of); }

 private:
  const std::uint64_t usual_ = readBudgetBytes();
};

TEST_F(RepeatedData, OfPrimitivesThatSharePositions) {
  expectTooMuch(problem([](GlbBuilder& g) {
                  const int many = g.floats("VEC3", 3, std::vector<float>(9000));
                  g.json["meshes"][0]["primitives"] = copies(200, {{"attributes", {{"POSITION", many}}}});
                }),
                "mesh 0 \"mesh0\": primitive ");
}

TEST_F(RepeatedData, OfPrimitivesThatShareAnAccessorWithoutBytes) {
  constexpr std::size_t kZeros = 1 << 14;
  const auto zeros = [](std::size_t primitives) {
    return [primitives](GlbBuilder& g) {
      const int many = g.accessor(-1, GlbBuilder::Float, "VEC3", kZeros);
      g.json["meshes"][0]["primitives"] = copies(primitives, {{"attributes", {{"POSITION", many}, {"NORMAL", many}}}});
    };
  };
  expectTooMuch(problem(zeros(20)), "mesh 0 \"mesh0\": primitive 2: POSITION: accessor 2: comes");
  readBudgetBytes() = 0;  // no limit
  GlbBuilder glb;
  glb.accessor(glb.view(std::vector<std::uint16_t>{0, 1, 2, 0}), GlbBuilder::UShort, "SCALAR", 3);
  glb.triangle();
  zeros(1)(glb);
  EXPECT_EQ(loadModelFile(write("m.glb", glb.glb())).triangleCount(), kZeros / 3);
}

/// Each of them reads its own vertices, not all.
TEST_F(RepeatedData, PrimitivesThatUseFewOfManyVerticesAreRead) {
  constexpr std::size_t kVertices = 1 << 14, kPrimitives = 500;
  const auto vertex = [](std::size_t i) {
    const auto x = static_cast<float>(i);
    return glm::vec3(x, 2.0f * x + 1.0f, 0.5f * x - 3.0f);
  };
  std::vector<float> positions, normals, uv;
  for (std::size_t i = 0; i < kVertices; ++i) {
    const glm::vec3 p = vertex(i), n = glm::normalize(p + glm::vec3(0.0f, 5.0f, 0.0f));
    positions.insert(positions.end(), {p.x, p.y, p.z});
    normals.insert(normals.end(), {n.x, n.y, n.z});
    uv.insert(uv.end(), {p.x / 7.0f, p.y});
  }
  GlbBuilder glb;
  glb.triangle();
  const Json attributes = {{"POSITION", glb.floats("VEC3", 3, positions)},
                           {"NORMAL", glb.floats("VEC3", 3, normals)},
                           {"TEXCOORD_0", glb.floats("VEC2", 2, uv)}};
  const std::uint32_t first = 7, second = 4, third = 9;  // of primitive 0, and not in order
  Json primitives = Json::array();
  for (std::uint32_t p = 0; p < kPrimitives; ++p) {
    const std::vector<std::uint32_t> corners = {first + 13 * p, second + 13 * p, third + 13 * p};
    const int indices = glb.accessor(glb.view(corners), GlbBuilder::UInt, "SCALAR", 3);
    primitives.push_back({{"attributes", attributes}, {"indices", indices}});
  }
  glb.json["meshes"][0]["primitives"] = primitives;
  const Model model = loadModelFile(write("m.glb", glb.glb()));
  ASSERT_EQ(model.meshes.size(), kPrimitives);
  for (std::size_t p = 0; p < kPrimitives; ++p) {
    const Mesh& mesh = model.meshes[p];
    ASSERT_EQ(mesh.positions.size(), 3u);
    ASSERT_EQ(mesh.indices.size(), 3u);
    const std::uint32_t corners[] = {first, second, third};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t from = corners[c] + 13 * p;
      EXPECT_EQ(mesh.positions[mesh.indices[c]], vertex(from));
      EXPECT_EQ(mesh.uv[mesh.indices[c]], glm::vec2(uv[2 * from], uv[2 * from + 1]));
      EXPECT_NEAR(mesh.normals[mesh.indices[c]].z, normals[3 * from + 2], 1e-6f);
    }
  }
}

TEST_F(RepeatedData, OfMorphTargets) {
  expectTooMuch(
      problem([](GlbBuilder& g) {
        const int many = g.floats("VEC3", 3, std::vector<float>(9000));
        Json& mesh = g.json["meshes"][0];
        mesh["weights"] = std::vector<double>(200, 0.5);
        mesh["primitives"][0] = {{"attributes", {{"POSITION", many}}}, {"targets", copies(200, {{"POSITION", many}})}};
      }),
      "mesh 0 \"mesh0\": primitive 0: target ");
}

TEST_F(RepeatedData, OfNodesThatShareASkin) {
  expectTooMuch(problem([](GlbBuilder& g) {
                  std::vector<int> joints;
                  for (int i = 0; i < 300; ++i) joints.push_back(g.node(Json::object()));
                  g.json["skins"] = Json::array({{{"joints", joints}}});
                  for (int i = 0; i < 100; ++i) g.node({{"mesh", 0}, {"skin", 0}});
                }),
                "node 3");
}

TEST_F(RepeatedData, OfMeshoptViews) {
  expectTooMuch(problem([](GlbBuilder& g) {
                  // A hundred blocks of 256 vertices, 2 bits of which say that all their bytes are 0.
                  constexpr std::size_t kBlocks = 100;
                  std::vector<std::uint8_t> stream(1 + 16 * kBlocks + 32);
                  stream[0] = 0xa0;
                  Json view = g.json["bufferViews"][g.view(stream)];
                  view["extensions"]["EXT_meshopt_compression"] = {
                      {"buffer", 0},     {"byteOffset", view["byteOffset"]}, {"byteLength", stream.size()},
                      {"byteStride", 4}, {"count", 256 * kBlocks},           {"mode", "ATTRIBUTES"}};
                  for (int i = 0; i < 50; ++i) g.json["bufferViews"].push_back(view);
                }),
                "bufferView 1");
}

TEST_F(RepeatedData, OfDracoStreams) {
  std::ifstream stream(BOXPROBE_SOURCE_DIR "/tests/unit/models/torus-draco.glb", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const Chunks chunks = chunksOf(bytes, "torus-draco.glb");
  GlbBuilder glb;
  glb.json = Json::parse(chunks.json);
  glb.buffer.assign(reinterpret_cast<const char*>(chunks.binary.data), chunks.binary.size);
  EXPECT_GT(loadModelFile(write("m.glb", glb.glb())).triangleCount(), 100u);
  Json& primitives = glb.json["meshes"][0]["primitives"];
  primitives = copies(200, Json(primitives[0]));
  expectTooMuch(fileProblem(glb.glb()), "mesh 0 \"");
}

TEST_F(RepeatedData, OfBuffersOfOneFile) {
  GlbBuilder glb;
  glb.triangle();
  glb.buffer.resize(20000);
  write("data.bin", glb.buffer);
  const auto text = [&glb](int count) {
    Json whole = glb.json;
    for (int i = 0; i < count; ++i) {
      whole["buffers"].push_back({{"byteLength", 20000}, {"uri", i % 2 == 0 ? "data.bin" : ".//%64ata.bin"}});
    }
    return whole.dump();
  };
  EXPECT_EQ(loadModelFile(write("m.gltf", text(10))).triangleCount(), 1u);
  expectTooMuch(fileProblem(text(100)), "buffer ");
}

/// Whatever the machine's memory is.
TEST_F(RepeatedData, FilesThatNameTheirBytesOnceAreRead) {
  readBudgetBytes() = 1;
  const std::string models = BOXPROBE_SOURCE_DIR "/tests/unit/models/";
  for (const char* name : {"bar.glb", "tori-instanced.glb", "tori.glb", "torus-meshopt.glb", "torus-quantized.glb",
                           "torus-variants.glb", "torus-webp.glb", "torus.glb"}) {
    EXPECT_GT(loadModelFile(models + name).triangleCount(), 0u) << name;
  }
  GlbBuilder glb;  // every index becomes a corner with a normal
  glb.triangle(
      {{"indices", glb.accessor(glb.view(std::vector<std::uint16_t>(30000)), GlbBuilder::UShort, "SCALAR", 30000)}});
  EXPECT_EQ(loadModelFile(write("m.glb", glb.glb())).triangleCount(), 10000u);
}

/// Any single changed byte gives a model or one of this program's errors, nothing else (run under AddressSanitizer,
/// this is where a bounds check that is missing shows).
TEST_F(ModelDamage, RandomBytesNeverDoWorse) {
  GlbBuilder glb;
  const int indices = glb.accessor(glb.view(std::vector<std::uint8_t>{0, 1, 2}), GlbBuilder::UByte, "SCALAR", 3);
  glb.triangle({{"indices", indices}});
  const std::string whole = glb.glb();
  std::mt19937 random(3);
  int refused = 0;
  for (int round = 0; round < 1500; ++round) {
    std::string bytes = whole;
    for (int change = 0; change < 1 + round % 3; ++change) bytes[random() % bytes.size()] = static_cast<char>(random());
    write("m.glb", bytes);
    try {
      loadModelFile(file("m.glb"));
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace boxprobe
