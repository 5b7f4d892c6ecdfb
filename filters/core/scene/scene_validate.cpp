// Is a scene sound? Every range in one place: called after each parse and before each commit, so that the layers above
// never meet NaN, an inverted box or two probes of one name.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "filters/core/base/field_error.h"
#include "filters/core/base/number_text.h"
#include "filters/core/scene/scene.h"
#include "filters/core/scene/technique_parameters.h"
#include "filters/math/sampling/filter_lobe.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

namespace {

constexpr std::size_t kMostProbes = 10000;
/// Of lengths, in scene units, and of light. Shaders compute in single precision, which ends at 3.4e38: up to here the
/// square of a distance, the product of two lights and the extent of a box are finite.
constexpr double kLargest = 1e18;
constexpr const char* kAxes[3] = {"x", "y", "z"};

std::string indexKey(std::size_t index) {
  return "[" + std::to_string(index) + "]";
}

/// One object of the scene: its key path, and checks of the fields below it.
class Fields {
 public:
  explicit Fields(KeyPath path) : path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& key, const std::string& reason) const {
    KeyPath path = path_;
    if (!key.empty()) path.push_back(key);
    throw FieldError(std::move(path), reason);
  }

  template <typename Number>
  void finite(const std::string& key, Number value) const {
    if (!std::isfinite(value)) fail(key, "is not a finite number");
  }
  template <typename Vector>
  void finiteVector(const std::string& key, const Vector& value) const {
    for (int i = 0; i < 3; ++i) {
      if (!std::isfinite(value[i])) fail(key, std::string(kAxes[i]) + " is not a finite number");
    }
  }
  template <typename Number>
  void atLeast(const std::string& key, Number value, Number least) const {
    finite(key, value);
    if (value < least) fail(key, "is " + numberText(value) + " and must be " + numberText(least) + " or more");
    notHuge(key, value);
  }
  template <typename Number>
  void notHuge(const std::string& key, Number value) const {
    finite(key, value);
    if (std::fabs(static_cast<double>(value)) > kLargest) {
      fail(key, "is " + numberText(value) + "; numbers up to " + numberText(kLargest) + " are computed with");
    }
  }
  template <typename Number>
  void above(const std::string& key, Number value, Number bound) const {
    finite(key, value);
    if (value <= bound) fail(key, "is " + numberText(value) + " and must be greater than " + numberText(bound));
  }
  template <typename Number>
  void within(const std::string& key, Number value, Number least, Number most) const {
    finite(key, value);
    if (value < least || value > most) {
      fail(key, "is " + numberText(value) + " and must be from " + numberText(least) + " to " + numberText(most));
    }
  }
  /// A place or an offset.
  void lengths(const std::string& key, const glm::dvec3& value) const {
    finiteVector(key, value);
    for (int i = 0; i < 3; ++i) {
      if (std::fabs(value[i]) > kLargest) {
        fail(key, std::string(kAxes[i]) + " is " + numberText(value[i]) + "; numbers up to " + numberText(kLargest) +
                      " are computed with");
      }
    }
  }
  void notNegative(const std::string& key, const glm::vec3& color) const {
    finiteVector(key, color);
    for (int i = 0; i < 3; ++i) {
      if (color[i] < 0.0f) fail(key, "has a negative component, " + numberText(color[i]) + "; use 0 or more");
      if (color[i] > static_cast<float>(kLargest)) {
        fail(key, "has a component of " + numberText(color[i]) + "; use " + numberText(kLargest) + " or less");
      }
    }
  }
  void direction(const std::string& key, const glm::dvec3& value) const {
    finiteVector(key, value);
    if (value == glm::dvec3(0.0)) fail(key, "is [0, 0, 0] and points nowhere; give it a length");
  }
  void box(const std::string& key, const Box& box) const {
    Fields inside(path_);
    inside.path_.push_back(key);
    inside.lengths("min", box.min);
    inside.lengths("max", box.max);
    for (int i = 0; i < 3; ++i) {
      if (box.min[i] > box.max[i]) {
        fail(key, std::string("min.") + kAxes[i] + " " + numberText(box.min[i]) + " is greater than max." + kAxes[i] +
                      " " + numberText(box.max[i]) + "; swap them");
      }
    }
  }

 private:
  KeyPath path_;
};

/// Names are what key paths, the command line and one-line messages are made of.
template <typename Named>
void checkNames(const std::vector<Named>& entries, const std::string& key) {
  std::unordered_map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Fields entry({key, indexKey(i)});
    const std::string& name = entries[i].name;
    if (name.empty()) entry.fail("name", "is empty; give it a name");
    if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; })) {
      entry.fail("name", "has a control character in it; use printable ones");
    }
    const auto [earlier, inserted] = first.emplace(name, i);
    if (!inserted) {
      entry.fail("name", "\"" + name + "\" is already the name of " + keyPathText({key, indexKey(earlier->second)}) +
                             "; give each its own");
    }
  }
}

