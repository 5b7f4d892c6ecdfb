// A scene with its probes in one .glb: what other readers find, what comes back, and files that are broken.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "filters/io/cube/bake_folder.h"
#include "filters/io/engines/glb_models.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/gltf/glb_document.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/scene/scene_file.h"
#include "tests/unit/error_text.h"
#include "tests/unit/io_glb_builder.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// Texels that are all different and exact as half floats.
void fill(CubeMap& cube, float start, int channels) {
  int number = 0;
  for (int level = 0; level < cube.levels(); ++level) {
    const int count = 6 * cube.levelSize(level) * cube.levelSize(level);
    for (int i = 0; i < count; ++i) {
      for (int c = 0; c < channels; ++c)
        cube.face(level, 0)[4 * i + c] = start + 0.125f * static_cast<float>(number++ % 1500);
    }
  }
}

class GlbProbes : public TemporaryFolder {
 protected:
  void SetUp() override {
    GlbBuilder builder;
    builder.triangle();
    builder.json["materials"] = {{{"name", "paint"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0.25}}}}};
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    builder.json["extensionsUsed"] = {"EXT_of_somebody"};
    builder.json["extensions"]["EXT_of_somebody"] = {{"kept", 7}};
    write("model.glb", builder.glb());
    write("sky.hdr", "sky bytes\n");
    std::filesystem::create_directories(file("other"));
    write("other/sky.hdr", "other bytes");
    content_.scene = parseScene(R"({"format": "boxprobe-scene", "version": 1, "model": "model.glb",
        "sky": {"image": "sky.hdr", "rotationDegrees": 30},
        "cameras": {"far": {"position": [1, 2, 9], "target": [0, 1, 0]}},
        "lights": [{"type": "point", "position": [3, 2, 1], "color": [1, 0.5, 0.25], "intensity": 40}],
        "materials": {"paint": {"coat": 0.5, "ior": 1.25, "transmission": 0.125, "roughness": 0.75, "emissive": [0, 6, 3]}},
        "probes": [{"name": "hall", "origin": [2, 1, -3], "box": {"min": [-4, 0, -7], "max": [5, 3, 6]},
                    "influence": {"min": [-3, 0.5, -6], "max": [4, 2.5, 5]}, "rotationDegrees": [0, 90, 0],
                    "blendDistance": {"min": [0.1, 0.2, 0.3], "max": [0.4, 0.5, 0.6]}, "importance": 2, "near": 0.05,
                    "far": 77, "technique": "box+footprint4", "faceSize": 16},
                   {"name": "picture", "mode": "custom", "image": "other/sky.hdr", "box": {"min": [-1, -1, -1], "max": [1, 2, 3]}}]})",
                                file("scene.boxprobe.json"), folder_.string());
    BakedProbeFile baked;
    baked.maps.radiance = CubeMap(16, 3);
    baked.maps.distance = CubeMap(16, 1);
    fill(baked.maps.radiance, 0.5f, 4);
    fill(baked.maps.distance, 0.1f, 1);
    for (int i = 0; i < 9; ++i) baked.maps.irradiance[i] = glm::vec3(0.1f * i, 0.3f, -0.7f);
    baked.maps.capturedAt = {2, 1, -3};
    baked.maps.capturedRotation = {0, 90, 0};
    baked.info.probe = content_.scene.probes[0];
    baked.info.inputHash = "00112233 4455 - -";
    baked.info.program = "Boxprobe 9";
    baked.info.renderer = "a renderer";
    content_.maps = {baked, std::nullopt};
    DiffuseLattice lattice;
    lattice.nodes = {2, 3, 4};
    lattice.low = {-1.5f, -0.5f, -2};
    lattice.high = {1, 2, 3};
    lattice.texels.resize(7 * 24);
    for (std::size_t i = 0; i < lattice.texels.size(); ++i)
      lattice.texels[i] = glm::vec4(0.25f * static_cast<float>(i));
    ProbeDiffuse diffuse;
    diffuse.lattice = std::make_shared<const DiffuseLattice>(lattice);
    SceneLamp lamp;
    lamp.node = "tri";
    lamp.corners = {{0, 3, 0}, {1, 3, 0}, {0, 3, 2}};
    lamp.radiance = {5, 6, 7};
    diffuse.lamps = {lamp};
    content_.diffuse.probes = {diffuse, std::nullopt};
    content_.writer = "Boxprobe 9";
  }

  std::string pack() {
    return glbWithProbes(content_, {std::make_shared<const Model>(loadModelFile(file("model.glb")))}, "out.glb");
  }
  /// The file with something of its extension changed.
  std::string broken(const std::function<void(json& root, json& extension)>& change) {
    write("whole.glb", pack());
    GlbDocument document = readGlbDocument(file("whole.glb"));
    json root = json::parse(document.json.dump());
    change(root, root["extensions"][kGlbExtension]);
    document.json = Json::parse(root.dump());
    return write("broken.glb", glbText(document, "broken.glb"));
  }

  GlbScene content_;
};

