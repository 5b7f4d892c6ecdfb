// The steps of reading a glTF file, shared by the gltf_*.cpp files: container, accessors, materials, meshes, nodes.
// Internal to this folder. tinygltf reads the JSON; every index and range it hands over is checked here before it is
// used, because it checks few. Files beside the model are read here.
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

/// An image as the file names it; its bytes are read when a material asks for them.
struct GltfImage {
  std::string name;
  std::string uri;
  int bufferView = -1;  ///< without a uri
  std::string bytes;    ///< of a uri, once read
};

struct GltfFile {
  std::string path;
  tinygltf::Model gltf;  ///< without images, which are below
  std::vector<GltfImage> images;
  /// Accessors of the indices of primitives in Draco's form, by mesh and primitive.
  std::map<std::pair<std::size_t, std::size_t>, int> dracoIndices;
  std::vector<std::string> warnings;
  std::size_t shapedPositions = 0;  ///< read so far, over all shapes

  /// Throws InputError: "building.glb: accessor 3: reason".
  [[noreturn]] void fail(const std::string& where, const std::string& reason) const;
  /// Adds a warning unless it is there.
  void warn(const std::string& warning);
};

/// Reads the file and whatever buffers it names, all from inside its folder. Unknown required extensions and versions
/// are refused.
GltfFile openGltf(const std::string& path);

/// The file that `uri` (percent-encoded) names beside the model, or a data URI decoded; null if no such file exists.
/// Throws InputError for one outside of the model's folder.
std::unique_ptr<std::string> readUri(const GltfFile& file, const std::string& uri);

/// What stands in the JSON before tinygltf sees it: version and extensions are checked; images and buffers are taken
/// out of it, because tinygltf would read every file that they name and refuses compressed ones.
struct GltfText {
  struct Buffer {
    std::string uri;  ///< empty: the binary chunk
    std::size_t byteLength = 0;
    bool unused = false;  ///< stands in for compressed bytes, for readers that cannot decompress
  };
  std::string json;
  std::vector<Buffer> buffers;
};
GltfText prepareGltf(GltfFile& file, const std::string& json);

/// Refuses extensions that are required and not read, with what to do; warns of those that are used and left out.
void checkExtensions(GltfFile& file, const std::vector<std::string>& required, const std::vector<std::string>& used);

/// EXT_meshopt_compression: compressed buffer views become plain ones.
void unpackMeshopt(GltfFile& file);

/// KHR_draco_mesh_compression: the primitive with added accessors for what was compressed; others as they are.
tinygltf::Primitive unpackDraco(GltfFile& file, std::size_t mesh, std::size_t primitive, const std::string& place);

/// Takes away at its end what was added to the file since its beginning.
class AddedAccessors {
 public:
  explicit AddedAccessors(GltfFile& file);
  ~AddedAccessors();
  AddedAccessors(const AddedAccessors&) = delete;
  AddedAccessors& operator=(const AddedAccessors&) = delete;

 private:
  GltfFile& file_;
  std::size_t accessors_, views_, buffers_;
};

/// A buffer, a view and an accessor of these bytes; returns the accessor's index.
int addAccessor(GltfFile& file, std::vector<unsigned char> bytes, std::size_t count, int componentType, int type,
                bool normalized);

/// A stretch of a buffer, checked to lie inside it.
struct ByteRange {
  const unsigned char* data = nullptr;
  std::size_t size = 0;
};
ByteRange bufferViewBytes(const GltfFile& file, int view, const std::string& where);

/// `components` (1 to 4, 16 of a matrix) floats an element; normalized integers mapped to [0, 1] or [-1, 1]. Refuses
/// accessors of another type and values that are not finite. `where` names the attribute for messages.
std::vector<float> readFloats(const GltfFile& file, int accessor, int components, const std::string& where);
/// Components of the accessor's type; throws if there is no such accessor.
int componentCount(const GltfFile& file, int accessor, const std::string& where);
std::vector<std::uint32_t> readIndices(const GltfFile& file, int accessor, const std::string& where);

/// Whether there is such an image, its bytes read: false with a warning for a file that does not exist.
bool readImage(GltfFile& file, int index, const std::string& where);

/// These images of the file, all read, decoded on several threads, each byte string once in this process as long as it
/// is held anywhere.
std::map<int, std::shared_ptr<const ImageRgba8>> decodeImages(const GltfFile& file, const std::set<int>& images,
                                                              const std::function<void(double)>& progress);

