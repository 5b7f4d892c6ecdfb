// `boxprobe export` and `boxprobe import` from outside: files, messages, exit status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "filters/io/image/image_file.h"
#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

const std::vector<std::string> kSmall = {"--set", "probes.room.faceSize=32", "--quiet"};

Outcome exportRoom(const TemporaryFolder& folder, std::vector<std::string> options) {
  std::vector<std::string> arguments = {"export", demoScene("room"), "-o", folder.path("out")};
  arguments.insert(arguments.end(), options.begin(), options.end());
  arguments.insert(arguments.end(), kSmall.begin(), kSmall.end());
  return runProgram(arguments);
}

TEST(Export, WritesThePictureItsDescriptionAndTheEnginesFile) {
  const TemporaryFolder folder;
  const Outcome outcome =
      exportRoom(folder, {"--format", "ktx2", "--ladder", "three", "--stats", folder.path("s.json")});
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_EQ(readFile(folder.path("out/room.ktx2")).substr(1, 6), "KTX 20");
  EXPECT_THAT(readFile(folder.path("out/boxprobe_three.js")), HasSubstr("loadBoxprobe"));
  const Json description = Json::parse(readFile(folder.path("out/room.json")));
  EXPECT_EQ(description["ladder"]["faceSize"], 32);
  EXPECT_EQ(description["box"]["max"], Json({4.0, 3.0, 3.0}));
  EXPECT_EQ(Json::parse(readFile(folder.path("s.json")))["counters"]["facesCaptured"], 12) << "two bounces";
}

TEST(Export, ABakedFileServesAndSmallerSizesAreItsMeans) {
  const TemporaryFolder folder;
  Json scene = Json::parse(readFile(demoScene("room")));
  scene["model"] = std::string(BOXPROBE_DATA_DIR) + "/scenes/room.glb";
  scene["probes"][0]["faceSize"] = 32;
  const std::string path = folder.write("room.boxprobe.json", scene.dump());
  ASSERT_EQ(runProgram({"bake", path, "--quiet"}).exitStatus, 0);
  const auto facesCaptured = [&](const std::string& size) {
    const Outcome outcome = runProgram({"export", path, "-o", folder.path("out"), "--format", "dds", "--size", size,
                                        "--stats", folder.path("s.json"), "--quiet"});
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    return Json::parse(readFile(folder.path("s.json")))["counters"]["facesCaptured"].get<int>();
  };
  EXPECT_EQ(facesCaptured("16"), 0);
  EXPECT_EQ(Json::parse(readFile(folder.path("out/room.json")))["ladder"]["faceSize"], 16);
  EXPECT_EQ(facesCaptured("64"), 12);  // more than was baked: both bounces again
}

TEST(Export, ATechniqueIsOneTextAndNeedsNoDrawing) {
  const TemporaryFolder folder;
  const Outcome outcome = runProgram({"export", demoScene("room"), "-o", folder.path("room.glsl"), "--shader", "glsl",
                                      "--technique", "box+footprint4", "--offscreen", "x"},
                                     DisplayKind::Unset);
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(readFile(folder.path("room.glsl")), HasSubstr("vec4 boxprobeReflection("));
}

TEST(Export, APageNamesTheFilesBesideIt) {
  const TemporaryFolder folder;
  const Outcome outcome = exportRoom(folder, {"--format", "web", "--set", "probes.room.technique=\"sphere+hdrp\""});
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(readFile(folder.path("out/index.html")), HasSubstr("<h1>room</h1>"));
  const Json scene = Json::parse(readFile(folder.path("out/scene.json")));
  EXPECT_EQ(scene["probes"][0]["technique"], "sphere+hdrp");
  EXPECT_EQ(scene["probes"][0]["faceSize"], 32);
  EXPECT_EQ(readFile(folder.path("out/" + scene["probes"][0]["file"].get<std::string>())).substr(1, 6), "KTX 20");
  std::size_t indices = 0;
  for (const Json& object : scene["objects"]) indices += object["count"].get<std::size_t>();
  EXPECT_EQ(readFile(folder.path("out/indices.bin")).size(), 4 * indices);
  for (const Json& technique : scene["shaders"]["techniques"]) {
    for (const Json& piece : technique["pieces"]) EXPECT_TRUE(scene["shaders"]["texts"].contains(piece)) << piece;
  }
}

