// Layout of the header: "OpenEXR File Layout" (openexr.com): magic, version, then attributes (name, type, size, value)
// up to an empty name; with the multi-part flag several such lists, up to an empty one.
#include "filters/io/image/exr_header_check.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/image/image_detail.h"

namespace boxprobe {

namespace {

constexpr std::uint32_t kMultiPart = 0x1000;

/// The size that a part claims; the defaults claim nothing.
struct PartSize {
  std::int32_t minX = 0, minY = 0, maxX = -1, maxY = -1;
  std::uint32_t tileWidth = 0, tileHeight = 0;  ///< 0: scan lines
  std::int32_t chunks = 0;
  int compression = 0;
  long long bytesPerPixel = 0;
};

/// Upper bounds of each compression's ratio, in the order of OpenEXR's enumeration: runs of 128 in 2 bytes; deflate's
/// 1032, of floats cut to 24 bits; Huffman with runs of 256 16-bit values in 10 bits; blocks of 16 halves in 3 bytes.
/// DWA at least a half of each 64 values, which deflate makes smaller.
constexpr long long kDwa = 64 * 4 / 2 * 1032;
constexpr std::array<long long, 10> kMostFromAByte = {1, 64, 1032, 1032, 512, 1376, 11, 11, kDwa, kDwa};

/// Sizes of the fixed-size types: the library reads that many bytes whatever the attribute says, and would then be out
/// of step with this reader. 0: another type.
std::int32_t fixedBytes(const std::string& type) {
  struct Row {
    std::int32_t bytes;
    std::vector<std::string> types;
  };
  static const std::vector<Row> rows = {{1, {"compression", "deepImageState", "envmap", "lineOrder"}},
                                        {4, {"float", "int"}},
                                        {8, {"double", "rational", "timecode", "v2f", "v2i"}},
                                        {9, {"tiledesc"}},
                                        {12, {"v3f", "v3i"}},
                                        {16, {"box2f", "box2i", "v2d"}},
                                        {24, {"v3d"}},
                                        {28, {"keycode"}},
                                        {32, {"chromaticities"}},
                                        {36, {"m33f"}},
                                        {64, {"m44f"}},
                                        {72, {"m33d"}},
                                        {128, {"m44d"}}};
  for (const Row& row : rows) {
    if (std::find(row.types.begin(), row.types.end(), type) != row.types.end()) return row.bytes;
  }
  return 0;
}

class HeaderReader {
 public:
  explicit HeaderReader(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    size_ = error ? 0 : static_cast<long long>(size);
  }

  void check() {
    constexpr std::uint32_t kMagic = 20000630;
    if (number<std::uint32_t>() != kMagic) return;
    const auto version = number<std::uint32_t>();
    do {
      checkPart();
    } while (file_ && (version & kMultiPart) != 0 && file_.peek() != 0);
  }

 private:
  template <typename Number>
  Number number() {
    Number value = 0;
    file_.read(reinterpret_cast<char*>(&value), sizeof(value));
    return value;
  }
  std::string text() {
    constexpr std::size_t kLongestName = 255;
    std::string name;
    for (int c = file_.get(); c > 0 && name.size() <= kLongestName; c = file_.get()) name += static_cast<char>(c);
    return name;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(oneLine(path_ + ": is damaged: " + what + ", but the file has " + std::to_string(size_) +
                             " bytes; save it again"));
  }

  void checkPart() {
    PartSize part;
    for (std::string name = text(); file_ && !name.empty(); name = text()) {
      const std::string type = text();
      const auto bytes = number<std::int32_t>();
      if (!file_) return;
      const auto start = static_cast<long long>(file_.tellg());
      if (bytes < 0 || bytes > size_ - start) {
        fail("attribute " + name + " is said to have " + std::to_string(bytes) + " bytes");
      }
      checkValue(name, type, bytes);
      file_.seekg(start);
      readSize(name, type, bytes, part);
      file_.seekg(start + bytes);
    }
    if (file_) checkSize(part);
  }

