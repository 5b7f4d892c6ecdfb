// What loading a scene takes over from its models: cameras with names of their own, lights, and each file read once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/load_scene.h"
#include "app/session/shared_work.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A triangle, a camera and a lamp.
constexpr const char* kModel = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
  "extensionsUsed": ["KHR_lights_punctual"],
  "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 5, "color": [1, 0.5, 0.25]}]}},
  "nodes": [{"name": "sheet", "mesh": 0},
            {"name": "eye", "camera": 0, "translation": [1, 2, 3]},
            {"name": "bulb", "translation": [0.5, 2.5, 1.5], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
  "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

class LoadedValues : public TemporaryFolder {
 protected:
  void SetUp() override {
    write("a.gltf", kModel);
    write("b.gltf", kModel);
  }
  LoadedScene load(const std::string& members, const LoadProgress& progress = {}) const {
    return loadScene(write("s.boxprobe.json", R"({"format": "boxprobe-scene", "version": 1, )" + members + "}"), {},
                     progress);
  }
  static std::vector<std::string> names(const Scene& scene) {
    std::vector<std::string> found;
    for (const Camera& camera : scene.cameras) found.push_back(camera.name);
    return found;
  }
  const std::string models_ = R"("models": [{"file": "a.gltf"}, {"file": "b.gltf", "translation": [10, 0, 0]},
    {"file": "a.gltf", "translation": [20, 0, 0]}])";
};

TEST_F(LoadedValues, CamerasAndLightsOfModelsAreAdopted) {
  std::vector<double> told;
  const LoadedScene loaded = load(models_, [&](double done) {
    told.push_back(done);
    return true;
  });
  ASSERT_EQ(loaded.scene.cameras.size(), 3u);
  const std::string stem = loaded.scene.cameras[0].name;
  EXPECT_THAT(names(loaded.scene), ElementsAre(stem, stem + " 2", stem + " 3"));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(loaded.scene.cameras[i].position.x, 1.0 + 10.0 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(loaded.scene.lights.at(i).position.x, 0.5 + 10.0 * static_cast<double>(i), 1e-9);
  }
  EXPECT_EQ(loaded.scene.lights.size(), 3u);
  EXPECT_EQ(loaded.models.at(0), loaded.models.at(2)) << "read once";
  EXPECT_NE(loaded.models[0], loaded.models[1]);
  EXPECT_EQ(loaded.path, file("s.boxprobe.json"));
  EXPECT_EQ(loaded.fileDigest, fileDigest(file("s.boxprobe.json")));
  EXPECT_FALSE(loaded.fit || loaded.exposureAutomatic);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 2.0 / 3.0 + 1e-9) << "the third is known";
  EXPECT_GT(told.back(), 0.34);
  EXPECT_EQ(fileDigest(file("none")), "");
  EXPECT_NE(fileDigest(file("a.gltf")), fileDigest(file("s.boxprobe.json")));
}

TEST_F(LoadedValues, WhatASceneHasItselfStays) {
  const LoadedScene own = load(models_ + R"(, "cameras": {"mine": {"position": [0, 1, 2], "target": [0, 0, 0]}})");
  EXPECT_THAT(names(own.scene), ElementsAre("mine"));
  EXPECT_EQ(own.scene.lights.size(), 3u);
  const LoadedScene lit = load(models_ + R"(, "lights": [{"type": "point", "position": [0, 1, 2]}])");
  EXPECT_EQ(lit.scene.lights.size(), 1u);
  EXPECT_EQ(lit.scene.cameras.size(), 3u);
  EXPECT_THAT(errorText([&] { loadScene(file("none.json")); }), HasSubstr("no such file"));
  EXPECT_THAT(errorText([&] { loadScene(file("")); }), HasSubstr("this is a folder"));
  write("t.txt", "");
  EXPECT_THAT(errorText([&] { loadScene(file("t.txt")); }), HasSubstr("neither a scene"));
  write("t.fbx", "");
  EXPECT_THAT(errorText([&] { loadScene(file("t.fbx")); }), Not(HasSubstr("neither a scene")));
}

TEST_F(LoadedValues, ABareModelIsTold) {
  const LoadedScene loaded = loadScene(file("a.gltf"), {"models.0.scale=2", "probes=[]", "tone=aces"});
  ASSERT_TRUE(loaded.fit);
  EXPECT_EQ(loaded.path, "");
  EXPECT_EQ(loaded.scene.models.at(0).scale, 2.0);
  EXPECT_EQ(loaded.scene.tone, Tone::Aces);
  EXPECT_EQ(loaded.scene.groundShadow, loaded.fit->kind == ModelKind::Object);
  EXPECT_EQ(loaded.scene.ambientOcclusion, loaded.fit->kind == ModelKind::Object);
  EXPECT_EQ(loadScene(file("a.gltf")).scene.tone, Tone::Neutral);
  EXPECT_TRUE(loaded.scene.probes.empty());
}

// Whatever a picture depends on is in it.
TEST_F(LoadedValues, AKeyIsOfAllThatIsShown) {
  const std::string base = R"("models": [{"file": "a.gltf"}], "probes": [{"name": "p", "origin": [0, 1, 1],
    "box": {"min": [-1, 0, -1], "max": [1, 2, 2]}}])";
  const LoadedScene first = load(base);
  const std::string key = loadedSceneKey(first);
  EXPECT_EQ(loadedSceneKey(load(base)), key);
  LoadedScene other = first;
  other.scene.exposure = 2.0;
  EXPECT_NE(loadedSceneKey(other), key);
  const auto changed = [&](const auto& change) {
    Model model = *first.models[0];
    change(model);
    LoadedScene made = first;
    made.models = {std::make_shared<const Model>(model)};
    return loadedSceneKey(made) != key;
  };
  EXPECT_TRUE(changed([](Model& m) { m.instances[0].node = "another"; }));
  EXPECT_TRUE(changed([](Model& m) { m.instances[0].worldFromModel[3].y += 0.5; }));
  EXPECT_TRUE(changed([](Model& m) { m.meshes[0].positions[1].x += 0.5f; }));
  other = first;
  other.scene.probes[0].mode = ProbeMode::Custom;
  other.scene.probes[0].image = write("p.hdr", "one");
  const std::string one = loadedSceneKey(other);
  write("p.hdr", "two");
  EXPECT_NE(loadedSceneKey(other), one);
  other.scene.probes[0].mode = ProbeMode::Baked;
  const std::string baked = loadedSceneKey(other);
  write("p.hdr", "one");
  EXPECT_EQ(loadedSceneKey(other), baked) << "the picture is not used";
}

}  // namespace
}  // namespace boxprobe
