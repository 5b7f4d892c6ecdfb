// Writes a scene as JSON: lists and maps of parts, each by its rows (field_writer.cpp). Defaults are those of a
// default-constructed struct.
#include "filters/io/scene/field_json.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

namespace {

Json skyJson(const Scene& scene, const Writing& how) {
  const auto written = [&how](const auto& rows, const auto& kind) { return writtenPart(rows, kind, how); };
  Json sky;
  if (const auto* image = std::get_if<SkyImage>(&scene.sky)) sky = written(skyImageFields(), *image);
  if (const auto* color = std::get_if<SkyColor>(&scene.sky)) sky = written(skyColorFields(), *color);
  if (const auto* gradient = std::get_if<SkyGradient>(&scene.sky)) sky = written(skyGradientFields(), *gradient);
  const Scene standard;
  for (const FieldRow<Scene>& row : anySkyFields()) writeField(sky, row, scene, standard, how);
  return sky;
}

Json lightJson(const Light& light, const Writing& how) {
  Json json = Json::object();
  const Light standard;
  for (const FieldRow<Light>& row : lightFields()) {
    if (hasField(light.type, row)) writeField(json, row, light, standard, how);
  }
  return json;
}

template <typename List, typename Write>
Json listJson(const List& list, Write write) {
  Json json = Json::array();
  for (const auto& entry : list) json.push_back(write(entry));
  return json;
}

template <typename Part>
Json mapJson(const std::map<std::string, Part>& map, const std::vector<FieldRow<Part>>& rows, const Writing& how) {
  Json json = Json::object();
  for (const auto& [name, entry] : map) json[name] = writtenPart(rows, entry, how);
  return json;
}

/// The value of a top-level key that is not a field; null: nothing to write in the minimal form.
Json partsJson(std::string_view key, const Scene& scene, const Writing& how) {
  const bool minimal = how.form == JsonForm::Minimal;
  const bool plainModel = minimal && scene.models.size() == 1 && scene.models[0] == ModelFile{scene.models[0].file};
  const auto unlessEmpty = [minimal](Json json) {
    if (minimal && json.empty()) json = nullptr;
    return json;
  };
  if (key == "format") return "boxprobe-scene";
  if (key == "version") return 1;
  if (key == "model") {
    if (!plainModel) return nullptr;
    return valueJson(scene.models[0].file, fieldNamed(modelFields(), "file"), how);
  }
  if (key == "models") {
    if (plainModel) return nullptr;
    return unlessEmpty(listJson(scene.models, [&](const auto& m) { return writtenPart(modelFields(), m, how); }));
  }
  if (key == "sky") {
    const Scene standard;
    const bool asItIs = scene.sky == standard.sky && sameFields(anySkyFields(), scene, standard);
    return minimal && asItIs ? Json() : skyJson(scene, how);
  }
  if (key == "cameras") {
    Json cameras = Json::object();
    for (const Camera& camera : scene.cameras) cameras[camera.name] = writtenPart(cameraFields(), camera, how);
    return unlessEmpty(std::move(cameras));
  }
  if (key == "lights") return unlessEmpty(listJson(scene.lights, [&](const auto& l) { return lightJson(l, how); }));
  if (key == "materials") return unlessEmpty(mapJson(scene.materials, materialFields(), how));
  if (key == "objects") return unlessEmpty(mapJson(scene.objects, objectFields(), how));
  if (key == "mirrors") return unlessEmpty(mapJson(scene.mirrors, mirrorFields(), how));
  if (key == "probes") {
    return unlessEmpty(listJson(scene.probes, [&](const auto& p) { return writtenPart(probeFields(), p, how); }));
  }
  return nullptr;
}

}  // namespace

Json sceneToJson(const Scene& scene, const std::string& folder, JsonForm form) {
  const Writing how{folder, form};
  const Scene standard;
  Json root = Json::object();
  for (const FieldRow<Scene>& row : sceneFields()) {
    if (row.get != nullptr) {
      writeField(root, row, scene, standard, how);
    } else if (Json parts = partsJson(row.key, scene, how); !parts.is_null()) {
      root[std::string(row.key)] = std::move(parts);
    }
  }
  return root;
}

}  // namespace boxprobe
