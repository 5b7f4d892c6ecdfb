// Scene to JSON. The defaults are not repeated here: they are what a default-made struct holds.
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "filters/core/base/number_text.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

/// Relative to the scene's folder, so that both can be moved together; absolute where they share nothing but the root.
std::string writtenPath(const std::string& file, const std::string& folder) {
  if (folder.empty() || file.empty()) return file;
  fs::path path(file), base(folder);
  std::error_code error;
  if (path.is_absolute() != base.is_absolute()) {
    path = fs::absolute(path, error);
    base = fs::absolute(base, error);
  }
  path = path.lexically_normal();
  base = base.lexically_normal();
  if (path.is_absolute()) {
    const auto first = [](const fs::path& p) {
      return p.relative_path().empty() ? fs::path() : *p.relative_path().begin();
    };
    if (first(path) != first(base)) return path.string();
  }
  const fs::path relative = path.lexically_relative(base);
  return relative.empty() ? path.string() : relative.generic_string();
}

/// The double whose shortest text is the float's shortest text: 0.3f is written 0.3, not 0.30000001192092896.
double widened(float value) {
  const std::string text = numberText(value);
  double shortest = value;
  std::from_chars(text.data(), text.data() + text.size(), shortest);
  return static_cast<float>(shortest) == value ? shortest : static_cast<double>(value);
}
double widened(double value) {
  return value;
}

Json toJson(double value) {
  // Whole values without ".0", as people write them; -0 and what 64-bit integers could not hold stay as they are.
  constexpr double kLargestWhole = 1e15;
  if (std::fabs(value) < kLargestWhole && !(value == 0.0 && std::signbit(value))) {
    const auto whole = static_cast<long long>(value);
    if (static_cast<double>(whole) == value) return whole;
  }
  return value;
}
Json toJson(float value) {
  return toJson(widened(value));
}

template <typename Vector>
Json vector(const Vector& v) {
  return Json::array({toJson(widened(v.x)), toJson(widened(v.y)), toJson(widened(v.z))});
}

Json toJson(int value) {
  return value;
}
Json toJson(bool value) {
  return value;
}
Json toJson(const std::string& value) {
  return value;
}
Json toJson(const glm::dvec3& value) {
  return vector(value);
}
Json toJson(const glm::vec3& value) {
  return vector(value);
}
Json toJson(const Box& box) {
  return {{"min", vector(box.min)}, {"max", vector(box.max)}};
}
Json toJson(const std::vector<std::string>& list) {
  Json json = Json::array();
  for (const std::string& text : list) json.push_back(text);
  return json;
}
Json toJson(const std::map<std::string, ParameterValue>& parameters) {
  Json json = Json::object();
  for (const auto& [name, value] : parameters) {
    std::visit([&json, &key = name](const auto& v) { json[key] = toJson(v); }, value);
  }
  return json;
}

/// Writes members of one object, leaving out what equals the default.
class ObjectWriter {
 public:
  explicit ObjectWriter(JsonForm form) : form_(form) {}

  template <typename Value>
  void put(const char* key, const Value& value, const Value& defaultValue) {
    if (form_ == JsonForm::Complete || !(value == defaultValue)) json_[key] = toJson(value);
  }
  template <typename Value>
  void put(const char* key, const std::optional<Value>& value) {
    if (value) json_[key] = toJson(*value);
  }
  void putJson(const char* key, Json value, bool isDefault) {
    if (form_ == JsonForm::Complete || !isDefault) json_[key] = std::move(value);
  }
  Json take() { return std::move(json_); }

 private:
  JsonForm form_;
  Json json_ = Json::object();
};

Json modelJson(const ModelFile& model, const std::string& folder, JsonForm form) {
  ObjectWriter out(form);
  const ModelFile standard;
  out.putJson("file", writtenPath(model.file, folder), false);
  out.put("translation", model.translation, standard.translation);
  out.put("rotationDegrees", model.rotationDegrees, standard.rotationDegrees);
  out.put("scale", model.scale, standard.scale);
  const char* const units[] = {"m", "cm", "mm", "in", "ft"};
  const char* const axes[] = {"x", "y", "z"};
  out.putJson("unit", units[static_cast<int>(model.unit)], model.unit == standard.unit);
  out.putJson("upAxis", axes[static_cast<int>(model.upAxis)], model.upAxis == standard.upAxis);
  return out.take();
}

Json skyJson(const Sky& sky, const std::string& folder) {
  if (const auto* image = std::get_if<SkyImage>(&sky)) return {{"image", writtenPath(image->file, folder)}};
  if (const auto* color = std::get_if<SkyColor>(&sky)) return {{"color", vector(color->color)}};
  const auto& gradient = std::get<SkyGradient>(sky);
  return {{"top", vector(gradient.top)}, {"horizon", vector(gradient.horizon)}, {"ground", vector(gradient.ground)}};
}

