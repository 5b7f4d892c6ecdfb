// Models broken in forty and more ways, given to the program: exit status 2, one line that names the file, no output.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/cli/program.h"
#include "tests/unit/io_glb_builder.h"

namespace boxprobe::test {
namespace {

using Json = nlohmann::json;
using Damage = std::function<void(GlbBuilder&)>;

/// A sound file with a bit of everything: an indexed triangle, a picture, a camera, a lamp.
GlbBuilder sound() {
  GlbBuilder glb;
  const int indices = glb.accessor(glb.view(std::vector<std::uint16_t>{0, 1, 2, 0}), GlbBuilder::UShort, "SCALAR", 3);
  glb.triangle({{"indices", indices}, {"material", 0}});
  glb.json["materials"] = Json::array({{{"emissiveTexture", {{"index", 0}}}}});
  glb.json["textures"] = Json::array({{{"source", 0}, {"sampler", 0}}});
  glb.json["samplers"] = Json::array({Json::object()});
  glb.json["images"] = Json::array({{{"uri", "picture.png"}}});
  glb.json["cameras"] = Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}});
  glb.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({{{"type", "point"}}});
  glb.node({{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  return glb;
}

Json& accessor(GlbBuilder& glb, int index) {
  return glb.json["accessors"][static_cast<std::size_t>(index)];
}
Json& primitive(GlbBuilder& glb) {
  return glb.json["meshes"][0]["primitives"][0];
}
void draco(GlbBuilder& glb, int view) {
  glb.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  primitive(glb)["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view},
                                                                {"attributes", {{"POSITION", 0}}}};
}

std::vector<std::pair<std::string, Damage>> damages() {
  const float nan = std::numeric_limits<float>::quiet_NaN(), huge = 1e30f;
  return {
      {"count past the buffer", [](GlbBuilder& g) { accessor(g, 1)["count"] = 9; }},
      {"count of 10^9", [](GlbBuilder& g) { accessor(g, 1)["count"] = 1000000000; }},
      {"count of 10^9 without data",
       [](GlbBuilder& g) { accessor(g, 1).erase("bufferView"), accessor(g, 1)["count"] = 1000000000; }},
      {"count that overflows", [](GlbBuilder& g) { accessor(g, 1)["count"] = 1537228672809129302u; }},
      {"negative count", [](GlbBuilder& g) { accessor(g, 1)["count"] = -3; }},
      {"accessor offset", [](GlbBuilder& g) { accessor(g, 1)["byteOffset"] = 20; }},
      {"accessor of no view", [](GlbBuilder& g) { accessor(g, 1)["bufferView"] = 7; }},
      {"component type", [](GlbBuilder& g) { accessor(g, 1)["componentType"] = 5130; }},
      {"positions of two numbers", [](GlbBuilder& g) { accessor(g, 1)["type"] = "VEC2"; }},
      {"indices that are floats", [](GlbBuilder& g) { accessor(g, 0)["componentType"] = 5126; }},
      {"index out of range", [](GlbBuilder& g) { g.buffer[2] = 7; }},
      {"view past the buffer", [](GlbBuilder& g) { g.json["bufferViews"][1]["byteLength"] = 4096; }},
      {"view offset", [](GlbBuilder& g) { g.json["bufferViews"][1]["byteOffset"] = 4096; }},
      {"view of no buffer", [](GlbBuilder& g) { g.json["bufferViews"][1]["buffer"] = 4; }},
      {"stride too small", [](GlbBuilder& g) { g.json["bufferViews"][1]["byteStride"] = 4; }},
      {"NaN position", [nan](GlbBuilder& g) { std::memcpy(g.buffer.data() + 8 + 16, &nan, 4); }},
      {"position beyond numbers", [huge](GlbBuilder& g) { std::memcpy(g.buffer.data() + 8 + 16, &huge, 4); }},
      {"no POSITION",
       [](GlbBuilder& g) {
         primitive(g)["attributes"] = {{"NORMAL", 1}};
       }},
      {"attribute of no accessor", [](GlbBuilder& g) { primitive(g)["attributes"]["NORMAL"] = 44; }},
      {"attribute of another length",
       [](GlbBuilder& g) {
         primitive(g)["attributes"]["COLOR_0"] = g.floats("VEC3", 3, {0, 0, 0});
       }},
      {"colours of two numbers",
       [](GlbBuilder& g) {
         primitive(g)["attributes"]["COLOR_0"] = g.floats("VEC2", 2, {0, 0, 0, 0, 0, 0});
       }},
      {"second coordinates of another length",
       [](GlbBuilder& g) {
         primitive(g)["attributes"]["TEXCOORD_1"] = g.floats("VEC2", 2, {0, 0});
       }},
      {"no such material", [](GlbBuilder& g) { primitive(g)["material"] = 12; }},
      {"no such mesh", [](GlbBuilder& g) { g.json["nodes"][0]["mesh"] = 4; }},
      {"no such child", [](GlbBuilder& g) { g.json["nodes"][0]["children"] = {8}; }},
      {"a node within itself", [](GlbBuilder& g) { g.json["nodes"][0]["children"] = {0}; }},
      {"two nodes in a circle",
       [](GlbBuilder& g) { g.json["nodes"][0]["children"] = {1}, g.json["nodes"][1]["children"] = {0}; }},
      {"no such scene", [](GlbBuilder& g) { g.json["scene"] = 5; }},
      {"matrix of three numbers",
       [](GlbBuilder& g) {
         g.json["nodes"][0]["matrix"] = {1, 0, 0};
       }},
      {"rotation of length 0",
       [](GlbBuilder& g) {
         g.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
       }},
      {"scale beyond numbers",
       [](GlbBuilder& g) {
         g.json["nodes"][0]["scale"] = {1e200, 1, 1};
       }},
      {"no such texture", [](GlbBuilder& g) { g.json["materials"][0]["emissiveTexture"]["index"] = 3; }},
      {"no such coat texture",
       [](GlbBuilder& g) {
         g.json["materials"][0]["extensions"]["KHR_materials_clearcoat"]["clearcoatTexture"]["index"] = 9;
       }},
      {"no such image", [](GlbBuilder& g) { g.json["textures"][0]["source"] = 3; }},
      {"no such sampler", [](GlbBuilder& g) { g.json["textures"][0]["sampler"] = 3; }},
      {"image out of the folder", [](GlbBuilder& g) { g.json["images"][0]["uri"] = "../../etc/passwd"; }},
      {"image out of the folder, escaped", [](GlbBuilder& g) { g.json["images"][0]["uri"] = "%2e%2e/a.png"; }},
      {"image in no view",
       [](GlbBuilder& g) {
         g.json["images"][0] = {{"bufferView", 8}, {"mimeType", "image/png"}};
       }},
      {"no such light", [](GlbBuilder& g) { g.json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 2; }},
      {"no such camera", [](GlbBuilder& g) { g.json["nodes"][1]["camera"] = 2; }},
      {"camera of no angle", [](GlbBuilder& g) { g.json["cameras"][0]["perspective"]["yfov"] = 0; }},
      {"sparse index out of range",
       [](GlbBuilder& g) {
         const int i = g.view(std::vector<std::uint16_t>{9}), v = g.view(std::vector<float>{1, 2, 3});
         accessor(g, 1)["sparse"] = {
             {"count", 1}, {"indices", {{"bufferView", i}, {"componentType", 5123}}}, {"values", {{"bufferView", v}}}};
       }},
      {"sparse count",
       [](GlbBuilder& g) {
         accessor(g, 1)["sparse"] = {{"count", 1000000000},
                                     {"indices", {{"bufferView", 0}, {"componentType", 5123}}},
                                     {"values", {{"bufferView", 1}}}};
       }},
      {"unknown required extension", [](GlbBuilder& g) { g.json["extensionsRequired"] = {"EXT_made_up"}; }},
      {"Basis required", [](GlbBuilder& g) { g.json["extensionsRequired"] = {"KHR_texture_basisu"}; }},
      {"Draco data that is none", [](GlbBuilder& g) { draco(g, 0); }},
      {"Draco data that is nowhere", [](GlbBuilder& g) { draco(g, 999); }},
      {"glTF 1.0", [](GlbBuilder& g) { g.json["asset"]["version"] = "1.0"; }},
  };
}

class BadModel : public ::testing::Test {
 protected:
  void expectRefused(const std::string& kind, const std::string& name, const std::string& bytes) {
    const std::string path = folder.write(name, bytes);
    const Outcome outcome = runProgram({"info", path}, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 2) << kind << ": " << outcome.err;
    EXPECT_EQ(outcome.out, "") << kind;
    EXPECT_EQ(outcome.errLines().size(), 1u) << kind << ": " << outcome.err;
    EXPECT_THAT(outcome.err, testing::HasSubstr(name)) << kind;
    ++refused;
  }
  TemporaryFolder folder;
  int refused = 0;
};

TEST_F(BadModel, EachKindOfDamageIsOneLineAndStatusTwo) {
  const std::string image = readFile(std::string(BOXPROBE_DATA_DIR) + "/pictures/front.png");
  folder.write("picture.png", image);
  const std::string whole = sound().glb();
  ASSERT_EQ(runProgram({"info", folder.write("sound.glb", whole)}, DisplayKind::Unset).exitStatus, 0);
  for (const auto& [kind, damage] : damages()) {
    GlbBuilder glb = sound();
    damage(glb);
    expectRefused(kind, "m.glb", glb.glb());
  }
  expectRefused("cut off in the middle", "m.glb", whole.substr(0, whole.size() / 2));
  expectRefused("cut off in the header", "m.glb", whole.substr(0, 9));
  expectRefused("wrong magic", "m.glb", "FTlg" + whole.substr(4));
  expectRefused("empty", "m.glb", "");
  expectRefused("missing buffer file", "m.gltf", sound().gltf("gone.bin"));
  expectRefused("buffer out of the folder", "m.gltf", sound().gltf("/etc/passwd"));
  expectRefused("JSON that ends early", "m.gltf", "{\"asset\": {");
  expectRefused("OBJ index out of range", "m.obj", "v 0 0 0\nf 1 2 3\n");
  expectRefused("PLY of 10^9 points", "m.ply", "ply\nformat ascii 1.0\nelement vertex 1000000000\nend_header\n");
  expectRefused("STL cut off", "m.stl", std::string(100, 'x'));
  expectRefused("VTP that is not", "m.vtp", "<a></a>");
  EXPECT_GE(refused, 58);
}

TEST_F(BadModel, APictureThatCannotBeReadIsNamedAndRefusesNothing) {
  const std::string image = readFile(std::string(BOXPROBE_DATA_DIR) + "/pictures/front.png");
  folder.write("cut.png", image.substr(0, 300));
  folder.write("text.png", "this is text");
  for (const char* name : {"cut.png", "text.png"}) {
    GlbBuilder glb = sound();
    glb.json["images"][0]["uri"] = name;
    const Outcome outcome = runProgram({"info", folder.write("m.glb", glb.glb())}, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    EXPECT_THAT(outcome.out, testing::HasSubstr(std::string("m.glb: image 0 (") + name + ")"));
  }
}

}  // namespace
}  // namespace boxprobe::test
