// Layouts follow the KTX File Format Specification 2.0 with the Khronos Data Format Specification 1.3 (basic descriptor
// block), and Microsoft's "Programming guide for DDS". Both formats are little-endian.
#include "filters/io/engines/cube_container.h"

#include <Imath/half.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace boxprobe {

namespace {

constexpr float kLargestHalf = 65504.0f;
constexpr std::uint32_t kTexelBytes = 8;

template <typename Integer>
void append(std::string& bytes, Integer value) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xff);
  }
}

void append32(std::string& bytes, std::initializer_list<std::uint32_t> values) {
  for (const std::uint32_t value : values) append(bytes, value);
}

void pad(std::string& bytes, std::size_t alignment) {
  bytes.resize((bytes.size() + alignment - 1) / alignment * alignment, '\0');
}

void appendFace(std::string& bytes, const CubeMap& cube, int level, int face) {
  const auto size = static_cast<std::size_t>(cube.levelSize(level));
  const float* values = cube.face(level, face);
  for (std::size_t i = 0; i < size * size * 4; ++i) {
    const float value = std::isfinite(values[i]) ? std::clamp(values[i], -kLargestHalf, kLargestHalf) : 0.0f;
    append(bytes, Imath::half(value).bits());
  }
}

/// Data format descriptor: four channels of 16-bit floats, linear light.
std::string formatDescriptor(bool premultiplied) {
  constexpr std::uint32_t kBlockSize = 24 + 4 * 16;
  constexpr std::uint32_t kColourModelRgbsda = 1, kPrimariesBt709 = 1, kTransferLinear = 1;
  std::string bytes;
  append32(bytes, {4 + kBlockSize, 0, 2 | kBlockSize << 16,
                   kColourModelRgbsda | kPrimariesBt709 << 8 | kTransferLinear << 16 | (premultiplied ? 1u << 24 : 0u),
                   0, kTexelBytes, 0});
  constexpr std::uint32_t kFloatSigned = 0xc0, kMinusOne = 0xbf800000, kOne = 0x3f800000;
  std::uint32_t offset = 0;
  for (const std::uint32_t channel : {0u, 1u, 2u, 15u}) {  // red, green, blue, alpha
    append32(bytes, {offset | 15u << 16 | (channel | kFloatSigned) << 24, 0, kMinusOne, kOne});
    offset += 16;
  }
  return bytes;
}

void appendKeyValue(std::string& bytes, const std::string& key, const std::string& value) {
  append(bytes, static_cast<std::uint32_t>(key.size() + value.size() + 2));
  bytes += key + '\0' + value + '\0';
  pad(bytes, 4);
}

}  // namespace

HalfLoss halfLoss(const CubeMap& cube) {
  HalfLoss loss;
  const std::size_t texels = std::size_t(cube.faceSize()) * cube.faceSize();
  for (int face = 0; face < 6; ++face) {
    for (std::size_t i = 0; i < texels; ++i) {
      const float* rgba = cube.face(0, face) + 4 * i;
      const bool finite = std::all_of(rgba, rgba + 4, [](float v) { return std::isfinite(v); });
      if (!finite) {
        ++loss.texelsNotFinite;
      } else if (std::any_of(rgba, rgba + 4, [](float v) { return std::abs(v) >= kLargestHalf; })) {
        ++loss.texelsAtLimit;
      }
    }
  }
  return loss;
}

bool coversPartly(const CubeMap& cube) {
  constexpr float kAll = 0.9995f;  // rounds to 1 as a half float, with the filter's own rounding error
  const std::size_t texels = std::size_t(cube.faceSize()) * cube.faceSize();
  for (int face = 0; face < 6; ++face) {
    for (std::size_t i = 0; i < texels; ++i) {
      if (cube.face(0, face)[4 * i + 3] < kAll) return true;
    }
  }
  return false;
}

std::string encodeKtx2(const CubeMap& cube, const std::string& writer) {
  constexpr std::uint32_t kFormatRgba16Sfloat = 97;
  const auto levels = static_cast<std::uint32_t>(cube.levels()), size = static_cast<std::uint32_t>(cube.faceSize());
  const std::string descriptor = formatDescriptor(coversPartly(cube));
  std::string keyValues;  // sorted by key
  appendKeyValue(keyValues, "KTXorientation", "rd");
  appendKeyValue(keyValues, "KTXwriter", writer);

  std::string bytes("\xabKTX 20\xbb\r\n\x1a\n", 12);
  append32(bytes, {kFormatRgba16Sfloat, 2, size, size, 0, 0, 6, levels, 0});
  const auto afterIndex = static_cast<std::uint32_t>(bytes.size() + 4 * 4 + 2 * 8 + levels * 24);
  const auto descriptorSize = static_cast<std::uint32_t>(descriptor.size());
  append32(bytes, {afterIndex, descriptorSize, afterIndex + descriptorSize,
                   static_cast<std::uint32_t>(keyValues.size()), 0, 0, 0, 0});
  std::string head = descriptor + keyValues, data;
  const std::size_t start = (afterIndex + head.size() + kTexelBytes - 1) / kTexelBytes * kTexelBytes;
  std::vector<std::size_t> offsets(levels), lengths(levels);
  for (int level = cube.levels() - 1; level >= 0; --level) {
    const auto i = static_cast<std::size_t>(level);
    offsets[i] = start + data.size();
    for (int face = 0; face < 6; ++face) appendFace(data, cube, level, face);
    lengths[i] = start + data.size() - offsets[i];
  }
  for (std::size_t i = 0; i < levels; ++i) {
    append(bytes, std::uint64_t(offsets[i]));
    append(bytes, std::uint64_t(lengths[i]));
    append(bytes, std::uint64_t(lengths[i]));
  }
  bytes += head;
  pad(bytes, kTexelBytes);
  return bytes + data;
}

std::string encodeDds(const CubeMap& cube) {
  constexpr std::uint32_t kCaps = 0x1, kHeight = 0x2, kWidth = 0x4, kPitch = 0x8, kPixelFormat = 0x1000,
                          kMipMapCount = 0x20000;
  constexpr std::uint32_t kFourCc = 0x4, kDx10 = 0x30315844;  // "DX10"
  constexpr std::uint32_t kComplex = 0x8, kTexture = 0x1000, kMipMap = 0x400000, kCubeAllFaces = 0xfe00;
  constexpr std::uint32_t kDxgiRgba16Float = 10, kTexture2d = 3, kTextureCube = 4, kPremultiplied = 2, kOpaque = 3;
  const auto levels = static_cast<std::uint32_t>(cube.levels()), size = static_cast<std::uint32_t>(cube.faceSize());
  std::string bytes = "DDS ";
  append32(bytes, {124, kCaps | kHeight | kWidth | kPitch | kPixelFormat | kMipMapCount, size, size, size * kTexelBytes,
                   0, levels});
  bytes.append(11 * 4, '\0');
  append32(bytes, {32, kFourCc, kDx10, 0, 0, 0, 0, 0});
  append32(bytes, {kComplex | kTexture | kMipMap, kCubeAllFaces, 0, 0, 0});
  append32(bytes, {kDxgiRgba16Float, kTexture2d, kTextureCube, 1, coversPartly(cube) ? kPremultiplied : kOpaque});
  for (int face = 0; face < 6; ++face) {
    for (int level = 0; level < cube.levels(); ++level) appendFace(bytes, cube, level, face);
  }
  return bytes;
}

}  // namespace boxprobe
