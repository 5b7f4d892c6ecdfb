// Everything that a .glb with probes holds, number by number, against engine_glb_values.txt: of a scene whose every
// field is another, with a model of its own and with several that are joined.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "filters/io/engines/glb_models.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/gltf/glb_document.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/scene/scene_file.h"
#include "tests/support/kept_values.h"
#include "tests/unit/error_text.h"
#include "tests/unit/io_glb_builder.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

/// Its JSON, and of each buffer view a sum of its bytes, each with another weight. Pictures' own bytes are their
/// encoder's affair.
void addDocument(test::KeptValues& values, const GlbDocument& document) {
  Json root = document.json;
  std::vector<bool> picture(root.contains("bufferViews") ? root["bufferViews"].size() : 0);
  if (root.contains("images")) {
    for (const Json& image : root["images"]) {
      if (image.contains("bufferView")) picture.at(image["bufferView"].get<std::size_t>()) = true;
    }
  }
  for (std::size_t i = 0; i < picture.size(); ++i) {
    Json& view = root["bufferViews"][i];
    const std::size_t start = view.value("byteOffset", std::size_t(0)), size = view["byteLength"].get<std::size_t>();
    std::size_t sum = 0;
    for (std::size_t at = 0; at < size; ++at) {
      sum += (at % 251 + 1) * static_cast<unsigned char>(document.binary.at(start + at));
    }
    view.erase("byteOffset");
    if (picture[i]) {
      view["byteLength"] = "of a picture";
    } else {
      view["sum"] = sum;
    }
  }
  if (root.contains("buffers")) root.erase("buffers");
  values.addJson("", root);
}

void fillMap(CubeMap& cube, float start) {
  int number = 0;
  for (int level = 0; level < cube.levels(); ++level) {
    const int count = 6 * 4 * cube.levelSize(level) * cube.levelSize(level);
    for (int i = 0; i < count; ++i) cube.face(level, 0)[i] = start + 0.125f * static_cast<float>(number++ % 1511);
  }
}

BakedProbeFile bakedMap(int faceSize, int levels, float start) {
  BakedProbeFile baked;
  baked.maps.radiance = CubeMap(faceSize, levels);
  fillMap(baked.maps.radiance, start);
  for (int i = 0; i < 9; ++i) {
    const float t = start + static_cast<float>(i);
    baked.maps.irradiance[static_cast<std::size_t>(i)] = {0.1f * t, 0.3f - 0.2f * t, 0.01f * t * t};
  }
  baked.maps.capturedAt = {0.5, 1.25, start};
  baked.maps.capturedRotation = {5, 15, -25};
  baked.info.inputHash = "00112233 4455 - -";
  baked.info.program = "Boxprobe 9";
  baked.info.renderer = "a renderer";
  return baked;
}

