// See scene_report.h.
#include "app/cli/report/scene_report.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <variant>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/scene_lamps.h"
#include "filters/core/scene/bounces.h"
#include "filters/core/scene/scene_fields.h"
#include "filters/io/cube/sky_picture.h"
#include "filters/vtk/capture/prefilter.h"

namespace boxprobe {

namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json vector3(const Vector& v) {
  return Json::array({v.x, v.y, v.z});
}

Json boxReport(const Box& box) {
  return {{"min", vector3(box.min)}, {"max", vector3(box.max)}};
}

/// RGBA8 with its mip chain, a third more than level 0.
std::size_t textureBytes(const ImageRgba8& image) {
  const std::size_t level0 = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
  return level0 + level0 / 3;
}

/// What a model's vertices and triangles take in memory.
std::size_t arrayBytes(const Model& model) {
  std::size_t bytes = 0;
  const auto add = [&bytes](const auto& values) { bytes += values.size() * sizeof(values[0]); };
  for (const Mesh& mesh : model.meshes) {
    add(mesh.positions);
    add(mesh.normals);
    add(mesh.tangents);
    add(mesh.uv);
    add(mesh.uv1);
    add(mesh.colors);
    add(mesh.indices);
  }
  return bytes;
}

Json modelReport(const ModelFile& file, const Model& model) {
  std::set<const ImageRgba8*> images;
  std::size_t bytes = 0;
  for (const Material& m : model.materials) {
    for (const TextureUse* use : m.textures()) {
      if (use->image && images.insert(use->image.get()).second) bytes += textureBytes(*use->image);
    }
  }
  Json names = Json::array();
  for (const Material& material : model.materials) names.push_back(material.name);
  const char* const units[] = {"m", "cm", "mm", "in", "ft"};
  Json report = {{"file", file.file},
                 {"unit", units[static_cast<int>(file.unit)]},
                 {"meshes", model.meshes.size()},
                 {"triangles", model.triangleCount()},
                 {"materials", names},
                 {"textures", images.size()},
                 {"textureBytes", bytes},
                 {"arrayBytes", arrayBytes(model)}};
  if (!model.variants.empty()) report["variants"] = model.variants;
  if (model.animationSeconds > 0.0) report["animationSeconds"] = model.animationSeconds;
  return report;
}

/// What one probe holds on the graphics side once captured: the prefiltered chain (RGBA16F), without lamps once more if
/// it has some, and distances (R32F).
std::size_t probeTextureBytes(int faceSize, bool lamps) {
  const auto texels = [](int size) { return 6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size); };
  std::size_t bytes = 4 * texels(faceSize);
  for (int level = 0; level < prefilterLevels(faceSize); ++level) bytes += (lamps ? 16 : 8) * texels(faceSize >> level);
  return bytes;
}

std::string_view probeModeId(ProbeUsage mode) {
  switch (mode) {
    case ProbeUsage::Off:
      return "off";
    case ProbeUsage::Simple:
      return "simple";
    case ProbeUsage::Blend:
      return "blend";
    case ProbeUsage::BlendAndSky:
      return "blend+sky";
  }
  return "";
}

/// Every node of the models once, with what the scene overrides.
Json objectsReport(const LoadedScene& loaded) {
  Json objects = Json::array();
  std::set<std::string> seen;
  for (const auto& model : loaded.models) {
    for (const Instance& instance : model->instances) {
      if (!seen.insert(instance.node).second) continue;
      const auto found = loaded.scene.objects.find(instance.node);
      const ObjectOverride object = found == loaded.scene.objects.end() ? ObjectOverride{} : found->second;
      objects.push_back({{"name", instance.node},
                         {"overridden", found != loaded.scene.objects.end()},
                         {"visible", object.visible},
                         {"seenByProbes", object.seenByProbes},
                         {"dynamic", object.dynamic},
                         {"probeMode", probeModeId(object.probeUsage)},
                         {"weights", object.weights == WeightMode::Pixel ? "pixel" : "object"}});
    }
  }
  return objects;
}

