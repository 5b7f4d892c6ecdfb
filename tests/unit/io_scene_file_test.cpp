// Scene files: every key read, every kind of mistake with its place, and text that reads back equal.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "filters/core/scene/bounces.h"
#include "filters/io/scene/scene_file.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

const char* const kHead = R"({ "format": "boxprobe-scene", "version": 1)";

Scene parsed(const std::string& members) {
  return parseScene(std::string(kHead) + (members.empty() ? "" : ", " + members) + " }", "scene.json", "folder");
}

/// The message for members that stand on the second line, so that places can be told.
std::string problem(const std::string& members) {
  return errorText([&] { parseScene(std::string(kHead) + ",\n" + members + "\n}", "scene.json", "folder"); });
}

TEST(SceneParse, AllThatIsLeftOutHasItsDefault) {
  EXPECT_EQ(parsed(""), Scene());
}

TEST(SceneParse, LightsThatThrowShadowsATurnedSkyAndAnOpenProbe) {
  const Scene scene = parsed(R"("sky": {"color": [1, 1, 1], "rotationDegrees": 30},
    "lights": [{"type": "directional", "shadows": "coverage+map", "angleDegrees": 2, "shadowLevel": "distance",
                "levelsPerUnit": 0.08},
               {"type": "point", "shadows": "coverage", "radius": 0.4}],
    "probes": [{"name": "room", "clear": "open"}])");
  EXPECT_EQ(scene.skyRotationDegrees, 30.0);
  EXPECT_EQ(scene.lights[0].shadows, LightShadows::CoverageAndMap);
  EXPECT_EQ(scene.lights[0].angleDegrees, 2.0);
  EXPECT_EQ(scene.lights[0].shadowLevel, ShadowLevel::Distance);
  EXPECT_EQ(scene.lights[0].levelsPerUnit, 0.08);
  EXPECT_EQ(scene.lights[1].shadows, LightShadows::Coverage);
  EXPECT_EQ(scene.lights[1].radius, 0.4);
  EXPECT_EQ(scene.probes[0].clear, Clear(ClearToOpen{}));
  EXPECT_EQ(parseScene(sceneText(scene, "folder"), "scene.json", "folder"), scene);
  EXPECT_NE(problem(R"("lights": [{"type": "point", "angleDegrees": 2}])").find("use \"radius\""), std::string::npos);
  EXPECT_NE(problem(R"("lights": [{"type": "point", "shadows": "soft"}])").find("coverage"), std::string::npos);
}

TEST(SceneParse, BouncesMayBeAll) {
  const std::string box = R"("name": "hall", "box": {"min": [-1, -2, -3], "max": [4, 5, 6]})";
  const auto with = [&](const std::string& bounces) {
    return R"("probes": [{)" + box + R"(, "bounces": )" + bounces + "}]";
  };
  const Scene scene = parsed(with(R"("all")"));
  EXPECT_TRUE(allBounces(scene.probes[0]));
  EXPECT_EQ(mostBounces(scene), std::nullopt);
  const std::string text = sceneText(scene, "folder");
  EXPECT_NE(text.find(R"("bounces": "all")"), std::string::npos) << text;
  EXPECT_EQ(parseScene(text, "scene.json", "folder"), scene);
  EXPECT_EQ(mostBounces(parsed(with("4"))), 4);
  const std::string must = "probes.hall.bounces: must be a whole number from 1 to 5, or \"all\"";
  for (const char* bad : {R"("al")", R"("")", "16", "2.5", "true", "null", "[3]"}) {
    EXPECT_NE(problem(with(bad)).find(must), std::string::npos) << bad << ": " << problem(with(bad));
  }
  for (const char* bad : {"0", "6", "-1", "17"}) {
    const std::string said = problem(with(bad));
    EXPECT_NE(said.find(std::string("probes.hall.bounces: is ") + bad + " and must be from 1 to 5, or \"all\""),
              std::string::npos)
        << said;
  }
}