/// A scene without symmetry, with what a .glb has to carry: a turned box, changed materials, a light, a sky of a file.
std::string glbRoom(const TemporaryFolder& folder) {
  Json scene = Json::parse(readFile(demoScene("room")));
  scene["model"] = std::string(BOXPROBE_DATA_DIR) + "/scenes/room.glb";
  scene["materials"]["floor"] = {{"baseColor", {0.7, 0.6, 0.4}}, {"metallic", 0}, {"roughness", 0.4}};
  scene["lights"] = Json::array({{{"type", "point"}, {"position", {1, 2, 0.5}}, {"intensity", 3}}});
  scene["sky"] = {{"image", "sky.exr"}, {"rotationDegrees", 40}};
  scene["probes"][0]["faceSize"] = 32;
  scene["probes"][0]["rotationDegrees"] = {0, 7, 0};
  ImageRgbaF sky;
  sky.width = 16;
  sky.height = 8;
  for (int i = 0; i < 16 * 8; ++i) {
    for (const float value : {0.1f * static_cast<float>(i % 16), 0.3f, 0.05f * static_cast<float>(i / 16), 1.0f}) {
      sky.pixels.push_back(value);
    }
  }
  saveExr(folder.path("sky.exr"), sky);
  return folder.write("room.boxprobe.json", scene.dump());
}

/// A variable of the environment while this lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value.c_str(), 1);
  }
  ~Variable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(Export, OneFileHoldsTheSceneAndOpensAsItWasBaked) {
  const TemporaryFolder folder;
  const std::string scene = glbRoom(folder), glb = folder.path("out.glb");
  // Unpacked into a place of its own; Mesa's shaders stay where they are.
  const char* home = std::getenv("HOME");
  const char* mesa = std::getenv("MESA_SHADER_CACHE_DIR");
  const Variable shaders("MESA_SHADER_CACHE_DIR",
                         mesa != nullptr ? mesa : std::string(home ? home : "/tmp") + "/.cache");
  const Variable cache("XDG_CACHE_HOME", folder.path("cache"));
  ASSERT_EQ(runProgram({"bake", scene, "--quiet"}).exitStatus, 0);
  const Outcome exported =
      runProgram({"export", scene, "-o", glb, "--format", "glb", "--stats", folder.path("s.json")});
  ASSERT_EQ(exported.exitStatus, 0) << exported.err;
  EXPECT_EQ(exported.out, glb + "\n");
  EXPECT_EQ(Json::parse(readFile(folder.path("s.json")))["counters"]["facesCaptured"], 0) << "baked files serve";
  const auto drawn = [&](const std::string& path, const std::string& picture) {
    const Outcome outcome = runProgram({"render", path, "-o", folder.path(picture), "--size", "48x30", "--camera", "A",
                                        "--stats", folder.path("s.json"), "--quiet"});
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    EXPECT_EQ(Json::parse(readFile(folder.path("s.json")))["counters"]["facesCaptured"], 0) << path;
    return loadHdrImage(folder.path(picture)).pixels;
  };
  const std::vector<float> before = drawn(scene, "before.exr");
  // Nothing beside it is needed.
  for (const char* name : {"room.boxprobe.json", "sky.exr", "room.probes"}) {
    std::filesystem::rename(folder.path(name), folder.path("gone " + std::string(name)));
  }
  EXPECT_EQ(drawn(glb, "after.exr"), before);
  EXPECT_EQ(drawn(glb, "again.exr"), before) << "unpacked before";
  // What a process that was ended left there goes with the next file that is unpacked; a folder of another's is let be.
  namespace fs = std::filesystem;
  const fs::path unpacked = folder.path("cache/boxprobe/glb");
  const fs::path left = unpacked / (std::string(32, 'a') + ".67108849"), other = unpacked / "other.67108849";
  for (const fs::path& made : {left / "probes", other}) fs::create_directories(made);
  EXPECT_NE(before, std::vector<float>(before.size(), 0.0f));
  // The scene on top of the file: a field is set as in any scene.
  const Outcome set = runProgram({"info", glb, "--set", "probes.room.intensity=2", "--quiet"});
  EXPECT_EQ(set.exitStatus, 0) << set.err;
  std::string cut = readFile(glb);
  cut[cut.find("\"version\":1") + 10] = '7';
  const Outcome refused = runProgram({"render", folder.write("seven.glb", cut), "-o", folder.path("no.png")});
  EXPECT_EQ(refused.exitStatus, 2);
  ASSERT_EQ(refused.errLines().size(), 1u) << refused.err;
  EXPECT_THAT(refused.err, AllOf(HasSubstr("seven.glb"), HasSubstr("version")));
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(other));
  // A link there leads to a folder whose permissions are not ours to change.
  const fs::path elsewhere = folder.path("elsewhere");
  fs::create_directory(elsewhere);
  fs::permissions(elsewhere, fs::perms(0755));
  fs::remove_all(unpacked);
  fs::create_directory_symlink(elsewhere, unpacked);
  const Outcome linked = runProgram({"info", glb, "--quiet"});
  EXPECT_EQ(linked.exitStatus, 1);
  EXPECT_THAT(linked.err, HasSubstr("is a link"));
  EXPECT_EQ(fs::status(elsewhere).permissions(), fs::perms(0755));
}

