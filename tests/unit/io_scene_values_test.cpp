// Whole scenes as text, short and complete, against io_scene_values.txt; JSON's layout and places; and every value that
// is refused, word by word.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "filters/core/scene/scene_fields.h"
#include "filters/io/json/json_cursor.h"
#include "filters/io/json/json_text.h"
#include "filters/io/scene/pareto_front_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/io/scene/scene_json.h"
#include "filters/io/scene/scene_reference.h"
#include "filters/math/technique/parameter_table.h"
#include "tests/support/kept_values.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::ElementsAre;

const char* const kStart = R"({ "format": "boxprobe-scene", "version": 1)";

Scene sceneOf(const std::string& members) {
  return parseScene(std::string(kStart) + ", " + members + " }", "scene.json", "folder");
}

std::string refusal(const std::string& members) {
  return errorText([&] { parseScene(std::string(kStart) + ",\n" + members + "\n}", "scene.json", "folder"); });
}

/// Several of each part, every field another number.
const char* const kScene = R"("models": [
      {"file": "a.stl", "translation": [0.1, 1e6, -3e-7], "rotationDegrees": [1, 2.5, -3], "scale": 2.5, "unit": "mm",
       "upAxis": "z"}, "sub/b.glb", {"file": "/else/c.glb", "variant": "red", "time": 1.25, "unit": "ft", "upAxis": "x"}],
    "sky": {"image": "sky.hdr", "cubeView": "inside", "sun": "in-picture", "rotationDegrees": 33},
    "cameras": {"b": {"position": [0.1, 0.2, 0.3], "target": [1, 2, 3.5], "up": [0, 0.5, 1]},
                "a": {"verticalFovDegrees": 33.3, "parallelHeight": 2.5}},
    "lights": [{"type": "point", "position": [0, 2, 0], "color": [1, 0.3, 0.1], "intensity": 1234.5, "range": 9,
                "radius": 0.25, "shadows": "coverage"},
               {"type": "spot", "direction": [0, -1, 1], "position": [1, 2, 3], "innerConeDegrees": 10,
                "outerConeDegrees": 20, "shadows": "coverage+map", "shadowLevel": "distance", "levelsPerUnit": 0.75},
               {"type": "directional", "direction": [0.3, -0.9, 0.1], "angleDegrees": 2.5, "intensity": 3}],
    "materials": {"floor \"new\"": {"roughness": 0.3, "baseColor": [0.1, 0.2, 0.7], "metallic": 0.6, "emissive": [1, 2, 3],
                  "normalScale": 0.8, "coat": 0.35, "ior": 1.3, "transmission": 0.5, "thickness": 0.4,
                  "attenuationDistance": 2, "attenuationColor": [0, 0.5, 1], "thin": false, "glass": "two-pass"}, "b": {}},
    "objects": {"mirror": {"visible": false, "seenByProbes": false, "dynamic": true, "weights": "object",
                           "probeMode": "off"},
                "moved": {"translation": [0.5, 0, 0], "rotationDegrees": [0, 12.5, 0], "probeMode": "simple"}, "plain": {}},
    "mirrors": {"mirror": {"enabled": false, "maxRoughness": 0.25, "resolution": 0.5}, "plain": {}}, "mirrorBudget": 500,
    "exposure": 0.3, "tone": "agx", "background": "color", "backgroundColor": [0.1, 0.2, 0.3], "groundShadow": true,
    "ambientOcclusion": true, "energy": "multiple", "lamps": "in-map",
    "probes": [{"name": "room", "origin": [1, 2, 3], "rotationDegrees": [4, 5, 6],
       "box": {"min": [-4.505, 0, -4.505], "max": [4.505, 5.01, 4.5]}, "near": 0.5, "far": 50, "clear": [0.1, 0.2, 0.3],
       "blendDistance": 0.7, "importance": 2, "intensity": 0.5, "projection": false, "technique": "sphere",
       "parameters": {"power": 0.1, "blur": true, "curve": "own"}, "faceSize": 64, "bounces": 3, "mode": "custom",
       "image": "room.exr", "imageLayout": "cross", "cubeView": "inside", "imageRotationDegrees": 15, "encoding": "rgbm",
       "decode": [8, 1.5], "filter": "gaussian", "samplesPerPixel": 16, "filterSamples": 160, "hides": ["a", "b"],
       "influence": {"min": [-1, -2, -3], "max": [1, 2.5, 3]}, "bevel": 0.3, "lattice": {"spacing": 0.7},
       "occlusion": {"multiplier": 2, "power": 3, "strength": 0.1}},
      {"name": "Halle \u00fc", "blendDistance": {"min": [0.1, 0.2, 0.3], "max": [1, 2, 3]}, "clear": "none",
       "bevel": {"fromRoughness": 0.1}, "mode": "realtime", "bounces": "all", "lattice": false},
      {"name": "open", "clear": "open", "blendDistance": {"min": [1, 2, 1], "max": [1, 2, 1]},
       "bevel": {"radius": 0.25, "fromRoughness": 0.5}}])";

