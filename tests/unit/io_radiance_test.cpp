// Radiance pictures by their headers: files are written here byte by byte, so that every value is known.
#include <array>
#include <cstdint>

#include "filters/io/image/image_file.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

constexpr int kWidth = 16, kHeight = 9;
using Pixel = std::array<std::uint8_t, 4>;

/// Column x, row y from the top: no symmetry, and rows hold runs.
Pixel pixelAt(int x, int y) {
  const int step = x / 4;
  return {static_cast<std::uint8_t>(128 + 5 * step + 3 * y), static_cast<std::uint8_t>(1 + 21 * step + 2 * y),
          static_cast<std::uint8_t>(200 - 9 * y), static_cast<std::uint8_t>(126 + step)};
}

/// A mantissa over 256, times 2^(exponent - 128).
float valueOf(const Pixel& pixel, int channel) {
  return static_cast<float>(pixel[static_cast<std::size_t>(channel)] / 256.0 * std::pow(2.0, pixel[3] - 128.0));
}

std::string flatLine(const std::vector<Pixel>& line) {
  std::string bytes;
  for (const Pixel& pixel : line) bytes.append(pixel.begin(), pixel.end());
  return bytes;
}

std::string oldRuns(const std::vector<Pixel>& line) {
  std::string bytes;
  for (std::size_t i = 0; i < line.size();) {
    std::size_t count = 1;
    while (i + count < line.size() && line[i + count] == line[i]) ++count;
    bytes.append(line[i].begin(), line[i].end());
    for (std::size_t rest = count - 1; rest > 0; rest >>= 8)
      bytes += std::string("\1\1\1") + static_cast<char>(rest & 255);
    i += count;
  }
  return bytes;
}

std::string newRuns(const std::vector<Pixel>& line) {
  std::string bytes{'\2', '\2', static_cast<char>(line.size() >> 8), static_cast<char>(line.size() & 255)};
  for (std::size_t channel = 0; channel < 4; ++channel) {
    for (std::size_t i = 0; i < line.size();) {
      std::size_t count = 1;
      while (count < 100 && i + count < line.size() && line[i + count][channel] == line[i][channel]) ++count;
      bytes += count > 1 ? static_cast<char>(128 + count) : '\1';
      bytes += static_cast<char>(line[i][channel]);
      i += count;
    }
  }
  return bytes;
}

using LineWriter = std::string (*)(const std::vector<Pixel>&);

/// The picture in an order such as "-Y +X".
std::string pictureIn(const std::string& order, LineWriter writeLine) {
  const bool columnsFirst = order[1] == 'X';
  const int lines = columnsFirst ? kWidth : kHeight, length = columnsFirst ? kHeight : kWidth;
  const auto signOf = [&](char axis) { return order[order.find(axis) - 1]; };
  std::string bytes =
      order.substr(0, 2) + " " + std::to_string(lines) + " " + order.substr(3) + " " + std::to_string(length) + "\n";
  for (int i = 0; i < lines; ++i) {
    std::vector<Pixel> line;
    for (int j = 0; j < length; ++j) {
      const int x = columnsFirst ? i : j, y = columnsFirst ? j : i;
      line.push_back(pixelAt(signOf('X') == '+' ? x : kWidth - 1 - x, signOf('Y') == '-' ? y : kHeight - 1 - y));
    }
    bytes += writeLine(line);
  }
  return bytes;
}

const std::string kHead = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n";

class RadianceFile : public TemporaryFolder {
 protected:
  /// The largest difference from what the pixels say, converted by `expected` (the texel's own light by default).
  template <typename Expected>
  double worst(const std::string& bytes, const Expected& expected) {
    const ImageRgbaF image = loadHdrImage(write("a.hdr", bytes));
    EXPECT_EQ(image.width, kWidth);
    EXPECT_EQ(image.height, kHeight);
    double most = 0.0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const Pixel pixel = pixelAt(x, y);
        const std::array<double, 3> light = {valueOf(pixel, 0), valueOf(pixel, 1), valueOf(pixel, 2)};
        const std::array<double, 3> right = expected(light);
        for (std::size_t c = 0; c < 3; ++c) {
          const double read =
              image.pixels[4 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)) + c];
          most = std::max(most, std::fabs(read - right[c]));
        }
      }
    }
    return most;
  }
  double worst(const std::string& bytes) {
    return worst(bytes, [](const std::array<double, 3>& light) { return light; });
  }
  double worstBy(const std::string& header, const double (&matrix)[3][3]) {
    return worst(header + pictureIn("-Y +X", newRuns), [&](const std::array<double, 3>& light) {
      std::array<double, 3> out{};
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) out[r] += matrix[r][c] * light[c];
      }
      return out;
    });
  }
};

