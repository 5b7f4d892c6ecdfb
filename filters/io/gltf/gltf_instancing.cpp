// EXT_mesh_gpu_instancing: a node that places its mesh many times.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "filters/core/base/file_limits.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

/// An attribute of the extension; empty without it.
std::vector<float> listOf(const GltfFile& file, const tinygltf::Value& attributes, const char* name, int components,
                          const std::string& place) {
  const int accessor = extensionWhole(attributes, name, -1);
  return accessor < 0 ? std::vector<float>() : readFloats(file, accessor, components, place + ": " + name);
}

}  // namespace

std::vector<glm::dmat4> instanceTransforms(const GltfFile& file, std::size_t node) {
  const auto& extensions = file.gltf.nodes[node].extensions;
  const auto found = extensions.find("EXT_mesh_gpu_instancing");
  if (found == extensions.end() || !found->second.IsObject() || !found->second.Has("attributes")) {
    return {glm::dmat4(1.0)};
  }
  const tinygltf::Value& attributes = found->second.Get("attributes");
  const std::string place = nodePlace(file, node) + ": EXT_mesh_gpu_instancing";
  const std::vector<float> moved = listOf(file, attributes, "TRANSLATION", 3, place);
  const std::vector<float> turned = listOf(file, attributes, "ROTATION", 4, place);
  const std::vector<float> scaled = listOf(file, attributes, "SCALE", 3, place);
  const std::size_t count = std::max({moved.size() / 3, turned.size() / 4, scaled.size() / 3});
  for (const std::size_t size : {moved.size() / 3, turned.size() / 4, scaled.size() / 3}) {
    if (size != 0 && size != count) file.fail(place, "its lists are of different lengths; repair the model");
  }
  std::vector<glm::dmat4> transforms(count, glm::dmat4(1.0));
  for (std::size_t i = 0; i < count; ++i) {
    glm::dmat4& matrix = transforms[i];
    if (!moved.empty()) matrix = glm::translate(matrix, {moved[3 * i], moved[3 * i + 1], moved[3 * i + 2]});
    if (!turned.empty()) {
      const glm::dquat rotation(turned[4 * i + 3], turned[4 * i], turned[4 * i + 1], turned[4 * i + 2]);  // w first
      const double length = glm::length(rotation);
      if (length > 0.0) matrix *= glm::mat4_cast(rotation / length);
    }
    if (!scaled.empty()) matrix = glm::scale(matrix, {scaled[3 * i], scaled[3 * i + 1], scaled[3 * i + 2]});
    for (int n = 0; n < 16; ++n) {
      if (std::fabs(matrix[n / 4][n % 4]) <= limits::kNumber) continue;
      file.fail(place, "entry " + std::to_string(i) + " reaches beyond 1e18; repair the model");
    }
  }
  return transforms;
}

}  // namespace boxprobe