class GlbValues : public TemporaryFolder {
 protected:
  void SetUp() override {
    GlbBuilder builder;
    builder.triangle();
    builder.json["materials"] = {
        {{"name", "paint"},
         {"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"roughnessFactor", 0.25}}},
         {"normalTexture", {{"index", 0}, {"scale", 0.5}}}},
        {{"name", "dim"},
         {"emissiveFactor", {1, 1, 1}},
         {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 5}}}}}},
        {{"name", "left alone"}},
        {{"name", "bare"}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["images"] = {{{"uri", "gone.png"}}};
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    write("model.glb", builder.glb());
    write("sky.hdr", "sky bytes\n");
    write("other/a\\b.hdr", "other bytes");
    GlbScene& content = content_;
    content.scene = parseScene(R"({"format": "boxprobe-scene", "version": 1,
        "models": [{"file": "model.glb", "translation": [1, -2, 3.5], "rotationDegrees": [10, 20, 30], "scale": 1.5}],
        "sky": {"image": "sky.hdr", "rotationDegrees": 30},
        "cameras": {"far": {"position": [1, 2, 9], "target": [0.5, 1, -1], "up": [0.1, 1, 0], "verticalFovDegrees": 35},
                    "plan": {"position": [3, 9, 1], "target": [3, 0, 1], "up": [0, 0, -1], "parallelHeight": 7},
                    "along": {"position": [3, 9, 1], "target": [8, 9, 1], "up": [0.25, 1, 0.5]}},
        "lights": [{"type": "point", "position": [3, 2, 1], "color": [1, 0.5, 0.25], "intensity": 40, "range": 6},
                   {"type": "spot", "position": [-3, 4, 1], "direction": [0.3, -1, 0.2], "innerConeDegrees": 11,
                    "outerConeDegrees": 33, "intensity": 12},
                   {"type": "directional", "direction": [0, -1, 0], "color": [0.9, 0.8, 0.7], "intensity": 3},
                   {"type": "point", "position": [1, 1, 1]}],
        "materials": {"paint": {"baseColor": [0.9, 0.8, 0.7], "metallic": 0.35, "roughness": 0.75, "coat": 0.5,
                                "ior": 1.25, "transmission": 0.125, "thickness": 0.4, "attenuationDistance": 2.5,
                                "attenuationColor": [0.2, 0.4, 0.6], "normalScale": 0.8, "emissive": [0.5, 3, 6]},
                      "dim": {"emissive": [0.25, 0.5, 0.75]}, "bare": {"metallic": 0.5, "normalScale": 2}},
        "probes": [{"name": "hall", "origin": [2, 1, -3], "box": {"min": [-4, 0, -7], "max": [5, 3, 6]},
                    "influence": {"min": [-3.5, 0.5, -6], "max": [4, 2.5, 5.25]}, "rotationDegrees": [10, 50, -20],
                    "blendDistance": {"min": [0.1, 0.2, 0.3], "max": [0.4, 0.5, 0.6]}, "importance": 2,
                    "intensity": 0.7, "near": 0.05, "far": 77, "technique": "box+footprint4", "clear": "open",
                    "faceSize": 16},
                   {"name": "picture", "mode": "custom", "image": "other/a\\b.hdr", "rotationDegrees": [0, 30, 0],
                    "box": {"min": [-1, -1, -1], "max": [1, 2, 3]}}]})",
                               file("scene.boxprobe.json"), folder_.string());
    content.maps = {bakedMap(16, 3, 0.5f), std::nullopt};
    content.maps[0]->maps.distance = CubeMap(8, 1);
    fillMap(content.maps[0]->maps.distance, 0.25f);
    content.maps[0]->info.probe = content.scene.probes[0];
    content.sky = bakedMap(8, 1, 2.0f);
    content.sky->info.inputHash.clear();
    DiffuseLattice lattice;
    lattice.nodes = {2, 3, 4};
    lattice.low = {-1.5f, -0.5f, -2};
    lattice.high = {1, 2, 3};
    for (int i = 0; i < 7 * 24; ++i) lattice.texels.emplace_back(glm::vec4(0, 1, 2, 3) + 0.25f * static_cast<float>(i));
    for (int i = 0; i < 3 * 24; ++i) lattice.cuts.emplace_back(glm::vec4(3, 2, 1, 0) + 0.5f * static_cast<float>(i));
    ProbeDiffuse diffuse;
    diffuse.lattice = std::make_shared<const DiffuseLattice>(lattice);
    SceneLamp lamp;
    lamp.node = "tri";
    lamp.corners = {{0, 3, 0.5}, {1, 3.5, 0}, {0.25, 3, 2}};
    lamp.radiance = {5, 6, 7};
    SceneLamp other = lamp;
    other.bothSides = true;
    diffuse.lamps = {lamp, other, lamp};
    content.diffuse.probes = {diffuse, std::nullopt};
    content.diffuse.countedLights = {3};
    content.writer = "Boxprobe 9";
  }
  std::string pack(const std::string& model) {
    return glbWithProbes(content_, {std::make_shared<const Model>(loadModelFile(file(model)))}, "out.glb");
  }
  GlbScene content_;
};