Json cameraJson(const Camera& camera, JsonForm form) {
  ObjectWriter out(form);
  const Camera standard;
  out.putJson("position", vector(camera.position), false);
  out.putJson("target", vector(camera.target), false);
  out.put("up", camera.up, standard.up);
  out.put("verticalFovDegrees", camera.verticalFovDegrees, standard.verticalFovDegrees);
  out.put("parallelHeight", camera.parallelHeight, standard.parallelHeight);
  return out.take();
}

Json lightJson(const Light& light, JsonForm form) {
  ObjectWriter out(form);
  const Light standard;
  const bool directional = light.type == LightType::Directional;
  const char* const types[] = {"directional", "point", "spot"};
  out.putJson("type", types[static_cast<int>(light.type)], false);
  if (light.type != LightType::Point) out.putJson("direction", vector(light.direction), false);
  if (!directional) out.putJson("position", vector(light.position), false);
  out.put("color", light.color, standard.color);
  out.put("intensity", light.intensity, standard.intensity);
  if (light.type == LightType::Spot) {
    out.put("innerConeDegrees", light.innerConeDegrees, standard.innerConeDegrees);
    out.put("outerConeDegrees", light.outerConeDegrees, standard.outerConeDegrees);
  }
  if (!directional) out.put("range", light.range, standard.range);
  const char* const shadows[] = {"none", "coverage", "coverage+map"};
  const char* const levels[] = {"size", "distance"};
  out.putJson("shadows", shadows[static_cast<int>(light.shadows)], light.shadows == standard.shadows);
  if (directional) {
    out.put("angleDegrees", light.angleDegrees, standard.angleDegrees);
  } else {
    out.put("radius", light.radius, standard.radius);
  }
  out.putJson("shadowLevel", levels[static_cast<int>(light.shadowLevel)], light.shadowLevel == standard.shadowLevel);
  out.put("levelsPerUnit", light.levelsPerUnit, standard.levelsPerUnit);
  return out.take();
}

Json materialJson(const MaterialOverride& material) {
  ObjectWriter out(JsonForm::Minimal);
  out.put("baseColor", material.baseColor);
  out.put("metallic", material.metallic);
  out.put("roughness", material.roughness);
  out.put("emissive", material.emissive);
  out.put("normalScale", material.normalScale);
  out.put("coat", material.coat);
  out.put("ior", material.ior);
  out.put("transmission", material.transmission);
  out.put("thickness", material.thickness);
  out.put("attenuationDistance", material.attenuationDistance);
  out.put("attenuationColor", material.attenuationColor);
  out.put("thin", material.thin);
  const char* const forms[] = {"auto", "one-pass", "two-pass", "two-interface"};
  if (material.glass) out.putJson("glass", forms[static_cast<int>(*material.glass)], false);
  return out.take();
}

Json objectJson(const ObjectOverride& object, JsonForm form) {
  ObjectWriter out(form);
  const ObjectOverride standard;
  const char* const modes[] = {"off", "simple", "blend", "blend+sky"};
  out.put("visible", object.visible, standard.visible);
  out.put("seenByProbes", object.seenByProbes, standard.seenByProbes);
  out.put("dynamic", object.dynamic, standard.dynamic);
  out.putJson("probeMode", modes[static_cast<int>(object.probeUsage)], object.probeUsage == standard.probeUsage);
  out.putJson("weights", object.weights == WeightMode::Pixel ? "pixel" : "object", object.weights == standard.weights);
  out.put("translation", object.translation, standard.translation);
  out.put("rotationDegrees", object.rotationDegrees, standard.rotationDegrees);
  return out.take();
}

Json mirrorJson(const PlanarMirror& mirror, JsonForm form) {
  ObjectWriter out(form);
  const PlanarMirror standard;
  out.put("enabled", mirror.enabled, standard.enabled);
  out.put("maxRoughness", mirror.maxRoughness, standard.maxRoughness);
  out.put("resolution", mirror.resolution, standard.resolution);
  return out.take();
}

Json blendJson(const BlendDistance& blend, JsonForm form) {
  const bool one = blend.min == blend.max && blend.min.x == blend.min.y && blend.min.x == blend.min.z;
  if (one && form == JsonForm::Minimal) return toJson(blend.min.x);
  return {{"min", vector(blend.min)}, {"max", vector(blend.max)}};
}

Json clearJson(const Clear& clear) {
  if (std::holds_alternative<ClearToSky>(clear)) return "sky";
  if (std::holds_alternative<ClearToNone>(clear)) return "none";
  if (std::holds_alternative<ClearToOpen>(clear)) return "open";
  return vector(std::get<glm::vec3>(clear));
}

Json bevelJson(const Bevel& bevel, JsonForm form) {
  if (bevel.fromRoughness == 0.0 && form == JsonForm::Minimal) return toJson(bevel.radius);
  ObjectWriter out(form);
  out.put("radius", bevel.radius, 0.0);
  out.put("fromRoughness", bevel.fromRoughness, 0.0);
  return out.take();
}

Json occlusionJson(const BoxOcclusion& occlusion, JsonForm form) {
  ObjectWriter out(form);
  const BoxOcclusion standard;
  out.put("multiplier", occlusion.multiplier, standard.multiplier);
  out.put("power", occlusion.power, standard.power);
  out.put("strength", occlusion.strength, standard.strength);
  return out.take();
}

