// What a run of the program keeps, refuses and works out without drawing: shared work, times left, colours of
// differences, names of outputs, the light of a fit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/session/display_picture.h"
#include "app/session/environment_check.h"
#include "app/session/fit_light_errors.h"
#include "app/session/fit_scene.h"
#include "app/session/glb_export.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/output_check.h"
#include "app/session/scene_review.h"
#include "app/session/shared_work.h"
#include "app/session/stats_json.h"
#include "app/session/time_left.h"
#include "tests/support/kept_values.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(TimeLeft, FollowsFromWhatIsDone) {
  TimeLeft left;
  EXPECT_FALSE(left.update(0.1, 10.0)) << "it starts here";
  EXPECT_FALSE(left.update(0.119, 20.0)) << "too little done";
  EXPECT_FALSE(left.update(0.2, 10.9)) << "too short a time";
  EXPECT_NEAR(*left.update(0.3, 14.0), 4.0 / 0.2 * 0.7, 1e-9);
  EXPECT_NEAR(*left.update(0.3, 14.0), 14.0, 1e-9) << "standing still is no falling back";
  EXPECT_NEAR(*left.update(1.0, 20.0), 0.0, 1e-9);
  EXPECT_FALSE(left.update(0.5, 21.0)) << "work was added";
  EXPECT_NEAR(*left.update(0.75, 26.0), 5.0, 1e-9);
  left.restart();
  EXPECT_FALSE(left.update(0.9, 40.0));
  EXPECT_NEAR(*left.update(0.95, 41.0), 1.0, 1e-9);
  const auto text = [](double seconds) { return TimeLeft::text(seconds).english(); };
  EXPECT_EQ(text(0.99), "under 1 s left");
  EXPECT_EQ(text(1.0), "1 s left");
  EXPECT_EQ(text(89.9), "90 s left");
  EXPECT_EQ(text(90.0), "2 min left");
  EXPECT_EQ(text(149.0), "2 min left");
  EXPECT_EQ(text(151.0), "3 min left");
}

// matplotlib's "inferno" at nine places, white from a quarter of the range on.
TEST(DisplayPicture, DifferencesHaveTheirColours) {
  const auto bytes = [](double difference) {
    const auto b = differenceBytes(difference);
    return std::vector<int>(b.begin(), b.end());
  };
  EXPECT_THAT(bytes(-1.0), ElementsAre(0, 0, 4));
  EXPECT_THAT(bytes(0.0), ElementsAre(0, 0, 4));
  EXPECT_THAT(bytes(1.0 / 32.0), ElementsAre(31, 12, 72));
  EXPECT_THAT(bytes(2.0 / 32.0), ElementsAre(85, 15, 109));
  EXPECT_THAT(bytes(3.5 / 32.0), ElementsAre(161, 44, 96));
  EXPECT_THAT(bytes(4.25 / 32.0), ElementsAre(196, 63, 77));
  EXPECT_THAT(bytes(5.0 / 32.0), ElementsAre(227, 89, 51));
  EXPECT_THAT(bytes(6.0 / 32.0), ElementsAre(249, 140, 10));
  EXPECT_THAT(bytes(7.5 / 32.0), ElementsAre(251, 228, 107));
  EXPECT_THAT(bytes(0.25), ElementsAre(252, 255, 164));
  EXPECT_THAT(bytes(0.9), ElementsAre(252, 255, 164));
  const ImageRgbaF light{2, 1, {0.2f, 0.4f, 0.1f, 0.0f, 3.0f, 0.05f, 0.0f, 1.0f}};
  const ImageRgba8 shown = displayPicture(light, 1.5, Tone::None);
  EXPECT_EQ(shown.width, 2);
  EXPECT_EQ(shown.height, 1);
  const auto srgb = [](double linear) {
    return static_cast<int>(
        std::lround(255.0 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055)));
  };
  EXPECT_THAT(shown.pixels, ElementsAre(srgb(0.3), srgb(0.6), srgb(0.15), 255, 255, srgb(0.075), 0, 255));
  const ImageRgba8 other{2, 1, {10, 40, 12, 255, 250, 0, 60, 9}, {}}, another{2, 1, {12, 9, 28, 0, 255, 3, 0, 200}, {}};
  const ImageRgba8 between = differencePicture(other, another);
  const auto first = differenceBytes(31.0 / 255.0), second = differenceBytes(60.0 / 255.0);
  EXPECT_EQ(between.width, 2);
  EXPECT_EQ(between.height, 1);
  EXPECT_THAT(between.pixels, ElementsAre(first[0], first[1], first[2], 255, second[0], second[1], second[2], 255));
}