TEST(SceneValues, WholeScenesAsText) {
  test::KeptValues values;
  const Scene scene = sceneOf(kScene);
  values.add(sceneText(scene, "folder"));
  values.add("== complete");
  values.add(formatJson(sceneToJson(scene, "", JsonForm::Complete)));
  for (const char* sky :
       {R"("sky": {"color": [1, 0.25, 0.5]})", R"("sky": {"top": [0.1, 0.2, 0.3]})", R"("sky": {"rotationDegrees": 5})",
        R"("model": "only.glb")", R"("models": [{"file": "only.glb", "scale": 2}])", R"("models": [])"}) {
    values.add(std::string("== ") + sky);
    values.add(sceneText(sceneOf(sky), "folder"));
    values.add(formatJson(sceneToJson(sceneOf(sky), "folder", JsonForm::Complete)["sky"]));
  }
  values.add("== a new scene");
  values.add(formatJson(sceneToJson(Scene(), "", JsonForm::Complete)));
  values.add(sceneText(sceneForModel("a.glb"), ""));
  values.expect("unit/values/io_scene_values.txt");
  EXPECT_EQ(sceneFromJson(sceneToJson(scene, "", JsonForm::Complete), ""), scene);
}

TEST(SceneValues, EachRefusalWordByWord) {
  const auto probe = [](const std::string& rest) { return refusal(R"("probes": [{"name": "room", )" + rest + "}]"); };
  const std::string at = "scene.json:2:29: probes.room.";
  EXPECT_EQ(probe(R"("blendDistance": "wide")"),
            at + "blendDistance: must be a number, or {\"min\": [..], \"max\": [..]}");
  EXPECT_EQ(probe(R"("clear": 1)"), at + "clear: must be \"sky\", \"open\", \"none\" or a color [r, g, b]");
  EXPECT_EQ(probe(R"("clear": [1, 2])"), at + "clear: must be three numbers in brackets, not [1,2]");
  EXPECT_EQ(probe(R"("bevel": "round")"), at + "bevel: must be a radius, or {\"fromRoughness\": FACTOR}");
  EXPECT_EQ(probe(R"("parameters": {"power": null})"),
            "scene.json:2:44: probes.room.parameters.power: must be a number, true or false, or text in quotes");
  EXPECT_EQ(probe(R"("hides": ["a", 2])"), "scene.json:2:44: probes.room.hides[1]: must be text in quotes, not 2");
  EXPECT_EQ(probe(R"("hides": "a")"), at + "hides: must be a list in brackets, not \"a\"");
  EXPECT_EQ(probe(R"("box": 3)"), at + "box: must be an object in braces, not 3");
  EXPECT_EQ(probe(R"("faceSize": 3000000000)"), at + "faceSize: must be a whole number, not 3000000000");
  EXPECT_THAT(probe(R"("faceSize": 2147483647)"), testing::HasSubstr("is 2147483647 and must be a power of two"));
  EXPECT_EQ(probe(R"("image": 3)"), at + "image: must be text in quotes, not 3");
  EXPECT_EQ(probe(R"("decode": [1, 2, 3])"), at + "decode: must be two numbers in brackets, not [1,2,3]");
  EXPECT_EQ(probe(R"("origin": "0 0 0")"), at + "origin: must be three numbers in brackets, not \"0 0 0\"");
  EXPECT_EQ(probe(R"("origin": [1, 2, 3, 4, 5])"), at + "origin: must be three numbers in brackets, not a list of 5");
  const std::string text(40, 'x');
  EXPECT_EQ(probe("\"projection\": \"" + text + "\""),
            at + "projection: must be true or false, not \"" + text.substr(0, 36) + "...");
  EXPECT_EQ(probe("\"projection\": \"" + text.substr(2) + "\""),
            at + "projection: must be true or false, not \"" + text.substr(2) + "\"");
  const auto light = [](const std::string& rest) { return refusal("\"lights\": [{" + rest + "}]"); };
  EXPECT_EQ(light(R"("intensity": 1)"),
            "scene.json:2:12: lights[0]: has no type; add \"type\": \"directional\", \"point\" or \"spot\"");
  EXPECT_EQ(light(R"("type": "point", "angleDegrees": 2)"),
            "scene.json:2:30: lights[0].angleDegrees: belongs to a directional light; use \"radius\"");
  EXPECT_EQ(light(R"("type": "directional", "radius": 2)"),
            "scene.json:2:36: lights[0].radius: does not belong to a directional light; use \"angleDegrees\"");
  EXPECT_EQ(light(R"("type": "point", "innerConeDegrees": 2)"),
            "scene.json:2:30: lights[0].innerConeDegrees: belongs to a spot light");
  EXPECT_EQ(light(R"("type": "spotty")"),
            "scene.json:2:13: lights[0].type: must be one of \"directional\", \"point\", \"spot\", not \"spotty\"");
  EXPECT_EQ(refusal(R"("sky": {"image": "a", "top": [1, 1, 1]})"),
            "scene.json:2:1: sky: mixes kinds; give an image, or a color, or top, horizon and ground");
  EXPECT_EQ(refusal(R"("sky": {"image": "a", "color": [1, 1, 1]})").find("mixes kinds") == std::string::npos, false);
  EXPECT_EQ(refusal(R"("models": 3)"), "scene.json:2:1: models: must be a list in brackets, not 3");
  EXPECT_EQ(refusal(R"("models": [{"scale": 2}])").rfind("scene.json:2:12: models[0]: has no file", 0), 0u);
  EXPECT_EQ(refusal(R"("model": {"file": "a.glb", "scale": "x"})"),
            "scene.json:2:28: model.scale: must be a number, not \"x\"");
  EXPECT_EQ(refusal(R"("materials": [])"), "scene.json:2:1: materials: must be an object in braces, not []");
  EXPECT_EQ(refusal(R"("materials": {"a": {"ior": 1e39}})"),
            "scene.json:2:21: materials.a.ior: 1e+39 is too large; use a smaller number");
  EXPECT_EQ(refusal(R"("exposure": true)"), "scene.json:2:1: exposure: must be a number, not true");
  const auto whole = [](const std::string& file) { return errorText([&] { parseScene(file, "s.json", ""); }); };
  EXPECT_EQ(whole(R"({"format": "boxprobe-lesson"})"),
            "s.json:1:2: format: is \"boxprobe-lesson\", not \"boxprobe-scene\"");
  EXPECT_EQ(whole(R"({"format": "boxprobe-scene"})"), "s.json:1:1: has no version; add \"version\": 1");
  EXPECT_EQ(whole("[]"), "s.json:1:1: must be an object in braces, not []");
}