void checkModel(const ModelFile& model, std::size_t index) {
  const Fields fields({"models", indexKey(index)});
  if (model.file.empty()) fields.fail("file", "is empty; name a model file");
  fields.lengths("translation", model.translation);
  fields.finiteVector("rotationDegrees", model.rotationDegrees);
  fields.above("scale", model.scale, 0.0);
  fields.notHuge("scale", model.scale);
}

void checkSky(const Sky& sky, double rotationDegrees) {
  const Fields fields({"sky"});
  fields.finite("rotationDegrees", rotationDegrees);
  if (const auto* gradient = std::get_if<SkyGradient>(&sky)) {
    fields.notNegative("top", gradient->top);
    fields.notNegative("horizon", gradient->horizon);
    fields.notNegative("ground", gradient->ground);
  } else if (const auto* color = std::get_if<SkyColor>(&sky)) {
    fields.notNegative("color", color->color);
  } else if (std::get<SkyImage>(sky).file.empty()) {
    fields.fail("image", "is empty; name an EXR or HDR file");
  }
}

void checkCamera(const Camera& camera) {
  const Fields fields({"cameras", camera.name});
  fields.lengths("position", camera.position);
  fields.lengths("target", camera.target);
  fields.direction("up", camera.up);
  if (camera.position == camera.target) {
    fields.fail("target", "is the camera's own position; move one of them");
  }
  const glm::dvec3 view = glm::normalize(camera.target - camera.position);
  // Sine of the angle between the two; below a microradian the picture's rotation is rounding noise.
  if (glm::length(glm::cross(view, glm::normalize(camera.up))) < 1e-6) {
    fields.fail("up", "is parallel to the view direction; turn one of them");
  }
  fields.finite("verticalFovDegrees", camera.verticalFovDegrees);
  if (camera.verticalFovDegrees <= 0.0 || camera.verticalFovDegrees >= 180.0) {
    fields.fail("verticalFovDegrees",
                "is " + numberText(camera.verticalFovDegrees) + " and must be greater than 0 and less than 180");
  }
  fields.atLeast("parallelHeight", camera.parallelHeight, 0.0);
  fields.notHuge("parallelHeight", camera.parallelHeight);
}

void checkLight(const Light& light, std::size_t index) {
  const Fields fields({"lights", indexKey(index)});
  if (light.type != LightType::Point) fields.direction("direction", light.direction);
  if (light.type != LightType::Directional) {
    fields.lengths("position", light.position);
    fields.atLeast("range", light.range, 0.0);
    fields.notHuge("range", light.range);
  }
  if (light.type == LightType::Spot) {
    fields.within("innerConeDegrees", light.innerConeDegrees, 0.0, 90.0);
    fields.within("outerConeDegrees", light.outerConeDegrees, 0.0, 90.0);
    if (light.innerConeDegrees >= light.outerConeDegrees) {
      fields.fail("innerConeDegrees", "is " + numberText(light.innerConeDegrees) +
                                          " and must be less than outerConeDegrees, " +
                                          numberText(light.outerConeDegrees));
    }
  }
  // A disc of 180 degrees would be a plane.
  fields.within("angleDegrees", light.angleDegrees, 0.0, 90.0);
  fields.atLeast("radius", light.radius, 0.0);
  fields.atLeast("levelsPerUnit", light.levelsPerUnit, 0.0);
  fields.notNegative("color", light.color);
  fields.atLeast("intensity", light.intensity, 0.0f);
}

void checkMaterial(const std::string& name, const MaterialOverride& material) {
  const Fields fields({"materials", name});
  if (name.empty()) fields.fail("", "has an empty name; use the model's material name");
  if (material.baseColor) fields.notNegative("baseColor", *material.baseColor);
  if (material.metallic) fields.within("metallic", *material.metallic, 0.0f, 1.0f);
  if (material.roughness) fields.within("roughness", *material.roughness, 0.0f, 1.0f);
  if (material.emissive) fields.notNegative("emissive", *material.emissive);
  if (material.normalScale) fields.notHuge("normalScale", *material.normalScale);
  if (material.coat) fields.within("coat", *material.coat, 0.0f, 1.0f);
  // Below 1: a medium thinner than what is around it, an air bubble in water.
  if (material.ior) {
    fields.above("ior", *material.ior, 0.0f);
    fields.notHuge("ior", *material.ior);
  }
  if (material.transmission) fields.within("transmission", *material.transmission, 0.0f, 1.0f);
  if (material.thickness) fields.atLeast("thickness", *material.thickness, 0.0f);
  if (material.attenuationDistance) fields.atLeast("attenuationDistance", *material.attenuationDistance, 0.0f);
  if (material.attenuationColor) {
    for (int i = 0; i < 3; ++i) fields.within("attenuationColor", (*material.attenuationColor)[i], 0.0f, 1.0f);
  }
}