TEST(SceneNames, AreThoseOfTheirFiles) {
  for (const auto& [path, name] :
       {std::pair("a/hall.boxprobe.json", "hall"), std::pair("hall.BOXPROBE.JSON", "hall"),
        std::pair("x.y/two.parts.glb", "two.parts"), std::pair("room.json", "room"), std::pair("a.b/room", "room"),
        std::pair("room.obj", "room"), std::pair("room.txt", "room.txt"), std::pair(".boxprobe.json", ".boxprobe")}) {
    EXPECT_EQ(sceneName(path), name) << path;
  }
  EXPECT_TRUE(isModelPath("a.GLB"));
  EXPECT_FALSE(isModelPath("a.json"));
  EXPECT_EQ(singleLine("  a \n\n b\t c  "), "a b c");
}

TEST(FittedByBounds, AProbeHasAMarginAndACameraSeesAll) {
  const Box bounds{{-1.0, 0.5, 2.0}, {3.0, 2.5, 6.0}};
  const double diagonal = std::sqrt(16.0 + 4.0 + 16.0);
  const Probe probe = fittedProbe(bounds);
  EXPECT_EQ(probe.origin, glm::dvec3(1.0, 1.5, 4.0));
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(probe.box.min[i], bounds.min[i] - 1e-3 * diagonal, 1e-12);
    EXPECT_NEAR(probe.box.max[i], bounds.max[i] + 1e-3 * diagonal, 1e-12);
    EXPECT_EQ(probe.blendDistance.min[i], 0.0);
    EXPECT_EQ(probe.blendDistance.max[i], 0.0);
  }
  EXPECT_NEAR(probe.nearDistance, 1e-4 * diagonal, 1e-12);
  EXPECT_NEAR(probe.farDistance, 2.0 * diagonal, 1e-12);
  const Probe point = fittedProbe({{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}});
  EXPECT_NEAR(point.box.max.x - 1.0, 1e-6, 1e-12);
  EXPECT_NEAR(point.nearDistance, 1e-6, 1e-12);
  EXPECT_NEAR(point.farDistance, 1e-5, 1e-12);
  const Camera camera = fittedCamera(bounds);
  EXPECT_EQ(camera.target, glm::dvec3(1.0, 1.5, 4.0));
  const double distance = 0.5 * diagonal / std::sin(0.5 * 45.0 * 3.14159265358979 / 180.0);
  const double whole = std::sqrt(0.25 + 0.1225 + 1.0);
  EXPECT_NEAR(camera.position.x, 1.0 + distance * 0.5 / whole, 1e-9);
  EXPECT_NEAR(camera.position.y, 1.5 + distance * 0.35 / whole, 1e-9);
  EXPECT_NEAR(camera.position.z, 4.0 + distance / whole, 1e-9);
}

TEST(Reviews, TheWorstErrorIsTheLargestOrNoNumber) {
  const auto worst = [](const std::vector<double>& errors) {
    SceneReview review;
    for (const double error : errors) {
      ReviewedCamera row;
      row.parts.resize(2);
      row.parts[0].relativeRmse = error;
      row.parts[1].relativeRmse = 9.0;
      review.cameras.push_back(row);
    }
    return review.worstError();
  };
  EXPECT_EQ(worst({}), 0.0);
  EXPECT_EQ(worst({0.2, 0.5, 0.3}), 0.5);
  EXPECT_TRUE(std::isnan(worst({0.2, std::nan(""), 0.3})));
}

class SharedWorkFiles : public TemporaryFolder {
 protected:
  SharedWork of(const std::string& key, int index = 0, int count = 1) const {
    return SharedWork(file("parts"), key, index, count);
  }
  void SetUp() override { std::filesystem::create_directories(file("parts")); }
  std::string path(const std::string& name) const { return "parts/" + name + ".0123456789abcdef.part"; }
  const std::string key_ = "0123456789abcdefff", other_ = "fedcba9876543210ff";
};

TEST_F(SharedWorkFiles, EachHasItsOwn) {
  EXPECT_EQ(SharedWork::folderOf("a/out.html"), "a/out.html.parts");
  std::string mine;
  for (std::size_t i = 0; i < 7; ++i) {
    for (int index = 1; index <= 3; ++index) mine += of(key_, index, 3).mine(i) ? std::to_string(index) : "";
    EXPECT_FALSE(of(key_).mine(i));
  }
  EXPECT_EQ(mine, "1231231");
  EXPECT_TRUE(of(key_, 1, 3).sharing());
  EXPECT_FALSE(of(key_).sharing());
}

