// What `info` and `explain --json` tell of a scene and of a pixel in which every value is another, against
// scene_report_values.txt.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/cli/report/report_text.h"
#include "app/cli/report/scene_report.h"
#include "app/session/explanation_json.h"
#include "app/session/load_scene.h"
#include "filters/core/scene/bounces.h"
#include "filters/explain/verdict.h"
#include "tests/support/kept_values.h"
#include "tests/unit/explained_room.h"

namespace boxprobe {
namespace {

std::shared_ptr<const ImageRgba8> imageOf(int width, int height) {
  return std::make_shared<const ImageRgba8>(
      ImageRgba8{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height), 200), {}});
}

/// A square of 2 by 1, facing down from a height.
Mesh lampMesh(float height, float right) {
  Mesh mesh;
  mesh.positions = {{right, height, 0}, {right + 2, height, 0}, {right + 2, height, 1}, {right, height, 1}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

std::shared_ptr<const Model> oddModel() {
  Model model;
  Material tiles;
  tiles.name = "tiles\nof stone";
  tiles.baseColorTexture.image = imageOf(6, 4);
  tiles.normalTexture.image = imageOf(10, 8);
  tiles.emissiveTexture.image = tiles.normalTexture.image;
  Material glow;
  glow.name = "glow";
  glow.emissive = {3.0f, 2.0f, 1.0f};
  glow.metallic = 0.0f;
  model.materials = {tiles, glow};
  Mesh floor;
  floor.positions = {{-3, 0, -3}, {3, 0, -3}, {3, 0, 3}, {-3, 0, 3}, {0, 0.1f, 0}};
  floor.normals.assign(5, glm::vec3(0, 1, 0));
  floor.tangents.assign(5, glm::vec4(1, 0, 0, 1));
  floor.uv.assign(5, glm::vec2(0.5f));
  floor.uv1.assign(5, glm::vec2(0.25f));
  floor.colors.assign(5, glm::vec4(1.0f));
  floor.indices = {0, 2, 1, 0, 3, 2, 0, 1, 4};
  floor.material = 0;
  model.meshes = {floor, lampMesh(2.5f, -1.0f), lampMesh(2.2f, 2.0f)};
  model.meshes[1].material = model.meshes[2].material = 1;
  model.instances = {{"floor", 0, glm::dmat4(1.0)},
                     {"ceiling lamp", 1, glm::dmat4(1.0)},
                     {"table", 0, glm::dmat4(1.0)},
                     {"shelf lamp", 2, glm::dmat4(1.0)},
                     {"floor", 0, glm::dmat4(1.0)}};
  model.variants = {"summer", "winter"};
  model.animationSeconds = 4.25;
  return std::make_shared<const Model>(model);
}

LoadedScene oddScene() {
  LoadedScene loaded;
  Scene& scene = loaded.scene;
  loaded.path = "/somewhere/odd.boxprobe.json";
  scene.models = {{"a.glb", {}, {}}, {"b.glb", {}, {}}};
  scene.models[1].unit = LengthUnit::Inch;
  Model plain;
  plain.meshes = {lampMesh(1.0f, 0.0f)};
  plain.instances = {{"sheet", 0, glm::dmat4(1.0)}};
  loaded.models = {oddModel(), std::make_shared<const Model>(plain)};
  scene.objects["floor"] = {false, true, true, ProbeUsage::Simple, WeightMode::Object, {}, {}};
  scene.objects["table"] = {true, false, false, ProbeUsage::Off, WeightMode::Pixel, {}, {}};
  scene.objects["sheet"] = {true, true, false, ProbeUsage::Blend, WeightMode::Pixel, {}, {}};
  scene.sky = SkyGradient{{0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f}, {0.7f, 0.8f, 0.9f}};
  scene.skyRotationDegrees = 33.0;
  Camera wide{"wide", {1, 2, 3}, {4, 5, 6}, {0, 1, 0}, 70.0, 0.0};
  Camera flat{"flat", {7, 8, 9}, {1, 3, 5}, {0, 1, 0}, 45.0, 6.5};
  scene.cameras = {wide, flat};
  Light sun;
  sun.direction = {0.1, -0.9, 0.2};
  sun.color = {1.0f, 0.9f, 0.8f};
  sun.intensity = 3.25f;
  sun.shadows = LightShadows::Coverage;
  sun.angleDegrees = 1.75;
  Light bulb;
  bulb.type = LightType::Point;
  bulb.position = {0.5, 1.5, 2.5};
  bulb.intensity = 7.0f;
  bulb.shadows = LightShadows::CoverageAndMap;
  bulb.radius = 0.125;
  Light spot = bulb;
  spot.type = LightType::Spot;
  spot.direction = {0.3, -0.4, 0.5};
  spot.innerConeDegrees = 11.0;
  spot.outerConeDegrees = 22.0;
  spot.shadows = LightShadows::None;
  scene.lights = {sun, bulb, spot};
  Probe hall;
  hall.name = "hall";
  hall.origin = {0.1, 1.2, 0.3};
  hall.box = {{-3.0, 0.0, -3.1}, {3.2, 2.6, 3.3}};
  hall.rotationDegrees = {1.0, 20.0, 3.0};
  hall.technique = "box+hdrp";
  hall.faceSize = 64;
  hall.bounces = 1;
  Probe part = hall;
  part.name = "part";
  part.influence = Box{{-1.0, 0.1, -1.1}, {1.2, 2.1, 1.3}};
  part.projection = false;
  part.faceSize = 128;
  part.bounces = kAllBounces;
  part.lattice = ProbeLattice{false, 1.0};
  part.box = {{-30.0, -30.0, -30.0}, {-20.0, -20.0, -20.0}};
  Probe picture = hall;
  picture.name = "picture";
  picture.mode = ProbeMode::Custom;
  picture.image = "no-such.hdr";
  picture.imageRotationDegrees = 45.0;
  picture.cubeView = CubeView::Inside;
  picture.bounces = 3;
  scene.probes = {hall, part, picture};
  scene.exposure = 1.625;
  loaded.warnings = {"first warning", "second\nwarning"};
  return loaded;
}

void addScenes(test::KeptValues& values) {
  LoadedScene loaded = oddScene();
  const auto add = [&](const std::string& title) {
    const nlohmann::ordered_json report = sceneReport(loaded);
    values.part(title);
    values.add(report.dump(1));
    values.add(sceneReportText(report));
  };
  add("scene");
  loaded.scene.lamps = LampForm::InMap;
  loaded.scene.sky = SkyColor{{0.15f, 0.25f, 0.35f}};
  loaded.scene.skyRotationDegrees = 0.0;
  loaded.scene.objects.clear();
  loaded.scene.probes.resize(1);
  loaded.scene.lights.clear();
  loaded.models[0] = loaded.models[1];
  loaded.warnings.clear();
  loaded.exposureAutomatic = true;
  ModelFit fit;
  fit.kind = ModelKind::Interior;
  fit.light = FitLight::Ceiling;
  fit.decided = Phrase::plain("an interior, it was decided");
  fit.survey.kind = ModelKind::Open;
  fit.survey.reason = Phrase::plain("for this reason");
  fit.survey.points.resize(7);
  fit.survey.solid = 0.11;
  fit.survey.enclosed = 0.22;
  fit.survey.walled = 0.33;
  fit.survey.floored = 0.44;
  fit.survey.sky = 0.55;
  fit.survey.backOutside = 0.66;
  fit.survey.largest = 7.7;
  loaded.fit = fit;
  add("bare model");
  loaded.exposureAutomatic = false;
  add("bare model of a fixed exposure");
}

Explanation oddExplanation() {
  ExplainedRoom room;
  room.probe.box = {{-2.0, -0.1, -3.0}, {2.5, 2.7, 2.2}};
  Explanation e = room.explain();
  e.rendered = glm::vec3(0.11f, 0.12f, 0.13f);
  e.direct = {0.21f, 0.22f, 0.23f};
  e.emissive = {0.31f, 0.32f, 0.33f};
  e.irradiance = glm::vec3(0.41f, 0.42f, 0.43f);
  e.diffuse = {0.51f, 0.52f, 0.53f};
  e.sheen = {0.61f, 0.62f, 0.63f};
  e.coat = {0.71f, 0.72f, 0.73f};
  e.specular = {0.81f, 0.82f, 0.83f};
  e.lookupCount = 17;
  e.skyWeight = 0.19f;
  e.skyLevel = 2.25f;
  e.skyValue = {0.91f, 0.92f, 0.93f};
  e.surface.coatStrength = 0.17f;
  e.surface.occlusion = 0.37f;
  e.surface.opacity = 0.57f;
  e.surface.metallic = 0.77f;
  e.notes = {Phrase::plain("a note"), Phrase::plain("another note")};
  MirrorExplanation mirror{{1.1f, 1.2f, 1.3f}, 0.14f, 0.15f, 1.6f, 1.7f, 18};
  e.mirror = mirror;
  GlassExplanation glass;
  glass.form = "two-interface";
  glass.back = true;
  glass.ior = 1.45f;
  glass.eta = 0.65f;
  glass.reflectance = 0.05f;
  glass.directionWorld = {0.6f, -0.5f, 0.4f};
  glass.exitWorld = {3.1, 3.2, 3.3};
  glass.distance = 0.35f;
  glass.roughness = 0.26f;
  glass.mirrored = 2;
  glass.transmittance = {0.96f, 0.97f, 0.98f};
  glass.passed = {0.86f, 0.87f, 0.88f};
  glass.looked = {0.76f, 0.77f, 0.78f};
  glass.stands = 0.67f;
  e.glass = glass;
  ProbeExplanation& p = e.probes[0];
  p.boxDistance = 4.25f;
  p.bevel = 0.45f;
  p.occlusion = 0.46f;
  p.coverage = 0.47f;
  p.openSky = {0.48f, 0.49f, 0.5f};
  p.openSkyLevel = 1.25f;
  p.distanceLookups = 5;
  p.influence = 0.58f;
  p.intensity = 0.59f;
  p.weight = 0.64f;
  p.trueDistance = 2.75f;
  p.maxLevel = 4.5f;
  p.irradiance = {0.54f, 0.55f, 0.56f};
  p.diffuse.lamps = {{"lamp", {0.24f, 0.25f, 0.27f}, 0.28f}};
  p.diffuse.nodes = {{{1, 2, 3}, {0.34f, 0.35f, 0.36f}, 0.38f, false}};
  p.diffuse.nodeCount = {4, 5, 6};
  p.diffuse.lattice = {0.39f, 0.4f, 0.44f};
  return e;
}

void addExplanations(test::KeptValues& values) {
  Explanation e = oddExplanation();
  Verdict verdict{Phrase::plain("it is off"), Mend{Phrase::plain("move it"), "room", {}}};
  verdict.mend->after.box = {{-1.1, -1.2, -1.3}, {2.1, 2.2, 2.3}};
  verdict.mend->after.influence = Box{{-3.1, -3.2, -3.3}, {4.1, 4.2, 4.3}};
  verdict.mend->after.projection = false;
  verdict.mend->after.technique = "box+none";
  values.part("pixel");
  values.add(explanationJson(e, verdict));
  values.part("pixel without what may be missing");
  e.glass.reset();
  e.mirror.reset();
  e.irradiance.reset();
  e.rendered.reset();
  e.color = glm::vec3(0.0f);
  e.notes.clear();
  ProbeExplanation& p = e.probes[0];
  p.hitDistance.reset();
  p.slabFactors.reset();
  p.boxDistance.reset();
  p.trueDistance.reset();
  p.occlusion.reset();
  p.coverage.reset();
  p.diffuse = {};
  p.face = -1;
  p.weight = std::numeric_limits<float>::quiet_NaN();
  verdict.mend->after.influence.reset();
  values.add(explanationJson(e, verdict));
  verdict.mend.reset();
  e.hit = false;
  e.probes.clear();
  values.part("background");
  values.add(explanationJson(e, verdict));
}

TEST(SceneReportValues, AreThoseOfTheFile) {
  test::KeptValues values;
  addScenes(values);
  addExplanations(values);
  values.expect("unit/values/scene_report_values.txt", 1e-5);
}

}  // namespace
}  // namespace boxprobe
