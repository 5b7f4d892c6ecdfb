// Compressed, instanced, deformed and variant glTF files: against the same model written without the extension by
// glTF-Transform, and against vertices computed by three.js (models/make_models.mjs makes both).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "filters/core/base/errors.h"
#include "filters/io/gltf/model_file.h"
#include "tests/unit/error_text.h"
#include "tests/unit/io_glb_builder.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using Json = nlohmann::json;

const std::string kModels = BOXPROBE_SOURCE_DIR "/tests/unit/models/";

Model load(const std::string& name, const ModelState& state = {}) {
  return loadModelFile(kModels + name, {}, state);
}

/// Every corner of every triangle in the world.
struct Corner {
  glm::dvec3 position, normal;
  glm::dvec2 uv;
};
std::vector<Corner> cornersOf(const Model& model) {
  std::vector<Corner> corners;
  for (const Instance& instance : model.instances) {
    const Mesh& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
    for (const std::uint32_t i : mesh.indices) {
      const glm::dvec3 position = instance.worldFromModel * glm::dvec4(mesh.positions[i], 1.0);
      corners.push_back({position, mesh.normals[i], mesh.uv.empty() ? glm::vec2(0.0f) : mesh.uv[i]});
    }
  }
  return corners;
}

/// The largest distance from a triangle's middle of `a` to the nearest one of `b`, and how far normals and texture
/// coordinates differ there: codecs put triangles in another order.
Corner farthest(const Model& a, const Model& b) {
  const std::vector<Corner> first = cornersOf(a), second = cornersOf(b);
  EXPECT_EQ(first.size(), second.size());
  const auto middles = [](const std::vector<Corner>& corners) {
    std::vector<Corner> list;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      const Corner &p = corners[i], &q = corners[i + 1], &r = corners[i + 2];
      list.push_back({(p.position + q.position + r.position) / 3.0, (p.normal + q.normal + r.normal) / 3.0,
                      (p.uv + q.uv + r.uv) / 3.0});
    }
    return list;
  };
  const std::vector<Corner> others = middles(second);
  Corner most{glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec2(0.0)};
  for (const Corner& corner : middles(first)) {
    const Corner* nearest = &others.at(0);
    for (const Corner& other : others) {
      if (glm::distance(other.position, corner.position) < glm::distance(nearest->position, corner.position)) {
        nearest = &other;
      }
    }
    most.position.x = std::max(most.position.x, glm::distance(nearest->position, corner.position));
    most.normal.x = std::max(most.normal.x, glm::distance(nearest->normal, corner.normal));
    most.uv.x = std::max(most.uv.x, glm::distance(nearest->uv, corner.uv));
  }
  return most;
}

struct Compressed {
  const char* name;
  const char* plain;
  double position, normal, uv;  ///< the most that the encoder's quantization makes of it
};

class CompressedModel : public ::testing::TestWithParam<Compressed> {};

// Draco's glTF encoder keeps 14 bits of a position, 10 of a normal, 12 of a texture coordinate.
TEST_P(CompressedModel, IsThePlainOne) {
  const Model model = load(GetParam().name), plain = load(GetParam().plain);
  EXPECT_TRUE(model.warnings.empty()) << model.warnings.front();
  const Corner most = farthest(model, plain);
  EXPECT_LE(most.position.x, GetParam().position);
  EXPECT_LE(most.normal.x, GetParam().normal);
  EXPECT_LE(most.uv.x, GetParam().uv);
}