TEST_F(SharedWorkFiles, AFitComesBackWhole) {
  BoxFit fit;
  fit.outcome = FitOutcome::Inside;
  fit.probe.name = "left out";
  fit.probe.origin = {0.1, 0.2, 0.3};
  fit.probe.box = {{-1.1, -1.2, -1.3}, {2.1, 2.2, 2.3}};
  fit.probe.rotationDegrees = {1.5, 17.25, -4.5};
  fit.probe.influence = Box{{-3.1, -3.2, -3.3}, {4.1, 4.2, 4.3}};
  fit.before = {5.1, 5.2, 5.3};
  fit.after = {6.1, 6.2, 6.3};
  for (std::size_t i = 0; i < 6; ++i)
    fit.faces[i] = {7.0 + 0.1 * static_cast<double>(i), 8.0 - static_cast<double>(i), i % 3 == 1};
  fit.hiddenBefore = 0.91;
  fit.hidden = 0.92;
  fit.open = 0.93;
  fit.seconds = 0.94;
  fit.remarks = {Phrase::plain("one"), Phrase::plain("two")};
  const SharedWork shared = of(key_);
  EXPECT_FALSE(shared.find("fit", {}));
  shared.keep("fit", fit);
  Probe start;
  start.name = "start";
  start.influence = Box{{9.0, 9.0, 9.0}, {9.0, 9.0, 9.0}};
  const auto found = shared.find("fit", start);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->outcome, FitOutcome::Inside);
  EXPECT_EQ(found->probe.name, "start");
  EXPECT_EQ(found->probe.origin, fit.probe.origin);
  EXPECT_EQ(found->probe.box, fit.probe.box);
  EXPECT_EQ(found->probe.rotationDegrees, fit.probe.rotationDegrees);
  EXPECT_EQ(found->probe.influence, fit.probe.influence);
  const auto errors = [](const LookupErrors& e) { return std::vector<double>{e.meanDegrees, e.p95Degrees, e.above5}; };
  EXPECT_THAT(errors(found->before), ElementsAre(5.1, 5.2, 5.3));
  EXPECT_THAT(errors(found->after), ElementsAre(6.1, 6.2, 6.3));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(found->faces[i].gainDegrees, fit.faces[i].gainDegrees) << i;
    EXPECT_EQ(found->faces[i].sensitivity, fit.faces[i].sensitivity) << i;
    EXPECT_EQ(found->faces[i].free, fit.faces[i].free) << i;
  }
  EXPECT_EQ(found->hiddenBefore, 0.91);
  EXPECT_EQ(found->hidden, 0.92);
  EXPECT_EQ(found->open, 0.93);
  EXPECT_EQ(found->seconds, 0.94);
  EXPECT_THAT(english(found->remarks), ElementsAre("one", "two"));
  EXPECT_EQ(shared.made(), 1u);
  EXPECT_EQ(shared.found(), 1u);
  EXPECT_FALSE(of(other_).find("fit", start)) << "of other wishes";
  fit.probe.influence.reset();
  fit.outcome = FitOutcome::Fitted;
  shared.keep("fit", fit);
  EXPECT_FALSE(shared.find("fit", start)->probe.influence);
  // The name of a file and what is in it.
  const std::string bytes = read(path("fit"));
  EXPECT_EQ(bytes.find('\n'), 32u);
  EXPECT_EQ(nlohmann::json::parse(bytes.substr(33))["open"], 0.93);
  fit.open = std::nan("");
  shared.keep("fit", fit);
  EXPECT_FALSE(shared.find("fit", start)) << "JSON holds no such number";
}

