// Meshes of a glTF file: one Mesh per triangle primitive, for all modes and number formats.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "filters/core/base/file_limits.h"
#include "filters/io/gltf/gltf_parts.h"
#include "filters/io/mesh/tangents.h"

namespace boxprobe {

namespace {

template <typename Vector>
std::vector<Vector> asVectors(const std::vector<float>& values) {
  constexpr int kLength = Vector::length();
  std::vector<Vector> vectors(values.size() / kLength);
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (int c = 0; c < kLength; ++c) vectors[i][c] = values[i * kLength + static_cast<std::size_t>(c)];
  }
  return vectors;
}

/// An attribute if the primitive has it; throws unless it has one entry per position.
template <typename Vector>
std::vector<Vector> readAttribute(const GltfFile& file, const tinygltf::Primitive& primitive, const std::string& name,
                                  const GltfVertices& vertices, const std::string& place) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end()) return {};
  const std::string where = place + ": " + name;
  if (const std::size_t entries = elementCount(file, found->second, where); entries != vertices.count) {
    file.fail(where,
              "has " + std::to_string(entries) + " entries for " + std::to_string(vertices.count) + " positions");
  }
  return asVectors<Vector>(readFloats(file, found->second, Vector::length(), where, vertices.list()));
}

template <typename Value>
std::uint64_t bytesOf(const std::vector<Value>& values) {
  return values.size() * sizeof(Value);
}
std::uint64_t bytesOf(const Mesh& mesh) {
  return bytesOf(mesh.positions) + bytesOf(mesh.normals) + bytesOf(mesh.tangents) + bytesOf(mesh.uv) +
         bytesOf(mesh.uv1) + bytesOf(mesh.colors) + bytesOf(mesh.indices);
}

/// glTF 2.0, section 3.7.2.1: the vertex order of the three modes, all with the winding of the first triangle.
std::vector<std::uint32_t> triangleList(const std::vector<std::uint32_t>& order, int mode) {
  if (mode == TINYGLTF_MODE_TRIANGLES)
    return {order.begin(), order.end() - static_cast<std::ptrdiff_t>(order.size() % 3)};
  std::vector<std::uint32_t> list;
  for (std::size_t i = 0; i + 2 < order.size(); ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      const std::size_t odd = i % 2;
      list.insert(list.end(), {order[i], order[i + 1 + odd], order[i + 2 - odd]});
    } else {
      list.insert(list.end(), {order[i + 1], order[i + 2], order[0]});
    }
  }
  return list;
}

/// Without normals each triangle is flat (glTF 2.0, section 3.7.2.1), so vertices cannot be shared. Tangents are
/// removed, because they belong to missing normals.
void makeFlat(Mesh& mesh) {
  Mesh flat;
  flat.name = mesh.name;
  flat.material = mesh.material;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec3 a = mesh.positions[mesh.indices[i]];
    const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
    const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    // A degenerate triangle is never visible; its normal only has to be a unit vector.
    const glm::vec3 unit = length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f, 1.0f, 0.0f);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t source = mesh.indices[i + corner];
      flat.positions.push_back(mesh.positions[source]);
      flat.normals.push_back(unit);
      if (!mesh.uv.empty()) flat.uv.push_back(mesh.uv[source]);
      if (!mesh.uv1.empty()) flat.uv1.push_back(mesh.uv1[source]);
      if (!mesh.colors.empty()) flat.colors.push_back(mesh.colors[source]);
      flat.indices.push_back(static_cast<std::uint32_t>(i + corner));
    }
  }
  mesh = std::move(flat);
}

/// Quantized normals are not exactly unit, and a zero normal would become NaN in every shader.
/// Those that are said to be `unit` and are keep their last bit (glb_models.cpp).
void makeUnit(GltfFile& file, std::vector<glm::vec3>& normals, bool unit) {
  for (glm::vec3& normal : normals) {
    const double length = glm::length(glm::dvec3(normal));
    if (unit && std::abs(length - 1.0) < 1e-5) continue;
    if (length > 0.0) {
      normal = glm::vec3(glm::dvec3(normal) / length);
    } else {
      file.warn("has normals of length 0, which were set to +Y");
      normal = glm::vec3(0.0f, 1.0f, 0.0f);
    }
  }
}

