// Places what the nodes of a glTF file contain: meshes with their shapes and instances, lights, cameras.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <map>
#include <numeric>
#include <set>

#include "filters/core/base/file_limits.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

/// A mirroring transform turns triangles inside out; a copy with reversed winding keeps their fronts outside (glTF 2.0,
/// section 3.7.4). The bitangent is a cross product, so its sign flips, too.
Mesh mirrored(const Mesh& mesh) {
  Mesh copy = mesh;
  for (std::size_t i = 0; i + 2 < copy.indices.size(); i += 3) std::swap(copy.indices[i + 1], copy.indices[i + 2]);
  for (glm::vec4& tangent : copy.tangents) tangent.w = -tangent.w;
  return copy;
}

/// Without those that equal an earlier one: copies in one place show nothing more, and rays meet every one of them.
std::vector<glm::dmat4> distinct(const std::vector<glm::dmat4>& transforms) {
  std::vector<std::size_t> order(transforms.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  // By their bytes, which have an order whatever the numbers are.
  const auto bytes = [&transforms](std::size_t i) { return reinterpret_cast<const unsigned char*>(&transforms[i]); };
  const auto equal = [&bytes](std::size_t a, std::size_t b) {
    return std::equal(bytes(a), bytes(a) + sizeof(glm::dmat4), bytes(b));
  };
  std::sort(order.begin(), order.end(), [&bytes, &equal](std::size_t a, std::size_t b) {
    if (equal(a, b)) return a < b;
    return std::lexicographical_compare(bytes(a), bytes(a) + sizeof(glm::dmat4), bytes(b),
                                        bytes(b) + sizeof(glm::dmat4));
  });
  std::vector<bool> again(transforms.size(), false);
  for (std::size_t i = 1; i < order.size(); ++i) again[order[i]] = equal(order[i - 1], order[i]);
  std::vector<glm::dmat4> kept;
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    if (!again[i]) kept.push_back(transforms[i]);
  }
  return kept;
}

class NodeReader {
 public:
  NodeReader(const GltfMeshReading& reading, const GltfPose& pose)
      : file_(reading.file), reading_(reading), pose_(pose), placed_(placeNodes(file_, pose)) {
    for (const GltfPlacedNode& node : placed_) worldFromNode_[node.index] = &node.worldFromNode;
  }

  GltfNodes read(const std::function<void(double)>& progress) {
    for (const GltfPlacedNode& placed : placed_) findShape(placed);
    std::set<std::size_t> leftOut;
    for (const auto& [index, shape] : shapes_) leftOut.insert(meshOf(index));
    for (const GltfPlacedNode& placed : placed_) {
      if (hasMesh(placed.index) && shapes_.count(placed.index) == 0) leftOut.erase(meshOf(placed.index));
    }
    meshes_ = readMeshes(reading_, leftOut, progress);
    for (const GltfPlacedNode& placed : placed_) {
      if (hasMesh(placed.index)) place(placed);
      placeLightAndCamera(placed.index, placed.worldFromNode);
    }
    nodes_.meshes = std::move(meshes_.meshes);
    return std::move(nodes_);
  }

 private:
  bool hasMesh(std::size_t node) const { return file_.gltf.nodes[node].mesh >= 0; }
  std::size_t meshOf(std::size_t node) const { return static_cast<std::size_t>(file_.gltf.nodes[node].mesh); }

  void findShape(const GltfPlacedNode& placed) {
    const tinygltf::Node& node = file_.gltf.nodes[placed.index];
    if (node.mesh < 0) return;
    if (meshOf(placed.index) >= file_.gltf.meshes.size()) {
      file_.fail(nodePlace(file_, placed.index), "mesh " + std::to_string(node.mesh) +
                                                     " does not exist; the file has " +
                                                     std::to_string(file_.gltf.meshes.size()));
    }
    GltfShape shape;
    const auto posed = pose_.find(placed.index);
    shape.weights = posed != pose_.end() && !posed->second.weights.empty() ? posed->second.weights
                    : !node.weights.empty()                                ? node.weights
                                            : file_.gltf.meshes[meshOf(placed.index)].weights;
    if (node.skin >= 0) shape.joints = jointTransforms(placed);
    if (!shape.atRest()) shapes_[placed.index] = std::move(shape);
  }

  /// Only the joints place a skinned mesh: the node's own transform is ignored (glTF 2.0, section 3.7.3.3).
  std::vector<glm::dmat4> jointTransforms(const GltfPlacedNode& placed) {
    const std::string place = nodePlace(file_, placed.index);
    const int index = file_.gltf.nodes[placed.index].skin;
    if (static_cast<std::size_t>(index) >= file_.gltf.skins.size()) {
      file_.fail(place, "skin " + std::to_string(index) + " does not exist; the file has " +
                            std::to_string(file_.gltf.skins.size()));
    }
    const tinygltf::Skin& skin = file_.gltf.skins[static_cast<std::size_t>(index)];
    const std::string skinPlace = "skin " + std::to_string(index);
    file_.count(skin.joints.size() * sizeof(glm::dmat4), place + ": " + skinPlace);  // each node keeps its own
    std::vector<float> inverse;
    if (skin.inverseBindMatrices >= 0) {
      inverse = readFloats(file_, skin.inverseBindMatrices, 16, skinPlace + ": inverseBindMatrices");
      if (inverse.size() < 16 * skin.joints.size()) {
        file_.fail(skinPlace, "has " + std::to_string(inverse.size() / 16) + " inverse bind matrices for " +
                                  std::to_string(skin.joints.size()) + " joints");
      }
    }
    const glm::dmat4 nodeFromWorld = glm::translate(glm::dmat4(1.0), -glm::dvec3(placed.worldFromNode[3]));
    std::vector<glm::dmat4> joints;
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      const auto found = worldFromNode_.find(static_cast<std::size_t>(skin.joints[j]));
      if (skin.joints[j] < 0 || found == worldFromNode_.end()) {
        file_.fail(skinPlace, "joint " + std::to_string(skin.joints[j]) + " is no node of the scene; repair the model");
      }
      glm::dmat4 bind(1.0);
      for (std::size_t i = 0; !inverse.empty() && i < 16; ++i) {
        bind[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = static_cast<double>(inverse[16 * j + i]);
      }
      joints.push_back(nodeFromWorld * *found->second * bind);
    }
    return joints;
  }