TEST_F(SharedWorkFiles, PicturesComeBackIfTheyAreWholeAndOfThatSize) {
  const ImageRgbaF color{3, 2, std::vector<float>(24, 0.5f)}, error{3, 2, std::vector<float>(24, 0.25f)};
  ImageRgbaF odd = color;
  for (std::size_t i = 0; i < 24; ++i) odd.pixels[i] = 0.1f * static_cast<float>(i);
  const SharedWork shared = of(key_);
  shared.keepTraced("traced", {odd, error, true});
  const auto traced = shared.findTraced("traced", 3, 2);
  ASSERT_TRUE(traced);
  EXPECT_TRUE(traced->complete);
  EXPECT_EQ(traced->color.pixels, odd.pixels);
  EXPECT_EQ(traced->standardError.pixels, error.pixels);
  EXPECT_EQ(traced->standardError.height, 2);
  EXPECT_FALSE(shared.findTraced("traced", 2, 3));
  EXPECT_FALSE(shared.findTraced("traced", 3, 3));
  EXPECT_FALSE(shared.findTraced("traced", 4, 2));
  shared.keepPicture("drawn", odd);
  EXPECT_EQ(shared.findPicture("drawn", 3, 2)->pixels, odd.pixels);
  EXPECT_FALSE(shared.findPicture("drawn", 2, 2));
  EXPECT_FALSE(shared.findPicture("none", 3, 2));
  EXPECT_FALSE(shared.findTraced("drawn", 3, 2)) << "one picture alone";
  shared.keepBytes("bytes", std::string(8 + 4 * 24 - 1, '\x03'));
  EXPECT_FALSE(shared.findPicture("bytes", 0x03030303, 0x03030303)) << "shorter than it says";
  shared.keepBytes("bytes", "1234567");
  EXPECT_FALSE(shared.findPicture("bytes", 3, 2)) << "shorter than a size";
  shared.keepBytes("bytes", "");
  EXPECT_FALSE(shared.findBytes("none"));
  // Damaged files are as good as none.
  const std::string bytes = read(path("drawn"));
  EXPECT_EQ(bytes.size(), 33u + 8u + 96u);
  for (const std::size_t at : {0u, 31u, 32u, 33u, 136u}) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    write(path("drawn"), damaged);
    EXPECT_FALSE(shared.findPicture("drawn", 3, 2)) << at;
  }
  write(path("drawn"), bytes.substr(0, 136));
  EXPECT_FALSE(shared.findPicture("drawn", 3, 2));
  write(path("drawn"), bytes);
  EXPECT_TRUE(shared.findPicture("drawn", 3, 2));
}

TEST_F(SharedWorkFiles, TakesItsOwnAwayAndLeavesOthers) {
  of(key_).keepBytes("a", "x");
  of(key_).keepBytes("b", "y");
  of(other_).keepBytes("a", "z");
  of(key_).remove();
  EXPECT_FALSE(of(key_).findBytes("a") || of(key_).findBytes("b"));
  EXPECT_EQ(of(other_).findBytes("a"), "z");
  of(other_).remove();
  EXPECT_FALSE(std::filesystem::exists(file("parts")));
}

class Outputs : public TemporaryFolder {};

TEST_F(Outputs, RevisionsAreCountedBesideAFileAndInAFolder) {
  const std::string glb = file("room.glb");
  EXPECT_EQ(lastRevision(glb), 0);
  writeRevision(glb, 7);
  EXPECT_EQ(read("room.glb.revision"), "{\"revision\":7,\"file\":\"room.glb\"}\n");
  EXPECT_EQ(lastRevision(glb), 7);
  std::filesystem::create_directories(file("web"));
  writeRevision(file("web"), 3);
  EXPECT_EQ(read("web/revision"), "{\"revision\":3,\"file\":\"\"}\n");
  EXPECT_EQ(lastRevision(file("web")), 3);
  const auto kept = [&](const std::string& text) {
    write("room.glb.revision", text);
    return lastRevision(glb);
  };
  EXPECT_EQ(kept("{\"revision\": 1}"), 1);
  EXPECT_EQ(kept("{\"revision\": 1073741822}"), 1073741822);
  for (const char* text : {"", "7", "[7]", "{\"revision\": \"7\"}", "{\"revision\": 7.5}", "{\"revision\": 0}",
                           "{\"revision\": -3}", "{\"revision\": 1073741823}", "{\"other\": 7}"}) {
    EXPECT_EQ(kept(text), 0) << text;
  }
}

