// The steps of reading a glTF file, shared by the gltf_*.cpp files: container, accessors, materials, meshes, nodes.
// Internal to this folder. tinygltf reads the JSON and the buffers; every index and range it hands over is checked here
// before it is used, because it checks few.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Of positions, transforms and factors. A transform of this size takes a position of this size to 1e36, still inside
/// single precision.
constexpr double kLargestGltfNumber = 1e18;

struct GltfFile {
  std::string path;
  tinygltf::Model gltf;
  /// Undecoded bytes of the images that are files or data URIs, by image index; those in buffer views stay there.
  std::map<int, std::string> encodedImages;
  std::vector<std::string> warnings;

  /// Throws InputError: "building.glb: accessor 3: reason".
  [[noreturn]] void fail(const std::string& where, const std::string& reason) const;
  /// Adds a warning unless it is there.
  void warn(const std::string& warning);
};

/// Reads the file and whatever buffers and images it names, all from inside its folder. Unknown required extensions and
/// versions are refused.
GltfFile openGltf(const std::string& path);

/// A stretch of a buffer, checked to lie inside it.
struct ByteRange {
  const unsigned char* data = nullptr;
  std::size_t size = 0;
};
ByteRange bufferViewBytes(const GltfFile& file, int view, const std::string& where);

/// `components` (1 to 4) floats an element; normalized integers mapped to [0, 1] or [-1, 1]. Refuses accessors of
/// another type and values that are not finite. `where` names the attribute for messages.
std::vector<float> readFloats(const GltfFile& file, int accessor, int components, const std::string& where);
/// Components of the accessor's type; throws if there is no such accessor.
int componentCount(const GltfFile& file, int accessor, const std::string& where);
std::vector<std::uint32_t> readIndices(const GltfFile& file, int accessor, const std::string& where);

/// These images of the file, decoded on several threads, each byte string once in this process as long as it is held
/// anywhere.
std::map<int, std::shared_ptr<const ImageRgba8>> decodeImages(const GltfFile& file, const std::set<int>& images,
                                                              const std::function<void(double)>& progress);

/// Decodes the images that materials use, on several threads; `progress` as in loadModelFile, over the images alone.
std::vector<Material> readMaterials(GltfFile& file, const std::function<void(double)>& progress);

/// The extension's number of that key, or `standard`.
double extensionNumber(const tinygltf::Value& extension, const char* key, double standard);

/// All meshes of the file, a Mesh for each primitive of triangles.
struct GltfMeshes {
  std::vector<Mesh> meshes;
  std::vector<std::vector<int>> primitives;  ///< by glTF mesh index: indices into `meshes`
};
GltfMeshes readMeshes(GltfFile& file, const std::vector<Material>& materials,
                      const std::function<void(double)>& progress);

/// Tangents for a mesh that a normal map needs them on: see gltf_tangents.cpp. Splits vertices where the picture is
/// mirrored.
void addTangents(Mesh& mesh, int uvSet);

/// The nodes of the default scene in world space.
struct GltfNodes {
  std::vector<Instance> instances;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
};
/// Adds to `meshes` copies with flipped winding for mirrored nodes.
GltfNodes readNodes(GltfFile& file, GltfMeshes& meshes);

/// KHR_lights_punctual's light `index` and the file's camera `index` as a node places them.
Light readLight(GltfFile& file, int index, const glm::dmat4& worldFromNode, const std::string& where);
Camera readCamera(GltfFile& file, int index, const glm::dmat4& worldFromNode, const std::string& where);

}  // namespace boxprobe
