// The steps of reading a glTF file, shared by the gltf_*.cpp files: container, accessors, materials, meshes, nodes.
// Internal to this folder. tinygltf parses the JSON but checks few indices and ranges, so they are checked here before
// use. Files beside the model are read here.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/io/files/read_budget.h"

namespace boxprobe {

/// An image as the file names it; its bytes are read when a material uses it.
struct GltfImage {
  std::string name;
  std::string uri;
  int bufferView = -1;  ///< if it has no uri
  std::string bytes;    ///< of the uri, once read
};

struct GltfFile {
  std::string path;
  tinygltf::Model gltf;  ///< without images, which are below
  std::vector<GltfImage> images;
  /// Accessors of the indices of Draco-compressed primitives, by mesh and primitive.
  std::map<std::pair<std::size_t, std::size_t>, int> dracoIndices;
  std::vector<std::string> warnings;
  std::set<std::string> warned;     ///< the same warnings, to find them
  std::size_t shapedPositions = 0;  ///< read so far, for all shapes
  mutable ReadBudget budget;        ///< see count()

  /// Throws InputError: "building.glb: accessor 3: reason".
  [[noreturn]] void fail(const std::string& where, const std::string& reason) const;
  /// Adds a warning once.
  void warn(const std::string& warning);
  /// Called for all bytes that are read or made from the file's own. Throws InputError beyond the budget.
  void count(std::uint64_t bytes, const std::string& where) const;
};

/// Reads the file and the buffers it refers to, all from its own folder. Throws for unknown versions and unsupported
/// required extensions.
GltfFile openGltf(const std::string& path);

/// Does the URI hold its data? Schemes may be written in capitals (RFC 3986, section 3.1).
bool isDataUri(const std::string& uri);

/// The contents of the file that `uri` (percent-encoded) names beside the model, or of a data URI; null if no such file
/// exists. Throws InputError for a file outside the model's folder.
std::unique_ptr<std::string> readUri(const GltfFile& file, const std::string& uri);

/// The JSON before tinygltf parses it: version and extensions are checked; images and buffers are removed, because
/// tinygltf would read every file that they name, and refuses compressed ones.
struct GltfText {
  struct Buffer {
    std::string uri;  ///< empty: the binary chunk
    std::size_t byteLength = 0;
    bool unused = false;  ///< fallback for readers that cannot decompress
  };
  std::string json;
  std::vector<Buffer> buffers;
};
GltfText prepareGltf(GltfFile& file, const std::string& json);

/// Throws for required extensions that are unsupported, with advice; warns of others that are ignored.
void checkExtensions(GltfFile& file, const std::vector<std::string>& required, const std::vector<std::string>& used);

/// Warns of values that are of another type than their field has, once for each field. tinygltf reads most such files
/// as if the values were missing.
void warnOfTypes(GltfFile& file, const nlohmann::json& root);

/// EXT_meshopt_compression: decompresses buffer views.
void unpackMeshopt(GltfFile& file);

/// KHR_draco_mesh_compression: the primitive with accessors for its decompressed data; others unchanged.
tinygltf::Primitive unpackDraco(GltfFile& file, std::size_t mesh, std::size_t primitive, const std::string& place);

/// Removes, in its destructor, what was added to the file since its construction.
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

/// Adds a buffer, a view and an accessor for these bytes, which are counted; returns the accessor's index.
int addAccessor(GltfFile& file, std::vector<unsigned char> bytes, std::size_t count, int componentType, int type,
                bool normalized, const std::string& where);

/// A range of a buffer, checked to lie inside it.
struct ByteRange {
  const unsigned char* data = nullptr;
  std::size_t size = 0;
};
ByteRange bufferViewBytes(const GltfFile& file, int view, const std::string& where);

/// Some elements of an accessor, which has them all.
using EntryList = std::vector<std::uint32_t>;

/// Which of its vertices a primitive is read with: those that it uses.
struct GltfVertices {
  std::size_t count = 0;          ///< in the file
  std::optional<EntryList> only;  ///< none: all
  const EntryList* list() const { return only ? &*only : nullptr; }
  /// Of the file, for messages.
  std::size_t entry(std::size_t i) const { return only ? (*only)[i] : i; }
};

/// `components` floats per element (1 to 4, 16 for a matrix), of all elements or of `only`; normalized integers are
/// mapped to [0, 1] or [-1, 1]. Throws for accessors of another type and for non-finite values. `where` names the
/// attribute in messages.
std::vector<float> readFloats(const GltfFile& file, int accessor, int components, const std::string& where,
                              const EntryList* only = nullptr);
/// Throws if there is no such accessor.
std::size_t elementCount(const GltfFile& file, int accessor, const std::string& where);
/// Components of the accessor's type; throws if there is no such accessor.
int componentCount(const GltfFile& file, int accessor, const std::string& where);
std::vector<std::uint32_t> readIndices(const GltfFile& file, int accessor, const std::string& where);

/// Reads an image's bytes; false, with a warning, if its file does not exist.
bool readImage(GltfFile& file, int index, const std::string& where);

/// Decodes these images, which must have been read, in parallel. Equal bytes are decoded once per process while any
/// copy is in use. Images that cannot be decoded are null, with a warning.
std::map<int, std::shared_ptr<const ImageRgba8>> decodeImages(GltfFile& file, const std::set<int>& images,
                                                              const std::function<void(double)>& progress);

/// Reads materials and decodes the images they use, in parallel; `progress` as in loadModelFile, over the images alone.
std::vector<Material> readMaterials(GltfFile& file, const std::function<void(double)>& progress);

/// Factors of KHR_materials_pbrSpecularGlossiness.
struct GltfSpecularGlossiness {
  glm::vec3 specular{1.0f};
  float glossiness = 1.0f;
};
/// Converts to metallic-roughness a material whose base colour holds the extension's diffuse colour, and whose
/// metallic-roughness texture its specular-glossiness texture.
void convertSpecularGlossiness(Material& material, const GltfSpecularGlossiness& factors);

/// The extension's number of that key, or `standard`.
double extensionNumber(const tinygltf::Value& extension, const char* key, double standard);
/// An integer from -1 to 1e9, or `standard`.
int extensionWhole(const tinygltf::Value& extension, const char* key, int standard);

/// Deformation of the vertices of a node's mesh.
struct GltfShape {
  std::vector<double> weights;     ///< of the morph targets; missing ones are 0
  std::vector<glm::dmat4> joints;  ///< of the skin: from the mesh to the node's position, in world axes
  bool atRest() const;
};

/// Applies morph targets, then the skin, to positions, normals and tangents (glTF 2.0, sections 3.7.2.2 and 3.7.3).
/// Normals are not unit afterwards.
void applyShape(GltfFile& file, const tinygltf::Primitive& primitive, const GltfShape& shape,
                const GltfVertices& vertices, Mesh& mesh, const std::string& place);

/// The file's meshes, one Mesh per triangle primitive.
struct GltfMeshes {
  std::vector<Mesh> meshes;
  std::vector<std::vector<int>> primitives;  ///< by glTF mesh index: indices into `meshes`
};

/// Options for reading meshes.
struct GltfMeshReading {
  GltfFile& file;
  const std::vector<Material>& materials;
  int variant = -1;  ///< index of KHR_materials_variants; -1: the primitives' own materials
};
/// Reads all meshes except those of `leftOut`, undeformed.
GltfMeshes readMeshes(const GltfMeshReading& reading, const std::set<std::size_t>& leftOut,
                      const std::function<void(double)>& progress);
/// Adds mesh `index`, deformed; returns its primitives.
std::vector<int> readShapedMesh(const GltfMeshReading& reading, std::size_t index, const GltfShape& shape,
                                GltfMeshes& meshes);

/// The names of KHR_materials_variants, in order.
std::vector<std::string> variantNames(const GltfFile& file);
/// The material of a primitive in a variant, -1 for none.
int variantMaterial(const tinygltf::Primitive& primitive, int variant);

/// Animated values that replace a node's own; empty: not animated.
struct GltfNodePose {
  std::vector<double> translation, rotation, scale, weights;
};
using GltfPose = std::map<std::size_t, GltfNodePose>;
/// The animations at a time in seconds; before the first key and after the last one values are constant. If several
/// animate the same property, the first is used.
GltfPose poseAt(GltfFile& file, double seconds);
/// The end of the last animation; 0 without any.
double animationSeconds(const GltfFile& file);

/// A node of the default scene; parents come before their children, otherwise in the file's order.
struct GltfPlacedNode {
  std::size_t index = 0;
  glm::dmat4 worldFromNode{1.0};
};
std::vector<GltfPlacedNode> placeNodes(const GltfFile& file, const GltfPose& pose);
/// For messages.
std::string nodePlace(const GltfFile& file, std::size_t index);

/// Transforms of EXT_mesh_gpu_instancing; the identity for a node without it.
std::vector<glm::dmat4> instanceTransforms(const GltfFile& file, std::size_t node);

/// What a camera of ours has not: distances of its near and far plane (far 0: none), and the width of its picture over
/// the height (0: any).
struct GltfClip {
  double near = 0.0, far = 0.0, aspect = 0.0;
};

/// The nodes of the default scene in world space.
struct GltfNodes {
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  std::vector<GltfClip> clips;  ///< of the cameras
};
GltfNodes readNodes(const GltfMeshReading& reading, const GltfPose& pose, const std::function<void(double)>& progress);

/// KHR_lights_punctual's light `index`, placed by a node; below, the same for the file's camera `index`.
Light readLight(GltfFile& file, int index, const glm::dmat4& worldFromNode, const std::string& where);
Camera readCamera(GltfFile& file, int index, const glm::dmat4& worldFromNode, const std::string& where);

/// Warns if a camera's near or far plane would cut off something that it sees.
void warnOfClipping(GltfFile& file, const GltfNodes& nodes);
/// Warns if a camera's picture has another shape than ours by default, 16:9.
void warnOfShape(GltfFile& file, const GltfNodes& nodes);

}  // namespace boxprobe
