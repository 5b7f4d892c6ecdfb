// Reads numbers from buffers: every offset, stride and count is checked before a byte is read.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "filters/core/base/file_limits.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

std::size_t componentSize(int componentType) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;  // 32-bit signed and double are not in glTF 2.0
  }
}

/// memcpy, because files need not be aligned for the type.
template <typename Number>
Number load(const unsigned char* bytes) {
  Number value;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

float componentAsFloat(const unsigned char* bytes, int componentType, bool normalized) {
  // glTF 2.0, section 3.6.2.2: signed types reach -1 at two values.
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const auto value = static_cast<float>(load<std::int8_t>(bytes));
      return normalized ? std::max(value / 127.0f, -1.0f) : value;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: {
      const auto value = static_cast<float>(load<std::uint8_t>(bytes));
      return normalized ? value / 255.0f : value;
    }
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const auto value = static_cast<float>(load<std::int16_t>(bytes));
      return normalized ? std::max(value / 32767.0f, -1.0f) : value;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
      const auto value = static_cast<float>(load<std::uint16_t>(bytes));
      return normalized ? value / 65535.0f : value;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return static_cast<float>(load<std::uint32_t>(bytes));
    default:
      return load<float>(bytes);
  }
}

std::uint32_t indexAt(const unsigned char* bytes, int componentType) {
  if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return load<std::uint8_t>(bytes);
  if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<std::uint16_t>(bytes);
  return load<std::uint32_t>(bytes);
}

bool isIndexType(int componentType) {
  return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

std::string accessorPlace(int accessor, const std::string& where) {
  return where + ": accessor " + std::to_string(accessor);
}

const tinygltf::Accessor& accessorAt(const GltfFile& file, int index, const std::string& where) {
  if (index < 0 || static_cast<std::size_t>(index) >= file.gltf.accessors.size()) {
    file.fail(where, "accessor " + std::to_string(index) + " does not exist; the file has " +
                         std::to_string(file.gltf.accessors.size()));
  }
  return file.gltf.accessors[static_cast<std::size_t>(index)];
}

/// `count` elements of `elementSize` bytes, `stride` apart, all inside their buffer view.
struct Elements {
  const unsigned char* data = nullptr;
  std::size_t stride = 0;
};

Elements elementsIn(const GltfFile& file, int view, std::size_t offset, std::size_t count, std::size_t elementSize,
                    const std::string& where) {
  const ByteRange bytes = bufferViewBytes(file, view, where);
  const std::size_t declared = file.gltf.bufferViews[static_cast<std::size_t>(view)].byteStride;
  const std::size_t stride = declared == 0 ? elementSize : declared;
  if (stride < elementSize) {
    file.fail(where, "byteStride " + std::to_string(stride) + " is less than the element's " +
                         std::to_string(elementSize) + " bytes");
  }
  // In this order nothing overflows: the available bytes bound the count.
  const bool fits =
      offset <= bytes.size && (count == 0 || (elementSize <= bytes.size - offset &&
                                              (count - 1) <= (bytes.size - offset - elementSize) / stride));
  if (!fits) {
    file.fail(where, std::to_string(count) + " elements from byte " + std::to_string(offset) +
                         " do not fit into bufferView " + std::to_string(view) + " of " + std::to_string(bytes.size) +
                         " bytes; the file is damaged");
  }
  return {bytes.data + offset, stride};
}

/// Copies all elements with sparse values applied, or those of `only`, tightly packed.
std::vector<unsigned char> packedElements(const GltfFile& file, int index, std::size_t elementSize,
                                          const std::string& where, const EntryList* only = nullptr) {
  const tinygltf::Accessor& accessor = accessorAt(file, index, where);
  Elements base;
  if (accessor.bufferView >= 0) {
    base = elementsIn(file, accessor.bufferView, accessor.byteOffset, accessor.count, elementSize, where);
  } else if (accessor.count > limits::kGltfZeroElements) {
    file.fail(where, "has " + std::to_string(accessor.count) + " elements without data");
  }
  if (only != nullptr && accessor.sparse.isSparse) {
    const std::vector<unsigned char> all = packedElements(file, index, elementSize, where);
    std::vector<unsigned char> packed(only->size() * elementSize);
    for (std::size_t i = 0; i < only->size(); ++i) {
      std::memcpy(packed.data() + i * elementSize, all.data() + (*only)[i] * elementSize, elementSize);
    }
    return packed;
  }
  const std::size_t count = only != nullptr ? only->size() : accessor.count;
  file.count(count * elementSize, where);
  std::vector<unsigned char> packed(count * elementSize, 0);
  if (base.data != nullptr) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t from = only != nullptr ? (*only)[i] : i;
      std::memcpy(packed.data() + i * elementSize, base.data + from * base.stride, elementSize);
    }
  }
  if (!accessor.sparse.isSparse) return packed;

  const auto& sparse = accessor.sparse;
  const auto negative = [](std::ptrdiff_t offset) { return offset < 0; };  // newer tinygltf: unsigned offsets
  if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count ||
      negative(static_cast<std::ptrdiff_t>(sparse.indices.byteOffset)) ||
      negative(static_cast<std::ptrdiff_t>(sparse.values.byteOffset)) || !isIndexType(sparse.indices.componentType)) {
    file.fail(where, "has a sparse part whose count, offsets or index type are not valid");
  }
  const auto changed = static_cast<std::size_t>(sparse.count);
  const Elements indices =
      elementsIn(file, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), changed,
                 componentSize(sparse.indices.componentType), where + " (sparse indices)");
  const Elements values = elementsIn(file, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
                                     changed, elementSize, where + " (sparse values)");
  for (std::size_t i = 0; i < changed; ++i) {
    const std::size_t target = indexAt(indices.data + i * indices.stride, sparse.indices.componentType);
    if (target >= accessor.count) {
      file.fail(where, "sparse index " + std::to_string(target) + " is beyond its " + std::to_string(accessor.count) +
                           " elements");
    }
    std::memcpy(packed.data() + target * elementSize, values.data + i * values.stride, elementSize);
  }
  return packed;
}

}  // namespace