  /// Types whose values contain their own sizes.
  void checkValue(const std::string& name, const std::string& type, long long bytes) {
    const auto wrong = [&] {
      throw InputError(oneLine(path_ + ": is damaged: attribute " + name + " of type " + type + " does not fill its " +
                               std::to_string(bytes) + " bytes; save it again"));
    };
    if (const std::int32_t fixed = fixedBytes(type); fixed != 0 && fixed != bytes) wrong();
    if (type == "floatvector" && bytes % 4 != 0) wrong();
    const long long end = static_cast<long long>(file_.tellg()) + bytes;
    if (type == "preview") {
      const std::int64_t width = number<std::uint32_t>(), height = number<std::uint32_t>();
      constexpr std::int64_t kLargestSide = 1 << 15;  // keeps the product below in range
      if (width > kLargestSide || height > kLargestSide || 8 + 4 * width * height != bytes) wrong();
    } else if (type == "stringvector") {
      while (file_ && file_.tellg() < end) {
        const auto length = number<std::int32_t>();
        if (length < 0 || length > end - file_.tellg()) wrong();
        file_.seekg(length, std::ios::cur);
      }
      if (file_.tellg() != end) wrong();
    } else if (type == "idmanifest") {
      constexpr std::int64_t kDeflate = 1032;  // its maximum compression ratio
      if (bytes < 4 || number<std::uint32_t>() > kDeflate * bytes) wrong();
    } else if (type == "chlist") {
      constexpr int kChannelBytes = 16;
      // The library reads on until a channel has no name.
      bool ended = false;
      while (file_ && !ended && file_.tellg() < end) {
        ended = text().empty();
        if (!ended) file_.seekg(kChannelBytes, std::ios::cur);
      }
      if (!ended || file_.tellg() != end) wrong();
    }
  }

  void readSize(const std::string& name, const std::string& type, std::int32_t bytes, PartSize& part) {
    if (name == "dataWindow" && type == "box2i" && bytes == 16) {
      part.minX = number<std::int32_t>(), part.minY = number<std::int32_t>();
      part.maxX = number<std::int32_t>(), part.maxY = number<std::int32_t>();
    } else if (name == "tiles" && type == "tiledesc" && bytes == 9) {
      part.tileWidth = number<std::uint32_t>(), part.tileHeight = number<std::uint32_t>();
    } else if (name == "chunkCount" && type == "int" && bytes == 4) {
      part.chunks = number<std::int32_t>();
    } else if (name == "compression" && bytes == 1) {
      part.compression = file_.get();
    } else if (name == "channels" && type == "chlist") {
      part.bytesPerPixel = pixelBytes(bytes);
    }
  }

  /// The sum over the channels; each is a name, its type (1: half, else 4 bytes), 4 bytes of flags and its sampling.
  long long pixelBytes(std::int32_t bytes) {
    long long sum = 0;
    const long long end = static_cast<long long>(file_.tellg()) + bytes;
    while (file_ && file_.tellg() < end && !text().empty()) {
      const auto type = number<std::int32_t>();
      number<std::int32_t>();
      const auto sampling = number<std::int64_t>();
      constexpr std::int64_t kFullResolution = 0x100000001;
      if (sampling == kFullResolution) sum += type == 1 ? 2 : 4;
    }
    return sum;
  }

  void checkSize(const PartSize& part) const {
    const long long width = static_cast<long long>(part.maxX) - part.minX + 1;
    const long long height = static_cast<long long>(part.maxY) - part.minY + 1;
    if (width <= 0 || height <= 0) return;  // the library refuses it
    checkImageSize(path_, width, height);
    const std::string pixels = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    // Every chunk has an offset of 8 bytes; no compression puts more than 256 lines into one.
    const bool tiled = part.tileWidth > 0 && part.tileHeight > 0;
    const long long columns = tiled ? (width + part.tileWidth - 1) / part.tileWidth : 1;
    const long long rowHeight = tiled ? static_cast<long long>(part.tileHeight) : 256;
    const long long chunks = std::max<long long>(columns * ((height + rowHeight - 1) / rowHeight), part.chunks);
    if (8 * chunks > size_) fail("the offsets of " + std::to_string(chunks) + " blocks are promised");
    const auto kind = static_cast<std::size_t>(part.compression);
    const long long ratio = kind < kMostFromAByte.size() ? kMostFromAByte[kind] : 0;
    if (ratio > 0 && width * height * part.bytesPerPixel / ratio > size_) fail(pixels + " are promised");
  }

  std::string path_;
  std::ifstream file_;
  long long size_ = 0;
};

}  // namespace

void checkExrHeader(const std::string& path) {
  HeaderReader(path).check();
}

}  // namespace boxprobe