TEST(SceneParse, ReadsEveryKeyOfAProbe) {
  const Scene scene = parsed(R"("probes": [{
    "name": "room", "origin": [1, 2, 3], "box": {"min": [-1, -2, -3], "max": [4, 5, 6]}, "rotationDegrees": [0, 45, 0],
    "influence": {"min": [-2, -2, -2], "max": [2, 2, 2]}, "near": 0.5, "far": 50, "clear": [0.25, 0.5, 1],
    "blendDistance": {"min": [1, 2, 3], "max": [4, 5, 6]}, "importance": 2, "intensity": 0.5, "projection": false,
    "technique": "sphere", "parameters": {"samples": 8, "pattern": "r2", "animated": true}, "faceSize": 64,
    "bounces": 3, "mode": "custom", "image": "room.exr", "imageLayout": "cross",
    "encoding": "rgbm", "decode": [8, 1.5], "filter": "gaussian", "samplesPerPixel": 16, "filterSamples": 160,
    "hides": ["mirror", "lamp"], "bevel": {"fromRoughness": 1}, "lattice": {"spacing": 0.7},
    "occlusion": {"multiplier": 2, "power": 3, "strength": 0.5} }])");
  ASSERT_EQ(scene.probes.size(), 1u);
  Probe expected;
  expected.name = "room";
  expected.origin = {1, 2, 3};
  expected.box = {{-1, -2, -3}, {4, 5, 6}};
  expected.rotationDegrees = {0, 45, 0};
  expected.influence = Box{{-2, -2, -2}, {2, 2, 2}};
  expected.nearDistance = 0.5;
  expected.farDistance = 50;
  expected.clear = glm::vec3(0.25f, 0.5f, 1.0f);
  expected.blendDistance = {{1, 2, 3}, {4, 5, 6}};
  expected.importance = 2;
  expected.intensity = 0.5;
  expected.projection = false;
  expected.technique = "sphere";
  expected.parameters = {{"samples", 8.0}, {"pattern", std::string("r2")}, {"animated", true}};
  expected.faceSize = 64;
  expected.bounces = 3;
  expected.mode = ProbeMode::Custom;
  expected.image = "folder/room.exr";
  expected.filter = FilterKind::Gaussian;
  expected.samplesPerPixel = 16;
  expected.filterSamples = 160;
  expected.imageLayout = CubeLayout::Cross;
  expected.encoding = ImageEncoding::Rgbm;
  expected.decode = glm::dvec2(8.0, 1.5);
  expected.hides = {"mirror", "lamp"};
  expected.bevel = Bevel{0.0, 1.0};
  expected.lattice = ProbeLattice{true, 0.7};
  expected.occlusion = BoxOcclusion{2.0, 3.0, 0.5};
  EXPECT_EQ(scene.probes[0], expected);
}

TEST(SceneParse, ShortFormsOfProbeFields) {
  const Scene scene = parsed(R"("probes": [{"name": "a", "blendDistance": 0.5, "clear": "none", "bevel": 0.25},
                                           {"name": "b", "clear": "sky", "lattice": false}])");
  EXPECT_EQ(scene.probes[0].blendDistance, (BlendDistance{glm::dvec3(0.5), glm::dvec3(0.5)}));
  EXPECT_TRUE(std::holds_alternative<ClearToNone>(scene.probes[0].clear));
  EXPECT_EQ(scene.probes[0].bevel, (Bevel{0.25, 0.0}));
  EXPECT_TRUE(std::holds_alternative<ClearToSky>(scene.probes[1].clear));
  EXPECT_TRUE(scene.probes[0].hasLattice());
  EXPECT_FALSE(scene.probes[1].hasLattice());
  EXPECT_NE(sceneText(scene, "").find("\"lattice\": false"), std::string::npos);
  EXPECT_EQ(parseScene(sceneText(scene, ""), "again", ""), scene);
}