TEST_F(GlbProbes, OtherReadersFindTheModelAndWhatGltfCanSay) {
  const std::string path = write("out.glb", pack());
  const json root = json::parse(*glbJsonText(path));
  EXPECT_EQ(root["extensions"]["EXT_of_somebody"]["kept"], 7);
  EXPECT_FALSE(root.contains("extensionsRequired"));
  EXPECT_EQ(root["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"], 0.75);
  EXPECT_EQ(root["materials"][0]["extensions"]["KHR_materials_ior"]["ior"], 1.25);
  EXPECT_EQ(root["materials"][0]["emissiveFactor"], json({0.0, 1.0, 0.5}));
  EXPECT_EQ(root["materials"][0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 6.0);
  const Model before = loadModelFile(file("model.glb")), after = loadModelFile(path);
  EXPECT_EQ(after.meshes[0].positions, before.meshes[0].positions);
  EXPECT_EQ(after.materials[0].roughness, 0.25f) << "the scene changes it here";
  EXPECT_EQ(after.lights, content_.scene.lights) << "position and intensity as glTF has them";
  ASSERT_EQ(after.cameras.size(), 1u);
  EXPECT_NEAR(glm::length(after.cameras[0].position - glm::dvec3(1, 2, 9)), 0.0, 1e-12);
  const glm::dvec3 ahead = glm::normalize(after.cameras[0].target - after.cameras[0].position);
  EXPECT_NEAR(glm::length(ahead - glm::normalize(glm::dvec3(-1, -1, -9))), 0.0, 1e-12);
}

TEST_F(GlbProbes, AProbeStandsInItsOwnFrame) {
  const json root = json::parse(*glbJsonText(write("out.glb", pack())));
  const json& extension = root["extensions"][kGlbExtension];
  const json& probe = extension["probes"][0];
  // A quarter turn about +Y takes the probe's x to the world's -z and its z to the world's x. The box's centre is
  // (0.5, 1.5, -0.5), from the origin (-1.5, 0.5, 2.5): (-2.5, 0.5, -1.5) along the probe's axes. Half
  // sizes 4.5, 1.5, 6.5.
  const auto near = [](const json& v, glm::dvec3 expected) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(v[i].get<double>(), expected[i], 1e-6) << v.dump();
  };
  near(probe["origin"], {2, 1, -3});
  near(probe["box"]["min"], {-7, -1, -8});
  near(probe["box"]["max"], {2, 2, 5});
  near(probe["influence"]["min"], {-6, -0.5, -7});
  near(probe["blendDistance"]["max"], {0.4, 0.5, 0.6});
  EXPECT_NEAR(probe["rotation"][1].get<double>(), std::sqrt(0.5), 1e-12);
  EXPECT_EQ(probe["near"], 0.05);
  EXPECT_EQ(probe["far"], 77);
  EXPECT_EQ(probe["importance"], 2);
  // The second texel of the second level's third face, channel by channel, as half floats.
  GlbDocument document = readGlbDocument(file("out.glb"));
  const json& level = extension["maps"][0]["levels"][1];
  EXPECT_EQ(level["size"], 8);
  const json view = json::parse(document.json["bufferViews"][level["bufferView"].get<std::size_t>()].dump());
  std::uint16_t red = 0;
  std::memcpy(&red, &document.binary[view["byteOffset"].get<std::size_t>() + 8 * (2 * 64 + 1)], 2);
  const int number = (6 * 256 + 2 * 64 + 1) * 4 % 1500;
  const double value = (1.0 + (red & 1023) / 1024.0) * std::exp2((red >> 10) - 15);  // of a normal half float
  EXPECT_EQ(value, 0.5 + 0.125 * number);
  EXPECT_EQ(extension["lattices"][0]["nodes"], json({2, 3, 4}));
  EXPECT_EQ(extension["lamps"][0]["radiance"], json({5.0, 6.0, 7.0}));
  EXPECT_EQ(extension["probes"][0]["lamps"], json({0}));
}