void warnOfTheRest(GltfFile& file, const tinygltf::Primitive& primitive) {
  for (const char* name : {"COLOR_1", "TEXCOORD_2"}) {
    if (primitive.attributes.count(name) > 0) file.warn("has " + std::string(name) + ", which is ignored");
  }
}

/// COLOR_0: three or four components; without alpha it is 1 (glTF 2.0, section 3.7.2.1). Whole numbers must be marked
/// as normalized. Blender 2.91 did not do so, and nothing else can be meant.
std::vector<glm::vec4> readColors(GltfFile& file, const tinygltf::Primitive& primitive, const GltfVertices& vertices,
                                  const std::string& place) {
  const auto found = primitive.attributes.find("COLOR_0");
  if (found == primitive.attributes.end()) return {};
  std::vector<glm::vec4> colors;
  const bool opaque = componentCount(file, found->second, place + ": COLOR_0") == 3;  // checks the index, too
  tinygltf::Accessor& accessor = file.gltf.accessors[static_cast<std::size_t>(found->second)];
  if (!accessor.normalized && accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
    accessor.normalized = true;
    file.warn("has vertex colours in whole numbers that are not marked as normalized; they are read as if they were");
  }
  if (opaque) {
    for (const glm::vec3& rgb : readAttribute<glm::vec3>(file, primitive, "COLOR_0", vertices, place)) {
      colors.emplace_back(rgb, 1.0f);
    }
  } else {
    colors = readAttribute<glm::vec4>(file, primitive, "COLOR_0", vertices, place);
  }
  for (glm::vec4& color : colors) color = glm::clamp(color, 0.0f, 1.0f);
  return colors;
}

/// The vertices of the triangles in their order, which for a primitive without indices is the file's.
std::vector<std::uint32_t> readOrder(const GltfFile& file, const tinygltf::Primitive& primitive, std::size_t count,
                                     const std::string& place) {
  std::vector<std::uint32_t> order;
  if (primitive.indices < 0) {
    order.resize(count);
    for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>(i);
    return order;
  }
  order = readIndices(file, primitive.indices, place + ": indices");
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] < count) continue;
    file.fail(place + ": indices", "index " + std::to_string(i) + " is " + std::to_string(order[i]) +
                                       ", but there are " + std::to_string(count) + " positions; the file is damaged");
  }
  return order;
}

/// The vertices that `order` uses, in whose list it counts from then on; none if these are all. Others would count in
/// the bounds, and many primitives may share one long list.
std::optional<EntryList> takeUsed(std::vector<std::uint32_t>& order, std::size_t count) {
  EntryList used;
  if (order.size() < count / 2) {  // their number is a promise until they are read
    used = order;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (std::uint32_t& vertex : order) {
      vertex = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), vertex) - used.begin());
    }
    return used;
  }
  constexpr std::uint32_t kUnused = 0xffffffffu;
  std::vector<std::uint32_t> places(count, kUnused);
  for (const std::uint32_t vertex : order) places[vertex] = 0;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (places[i] == kUnused) continue;
    places[i] = static_cast<std::uint32_t>(used.size());
    used.push_back(i);
  }
  if (used.size() == count) return std::nullopt;
  for (std::uint32_t& vertex : order) vertex = places[vertex];
  return used;
}

