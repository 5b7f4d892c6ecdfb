// Validates a scene after each parse and before each commit, so that no other code meets NaN, an inverted box or two
// probes of one name. This file checks relations between fields; field_check.cpp checks single fields.
#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "filters/core/base/file_limits.h"
#include "filters/core/base/number_text.h"
#include "filters/core/scene/scene_fields.h"
#include "filters/core/scene/technique_parameters.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

namespace {

template <typename Entries>
void checkCount(const Entries& entries, const std::string& key) {
  if (entries.size() <= limits::kEntries) return;
  throw FieldError({key}, "has " + std::to_string(entries.size()) + " entries; at most " +
                              std::to_string(limits::kEntries) + " are allowed");
}

std::string indexKey(std::size_t index) {
  return "[" + std::to_string(index) + "]";
}

/// Names are parts of key paths, command lines and one-line messages.
template <typename Named>
void checkNames(const std::vector<Named>& entries, const std::string& key) {
  std::unordered_map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string& name = entries[i].name;
    const auto refuse = [&](const std::string& reason) { throw FieldError({key, indexKey(i), "name"}, reason); };
    if (name.empty()) refuse("is empty; give it a name");
    if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; })) {
      refuse("has a control character in it; use printable ones");
    }
    const auto [earlier, inserted] = first.emplace(name, i);
    if (!inserted) {
      refuse("\"" + name + "\" is already the name of " + keyPathText({key, indexKey(earlier->second)}) +
             "; give each its own");
    }
  }
}

void checkSky(const Scene& scene) {
  checkFields(anySkyFields(), scene, {"sky"});
  if (const auto* gradient = std::get_if<SkyGradient>(&scene.sky)) checkFields(skyGradientFields(), *gradient, {"sky"});
  if (const auto* color = std::get_if<SkyColor>(&scene.sky)) checkFields(skyColorFields(), *color, {"sky"});
  if (const auto* image = std::get_if<SkyImage>(&scene.sky)) checkFields(skyImageFields(), *image, {"sky"});
}

void checkCamera(const Camera& camera) {
  checkFields(cameraFields(), camera, {"cameras", camera.name});
  if (camera.position == camera.target) {
    throw FieldError({"cameras", camera.name, "target"}, "is the camera's own position; move one of them");
  }
  const glm::dvec3 view = glm::normalize(camera.target - camera.position);
  // Sine of the angle between the two; below a microradian the picture's rotation is rounding noise.
  if (glm::length(glm::cross(view, glm::normalize(camera.up))) < 1e-6) {
    throw FieldError({"cameras", camera.name, "up"}, "is parallel to the view direction; turn one of them");
  }
}

void checkLight(const Light& light, std::size_t index) {
  const KeyPath path{"lights", indexKey(index)};
  for (const FieldRow<Light>& row : lightFields()) {
    if (hasField(light.type, row)) checkField(row, row.get(light), path);
  }
  // Both sizes, whatever the type: code that makes a light may set a size before the type.
  for (const char* size : {"angleDegrees", "radius"}) checkField(lightField(size), lightField(size).get(light), path);
  if (light.type == LightType::Spot && light.innerConeDegrees >= light.outerConeDegrees) {
    throw FieldError({"lights", indexKey(index), "innerConeDegrees"}, "is " + numberText(light.innerConeDegrees) +
                                                                          " and must be less than outerConeDegrees, " +
                                                                          numberText(light.outerConeDegrees));
  }
}

void checkTechnique(const Probe& probe) {
  if (!parseTechnique(probe.technique)) {
    throw FieldError({"probes", probe.name, "technique"}, "\"" + probe.technique +
                                                              "\" is not known; use PROJECTION, EVALUATION or " +
                                                              "PROJECTION+EVALUATION of: " + techniqueIdList());
  }
  for (const auto& [name, value] : probe.parameters) {
    const std::string problem = parameterProblem(name, value);
    if (!problem.empty()) throw FieldError({"probes", probe.name, "parameters", name}, problem);
  }
}

void checkProbe(const Probe& probe) {
  checkFields(probeFields(), probe, {"probes", probe.name});
  if (probe.farDistance <= probe.nearDistance) {
    throw FieldError(
        {"probes", probe.name, "far"},
        "is " + numberText(probe.farDistance) + " and must be greater than near, " + numberText(probe.nearDistance));
  }
  if (probe.mode == ProbeMode::Custom && probe.image.empty()) {
    throw FieldError({"probes", probe.name, "image"}, "is missing; mode \"custom\" needs an image file");
  }
  checkTechnique(probe);
}

}  // namespace

void validate(const Scene& scene) {
  checkCount(scene.models, "models");
  checkCount(scene.cameras, "cameras");
  checkCount(scene.lights, "lights");
  checkCount(scene.materials, "materials");
  checkCount(scene.objects, "objects");
  checkCount(scene.mirrors, "mirrors");
  checkCount(scene.probes, "probes");
  for (std::size_t i = 0; i < scene.models.size(); ++i) {
    checkFields(modelFields(), scene.models[i], {"models", indexKey(i)});
  }
  checkSky(scene);
  checkNames(scene.cameras, "cameras");
  for (const Camera& camera : scene.cameras) checkCamera(camera);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) checkLight(scene.lights[i], i);
  for (const auto& [name, material] : scene.materials) {
    if (name.empty()) throw FieldError({"materials", name}, "has an empty name; use the model's material name");
    checkFields(materialFields(), material, {"materials", name});
  }
  for (const auto& [name, object] : scene.objects) {
    if (name.empty()) throw FieldError({"objects"}, "has an empty name; use the model's node name");
    checkFields(objectFields(), object, {"objects", name});
  }
  for (const auto& [name, mirror] : scene.mirrors) {
    if (name.empty()) throw FieldError({"mirrors"}, "has an empty name; use the model's node name");
    checkFields(mirrorFields(), mirror, {"mirrors", name});
  }
  checkNames(scene.probes, "probes");
  for (const Probe& probe : scene.probes) checkProbe(probe);
  checkFields(sceneFields(), scene, {});
}

}  // namespace boxprobe
