// Headers of OpenEXR files, byte by byte: those that promise just as much as a file can hold, and a byte more.
#include <gmock/gmock.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "filters/io/image/exr_header_check.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

/// A header's bytes, as "OpenEXR File Layout" has them.
struct HeaderBytes {
  std::string bytes;
  template <typename Number>
  static std::string of(Number number) {
    return std::string(reinterpret_cast<const char*>(&number), sizeof number);
  }
  HeaderBytes() : bytes(of(std::uint32_t(20000630)) + of(std::uint32_t(2))) {}
  HeaderBytes& add(const std::string& name, const std::string& type, const std::string& value) {
    bytes += name + '\0' + type + '\0' + of(static_cast<std::int32_t>(value.size())) + value;
    return *this;
  }
  HeaderBytes& window(int minX, int minY, int maxX, int maxY) {
    return add("dataWindow", "box2i", of(minX) + of(minY) + of(maxX) + of(maxY));
  }
  static std::string channel(const std::string& name, std::int32_t type, std::int32_t stepX = 1,
                             std::int32_t stepY = 1) {
    return name + '\0' + of(type) + of(std::int32_t(0)) + of(stepX) + of(stepY);
  }
  HeaderBytes& channels(const std::string& list) { return add("channels", "chlist", list + '\0'); }
  HeaderBytes& compression(int kind) {
    return add("compression", "compression", std::string(1, static_cast<char>(kind)));
  }
  HeaderBytes& end() {
    bytes += '\0';
    return *this;
  }
};

class ExrHeaderCheck : public TemporaryFolder {
 protected:
  /// What is said of the header in a file of so many bytes; empty: it may be read.
  std::string said(const HeaderBytes& header, std::size_t size = 0) const {
    std::string bytes = header.bytes;
    EXPECT_TRUE(size == 0 || bytes.size() <= size);
    if (size > 0) bytes.resize(size, '\0');
    const std::string path = write("h.exr", bytes);
    try {
      checkExrHeader(path);
      return "";
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.rfind(path + ": ", 0), 0u) << text;
      return text.substr(path.size() + 2);
    }
  }
};

