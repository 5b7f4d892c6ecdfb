// The scene file's grammar: one function an object, each naming the keys it knows. Ranges are validate()'s business.
#include <filesystem>

#include "filters/io/json/json_cursor.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

namespace {

std::string resolved(const std::string& file, const std::string& folder) {
  if (folder.empty() || file.empty()) return file;
  return (std::filesystem::path(folder) / file).lexically_normal().string();  // an absolute `file` replaces the folder
}

template <typename Target, typename Read>
void readInto(const JsonCursor& object, const char* key, Target& target, Read read) {
  if (const auto field = object.find(key)) target = ((*field).*read)();
}

ModelFile readModel(const JsonCursor& entry, const std::string& folder) {
  ModelFile model;
  if (entry.json().is_string()) {
    model.file = resolved(entry.text(), folder);
    return model;
  }
  entry.requireObject({"file", "translation", "rotationDegrees", "scale", "unit", "upAxis"});
  const auto file = entry.find("file");
  if (!file) entry.fail("has no file; add \"file\": \"NAME.glb\"");
  model.file = resolved(file->text(), folder);
  readInto(entry, "translation", model.translation, &JsonCursor::vector);
  readInto(entry, "rotationDegrees", model.rotationDegrees, &JsonCursor::vector);
  readInto(entry, "scale", model.scale, &JsonCursor::number);
  if (const auto unit = entry.find("unit")) {
    model.unit = static_cast<LengthUnit>(unit->choice({"m", "cm", "mm", "in", "ft"}));
  }
  if (const auto up = entry.find("upAxis")) model.upAxis = static_cast<UpAxis>(up->choice({"x", "y", "z"}));
  return model;
}

Sky readSky(const JsonCursor& sky, const std::string& folder) {
  sky.requireObject({"image", "color", "top", "horizon", "ground", "rotationDegrees"});
  const auto image = sky.find("image");
  const auto color = sky.find("color");
  const std::size_t others = sky.find("rotationDegrees") ? 1 : 0;
  if ((image || color) && sky.json().size() > 1 + others) {
    sky.fail("mixes kinds; give an image, or a color, or top, horizon and ground");
  }
  if (image) return SkyImage{resolved(image->text(), folder)};
  if (color) return SkyColor{color->color()};
  SkyGradient gradient;
  readInto(sky, "top", gradient.top, &JsonCursor::color);
  readInto(sky, "horizon", gradient.horizon, &JsonCursor::color);
  readInto(sky, "ground", gradient.ground, &JsonCursor::color);
  return gradient;
}

Camera readCamera(const JsonCursor& entry) {
  entry.requireObject({"position", "target", "up", "verticalFovDegrees", "parallelHeight"});
  Camera camera;
  camera.name = entry.key();
  readInto(entry, "position", camera.position, &JsonCursor::vector);
  readInto(entry, "target", camera.target, &JsonCursor::vector);
  readInto(entry, "up", camera.up, &JsonCursor::vector);
  readInto(entry, "verticalFovDegrees", camera.verticalFovDegrees, &JsonCursor::number);
  readInto(entry, "parallelHeight", camera.parallelHeight, &JsonCursor::number);
  return camera;
}

Light readLight(const JsonCursor& entry) {
  entry.requireObject({"type", "direction", "position", "color", "intensity", "innerConeDegrees", "outerConeDegrees",
                       "range", "shadows", "angleDegrees", "radius", "shadowLevel", "levelsPerUnit"});
  Light light;
  const auto type = entry.find("type");
  if (!type) entry.fail("has no type; add \"type\": \"directional\", \"point\" or \"spot\"");
  light.type = static_cast<LightType>(type->choice({"directional", "point", "spot"}));
  const bool directional = light.type == LightType::Directional;
  if (const auto wrong = entry.find(directional ? "position" : "direction"); wrong && light.type != LightType::Spot) {
    wrong->fail(directional ? "does not belong to a directional light; use \"direction\""
                            : "does not belong to a point light; use \"position\"");
  }
  for (const char* key : {"innerConeDegrees", "outerConeDegrees", "range"}) {
    const bool ofType = light.type == LightType::Spot || (key == std::string("range") && !directional);
    if (const auto wrong = entry.find(key); wrong && !ofType) {
      wrong->fail(directional ? "does not belong to a directional light" : "belongs to a spot light");
    }
  }
  if (const auto wrong = entry.find(directional ? "radius" : "angleDegrees")) {
    wrong->fail(directional ? "does not belong to a directional light; use \"angleDegrees\""
                            : "belongs to a directional light; use \"radius\"");
  }
  if (const auto shadows = entry.find("shadows")) {
    light.shadows = static_cast<LightShadows>(shadows->choice({"none", "coverage", "coverage+map"}));
  }
  readInto(entry, "angleDegrees", light.angleDegrees, &JsonCursor::number);
  readInto(entry, "radius", light.radius, &JsonCursor::number);
  if (const auto level = entry.find("shadowLevel")) {
    light.shadowLevel = static_cast<ShadowLevel>(level->choice({"size", "distance"}));
  }
  readInto(entry, "levelsPerUnit", light.levelsPerUnit, &JsonCursor::number);
  readInto(entry, "innerConeDegrees", light.innerConeDegrees, &JsonCursor::number);
  readInto(entry, "outerConeDegrees", light.outerConeDegrees, &JsonCursor::number);
  readInto(entry, "range", light.range, &JsonCursor::number);
  readInto(entry, "direction", light.direction, &JsonCursor::vector);
  readInto(entry, "position", light.position, &JsonCursor::vector);
  readInto(entry, "color", light.color, &JsonCursor::color);
  readInto(entry, "intensity", light.intensity, &JsonCursor::numberFloat);
  return light;
}

MaterialOverride readMaterial(const JsonCursor& entry) {
  entry.requireObject({"baseColor", "metallic", "roughness", "emissive", "normalScale", "coat", "ior", "transmission",
                       "thickness", "attenuationDistance", "attenuationColor", "thin", "glass"});
  MaterialOverride material;
  readInto(entry, "baseColor", material.baseColor, &JsonCursor::color);
  readInto(entry, "metallic", material.metallic, &JsonCursor::numberFloat);
  readInto(entry, "roughness", material.roughness, &JsonCursor::numberFloat);
  readInto(entry, "emissive", material.emissive, &JsonCursor::color);
  readInto(entry, "normalScale", material.normalScale, &JsonCursor::numberFloat);
  readInto(entry, "coat", material.coat, &JsonCursor::numberFloat);
  readInto(entry, "ior", material.ior, &JsonCursor::numberFloat);
  readInto(entry, "transmission", material.transmission, &JsonCursor::numberFloat);
  readInto(entry, "thickness", material.thickness, &JsonCursor::numberFloat);
  readInto(entry, "attenuationDistance", material.attenuationDistance, &JsonCursor::numberFloat);
  readInto(entry, "attenuationColor", material.attenuationColor, &JsonCursor::color);
  readInto(entry, "thin", material.thin, &JsonCursor::boolean);
  if (const auto form = entry.find("glass")) {
    material.glass = static_cast<GlassForm>(form->choice({"auto", "one-pass", "two-pass", "two-interface"}));
  }
  return material;
}

ObjectOverride readObject(const JsonCursor& entry) {
  entry.requireObject({"visible", "seenByProbes", "dynamic", "probeMode", "weights", "translation", "rotationDegrees"});
  ObjectOverride object;
  readInto(entry, "visible", object.visible, &JsonCursor::boolean);
  readInto(entry, "seenByProbes", object.seenByProbes, &JsonCursor::boolean);
  readInto(entry, "dynamic", object.dynamic, &JsonCursor::boolean);
  if (const auto mode = entry.find("probeMode")) {
    object.probeUsage = static_cast<ProbeUsage>(mode->choice({"off", "simple", "blend", "blend+sky"}));
  }
  if (const auto weights = entry.find("weights")) {
    object.weights = static_cast<WeightMode>(weights->choice({"pixel", "object"}));
  }
  readInto(entry, "translation", object.translation, &JsonCursor::vector);
  readInto(entry, "rotationDegrees", object.rotationDegrees, &JsonCursor::vector);
  return object;
}

PlanarMirror readMirror(const JsonCursor& entry) {
  entry.requireObject({"enabled", "maxRoughness", "resolution"});
  PlanarMirror mirror;
  readInto(entry, "enabled", mirror.enabled, &JsonCursor::boolean);
  readInto(entry, "maxRoughness", mirror.maxRoughness, &JsonCursor::number);
  readInto(entry, "resolution", mirror.resolution, &JsonCursor::number);
  return mirror;
}

Box readBox(const JsonCursor& entry) {
  entry.requireObject({"min", "max"});
  Box box;
  for (const char* key : {"min", "max"}) {
    if (!entry.find(key)) entry.fail(std::string("has no ") + key + "; give both min and max");
  }
  readInto(entry, "min", box.min, &JsonCursor::vector);
  readInto(entry, "max", box.max, &JsonCursor::vector);
  return box;
}

BlendDistance readBlendDistance(const JsonCursor& entry) {
  BlendDistance blend;
  if (entry.json().is_number()) {
    blend.min = blend.max = glm::dvec3(entry.number());
    return blend;
  }
  if (!entry.json().is_object()) entry.fail("must be a number, or {\"min\": [..], \"max\": [..]}");
  entry.requireObject({"min", "max"});
  readInto(entry, "min", blend.min, &JsonCursor::vector);
  readInto(entry, "max", blend.max, &JsonCursor::vector);
  return blend;
}

Clear readClear(const JsonCursor& entry) {
  if (entry.json().is_array()) return entry.color();
  if (entry.json() == "sky") return ClearToSky{};
  if (entry.json() == "none") return ClearToNone{};
  if (entry.json() == "open") return ClearToOpen{};
  entry.fail("must be \"sky\", \"open\", \"none\" or a color [r, g, b]");
}

Bevel readBevel(const JsonCursor& entry) {
  Bevel bevel;
  if (entry.json().is_number()) {
    bevel.radius = entry.number();
    return bevel;
  }
  if (!entry.json().is_object()) entry.fail("must be a radius, or {\"fromRoughness\": FACTOR}");
  entry.requireObject({"radius", "fromRoughness"});
  readInto(entry, "radius", bevel.radius, &JsonCursor::number);
  readInto(entry, "fromRoughness", bevel.fromRoughness, &JsonCursor::number);
  return bevel;
}

BoxOcclusion readOcclusion(const JsonCursor& entry) {
  entry.requireObject({"multiplier", "power", "strength"});
  BoxOcclusion occlusion;
  readInto(entry, "multiplier", occlusion.multiplier, &JsonCursor::number);
  readInto(entry, "power", occlusion.power, &JsonCursor::number);
  readInto(entry, "strength", occlusion.strength, &JsonCursor::number);
  return occlusion;
}

ParameterValue readParameter(const JsonCursor& entry) {
  if (entry.json().is_boolean()) return entry.boolean();
  if (entry.json().is_number()) return entry.number();
  if (entry.json().is_string()) return entry.text();
  entry.fail("must be a number, true or false, or text in quotes");
}

void readProbeCapture(const JsonCursor& entry, Probe& probe, const std::string& folder) {
  readInto(entry, "origin", probe.origin, &JsonCursor::vector);
  readInto(entry, "near", probe.nearDistance, &JsonCursor::number);
  readInto(entry, "far", probe.farDistance, &JsonCursor::number);
  if (const auto clear = entry.find("clear")) probe.clear = readClear(*clear);
  readInto(entry, "faceSize", probe.faceSize, &JsonCursor::whole);
  readInto(entry, "bounces", probe.bounces, &JsonCursor::whole);
  if (const auto mode = entry.find("mode")) {
    probe.mode = static_cast<ProbeMode>(mode->choice({"baked", "realtime", "custom"}));
  }
  if (const auto image = entry.find("image")) probe.image = resolved(image->text(), folder);
  if (const auto layout = entry.find("imageLayout")) {
    probe.imageLayout = static_cast<CubeLayout>(layout->choice({"auto", "latlong", "strip", "cross", "six"}));
  }
  if (const auto encoding = entry.find("encoding")) {
    probe.encoding = static_cast<ImageEncoding>(encoding->choice({"linear", "rgbm", "dldr", "rgbmLinear"}));
  }
  if (const auto decode = entry.find("decode")) probe.decode = decode->pair();
  if (const auto filter = entry.find("filter")) {
    probe.filter = static_cast<FilterKind>(filter->choice({"ggx", "gaussian"}));
  }
  readInto(entry, "samplesPerPixel", probe.samplesPerPixel, &JsonCursor::whole);
  readInto(entry, "filterSamples", probe.filterSamples, &JsonCursor::whole);
  if (const auto hides = entry.find("hides")) {
    for (const JsonCursor& node : hides->elements()) probe.hides.push_back(node.text());
  }
}

Probe readProbe(const JsonCursor& element, const std::string& folder) {
  element.requireObject();
  const auto name = element.find("name");
  if (!name) element.fail("has no name; add \"name\": \"...\"");
  Probe probe;
  probe.name = name->text();
  // From here on by name, as people think of it; an empty one is left to validate(), which counts.
  const JsonCursor entry = probe.name.empty() ? element : element.at({"probes", probe.name});
  entry.requireObject(
      {"name",     "origin",          "box",           "rotationDegrees", "influence",   "near",      "far",
       "clear",    "blendDistance",   "importance",    "intensity",       "projection",  "technique", "parameters",
       "faceSize", "bounces",         "mode",          "image",           "imageLayout", "encoding",  "decode",
       "filter",   "samplesPerPixel", "filterSamples", "hides",           "bevel",       "occlusion"});
  if (const auto box = entry.find("box")) probe.box = readBox(*box);
  readInto(entry, "rotationDegrees", probe.rotationDegrees, &JsonCursor::vector);
  if (const auto influence = entry.find("influence")) probe.influence = readBox(*influence);
  if (const auto blend = entry.find("blendDistance")) probe.blendDistance = readBlendDistance(*blend);
  readInto(entry, "importance", probe.importance, &JsonCursor::number);
  readInto(entry, "intensity", probe.intensity, &JsonCursor::number);
  readInto(entry, "projection", probe.projection, &JsonCursor::boolean);
  readInto(entry, "technique", probe.technique, &JsonCursor::text);
  if (const auto parameters = entry.find("parameters")) {
    for (const JsonCursor& parameter : parameters->members()) {
      probe.parameters[parameter.key()] = readParameter(parameter);
    }
  }
  if (const auto bevel = entry.find("bevel")) probe.bevel = readBevel(*bevel);
  if (const auto occlusion = entry.find("occlusion")) probe.occlusion = readOcclusion(*occlusion);
  readProbeCapture(entry, probe, folder);
  return probe;
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
  readHeader(root);  // first: a file of another kind should be called that, not be blamed for its keys
  root.requireObject({"format", "version", "model", "models", "sky", "cameras", "lights", "materials", "objects",
                      "mirrors", "mirrorBudget", "probes", "exposure"});
  Scene scene;
  const auto model = root.find("model");
  const auto models = root.find("models");
  if (model && models) models->fail("stands beside model; keep one of them");
  if (model) scene.models.push_back(readModel(*model, folder));
  if (models) {
    for (const JsonCursor& entry : models->elements()) scene.models.push_back(readModel(entry, folder));
  }
  if (const auto sky = root.find("sky")) {
    scene.sky = readSky(*sky, folder);
    readInto(*sky, "rotationDegrees", scene.skyRotationDegrees, &JsonCursor::number);
  }
  if (const auto cameras = root.find("cameras")) {
    for (const JsonCursor& entry : cameras->members()) scene.cameras.push_back(readCamera(entry));
  }
  if (const auto lights = root.find("lights")) {
    for (const JsonCursor& entry : lights->elements()) scene.lights.push_back(readLight(entry));
  }
  if (const auto materials = root.find("materials")) {
    for (const JsonCursor& entry : materials->members()) scene.materials[entry.key()] = readMaterial(entry);
  }
  if (const auto objects = root.find("objects")) {
    for (const JsonCursor& entry : objects->members()) scene.objects[entry.key()] = readObject(entry);
  }
  if (const auto mirrors = root.find("mirrors")) {
    for (const JsonCursor& entry : mirrors->members()) scene.mirrors[entry.key()] = readMirror(entry);
  }
  readInto(root, "mirrorBudget", scene.mirrorBudget, &JsonCursor::number);
  if (const auto probes = root.find("probes")) {
    for (const JsonCursor& entry : probes->elements()) scene.probes.push_back(readProbe(entry, folder));
  }
  readInto(root, "exposure", scene.exposure, &JsonCursor::number);
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