/// A mesh without symmetry; normals and tangents of unit length.
Mesh oddMesh(float seed, const std::string& name) {
  Mesh mesh;
  mesh.name = name;
  for (int i = 0; i < 4; ++i) {
    const float t = seed + 0.375f * static_cast<float>(i);
    mesh.positions.emplace_back(t, 2.0f - 3.0f * t, t * t);
    mesh.normals.push_back(i % 2 == 0 ? glm::vec3(0, 0.6f, 0.8f) : glm::vec3(0.8f, 0, -0.6f));
    mesh.tangents.emplace_back(1.0f, 0.0f, 0.0f, i < 2 ? 1.0f : -1.0f);
    mesh.uv.emplace_back(0.5f * t, -3.0f * t);
  }
  mesh.indices = {0, 1, 2, 2, 1, 3};
  return mesh;
}

TextureUse textureUse(const std::shared_ptr<const ImageRgba8>& image) {
  TextureUse use;
  use.image = image;
  return use;
}

/// Of two models: materials with every extension, pictures that share samplers and not, a mirrored and a leaning
/// instance, normals that are not of unit length.
GlbDocument joinedDocument() {
  const auto image = std::make_shared<const ImageRgba8>(ImageRgba8{1, 1, {1, 2, 3, 4}, "one"});
  const auto second = std::make_shared<const ImageRgba8>(ImageRgba8{1, 1, {5, 6, 7, 8}, "two"});
  Model first, other;
  first.meshes = {oddMesh(0.25f, "a"), oddMesh(1.5f, "b"), oddMesh(-2.0f, "c")};
  first.meshes[1].normals[2] *= 2.0f;
  first.meshes[1].tangents[1].w = 0.5f;
  first.meshes[1].normals[0] = glm::vec3(0.0f);
  first.meshes[2].uv1 = first.meshes[2].uv;
  first.meshes[2].colors.assign(4, glm::vec4(0.5f, 0.25f, 0.125f, 1.0f));
  first.materials.resize(5);
  Material& coat = first.materials[0];
  coat.name = "coat";
  coat.coatRoughness = 0.25f;
  coat.emissive = {0.5f, 2.5f, 1.0f};
  coat.baseColorTexture = textureUse(image);
  coat.emissiveTexture = textureUse(second);
  coat.emissiveTexture.uvTransform = {
      2.0f * std::cos(0.4f), -2.0f * std::sin(0.4f), -3.0f * std::sin(0.4f), -3.0f * std::cos(0.4f), 0.25f, 0.125f};
  coat.coatTexture = textureUse(image);
  coat.coatTexture.nearest = true;
  coat.coatRoughnessTexture = textureUse(second);
  coat.coatNormalTexture = textureUse(image);
  coat.coatNormalTexture.wrapT = Wrap::MirroredRepeat;
  coat.coatNormalScale = 0.75f;
  Material& glass = first.materials[1];
  glass.name = "glass";
  glass.transmission = 0.5f;
  glass.transmissionTexture = textureUse(image);
  glass.thin = false;
  glass.thickness = 0.5f;
  glass.thicknessMean = 0.25f;
  glass.thicknessTexture = textureUse(second);
  glass.attenuationDistance = 1.5f;
  glass.attenuationColor = {0.25f, 0.5f, 0.75f};
  glass.ior = 1.25f;
  glass.alphaMode = AlphaMode::Mask;
  glass.alphaCutoff = 0.375f;
  Material& finish = first.materials[2];
  finish.name = "finish";
  finish.specular = 0.5f;
  finish.finish.specularEdge = 0.25f;
  finish.finish.specularTint = {0.5f, 0.75f, 0.25f};
  finish.finish.sheenColor = {0.25f, 0.5f, 0.125f};
  finish.finish.sheenRoughness = 0.625f;
  finish.finish.anisotropy = 0.75f;
  finish.finish.anisotropyRotation = 1.25f;
  finish.finish.iridescence = 0.875f;
  finish.finish.filmIor = 1.5f;
  finish.finish.filmThicknessMin = 110.0f;
  finish.finish.filmThicknessMax = 390.0f;
  for (TextureUse* use : finish.finish.textures()) *use = textureUse(image);
  Material& flat = first.materials[3];
  flat.name = "flat";
  flat.unlit = flat.doubleSided = true;
  flat.alphaMode = AlphaMode::Blend;
  flat.normalTexture = flat.occlusionTexture = flat.metallicRoughnessTexture = textureUse(second);
  flat.normalTexture.wrapS = Wrap::ClampToEdge;
  flat.normalTexture.uvSet = 1;
  flat.normalTexture.uvTransform = {1.0f, 0.0f, 0.0f, 1.0f, 0.5f, 0.0f};
  flat.normalScale = 0.75f;
  flat.occlusionStrength = 0.5f;
  Material& dark = first.materials[4];
  dark.name = "dark";
  dark.finish.specularEdge = 0.0f;
  dark.metallic = 0.5f;
  dark.roughness = 0.25f;
  dark.baseColor = {0.125f, 0.25f, 0.5f, 0.75f};
  dark.thickness = 0.75f;
  dark.thicknessMean = 0.0f;
  for (int i = 0; i < 3; ++i) first.meshes[static_cast<std::size_t>(i)].material = i;
  first.instances = {{"plain", 0, glm::dmat4(1.0)},
                     {"again", 0, glm::dmat4(1.0)},
                     {"mirrored", 0, glm::dmat4(1.0)},
                     {"b", 1, glm::dmat4(1.0)},
                     {"leaning", 2, glm::dmat4(1.0)}};
  first.instances[1].worldFromModel[3] = {1, 2, 3, 1};
  first.instances[2].worldFromModel[1][1] = -2.0;
  first.instances[4].worldFromModel[1][0] = 0.5;
  first.instances[4].worldFromModel[2][2] = -1.5;
  first.instances[4].worldFromModel[3] = {4, 5, 6, 1};
  other.meshes = {oddMesh(3.0f, "d")};
  other.materials.resize(1);
  other.meshes[0].material = 0;
  other.meshes[0].tangents.clear();
  other.instances = {{"d", 0, glm::dmat4(1.0)}};
  Scene scene;
  scene.models = {ModelFile{"a.obj"}, ModelFile{"b.ply"}};
  scene.models[1].translation = {7, 8, 9};
  return documentOfModels(scene, {std::make_shared<const Model>(first), std::make_shared<const Model>(other)});
}