TEST_F(GlbProbes, TheSceneAndItsMapsComeBackBitByBit) {
  const std::string path = write("out.glb", pack());
  EXPECT_TRUE(holdsProbes(path));
  EXPECT_FALSE(holdsProbes(file("model.glb")));
  unpackGlb(path, file("opened"));
  Scene scene = glbSceneOf(path, file("opened"));
  EXPECT_EQ(read("opened/sky.hdr"), "sky bytes\n");
  EXPECT_EQ(read("opened/2-sky.hdr"), "other bytes") << "two pictures of one name";
  EXPECT_EQ(scene.probes[1].image, file("opened/2-sky.hdr"));
  scene.probes[1].image = content_.scene.probes[1].image;
  scene.sky = content_.scene.sky;
  scene.models = content_.scene.models;
  EXPECT_EQ(scene, content_.scene);
  saveBakedProbe(file("as-baked.exr"), *content_.maps[0]);
  EXPECT_EQ(read("opened/probes/hall.exr"), read("as-baked.exr"));
  // Written again from what was opened, the file is the same.
  content_.maps[0] = loadBakedProbe(file("opened/probes/hall.exr"));
  EXPECT_EQ(pack(), read("out.glb"));
}

TEST_F(GlbProbes, AFileWrittenAgainFromItselfDoesNotGrow) {
  const std::string path = write("out.glb", pack());
  content_.scene.models[0].file = path;
  const std::string again =
      write("again.glb", glbWithProbes(content_, {std::make_shared<const Model>(loadModelFile(path))}, "again.glb"));
  const GlbDocument first = readGlbDocument(path), second = readGlbDocument(again);
  EXPECT_EQ(second.binary.size(), first.binary.size());
  EXPECT_EQ(second.json["bufferViews"].size(), first.json["bufferViews"].size());
  EXPECT_EQ(second.json["cameras"].size(), 1u);
  EXPECT_EQ(second.json["materials"], first.json["materials"]);
}

