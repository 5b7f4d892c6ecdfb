// Sizes of pictures to the last pixel that is read, their kinds by their bytes, Radiance's headers line by line, and
// how OpenEXR's planes are written.
#include <OpenEXR/ImfCompression.h>
#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <functional>

#include "filters/io/image/exr_writer.h"
#include "filters/io/image/image_detail.h"
#include "filters/io/image/radiance_reader.h"
#include "tests/unit/error_text.h"

namespace boxprobe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(PictureLimits, EndWhereTheyAreSaidTo) {
  EXPECT_NO_THROW(checkImageSize("a", 32768, 4096));
  EXPECT_NO_THROW(checkImageSize("a", 1, 32768));
  EXPECT_EQ(errorText([] { checkImageSize("a", 0, 5); }), "a: has no pixels; save it again");
  EXPECT_EQ(errorText([] { checkImageSize("a", 5, 0); }), "a: has no pixels; save it again");
  EXPECT_EQ(errorText([] { checkImageSize("a", 32769, 1); }), "a: is 32769 x 1 pixels; at most 32768 a side are read");
  EXPECT_EQ(errorText([] { checkImageSize("a", 2, 32769); }), "a: is 2 x 32769 pixels; at most 32768 a side are read");
  EXPECT_EQ(errorText([] { checkImageSize("a", 32768, 4097); }),
            "a: is 32768 x 4097 pixels; at most 134217728 in all are read");
  EXPECT_NO_THROW(checkEncodedSize("a", 100, 60, 6, 1000));
  EXPECT_NO_THROW(checkEncodedSize("a", 1, 6999, 6, 1000));
  EXPECT_EQ(errorText([] { checkEncodedSize("a", 100, 70, 6, 1000); }),
            "a: is damaged: 100 x 70 pixels are promised in 6 bytes; save it again");
  EXPECT_NO_THROW(checkPixelCount("a", 3, 2, 24));
  EXPECT_EQ(errorText<WorkError>([] { checkPixelCount("a", 3, 2, 25); }),
            "a: not written: 3 x 2 pixels do not match 25 values");
  EXPECT_EQ(errorText<WorkError>([] { checkPixelCount("a", 0, 2, 0); }),
            "a: not written: 0 x 2 pixels do not match 0 values");
  EXPECT_EQ(errorText<WorkError>([] { checkPixelCount("a", 2, 0, 0); }),
            "a: not written: 2 x 0 pixels do not match 0 values");
}

/// A PNG's first 29 bytes: the decoders ask for no more to know its size.
std::string pngHead(std::uint32_t width, std::uint32_t height) {
  std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
  for (const std::uint32_t number : {width, height}) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 255u);
  }
  return bytes + std::string("\x08\x06\0\0\0", 5);
}

TEST(PictureLimits, OfEncodedPictures) {
  const auto said = [](const std::string& bytes) {
    return errorText([&] { decodeImage8(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), "a"); });
  };
  EXPECT_EQ(said(pngHead(40000, 3)), "a: is 40000 x 3 pixels; at most 32768 a side are read");
  EXPECT_EQ(said(pngHead(3, 0x01020304)), "a: is 3 x 16909060 pixels; at most 32768 a side are read");
  EXPECT_EQ(said(pngHead(40000, 3).substr(0, 23)), "a: is not a PNG, JPEG or WebP picture; save it as one of these");
  EXPECT_EQ(said(""), "a: is not a PNG, JPEG or WebP picture; save it as one of these");
  EXPECT_EQ(said(std::string("\xabKTX 20\xbb", 8)),
            "a: is a KTX2 picture, which is not read; save it as PNG (gltf-transform ktxdecompress IN OUT)");
  EXPECT_EQ(said(std::string("\xabKTX 20\xba", 8)), "a: is not a PNG, JPEG or WebP picture; save it as one of these");
  EXPECT_EQ(said(std::string("RIFF\4\0\0\0WEBP", 12)), "a: is a damaged WebP picture; save it again");
  // Of a PNG's byte at most 8256 pixels. The first header fits its 400 bytes, and is damaged further on: the library
  // looks as far as the chunk of pixels.
  std::string large = pngHead(8256, 400) + std::string("\0\0\0\0\0\0\1\0IDAT", 12);
  large.resize(400, '\0');
  EXPECT_THAT(said(large), HasSubstr("a: is damaged ("));
  large.pop_back();
  EXPECT_EQ(said(large), "a: is damaged: 8256 x 400 pixels are promised in 399 bytes; save it again");
}

