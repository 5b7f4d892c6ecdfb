// Makes small glTF files for tests, valid or broken on purpose: the JSON is open to any change before it is packed.
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace boxprobe {

struct GlbBuilder {
  using Json = nlohmann::json;
  Json json = {{"asset", {{"version", "2.0"}}}};
  std::string buffer;

  enum Component { Byte = 5120, UByte = 5121, Short = 5122, UShort = 5123, UInt = 5125, Float = 5126 };

  /// A buffer view of these values; returns its index.
  template <typename Number>
  int view(const std::vector<Number>& values) {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    const std::size_t offset = buffer.size();
    const std::size_t size = values.size() * sizeof(Number);
    buffer.resize(offset + size);
    std::memcpy(buffer.data() + offset, values.data(), size);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
    return static_cast<int>(json["bufferViews"].size()) - 1;
  }
  int accessor(int bufferView, Component component, const std::string& type, std::size_t count) {
    Json accessor = {{"componentType", static_cast<int>(component)}, {"type", type}, {"count", count}};
    if (bufferView >= 0) accessor["bufferView"] = bufferView;
    json["accessors"].push_back(accessor);
    return static_cast<int>(json["accessors"].size()) - 1;
  }
  int floats(const std::string& type, std::size_t components, const std::vector<float>& values) {
    return accessor(view(values), Float, type, values.size() / components);
  }
  /// A mesh of one primitive with these members; returns its index.
  int mesh(const Json& primitive) {
    json["meshes"].push_back({{"primitives", Json::array({primitive})}});
    return static_cast<int>(json["meshes"].size()) - 1;
  }
  /// A root node of the scene; returns its index.
  int node(const Json& node) {
    json["nodes"].push_back(node);
    const int index = static_cast<int>(json["nodes"].size()) - 1;
    if (!json.contains("scenes")) json["scenes"] = Json::array({{{"nodes", Json::array()}}});
    json["scenes"][0]["nodes"].push_back(index);
    return index;
  }
  /// One triangle in the plane z = 0, normal +Z by winding; returns the POSITION accessor.
  int trianglePositions() { return floats("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0}); }
  /// A file of one node "tri" with one triangle; `extra` is merged into the primitive.
  void triangle(const Json& extra = Json::object()) {
    Json primitive = {{"attributes", {{"POSITION", trianglePositions()}}}};
    primitive.merge_patch(extra);
    node({{"name", "tri"}, {"mesh", mesh(primitive)}});
  }

  std::string glb() const {
    Json whole = json;
    std::string binary = buffer;
    binary.resize((binary.size() + 3) / 4 * 4);
    if (!binary.empty()) whole["buffers"] = Json::array({{{"byteLength", binary.size()}}});
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t binaryChunk = binary.empty() ? 0 : 8 + binary.size();
    std::string file = "glTF" + word(2) + word(12 + 8 + text.size() + binaryChunk);
    file += word(text.size()) + "JSON" + text;
    if (!binary.empty()) file += word(binary.size()) + std::string("BIN\0", 4) + binary;
    return file;
  }
  /// As .gltf text beside a file of its buffer.
  std::string gltf(const std::string& bufferName) const {
    Json whole = json;
    whole["buffers"] = Json::array({{{"byteLength", buffer.size()}, {"uri", bufferName}}});
    return whole.dump();
  }

 private:
  static std::string word(std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &number, 4);
    return bytes;
  }
};

}  // namespace boxprobe
