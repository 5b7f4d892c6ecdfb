// Near and far planes and picture shapes of a file's cameras: ours see everything, in a picture of any shape, so what
// is different is said.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/base/number_text.h"
#include "filters/core/base/one_line.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

constexpr double kUsualShape = 16.0 / 9.0, kSameShape = 0.01;
constexpr double kWidestPicture = 4.0;  ///< width to height: the picture's shape is not the camera's here

/// Is any position, seen by the camera, nearer than its near plane or beyond its far plane? Of files that place very
/// many, the first `left` are tried.
bool cutsOff(const GltfNodes& nodes, const Camera& camera, const GltfClip& clip, std::size_t& left) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
  const double slope = std::tan(0.5 * glm::radians(camera.verticalFovDegrees));
  for (const Instance& instance : nodes.instances) {
    const std::vector<glm::vec3>& positions = nodes.meshes[static_cast<std::size_t>(instance.mesh)].positions;
    if (positions.size() > left) return false;
    left -= positions.size();
    for (const glm::vec3& position : positions) {
      const glm::dvec3 from =
          glm::dvec3(instance.worldFromModel * glm::dvec4(glm::dvec3(position), 1.0)) - camera.position;
      const double depth = glm::dot(from, forward);
      if (depth <= 0.0 || (depth >= clip.near && !(clip.far > 0.0 && depth > clip.far))) continue;
      const double high = camera.parallelHeight > 0.0 ? 0.5 * camera.parallelHeight : slope * depth;
      if (std::fabs(glm::dot(from, up)) <= high && std::fabs(glm::dot(from, right)) <= kWidestPicture * high)
        return true;
    }
  }
  return false;
}

}  // namespace

void warnOfClipping(GltfFile& file, const GltfNodes& nodes) {
  std::size_t left = 20'000'000;
  for (std::size_t i = 0; i < nodes.cameras.size(); ++i) {
    const Camera& camera = nodes.cameras[i];
    const GltfClip& clip = nodes.clips[i];
    if (!cutsOff(nodes, camera, clip, left)) continue;
    file.warn(
        oneLine("has cameras whose near or far plane cuts off a part of the model, which is drawn all the same (" +
                camera.name.substr(0, 200) + ": " + numberText(clip.near) + " to " +
                (clip.far > 0.0 ? numberText(clip.far) : std::string("infinity")) + ")"));
    return;
  }
}

void warnOfShape(GltfFile& file, const GltfNodes& nodes) {
  constexpr std::size_t kMostTold = 8;
  std::size_t told = 0;
  for (std::size_t i = 0; i < nodes.cameras.size(); ++i) {
    const double aspect = nodes.clips[i].aspect;
    if (!(aspect > 0.0 && std::isfinite(aspect)) || std::fabs(aspect / kUsualShape - 1.0) < kSameShape) continue;
    constexpr double kHeight = 720.0, kMostPixels = 16384.0;
    const double width = std::round(std::clamp(aspect * kHeight, 1.0, kMostPixels));
    file.warn(oneLine("has a camera whose picture is not 16:9 (" + nodes.cameras[i].name.substr(0, 200) +
                      "); render it with --size " + numberText(width) + "x" + numberText(kHeight)));
    if (++told == kMostTold) return;
  }
}

}  // namespace boxprobe