/// A TGA without compression, which stb reads.
std::string tga(int width, int height, int bytesPerPixel) {
  std::string bytes(18, '\0');
  bytes[2] = 2;
  bytes[12] = static_cast<char>(width);
  bytes[14] = static_cast<char>(height);
  bytes[16] = static_cast<char>(8 * bytesPerPixel);
  bytes[17] = bytesPerPixel == 4 ? 0x28 : 0x20;  // rows from the top
  for (int i = 0; i < width * height * bytesPerPixel; ++i) bytes += static_cast<char>(3 + 7 * i);
  return bytes;
}

TEST(OtherPictures, AreReadByTheirBytes) {
  for (const int channels : {3, 4}) {
    const std::string bytes = tga(3, 2, channels);
    bool alpha = channels == 3;
    const ImageRgba8 image =
        decodeImage8(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), "b", &alpha);
    EXPECT_EQ(image.name, "b");
    EXPECT_EQ(image.width, 3);
    EXPECT_EQ(image.height, 2);
    EXPECT_EQ(alpha, channels == 4);
    ASSERT_EQ(image.pixels.size(), 24u);
    for (std::size_t i = 0; i < 6; ++i) {
      const auto stored = [&](std::size_t c) {
        return static_cast<std::uint8_t>(3 + 7 * (i * std::size_t(channels) + c));
      };
      EXPECT_EQ(image.pixels[4 * i], stored(2));
      EXPECT_EQ(image.pixels[4 * i + 1], stored(1));
      EXPECT_EQ(image.pixels[4 * i + 2], stored(0));
      EXPECT_EQ(image.pixels[4 * i + 3], channels == 4 ? stored(3) : 255);
    }
  }
}

TEST(RadianceHeader, WhatIsNotFollowedIsSaid) {
  const auto remarks = [](const std::string& lines, const char* format = "32-bit_rle_rgbe") {
    return decodeRadiance("#?RADIANCE\nFORMAT=" + std::string(format) + "\n" + lines + "\n-Y 1 +X 1\n\x80\x40\x20\x81",
                          "a.hdr")
        .remarks;
  };
  EXPECT_THAT(
      remarks("EXPOSURE = 2\nCOLORCORR\t=1 2 3\nPRIMARIES=.7 .3 .2 .7 .1 .1 .3 .3\nGAMMA=1\n#GAMMA=2\nVIEW=-vtv\n"),
      IsEmpty());
  EXPECT_THAT(remarks("GAMMA=2.2\n"), ElementsAre("GAMMA=2.2 is not followed: its values are taken as linear"));
  EXPECT_THAT(remarks("GAMMA=x\n"), ElementsAre("GAMMA=x is not followed: its values are taken as linear"));
  EXPECT_THAT(remarks("EXPOSURE=-2\n"), ElementsAre("EXPOSURE=-2 is not followed: positive numbers are needed"));
  EXPECT_THAT(remarks("EXPOSURE=1e200\nEXPOSURE=1e200\n"),
              ElementsAre("EXPOSURE=1e200 is not followed: positive numbers are needed"));
  EXPECT_THAT(remarks("COLORCORR=1 0 1\nCOLORCORR=1 1 -1\n"),
              ElementsAre("COLORCORR=1 0 1 is not followed: positive numbers are needed",
                          "COLORCORR=1 1 -1 is not followed: positive numbers are needed"));
  const std::string wanted = " is not followed: eight chromaticities that span colours are needed";
  EXPECT_THAT(remarks("PRIMARIES=1 2 3\n"), ElementsAre("PRIMARIES=1 2 3" + wanted));
  EXPECT_THAT(remarks("PRIMARIES=.3 .3 .3 .3 .3 .3 .3 .3\n"),
              ElementsAre("PRIMARIES=.3 .3 .3 .3 .3 .3 .3 .3" + wanted));
  EXPECT_THAT(remarks("PRIMARIES=.7 .3 .2 .7 .1 .1 .3 .3\n", "32-bit_rle_xyze "),
              ElementsAre("PRIMARIES is not followed: the values are XYZ"));
  EXPECT_THAT(remarks("GAMMA=" + std::string(200, 'x') + "\n"),
              ElementsAre("GAMMA=" + std::string(80, 'x') + " is not followed: its values are taken as linear"));
  // Red, green and blue have primaries of their own.
  const ImageRgbaF image =
      decodeRadiance(
          "#?RADIANCE\nPRIMARIES=.61 .31 .25 .65 .18 .09 .4476 .4074\nEXPOSURE=2\n\n-Y 1 +X 1\n\x80\x40\x20\x81", "a")
          .image;
  EXPECT_NEAR(image.pixels[0], 0.5 * (1.541294651 - 0.5 * 0.534578949 - 0.25 * 0.006715702), 1e-6);
  EXPECT_NEAR(image.pixels[1], 0.5 * (0.029835645 + 0.5 * 0.970670973 - 0.25 * 0.000506618), 1e-6);
  EXPECT_NEAR(image.pixels[2], 0.5 * (0.348449187 + 0.5 * 0.112794523 + 0.25 * 0.538756290), 1e-6);
}

