// `cmake --install` to a folder nobody has heard of: the program runs from there with the data that lies there, and a
// program that is none of the project's is configured, built and run against it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "filters/io/image/image_file.h"
#include "tests/cli/program.h"

namespace {

using namespace boxprobe;
using boxprobe::test::readFile;
using boxprobe::test::TemporaryFolder;
namespace fs = std::filesystem;

class Installed : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    ASSERT_TRUE(run(BOXPROBE_CMAKE " --install " BOXPROBE_BUILD_DIR " --prefix '" + prefix() + "'", "install")) << log_;
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static std::string path(const std::string& below) { return folder_->path(below); }
  static std::string prefix() { return path("a prefix"); }
  static std::string installed(const std::string& below) { return prefix() + "/" + below; }
  /// Standard output and error are in log_ afterwards.
  static bool run(const std::string& command, const std::string& name) {
    const std::string file = path(name + ".log");
    const bool done = std::system(("( " + command + " ) >'" + file + "' 2>&1").c_str()) == 0;
    log_ = readFile(file);
    return done;
  }
  static bool configure(const std::string& source, const std::string& build) {
    return run(std::string(BOXPROBE_CMAKE " -G '" BOXPROBE_GENERATOR "' -S '") + source + "' -B '" + build +
                   "' -DCMAKE_CXX_COMPILER=" BOXPROBE_CXX + " -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH='" +
                   prefix() + "'",
               "configure");
  }

  static TemporaryFolder* folder_;
  static std::string log_;
};
TemporaryFolder* Installed::folder_ = nullptr;
std::string Installed::log_;

/// The same model with materials that emit the picture they had and are black otherwise. Of a GLB's two chunks the JSON
/// comes first.
void writeShining(const std::string& from, const std::string& to) {
  const std::string bytes = readFile(from);
  std::uint32_t length = 0;
  std::memcpy(&length, &bytes[12], 4);
  nlohmann::json model = nlohmann::json::parse(bytes.substr(20, length));
  for (nlohmann::json& material : model["materials"]) {
    nlohmann::json& base = material["pbrMetallicRoughness"];
    if (base.count("baseColorTexture") == 0) continue;
    material.erase("extensions");
    material["emissiveTexture"] = base["baseColorTexture"];
    material["emissiveFactor"] = {1.0, 1.0, 1.0};
    base["baseColorFactor"] = {0.0, 0.0, 0.0, 1.0};
  }
  std::string json = model.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string out = bytes.substr(0, 20) + json + bytes.substr(20 + length);
  const auto put = [&out](std::size_t at, std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    std::memcpy(&out[at], &number, 4);
  };
  put(8, out.size());
  put(12, json.size());
  std::ofstream(to, std::ios::binary) << out;
}

TEST_F(Installed, TheProgramTakesTheDataThatLiesBesideIt) {
  ASSERT_TRUE(run("'" + installed("bin/boxprobe") + "' lessons", "lessons")) << log_;
  EXPECT_NE(log_.find("floor-mirror"), std::string::npos) << log_;
  // Not that of the build folder, which is still there.
  fs::rename(installed("share/boxprobe/lessons"), installed("share/boxprobe/elsewhere"));
  EXPECT_FALSE(run("'" + installed("bin/boxprobe") + "' lessons", "lessons")) << log_;
  EXPECT_NE(log_.find(installed("share/boxprobe/lessons")), std::string::npos) << log_;
}

TEST_F(Installed, AnotherProgramLightsItsActors) {
  const std::string build = path("example");
  ASSERT_TRUE(configure(BOXPROBE_SOURCE_DIR "/tests/install/example", build)) << log_;
  ASSERT_TRUE(run(BOXPROBE_CMAKE " --build '" + build + "'", "build")) << log_;
  // VTK's importer knows no unlit materials: the walls shine by themselves instead.
  const std::string model = path("shining.glb");
  writeShining(installed("share/boxprobe/scenes/six-faces.glb"), model);
  const std::string scene = folder_->write("shining.boxprobe.json", R"({"format": "boxprobe-scene", "version": 1,
    "model": "shining.glb", "sky": {"color": [0, 0, 0]}, "objects": {"ball": {"seenByProbes": false}},
    "cameras": {"main": {"position": [0.9, 0.5, 1.8], "target": [0, 0, 0], "up": [0, 1, 0], "verticalFovDegrees": 30}},
    "probes": [{"name": "cube", "origin": [0, 0, 0], "box": {"min": [-2, -2, -2], "max": [2, 2, 2]}, "blendDistance": 0}]})");
  const std::string picture = path("theirs.png"), ours = path("ours.png");
  ASSERT_TRUE(run("'" + build + "/probe_in_renderer' '" + model + "' '" + picture + "'", "example")) << log_;
  ASSERT_TRUE(run(
      "'" + installed("bin/boxprobe") + "' render '" + scene + "' -o '" + ours + "' --size 300x300 --samples 1 --quiet",
      "render"))
      << log_;
  const ImageRgba8 a = loadImage8(picture), b = loadImage8(ours);
  ASSERT_EQ(a.pixels.size(), b.pixels.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double difference = (int{a.pixels[i]} - int{b.pixels[i]}) / 255.0;
    sum += i % 4 != 3 ? difference * difference : 0.0;
  }
  const double psnr = 10.0 * std::log10(static_cast<double>(a.pixels.size()) * 0.75 / std::max(sum, 1e-9));
  std::printf("the example's picture against the program's: %.1f dB\n", psnr);
  // What is left is how two importers read a material; the light itself is compared by actor_probes_test.
  EXPECT_GT(psnr, 30.0);
}

