// The steps of reading a glTF file, shared by the gltf_*.cpp files: container, accessors, materials, meshes, nodes.
// Internal to this folder. tinygltf reads the JSON and the buffers; every index and range it hands over is checked here
// before it is used, because it checks few.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/model.h"

namespace boxprobe {

/// Of positions, transforms and factors. A transform of this size takes a position of this size to 1e36, still inside
/// single precision.
constexpr double kLargestNumber = 1e18;

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

std::vector<Material> readMaterials(GltfFile& file);

/// All meshes of the file, a Mesh for each primitive of triangles.
struct GltfMeshes {
  std::vector<Mesh> meshes;
  std::vector<std::vector<int>> primitives;  ///< by glTF mesh index: indices into `meshes`
};
GltfMeshes readMeshes(GltfFile& file);

/// The nodes of the default scene in world space. Adds to `meshes` copies with flipped winding for mirrored nodes.
std::vector<Instance> readInstances(GltfFile& file, GltfMeshes& meshes);

}  // namespace boxprobe