TEST(SceneParse, ReadsModelsSkiesCamerasAndLights) {
  EXPECT_EQ(parsed(R"("model": "../a.glb")").models[0].file, "a.glb");
  EXPECT_EQ(parsed(R"("model": "/else/a.glb")").models[0].file, "/else/a.glb");
  const Scene placed = parsed(
      R"("models": [{"file": "a.glb", "translation": [1000000.125, 0, 0], "rotationDegrees": [0, 90, 0], "scale": 0.01},
                    "b.glb"])");
  EXPECT_EQ(placed.models[0], (ModelFile{"folder/a.glb", {1000000.125, 0, 0}, {0, 90, 0}, 0.01}));
  EXPECT_EQ(placed.models[1].file, "folder/b.glb");
  EXPECT_EQ(parsed(R"("sky": {"image": "sky.hdr"})").sky, Sky(SkyImage{"folder/sky.hdr"}));
  EXPECT_EQ(parsed(R"("sky": {"color": [1, 0, 0.5]})").sky, Sky(SkyColor{{1.0f, 0.0f, 0.5f}}));
  EXPECT_EQ(std::get<SkyGradient>(parsed(R"("sky": {"top": [0, 0, 1]})").sky).horizon, SkyGradient().horizon);
  const Scene cameras = parsed(
      R"("cameras": {"zenith": {"position": [0, 9, 0], "target": [0, 0, 0], "up": [0, 0, -1]},
                     "aisle": {"verticalFovDegrees": 60}})");
  ASSERT_EQ(cameras.cameras.size(), 2u);
  EXPECT_EQ(cameras.cameras[0].name, "zenith");  // file order, not the alphabet's
  EXPECT_EQ(cameras.cameras[0].up, glm::dvec3(0, 0, -1));
  EXPECT_EQ(cameras.cameras[1].verticalFovDegrees, 60.0);
  const Scene lights = parsed(R"("lights": [{"type": "directional", "direction": [1, -1, 0], "intensity": 3},
                                            {"type": "point", "position": [0, 2, 0], "color": [1, 0.5, 0]}])");
  EXPECT_EQ(lights.lights[0].direction, glm::dvec3(1, -1, 0));
  EXPECT_EQ(lights.lights[0].intensity, 3.0f);
  EXPECT_EQ(lights.lights[1].type, LightType::Point);
  EXPECT_EQ(lights.lights[1].color, glm::vec3(1.0f, 0.5f, 0.0f));
}

TEST(SceneParse, ReadsOverridesAndExposure) {
  const Scene scene = parsed(R"("exposure": 2, "materials": {"floor": {"baseColor": [1, 0.5, 0], "metallic": 1,
      "roughness": 0.25, "emissive": [2, 0, 0], "normalScale": 0.5, "coat": 1, "ior": 1.3, "transmission": 0.5,
      "thickness": 0.4, "attenuationDistance": 2, "attenuationColor": [0, 0.5, 1], "thin": false, "glass": "two-pass"}},
    "objects": {"mirror": {"visible": false, "seenByProbes": false, "dynamic": true, "probeMode": "simple",
                           "weights": "object", "translation": [1, 2, 3], "rotationDegrees": [0, 90, 0]}},
    "mirrors": {"mirror": {"enabled": false, "maxRoughness": 0.5, "resolution": 2}}, "mirrorBudget": 1000000,
    "lamps": "in-map")");
  EXPECT_EQ(scene.exposure, 2.0);
  const MaterialOverride& floor = scene.materials.at("floor");
  EXPECT_EQ(floor.baseColor, glm::vec3(1.0f, 0.5f, 0.0f));
  EXPECT_EQ(floor.metallic, 1.0f);
  EXPECT_EQ(floor.roughness, 0.25f);
  EXPECT_EQ(floor.emissive, glm::vec3(2.0f, 0.0f, 0.0f));
  EXPECT_EQ(floor.normalScale, 0.5f);
  EXPECT_EQ(floor.coat, 1.0f);
  EXPECT_EQ(floor.ior, 1.3f);
  EXPECT_EQ(floor.transmission, 0.5f);
  EXPECT_EQ(floor.thickness, 0.4f);
  EXPECT_EQ(floor.attenuationDistance, 2.0f);
  EXPECT_EQ(floor.attenuationColor, glm::vec3(0.0f, 0.5f, 1.0f));
  EXPECT_EQ(floor.thin, false);
  EXPECT_EQ(floor.glass, GlassForm::TwoPass);
  EXPECT_EQ(scene.objects.at("mirror"),
            (ObjectOverride{false, false, true, ProbeUsage::Simple, WeightMode::Object, {1, 2, 3}, {0, 90, 0}}));
  EXPECT_EQ(scene.mirrors.at("mirror"), (PlanarMirror{false, 0.5, 2.0}));
  EXPECT_EQ(scene.mirrorBudget, 1.0e6);
  EXPECT_EQ(scene.lamps, LampForm::InMap);
  EXPECT_EQ(parsed("").lamps, LampForm::Shapes);
  EXPECT_NE(errorText([] { parsed(R"("lamps": "shape")"); }).find("lamps: must be one of \"in-map\", \"shapes\", not"),
            std::string::npos);
}