TEST_F(Installed, TheLibrariesEnterASharedOne) {
  const std::string build = path("shared");
  ASSERT_TRUE(configure(BOXPROBE_SOURCE_DIR "/tests/install/shared", build)) << log_;
  ASSERT_TRUE(run(BOXPROBE_CMAKE " --build '" + build + "'", "build")) << log_;
  EXPECT_TRUE(run("'" + build + "/probes_host'", "host")) << log_;
  // It offers what public headers declare, and nothing of what stands behind them.
  ASSERT_TRUE(run("nm -DC --defined-only '" + build + "/libprobes_plugin.so'", "symbols")) << log_;
  EXPECT_NE(log_.find(" countProbes"), std::string::npos) << log_;
  EXPECT_NE(log_.find(" vtkReflectionProbes::New()"), std::string::npos) << log_;
  for (const char* hidden : {" boxprobe::validate(", " boxprobe::ActorParts::", " vtkProbePass::", " nlohmann::"}) {
    EXPECT_EQ(log_.find(hidden), std::string::npos) << hidden;
  }
}

// As after a build of the program alone, `./run`.
TEST_F(Installed, WhatWasNotBuiltIsBuiltThen) {
  fs::remove_all(BOXPROBE_BUILD_DIR "/app/install/man1");
  fs::remove(BOXPROBE_BUILD_DIR "/app/install/man1.stamp");
  fs::remove(BOXPROBE_BUILD_DIR "/filters/vtk/libboxprobe_placement.a");
  const std::string prefix = path("another prefix");
  ASSERT_TRUE(run(BOXPROBE_CMAKE " --install " BOXPROBE_BUILD_DIR " --prefix '" + prefix + "'", "again")) << log_;
  EXPECT_TRUE(fs::exists(prefix + "/share/man/man1/boxprobe.1.gz"));
  const auto is = [](const fs::path& file) { return file.filename() == "libboxprobe_placement.a"; };
  EXPECT_TRUE(std::any_of(fs::recursive_directory_iterator(prefix), fs::recursive_directory_iterator(), is));
}

TEST_F(Installed, TheMathematicsNeedNoVtk) {
  folder_->write("CMakeLists.txt",
                 "cmake_minimum_required(VERSION 3.25)\nproject(mathematics CXX)\n"
                 "find_package(Boxprobe " BOXPROBE_VERSION
                 " REQUIRED COMPONENTS Math Core)\n"
                 "if(TARGET VTK::CommonCore OR TARGET Boxprobe::IO OR NOT TARGET Boxprobe::Core)\n"
                 "  message(FATAL_ERROR \"more or less than was asked for\")\nendif()\n");
  EXPECT_TRUE(configure(path(""), path("mathematics"))) << log_;
  folder_->write("CMakeLists.txt",
                 "cmake_minimum_required(VERSION 3.25)\nproject(mathematics CXX)\n"
                 "find_package(Boxprobe REQUIRED COMPONENTS Maths)\n");
  EXPECT_FALSE(configure(path(""), path("maths")));
  EXPECT_NE(log_.find("has no component Maths"), std::string::npos) << log_;
}

TEST_F(Installed, ThereIsAManualPageForEachCommand) {
  EXPECT_TRUE(fs::exists(installed("share/man/man1/boxprobe.1.gz")));
  ASSERT_TRUE(run("zcat '" + installed("share/man/man1/boxprobe-render.1.gz") + "'", "manual")) << log_;
  EXPECT_NE(log_.find("\\-\\-technique"), std::string::npos);
}

TEST_F(Installed, TheShellCompletesCommandsAndOptions) {
  const std::string source = "PATH='" + installed("bin") + "':$PATH; source '" +
                             installed("share/bash-completion/completions/boxprobe") + "'; ";
  ASSERT_TRUE(run("bash -c \"" + source + "COMP_WORDS=(boxprobe render --te); COMP_CWORD=2; _boxprobe; " +
                      "echo \\${COMPREPLY[@]}; COMP_WORDS=(boxprobe ren); COMP_CWORD=1; _boxprobe; " +
                      "echo \\${COMPREPLY[@]}\"",
                  "completion"))
      << log_;
  EXPECT_EQ(log_, "--technique\nrender\n");
}

}  // namespace