TEST(SceneValues, NumbersOfTheCommandLine) {
  const Scene scene = sceneOf(kScene);
  const auto number = [&](const char* keys) { return sceneNumber(scene, keys).value_or(-77.0); };
  EXPECT_EQ(number("exposure"), 0.3);
  EXPECT_EQ(number("probes.room.box.max[2]"), 4.5);
  EXPECT_EQ(number("probes.Halle \xc3\xbc.blendDistance.max.1"), 2.0);
  EXPECT_EQ(number("lights[1].levelsPerUnit"), 0.75);
  EXPECT_EQ(number("cameras.a.parallelHeight"), 2.5);
  EXPECT_EQ(number("sky.rotationDegrees"), 33.0);
  EXPECT_EQ(number("models.0.translation[1]"), 1e6);
  for (const char* keys : {"probes.room.name", "probes.room", "nothing", "probes.cellar.far", "lights[9].range",
                           "lights", "probes.room.box.max[3]", "exposure.x"}) {
    EXPECT_FALSE(sceneNumber(scene, keys)) << keys;
  }
}

TEST(SceneValues, AssignmentsReachWhatTheyName) {
  const auto after = [](const std::vector<std::string>& assignments) {
    Scene scene = sceneOf(kScene);
    setSceneFields(scene, assignments);
    return scene;
  };
  EXPECT_EQ(after({"models[1].scale=3"}).models[1].scale, 3.0);
  EXPECT_EQ(after({"models[2].time=2.5"}).models[2].time, 2.5);
  EXPECT_EQ(after({"model=x.glb"}).models.size(), 1u);
  EXPECT_EQ(after({"lights.2.direction[1]=-5"}).lights[2].direction, glm::dvec3(0.3, -5, 0.1));
  EXPECT_EQ(after({"probes.room.parameters.power=3"}).probes[0].parameters.size(), 3u);
  EXPECT_EQ(after({"probes.open.influence.min[0]=-9"}).probes[2].influence, (Box{{-9, -1, -1}, {1, 1, 1}}));
  EXPECT_EQ(after({"probes.room.influence.min[0]=-9"}).probes[0].influence, (Box{{-9, -2, -3}, {1, 2.5, 3}}));
  EXPECT_EQ(after({"probes.room.influence={\"min\": [0, 0, 0], \"max\": [1, 1, 1]}"}).probes[0].influence,
            (Box{{0, 0, 0}, {1, 1, 1}}));
  const Scene gradient = after({"sky.horizon=[1, 1, 1]"});
  EXPECT_EQ(gradient.sky, Sky(SkyGradient{SkyGradient().top, glm::vec3(1.0f), SkyGradient().ground}));
  EXPECT_EQ(gradient.skyRotationDegrees, 33.0) << "of any sky";
  EXPECT_EQ(after({"sky.rotationDegrees=4"}).sky, sceneOf(kScene).sky);
  EXPECT_EQ(std::get<SkyImage>(after({"sky.sun=lamp"}).sky).file, "folder/sky.hdr");
  EXPECT_EQ(after({"materials.\"floor \\\"new\\\"\".metallic=0.25"}).materials.at("floor \"new\"").metallic, 0.25f);
  EXPECT_EQ(after({"materials.\"a=\\\\\".metallic=0.25"}).materials.at("a=\\").metallic, 0.25f);
  EXPECT_FALSE(after({"objects.\"a=b\"={\"visible\": false}"}).objects.at("a=b").visible);
  EXPECT_EQ(after({"probes.\"x\".far=9", "probes.\"y\".far=8"}).probes[4].farDistance, 8.0);
  EXPECT_EQ(after({"cameras.\"c\".parallelHeight=3"}).cameras[2].parallelHeight, 3.0);
  EXPECT_EQ(after({"probes.room.technique=box"}).probes[0].technique, "box");
  EXPECT_EQ(after({"probes.room.technique=\"box\""}).probes[0].technique, "box");
  const auto said = [&](const std::vector<std::string>& assignments) { return errorText([&] { after(assignments); }); };
  EXPECT_EQ(said({"exposure=2", "lights[3].range=1"}),
            "--set lights[3].range=1: lights[3]: there are 3 elements, counted from 0");
  EXPECT_EQ(said({"exposure=2", "exposure=-1"}), "--set: exposure: is -1 and must be from 0 to 1e+12");
  EXPECT_EQ(said({"exposure=-1"}), "--set exposure=-1: exposure: is -1 and must be from 0 to 1e+12");
  EXPECT_EQ(said({"=1"}), "--set =1: is not an assignment; write KEY=VALUE");
  EXPECT_EQ(said({".=1"}), "--set .=1: names no key; write KEY=VALUE");
  EXPECT_EQ(said({"exposure[0]=1"}), "--set exposure[0]=1: exposure[0]: has nothing below it; end the key before it");
  EXPECT_EQ(said({"lights[x].range=1"}),
            "--set lights[x].range=1: lights[x]: is not an element; use an index such as [0]");
  EXPECT_EQ(said({"probes.\"open\"x=1"}),
            "--set probes.\"open\"x=1: the name in quotes does not end; write GROUP.\"NAME\".FIELD=VALUE");
}