// A folder as the output means NAME.glb in it, which may be the model that the scene reads.
TEST(Export, AGlbNeverTakesThePlaceOfItsModel) {
  const TemporaryFolder folder;
  const std::string model = readFile(std::string(BOXPROBE_DATA_DIR) + "/scenes/room.glb");
  folder.write("room.glb", model);
  Json scene = Json::parse(readFile(demoScene("room")));
  scene["model"] = "room.glb";
  const std::string path = folder.write("room.boxprobe.json", scene.dump());
  for (const std::string& out : {folder.path(""), folder.path("room.glb")}) {
    const Outcome refused = runProgram({"export", path, "-o", out, "--format", "glb", "--size", "16"});
    EXPECT_EQ(refused.exitStatus, 2) << out;
    EXPECT_THAT(refused.err, AllOf(HasSubstr("room.glb"), HasSubstr("this is the input")));
    EXPECT_EQ(readFile(folder.path("room.glb")), model);
  }
}

/// The JSON chunk of a .glb; null while there is none.
Json glbJson(const std::string& path) {
  if (!std::filesystem::exists(path)) return nullptr;
  const std::string bytes = readFile(path);
  std::uint32_t length = 0;
  std::memcpy(&length, &bytes.at(12), 4);
  return Json::parse(bytes.substr(20, length));
}

TEST(Export, WatchingFollowsTheSceneFile) {
  const TemporaryFolder folder;
  const std::string glb = folder.path("live.glb"), path = glbRoom(folder);
  Json scene = Json::parse(readFile(path));
  scene["probes"][0]["bounces"] = 1;
  scene["probes"][0]["rotationDegrees"] = {0, 0, 0};
  const auto save = [&](const std::string& text) {
    folder.write("new.json", text);
    std::filesystem::rename(folder.path("new.json"), path);
  };
  save(scene.dump());
  RunningProgram program({"export", path, "-o", glb, "--format", "glb", "--watch"});
  const auto waitFor = [&](const std::function<bool()>& holds) {
    for (int i = 0; i < 1200 && !program.ended(); ++i) {
      if (holds()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  };
  const auto height = [&] {
    const Json root = glbJson(glb);
    if (root.is_null()) return 0.0;
    const Json& box = root["extensions"]["BOXPROBE_reflection_probes"]["probes"][0]["box"];
    return box["max"][1].get<double>() - box["min"][1].get<double>();
  };
  ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(glb + ".revision"); }));
  EXPECT_NEAR(height(), 3.0, 1e-5);
  save("{\"format\": \"boxprobe-sc");
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_NEAR(height(), 3.0, 1e-5);
  scene["probes"][0]["box"]["max"][1] = 2.5;
  save(scene.dump());
  EXPECT_TRUE(waitFor([&] { return std::abs(height() - 2.5) < 1e-5; }));
  EXPECT_TRUE(waitFor([&] { return Json::parse(readFile(glb + ".revision"))["revision"] == 3; })) << "boxes, then maps";
  ASSERT_TRUE(program.sendAtWork(SIGINT));
  const Outcome outcome = program.finish();
  EXPECT_EQ(outcome.exitStatus, 1);
  EXPECT_THAT(outcome.err, HasSubstr("what was written before stays"));
  EXPECT_THAT(folder.names(), ElementsAre("live.glb", "live.glb.revision", "room.boxprobe.json", "sky.exr"));
}