Json probeJson(const Probe& probe, const std::string& folder, JsonForm form) {
  ObjectWriter out(form);
  const Probe standard;
  const char* const modes[] = {"baked", "realtime", "custom"};
  out.putJson("name", probe.name, false);
  out.putJson("origin", vector(probe.origin), false);
  out.putJson("box", toJson(probe.box), false);
  out.put("rotationDegrees", probe.rotationDegrees, standard.rotationDegrees);
  out.put("influence", probe.influence);
  out.put("near", probe.nearDistance, standard.nearDistance);
  out.put("far", probe.farDistance, standard.farDistance);
  out.putJson("clear", clearJson(probe.clear), probe.clear == standard.clear);
  out.putJson("blendDistance", blendJson(probe.blendDistance, form), probe.blendDistance == standard.blendDistance);
  out.put("importance", probe.importance, standard.importance);
  out.put("intensity", probe.intensity, standard.intensity);
  out.put("projection", probe.projection, standard.projection);
  out.put("technique", probe.technique, standard.technique);
  out.put("parameters", probe.parameters, standard.parameters);
  out.put("faceSize", probe.faceSize, standard.faceSize);
  out.put("bounces", probe.bounces, standard.bounces);
  out.putJson("mode", modes[static_cast<int>(probe.mode)], probe.mode == standard.mode);
  if (!probe.image.empty()) out.putJson("image", writtenPath(probe.image, folder), false);
  const char* const layouts[] = {"auto", "latlong", "strip", "cross", "six"};
  out.putJson("imageLayout", layouts[static_cast<int>(probe.imageLayout)], probe.imageLayout == standard.imageLayout);
  const char* const encodings[] = {"linear", "rgbm", "dldr", "rgbmLinear"};
  out.putJson("encoding", encodings[static_cast<int>(probe.encoding)], probe.encoding == standard.encoding);
  if (probe.decode) out.putJson("decode", Json::array({toJson(probe.decode->x), toJson(probe.decode->y)}), false);
  out.putJson("filter", probe.filter == FilterKind::Ggx ? "ggx" : "gaussian", probe.filter == standard.filter);
  out.put("samplesPerPixel", probe.samplesPerPixel, standard.samplesPerPixel);
  out.put("filterSamples", probe.filterSamples, standard.filterSamples);
  out.put("hides", probe.hides, standard.hides);
  if (probe.bevel) out.putJson("bevel", bevelJson(*probe.bevel, form), false);
  if (probe.occlusion) out.putJson("occlusion", occlusionJson(*probe.occlusion, form), false);
  return out.take();
}

template <typename List, typename Write>
Json listJson(const List& list, Write write) {
  Json json = Json::array();
  for (const auto& entry : list) json.push_back(write(entry));
  return json;
}

template <typename Map, typename Write>
Json mapJson(const Map& map, Write write) {
  Json json = Json::object();
  for (const auto& [name, entry] : map) json[name] = write(entry);
  return json;
}

}  // namespace

Json sceneToJson(const Scene& scene, const std::string& folder, JsonForm form) {
  ObjectWriter out(form);
  out.putJson("format", "boxprobe-scene", false);
  out.putJson("version", 1, false);
  const bool plainModel = scene.models.size() == 1 && scene.models[0] == ModelFile{scene.models[0].file};
  if (plainModel && form == JsonForm::Minimal) {
    out.putJson("model", writtenPath(scene.models[0].file, folder), false);
  } else {
    out.putJson("models", listJson(scene.models, [&](const auto& m) { return modelJson(m, folder, form); }),
                scene.models.empty());
  }
  Json sky = skyJson(scene.sky, folder);
  const bool turned = scene.skyRotationDegrees != 0.0;
  if (turned || form == JsonForm::Complete) sky["rotationDegrees"] = toJson(scene.skyRotationDegrees);
  out.putJson("sky", std::move(sky), scene.sky == Sky() && !turned);
  Json cameras = Json::object();
  for (const Camera& camera : scene.cameras) cameras[camera.name] = cameraJson(camera, form);
  out.putJson("cameras", std::move(cameras), scene.cameras.empty());
  out.putJson("lights", listJson(scene.lights, [&](const auto& l) { return lightJson(l, form); }),
              scene.lights.empty());
  out.putJson("materials", mapJson(scene.materials, materialJson), scene.materials.empty());
  out.putJson("objects", mapJson(scene.objects, [&](const auto& o) { return objectJson(o, form); }),
              scene.objects.empty());
  out.putJson("mirrors", mapJson(scene.mirrors, [&](const auto& m) { return mirrorJson(m, form); }),
              scene.mirrors.empty());
  out.put("mirrorBudget", scene.mirrorBudget, Scene().mirrorBudget);
  out.putJson("probes", listJson(scene.probes, [&](const auto& p) { return probeJson(p, folder, form); }),
              scene.probes.empty());
  out.put("exposure", scene.exposure, Scene().exposure);
  return out.take();
}

}  // namespace boxprobe