/// Objects that are drawn as lamps, the most powerful first.
Json lampsReport(const SceneLamps& lamps) {
  Json report = Json::array();
  for (const SceneLamp& lamp : lamps.lamps) {
    const auto same =
        std::find_if(report.begin(), report.end(), [&](const Json& known) { return known["object"] == lamp.node; });
    if (same == report.end()) {
      report.push_back({{"object", lamp.node},
                        {"polygons", 1},
                        {"area", lamp.area},
                        {"radiance", vector3(lamp.radiance)},
                        {"power", lamp.power}});
      continue;
    }
    (*same)["polygons"] = (*same)["polygons"].get<int>() + 1;
    (*same)["area"] = (*same)["area"].get<double>() + lamp.area;
    (*same)["power"] = (*same)["power"].get<double>() + lamp.power;
  }
  return report;
}

/// What diffuse light of a probe is made of.
std::string diffuseLightOf(const Scene& scene, const Probe& probe) {
  if (scene.lamps != LampForm::Shapes || !probe.hasLattice()) return "coefficients";
  return probe.mode == ProbeMode::Custom ? "lattice" : "lamps and lattice";
}

/// A value of a choice as scene files have it.
template <typename Part>
std::string choiceId(const std::vector<FieldRow<Part>>& rows, const char* key, int value) {
  return std::string(fieldNamed(rows, key).choices.at(static_cast<std::size_t>(value)).id);
}

Json probeReport(const Scene& scene, const SceneLamps& lamps, const Probe& probe) {
  const bool lit = probe.mode != ProbeMode::Custom && !probeLamps(lamps.lamps, probe).empty();
  return {{"name", probe.name},
          {"diffuseLight", diffuseLightOf(scene, probe)},
          {"origin", vector3(probe.origin)},
          {"box", boxReport(probe.box)},
          {"influence", boxReport(probe.influenceBox())},
          {"rotationDegrees", vector3(probe.rotationDegrees)},
          {"technique", probe.technique},
          {"projection", probe.projection},
          {"faceSize", probe.faceSize},
          {"bounces", allBounces(probe) ? Json("all") : Json(probe.bounces)},
          {"textureBytes", probeTextureBytes(probe.faceSize, lit)}};
}

Json lightReport(const Light& light) {
  const bool directional = light.type == LightType::Directional;
  const char* const types[] = {"directional", "point", "spot"};
  Json report = {{"type", types[static_cast<int>(light.type)]},
                 {directional ? "direction" : "position", vector3(directional ? light.direction : light.position)},
                 {"color", vector3(light.color)},
                 {"intensity", light.intensity}};
  if (light.type == LightType::Spot) {
    report["direction"] = vector3(light.direction);
    report["innerConeDegrees"] = light.innerConeDegrees;
    report["outerConeDegrees"] = light.outerConeDegrees;
  }
  if (light.shadows != LightShadows::None) {
    report["shadows"] = light.shadows == LightShadows::Coverage ? "coverage" : "coverage+map";
    report[directional ? "angleDegrees" : "radius"] = directional ? light.angleDegrees : light.radius;
  }
  return report;
}

Json skyReport(const Sky& sky, double rotationDegrees, Json& warnings) {
  if (const auto* color = std::get_if<SkyColor>(&sky)) return {{"kind", "color"}, {"color", vector3(color->color)}};
  if (const auto* image = std::get_if<SkyImage>(&sky)) {
    const DrawnSky drawn = loadDrawnSky(*image);  // one that cannot be read is found out here, too
    const SkyPictureNotes& notes = drawn.notes;
    const ImageRgbaF& pixels = drawn.image;
    for (const std::string& sentence : notes.repairs.sentences()) warnings.push_back("sky.image: " + sentence);
    Json report = {{"kind", "image"},
                   {"file", image->file},
                   {"width", pixels.width},
                   {"height", pixels.height},
                   {"texelsNotFinite", notes.repairs.notFinite},
                   {"layout", choiceId(probeFields(), "imageLayout", static_cast<int>(notes.layout))}};
    if (notes.layout != CubeLayout::LatLong) {
      report["cubeView"] = choiceId(skyImageFields(), "cubeView", static_cast<int>(image->cubeView));
    }
    if (drawn.sun) {
      report["sunLight"] = lightReport(lightOf(*drawn.sun, rotationDegrees));
      report["sunLight"]["angleDegrees"] = drawn.sun->angleDegrees;
    }
    return report;
  }
  const SkyGradient& gradient = std::get<SkyGradient>(sky);
  return {{"kind", "gradient"},
          {"top", vector3(gradient.top)},
          {"horizon", vector3(gradient.horizon)},
          {"ground", vector3(gradient.ground)}};
}