TEST_F(GlbValues, EveryNumberOfAFileWithProbes) {
  test::KeptValues values;
  const std::string path = write("out.glb", pack("model.glb"));
  addDocument(values, readGlbDocument(path));
  values.add("== joined models");
  addDocument(values, joinedDocument());
  values.add("== written again from itself: views and bytes");
  // What other programs put behind the probes' bytes is not cut off with them.
  const std::pair<const char*, std::function<void(Json & root, Json & model)>> changes[] = {
      {"as it is", [](Json&, Json&) {}},
      {"without a note", [](Json&, Json& model) { model = nullptr; }},
      {"a view too many", [](Json& root, Json& model) { model["bufferViews"] = root["bufferViews"].size() + 1; }},
      {"all views", [](Json& root, Json& model) { model["bufferViews"] = root["bufferViews"].size(); }},
      {"bytes beyond the end", [](Json&, Json& model) { model["bytes"] = 1e9; }},
      {"too many bytes", [](Json&, Json& model) { model["bytes"] = 1000000000u; }},
      {"too few bytes", [](Json&, Json& model) { model["bytes"] = 8u; }},
      {"an accessor behind",
       [](Json& root, Json&) {
         root["accessors"].push_back(root["accessors"][0]);
         root["accessors"].back()["bufferView"] = 1;
       }},
      {"a picture behind", [](Json& root, Json&) {
         root["images"].push_back({{"bufferView", 2}, {"mimeType", "image/png"}});
       }}};
  for (const auto& [label, change] : changes) {
    GlbDocument document = readGlbDocument(path);
    Json& extension = document.json["extensions"][kGlbExtension];
    change(document.json, extension["model"]);
    write("changed.glb", glbText(document, "changed.glb"));
    content_.scene.models[0].file = file("changed.glb");
    const GlbDocument again = readGlbDocument(write("again.glb", pack("changed.glb")));
    values.add(std::string(label) + ": " + std::to_string(again.json["bufferViews"].size()) + " " +
               std::to_string(again.binary.size()) + " " + again.json["materials"][0]["emissiveFactor"].dump());
  }
  values.expect("unit/values/engine_glb_values.txt");
}