INSTANTIATE_TEST_SUITE_P(
    Codecs, CompressedModel,
    ::testing::Values(Compressed{"torus-draco.glb", "torus.glb", 2.8 / (1 << 14), 0.01, 2.0 / (1 << 12)},
                      Compressed{"torus-draco-sequential.glb", "torus.glb", 2.8 / (1 << 14), 0.01, 2.0 / (1 << 12)},
                      Compressed{"torus-meshopt.glb", "torus-quantized.glb", 1e-4, 0.02, 1e-4},
                      Compressed{"torus-quantized.glb", "torus.glb", 2.8 / (1 << 13), 0.02, 1e-6},
                      Compressed{"torus-webp.glb", "torus.glb", 0.0, 0.0, 0.0},
                      Compressed{"tori-instanced.glb", "tori.glb", 1e-5, 0.0, 0.0}),
    [](const auto& given) {
      std::string name = given.param.name;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
      return name;
    });

TEST(ModelFormats, WebpPicturesAreDecoded) {
  const auto image = load("torus-webp.glb").materials.at(0).baseColorTexture.image;
  const auto plain = load("torus.glb").materials.at(0).baseColorTexture.image;
  ASSERT_TRUE(image && plain);
  EXPECT_EQ(image->width, 16);
  EXPECT_EQ(image->pixels, plain->pixels) << "it is stored without loss";
}

TEST(ModelFormats, InstancesShareAMeshAndAName) {
  const Model model = load("tori-instanced.glb");
  ASSERT_EQ(model.instances.size(), 9u);
  EXPECT_EQ(model.meshes.size(), 1u);
  for (const Instance& instance : model.instances) EXPECT_EQ(instance.node, "torus");
}

TEST(ModelFormats, VariantsChooseMaterials) {
  const auto color = [](const Model& model) {
    return model.materials.at(static_cast<std::size_t>(model.meshes.at(0).material)).baseColor;
  };
  const Model model = load("torus-variants.glb");
  EXPECT_EQ(model.variants, (std::vector<std::string>{"red", "blue"}));
  EXPECT_EQ(color(model), color(load("torus-variants.glb", {"red", {}})));
  EXPECT_EQ(color(load("torus-variants.glb", {"blue", {}})), color(load("torus-blue.glb")));
  EXPECT_EQ(errorText([] {
              load("torus-variants.glb", {"green", {}});
            }),
            kModels + "torus-variants.glb: variants: has no variant \"green\"; it has \"red\", \"blue\"");
}

// three.js's getVertexPosition of the same mesh, skeleton and weights.
TEST(ModelFormats, SkinsAndMorphTargetsAreThoseOfThreeJs) {
  const Json expected = Json::parse(std::ifstream(kModels + "bar-vertices.json"));
  for (const char* time : {"", "0", "0.25", "1", "7"}) {
    SCOPED_TRACE(time);
    const std::string text = time;
    ModelState state;
    if (!text.empty()) state.seconds = std::stod(text);
    const Model model = load("bar.glb", state);
    ASSERT_EQ(model.instances.size(), 1u);
    const Mesh& mesh = model.meshes.at(static_cast<std::size_t>(model.instances[0].mesh));
    const Json& vertices = expected.at(text == "7" ? "1" : text.empty() ? "0" : text);
    ASSERT_EQ(mesh.positions.size(), vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const glm::dvec3 position = model.instances[0].worldFromModel * glm::dvec4(mesh.positions[i], 1.0);
      const glm::dvec3 wanted(vertices[i][0], vertices[i][1], vertices[i][2]);
      EXPECT_LT(glm::distance(position, wanted), 2e-6) << i;
      EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-5f);
    }
  }
  EXPECT_EQ(load("bar.glb").animationSeconds, 1.0);
}