/// A carton of 40 x 90 x 70 cm, open at one side and with a slanting top.
std::string carton(const TemporaryFolder& folder, const std::string& name, const std::string& color) {
  folder.write(name + ".mtl", "newmtl paint\nKd " + color + "\nPr 0.6\nKs 0.2 0.2 0.2\n");
  return folder.write(name + ".obj", "mtllib " + name + ".mtl\no " + name + R"(
usemtl paint
v 0 0 0
v 40 0 0
v 40 0 70
v 0 0 70
v 0 90 0
v 40 90 0
v 40 80 70
v 0 90 60
f 1 2 3 4
f 8 7 6 5
f 1 5 6 2
f 2 6 7 3
f 3 7 8 4
)");
}

TEST(Export, SeveralModelsAreOneFileThatDrawsTheSame) {
  const TemporaryFolder folder;
  const std::string path = glbRoom(folder), glb = folder.path("out.glb");
  Json scene = Json::parse(readFile(path));
  scene["models"] = Json::array(
      {{{"file", scene["model"]}},
       {{"file", carton(folder, "tall", "0.7 0.3 0.1")}, {"unit", "cm"}, {"translation", {0.4, 0.01, -0.3}}},
       {{"file", carton(folder, "wide", "0.1 0.3 0.6")},
        {"unit", "cm"},
        {"upAxis", "z"},
        {"rotationDegrees", {0, 20, 0}}}});
  scene.erase("model");
  folder.write("room.boxprobe.json", scene.dump());
  const char* home = std::getenv("HOME");
  const char* mesa = std::getenv("MESA_SHADER_CACHE_DIR");
  const Variable shaders("MESA_SHADER_CACHE_DIR",
                         mesa != nullptr ? mesa : std::string(home ? home : "/tmp") + "/.cache");
  const Variable cache("XDG_CACHE_HOME", folder.path("cache"));
  const Outcome exported = runProgram({"export", path, "-o", glb, "--format", "glb", "--quiet"});
  ASSERT_EQ(exported.exitStatus, 0) << exported.err;
  const auto drawn = [&](const std::string& what, const std::string& picture) {
    const Outcome outcome = runProgram({"render", what, "-o", folder.path(picture), "--size", "64x40", "--camera", "A",
                                        "--stats", folder.path("s.json"), "--quiet"});
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    return loadHdrImage(folder.path(picture)).pixels;
  };
  const std::vector<float> before = drawn(path, "before.exr");
  for (const char* name : {"tall.obj", "tall.mtl", "wide.obj"}) std::filesystem::remove(folder.path(name));
  EXPECT_EQ(drawn(glb, "after.exr"), before);
  EXPECT_EQ(Json::parse(readFile(folder.path("s.json")))["counters"]["facesCaptured"], 0) << "maps as they were baked";
}