TEST_F(RadianceFile, EveryOrderOfLinesByEveryKindOfRuns) {
  for (const char* order : {"-Y +X", "-Y -X", "+Y +X", "+Y -X", "+X -Y", "+X +Y", "-X -Y", "-X +Y"}) {
    for (const LineWriter writeLine : {&flatLine, &oldRuns, &newRuns}) {
      EXPECT_EQ(worst(kHead + "\n" + pictureIn(order, writeLine)), 0.0) << order;
    }
  }
}

// Filament 1937, loaders.gl 3327: without runs, and the first bytes of a line look like the head of some.
TEST_F(RadianceFile, PixelsThatLookLikeRuns) {
  for (const Pixel& first : {Pixel{2, 2, 3, 140}, Pixel{2, 2, 0, 16}, Pixel{1, 1, 1, 140}}) {
    std::string pixels = flatLine(std::vector<Pixel>(16 * 8, Pixel{128, 64, 32, 129}));
    pixels.replace(4 * 16 * 2, 4, std::string(first.begin(), first.end()));  // the first of the third line
    write("a.hdr", kHead + "\n-Y 8 +X 16\n" + pixels);
    const ImageRgbaF image = loadHdrImage(file("a.hdr"));
    for (std::size_t i = 0; i < 16 * 8; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const float right = valueOf(i == 16 * 2 ? first : Pixel{128, 64, 32, 129}, static_cast<int>(c));
        ASSERT_EQ(image.pixels[4 * i + c], right) << i << " of " << int(first[0]) << " " << int(first[3]);
      }
    }
  }
}

TEST_F(RadianceFile, OldRunsAbove255RepeatInTurn) {
  // 1 + 231 + 3 * 256 = 1000 pixels, then a second line of its own colour.
  const std::string line{"\x80\x40\x20\x81\1\1\1\xe7\1\1\1\3"}, other{"\x90\x50\x30\x82\1\1\1\xe7\1\1\1\3"};
  write("a.hdr", kHead + "\n-Y 2 +X 1000\n" + line + other);
  const ImageRgbaF image = loadHdrImage(file("a.hdr"));
  ASSERT_EQ(image.width, 1000);
  for (std::size_t i = 0; i < 2000; ++i) ASSERT_EQ(image.pixels[4 * i], i < 1000 ? 1.0f : 2.25f) << i;
}

TEST_F(RadianceFile, HeadersOfOtherPrograms) {
  const std::string picture = pictureIn("-Y +X", newRuns);
  EXPECT_EQ(worst("#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n" + picture), 0.0);
  EXPECT_EQ(worst("#?RADIANCE\n\n" + picture), 0.0) << "no FORMAT";
  EXPECT_EQ(worst(kHead + "# " + std::string(3000, 'c') + "\nSOFTWARE=x\nVIEW=-vtv -vh 90\nGAMMA=1\n\n" + picture),
            0.0);
  EXPECT_EQ(worst(kHead + "PRIMARIES=0 0 0 0 0 0 0 0\n\n" + picture), 0.0);
  EXPECT_EQ(worst(kHead + "PRIMARIES=.64 .33 .3 .6 .15 .06 .3127 .329\n\n" + picture), 0.0);
  std::string windows = "#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n" + picture;
  windows.insert(windows.find('\n', windows.find("+X")), "\r");
  EXPECT_EQ(worst(windows), 0.0);
}

TEST_F(RadianceFile, WhatValuesWereMultipliedByIsDividedOut) {
  const auto divided = [](double r, double g, double b) {
    return [=](const std::array<double, 3>& light) {
      return std::array<double, 3>{light[0] / r, light[1] / g, light[2] / b};
    };
  };
  const std::string picture = "\n" + pictureIn("-Y +X", newRuns);
  EXPECT_LT(worst(kHead + "EXPOSURE=4\n" + picture, divided(4, 4, 4)), 1e-7);
  EXPECT_LT(worst(kHead + "EXPOSURE=2\nEXPOSURE= 1.5\n" + picture, divided(3, 3, 3)), 1e-7);
  EXPECT_LT(worst(kHead + "COLORCORR=1 2 .5\nCOLORCORR= 3 1 1\nEXPOSURE=2\n" + picture, divided(6, 4, 1)), 1e-7);
  EXPECT_EQ(worst(kHead + "EXPOSURE=0\nEXPOSURE=-1\nEXPOSURE=nan\nCOLORCORR=1 2\n" + picture), 0.0);
}

