// The grammar of the scene file above its fields: lists, maps, and keys that exclude each other. field_reader.cpp reads
// fields by their rows; validate() checks ranges.
#include "filters/io/json/json_cursor.h"
#include "filters/io/scene/field_json.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

namespace {

ModelFile readModel(const JsonCursor& entry, const std::string& folder) {
  if (!entry.json().is_string()) return readPart(entry, modelFields(), folder);
  ModelFile model;
  model.file = std::get<std::string>(readValue(entry, fieldNamed(modelFields(), "file"), folder));
  return model;
}

/// A part of the sky is present if one of its keys is.
template <typename Part>
std::size_t keysThere(const JsonCursor& object, const std::vector<FieldRow<Part>>& rows) {
  std::size_t count = 0;
  for (const FieldRow<Part>& row : rows) count += object.find(row.key) ? 1 : 0;
  return count;
}

void readSky(const JsonCursor& sky, Scene& scene, const std::string& folder) {
  sky.requireObject(fieldKeys(skyImageFields(), skyColorFields(), skyGradientFields(), anySkyFields()));
  const std::size_t image = keysThere(sky, skyImageFields()), color = keysThere(sky, skyColorFields());
  const std::size_t gradient = keysThere(sky, skyGradientFields());
  if ((image > 0 ? 1 : 0) + (color > 0 ? 1 : 0) + (gradient > 0 ? 1 : 0) > 1) {
    sky.fail("mixes kinds; give an image, or a color, or top, horizon and ground");
  }
  if (image > 0) readFields(sky, skyImageFields(), scene.sky.emplace<SkyImage>(), folder);
  if (color > 0) readFields(sky, skyColorFields(), scene.sky.emplace<SkyColor>(), folder);
  if (gradient > 0) readFields(sky, skyGradientFields(), scene.sky.emplace<SkyGradient>(), folder);
  readFields(sky, anySkyFields(), scene, folder);
}

Camera readCamera(const JsonCursor& entry, const std::string& folder) {
  Camera camera = readPart(entry, cameraFields(), folder);
  camera.name = entry.key();
  return camera;
}

/// The message for a key that only lights of another type have.
std::string typeProblem(const FieldInfo& field, LightType type, const std::vector<FieldChoice>& types) {
  const std::string own(types[static_cast<std::size_t>(type)].id);
  std::string problem = "does not belong to a " + own + " light";
  for (std::size_t i = 0; i < types.size(); ++i) {
    const bool only = field.types == 1u << i;
    if (only && type != LightType::Directional) problem = "belongs to a " + std::string(types[i].id) + " light";
  }
  return problem + (field.otherTypes.empty() ? "" : "; use \"" + std::string(field.otherTypes) + "\"");
}

Light readLight(const JsonCursor& entry, const std::string& folder) {
  entry.requireObject(fieldKeys(lightFields()));
  requireFields(entry, lightFields());
  Light light;
  const FieldRow<Light>& type = lightField("type");
  type.set(light, readValue(*entry.find(type.key), type, folder));
  for (const FieldRow<Light>& row : lightFields()) {
    if (hasField(light.type, row)) continue;
    if (const auto wrong = entry.find(row.key)) wrong->fail(typeProblem(row, light.type, type.choices));
  }
  readFields(entry, lightFields(), light, folder);
  return light;
}

Probe readProbe(const JsonCursor& element, const std::string& folder) {
  element.requireObject();
  requireFields(element, probeFields());
  const std::string name = element.find("name")->text();
  // From here on by name, which is easier to read; empty names are left to validate(), which uses indices.
  return readPart(name.empty() ? element : element.at({"probes", name}), probeFields(), folder);
}

void readHeader(const JsonCursor& root) {
  const auto format = root.find("format");
  if (!format) root.fail("is not a scene file; it starts with { \"format\": \"boxprobe-scene\", \"version\": 1, ...");
  if (format->text() != "boxprobe-scene") format->fail("is \"" + format->text() + "\", not \"boxprobe-scene\"");
  const auto version = root.find("version");
  if (!version) root.fail("has no version; add \"version\": 1");
  if (version->whole() != 1) {
    version->fail("is " + std::to_string(version->whole()) + "; this program reads version 1, so get a newer program");
  }
}

}  // namespace

Scene sceneFromJson(const Json& json, const std::string& folder) {
  const JsonCursor root(json, {});
  root.requireObject();
  readHeader(root);  // first: a file of another kind should be reported as such, not by its unknown keys
  root.requireObject(fieldKeys(sceneFields()));
  Scene scene;
  const auto model = root.find("model");
  const auto models = root.find("models");
  if (model && models) models->fail("stands beside model; keep one of them");
  if (model) scene.models.push_back(readModel(*model, folder));
  if (models) {
    for (const JsonCursor& entry : models->elements()) scene.models.push_back(readModel(entry, folder));
  }
  if (const auto sky = root.find("sky")) readSky(*sky, scene, folder);
  if (const auto cameras = root.find("cameras")) {
    for (const JsonCursor& entry : cameras->members()) scene.cameras.push_back(readCamera(entry, folder));
  }
  if (const auto lights = root.find("lights")) {
    for (const JsonCursor& entry : lights->elements()) scene.lights.push_back(readLight(entry, folder));
  }
  const auto readMap = [&](const char* key, auto& map, const auto& rows) {
    const auto entries = root.find(key);
    if (!entries) return;
    for (const JsonCursor& entry : entries->members()) map[entry.key()] = readPart(entry, rows, folder);
  };
  readMap("materials", scene.materials, materialFields());
  readMap("objects", scene.objects, objectFields());
  readMap("mirrors", scene.mirrors, mirrorFields());
  if (const auto probes = root.find("probes")) {
    for (const JsonCursor& entry : probes->elements()) scene.probes.push_back(readProbe(entry, folder));
  }
  readFields(root, sceneFields(), scene, folder);
  return scene;
}

Json::json_pointer pointerForPath(const Json& root, const KeyPath& path) {
  Json::json_pointer pointer;
  const Json* value = &root;
  for (std::size_t i = 0; i < path.size() && value != nullptr; ++i) {
    const std::string& key = path[i];
    const Json* next = nullptr;
    if (i == 0 && key == "models" && !root.contains("models") && root.contains("model")) {
      pointer.push_back("model");
      value = &root["model"];
      ++i;  // skips the index
      continue;
    }
    if (value->is_object()) {
      if (const auto found = value->find(key); found != value->end()) next = &*found;
      if (next != nullptr) pointer.push_back(key);
    } else if (value->is_array()) {
      for (std::size_t index = 0; index < value->size() && next == nullptr; ++index) {
        const Json& element = (*value)[index];
        const bool named = i == 1 && element.is_object() && element.contains("name") && element["name"] == key;
        if (named || key == "[" + std::to_string(index) + "]") {
          next = &element;
          pointer /= index;
        }
      }
    }
    value = next;
  }
  return pointer;
}

}  // namespace boxprobe
