// `boxprobe export` and `boxprobe import` from outside: files, messages, exit status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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