TEST_F(RadianceFile, PrimariesAndXyzAreConverted) {
  // ITU-R BT.2087, BT.2020 to BT.709; the Academy's AP0 to Rec. 709 with Bradford (OpenColorIO-Configs, aces_1.0.3);
  // XYZ to sRGB (Lindbloom).
  const double from2020[3][3] = {
      {1.660491, -0.587641, -0.072850}, {-0.124550, 1.132900, -0.008349}, {-0.018151, -0.100579, 1.118730}};
  const double fromAp0[3][3] = {
      {2.521686, -1.134131, -0.387555}, {-0.276480, 1.372719, -0.096239}, {-0.015378, -0.152975, 1.168353}};
  const double fromXyz[3][3] = {
      {3.2404542, -1.5371385, -0.4985314}, {-0.9692660, 1.8760108, 0.0415560}, {0.0556434, -0.2040259, 1.0572252}};
  EXPECT_LT(worstBy(kHead + "PRIMARIES=.708 .292 .17 .797 .131 .046 .3127 .329\n\n", from2020), 1e-4);
  EXPECT_LT(worstBy(kHead + "PRIMARIES=.7347 .2653 0 1 .0001 -.077 .32168 .33767\n\n", fromAp0), 4e-4);
  EXPECT_LT(worstBy("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n", fromXyz), 4e-3);  // its white differs in the fourth digit
}

TEST_F(RadianceFile, DamageIsOneLine) {
  const auto problem = [this](const std::string& bytes) {
    return errorText([&] { loadHdrImage(write("d.hdr", bytes)); });
  };
  for (const LineWriter writeLine : {&flatLine, &oldRuns, &newRuns}) {
    const std::string whole = kHead + "\n" + pictureIn("-Y +X", writeLine);
    ASSERT_NO_THROW(loadHdrImage(write("d.hdr", whole)));
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const std::string said = problem(whole.substr(0, length));
      ASSERT_EQ(said.rfind(file("d.hdr") + ": ", 0), 0u) << length;
      ASSERT_EQ(said.find('\n'), std::string::npos);
    }
  }
  const std::string size = kHead + "\n-Y 1 +X 16\n";
  const auto said = [](const std::string& what) { return ": is damaged (" + what + "); save it again"; };
  EXPECT_EQ(problem(size + std::string("\2\2\0\x11", 4) + std::string(80, '\x90')),
            file("d.hdr") + said("scan line 1 has 17 pixels in place of 16"));
  EXPECT_EQ(problem(size + std::string("\2\2\0\x10\x91\1", 6)),
            file("d.hdr") + said("the runs of scan line 1 do not fill it"));
  EXPECT_EQ(problem(size + "\1\1\1\5" + std::string(80, '\x90')),
            file("d.hdr") + said("the runs of scan line 1 do not fit it"));
  EXPECT_EQ(problem(size + "\x80\x80\x80\x80\1\1\1\x10"),
            file("d.hdr") + said("the runs of scan line 1 do not fit it"));
  EXPECT_EQ(problem(kHead + "\nhello\n"), file("d.hdr") + said("\"hello\" is no size such as -Y 512 +X 1024"));
  EXPECT_EQ(problem("#?RADIANCE\nFORMAT=8-bit\n\n-Y 1 +X 1\n1234"),
            file("d.hdr") + ": FORMAT=8-bit is not read; save it as 32-bit_rle_rgbe or as .exr");
  EXPECT_EQ(problem("GIF89a"), file("d.hdr") + ": is not a Radiance HDR picture; save it as .exr or .hdr");
  // Rows that are not there take no memory: 2^27 pixels are promised.
  EXPECT_EQ(problem(kHead + "\n-Y 8192 +X 16384\n\x80\x80\x80\x80"),
            file("d.hdr") + said("it ends in scan line 1 of 8192"));
}

}  // namespace
}  // namespace boxprobe