TEST_F(ExrHeaderCheck, EachTypeFillsItsBytes) {
  const std::pair<int, std::vector<std::string>> rows[] = {
      {1, {"compression", "deepImageState", "envmap", "lineOrder"}},
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
  for (const auto& [size, types] : rows) {
    for (const std::string& type : types) {
      for (const int given : {size - 1, size, size + 1}) {
        const HeaderBytes header =
            HeaderBytes().add("x", type, std::string(static_cast<std::size_t>(given), '\0')).end();
        EXPECT_EQ(said(header), given == size ? ""
                                              : "is damaged: attribute x of type " + type + " does not fill its " +
                                                    std::to_string(given) + " bytes; save it again")
            << type;
      }
    }
  }
  EXPECT_EQ(said(HeaderBytes().add("x", "string", "abc").add("y", "unknown", "").end()), "");
}

TEST_F(ExrHeaderCheck, ListsFillTheirBytes) {
  const auto of = [](auto number) { return HeaderBytes::of(number); };
  using U = std::uint32_t;
  using I = std::int32_t;
  const std::string one = of(I(2)) + "ab", none = of(I(0));
  const std::string channel = HeaderBytes::channel("R", 1);
  struct Row {
    const char* type;
    std::string value;
    bool sound;
  };
  const Row rows[] = {{"floatvector", std::string(8, 'x'), true},
                      {"floatvector", std::string(9, 'x'), false},
                      {"preview", of(U(2)) + of(U(3)) + std::string(24, 'x'), true},
                      {"preview", of(U(2)) + of(U(3)) + std::string(25, 'x'), false},
                      {"preview", of(U(0)) + of(U(3)), true},
                      {"preview", of(U(32769)) + of(U(0)), false},
                      {"preview", of(U(32768)) + of(U(0)), true},
                      {"preview", of(U(0)) + of(U(32769)), false},
                      {"stringvector", "", true},
                      {"stringvector", one + none + one, true},
                      {"stringvector", one + "c", false},
                      {"stringvector", of(I(3)) + "ab", false},
                      {"stringvector", of(I(-1)) + "ab", false},
                      {"idmanifest", "abc", false},
                      {"idmanifest", of(U(1032 * 4)), true},
                      {"idmanifest", of(U(1032 * 4 + 1)), false},
                      {"chlist", std::string(1, '\0'), true},
                      {"chlist", channel + '\0', true},
                      {"chlist", channel, false},
                      {"chlist", channel + '\0' + 'x', false},
                      {"chlist", channel + "G", false},
                      {"chlist", "", false}};
  for (const Row& row : rows) {
    const std::string text = said(HeaderBytes().add("x", row.type, row.value).end());
    EXPECT_EQ(text, row.sound ? ""
                              : std::string("is damaged: attribute x of type ") + row.type + " does not fill its " +
                                    std::to_string(row.value.size()) + " bytes; save it again")
        << row.type << " " << row.value.size();
  }
}

TEST_F(ExrHeaderCheck, AttributesEndInTheFile) {
  HeaderBytes header = HeaderBytes().add("long", "string", "abcdef");
  const std::size_t size = header.bytes.size();
  EXPECT_EQ(said(header), "") << "cut off behind it, which the library says";
  header.bytes.resize(size - 1);
  const auto promised = [&](const char* bytes) {
    return std::string("is damaged: attribute long is said to have ") + bytes + " bytes, but the file has " +
           std::to_string(header.bytes.size()) + " bytes; save it again";
  };
  EXPECT_EQ(said(header), promised("6"));
  header = HeaderBytes();
  header.bytes += std::string("long\0string\0", 12) + HeaderBytes::of(std::int32_t(-1)) + "abc";
  EXPECT_EQ(said(header), promised("-1"));
  header.bytes[0] = 'x';
  EXPECT_EQ(said(header), "") << "no OpenEXR file, which is said elsewhere";
  EXPECT_EQ(said(HeaderBytes().end()), "");
}

/// Each compression's files of 4000 bytes and of one less, for exactly as many pixels as they may promise.
TEST_F(ExrHeaderCheck, PixelsOfEachCompressionFitTheFile) {
  const int ratios[] = {1, 64, 1032, 1032, 512, 1376, 11, 11, 132096, 132096};
  for (int kind = 0; kind < 10; ++kind) {
    // Two halves and a float a pixel: 8 bytes. One channel has fewer samples, which is not counted.
    const int height = ratios[kind] > 10000 ? 16512 : ratios[kind], width = 500 * (ratios[kind] / height);
    const HeaderBytes header =
        HeaderBytes()
            .window(-3, 5, width - 4, height + 4)
            .channels(HeaderBytes::channel("A", 1) + HeaderBytes::channel("B", 1) + HeaderBytes::channel("C", 2) +
                      HeaderBytes::channel("D", 2, 2, 1) + HeaderBytes::channel("E", 2, 1, 2))
            .compression(kind)
            .end();
    EXPECT_EQ(said(header, 4000), "") << kind;
    EXPECT_EQ(said(header, 3999), "is damaged: " + std::to_string(width) + " x " + std::to_string(height) +
                                      " pixels are promised, but the file has 3999 bytes; save it again")
        << kind;
  }
  const HeaderBytes unknown =
      HeaderBytes().window(0, 0, 4999, 4999).channels(HeaderBytes::channel("A", 0)).compression(10).end();
  EXPECT_EQ(said(unknown, 4000), "") << "a compression of later versions";
}

TEST_F(ExrHeaderCheck, OffsetsOfAllBlocksFitTheFile) {
  const auto refused = [](int blocks, int bytes) {
    return "is damaged: the offsets of " + std::to_string(blocks) + " blocks are promised, but the file has " +
           std::to_string(bytes) + " bytes; save it again";
  };
  const auto tiles = [](std::uint32_t width, std::uint32_t height) {
    return HeaderBytes::of(width) + HeaderBytes::of(height) + '\0';
  };
  // 1000 x 700 in tiles of 16 x 32: 63 x 22.
  HeaderBytes tiled = HeaderBytes().window(0, 0, 999, 699).add("tiles", "tiledesc", tiles(16, 32)).end();
  EXPECT_EQ(said(tiled, 63 * 22 * 8), "");
  EXPECT_EQ(said(tiled, 63 * 22 * 8 - 1), refused(63 * 22, 63 * 22 * 8 - 1));
  // Without tiles at most 256 lines in a block: 32513 lines are 128 blocks.
  for (const auto& size : {tiles(0, 32), tiles(16, 0)}) {
    const HeaderBytes lines = HeaderBytes().window(7, -4, 7, 32508).add("tiles", "tiledesc", size).end();
    EXPECT_EQ(said(lines, 1024), "");
    EXPECT_EQ(said(lines, 1023), refused(128, 1023));
  }
  const HeaderBytes counted =
      HeaderBytes().window(0, 0, 9, 9).add("chunkCount", "int", HeaderBytes::of(std::int32_t(40))).end();
  EXPECT_EQ(said(counted, 320), "");
  EXPECT_EQ(said(counted, 319), refused(40, 319));
  EXPECT_EQ(said(HeaderBytes().window(5, 0, 4, 9).end()), "") << "an empty window, which the library refuses";
  EXPECT_EQ(said(HeaderBytes().window(0, 5, 9, 4).end()), "");
  EXPECT_EQ(said(HeaderBytes().window(-1, 0, 32767, 0).end()), "is 32769 x 1 pixels; at most 32768 a side are read");
}

TEST_F(ExrHeaderCheck, EveryPartIsLookedAt) {
  HeaderBytes parts;
  parts.bytes[5] = 0x10;  // several parts
  parts.window(0, 0, 9, 9).end();
  const std::string first = parts.bytes;
  parts.window(-1, 0, 32767, 0).end().end();
  EXPECT_EQ(said(parts), "is 32769 x 1 pixels; at most 32768 a side are read");
  parts.bytes[5] = 0;
  EXPECT_EQ(said(parts), "") << "of one part nothing follows";
  parts.bytes = first;
  parts.end().window(-1, 0, 32767, 0).end();
  EXPECT_EQ(said(parts), "") << "behind the last part";
}

}  // namespace
}  // namespace boxprobe