TEST(SceneErrors, SyntaxErrorsHaveLineAndColumn) {
  const std::string text =
      errorText([] { parseScene("{\n  \"format\": \"boxprobe-scene\",\n  \"version\" 1\n}", "s.json", ""); });
  EXPECT_EQ(text.rfind("s.json:3:13: not valid JSON: ", 0), 0u) << text;
  EXPECT_EQ(errorText([] { parseScene("", "s.json", ""); }).rfind("s.json:", 0), 0u);
  EXPECT_EQ(errorText([] { parseScene("{\"a\": 1e999}", "s.json", ""); }),
            "s.json:1:7: not valid JSON: number overflow parsing '1e999'");
  EXPECT_NE(errorText([] { parseScene("{\"a\": NaN}", "s.json", ""); }), "");
  const std::string twice = errorText([] { parseScene("{\"a\": 1,\n \"a\": 2}", "s.json", ""); });
  EXPECT_EQ(twice, "s.json:2:2: the key \"a\" stands here a second time; remove one");
}

TEST(SceneErrors, DeepNestingIsRefusedNotCrashedOn) {
  const std::string deep(1000000, '[');
  EXPECT_NE(errorText([&] { parseScene(deep, "s.json", ""); }).find("nested more than"), std::string::npos);
}

TEST(SceneErrors, OtherFilesAreCalledWhatTheyAre) {
  EXPECT_EQ(errorText([] { parseScene("{\"asset\": {}}", "s.json", ""); }),
            "s.json:1:1: is not a scene file; it starts with { \"format\": \"boxprobe-scene\", \"version\": 1, ...");
  EXPECT_EQ(errorText([] { parseScene(R"({"format": "boxprobe-scene", "version": 2})", "s.json", ""); }),
            "s.json:1:30: version: is 2; this program reads version 1, so get a newer program");
  EXPECT_NE(errorText([] { parseScene("[]", "s.json", ""); }), "");
}

TEST(SceneErrors, UnknownKeysAreNamedWithTheNearest) {
  EXPECT_EQ(problem(R"("probs": [])"), "scene.json:2:1: probs: unknown key; did you mean \"probes\"?");
  EXPECT_EQ(problem(R"("probes": [{"name": "room", "orgin": [0, 0, 0]}])"),
            "scene.json:2:29: probes.room.orgin: unknown key; did you mean \"origin\"?");
  EXPECT_EQ(
      problem(R"("materials": {"floor": {"phong": 3}})"),
      "scene.json:2:25: materials.floor.phong: unknown key; the keys here are baseColor, metallic, roughness, "
      "emissive, normalScale, coat, ior, transmission, thickness, attenuationDistance, attenuationColor, thin, glass");
  for (const char* members :
       {R"("models": [{"file": "a", "x": 1}])", R"("sky": {"colour": [1, 1, 1]})", R"("cameras": {"a": {"fov": 3}})",
        R"("lights": [{"type": "point", "rage": 3}])", R"("objects": {"a": {"shown": true}})",
        R"("probes": [{"name": "a", "box": {"mid": 1}}])", R"("probes": [{"name": "a", "blendDistance": {"mid": 1}}])",
        R"("probes": [{"name": "a", "occlusion": {"mid": 1}}])"}) {
    EXPECT_NE(problem(members).find("unknown key"), std::string::npos) << members;
  }
}