void checkTechnique(const Fields& fields, const Probe& probe) {
  if (!parseTechnique(probe.technique)) {
    fields.fail("technique", "\"" + probe.technique + "\" is not known; use PROJECTION, EVALUATION or " +
                                 "PROJECTION+EVALUATION of: " + techniqueIdList());
  }
  const Fields parameters({"probes", probe.name, "parameters"});
  for (const auto& [name, value] : probe.parameters) {
    const std::string problem = parameterProblem(name, value);
    if (!problem.empty()) parameters.fail(name, problem);
  }
  if (probe.bevel) {
    const Fields bevel({"probes", probe.name, "bevel"});
    bevel.atLeast("radius", probe.bevel->radius, 0.0);
    bevel.atLeast("fromRoughness", probe.bevel->fromRoughness, 0.0);
  }
  if (probe.occlusion) {
    const Fields occlusion({"probes", probe.name, "occlusion"});
    occlusion.atLeast("multiplier", probe.occlusion->multiplier, 0.0);
    occlusion.atLeast("power", probe.occlusion->power, 0.0);
    occlusion.within("strength", probe.occlusion->strength, 0.0, 1.0);
  }
}

void checkCapture(const Fields& fields, const Probe& probe) {
  fields.lengths("origin", probe.origin);
  fields.above("near", probe.nearDistance, 0.0);
  fields.notHuge("far", probe.farDistance);
  if (probe.farDistance <= probe.nearDistance) {
    fields.fail("far", "is " + numberText(probe.farDistance) + " and must be greater than near, " +
                           numberText(probe.nearDistance));
  }
  if (const auto* color = std::get_if<glm::vec3>(&probe.clear)) fields.notNegative("clear", *color);
  const int size = probe.faceSize;
  if (size < 16 || size > 2048 || (size & (size - 1)) != 0) {
    fields.fail("faceSize", "is " + std::to_string(size) + " and must be a power of two from 16 to 2048");
  }
  if (probe.bounces < 1 || probe.bounces > 5) {
    fields.fail("bounces", "is " + std::to_string(probe.bounces) + " and must be from 1 to 5");
  }
  if (probe.filterSamples < kMinSamples || probe.filterSamples > kMaxSamples) {
    fields.fail("filterSamples", "is " + std::to_string(probe.filterSamples) + " and must be from " +
                                     std::to_string(kMinSamples) + " to " + std::to_string(kMaxSamples));
  }
  if (probe.samplesPerPixel != 1 && probe.samplesPerPixel != 4 && probe.samplesPerPixel != 16) {
    fields.fail("samplesPerPixel", "is " + std::to_string(probe.samplesPerPixel) + " and must be 1, 4 or 16");
  }
  if (probe.decode) {
    const Fields decode({"probes", probe.name, "decode"});
    decode.above("[0]", probe.decode->x, 0.0);
    decode.notHuge("[0]", probe.decode->x);
    decode.atLeast("[1]", probe.decode->y, 0.0);
  }
  if (probe.mode == ProbeMode::Custom && probe.image.empty()) {
    fields.fail("image", "is missing; mode \"custom\" needs an image file");
  }
}

void checkProbe(const Probe& probe) {
  const Fields fields({"probes", probe.name});
  fields.box("box", probe.box);
  if (probe.influence) fields.box("influence", *probe.influence);
  fields.finiteVector("rotationDegrees", probe.rotationDegrees);
  const Fields blend({"probes", probe.name, "blendDistance"});
  for (int i = 0; i < 3; ++i) {
    blend.atLeast("min", probe.blendDistance.min[i], 0.0);
    blend.atLeast("max", probe.blendDistance.max[i], 0.0);
  }
  fields.notHuge("importance", probe.importance);
  fields.atLeast("intensity", probe.intensity, 0.0);
  checkCapture(fields, probe);
  checkTechnique(fields, probe);
}

}  // namespace

void validate(const Scene& scene) {
  for (std::size_t i = 0; i < scene.models.size(); ++i) checkModel(scene.models[i], i);
  checkSky(scene.sky, scene.skyRotationDegrees);
  checkNames(scene.cameras, "cameras");
  for (const Camera& camera : scene.cameras) checkCamera(camera);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) checkLight(scene.lights[i], i);
  for (const auto& [name, material] : scene.materials) checkMaterial(name, material);
  for (const auto& [name, object] : scene.objects) {
    if (name.empty()) throw FieldError({"objects"}, "has an empty name; use the model's node name");
    const Fields fields({"objects", name});
    fields.lengths("translation", object.translation);
    fields.finiteVector("rotationDegrees", object.rotationDegrees);
  }
  for (const auto& [name, mirror] : scene.mirrors) {
    if (name.empty()) throw FieldError({"mirrors"}, "has an empty name; use the model's node name");
    const Fields fields({"mirrors", name});
    fields.within("maxRoughness", mirror.maxRoughness, 0.0, 1.0);
    fields.within("resolution", mirror.resolution, 0.1, 4.0);
  }
  Fields({}).atLeast("mirrorBudget", scene.mirrorBudget, 0.0);
  if (scene.probes.size() > kMostProbes) {
    throw FieldError({"probes"}, "has " + std::to_string(scene.probes.size()) + " entries; at most " +
                                     std::to_string(kMostProbes) + " are allowed");
  }
  checkNames(scene.probes, "probes");
  for (const Probe& probe : scene.probes) checkProbe(probe);
  Fields({}).atLeast("exposure", scene.exposure, 0.0);
}

}  // namespace boxprobe