TEST(JsonLayout, IsForPeopleAndFitsALine) {
  const auto text = [](const char* json) { return formatJson(boxprobe::Json::parse(json)); };
  EXPECT_EQ(text("3"), "3\n");
  EXPECT_EQ(text("[]"), "[]\n");
  EXPECT_EQ(text("{}"), "{}\n");
  EXPECT_EQ(text("[1, 2]"), "[\n  1,\n  2\n]\n") << "the outermost is spread out";
  EXPECT_EQ(text(R"({"a": {"b": [1, 2], "c": "x"}})"), "{\n  \"a\": {\"b\": [1, 2], \"c\": \"x\"}\n}\n");
  EXPECT_EQ(text(R"({"a": {"b": {"c": 1}}})"), "{\n  \"a\": {\n    \"b\": {\"c\": 1}\n  }\n}\n");
  EXPECT_EQ(text(R"({"a": {"b": [1], "c": [2], "d": [3]}})"), "{\n  \"a\": {\"b\": [1], \"c\": [2], \"d\": [3]}\n}\n");
  EXPECT_EQ(text(R"({"a": {"b": [1], "c": 2, "d": 3, "e": 4}})"),
            "{\n  \"a\": {\n    \"b\": [1],\n    \"c\": 2,\n    \"d\": 3,\n    \"e\": 4\n  }\n}\n");
  EXPECT_EQ(text(R"({"a": [1, 2, 3, 4, 5]})"), "{\n  \"a\": [1, 2, 3, 4, 5]\n}\n");
  EXPECT_EQ(text(R"({"a": [[1], [2]]})"), "{\n  \"a\": [[1], [2]]\n}\n");
  EXPECT_EQ(text(R"({"a": [[[1]], 2]})"), "{\n  \"a\": [\n    [[1]],\n    2\n  ]\n}\n");
  // A line has 100 characters: "  "a": [" and "]," around, two for each element beyond its own.
  const auto line = [&](std::size_t length) {
    return text(("{\"a\": [1, \"" + std::string(length, 'x') + "\"]}").c_str());
  };
  std::size_t longest = 0;
  for (std::size_t length = 60; length < 120; ++length) {
    if (line(length).find("[1, ") != std::string::npos) longest = length;
  }
  // Used before it 7: 2 and "a": ; its own text is [1,"..."] with length + 6, and 2 x 2 + 8 more.
  EXPECT_EQ(longest, 100u - 7 - 6 - 12);
}