TEST_F(Outputs, WhatCannotBeWrittenIsRefusedBeforehand) {
  EXPECT_EQ(requireExtension("-o", "a/B.PnG", {".exr", ".png"}), ".png");
  EXPECT_EQ(errorText([] {
              requireExtension("-o", "a.jpg", {".exr", ".png"});
            }),
            "-o a.jpg: the file name must end in .exr or .png");
  write("taken", "x");
  requireOutputFolder("-o", file("one/two"));
  EXPECT_TRUE(std::filesystem::is_directory(file("one/two")));
  requireOutputFolder("-o", file("one/two"));
  EXPECT_EQ(errorText([&] { requireOutputFolder("-o", file("taken")); }),
            file("taken") + ": this is a file; -o names a folder");
  EXPECT_THAT(errorText<WorkError>([&] { requireOutputFolder("-o", file("taken/below")); }),
              HasSubstr("cannot create this folder"));
  EXPECT_THAT(errorText([&] { requireOutputFolder("-o", file(std::string(300, 'a'))); }),
              HasSubstr("choose a shorter one"));
  EXPECT_THAT(errorText([&] { requireShortName("-o", file(std::string(300, 'a'))); }), HasSubstr("a shorter one"));
  requireShortName("-o", file("short"));
  requireWritable("-o", file("new.png"));
  requireWritable("-o", file("new.png"));
  EXPECT_EQ(errorText([&] { requireWritable("--stats", file("new.png")); }),
            "--stats " + file("new.png") + ": -o writes to this file; name another");
  EXPECT_EQ(errorText([&] { requireWritable("--stats", file("one/../new.png")); }),
            "--stats " + file("one/../new.png") + ": -o writes to this file; name another");
  requireWritable("the window", file("new.png"));
  EXPECT_EQ(errorText([&] { requireWritable("-o", file("none/a.png")); }),
            "-o " + file("none/a.png") + ": the folder " + file("none") + " does not exist; create it first");
  EXPECT_THAT(errorText([&] { requireWritable("-o", file("taken/a.png")); }),
              HasSubstr("taken is a file, not a folder"));
  EXPECT_THAT(errorText([&] { requireWritable("-o", file("one")); }), HasSubstr("this is a folder; name a file in it"));
  EXPECT_THAT(errorText([&] { requireWritable("-o", "/dev/null"); }), HasSubstr("this is a pipe or device"));
  EXPECT_FALSE(std::filesystem::exists(file("new.png"))) << "nothing is left of trying";
}

TEST(Environment, VariablesAreMeantOrRefused) {
  const auto refused = [](const char* name, const std::string& value) {
    const char* before = std::getenv(name);
    const std::string kept = before != nullptr ? before : "";
    ::setenv(name, value.c_str(), 1);
    std::string text;
    try {
      requireMeantEnvironment();
    } catch (const InputError& error) {
      text = error.what();
    }
    before != nullptr ? ::setenv(name, kept.c_str(), 1) : ::unsetenv(name);
    return text;
  };
  for (const char* value : {"auto", "cpu", "gpu"}) EXPECT_EQ(refused("BOXPROBE_RENDERER_TUNING", value), "") << value;
  EXPECT_EQ(refused("BOXPROBE_RENDERER_TUNING", "fast"),
            "the environment's BOXPROBE_RENDERER_TUNING is \"fast\"; set it to auto, cpu or gpu, or unset it");
  for (const char* value : {"1", "16", "7"}) EXPECT_EQ(refused("BOXPROBE_ANISOTROPY", value), "") << value;
  for (const char* value : {"0", "17", "2.5", "", "x", "3x", "nan"}) {
    EXPECT_THAT(refused("BOXPROBE_ANISOTROPY", value), HasSubstr("a whole number from 1 to 16")) << value;
  }
  for (const char* value : {"1", "1000000"}) EXPECT_EQ(refused("BOXPROBE_TEXTURE_UNITS", value), "") << value;
  for (const char* value : {"0", "1000001", "1.5"}) EXPECT_NE(refused("BOXPROBE_TEXTURE_UNITS", value), "") << value;
  for (const char* value : {"0.5", "1e-6", "1e12"}) EXPECT_EQ(refused("BOXPROBE_TEXTURE_MEMORY", value), "") << value;
  for (const char* value : {"0", "1.1e12", "-1"}) EXPECT_NE(refused("BOXPROBE_TEXTURE_MEMORY", value), "") << value;
  EXPECT_EQ(refused("BOXPROBE_PROGRESS", "lines"), "");
  EXPECT_NE(refused("BOXPROBE_PROGRESS", "line"), "");
}

