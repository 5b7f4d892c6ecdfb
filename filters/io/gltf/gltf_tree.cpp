// The node tree of a glTF file: world transforms in double, so that a building far from its file's origin keeps its
// millimetres.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "filters/core/base/file_limits.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

glm::dmat4 localTransform(const GltfFile& file, std::size_t index, const GltfPose& pose) {
  const tinygltf::Node& node = file.gltf.nodes[index];
  const auto posed = pose.find(index);
  const GltfNodePose moved = posed == pose.end() ? GltfNodePose() : posed->second;
  const auto chosen = [](const std::vector<double>& own, const std::vector<double>& given) -> const auto& {
    return given.empty() ? own : given;
  };
  const auto check = [&](const std::vector<double>& values, std::size_t length, const char* key) {
    if (!values.empty() && values.size() != length) {
      file.fail(nodePlace(file, index), std::string(key) + " must have " + std::to_string(length) + " numbers");
    }
    for (const double value : values) {
      if (!std::isfinite(value))
        file.fail(nodePlace(file, index), std::string(key) + " is not finite; repair the model");
    }
    return !values.empty();
  };
  const std::vector<double>& translation = chosen(node.translation, moved.translation);
  const std::vector<double>& turn = chosen(node.rotation, moved.rotation);
  const std::vector<double>& scale = chosen(node.scale, moved.scale);
  glm::dmat4 matrix(1.0);
  if (check(node.matrix, 16, "matrix")) {
    auto number = node.matrix.begin();  // column by column
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) matrix[column][row] = *number++;
    }
    return matrix;
  }
  if (check(translation, 3, "translation")) {
    matrix = glm::translate(matrix, {translation[0], translation[1], translation[2]});
  }
  if (check(turn, 4, "rotation")) {
    const glm::dquat rotation(turn[3], turn[0], turn[1], turn[2]);  // w first
    const double length = glm::length(rotation);
    if (length == 0.0) file.fail(nodePlace(file, index), "rotation is a quaternion of length 0; repair the model");
    matrix *= glm::mat4_cast(rotation / length);
  }
  if (check(scale, 3, "scale")) matrix = glm::scale(matrix, {scale[0], scale[1], scale[2]});
  return matrix;
}

std::vector<int> rootNodes(const GltfFile& file) {
  const auto& scenes = file.gltf.scenes;
  if (!scenes.empty()) {
    const int scene = file.gltf.defaultScene < 0 ? 0 : file.gltf.defaultScene;
    if (static_cast<std::size_t>(scene) >= scenes.size()) {
      file.fail("scene",
                "scene " + std::to_string(scene) + " does not exist; the file has " + std::to_string(scenes.size()));
    }
    return scenes[static_cast<std::size_t>(scene)].nodes;
  }
  std::vector<bool> isChild(file.gltf.nodes.size(), false);
  for (const tinygltf::Node& node : file.gltf.nodes) {
    for (const int child : node.children) {
      if (child >= 0 && static_cast<std::size_t>(child) < isChild.size())
        isChild[static_cast<std::size_t>(child)] = true;
    }
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < isChild.size(); ++i) {
    if (!isChild[i]) roots.push_back(static_cast<int>(i));
  }
  return roots;
}

/// Every factor may be in range while the product of the parents overflows.
void checkReach(const GltfFile& file, const GltfPlacedNode& node) {
  for (int i = 0; i < 16; ++i) {
    // Also false for NaN, the result of infinity times 0.
    if (std::fabs(node.worldFromNode[i / 4][i % 4]) <= limits::kNumber) continue;
    file.fail(nodePlace(file, node.index),
              "its transform, with those of its parents, reaches beyond 1e18; repair the model");
  }
}

}  // namespace

std::string nodePlace(const GltfFile& file, std::size_t index) {
  const std::string& name = file.gltf.nodes[index].name;
  return "node " + std::to_string(index) + (name.empty() ? "" : " \"" + name + "\"");
}

// With an explicit stack: files may nest deeper than a thread's stack allows.
std::vector<GltfPlacedNode> placeNodes(const GltfFile& file, const GltfPose& pose) {
  std::vector<GltfPlacedNode> placed, stack;
  std::vector<bool> seen(file.gltf.nodes.size(), false);
  const auto push = [&](const std::vector<int>& children, const glm::dmat4& worldFromParent,
                        const std::string& parent) {
    for (auto child = children.rbegin(); child != children.rend(); ++child) {  // reversed: file order off the stack
      if (*child < 0 || static_cast<std::size_t>(*child) >= seen.size()) {
        file.fail(parent,
                  "node " + std::to_string(*child) + " does not exist; the file has " + std::to_string(seen.size()));
      }
      const auto index = static_cast<std::size_t>(*child);
      if (seen[index])
        file.fail(nodePlace(file, index), "stands in the tree twice, or is its own ancestor; repair the model");
      seen[index] = true;
      stack.push_back({index, worldFromParent});
    }
  };
  push(rootNodes(file), glm::dmat4(1.0), "scene");
  while (!stack.empty()) {
    GltfPlacedNode node = stack.back();
    stack.pop_back();
    node.worldFromNode *= localTransform(file, node.index, pose);
    checkReach(file, node);
    placed.push_back(node);
    push(file.gltf.nodes[node.index].children, node.worldFromNode, nodePlace(file, node.index));
  }
  return placed;
}

}  // namespace boxprobe