  void place(const GltfPlacedNode& placed) {
    const tinygltf::Node& node = file_.gltf.nodes[placed.index];
    const std::string& meshName = file_.gltf.meshes[meshOf(placed.index)].name;
    const std::string name = !node.name.empty()  ? node.name
                             : !meshName.empty() ? meshName
                                                 : "node" + std::to_string(placed.index);
    const auto shaped = shapes_.find(placed.index);
    const bool skinned = shaped != shapes_.end() && !shaped->second.joints.empty();
    const std::vector<int> primitives =
        shaped == shapes_.end() ? meshes_.primitives[meshOf(placed.index)] : shapedMesh(placed.index, shaped->second);
    const glm::dmat4 worldFromMesh =
        skinned ? glm::translate(glm::dmat4(1.0), glm::dvec3(placed.worldFromNode[3])) : placed.worldFromNode;
    for (const glm::dmat4& instance : distinct(instanceTransforms(file_, placed.index))) {
      const glm::dmat4 worldFromInstance = worldFromMesh * instance;
      const glm::dmat4 turned = skinned ? worldFromInstance * shaped->second.joints.front() : worldFromInstance;
      const bool mirrors = glm::determinant(glm::dmat3(turned)) < 0.0;
      if (nodes_.instances.size() + primitives.size() > limits::kGltfInstances) {
        file_.fail(nodePlace(file_, placed.index),
                   "the file places more than " + std::to_string(limits::kGltfInstances) + " meshes; leave some out");
      }
      for (const int primitive : primitives) {
        nodes_.instances.push_back({name, mirrors ? mirroredMesh(primitive) : primitive, worldFromInstance});
      }
    }
  }

  /// Nodes with equal weights and no other difference share a mesh.
  std::vector<int> shapedMesh(std::size_t node, const GltfShape& shape) {
    const std::size_t mesh = meshOf(node);
    if (!shape.joints.empty()) return readShapedMesh(reading_, mesh, shape, meshes_);
    const auto [entry, isNew] = morphed_.emplace(std::make_pair(mesh, shape.weights), std::vector<int>());
    if (isNew) entry->second = readShapedMesh(reading_, mesh, shape, meshes_);
    return entry->second;
  }

  void placeLightAndCamera(std::size_t index, const glm::dmat4& worldFromNode) {
    const tinygltf::Node& node = file_.gltf.nodes[index];
    const std::string where = nodePlace(file_, index);
    const auto light = node.extensions.find("KHR_lights_punctual");
    if (light != node.extensions.end()) {
      const double number = extensionNumber(light->second, "light", -1.0);
      nodes_.lights.push_back(
          readLight(file_, number >= 0.0 && number <= 1.0e9 ? static_cast<int>(number) : -1, worldFromNode, where));
    }
    if (node.camera < 0) return;
    Camera camera = readCamera(file_, node.camera, worldFromNode, where);
    if (!node.name.empty()) camera.name = node.name;
    const std::string stem = camera.name;
    int& copy = nextCopy_.try_emplace(stem, 2).first->second;
    while (!cameraNames_.insert(camera.name).second) camera.name = stem + " " + std::to_string(copy++);
    nodes_.cameras.push_back(camera);
    const tinygltf::Camera& source = file_.gltf.cameras[static_cast<std::size_t>(node.camera)];
    const bool parallel = source.type == "orthographic";
    if (parallel) {
      const tinygltf::OrthographicCamera& of = source.orthographic;
      nodes_.clips.push_back({of.znear, of.zfar, of.xmag / of.ymag});  // ymag is above 0
    } else {
      const tinygltf::PerspectiveCamera& of = source.perspective;
      nodes_.clips.push_back({of.znear, of.zfar, of.aspectRatio});
    }
  }

  int mirroredMesh(int original) {
    const auto [entry, isNew] = mirrored_.emplace(original, static_cast<int>(meshes_.meshes.size()));
    if (isNew) meshes_.meshes.push_back(mirrored(meshes_.meshes[static_cast<std::size_t>(original)]));
    return entry->second;
  }

  GltfFile& file_;
  const GltfMeshReading& reading_;
  const GltfPose& pose_;
  std::vector<GltfPlacedNode> placed_;
  std::map<std::size_t, const glm::dmat4*> worldFromNode_;
  std::map<std::size_t, GltfShape> shapes_;  ///< by node: those not in the rest pose
  std::map<std::pair<std::size_t, std::vector<double>>, std::vector<int>> morphed_;
  std::map<int, int> mirrored_;
  std::set<std::string> cameraNames_;
  std::map<std::string, int> nextCopy_;  ///< of cameras of one name
  GltfMeshes meshes_;
  GltfNodes nodes_;
};

}  // namespace

GltfNodes readNodes(const GltfMeshReading& reading, const GltfPose& pose, const std::function<void(double)>& progress) {
  return NodeReader(reading, pose).read(progress);
}

}  // namespace boxprobe
