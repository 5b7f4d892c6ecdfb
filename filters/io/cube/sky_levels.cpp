// The file: magic, key, face size and levels (32 bits each), nine coefficients of three floats, texels, and XXH3 of all
// that (64 bits). Numbers are little-endian; a big-endian machine does not recognize the magic and filters its levels
// itself.
#include "filters/io/cube/sky_levels.h"

#include <Imath/half.h>
#include <xxhash.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/files/read_file.h"

namespace boxprobe {

namespace {

constexpr std::size_t kKeyLength = 32;
constexpr std::uint32_t kMagic = 0x314c4b53;  // "SKL1"
constexpr int kMostLevels = 13;               // of 4096² faces

struct Head {
  std::uint32_t magic = kMagic;
  char key[kKeyLength] = {};
  std::int32_t faceSize = 0, levels = 0;
  float irradiance[27] = {};
};
static_assert(sizeof(Head) == 4 + kKeyLength + 8 + 27 * 4, "the file has no gaps");

std::size_t texelValues(int faceSize, int levels) {
  std::size_t values = 0;
  for (int level = 0; level < levels; ++level) {
    const auto size = static_cast<std::size_t>(faceSize >> level);
    values += 6 * 4 * size * size;
  }
  return values;
}

bool plausible(const Head& head) {
  return head.magic == kMagic && head.levels >= 1 && head.levels <= kMostLevels && head.faceSize >= 1 &&
         head.faceSize <= 1 << (kMostLevels - 1) && head.faceSize >> (head.levels - 1) >= 1;
}

}  // namespace

std::size_t SkyLevels::offset(int level, int face) const {
  const auto size = static_cast<std::size_t>(faceSize >> level);
  return texelValues(faceSize, level) + static_cast<std::size_t>(face) * 4 * size * size;
}

std::string skyLevelsFile(const std::string& picture) {
  return std::filesystem::path(picture).replace_extension(".levels").string();
}

bool holdsSkyLevels(const std::string& path, const std::string& key, int faceSize) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return false;
  std::ifstream file(path, std::ios::binary);
  Head head;
  if (!file.read(reinterpret_cast<char*>(&head), sizeof head)) return false;
  return plausible(head) && head.faceSize == faceSize && std::string(head.key, kKeyLength) == key;
}

SkyLevels loadSkyLevels(const std::string& path) {
  const std::string bytes = readWholeFile(path);
  Head head;
  const auto damaged = [&] { return InputError(path + ": is damaged; install it again"); };
  std::uint64_t sum = 0;
  if (bytes.size() < sizeof head + sizeof sum) throw damaged();
  std::memcpy(&head, bytes.data(), sizeof head);
  if (!plausible(head)) throw damaged();
  const std::size_t values = texelValues(head.faceSize, head.levels), content = sizeof head + 2 * values;
  if (bytes.size() != content + sizeof sum) throw damaged();
  std::memcpy(&sum, bytes.data() + content, sizeof sum);
  if (sum != XXH3_64bits(bytes.data(), content)) throw damaged();

  SkyLevels result;
  result.key.assign(head.key, kKeyLength);
  result.faceSize = head.faceSize;
  result.levels = head.levels;
  for (std::size_t i = 0; i < 27; ++i) result.irradiance[i / 3][static_cast<int>(i % 3)] = head.irradiance[i];
  result.texels.resize(values);
  std::memcpy(result.texels.data(), bytes.data() + sizeof head, 2 * values);
  return result;
}

void saveSkyLevels(const std::string& path, const std::string& key, const BakedMaps& maps) {
  Head head;
  if (key.size() != kKeyLength)
    throw WorkError(path + ": not written: the key has " + std::to_string(key.size()) + " characters");
  std::memcpy(head.key, key.data(), kKeyLength);
  head.faceSize = maps.radiance.faceSize();
  head.levels = maps.radiance.levels();
  for (std::size_t i = 0; i < 27; ++i) head.irradiance[i] = maps.irradiance[i / 3][static_cast<int>(i % 3)];
  std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
  for (int level = 0; level < head.levels; ++level) {
    const auto size = static_cast<std::size_t>(maps.radiance.levelSize(level));
    for (int face = 0; face < 6; ++face) {
      const float* rgba = maps.radiance.face(level, face);
      for (std::size_t i = 0; i < 4 * size * size; ++i) {
        const std::uint16_t bits = half(rgba[i]).bits();
        bytes.append(reinterpret_cast<const char*>(&bits), sizeof bits);
      }
    }
  }
  const std::uint64_t sum = XXH3_64bits(bytes.data(), bytes.size());
  bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  writeTextAtomically(path, bytes);
}

}  // namespace boxprobe