TEST(JsonPlaces, AreThoseOfKeysAndElements) {
  const JsonText json = parseJsonText(
      "\xef\xbb\xbf{\n \"a\\u0062\": [10, {\"c\": \"}]\\\"\"},\t[true,\n  null , \"x,y\"]],\n  \"\xc3\xa4\xc3\xb6\": "
      "-1.5e3, "
      "\"d\": {\"e\": {\"f\": []}}}",
      "s.json");
  const auto place = [&](const std::string& pointer) { return json.placeText(boxprobe::Json::json_pointer(pointer)); };
  EXPECT_EQ(place(""), "s.json:1:1");
  EXPECT_EQ(place("/ab"), "s.json:2:2");
  EXPECT_EQ(place("/ab/0"), "s.json:2:14");
  EXPECT_EQ(place("/ab/1"), "s.json:2:18");
  EXPECT_EQ(place("/ab/1/c"), "s.json:2:19");
  EXPECT_EQ(place("/ab/2"), "s.json:2:33");
  EXPECT_EQ(place("/ab/2/0"), "s.json:2:34");
  EXPECT_EQ(place("/ab/2/1"), "s.json:3:3");
  EXPECT_EQ(place("/ab/2/2"), "s.json:3:10");
  EXPECT_EQ(place("/ab/3"), "s.json:2:2") << "its list";
  EXPECT_EQ(place("/\xc3\xa4\xc3\xb6"), "s.json:4:3");
  EXPECT_EQ(place("/d"), "s.json:4:17") << "letters, not bytes";
  EXPECT_EQ(place("/d/e"), "s.json:4:23");
  EXPECT_EQ(place("/d/e/f"), "s.json:4:29");
  EXPECT_EQ(place("/d/x"), "s.json:4:17");
  JsonText nothing;
  nothing.name = "n";
  EXPECT_EQ(nothing.placeText(boxprobe::Json::json_pointer("/a")), "n");
}