TEST(SceneErrors, WrongTypesNameTheKeyWhatIsWantedAndWhatIsThere) {
  EXPECT_EQ(problem(R"("exposure": "bright")"), "scene.json:2:1: exposure: must be a number, not \"bright\"");
  EXPECT_EQ(problem(R"("probes": [{"name": "room", "origin": [0, 1]}])"),
            "scene.json:2:29: probes.room.origin: must be three numbers in brackets, not [0,1]");
  EXPECT_EQ(problem(R"("probes": [{"name": "room", "origin": [0, true, 1]}])"),
            "scene.json:2:43: probes.room.origin[1]: must be a number, not true");
  EXPECT_EQ(problem(R"("probes": [{"name": "room", "projection": 1}])"),
            "scene.json:2:29: probes.room.projection: must be true or false, not 1");
  EXPECT_EQ(problem(R"("probes": [{"name": "room", "faceSize": 64.5}])"),
            "scene.json:2:29: probes.room.faceSize: must be a whole number, not 64.5");
  EXPECT_EQ(problem(R"("probes": [{"name": "room", "mode": "bake"}])"),
            "scene.json:2:29: probes.room.mode: must be one of \"baked\", \"realtime\", \"custom\", not \"bake\"");
  EXPECT_EQ(problem(R"("probes": [{"name": "room", "encoding": "RGBM"}])"),
            "scene.json:2:29: probes.room.encoding: must be one of \"linear\", \"rgbm\", \"dldr\", \"rgbmLinear\", not "
            "\"RGBM\"");
  EXPECT_EQ(problem(R"("probes": [{"name": "room", "decode": [5]}])"),
            "scene.json:2:29: probes.room.decode: must be two numbers in brackets, not [5]");
  EXPECT_EQ(problem(R"("probes": [{"name": "room", "decode": [5, -1]}])"),
            "scene.json:2:43: probes.room.decode[1]: is -1 and must be 0 or more");
  EXPECT_EQ(problem(R"("probes": {"room": {}})"), "scene.json:2:1: probes: must be a list in brackets, not an object");
  EXPECT_EQ(problem(R"("probes": [{"origin": [0, 0, 0]}])"),
            "scene.json:2:12: probes[0]: has no name; add \"name\": \"...\"");
  EXPECT_EQ(problem(R"("cameras": [])"), "scene.json:2:1: cameras: must be an object in braces, not []");
  EXPECT_EQ(problem(R"("sky": {"color": [1, 1, 1e200]})"),
            "scene.json:2:25: sky.color[2]: 1e+200 is too large; use a smaller number");
  EXPECT_EQ(problem(R"("probes": [{"name": "room", "box": {"min": [0, 0, 0]}}])"),
            "scene.json:2:29: probes.room.box: has no max; give both min and max");
  for (const char* lattice : {"true", "1", "\"none\"", "[1]"}) {
    const std::string text = problem(R"("probes": [{"name": "room", "lattice": )" + std::string(lattice) + "}]");
    EXPECT_NE(text.find("probes.room.lattice: must be false, or {\"spacing\": DISTANCE}"), std::string::npos) << text;
  }
  EXPECT_NE(problem(R"("probes": [{"name": "room", "clear": "black"}])").find("\"sky\", \"open\", \"none\" or a color"),
            std::string::npos);
}

TEST(SceneErrors, ChoicesThatExcludeEachOther) {
  EXPECT_EQ(problem(R"("model": "a.glb", "models": [])"),
            "scene.json:2:19: models: stands beside model; keep one of them");
  EXPECT_NE(problem(R"("sky": {"color": [1, 1, 1], "top": [0, 0, 1]})").find("mixes kinds"), std::string::npos);
  EXPECT_NE(problem(R"("lights": [{"type": "point", "direction": [0, -1, 0]}])").find("use \"position\""),
            std::string::npos);
}

TEST(SceneErrors, ValuesOutOfRangeHavePlacesToo) {
  EXPECT_EQ(problem("\"probes\": [\n  {\"name\": \"room\",\n   \"box\": {\"min\": [3, 0, 0], \"max\": [1, 1, 1]}}]"),
            "scene.json:4:4: probes.room.box: min.x 3 is greater than max.x 1; swap them");
  EXPECT_EQ(problem("\"probes\": [{\"name\": \"room\"},\n {\"name\": \"room\"}]"),
            "scene.json:3:3: probes[1].name: \"room\" is already the name of probes[0]; give each its own");
  EXPECT_EQ(problem(R"("cameras": {"a": {"target": [0, 1.6, 5]}})"),
            "scene.json:2:19: cameras.a.target: is the camera's own position; move one of them");
  const std::string technique = problem(R"("probes": [{"name": "room", "technique": "boxx"}])");
  EXPECT_EQ(technique.rfind("scene.json:2:29: probes.room.technique: \"boxx\" is not known", 0), 0u) << technique;
}