TEST(Statistics, HaveTheirValues) {
  RunStats stats;
  const auto times = [&] { return nlohmann::json::parse(statsJson(stats))["times"]; };
  EXPECT_TRUE(times()["frameCpuSecondsMedian"].is_null());
  EXPECT_TRUE(times()["startToFirstFrameCpuSeconds"].is_null());
  stats.frameCpuSeconds = {0.5, 0.1, 0.4, 0.3};
  EXPECT_NEAR(times()["frameCpuSecondsMedian"].get<double>(), 0.35, 1e-12);
  EXPECT_EQ(times()["frameCpuSecondsMin"], 0.1);
  EXPECT_EQ(times()["frames"], 4);
  stats.frameCpuSeconds = {0.5, 0.1, 0.4};
  EXPECT_EQ(times()["frameCpuSecondsMedian"], 0.4);
  stats.startToFirstFrameCpuSeconds = 1.25;
  stats.modelLoadCpuSeconds = 0.75;
  EXPECT_EQ(times()["startToFirstFrameCpuSeconds"], 1.25);
  EXPECT_EQ(times()["modelLoadCpuSeconds"], 0.75);
}

/// A closed room with a bulb, its walls of two colours.
LoadedScene litRoom(const glm::vec3& wall) {
  Model model;
  for (int i = 0; i < 2; ++i) {
    Material material;
    material.metallic = 0.0f;
    material.roughness = 0.8f;
    material.baseColor = i == 0 ? glm::vec4(wall, 1.0f) : glm::vec4(0.1f, 0.15f, 0.3f, 1.0f);
    model.materials.push_back(material);
  }
  const glm::vec3 low(-2.0f, 0.0f, -1.5f), high(3.0f, 2.4f, 1.8f);
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool far : {false, true}) {
      Mesh mesh;
      for (int i = 0; i < 4; ++i) {
        glm::vec3 at(0.0f);
        at[axis] = (far ? high : low)[axis];
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        at[u] = ((i == 1 || i == 2) ? high : low)[u];
        at[v] = (i >= 2 ? high : low)[v];
        mesh.positions.push_back(at);
      }
      mesh.indices = far ? std::vector<std::uint32_t>{0, 2, 1, 0, 3, 2} : std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
      mesh.material = axis == 0 && far ? 1 : 0;
      model.instances.push_back(
          {"face " + std::to_string(2 * axis + (far ? 1 : 0)), static_cast<int>(model.meshes.size()), glm::dmat4(1.0)});
      model.meshes.push_back(mesh);
    }
  }
  LoadedScene loaded;
  loaded.scene.sky = SkyColor{{0.0f, 0.0f, 0.0f}};
  Light bulb;
  bulb.type = LightType::Point;
  bulb.position = {1.9, 1.8, -0.4};
  bulb.intensity = 5.0f;
  loaded.scene.lights = {bulb};
  loaded.scene.models.push_back({"room", {}, {}});
  loaded.models = {std::make_shared<const Model>(std::move(model))};
  return loaded;
}

TEST(FitLight, IsThatOfTheFile) {
  const LoadedScene loaded = litRoom({0.25f, 0.2f, 0.15f});
  Probe before;
  before.name = "room";
  before.origin = {0.3, 1.1, 0.2};
  before.box = {{-2.6, -0.1, -1.5}, {2.1, 2.9, 2.5}};
  ProbeFitter fitter(loaded.scene, loaded.models);
  const auto fit = fitter.fit(before);
  ASSERT_TRUE(fit);
  test::KeptValues values;
  const auto add = [&](const char* name, const BoxFit& of) {
    std::vector<double> told;
    const auto errors = fitLightErrors(loaded.scene, loaded.models, fitter, before, of, [&](double done) {
      told.push_back(done);
      return true;
    });
    ASSERT_TRUE(errors);
    values.part(name);
    values.add("before, after", std::vector<double>{errors->before, errors->after});
    values.add("faces", std::vector<double>(errors->faceGain.begin(), errors->faceGain.end()));
    ASSERT_FALSE(told.empty());
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_GT(told.back(), 0.4);
    EXPECT_LE(told.back(), 1.0);
  };
  add("fitted", *fit);
  BoxFit moved = *fit;
  moved.probe.origin = {-0.9, 1.5, -0.4};
  moved.probe.rotationDegrees = {0.0, 20.0, 0.0};
  add("turned, and captured from elsewhere", moved);
  // Nothing in the dark, or if it is stopped.
  EXPECT_FALSE(fitLightErrors(loaded.scene, loaded.models, fitter, before, *fit, [](double) { return false; }));
  Scene dark = loaded.scene;
  dark.lights.clear();
  EXPECT_FALSE(fitLightErrors(dark, loaded.models, fitter, before, *fit));
  values.expect("unit/values/fit_light.txt", 5e-3);
}

}  // namespace
}  // namespace boxprobe