class FormatDamage : public TemporaryFolder {
 protected:
  std::string bytesOf(const std::string& name) const {
    std::ifstream stream(kModels + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// The model's JSON changed in place: `to` is as long as `from` or shorter.
  std::string problem(std::string bytes, const std::string& from, std::string to) const {
    const std::size_t at = bytes.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    to.resize(from.size(), ' ');
    bytes.replace(at, from.size(), to);
    const std::string path = write("m.glb", bytes);
    return errorText([&] { loadModelFile(path); }).substr(path.size() + 2);
  }
};

TEST_F(FormatDamage, ClaimsThatBytesCannotHoldAreRefused) {
  const std::string meshopt = bytesOf("torus-meshopt.glb");
  EXPECT_NE(
      problem(meshopt, "\"byteStride\":2,\"count\":1728", "\"byteStride\":2,\"count\":9e15").find("are promised in"),
      std::string::npos);
  EXPECT_NE(problem(meshopt, "\"mode\":\"TRIANGLES\"", "\"mode\":\"TRIANGLER\"").find("mode"), std::string::npos);
  EXPECT_NE(problem(meshopt, "\"byteStride\":8,\"count\"", "\"byteStride\":7,\"count\"").find("byteStride"),
            std::string::npos);
  std::string draco = bytesOf("torus-draco.glb");
  const std::size_t stream = draco.find("DRACO");
  ASSERT_NE(stream, std::string::npos);
  // Behind the header of 11 bytes and the kind of traversal: vertices and triangles as numbers of 7 bits a byte.
  draco.replace(stream + 14, 5, "\xff\xff\xff\xff\x0f");
  EXPECT_NE(problem(draco, "DRACO", "DRACO").find("are promised in"), std::string::npos);
  EXPECT_NE(problem(bytesOf("torus-draco.glb"), "DRACO", "DRICO").find("is not a Draco 2.2 mesh"), std::string::npos);
}

/// Any few changed bytes behind the JSON give a model or a refusal.
TEST_F(FormatDamage, RandomBytesNeverDoWorse) {
  for (const char* name : {"torus-draco.glb", "torus-draco-sequential.glb", "torus-meshopt.glb", "torus-webp.glb"}) {
    const std::string whole = bytesOf(name);
    const std::size_t binary = whole.find("BIN") + 4;
    std::uint32_t random = 7;
    int refused = 0;
    for (int round = 0; round < 150; ++round) {
      std::string bytes = whole;
      for (int change = 0; change < 3; ++change) {
        random = 1664525u * random + 1013904223u;
        bytes[binary + (random >> 8) % (bytes.size() - binary)] = static_cast<char>(random >> 24);
      }
      try {
        loadModelFile(write("m.glb", bytes));
      } catch (const InputError&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, 0) << name;
  }
}

TEST_F(FormatDamage, RequiredExtensionsAreLookedAtFirst) {
  GlbBuilder glb;
  glb.triangle();
  const auto problemWith = [&](const char* extension) {
    glb.json["extensionsRequired"] = {extension};
    glb.json["buffers"] = 7;  // would be refused, too
    const std::string path = write("m.gltf", glb.json.dump());
    return errorText([&] { loadModelFile(path); }).substr(path.size() + 2);
  };
  EXPECT_EQ(problemWith("KHR_texture_basisu"),
            "extensionsRequired: needs KHR_texture_basisu: its textures are KTX2 (Basis Universal), which is not read; "
            "convert them: gltf-transform ktxdecompress IN OUT");
  EXPECT_EQ(problemWith("ACME_cubes"),
            "extensionsRequired: needs ACME_cubes, which is not supported; export without it");
}

TEST_F(FormatDamage, SkinsAndInstancesThatDoNotFitAreRefused) {
  const std::string bar = bytesOf("bar.glb");
  EXPECT_NE(problem(bar, "\"joints\":[0,1]", "\"joints\":[0,9]").find("is no node of the scene"), std::string::npos);
  EXPECT_NE(problem(bar, "\"joints\":[0,1]", "\"joints\":[0  ]").find("hangs on joint 1, but the skin has 1"),
            std::string::npos);
  const std::string tori = bytesOf("tori-instanced.glb");
  EXPECT_NE(problem(tori, "\"ROTATION\":5", "\"ROTATION\":4").find("needs 4 components"), std::string::npos);
  EXPECT_NE(problem(tori, "\"SCALE\":6", "\"SCALE\":0").find("lists are of different lengths"), std::string::npos);
}

}  // namespace
}  // namespace boxprobe