/// One of everything, nothing at its default.
Scene richScene() {
  Scene scene = parsed(
      R"("models": [{"file": "a.stl", "translation": [0.1, 1e6, -3e-7], "unit": "mm", "upAxis": "z"}, "sub/b.glb"],
    "sky": {"top": [0.1, 0.2, 0.3], "horizon": [1, 1, 1]}, "exposure": 0.3,
    "cameras": {"b": {"position": [0.1, 0.2, 0.3]}, "a": {"up": [0, 0, 1], "verticalFovDegrees": 33.3, "parallelHeight": 2.5}},
    "lights": [{"type": "point", "position": [0, 2, 0], "color": [1, 0.3, 0.1], "intensity": 1234.5, "range": 9},
               {"type": "spot", "direction": [0, -1, 1], "position": [1, 2, 3], "innerConeDegrees": 10, "outerConeDegrees": 20}],
    "materials": {"floor \"new\"": {"roughness": 0.3, "baseColor": [0.1, 0.2, 0.7]}, "b": {}},
    "objects": {"mirror": {"visible": false, "weights": "object", "probeMode": "off"}, "plain": {},
                "moved": {"translation": [0.5, 0, 0], "rotationDegrees": [0, 12.5, 0]}},
    "mirrors": {"mirror": {"maxRoughness": 0.25}, "plain": {}}, "mirrorBudget": 500,
    "probes": [{"name": "room", "box": {"min": [-4.505, 0, -4.505], "max": [4.505, 5.01, 4.505]}, "clear": [0.1, 0.2, 0.3],
       "blendDistance": 0.7, "parameters": {"power": 0.1, "blur": true, "curve": "own"}, "hides": ["a", "b"],
       "influence": {"min": [-1, -1, -1], "max": [1, 1, 1]}, "bevel": 0.3, "occlusion": {"strength": 0.1}},
      {"name": "Halle \u00fc", "blendDistance": {"min": [0.1, 0.2, 0.3], "max": [1, 2, 3]}, "clear": "none",
       "bevel": {"fromRoughness": 0.1}, "mode": "realtime", "filter": "gaussian", "image": "x.exr"}])");
  return scene;
}

TEST(SceneText, ReadsBackEqual) {
  const Scene scene = richScene();
  const std::string text = sceneText(scene, "folder");
  EXPECT_EQ(parseScene(text, "again", "folder"), scene) << text;
  EXPECT_EQ(sceneText(parseScene(text, "again", "folder"), "folder"), text);
  EXPECT_EQ(parseScene(sceneText(Scene(), "x"), "again", "x"), Scene());
}

TEST(SceneText, EveryNumberReadsBackBitForBit) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-12.0, 12.0), sign(-1.0, 1.0);
  const auto number = [&] { return sign(random) * std::pow(10.0, exponent(random)); };
  for (int round = 0; round < 500; ++round) {
    Scene scene;
    scene.probes.emplace_back();
    scene.probes[0].origin = {number(), number(), -0.0};
    scene.probes[0].importance = number();
    scene.sky = SkyColor{glm::vec3(std::abs(number()), std::abs(number()), 0.1f)};
    scene.materials["m"].normalScale = static_cast<float>(number());
    const Scene again = parseScene(sceneText(scene, ""), "again", "");
    ASSERT_EQ(again, scene) << sceneText(scene, "");
    EXPECT_TRUE(std::signbit(again.probes[0].origin.z));
  }
}

