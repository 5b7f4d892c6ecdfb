// Values of glTF files that are of another type than the format says: each is told with its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "filters/io/gltf/gltf_parts.h"
#include "filters/io/gltf/model_file.h"
#include "tests/unit/io_glb_builder.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using Json = nlohmann::json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// What people export, with right types throughout.
Json sound() {
  return Json::parse(R"({
    "asset": {"version": "2.0", "generator": 5}, "scene": 0,
    "scenes": [{"nodes": [0, 1], "name": "hall"}],
    "nodes": [{"name": "a", "mesh": 0, "translation": [1, 2.5, 3], "rotation": [0, 0, 0, 1], "children": [2],
               "extensions": {"KHR_lights_punctual": {"light": 0}}, "weights": [0.5]},
              {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}, {"camera": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "_WornTexture": 1}, "material": 0, "mode": 4,
                                "targets": [{"POSITION": 0}]}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1], "metallicFactor": 0,
                     "baseColorTexture": {"index": 0, "texCoord": 1,
                       "extensions": {"KHR_texture_transform": {"offset": [0, 1], "scale": [2, 2], "rotation": 1}}}},
                   "normalTexture": {"index": 0, "scale": 0.5}, "alphaMode": "MASK", "doubleSided": true,
                   "extensions": {"KHR_materials_ior": {"ior": 1.4}, "VENDOR_any": {"ior": "x", "nodes": "y"}},
                   "extras": {"alphaCutoff": "half", "normalTexture": 3}}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 1}}],
    "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "color": [1, 1, 0.5], "intensity": 7,
                                                       "spot": {"innerConeAngle": 0, "outerConeAngle": 1}}]}}
  })");
}

std::vector<std::string> warnings(const Json& root) {
  GltfFile file;
  warnOfTypes(file, root);
  return file.warnings;
}

/// The only warning once the value at `pointer` is another.
std::string warning(const char* pointer, const Json& value) {
  Json root = sound();
  root[Json::json_pointer(pointer)] = value;
  const std::vector<std::string> told = warnings(root);
  EXPECT_LE(told.size(), 1u) << pointer;
  return told.empty() ? "" : told.front();
}

TEST(ModelTypes, RightOnesAreNotTold) {
  EXPECT_THAT(warnings(sound()), IsEmpty());
}

TEST(ModelTypes, EachKindIsToldWithPlaceAndValue) {
  EXPECT_EQ(warning("/scene", "0"), "scene: must be a whole number, 0 or more, not \"0\"");
  EXPECT_EQ(warning("/nodes", 4), "nodes: must be a list of objects in brackets, not 4");
  EXPECT_EQ(warning("/nodes/1", 4), "nodes[1]: must be an object in braces, not 4");
  EXPECT_EQ(warning("/extensionsUsed", {3}), "extensionsUsed[0]: must be text in quotes, not 3");
  EXPECT_EQ(warning("/scenes/0/nodes", Json::parse("[0, -1]")),
            "scenes[0].nodes[1]: must be a whole number, 0 or more, not -1");
  EXPECT_EQ(warning("/nodes/0/mesh", -1), "nodes[0].mesh: must be a whole number, 0 or more, not -1");
  EXPECT_EQ(warning("/nodes/0/name", 7), "nodes[0].name: must be text in quotes, not 7");
  EXPECT_EQ(warning("/nodes/0/translation", "far"), "nodes[0].translation: must be 3 numbers in brackets, not \"far\"");
  EXPECT_EQ(warning("/nodes/0/translation", {1, 2}), "nodes[0].translation: must be 3 numbers in brackets, not [1,2]");
  EXPECT_EQ(warning("/nodes/1/matrix", {1, 0, 0, 0, 1}),
            "nodes[1].matrix: must be 16 numbers in brackets, not a list of 5");
  EXPECT_EQ(warning("/nodes/0/weights", {"a"}), "nodes[0].weights[0]: must be a number, not \"a\"");
  EXPECT_EQ(warning("/nodes/1/matrix/5", nullptr), "nodes[1].matrix[5]: must be a number, not null");
  EXPECT_EQ(warning("/meshes/0/primitives/0/mode", 4.0),
            "meshes[0].primitives[0].mode: must be a whole number, 0 or more, not 4.0");
  EXPECT_EQ(warning("/materials/0/doubleSided", 1), "materials[0].doubleSided: must be true or false, not 1");
  EXPECT_EQ(warning("/materials/0/pbrMetallicRoughness", true),
            "materials[0].pbrMetallicRoughness: must be an object in braces, not true");
  EXPECT_EQ(warning("/materials/0/pbrMetallicRoughness/metallicFactor", "0"),
            "materials[0].pbrMetallicRoughness.metallicFactor: must be a number, not \"0\"");
  EXPECT_EQ(warning("/materials/0/emissiveFactor", {1, 1, 1, 1}),
            "materials[0].emissiveFactor: must be 3 numbers in brackets, not [1,1,1,1]");
  EXPECT_EQ(warning("/cameras/0/perspective/yfov", Json::object()),
            "cameras[0].perspective.yfov: must be a number, not an object");
}