TEST(Export, WatchingFollowsWhatAModelNames) {
  const TemporaryFolder folder;
  const std::string model = carton(folder, "tall", "0.75 0.25 0.5"), glb = folder.path("live.glb");
  Json scene = Json::parse(readFile(demoScene("room")));
  scene["model"] = model;
  scene["probes"][0].update({{"faceSize", 16}, {"bounces", 1}});
  const std::string path = folder.write("live.boxprobe.json", scene.dump());
  RunningProgram program({"export", path, "-o", glb, "--format", "glb", "--watch", "--quiet"});
  const auto waitFor = [&](double red) {
    for (int i = 0; i < 1200 && !program.ended(); ++i) {
      const Json root = glbJson(glb);
      if (!root.is_null() && root["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][0] == red) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  };
  ASSERT_TRUE(waitFor(0.75));
  folder.write("tall.mtl", "newmtl paint\nKd 0.5 0.25 0.25\n");
  EXPECT_TRUE(waitFor(0.5)) << "its MTL file alone was saved";
  program.sendAtWork(SIGINT);
  program.finish();
}

TEST(Export, BadUsageIsOneLineAndWritesNothing) {
  const TemporaryFolder folder;
  folder.write("file", "");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--format", "png"}, "ktx2, dds, exr, hdr"},
      {{"--ladder", "quake"}, "no such ladder"},
      {{"--size", "100"}, "power of two"},
      {{"--probe", "hall"}, "no such probe"},
      {{"--technique", "box"}, "--shader"},
      {{"--format", "web", "--ladder", "three"}, "whole scene"},
      {{"--format", "web", "--center"}, "whole scene"},
      {{"--format", "glb", "--ladder", "three"}, "whole scene"},
      {{"--format", "glb", "--lossy"}, "whole scene"},
      {{"--shader", "wgsl"}, "glsl, hlsl, godot"},
      {{"--shader", "glsl", "--technique", "impostor"}, "distances"},
  };
  for (const auto& [options, message] : cases) {
    const Outcome outcome = exportRoom(folder, options);
    EXPECT_EQ(outcome.exitStatus, 2) << options[0];
    ASSERT_EQ(outcome.errLines().size(), 1u) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message));
  }
  const Outcome file = runProgram({"export", demoScene("room"), "-o", folder.path("file")});
  EXPECT_EQ(file.exitStatus, 2);
  EXPECT_THAT(file.err, HasSubstr("this is a file"));
  EXPECT_THAT(folder.names(), ElementsAre("file"));
}

TEST(Export, WhatAHalfFloatCannotHoldIsSaid) {
  const TemporaryFolder folder;
  ImageRgbaF sky;
  sky.width = 64;
  sky.height = 32;
  sky.pixels.assign(std::size_t(4) * 64 * 32, 1.0f);
  sky.pixels[4 * (10 * 64 + 20)] = 1e6f;
  saveExr(folder.path("sky.exr"), sky);
  const std::vector<std::string> custom = {"--set", "probes.room.mode=\"custom\"", "--set",
                                           "probes.room.image=\"" + folder.path("sky.exr") + "\""};
  const Outcome refused = exportRoom(folder, custom);
  EXPECT_EQ(refused.exitStatus, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("probes.room"), HasSubstr("65504"), HasSubstr("--lossy")));
  std::vector<std::string> lossy = custom;
  lossy.push_back("--lossy");
  EXPECT_EQ(exportRoom(folder, lossy).exitStatus, 0);
}

TEST(Export, EnginesWithOneCentreAreWarnedAbout) {
  const TemporaryFolder folder;
  const auto warned = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"export", demoScene("room"), "-o", folder.path("out"), "--size", "16"});
    const Outcome outcome = runProgram(options);
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(warned({"--ladder", "bevy"}), HasSubstr("--center"));
  EXPECT_THAT(warned({"--set", "probes.room.name=\"main hall\""}), HasSubstr("named main_hall"));
  EXPECT_THAT(warned({"--ladder", "bevy", "--center"}), Not(HasSubstr("--center")));
}

TEST(Import, MakesASceneOfAGodotSceneAndRefusesOtherFiles) {
  const TemporaryFolder folder;
  const std::string godot = folder.write("room.tscn",
                                         "[gd_scene format=3]\n[node name=\"Room\" type=\"Node3D\"]\n[node name=\"P\" "
                                         "type=\"ReflectionProbe\" parent=\".\"]\n"
                                         "size = Vector3(8, 3, 6)\nbox_projection = true\n");
  const Outcome outcome = runProgram({"import", godot, "-o", folder.path("room.boxprobe.json")});
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  const Json scene = Json::parse(readFile(folder.path("room.boxprobe.json")));
  EXPECT_EQ(scene["probes"][0]["name"], "P");
  EXPECT_EQ(scene["probes"][0]["box"]["max"], Json({4.0, 1.5, 3.0}));
  EXPECT_EQ(runProgram({"info", folder.path("room.boxprobe.json"), "--quiet"}).exitStatus, 0);
  for (const auto& [file, message] :
       {std::pair{folder.write("a.txt", "hello"), "neither"}, {folder.path("none.tscn"), "none.tscn"}}) {
    const Outcome refused = runProgram({"import", file, "-o", folder.path("b.boxprobe.json")});
    EXPECT_EQ(refused.exitStatus, 2);
    EXPECT_THAT(refused.err, HasSubstr(message));
  }
  EXPECT_EQ(runProgram({"import", godot, "-o", folder.path("scene.txt")}).exitStatus, 2);
}

}  // namespace
}  // namespace boxprobe::test
