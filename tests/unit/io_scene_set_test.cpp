// Single fields set from the command line: what each form reaches, and what each mistake is told.
#include <gtest/gtest.h>

#include "filters/io/scene/scene_file.h"
#include "tests/unit/error_text.h"

namespace boxprobe {
namespace {

class SceneSet : public ::testing::Test {
 protected:
  SceneSet() {
    scene.models.push_back({"a.glb", {}, {}, 1.0});
    scene.cameras.emplace_back();
    scene.lights.emplace_back();
    scene.probes.resize(2);
    scene.probes[0].name = "room";
    scene.probes[1].name = "big room 2.5";
  }
  void set(const std::string& assignment) { setSceneFields(scene, {assignment}); }
  std::string problem(const std::string& assignment) {
    const Scene before = scene;
    const std::string text = errorText([&] { set(assignment); });
    EXPECT_EQ(scene, before) << "a refused assignment changed the scene";
    const std::string prefix = "--set " + assignment + ": ";
    if (text.rfind("--set " + assignment, 0) != 0) ADD_FAILURE() << text;
    return text.size() > prefix.size() ? text.substr(prefix.size()) : text;
  }
  Scene scene;
};

TEST_F(SceneSet, FieldsOfProbes) {
  set("probes.room.box.max=[1,2,3]");
  EXPECT_EQ(scene.probes[0].box.max, glm::dvec3(1, 2, 3));
  set("probes.room.box.max[1]=7");
  set("probes.room.box.max.2=8");
  EXPECT_EQ(scene.probes[0].box.max, glm::dvec3(1, 7, 8));
  set("probes.room.box={\"min\": [0, 0, 0], \"max\": [2, 2, 2]}");
  EXPECT_EQ(scene.probes[0].box.min, glm::dvec3(0));
  set("probes.room.blendDistance=0.5");
  EXPECT_EQ(scene.probes[0].blendDistance.max, glm::dvec3(0.5));
  set("probes.room.blendDistance.min[0]=2");
  EXPECT_EQ(scene.probes[0].blendDistance.min, glm::dvec3(2, 0.5, 0.5));
  set("probes.room.technique=infinite");
  EXPECT_EQ(scene.probes[0].technique, "infinite");
  set("probes.room.projection=false");
  EXPECT_FALSE(scene.probes[0].projection);
  set("probes.room.parameters.power=2");
  EXPECT_EQ(std::get<double>(scene.probes[0].parameters.at("power")), 2.0);
  set("probes.room.bevel=0.3");
  EXPECT_EQ(scene.probes[0].bevel, (Bevel{0.3, 0.0}));
  set("probes.room.hides=[\"mirror\"]");
  EXPECT_EQ(scene.probes[0].hides, std::vector<std::string>{"mirror"});
  set("probes.room.encoding=rgbm");
  set("probes.room.decode=[16, 1]");
  EXPECT_EQ(scene.probes[0].encoding, ImageEncoding::Rgbm);
  EXPECT_EQ(scene.probes[0].decode, glm::dvec2(16, 1));
  set("probes.room.decode.1=2");
  EXPECT_EQ(scene.probes[0].decode, glm::dvec2(16, 2));
  set("probes.room.clear=none");
  EXPECT_TRUE(std::holds_alternative<ClearToNone>(scene.probes[0].clear));
  set("probes.room.name=hall");
  EXPECT_EQ(scene.probes[0].name, "hall");
}

TEST_F(SceneSet, NamesMayHoldDotsAndSpaces) {
  set("probes.big room 2.5.origin=[0,1,0]");
  EXPECT_EQ(scene.probes[1].origin, glm::dvec3(0, 1, 0));
  scene.materials["stone.001"].metallic = 0.0f;
  set("materials.stone.001.roughness=0.5");
  EXPECT_EQ(scene.materials.at("stone.001").roughness, 0.5f);
}

TEST_F(SceneSet, NamesInQuotesHoldAnything) {
  set("materials.\"Material.001\".roughness=0.5");
  EXPECT_EQ(scene.materials.at("Material.001").roughness, 0.5f);
  set("objects.\"a=b [2].c\".visible=false");
  EXPECT_FALSE(scene.objects.at("a=b [2].c").visible);
  set("materials.\"say \\\"x\\\"\".metallic=0");
  EXPECT_EQ(scene.materials.at("say \"x\"").metallic, 0.0f);
  set("probes.\"big room 2.5\".faceSize=128");
  EXPECT_EQ(scene.probes[1].faceSize, 128);
}

TEST_F(SceneSet, NamesInQuotesAddProbesAndCameras) {
  setSceneFields(scene, {"probes.\"hall.1\".box.min=[-4,0,-4]", "probes.\"hall.1\".origin=[0,0.5,0]"});
  ASSERT_EQ(scene.probes.size(), 3u);
  EXPECT_EQ(scene.probes[2].name, "hall.1");
  EXPECT_EQ(scene.probes[2].box.min, glm::dvec3(-4, 0, -4));
  set("cameras.\"side\".position=[9,1,0]");
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_EQ(scene.cameras[1].name, "side");
  EXPECT_EQ(scene.cameras[1].position, glm::dvec3(9, 1, 0));
}

TEST_F(SceneSet, AnInfluenceBoxStartsFromTheBoxItStandsFor) {
  set("probes.room.box.max=[5,6,7]");
  EXPECT_FALSE(scene.probes[0].influence);
  set("probes.room.influence.max[0]=9");
  EXPECT_EQ(scene.probes[0].influence, (Box{{-1, -1, -1}, {9, 6, 7}}));
}

TEST_F(SceneSet, EntriesOfMaterialsAndObjectsAreMade) {
  set("materials.floor.roughness=0.25");
  EXPECT_EQ(scene.materials.at("floor").roughness, 0.25f);
  EXPECT_FALSE(scene.materials.at("floor").metallic);
  set("objects.mirror.visible=false");
  EXPECT_FALSE(scene.objects.at("mirror").visible);
  EXPECT_TRUE(scene.objects.at("mirror").seenByProbes);
}

TEST_F(SceneSet, TheRestOfTheScene) {
  set("exposure=2");
  EXPECT_EQ(scene.exposure, 2.0);
  set("cameras.main.position=[0,1,2]");
  EXPECT_EQ(scene.cameras[0].position, glm::dvec3(0, 1, 2));
  set("lights[0].intensity=5");
  EXPECT_EQ(scene.lights[0].intensity, 5.0f);
  set("models[0].scale=0.5");
  EXPECT_EQ(scene.models[0].scale, 0.5);
  set("model=other.glb");
  EXPECT_EQ(scene.models.size(), 1u);
  EXPECT_EQ(scene.models[0].file, "other.glb");
}

TEST_F(SceneSet, TheSkyChangesKind) {
  set("sky.color=[1,0,0]");
  EXPECT_EQ(scene.sky, Sky(SkyColor{{1.0f, 0.0f, 0.0f}}));
  set("sky.top=[0,0,1]");
  EXPECT_EQ(scene.sky, Sky(SkyGradient{{0.0f, 0.0f, 1.0f}, SkyGradient().horizon, SkyGradient().ground}));
  set("sky.ground[0]=0.5");
  EXPECT_EQ(std::get<SkyGradient>(scene.sky).ground.x, 0.5f);
  EXPECT_EQ(std::get<SkyGradient>(scene.sky).top.z, 1.0f);
  set("sky.rotationDegrees=45");
  set("sky.image=sky.exr");
  EXPECT_EQ(scene.skyRotationDegrees, 45.0);
  EXPECT_EQ(scene.sky, Sky(SkyImage{"sky.exr"}));
}

TEST_F(SceneSet, MistakesAreNamed) {
  EXPECT_EQ(problem("exposure"), "is not an assignment; write KEY=VALUE");
  EXPECT_EQ(problem("exposur=2"), "exposur: unknown key; did you mean \"exposure\"?");
  EXPECT_EQ(problem("probes.rom.origin=[0,0,0]"),
            "probes.rom: there is no such probe; the scene has room, big room 2.5; to add one, put its name in quotes: "
            "probes.\"rom\"");
  EXPECT_EQ(problem("cameras.side.target=[0,0,0]"),
            "cameras.side: there is no such camera; the scene has main; to add one, put its name in quotes: "
            "cameras.\"side\"");
  EXPECT_EQ(problem("materials.\"Material.001.roughness=0.5"),
            "the name in quotes does not end; write GROUP.\"NAME\".FIELD=VALUE");
  EXPECT_EQ(problem("materials.\"a\"roughness=0.5"),
            "the name in quotes does not end; write GROUP.\"NAME\".FIELD=VALUE");
  EXPECT_EQ(problem("probes.room.orgin=[0,0,0]"), "probes.room.orgin: unknown key; did you mean \"origin\"?");
  EXPECT_EQ(problem("probes.room.box.mx[0]=1"), "probes.room.box.mx: unknown key; did you mean \"max\"?");
  EXPECT_EQ(problem("probes.room.box.max.x=1"), "probes.room.box.max.x: is not an element; use an index such as [0]");
  EXPECT_EQ(problem("probes.room.box.max[3]=1"), "probes.room.box.max[3]: there are 3 elements, counted from 0");
  EXPECT_EQ(problem("lights[1].intensity=1"), "lights[1]: there are 1 elements, counted from 0");
  EXPECT_EQ(problem("exposure.x=1"), "exposure.x: has nothing below it; end the key before it");
  EXPECT_EQ(problem("exposure=NaN"), "exposure: must be a number, not \"NaN\"");
  EXPECT_EQ(problem("probes.room.faceSize=100"),
            "probes.room.faceSize: is 100 and must be a power of two from 16 to 2048");
  EXPECT_EQ(problem("probes.room.box.max=[-5,1,1]"), "probes.room.box: min.x -1 is greater than max.x -5; swap them");
  EXPECT_NE(problem("probes.room.box.max=[1,2"), "");
  EXPECT_NE(problem("exposure=1e999"), "");
  EXPECT_NE(problem("exposure="), "");
  EXPECT_NE(problem("=3"), "");
  EXPECT_NE(problem(".=3"), "");
  EXPECT_NE(problem("probes=3"), "");
  EXPECT_NE(problem("probes.room=3"), "");
  EXPECT_NE(problem("probes.=3"), "");
  EXPECT_NE(problem("materials.=3"), "");
}

// A box moved by both its ends is no box in between.
TEST_F(SceneSet, SeveralAreValidatedTogether) {
  setSceneFields(scene, {"probes.room.box.min=[5,0,0]", "probes.room.box.max=[9,9,9]"});
  EXPECT_EQ(scene.probes[0].box, (Box{{5, 0, 0}, {9, 9, 9}}));
  const Scene before = scene;
  const std::string text = errorText([&] { setSceneFields(scene, {"exposure=2", "probes.room.box.min=[99,0,0]"}); });
  EXPECT_NE(text.find("probes.room.box: min.x 99 is greater than max.x 9"), std::string::npos) << text;
  EXPECT_EQ(scene, before);
}

}  // namespace
}  // namespace boxprobe
