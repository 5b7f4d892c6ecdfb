// Lights (KHR_lights_punctual) and cameras of a glTF file as scene values. Both look along their node's -Z with +Y up,
// and ignore its scale.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/base/file_limits.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

/// The node's axis as a unit vector; the untransformed axis if the transform is degenerate.
glm::dvec3 turned(const glm::dmat4& worldFromNode, const glm::dvec3& axis) {
  const glm::dvec3 world = glm::dmat3(worldFromNode) * axis;
  const double length = glm::length(world);
  return length > 0.0 ? world / length : axis;
}

}  // namespace

Light readLight(GltfFile& file, int index, const glm::dmat4& worldFromNode, const std::string& where) {
  const auto& lights = file.gltf.lights;
  if (index < 0 || static_cast<std::size_t>(index) >= lights.size()) {
    file.fail(where,
              "light " + std::to_string(index) + " does not exist; the file has " + std::to_string(lights.size()));
  }
  const tinygltf::Light& source = lights[static_cast<std::size_t>(index)];
  const auto bounded = [&](double value) {
    if (!std::isfinite(value)) file.fail(where, "light " + std::to_string(index) + " has a number that is not finite");
    return std::clamp(value, 0.0, limits::kNumber);
  };
  Light light;
  light.position = glm::dvec3(worldFromNode[3]);
  light.direction = turned(worldFromNode, {0.0, 0.0, -1.0});
  for (int i = 0; i < 3 && source.color.size() == 3; ++i) {
    light.color[i] = static_cast<float>(bounded(source.color[static_cast<std::size_t>(i)]));
  }
  light.intensity = static_cast<float>(bounded(source.intensity));
  light.range = bounded(source.range);
  if (source.type == "directional") {
    light.type = LightType::Directional;
    light.position = glm::dvec3(0.0);
    light.range = 0.0;
  } else if (source.type == "spot") {
    light.type = LightType::Spot;
    // At most a right angle, and above the inner angle: a cone's edge needs a width.
    light.outerConeDegrees = std::clamp(glm::degrees(source.spot.outerConeAngle), 1.0e-3, 90.0);
    light.innerConeDegrees = std::clamp(glm::degrees(source.spot.innerConeAngle), 0.0, 0.9999 * light.outerConeDegrees);
  } else {
    if (source.type != "point") file.warn("has lights of unknown type, which shine as points");
    light.type = LightType::Point;
    light.direction = Light().direction;
  }
  return light;
}

Camera readCamera(GltfFile& file, int index, const glm::dmat4& worldFromNode, const std::string& where) {
  const auto& cameras = file.gltf.cameras;
  if (static_cast<std::size_t>(index) >= cameras.size()) {
    file.fail(where,
              "camera " + std::to_string(index) + " does not exist; the file has " + std::to_string(cameras.size()));
  }
  const tinygltf::Camera& source = cameras[static_cast<std::size_t>(index)];
  Camera camera;
  camera.name = source.name.empty() ? "camera" + std::to_string(index) : source.name;
  camera.position = glm::dvec3(worldFromNode[3]);
  camera.target = camera.position + turned(worldFromNode, {0.0, 0.0, -1.0});
  camera.up = turned(worldFromNode, {0.0, 1.0, 0.0});
  if (source.type == "orthographic") {
    if (!(source.orthographic.ymag > 0.0 && source.orthographic.ymag <= limits::kNumber)) {
      file.fail(where, "camera " + std::to_string(index) + ": ymag must be greater than 0; repair the model");
    }
    camera.parallelHeight = 2.0 * source.orthographic.ymag;
    return camera;
  }
  const double degrees = glm::degrees(source.perspective.yfov);
  if (!(degrees > 0.0 && degrees < 180.0)) {
    file.fail(where, "camera " + std::to_string(index) + ": yfov must be between 0 and pi; repair the model");
  }
  camera.verticalFovDegrees = degrees;
  return camera;
}

}  // namespace boxprobe