TEST(JsonPlaces, OfMistakes) {
  const auto said = [](const std::string& text) { return errorText([&] { parseJsonText(text, "s"); }); };
  // A word that is none: where it begins, whatever was read before.
  const std::pair<const char*, const char*> words[] = {{R"({"a": nul})", "s:1:7: "},
                                                       {R"([true, fals])", "s:1:8: "},
                                                       {"[1,\n  nope]", "s:2:3: "},
                                                       {"none", "s: not"},
                                                       {R"(["x", trux])", "s:1:7: "}};
  for (const auto& [text, place] : words) EXPECT_EQ(said(text).rfind(place, 0), 0u) << said(text);
  const auto start = [&](const std::string& text) {
    const std::string all = said(text);
    return all.substr(0, all.find(": not valid JSON: "));
  };
  EXPECT_EQ(start("{\"a\": 1,\n  \"b\": 2,\n}"), "s:3:1");
  EXPECT_EQ(start("[1 2]"), "s:1:4");
  EXPECT_EQ(start("[\n1,\n\"\xc3\xa4\" 5]"), "s:3:5");
  EXPECT_EQ(start("{\"a\": 01}"), "s:1:8");
  EXPECT_EQ(said(std::string("{\n\"a\0\": 1}", 10)),
            "s:2:3: not valid JSON: there is a zero byte; save it as plain text");
  EXPECT_EQ(said("{\"a\": {\"b\": 1, \"b\": 2}}"), "s:1:16: the key \"b\" stands here a second time; remove one");
  const std::string deep = std::string(129, '[') + std::string(129, ']');
  EXPECT_EQ(said(deep), "s: not valid JSON: nested more than 128 levels deep");
  EXPECT_NO_THROW(parseJsonText(deep.substr(1, 256), "s"));
  const auto most = [](const std::string& text, std::size_t entries) {
    try {
      checkJsonSyntax(text, "s", entries);
      return std::string();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  const std::string end = ": has more than 2 entries, the most that are read; leave some out";
  EXPECT_EQ(most(R"({"a": [1, 2], "b": {"c": [], "d": {}}})", 2), "");
  EXPECT_EQ(most(R"({"a": [1, 2, 3]})", 2), "s: a" + end);
  EXPECT_EQ(most(R"({"a": [{}, [], "x"]})", 2), "s: a" + end);
  EXPECT_EQ(most(R"({"a": {"b": 1, "c": 2, "d": 3}})", 2), "s: a" + end);
  EXPECT_EQ(most("[null, true, 1.5]", 2), "s: the file" + end);
  EXPECT_EQ(most(R"({"a": 1, "b": [1, 2], "c": 3})", 2), "s: the file" + end);
}

TEST(SceneReferenceValues, JsonHasEachFieldsRow) {
  const nlohmann::json parts = nlohmann::json::parse(sceneReferenceJson());
  ASSERT_EQ(parts.size(), fieldParts().size() + 1);
  std::size_t number = 0;
  for (const FieldPart& part : fieldParts()) {
    const nlohmann::json& json = parts[number++];
    EXPECT_EQ(json["path"], std::string(part.path));
    EXPECT_EQ(json["help"], std::string(part.help));
    ASSERT_EQ(json["fields"].size(), part.fields.size());
    for (std::size_t i = 0; i < part.fields.size(); ++i) {
      const FieldInfo& field = *part.fields[i].field;
      const nlohmann::json& row = json["fields"][i];
      SCOPED_TRACE(std::string(part.path) + " " + std::string(field.key));
      EXPECT_EQ(row["key"], std::string(field.key));
      EXPECT_EQ(row["help"], std::string(field.help));
      EXPECT_EQ(row.contains("unit"), !field.unit.empty());
      EXPECT_EQ(row["required"], !field.required.empty());
      EXPECT_EQ(row.contains("default"), field.required.empty() && field.ifLeftOut.empty());
      EXPECT_EQ(row.value("leftOut", ""), std::string(field.ifLeftOut));
      EXPECT_EQ(row.contains("values"), !field.values.empty());
      EXPECT_EQ(row.contains("choices") ? row["choices"].size() : 0, field.choices.size());
      const bool ranged = field.kind == FieldKind::Number || field.kind == FieldKind::Integer ||
                          field.kind == FieldKind::Vector || field.kind == FieldKind::Color;
      const bool low = ranged && std::abs(field.range.lowest) < 1e18,
                 high = ranged && std::abs(field.range.highest) < 1e18;
      EXPECT_EQ(row.contains("lowest"), low && !field.range.aboveLowest);
      EXPECT_EQ(row.contains("above"), low && field.range.aboveLowest);
      EXPECT_EQ(row.contains("highest"), high && !field.range.belowHighest);
      EXPECT_EQ(row.contains("below"), high && field.range.belowHighest);
      if (low) {
        EXPECT_EQ(row[field.range.aboveLowest ? "above" : "lowest"], field.range.lowest);
      }
      if (high) {
        EXPECT_EQ(row[field.range.belowHighest ? "below" : "highest"], field.range.highest);
      }
      EXPECT_EQ(row["changes"].size(), (field.changes.empty() ? part.changes : field.changes).size());
    }
  }
  const nlohmann::json& parameters = parts.back()["fields"];
  ASSERT_EQ(parameters.size(), parameterRows().size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ParameterRow& row = parameterRows()[i];
    SCOPED_TRACE(row.name);
    const nlohmann::json& standard = parameters[i]["default"];
    EXPECT_EQ(parameters[i]["key"], std::string(row.name));
    EXPECT_EQ(parameters[i]["required"], false);
    EXPECT_EQ(parameters[i]["kind"], "parameter");
    EXPECT_EQ(parameters[i].contains("unit"), !row.unit.empty());
    EXPECT_EQ(standard.is_boolean(), row.kind == ParameterKind::Switch);
    EXPECT_EQ(standard.is_string(), row.kind == ParameterKind::Choice);
    if (standard.is_boolean()) {
      EXPECT_EQ(standard, row.standard != 0.0);
    } else if (standard.is_string()) {
      EXPECT_EQ(standard, std::string(row.choices[static_cast<std::size_t>(row.standard)]));
    } else {
      EXPECT_EQ(standard, row.standard);
    }
  }
}

class ParetoFile : public TemporaryFolder {};

TEST_F(ParetoFile, PointsAreThoseOfTheReference) {
  const std::string entry =
      R"({"reference": "scene", "technique": "box+hdrp", "label": "Box", "frameCpuRatioToBox": 1.5,
      "error": 0.25, "onFront": true, "ours": false})";
  const std::string path =
      write("b.json", R"({"summary": [{"reference": "box"}, )" + entry + ", " +
                          R"({"reference": "scene", "technique": "x", "label": "X", "frameCpuRatioToBox": 3,
      "error": 0.125, "onFront": false, "ours": true}]})");
  const std::vector<ParetoPoint> points = loadParetoFront(path, "scene");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].id, "box+hdrp");
  EXPECT_EQ(points[0].label, "Box");
  EXPECT_EQ(points[0].cost, 1.5);
  EXPECT_EQ(points[0].error, 0.25);
  EXPECT_TRUE(points[0].onParetoFront);
  EXPECT_FALSE(points[0].ours);
  EXPECT_EQ(points[1].cost, 3.0);
  EXPECT_FALSE(points[1].onParetoFront);
  EXPECT_TRUE(points[1].ours);
  EXPECT_EQ(errorText([&] { loadParetoFront(path, "box"); }),
            path + ": not a bench.json of this version; write it again with boxprobe bench");
}

}  // namespace
}  // namespace boxprobe