TEST(SceneText, IsForPeople) {
  Scene scene;
  scene.models.push_back({"scenes/room.glb", {}, {}, 1.0});
  scene.cameras.emplace_back();
  scene.materials["floor"].roughness = 0.3f;
  scene.probes.emplace_back();
  scene.probes[0].blendDistance = {glm::dvec3(0.5), glm::dvec3(0.5)};
  EXPECT_EQ(sceneText(scene, "scenes"), R"({
  "format": "boxprobe-scene",
  "version": 1,
  "model": "room.glb",
  "cameras": {
    "main": {"position": [0, 1.6, 5], "target": [0, 1, 0]}
  },
  "materials": {
    "floor": {"roughness": 0.3}
  },
  "probes": [
    {
      "name": "probe",
      "origin": [0, 0, 0],
      "box": {"min": [-1, -1, -1], "max": [1, 1, 1]},
      "blendDistance": 0.5
    }
  ]
}
)");
}

TEST(SceneText, PathsAreRelativeToTheSceneWherePossible) {
  Scene scene;
  const auto written = [&](const std::string& file, const std::string& folder) {
    scene.models = {{file, {}, {}, 1.0}};
    const std::string text = sceneText(scene, folder);
    const std::size_t start = text.find("\"model\": \"") + 10;
    return text.substr(start, text.find('"', start) - start);
  };
  EXPECT_EQ(written("a/b/m.glb", "a/b"), "m.glb");
  EXPECT_EQ(written("a/m.glb", "a/b"), "../m.glb");
  EXPECT_EQ(written("/home/x/m.glb", "/home/y"), "../x/m.glb");
  EXPECT_EQ(written("/opt/m.glb", "/home/y"), "/opt/m.glb");
  EXPECT_EQ(written("m.glb", "."), "m.glb");
}

class SceneFile : public TemporaryFolder {};

TEST_F(SceneFile, SavesAndLoadsEqual) {
  write("sub/room.glb", "not looked into");
  Scene scene;
  scene.models.push_back({file("sub/room.glb"), {}, {}, 1.0});
  scene.probes.emplace_back();
  saveSceneFile(scene, file("room.boxprobe.json"));
  EXPECT_NE(read("room.boxprobe.json").find("\"model\": \"sub/room.glb\""), std::string::npos);
  EXPECT_EQ(loadSceneFile(file("room.boxprobe.json")), scene);
  EXPECT_EQ(entryCount(), 2u);  // nothing temporary is left
}

TEST_F(SceneFile, FilesThatAreMissingAreNamedWithTheirKey) {
  const std::string scene = write("s.json", std::string(kHead) + ",\n \"model\": \"gone.glb\" }");
  EXPECT_EQ(errorText([&] { loadSceneFile(scene); }),
            scene + ":2:2: model: " + file("gone.glb") + " does not exist; correct the name or put the model there");
  write("here.glb", "x");
  write("s.json", std::string(kHead) + ", \"models\": [\"here.glb\",\n {\"file\": \"gone.glb\"}] }");
  EXPECT_EQ(errorText([&] { loadSceneFile(scene); }).rfind(scene + ":2:3: models[1].file: ", 0), 0u);
  write("s.json", std::string(kHead) + ",\n \"sky\": {\"image\": \"gone.hdr\"} }");
  EXPECT_EQ(errorText([&] { loadSceneFile(scene); }).rfind(scene + ":2:10: sky.image: ", 0), 0u);
  write("s.json", std::string(kHead) + ", \"model\": \".\" }");
  EXPECT_NE(errorText([&] { loadSceneFile(scene); }).find("is not a file"), std::string::npos);
  EXPECT_EQ(errorText([&] { loadSceneFile(file("gone.json")); }),
            file("gone.json") + ": does not exist; check the path");
  EXPECT_NE(errorText([&] { loadSceneFile(folder_.string()); }), "");
}

TEST_F(SceneFile, AnInvalidSceneDoesNotReplaceAFile) {
  write("s.json", "old");
  Scene scene;
  scene.exposure = std::nan("");
  EXPECT_EQ(errorText([&] { saveSceneFile(scene, file("s.json")); }), "exposure: is not a finite number");
  EXPECT_EQ(read("s.json"), "old");
}

TEST(BareModel, GetsACameraAndAProbe) {
  const Scene scene = sceneForModel("a.glb");
  EXPECT_EQ(scene.models[0].file, "a.glb");
  EXPECT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.probes.size(), 1u);
}

}  // namespace
}  // namespace boxprobe