/// Decodes the images that materials use, on several threads; `progress` as in loadModelFile, over the images alone.
std::vector<Material> readMaterials(GltfFile& file, const std::function<void(double)>& progress);

/// Of KHR_materials_pbrSpecularGlossiness.
struct GltfSpecularGlossiness {
  glm::vec3 specular{1.0f};
  float glossiness = 1.0f;
};
/// A material whose base colour stands for the extension's diffuse colour, and whose metallic-roughness picture for its
/// specular-glossiness picture, into metallic-roughness.
void convertSpecularGlossiness(Material& material, const GltfSpecularGlossiness& factors);

/// The extension's number of that key, or `standard`.
double extensionNumber(const tinygltf::Value& extension, const char* key, double standard);
/// A whole number from -1 to 1e9, or `standard`.
int extensionWhole(const tinygltf::Value& extension, const char* key, int standard);

/// What a node does to the vertices of its mesh before they are placed.
struct GltfShape {
  std::vector<double> weights;     ///< of the morph targets; those that are missing are 0
  std::vector<glm::dmat4> joints;  ///< of the skin: from the mesh to the node's position, axes of the world
  bool atRest() const;
};

/// Morph targets, then the skin, on positions, normals and tangents (glTF 2.0, sections 3.7.2.2 and 3.7.3). Normals
/// are not unit afterwards.
void applyShape(GltfFile& file, const tinygltf::Primitive& primitive, const GltfShape& shape, Mesh& mesh,
                const std::string& place);

/// The file's meshes, a Mesh for each primitive of triangles.
struct GltfMeshes {
  std::vector<Mesh> meshes;
  std::vector<std::vector<int>> primitives;  ///< by glTF mesh index: indices into `meshes`
};

/// What meshes are read with.
struct GltfMeshReading {
  GltfFile& file;
  const std::vector<Material>& materials;
  int variant = -1;  ///< index of KHR_materials_variants; -1: the materials that primitives name
};
/// All but those of `leftOut`, as they are without any shape.
GltfMeshes readMeshes(const GltfMeshReading& reading, const std::set<std::size_t>& leftOut,
                      const std::function<void(double)>& progress);
/// Adds mesh `index` in this shape; returns its primitives.
std::vector<int> readShapedMesh(const GltfMeshReading& reading, std::size_t index, const GltfShape& shape,
                                GltfMeshes& meshes);

/// The names of KHR_materials_variants, in order.
std::vector<std::string> variantNames(const GltfFile& file);
/// Index of the material that a primitive has in a variant, -1 for none.
int variantMaterial(const tinygltf::Primitive& primitive, int variant);

/// Tangents for a mesh that a normal map needs them on: see gltf_tangents.cpp. Splits vertices where the picture is
/// mirrored.
void addTangents(Mesh& mesh, int uvSet);

/// Values that animations give a node in place of its own; empty: its own.
struct GltfNodePose {
  std::vector<double> translation, rotation, scale, weights;
};
using GltfPose = std::map<std::size_t, GltfNodePose>;
/// The animations at this time, in seconds; before their first key and behind their last one they stand still. Where
/// several move the same property the first one counts.
GltfPose poseAt(GltfFile& file, double seconds);
/// When the last animation ends; 0 without any.
double animationSeconds(const GltfFile& file);

/// A node of the default scene; parents stand before their children, else in the file's order.
struct GltfPlacedNode {
  std::size_t index = 0;
  glm::dmat4 worldFromNode{1.0};
};
std::vector<GltfPlacedNode> placeNodes(const GltfFile& file, const GltfPose& pose);
/// For messages.
std::string nodePlace(const GltfFile& file, std::size_t index);

/// Transforms of EXT_mesh_gpu_instancing; one that changes nothing for a node without it.
std::vector<glm::dmat4> instanceTransforms(const GltfFile& file, std::size_t node);

/// The nodes of the default scene in world space.
struct GltfNodes {
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
};
GltfNodes readNodes(const GltfMeshReading& reading, const GltfPose& pose, const std::function<void(double)>& progress);

/// KHR_lights_punctual's light `index` and the file's camera `index` as a node places them.
Light readLight(GltfFile& file, int index, const glm::dmat4& worldFromNode, const std::string& where);
Camera readCamera(GltfFile& file, int index, const glm::dmat4& worldFromNode, const std::string& where);

}  // namespace boxprobe
