// KHR_draco_mesh_compression through Google's Draco. Its decoder allocates whatever a stream claims, so the claims are
// first checked against the stream's size. Source of the layout: the Draco bitstream specification, version 2.2.
#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

#include <algorithm>

#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";

/// A flat grid of 1024 x 1024 equal squares, as regular as meshes get, has 521 triangles per byte.
constexpr std::uint64_t kTrianglesAByte = 1024;
/// A triangle adds at most three points.
constexpr std::uint64_t kPointsATriangle = 3;

struct Claims {
  std::uint64_t triangles = 0, points = 0;
  bool read = false;
};

/// The counts in a stream's header; empty for other versions and kinds of streams.
Claims claimsOf(const ByteRange& bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data), bytes.size);
  draco::DracoHeader header;
  Claims claims;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) return claims;
  if (header.version_major != 2 || header.version_minor != 2 || header.encoder_type != draco::TRIANGULAR_MESH) {
    return claims;
  }
  buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(2, 2));
  if ((header.flags & METADATA_FLAG_MASK) != 0) {
    draco::GeometryMetadata ignored;
    if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &ignored)) return claims;
  }
  std::uint32_t first = 0, second = 0;
  std::uint8_t traversal = 0;
  const bool edgebreaker = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING;
  if (edgebreaker && !buffer.Decode(&traversal)) return claims;
  if (!draco::DecodeVarint(&first, &buffer) || !draco::DecodeVarint(&second, &buffer)) return claims;
  claims.triangles = edgebreaker ? second : first;
  claims.points = edgebreaker ? first : second;
  claims.read = true;
  return claims;
}

void checkClaims(const GltfFile& file, const ByteRange& bytes, const std::string& place) {
  const Claims claims = claimsOf(bytes);
  if (!claims.read) file.fail(place, "is not a Draco 2.2 mesh; the file is damaged, or export it again");
  const std::uint64_t most = kTrianglesAByte * bytes.size;
  if (claims.triangles > most || claims.points > kPointsATriangle * most) {
    file.fail(place, std::to_string(claims.triangles) + " triangles and " + std::to_string(claims.points) +
                         " points are promised in " + std::to_string(bytes.size) + " bytes; the file is damaged");
  }
}

std::unique_ptr<draco::Mesh> decodeMesh(const GltfFile& file, const ByteRange& bytes, const std::string& place) {
  checkClaims(file, bytes, place);
  try {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data), bytes.size);
    auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (mesh.ok()) return std::move(mesh).value();
  } catch (const std::exception&) {
  }
  file.fail(place, "its compressed bytes cannot be decoded; the file is damaged");
}

template <typename Number>
bool copyValues(const draco::PointAttribute& attribute, std::size_t points, int components,
                std::vector<unsigned char>& bytes) {
  bytes.resize(points * static_cast<std::size_t>(components) * sizeof(Number));
  for (std::size_t i = 0; i < points; ++i) {
    Number values[4] = {};
    const draco::PointIndex point(static_cast<std::uint32_t>(i));
    const draco::AttributeValueIndex value = attribute.mapped_index(point);
    if (value.value() >= attribute.size()) return false;
    if (!attribute.ConvertValue<Number>(value, static_cast<std::int8_t>(components), values)) return false;
    std::copy_n(reinterpret_cast<const unsigned char*>(values), static_cast<std::size_t>(components) * sizeof(Number),
                bytes.data() + i * static_cast<std::size_t>(components) * sizeof(Number));
  }
  return true;
}

bool copyAttribute(const draco::PointAttribute& attribute, std::size_t points, int components, int componentType,
                   std::vector<unsigned char>& bytes) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return copyValues<std::int8_t>(attribute, points, components, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copyValues<std::uint8_t>(attribute, points, components, bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return copyValues<std::int16_t>(attribute, points, components, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copyValues<std::uint16_t>(attribute, points, components, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copyValues<std::uint32_t>(attribute, points, components, bytes);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return copyValues<float>(attribute, points, components, bytes);
    default:
      return false;
  }
}

int indexAccessor(GltfFile& file, const draco::Mesh& mesh, const std::string& place) {
  std::vector<unsigned char> bytes(std::size_t(mesh.num_faces()) * 12);
  for (std::uint32_t f = 0; f < mesh.num_faces(); ++f) {
    const draco::Mesh::Face& face = mesh.face(draco::FaceIndex(f));
    const std::uint32_t corners[3] = {face[0].value(), face[1].value(), face[2].value()};
    std::copy_n(reinterpret_cast<const unsigned char*>(corners), 12, bytes.data() + std::size_t(f) * 12);
  }
  return addAccessor(file, std::move(bytes), std::size_t(mesh.num_faces()) * 3, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                     TINYGLTF_TYPE_SCALAR, false, place);
}

}  // namespace

tinygltf::Primitive unpackDraco(GltfFile& file, std::size_t meshIndex, std::size_t index, const std::string& where) {
  tinygltf::Primitive primitive = file.gltf.meshes[meshIndex].primitives[index];
  const auto found = primitive.extensions.find(kDraco);
  if (found == primitive.extensions.end()) return primitive;
  const std::string place = where + ": " + kDraco;
  const ByteRange bytes = bufferViewBytes(file, extensionWhole(found->second, "bufferView", -1), place);
  const std::unique_ptr<draco::Mesh> mesh = decodeMesh(file, bytes, place);
  const tinygltf::Value attributes =
      found->second.Has("attributes") ? found->second.Get("attributes") : tinygltf::Value();
  for (auto& [name, accessor] : primitive.attributes) {
    const int id = extensionWhole(attributes, name.c_str(), -1);
    if (id < 0) continue;  // not compressed
    const draco::PointAttribute* attribute = mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
    const std::string attributePlace = place + ": " + name;
    const int components = componentCount(file, accessor, attributePlace);
    const tinygltf::Accessor declared = file.gltf.accessors[static_cast<std::size_t>(accessor)];
    std::vector<unsigned char> values;
    if (attribute == nullptr || components < 1 || components > 4 ||
        !copyAttribute(*attribute, mesh->num_points(), components, declared.componentType, values)) {
      file.fail(attributePlace, "is not in the compressed mesh; export it again");
    }
    accessor = addAccessor(file, std::move(values), mesh->num_points(), declared.componentType, declared.type,
                           declared.normalized, attributePlace);
  }
  primitive.indices = indexAccessor(file, *mesh, place);
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  return primitive;
}

}  // namespace boxprobe