TEST_F(GlbProbes, PicturesOfAwkwardNamesComeBack) {
  std::filesystem::create_directories(file("third"));
  const std::string stem(230, 'x');
  write("third/probes", "no extension");
  write("third/" + stem + ".hdr", "long name");
  content_.scene.probes[1].image = file("third/" + stem + ".hdr");
  std::get<SkyImage>(content_.scene.sky).file = file("third/probes");
  const std::string path = write("out.glb", pack());
  unpackGlb(path, file("opened"));
  const Scene scene = glbSceneOf(path, file("opened"));
  const auto bytes = [](const std::string& name) {
    std::ifstream stream(name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  EXPECT_EQ(bytes(scene.probes[1].image), "long name");
  EXPECT_EQ(bytes(std::get<SkyImage>(scene.sky).file), "no extension");
  EXPECT_TRUE(std::filesystem::is_directory(file("opened/probes"))) << "of the maps";
}

TEST_F(GlbProbes, AMovedModelStandsWhereTheSceneHasIt) {
  content_.scene.models[0].unit = LengthUnit::Centimetre;
  content_.scene.models[0].upAxis = UpAxis::Z;
  content_.scene.models[0].translation = {10, 0, 0};
  const Model placed = loadModelFile(write("out.glb", pack()));
  // The file's (0, 1, 0), in centimetres with Z up, is (0, 0, -0.01) with Y up.
  const glm::dvec4 corner = placed.instances[0].worldFromModel * glm::dvec4(0, 1, 0, 1);
  EXPECT_NEAR(glm::length(glm::dvec3(corner) - glm::dvec3(10, 0, -0.01)), 0.0, 1e-12);
}

/// A mesh without symmetry, with all arrays; normals and tangents unit to the last bit of what floats can be.
Mesh fullMesh(float seed) {
  Mesh mesh;
  mesh.name = "mesh " + std::to_string(seed);
  for (int i = 0; i < 5; ++i) {
    const float t = seed + 0.37f * static_cast<float>(i);
    mesh.positions.emplace_back(std::sin(t), 1.7f * std::cos(2.1f * t), t);
    mesh.normals.push_back(glm::vec3(glm::normalize(glm::dvec3(std::cos(t), 0.3, std::sin(3 * t)))));
    mesh.tangents.emplace_back(glm::vec3(glm::normalize(glm::dvec3(0.2, t, -1))), i % 2 == 0 ? 1.0f : -1.0f);
    mesh.uv.emplace_back(0.1f * t, -3.0f * t);
    mesh.uv1.emplace_back(t, 0.7f);
    mesh.colors.emplace_back(0.1f, 0.15f * static_cast<float>(i), 0.9f, 0.3f);
  }
  mesh.indices = {0, 1, 2, 2, 1, 3, 4, 0, 3};
  return mesh;
}

/// Nearly every field of a material away from its default.
Material fullMaterial(const std::string& name) {
  Material m;
  m.name = name;
  m.baseColor = {0.1f, 0.2f, 0.3f, 0.4f};
  m.metallic = 0.6f;
  m.roughness = 0.7f;
  m.emissive = {0.3f, 7.0f, 1.1f};
  m.normalScale = 0.8f;
  m.occlusionStrength = 0.9f;
  m.coat = 0.35f;
  m.coatRoughness = 0.45f;
  m.coatNormalScale = 0.55f;
  m.specular = 0.5f;
  m.finish.specularEdge = 0.25f;
  m.finish.specularTint = {0.5f, 0.75f, 0.25f};
  m.transmission = 0.55f;
  m.ior = 1.33f;
  m.thin = false;
  m.thickness = 0.15f;
  m.attenuationDistance = 2.5f;
  m.attenuationColor = {0.9f, 0.8f, 0.7f};
  m.doubleSided = true;
  m.alphaMode = AlphaMode::Mask;
  m.alphaCutoff = 0.25f;
  m.finish.sheenColor = {0.2f, 0.3f, 0.1f};
  m.finish.sheenRoughness = 0.65f;
  m.finish.anisotropy = 0.75f;
  m.finish.anisotropyRotation = 1.25f;
  m.finish.iridescence = 0.85f;
  m.finish.filmIor = 1.4f;
  m.finish.filmThicknessMin = 110.0f;
  m.finish.filmThicknessMax = 390.0f;
  ImageRgba8 image{3, 2, {}, "paint"};
  for (int i = 0; i < 24; ++i) image.pixels.push_back(static_cast<std::uint8_t>(7 * i + 3));
  TextureUse use;
  use.image = std::make_shared<const ImageRgba8>(image);
  use.wrapS = Wrap::ClampToEdge;
  use.wrapT = Wrap::MirroredRepeat;
  use.uvSet = 1;
  use.nearest = true;
  use.uvTransform = {2.0f, 0.0f, 0.0f, -3.0f, 0.25f, 0.125f};
  for (TextureUse* each :
       {&m.baseColorTexture, &m.normalTexture, &m.occlusionTexture, &m.coatTexture, &m.coatNormalTexture,
        &m.metallicRoughnessTexture, &m.transmissionTexture, &m.finish.filmThicknessTexture, &m.emissiveTexture}) {
    *each = use;
  }
  m.emissiveTexture.wrapS = Wrap::Repeat;
  return m;
}

void expectSame(const TextureUse& a, const TextureUse& b) {
  ASSERT_EQ(a.image != nullptr, b.image != nullptr);
  if (!a.image) return;
  EXPECT_EQ(a.image->width, b.image->width);
  EXPECT_EQ(a.image->pixels, b.image->pixels);
  EXPECT_EQ(a.wrapS, b.wrapS);
  EXPECT_EQ(a.wrapT, b.wrapT);
  EXPECT_EQ(a.uvSet, b.uvSet);
  EXPECT_EQ(a.nearest, b.nearest);
  EXPECT_EQ(a.uvTransform, b.uvTransform);
}

TEST_F(GlbProbes, ModelsOfAnyFormatAreOneAndComeBackBitByBit) {
  Model first, second;
  first.meshes = {fullMesh(0.1f), fullMesh(2.3f)};
  first.materials = {Material{}, fullMaterial("full")};
  first.materials[0].name = "plain";
  first.materials[0].unlit = true;
  first.meshes[0].material = 1;
  first.meshes[1].material = 0;
  first.instances = {{"far", 0, glm::dmat4(1.0)}, {"same again", 0, glm::dmat4(1.0)}};
  first.instances[0].worldFromModel[3] = {431000.015625, 312.1, 5411932.3, 1.0};  // as of survey data
  second.meshes = {fullMesh(4.5f)};
  second.materials = {fullMaterial("other")};
  second.materials[0].alphaMode = AlphaMode::Blend;
  second.materials[0].thickness = 0.0f;  // a solid all the same, as MTL files have them
  second.materials[0].coat = 0.0f;       // which a scene may turn on
  second.materials[0].transmission = 0.0f;
  second.meshes[0].material = 0;
  second.instances = {{"mirrored", 0, glm::dmat4(1.0)}};
  second.instances[0].worldFromModel[0][0] = -2.0;  // its triangles are turned, as every reader here leaves them
  Scene scene;
  scene.models = {ModelFile{"a.obj"}, ModelFile{"b.ply"}};
  scene.models[1].unit = LengthUnit::Centimetre;
  scene.models[1].upAxis = UpAxis::Z;
  scene.models[1].translation = {10, 20, 30};
  EXPECT_TRUE(needsJoining(scene));
  const SceneModels models = {std::make_shared<const Model>(first), std::make_shared<const Model>(second)};
  const Model after = loadModelFile(write("joined.glb", glbText(documentOfModels(scene, models), "joined.glb")));
  ASSERT_EQ(after.instances.size(), 3u);
  const Mesh* before[] = {&first.meshes[0], &first.meshes[0], &second.meshes[0]};
  for (std::size_t i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    const Mesh& mesh = after.meshes[static_cast<std::size_t>(after.instances[i].mesh)];
    EXPECT_EQ(mesh.positions, before[i]->positions);
    EXPECT_EQ(mesh.normals, before[i]->normals);
    EXPECT_EQ(mesh.tangents, before[i]->tangents);
    EXPECT_EQ(mesh.uv, before[i]->uv);
    EXPECT_EQ(mesh.uv1, before[i]->uv1);
    EXPECT_EQ(mesh.colors, before[i]->colors);
    EXPECT_EQ(mesh.indices, before[i]->indices);
    const Material& a = after.materials.at(static_cast<std::size_t>(mesh.material));
    const Material& b = i < 2 ? first.materials[1] : second.materials[0];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.baseColor, b.baseColor);
    EXPECT_EQ(a.emissive, b.emissive);
    EXPECT_EQ(a.attenuationColor, b.attenuationColor);
    EXPECT_EQ(a.finish.sheenColor, b.finish.sheenColor);
    // A reader takes the tint's brightness for the strength, so that their product comes back.
    EXPECT_LT(glm::length(a.specular * a.finish.specularTint - b.specular * b.finish.specularTint), 1.0e-7f);
    for (const auto& [x, y] : {std::pair{a.metallic, b.metallic},
                               {a.roughness, b.roughness},
                               {a.normalScale, b.normalScale},
                               {a.occlusionStrength, b.occlusionStrength},
                               {a.coat, b.coat},
                               {a.coatRoughness, b.coatRoughness},
                               {a.coatNormalScale, b.coatNormalScale},
                               {a.finish.specularEdge, b.finish.specularEdge},
                               {a.transmission, b.transmission},
                               {a.ior, b.ior},
                               {a.thickness, b.thickness},
                               {a.attenuationDistance, b.attenuationDistance},
                               {a.finish.sheenRoughness, b.finish.sheenRoughness},
                               {a.finish.anisotropy, b.finish.anisotropy},
                               {a.finish.anisotropyRotation, b.finish.anisotropyRotation},
                               {a.finish.iridescence, b.finish.iridescence},
                               {a.finish.filmIor, b.finish.filmIor},
                               {a.finish.filmThicknessMin, b.finish.filmThicknessMin},
                               {a.finish.filmThicknessMax, b.finish.filmThicknessMax}}) {
      EXPECT_EQ(x, y);
    }
    EXPECT_EQ(a.alphaMode, b.alphaMode);
    if (i < 2) {
      EXPECT_EQ(a.alphaCutoff, b.alphaCutoff);
    }
    EXPECT_EQ(a.thin, b.thin);
    EXPECT_EQ(a.doubleSided, b.doubleSided);
    const auto uses = a.textures(), wanted = b.textures();
    for (std::size_t t = 0; t < uses.size(); ++t) expectSame(*uses[t], *wanted[t]);
  }
  EXPECT_EQ(after.instances[0].node, "far");
  EXPECT_EQ(after.instances[0].worldFromModel, first.instances[0].worldFromModel);
  EXPECT_EQ(after.instances[0].mesh, after.instances[1].mesh) << "shared";
  EXPECT_TRUE(after.materials[0].unlit);
  // (1, 2, 3) of the file's node is (-2, 2, 3) in centimetres with Z up: (-0.02, 0.03, -0.02) with Y up.
  const glm::dvec4 corner = after.instances[2].worldFromModel * glm::dvec4(1, 2, 3, 1);
  EXPECT_NEAR(glm::length(glm::dvec3(corner) - glm::dvec3(9.98, 20.03, 29.98)), 0.0, 1e-12);
}

TEST_F(GlbProbes, AShearedInstanceIsWrittenAsNodesCanBe) {
  Model model;
  model.meshes = {fullMesh(0.1f)};
  model.instances = {{"leaning", 0, glm::dmat4(1.0)}};
  model.instances[0].worldFromModel[1][0] = 0.5;
  model.instances[0].worldFromModel[3] = {1, 2, 3, 1};
  Scene scene;
  scene.models = {ModelFile{"a.obj"}};
  const GlbDocument document = documentOfModels(scene, {std::make_shared<const Model>(model)});
  EXPECT_FALSE(document.json["nodes"][0].contains("matrix"));
  const Model after = loadModelFile(write("sheared.glb", glbText(document, "sheared.glb")));
  for (std::size_t i = 0; i < 5; ++i) {
    const glm::dvec3 p(model.meshes[0].positions[i]);
    const glm::dvec3 seen = after.instances[0].worldFromModel * glm::dvec4(after.meshes[0].positions[i], 1.0);
    EXPECT_NEAR(glm::length(seen - glm::dvec3(p.x + 0.5 * p.y + 1, p.y + 2, p.z + 3)), 0.0, 1e-6);
  }
}

TEST_F(GlbProbes, BrokenFilesAreOneLine) {
  const auto refused = [this](const std::string& part, const std::function<void(json&, json&)>& change) {
    const std::string path = broken(change);
    const std::string text = errorText([&] { unpackGlb(path, file("opened-broken")); });
    EXPECT_THAT(text, HasSubstr("broken.glb: ")) << part;
    EXPECT_THAT(text, HasSubstr(part));
  };
  using J = json;
  refused("version", [](J&, J& e) { e["version"] = 2; });
  refused("maps[0].levels[1].size", [](J&, J& e) { e["maps"][0]["levels"][1]["size"] = 16; });
  refused("maps[0].levels[0].size", [](J&, J& e) { e["maps"][0]["levels"][0]["size"] = 4294967295u; });
  refused("maps[0].levels[0].size", [](J&, J& e) { e["maps"][0]["levels"][0]["size"] = 12; });
  refused("maps[0].levels[2].bufferView", [](J&, J& e) { e["maps"][0]["levels"][2]["bufferView"] = 10000; });
  refused("maps[0].levels[2].bufferView", [](J&, J& e) { e["maps"][0]["levels"][2]["bufferView"] = 0; });
  refused("maps[0].levels[2].bufferView", [](J&, J& e) { e["maps"][0]["levels"][2]["bufferView"] = -1; });
  refused("outside", [](J& root, J& e) {
    root["bufferViews"][e["maps"][0]["levels"][0]["bufferView"].get<std::size_t>()]["byteOffset"] = 4294967000u;
  });
  refused("byteOffset", [](J& root, J& e) {
    root["bufferViews"][e["maps"][0]["levels"][0]["bufferView"].get<std::size_t>()]["byteOffset"] = 1e300;
  });
  refused("encoding", [](J&, J& e) { e["maps"][0]["encoding"] = "png"; });
  refused("has an owner already", [](J&, J& e) {
    e["probes"][1]["map"] = 0;
    e["scene"]["probes"][1].erase("mode");
    e["scene"]["probes"][1].erase("image");
  });
  refused("more bytes than the file", [](J&, J& e) {
    const J view = e["maps"][0]["levels"][0]["bufferView"];
    for (int i = 0; i < 20; ++i) e["files"].push_back({{"name", "copy " + std::to_string(i)}, {"bufferView", view}});
  });
  refused("more bytes than the file", [](J&, J& e) {
    for (J& level : e["maps"][1]["levels"])
      level["bufferView"] = e["maps"][0]["levels"][&level - &e["maps"][1]["levels"][0]]["bufferView"];
    while (e["maps"].size() < 40) e["maps"].push_back(e["maps"][0]);
    for (std::size_t i = 2; i < 40; ++i) {
      J probe = e["scene"]["probes"][0], entry = e["probes"][0];
      probe["name"] = entry["name"] = "copy " + std::to_string(i);
      entry["map"] = i;
      e["scene"]["probes"].push_back(probe);
      e["probes"].push_back(entry);
    }
  });
  refused("13", [](J&, J& e) { e["maps"][0]["levels"] = J::array(); });
  refused("irradiance", [](J&, J& e) { e["maps"][0]["irradiance"].erase(3); });
  refused("probes[0].map", [](J&, J& e) { e["probes"][0]["map"] = 5; });
  refused("no probe of the scene", [](J&, J& e) { e["probes"][0]["name"] = "attic"; });
  refused("twice", [](J&, J& e) { e["probes"][1]["name"] = "hall"; });
  refused("name of two files", [](J&, J& e) { e["files"][1]["name"] = "sky.hdr"; });
  refused("no name of a file", [](J&, J& e) { e["files"][0]["name"] = "../sky.hdr"; });
  refused("holds no picture", [](J&, J& e) { e["scene"]["sky"]["image"] = "/etc/passwd"; });
  refused("holds no picture", [](J&, J& e) { e["files"].erase(0); });
  refused("model", [](J&, J& e) { e["scene"]["model"] = "other.glb"; });
  refused("probes", [](J&, J& e) { e["scene"]["probes"][0]["box"] = 3; });
  refused("already the name", [](J&, J& e) { e["scene"]["probes"][1]["name"] = "hall"; });
  refused("inputs", [](J&, J& e) { e["maps"][0]["inputs"] = "x"; });
  refused("scene", [](J&, J& e) { e.erase("scene"); });
  for (const char* number : {"1", "-1", "4294967296000", ""}) {
    const std::string path = broken([&](J&, J& e) { e["materials"] = {{number, J::object()}}; });
    EXPECT_THAT(errorText([&] { loadModelFile(path); }),
                HasSubstr("BOXPROBE_reflection_probes.materials." + std::string(number) + ": is no material"));
  }
  std::string cut = pack();
  cut.resize(cut.size() - 5);
  const std::string path = write("cut.glb", cut);
  EXPECT_THAT(errorText([&] { unpackGlb(path, file("opened-cut")); }), HasSubstr("cut off"));
}

TEST_F(GlbProbes, WhatDoesNotFitIsSaidBeforeAnythingIsMade) {
  Scene many = content_.scene;
  for (int i = 0; i < 20; ++i) {
    many.probes.push_back(many.probes[0]);
    many.probes.back().name = std::to_string(i);
    many.probes.back().faceSize = 4096;
  }
  EXPECT_THAT(errorText([&] { requireGlbScene(many, "out.glb"); }), HasSubstr("out.glb: would have "));
  many = content_.scene;
  many.models.push_back(ModelFile{file("gone.obj")});
  EXPECT_THAT(errorText([&] { requireGlbScene(many, "out.glb"); }), HasSubstr("gone.obj"));
  many.models.clear();
  EXPECT_THAT(errorText([&] { requireGlbScene(many, "out.glb"); }), HasSubstr("models: "));
}

TEST_F(GlbProbes, BuffersAndPicturesBesideTheModelAreTakenIn) {
  GlbBuilder builder;
  builder.triangle();
  builder.json["images"] = {{{"uri", "paint%201.png"}}, {{"uri", "missing.png"}}};
  write("beside.gltf", builder.gltf("bytes.bin"));
  write("bytes.bin", builder.buffer);
  const std::string png("\x89PNG\r\n and more", 16);
  write("paint 1.png", png);
  GlbDocument document = readGlbDocument(file("beside.gltf"));
  EXPECT_EQ(document.binary.substr(0, builder.buffer.size()), builder.buffer);
  const Json& image = document.json["images"][0];
  EXPECT_EQ(image["mimeType"], "image/png");
  const Json& view = document.json["bufferViews"][image["bufferView"].get<std::size_t>()];
  EXPECT_EQ(document.binary.substr(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>()), png);
  EXPECT_EQ(document.json["images"][1]["uri"], "missing.png");
  write("beside.gltf", builder.gltf("../bytes.bin"));
  EXPECT_THAT(errorText([&] { readGlbDocument(file("beside.gltf")); }), HasSubstr("beside.gltf"));
}

}  // namespace
}  // namespace boxprobe