TEST_F(GlbValues, OnlyFilesWithTheExtensionHoldProbes) {
  EXPECT_TRUE(holdsProbes(write("out.glb", pack("model.glb"))));
  EXPECT_FALSE(holdsProbes(file("model.glb")));
  EXPECT_FALSE(holdsProbes(write("text.glb", "hello")));
  EXPECT_FALSE(holdsProbes(write("cut.glb", read("out.glb").substr(0, 15))));
  EXPECT_FALSE(holdsProbes(file("gone.glb")));
  GlbBuilder mentioned;
  mentioned.json["asset"]["generator"] = kGlbExtension;
  EXPECT_FALSE(holdsProbes(write("named.glb", mentioned.glb())));
  mentioned.json["extensions"] = {{"other", 1}};
  EXPECT_FALSE(holdsProbes(write("named.glb", mentioned.glb())));
  EXPECT_EQ(errorText([&] { glbSceneOf(write("text.txt", "hello"), "x"); }), file("text.txt") + ": is no .glb file");
}

TEST_F(GlbValues, EachBrokenValueIsNamed) {
  write("whole.glb", pack("model.glb"));
  const auto refused = [this](const std::function<void(Json & root, Json & extension)>& change) {
    GlbDocument document = readGlbDocument(file("whole.glb"));
    change(document.json, document.json["extensions"][kGlbExtension]);
    const std::string path = write("broken.glb", glbText(document, "broken.glb"));
    const std::string text = errorText([&] { unpackGlb(path, file("opened")); }),
                      start = path + ": BOXPROBE_reflection_probes";
    EXPECT_EQ(text.rfind(start, 0), 0u) << text;
    return text.substr(std::min(start.size(), text.size()));
  };
  using J = Json;
  const std::string again = "; export it again";
  EXPECT_EQ(refused([](J&, J& e) { e.erase("version"); }), ": has no version; this program reads version 1");
  EXPECT_EQ(refused([](J&, J& e) { e["version"] = "1"; }), ": is of version \"1\"; this program reads version 1");
  EXPECT_EQ(refused([](J&, J& e) { e["files"] = 3; }), ".files: is not a list" + again);
  EXPECT_EQ(refused([](J&, J& e) { e["files"][0].erase("name"); }), ".files[0]: has no \"name\"" + again);
  for (const std::string name : {"", ".", "..", "probes", "a/b", "a\\b"}) {
    EXPECT_EQ(refused([&](J&, J& e) { e["files"][0]["name"] = name; }),
              ".files[0]: \"" + name + "\" is no name of a file" + again);
  }
  const std::string longest(199, 'x');
  EXPECT_EQ(refused([&](J&, J& e) { e["files"][0]["name"] = longest; }).rfind(".scene.sky.image: the file holds no", 0),
            std::string::npos)
      << "the name itself may be as long as that";
  EXPECT_EQ(refused([&](J&, J& e) { e["files"][0]["name"] = longest + "x"; }),
            ".files[0]: \"" + longest + "x\" is no name of a file" + again);
  EXPECT_EQ(refused([](J&, J& e) { e["time"] = "now"; }), ".time: is not a number" + again);
  EXPECT_EQ(refused([](J&, J& e) { e["variant"] = 3; }), ".variant: is not a string" + again);
  EXPECT_EQ(refused([](J&, J& e) { e["scene"] = 3; }), ".scene: is no scene" + again);
  EXPECT_EQ(refused([](J&, J& e) { e["scene"]["models"] = 3; }),
            ".scene: has a \"models\", which is the file itself" + again);
  const auto map = [](J& e) -> J& { return e["maps"][0]; };
  EXPECT_EQ(refused([&](J&, J& e) {
              map(e)["capturedAt"] = {1, 2};
            }),
            ".maps[0].capturedAt: is not a list of three numbers" + again);
  EXPECT_EQ(refused([&](J&, J& e) {
              map(e)["capturedRotationDegrees"] = {1, 2, "x"};
            }),
            ".maps[0].capturedRotationDegrees: is not a number" + again);
  EXPECT_EQ(refused([&](J&, J& e) { map(e)["distance"]["size"] = 0; }), ".maps[0].distance.size: is 0" + again);
  EXPECT_EQ(refused([&](J&, J& e) { map(e)["distance"]["size"] = 4097; }),
            ".maps[0].distance.size: is no whole number from 0 to 4096" + again);
  const std::string view = std::to_string(
      map(readGlbDocument(file("whole.glb")).json["extensions"][kGlbExtension])["distance"]["bufferView"].get<int>());
  EXPECT_EQ(refused([&](J&, J& e) { map(e)["distance"]["size"] = 9; }),
            ".maps[0].distance.bufferView: buffer view " + view + " has 1536 bytes and must have 1944" + again);
  EXPECT_EQ(refused([&](J&, J& e) { map(e)["levels"] = J::array(); }),
            ".maps[0]: has no levels, or more than 13" + again);
  EXPECT_EQ(refused([&](J&, J& e) {
              while (map(e)["levels"].size() < 14) map(e)["levels"].push_back(map(e)["levels"][0]);
            }),
            ".maps[0]: has no levels, or more than 13" + again);
  EXPECT_EQ(refused([&](J&, J& e) {
              while (map(e)["levels"].size() < 6) map(e)["levels"].push_back(map(e)["levels"][0]);
            }),
            ".maps[0].levels[0].size: does not fit 6 levels" + again);
  EXPECT_EQ(refused([&](J&, J& e) { map(e)["levels"][0]["size"] = 0; }),
            ".maps[0].levels[0].size: does not fit 3 levels" + again);
  EXPECT_EQ(refused([&](J&, J& e) { map(e)["levels"][1]["size"] = 4; }), ".maps[0].levels[1].size: must be 8" + again);
  EXPECT_EQ(refused([&](J&, J& e) {
              map(e)["irradiance"].push_back({1, 2, 3});
            }),
            ".maps[0]: needs nine \"irradiance\" coefficients" + again);
  EXPECT_EQ(refused([&](J&, J& e) { map(e)["inputs"] = "one"; }), ".maps[0].inputs: is no record of a bake" + again);
  EXPECT_EQ(refused([](J&, J& e) { e["probes"][0]["map"] = 2; }),
            ".probes[0].map: is no whole number from 0 to 1" + again);
  EXPECT_EQ(refused([](J&, J& e) { e["sky"]["map"] = 0; }), ".sky.map: map 0 has an owner already" + again);
  EXPECT_EQ(refused([](J&, J& e) { e["maps"] = J::array(); }), ".probes[0].map: the file has no maps" + again);
}

}  // namespace
}  // namespace boxprobe