ByteRange bufferViewBytes(const GltfFile& file, int index, const std::string& where) {
  const std::string place = "bufferView " + std::to_string(index);
  if (index < 0 || static_cast<std::size_t>(index) >= file.gltf.bufferViews.size()) {
    file.fail(where, place + " does not exist; the file has " + std::to_string(file.gltf.bufferViews.size()));
  }
  const tinygltf::BufferView& view = file.gltf.bufferViews[static_cast<std::size_t>(index)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= file.gltf.buffers.size()) {
    file.fail(where, place + ": buffer " + std::to_string(view.buffer) + " does not exist; the file has " +
                         std::to_string(file.gltf.buffers.size()));
  }
  const std::vector<unsigned char>& bytes = file.gltf.buffers[static_cast<std::size_t>(view.buffer)].data;
  if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
    file.fail(where, place + " of " + std::to_string(view.byteLength) + " bytes from byte " +
                         std::to_string(view.byteOffset) + " runs past the end of buffer " +
                         std::to_string(view.buffer) + " of " + std::to_string(bytes.size()) +
                         " bytes; the file is damaged");
  }
  return {bytes.data() + view.byteOffset, view.byteLength};
}

int componentCount(const GltfFile& file, int index, const std::string& where) {
  switch (accessorAt(file, index, where).type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    case TINYGLTF_TYPE_MAT4:
      return 16;
    default:
      return 0;  // smaller matrices, which no attribute here uses
  }
}

std::size_t elementCount(const GltfFile& file, int index, const std::string& where) {
  return accessorAt(file, index, where).count;
}

std::vector<float> readFloats(const GltfFile& file, int index, int components, const std::string& attribute,
                              const EntryList* only) {
  const tinygltf::Accessor& accessor = accessorAt(file, index, attribute);
  const std::string where = accessorPlace(index, attribute);
  if (componentCount(file, index, where) != components) {
    file.fail(where, "has the wrong type; it needs " + std::to_string(components) + " components");
  }
  const std::size_t size = componentSize(accessor.componentType);
  if (size == 0)
    file.fail(where, "has a component type that is not in glTF: " + std::to_string(accessor.componentType));
  const std::vector<unsigned char> packed =
      packedElements(file, index, size * static_cast<std::size_t>(components), where, only);
  std::vector<float> values(packed.size() / size);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = componentAsFloat(packed.data() + i * size, accessor.componentType, accessor.normalized);
    if (!std::isfinite(values[i])) {
      const std::size_t element = i / static_cast<std::size_t>(components);
      file.fail(where, "element " + std::to_string(only != nullptr ? (*only)[element] : element) +
                           " is not finite; repair the model");
    }
  }
  return values;
}

std::vector<std::uint32_t> readIndices(const GltfFile& file, int index, const std::string& primitive) {
  const tinygltf::Accessor& accessor = accessorAt(file, index, primitive);
  const std::string where = accessorPlace(index, primitive);
  if (componentCount(file, index, where) != 1 || !isIndexType(accessor.componentType)) {
    file.fail(where, "indices must be unsigned bytes, shorts or ints");
  }
  const std::size_t size = componentSize(accessor.componentType);
  const std::vector<unsigned char> packed = packedElements(file, index, size, where);
  std::vector<std::uint32_t> values(accessor.count);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = indexAt(packed.data() + i * size, accessor.componentType);
  return values;
}

AddedAccessors::AddedAccessors(GltfFile& file)
    : file_(file),
      accessors_(file.gltf.accessors.size()),
      views_(file.gltf.bufferViews.size()),
      buffers_(file.gltf.buffers.size()) {}

AddedAccessors::~AddedAccessors() {
  file_.gltf.accessors.resize(accessors_);
  file_.gltf.bufferViews.resize(views_);
  file_.gltf.buffers.resize(buffers_);
}

int addAccessor(GltfFile& file, std::vector<unsigned char> bytes, std::size_t count, int componentType, int type,
                bool normalized, const std::string& where) {
  file.count(bytes.size(), where);
  tinygltf::BufferView view;
  view.buffer = static_cast<int>(file.gltf.buffers.size());
  view.byteLength = bytes.size();
  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(file.gltf.bufferViews.size());
  accessor.count = count;
  accessor.componentType = componentType;
  accessor.type = type;
  accessor.normalized = normalized;
  file.gltf.buffers.emplace_back().data = std::move(bytes);
  file.gltf.bufferViews.push_back(std::move(view));
  file.gltf.accessors.push_back(std::move(accessor));
  return static_cast<int>(file.gltf.accessors.size()) - 1;
}

}  // namespace boxprobe
