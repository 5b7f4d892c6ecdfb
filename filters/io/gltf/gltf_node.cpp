// The node tree of a glTF file flattened into placed meshes, in double: a building far from its file's origin keeps its
// millimetres.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <map>

#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

std::string nodePlace(const GltfFile& file, std::size_t index) {
  const std::string& name = file.gltf.nodes[index].name;
  return "node " + std::to_string(index) + (name.empty() ? "" : " \"" + name + "\"");
}

glm::dmat4 localTransform(const GltfFile& file, std::size_t index) {
  const tinygltf::Node& node = file.gltf.nodes[index];
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
  glm::dmat4 matrix(1.0);
  if (check(node.matrix, 16, "matrix")) {
    auto number = node.matrix.begin();  // column by column
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) matrix[column][row] = *number++;
    }
    return matrix;
  }
  if (check(node.translation, 3, "translation")) {
    matrix = glm::translate(matrix, {node.translation[0], node.translation[1], node.translation[2]});
  }
  if (check(node.rotation, 4, "rotation")) {
    const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);  // w first
    const double length = glm::length(rotation);
    if (length == 0.0) file.fail(nodePlace(file, index), "rotation is a quaternion of length 0; repair the model");
    matrix *= glm::mat4_cast(rotation / length);
  }
  if (check(node.scale, 3, "scale")) matrix = glm::scale(matrix, {node.scale[0], node.scale[1], node.scale[2]});
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

/// A mirroring transform turns triangles inside out; a copy with the other winding keeps their fronts in front
/// (glTF 2.0, section 3.7.4). The bitangent is a cross product, so its sign turns, too.
Mesh mirrored(const Mesh& mesh) {
  Mesh copy = mesh;
  for (std::size_t i = 0; i + 2 < copy.indices.size(); i += 3) std::swap(copy.indices[i + 1], copy.indices[i + 2]);
  for (glm::vec4& tangent : copy.tangents) tangent.w = -tangent.w;
  return copy;
}

/// Walks the tree with its own stack: files may nest deeper than a thread's stack allows.
class TreeWalk {
 public:
  TreeWalk(GltfFile& file, GltfMeshes& meshes) : file_(file), meshes_(meshes), seen_(file.gltf.nodes.size(), false) {}

  GltfNodes walk() {
    push(rootNodes(file_), glm::dmat4(1.0), "scene");
    while (!stack_.empty()) {
      const auto [index, worldFromParent] = stack_.back();
      stack_.pop_back();
      const tinygltf::Node& node = file_.gltf.nodes[index];
      const glm::dmat4 worldFromNode = worldFromParent * localTransform(file_, index);
      checkReach(index, worldFromNode);
      if (node.mesh >= 0) place(index, worldFromNode);
      placeLightAndCamera(index, worldFromNode);
      if (node.skin >= 0) file_.warn("has skins, which are not supported; the bind pose is used");
      push(node.children, worldFromNode, nodePlace(file_, index));
    }
    GltfNodes nodes;
    nodes.instances = std::move(instances_);
    nodes.lights = std::move(lights_);
    nodes.cameras = std::move(cameras_);
    return nodes;
  }

 private:
  void push(const std::vector<int>& children, const glm::dmat4& worldFromParent, const std::string& parent) {
    for (auto child = children.rbegin(); child != children.rend(); ++child) {  // reversed: file order off the stack
      if (*child < 0 || static_cast<std::size_t>(*child) >= seen_.size()) {
        file_.fail(parent,
                   "node " + std::to_string(*child) + " does not exist; the file has " + std::to_string(seen_.size()));
      }
      const auto index = static_cast<std::size_t>(*child);
      if (seen_[index])
        file_.fail(nodePlace(file_, index), "stands in the tree twice, or is its own ancestor; repair the model");
      seen_[index] = true;
      stack_.emplace_back(index, worldFromParent);
    }
  }

  /// Parents multiply: every node may be sound and the product beyond any number.
  void checkReach(std::size_t index, const glm::dmat4& worldFromNode) const {
    for (int i = 0; i < 16; ++i) {
      // Also false for NaN, which infinity times 0 leaves.
      if (std::fabs(worldFromNode[i / 4][i % 4]) <= kLargestGltfNumber) continue;
      file_.fail(nodePlace(file_, index),
                 "its transform, with those of its parents, reaches beyond 1e18; repair the model");
    }
  }

  void place(std::size_t index, const glm::dmat4& worldFromNode) {
    const tinygltf::Node& node = file_.gltf.nodes[index];
    const auto mesh = static_cast<std::size_t>(node.mesh);
    if (mesh >= meshes_.primitives.size()) {
      file_.fail(nodePlace(file_, index), "mesh " + std::to_string(node.mesh) + " does not exist; the file has " +
                                              std::to_string(meshes_.primitives.size()));
    }
    const std::string& meshName = file_.gltf.meshes[mesh].name;
    const std::string name = !node.name.empty()  ? node.name
                             : !meshName.empty() ? meshName
                                                 : "node" + std::to_string(index);
    for (const int primitive : meshes_.primitives[mesh]) {
      const bool mirrors = glm::determinant(glm::dmat3(worldFromNode)) < 0.0;
      instances_.push_back({name, mirrors ? mirroredMesh(primitive) : primitive, worldFromNode});
    }
  }

  void placeLightAndCamera(std::size_t index, const glm::dmat4& worldFromNode) {
    const tinygltf::Node& node = file_.gltf.nodes[index];
    const std::string where = nodePlace(file_, index);
    const auto light = node.extensions.find("KHR_lights_punctual");
    if (light != node.extensions.end()) {
      const double number = extensionNumber(light->second, "light", -1.0);
      lights_.push_back(
          readLight(file_, number >= 0.0 && number <= 1.0e9 ? static_cast<int>(number) : -1, worldFromNode, where));
    }
    if (node.camera < 0) return;
    Camera camera = readCamera(file_, node.camera, worldFromNode, where);
    if (!node.name.empty()) camera.name = node.name;
    const std::string stem = camera.name;
    const auto taken = [&] {
      return std::any_of(cameras_.begin(), cameras_.end(), [&](const Camera& c) { return c.name == camera.name; });
    };
    for (int copy = 2; taken(); ++copy) camera.name = stem + " " + std::to_string(copy);
    cameras_.push_back(camera);
  }

  int mirroredMesh(int original) {
    const auto [entry, isNew] = mirrored_.emplace(original, static_cast<int>(meshes_.meshes.size()));
    if (isNew) meshes_.meshes.push_back(mirrored(meshes_.meshes[static_cast<std::size_t>(original)]));
    return entry->second;
  }

  GltfFile& file_;
  GltfMeshes& meshes_;
  std::vector<bool> seen_;
  std::vector<std::pair<std::size_t, glm::dmat4>> stack_;
  std::map<int, int> mirrored_;
  std::vector<Instance> instances_;
  std::vector<Light> lights_;
  std::vector<Camera> cameras_;
};

}  // namespace

GltfNodes readNodes(GltfFile& file, GltfMeshes& meshes) {
  return TreeWalk(file, meshes).walk();
}

}  // namespace boxprobe