Mesh readPrimitive(const GltfMeshReading& reading, const tinygltf::Primitive& primitive, int mode,
                   const GltfShape& shape, const std::string& place) {
  GltfFile& file = reading.file;
  Mesh mesh;
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) file.fail(place, "has no POSITION attribute; export it again");
  GltfVertices vertices;
  vertices.count = elementCount(file, position->second, place + ": POSITION");
  if (vertices.count > 0xffffffffu) file.fail(place, "has more than 2^32 positions; split it");
  if (primitive.indices < -1) file.fail(place, "indices must be the number of an accessor");
  std::vector<std::uint32_t> order;
  if (primitive.indices >= 0) {
    order = readOrder(file, primitive, vertices.count, place);
    vertices.only = takeUsed(order, vertices.count);
  }
  mesh.positions = readAttribute<glm::vec3>(file, primitive, "POSITION", vertices, place);
  if (primitive.indices < 0) order = readOrder(file, primitive, vertices.count, place);
  mesh.normals = readAttribute<glm::vec3>(file, primitive, "NORMAL", vertices, place);
  mesh.tangents = readAttribute<glm::vec4>(file, primitive, "TANGENT", vertices, place);
  applyShape(file, primitive, shape, vertices, mesh, place);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 reach = glm::abs(mesh.positions[i]);
    if (std::max({reach.x, reach.y, reach.z}) <= static_cast<float>(limits::kNumber)) continue;
    file.fail(place + ": POSITION",
              "entry " + std::to_string(vertices.entry(i)) + " lies beyond 1e18; repair the model");
  }
  mesh.uv = readAttribute<glm::vec2>(file, primitive, "TEXCOORD_0", vertices, place);
  mesh.uv1 = readAttribute<glm::vec2>(file, primitive, "TEXCOORD_1", vertices, place);
  mesh.colors = readColors(file, primitive, vertices, place);

  if (mode == TINYGLTF_MODE_TRIANGLES && order.size() % 3 != 0) {
    file.warn("has triangle lists whose length is no multiple of 3; the incomplete triangle is left out");
  }
  mesh.indices = triangleList(order, mode);

  const int material = reading.variant < 0 ? primitive.material : variantMaterial(primitive, reading.variant);
  if (material >= 0 && static_cast<std::size_t>(material) >= file.gltf.materials.size()) {
    file.fail(place, "material " + std::to_string(material) + " does not exist; the file has " +
                         std::to_string(file.gltf.materials.size()));
  }
  mesh.material = material < 0 ? -1 : material;
  if (mesh.normals.empty()) {
    makeFlat(mesh);
  } else {
    makeUnit(file, mesh.normals, primitive.extras.IsObject() && primitive.extras.Has("unitNormals"));
  }
  if (mesh.material >= 0 && mesh.tangents.empty()) {
    const Material& drawn = reading.materials[static_cast<std::size_t>(mesh.material)];
    const int set = tangentSet(mesh, drawn);
    if (set >= 0) addTangents(mesh, set);
    if (set < 0 && drawn.finish.isAnisotropic()) {
      file.warn("has anisotropic surfaces without tangents or texture coordinates, which are drawn isotropic");
    }
  }
  warnOfTheRest(file, primitive);
  return mesh;
}

}  // namespace

std::vector<int> readShapedMesh(const GltfMeshReading& reading, std::size_t index, const GltfShape& shape,
                                GltfMeshes& result) {
  GltfFile& file = reading.file;
  const tinygltf::Mesh& source = file.gltf.meshes[index];
  const std::string name = source.name.empty() ? "mesh" + std::to_string(index) : source.name;
  std::vector<int> members;
  for (std::size_t p = 0; p < source.primitives.size(); ++p) {
    const std::string place = "mesh " + std::to_string(index) + " \"" + name + "\": primitive " + std::to_string(p);
    const AddedAccessors dropped(file);
    const std::uint64_t before = file.budget.counted();
    const tinygltf::Primitive primitive = unpackDraco(file, index, p, place);
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (mode < TINYGLTF_MODE_TRIANGLES || mode > TINYGLTF_MODE_TRIANGLE_FAN) {
      file.warn("has points or lines, which are not supported and are ignored");
      continue;
    }
    Mesh mesh = readPrimitive(reading, primitive, mode, shape, place);
    mesh.name = name;
    // Flat triangles, tangents and small numbers as floats are more than what was read.
    const std::uint64_t made = bytesOf(mesh), read = file.budget.counted() - before;
    if (made > read) file.count(made - read, place);
    if (mesh.indices.empty()) continue;
    members.push_back(static_cast<int>(result.meshes.size()));
    result.meshes.push_back(std::move(mesh));
  }
  return members;
}

GltfMeshes readMeshes(const GltfMeshReading& reading, const std::set<std::size_t>& leftOut,
                      const std::function<void(double)>& progress) {
  GltfMeshes result;
  const std::size_t count = reading.file.gltf.meshes.size();
  for (std::size_t m = 0; m < count; ++m) {
    result.primitives.push_back(leftOut.count(m) > 0 ? std::vector<int>() : readShapedMesh(reading, m, {}, result));
    if (progress) progress(static_cast<double>(m + 1) / static_cast<double>(count));
  }
  return result;
}

}  // namespace boxprobe