/// The picture of a custom probe: what it is, what it asks for and does not get, or why it cannot be read.
void addPicture(const Probe& probe, Json& report, Json& warnings) {
  if (probe.mode != ProbeMode::Custom || probe.image.empty()) return;
  report["image"] = probe.image;
  report["cubeView"] = choiceId(probeFields(), "cubeView", static_cast<int>(probe.cubeView));
  if (probe.imageRotationDegrees != 0.0) report["imageRotationDegrees"] = probe.imageRotationDegrees;
  const std::string place = "probes." + probe.name + ".image: ";
  try {
    const LoadedCube cube = loadCustomCube(probe);
    report["imageLayout"] = choiceId(probeFields(), "imageLayout", static_cast<int>(cube.layout));
    for (const std::string& sentence : cube.repairs.sentences()) warnings.push_back(place + sentence);
  } catch (const InputError& error) {
    warnings.push_back(place + error.what());
  }
}

Json cameraReport(const Camera& camera) {
  Json report = {{"name", camera.name},
                 {"position", vector3(camera.position)},
                 {"target", vector3(camera.target)},
                 {"verticalFovDegrees", camera.verticalFovDegrees}};
  if (camera.parallelHeight > 0.0) report["parallelHeight"] = camera.parallelHeight;
  return report;
}

/// What was found of a bare model and what follows from it.
Json fitReport(const ModelFit& fit) {
  const ModelSurvey& survey = fit.survey;
  return {{"kind", modelKindId(fit.kind)},
          {"found", modelKindId(survey.kind)},
          {"reason", survey.reason.english()},
          {"light", fitLightId(fit.light)},
          {"decided", fit.decided.english()},
          {"largestMetres", survey.largest},
          {"points",
           {{"count", survey.points.size()},
            {"closedIn", survey.enclosed},
            {"walled", survey.walled},
            {"floored", survey.floored},
            {"solid", survey.solid}}},
          {"raysToSky", survey.sky},
          {"backsFromOutside", survey.backOutside}};
}

}  // namespace

Json sceneReport(const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  Json report;
  report["path"] = loaded.path;
  for (const char* key : {"models", "objects", "probes", "cameras", "lights"}) report[key] = Json::array();
  for (std::size_t i = 0; i < scene.models.size(); ++i) {
    report["models"].push_back(modelReport(scene.models[i], *loaded.models[i]));
  }
  report["objects"] = objectsReport(loaded);
  Json pictures = Json::array();
  report["sky"] = skyReport(scene.sky, scene.skyRotationDegrees, pictures);
  if (scene.skyRotationDegrees != 0.0) report["sky"]["rotationDegrees"] = scene.skyRotationDegrees;
  for (const Camera& camera : scene.cameras) report["cameras"].push_back(cameraReport(camera));
  for (const Light& light : scene.lights) report["lights"].push_back(lightReport(light));
  SceneLamps lamps;
  if (scene.lamps == LampForm::Shapes) lamps = sceneLamps(scene, loaded.models);
  for (const Probe& probe : scene.probes) {
    report["probes"].push_back(probeReport(scene, lamps, probe));
    addPicture(probe, report["probes"].back(), pictures);
  }
  report["lamps"] = lampsReport(lamps);
  report["lampRemarks"] = lamps.remarks;
  report["exposure"] = scene.exposure;
  if (loaded.fit) {
    report["fit"] = fitReport(*loaded.fit);
    report["fit"]["exposure"] = loaded.exposureAutomatic ? "automatic" : "fixed";
  }
  report["warnings"] = loaded.warnings;
  report["warnings"].insert(report["warnings"].end(), pictures.begin(), pictures.end());
  return report;
}

}  // namespace boxprobe