TEST(ModelTypes, TexturesAndExtensionsAreToldAsWell) {
  EXPECT_EQ(warning("/materials/0/normalTexture", 0), "materials[0].normalTexture: must be an object in braces, not 0");
  EXPECT_EQ(warning("/materials/0/normalTexture/index", "0"),
            "materials[0].normalTexture.index: must be a whole number, 0 or more, not \"0\"");
  EXPECT_EQ(warning("/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset", 1),
            "materials[0].pbrMetallicRoughness.baseColorTexture.extensions.KHR_texture_transform.offset: must be 2 "
            "numbers in brackets, not 1");
  EXPECT_EQ(warning("/materials/0/extensions/KHR_materials_ior", 1.4),
            "materials[0].extensions.KHR_materials_ior: must be an object in braces, not 1.4");
  EXPECT_EQ(warning("/materials/0/extensions", Json::array()),
            "materials[0].extensions: must be an object in braces, not []");
  EXPECT_EQ(warning("/extensions/KHR_lights_punctual/lights/0/intensity", "bright"),
            "extensions.KHR_lights_punctual.lights[0].intensity: must be a number, not \"bright\"");
  EXPECT_EQ(warning("/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", false),
            "extensions.KHR_lights_punctual.lights[0].spot.outerConeAngle: must be a number, not false");
}

TEST(ModelTypes, OneLineAFieldHoweverMany) {
  Json root = sound();
  for (int i = 0; i < 5; ++i) root["materials"].push_back({{"alphaCutoff", "a\nb" + std::string(100, 'c')}});
  root["materials"][3]["alphaCutoff"] = 0.25;
  root["materials"][2]["doubleSided"] = "yes";
  EXPECT_THAT(warnings(root), ElementsAre("materials[1].alphaCutoff: must be a number, not \"a\\nb" +
                                              std::string(32, 'c') + "...; 3 more like it",
                                          "materials[2].doubleSided: must be true or false, not \"yes\""));
}

class ModelTypesFile : public TemporaryFolder {};

TEST_F(ModelTypesFile, AreWarningsOfTheModel) {
  GlbBuilder glb;
  glb.triangle();
  glb.json["materials"] = {{{"pbrMetallicRoughness", {{"roughnessFactor", "smooth"}}}}};
  const Model model = loadModelFile(write("m.glb", glb.glb()));
  EXPECT_EQ(model.triangleCount(), 1u);
  EXPECT_THAT(model.warnings,
              ElementsAre("materials[0].pbrMetallicRoughness.roughnessFactor: must be a number, not \"smooth\""));
}

}  // namespace
}  // namespace boxprobe