TEST(RadianceHeader, TheSizeIsReadStrictly) {
  const auto size = [](const std::string& line) {
    try {
      const ImageRgbaF image = decodeRadiance("#?RADIANCE\n\n" + line + "\n" + std::string(24, '\x80'), "a").image;
      return std::to_string(image.width) + "x" + std::to_string(image.height);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(size("-Y 2 +X 3"), "3x2");
  EXPECT_EQ(size("  -Y   2   +X   3  "), "3x2");
  EXPECT_EQ(size("+X 3 -Y 2"), "3x2");
  for (const std::string line : {"-Y 2", "-Y 2 +X", "-Y2 +X 3", "-Y 2 +Y 3", "-Y 2 +Z 3", "*Y 2 +X 3", "-Y 2 X 3",
                                 "-Y -2 +X 3", "-Y 2 +X 3 4", "-Y two +X 3", "-Y 2 +X 99999999999999999999"}) {
    EXPECT_EQ(size(line), "a: is damaged (\"" + line + "\" is no size such as -Y 512 +X 1024); save it again");
  }
  EXPECT_EQ(size("-Y 0 +X 3"), "a: has no pixels; save it again");
  EXPECT_EQ(size(std::string(50, 'x')),
            "a: is damaged (\"" + std::string(40, 'x') + "\" is no size such as -Y 512 +X 1024); save it again");
}

TEST(ExrWriter, PlanesAreAsTheyWereGiven) {
  const std::vector<float> values = {1.0f, 70000.0f, -1e9f, 0.1f, 2.0f, 3.0f, 4.0f, 5.0f};
  ExrLevel level{2, 2, {}};
  addPlane(level, "half", values.data() + 1, 2, ExrPrecision::Half);
  addPlane(level, "float", values.data(), 2, ExrPrecision::Float);
  ASSERT_EQ(level.planes.size(), 2u);
  EXPECT_EQ(level.planes[0].channel, "half");
  EXPECT_THAT(level.planes[0].floats, IsEmpty());
  EXPECT_THAT(level.planes[0].halves, ElementsAre(half(65504.0f), half(0.1f), half(3.0f), half(5.0f)));
  EXPECT_THAT(level.planes[1].floats, ElementsAre(1.0f, -1e9f, 2.0f, 4.0f));
  EXPECT_THAT(level.planes[1].halves, IsEmpty());
  const ExrPart part = exrPart(7, 3);
  EXPECT_EQ(part.header.dataWindow(), Imath::Box2i({0, 0}, {6, 2}));
  EXPECT_EQ(part.levels.at(0).width, 7);
  EXPECT_EQ(part.levels.at(0).height, 3);
}

/// 64 x 768 texels: grain of a few percent in the rows asked for, black in the others.
ExrLevel grainWhere(const std::function<bool(int row)>& grain) {
  constexpr int kGrainWidth = 64, kGrainHeight = 768;
  ExrLevel level{kGrainWidth, kGrainHeight, {}};
  std::vector<float> values;
  unsigned state = 1;
  for (int y = 0; y < kGrainHeight; ++y) {
    for (int x = 0; x < kGrainWidth; ++x) {
      state = state * 1664525u + 1013904223u;
      const float noise = static_cast<float>(state >> 8) / 16777216.0f;
      const float smooth = 1.6f + std::sin(0.02f * static_cast<float>(x)) + std::cos(0.03f * static_cast<float>(y));
      values.push_back(grain(y) ? smooth * (1.0f + 0.04f * (noise - 0.5f)) : 0.0f);
    }
  }
  for (const char* channel : {"R", "G", "B"}) addPlane(level, channel, values.data(), 1, ExrPrecision::Half);
  return level;
}

// Of a large picture it is chosen by 32 rows in the middle of each sixth. Such grain is smaller by ZIP, black by PIZ.
TEST(ExrWriter, CompressionIsChosenBySixBands) {
  const auto inBand = [](int row) { return row % 128 >= 48 && row % 128 < 80; };
  EXPECT_EQ(chooseCompression(grainWhere([&](int row) { return inBand(row); })), Imf::ZIP_COMPRESSION);
  EXPECT_EQ(chooseCompression(grainWhere([&](int row) { return !inBand(row); })), Imf::PIZ_COMPRESSION);
  for (const int odd : {0, 5}) {
    EXPECT_EQ(chooseCompression(grainWhere([&](int row) { return inBand(row) && row / 128 != odd; })),
              Imf::ZIP_COMPRESSION)
        << odd;
  }
}

}  // namespace
}  // namespace boxprobe
