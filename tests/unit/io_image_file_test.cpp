// Pictures in and out: exact round trips, every layout that is read, damage told in one line.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "filters/io/image/image_file.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class ImageFile : public TemporaryFolder {};

ImageRgbaF ramp(int width, int height) {
  ImageRgbaF image;
  image.width = width;
  image.height = height;
  for (int i = 0; i < width * height * 4; ++i) image.pixels.push_back(0.37f * static_cast<float>(i) - 5.0f);
  return image;
}

/// A file of other software: the given half or float channels, value = texel index (+ channel index * 100).
void writeOther(const std::string& path, int width, int height, Imf::PixelType type,
                const std::vector<std::string>& channels, bool tiled, const Imath::V2i& corner = {0, 0}) {
  const Imath::Box2i window(corner, corner + Imath::V2i(width - 1, height - 1));
  Imf::Header header(window, window);
  Imf::FrameBuffer buffer;
  const std::size_t texels = static_cast<std::size_t>(width) * height;
  std::vector<std::vector<float>> floats(channels.size(), std::vector<float>(texels));
  std::vector<std::vector<half>> halves(channels.size(), std::vector<half>(texels));
  for (std::size_t c = 0; c < channels.size(); ++c) {
    for (std::size_t i = 0; i < texels; ++i) {
      floats[c][i] = static_cast<float>(i + 100 * c);
      halves[c][i] = half(floats[c][i]);
    }
    header.channels().insert(channels[c], Imf::Channel(type));
    const std::size_t size = type == Imf::HALF ? sizeof(half) : sizeof(float);
    void* base = type == Imf::HALF ? static_cast<void*>(halves[c].data()) : static_cast<void*>(floats[c].data());
    buffer.insert(channels[c], Imf::Slice::Make(type, base, window, size, size * width));
  }
  if (tiled) {
    header.setTileDescription(Imf::TileDescription(4, 4, Imf::ONE_LEVEL));
    Imf::TiledOutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  } else {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(height);
  }
}

TEST_F(ImageFile, PngReadsBackEqual) {
  ImageRgba8 image;
  image.width = 7;
  image.height = 3;
  for (int i = 0; i < 7 * 3 * 4; ++i) image.pixels.push_back(static_cast<std::uint8_t>(i * 13));
  savePng(file("a.png"), image);
  const ImageRgba8 again = loadImage8(file("a.png"));
  EXPECT_EQ(again.width, 7);
  EXPECT_EQ(again.height, 3);
  EXPECT_EQ(again.pixels, image.pixels);
  EXPECT_EQ(entryCount(), 1u);
}

TEST_F(ImageFile, ExrReadsBackEqual) {
  const ImageRgbaF image = ramp(33, 17);
  saveExr(file("a.exr"), image);
  std::size_t notFinite = 9;
  const ImageRgbaF again = loadHdrImage(file("a.exr"), &notFinite);
  EXPECT_EQ(again.width, 33);
  EXPECT_EQ(again.height, 17);
  EXPECT_EQ(again.pixels, image.pixels);
  EXPECT_EQ(notFinite, 0u);
  EXPECT_EQ(entryCount(), 1u);
}

TEST_F(ImageFile, NonFiniteTexelsAreCountedAndZero) {
  ImageRgbaF image = ramp(4, 1);
  image.pixels[5] = std::numeric_limits<float>::quiet_NaN();
  image.pixels[6] = std::numeric_limits<float>::infinity();
  image.pixels[12] = -std::numeric_limits<float>::infinity();
  saveExr(file("a.exr"), image);
  std::size_t notFinite = 0;
  const ImageRgbaF again = loadHdrImage(file("a.exr"), &notFinite);
  EXPECT_EQ(notFinite, 2u);
  EXPECT_EQ(again.pixels[5], 0.0f);
  EXPECT_EQ(again.pixels[6], 0.0f);
  EXPECT_EQ(again.pixels[12], 0.0f);
  EXPECT_EQ(again.pixels[4], image.pixels[4]);
}

TEST_F(ImageFile, ReadsHalfAndFloatScanLinesAndTilesAndWindowsOffTheOrigin) {
  for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
    for (const bool tiled : {false, true}) {
      writeOther(file("o.exr"), 9, 6, type, {"B", "G", "R"}, tiled, {-3, 11});
      const ImageRgbaF image = loadHdrImage(file("o.exr"));
      ASSERT_EQ(image.width, 9);
      ASSERT_EQ(image.height, 6);
      for (std::size_t i = 0; i < 54; ++i) {
        EXPECT_EQ(image.pixels[4 * i + 0], static_cast<float>(i + 200));
        EXPECT_EQ(image.pixels[4 * i + 1], static_cast<float>(i + 100));
        EXPECT_EQ(image.pixels[4 * i + 2], static_cast<float>(i));
        EXPECT_EQ(image.pixels[4 * i + 3], 1.0f);  // no alpha stored
      }
    }
  }
}

TEST_F(ImageFile, LuminanceAloneIsGrey) {
  writeOther(file("y.exr"), 3, 2, Imf::HALF, {"A", "Y"}, false);
  const ImageRgbaF image = loadHdrImage(file("y.exr"));
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(image.pixels[4 * i + c], static_cast<float>(i + 100));
    EXPECT_EQ(image.pixels[4 * i + 3], static_cast<float>(i));
  }
}

TEST_F(ImageFile, ChannelsThatAreNoPictureAreListed) {
  writeOther(file("z.exr"), 3, 2, Imf::FLOAT, {"Z", "id"}, false);
  EXPECT_EQ(errorText([&] { loadHdrImage(file("z.exr")); }),
            file("z.exr") +
                ": part 0 has the channels Z, id; R, G and B, or luminance Y, alone or with RY and BY, are needed");
}

TEST_F(ImageFile, ReadsRadianceHdr) {
  // Two texels without run lengths: (1, 0.5, 0) and (8, 8, 8); value = mantissa / 256 * 2^(exponent - 128).
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
  write("a.hdr", header + std::string("\x80\x40\x00\x81\x80\x80\x80\x84", 8));
  const ImageRgbaF image = loadHdrImage(file("a.hdr"));
  ASSERT_EQ(image.width, 2);
  EXPECT_EQ(image.pixels, (std::vector<float>{1.0f, 0.5f, 0.0f, 1.0f, 8.0f, 8.0f, 8.0f, 1.0f}));
}

TEST_F(ImageFile, DamageIsOneLineThatNamesTheFile) {
  saveExr(file("a.exr"), ramp(64, 64));
  const std::string whole = read("a.exr");
  for (const std::size_t length :
       {std::size_t(0), std::size_t(3), std::size_t(100), whole.size() / 2, whole.size() - 1}) {
    write("cut.exr", whole.substr(0, length));
    EXPECT_EQ(errorText([&] { loadHdrImage(file("cut.exr")); }).rfind(file("cut.exr") + ": ", 0), 0u) << length;
  }
  std::string corrupt = whole;
  for (std::size_t i = whole.size() / 2; i < whole.size() / 2 + 64; ++i) corrupt[i] = static_cast<char>(~corrupt[i]);
  write("bad.exr", corrupt);
  EXPECT_NE(errorText([&] { loadHdrImage(file("bad.exr")); }), "");

  ImageRgba8 picture;
  picture.width = picture.height = 64;
  for (int i = 0; i < 64 * 64 * 4; ++i) picture.pixels.push_back(static_cast<std::uint8_t>(i * i));
  savePng(file("a.png"), picture);
  write("cut.png", read("a.png").substr(0, read("a.png").size() / 2));
  EXPECT_EQ(errorText([&] { loadImage8(file("cut.png")); }).rfind(file("cut.png") + ": is damaged", 0), 0u);
  std::string large = read("a.png");
  large.replace(16, 8, std::string("\x00\x00\xea\x60\x00\x00\xea\x60", 8));
  write("large.png", large);
  EXPECT_EQ(errorText([&] { loadImage8(file("large.png")); }),
            file("large.png") + ": is 60000 x 60000 pixels; at most 32768 a side are read");
  write("text.png", "this is text");
  EXPECT_EQ(errorText([&] { loadImage8(file("text.png")); }),
            file("text.png") + ": is not a PNG, JPEG or WebP picture; save it as one of these");
  write("text.hdr", "this is text");
  EXPECT_NE(errorText([&] { loadHdrImage(file("text.hdr")); }), "");
  write("cut.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 64\n\x02\x02");
  EXPECT_NE(errorText([&] { loadHdrImage(file("cut.hdr")); }), "");
}

// The library reads channels until one has no name, whatever size is said.
TEST_F(ImageFile, ChannelsEndWhereTheirAttributeDoes) {
  saveExr(file("a.exr"), ramp(3, 2));
  std::string bytes = read("a.exr");
  const std::size_t size = bytes.find(std::string("channels\0chlist\0", 16)) + 16;
  const int said = static_cast<unsigned char>(bytes[size]);
  --bytes[size];
  write("short.exr", bytes);
  EXPECT_EQ(errorText([&] { loadHdrImage(file("short.exr")); }),
            file("short.exr") + ": is damaged: attribute channels of type chlist does not fill its " +
                std::to_string(said - 1) + " bytes; save it again");
}

TEST_F(ImageFile, SizesBeyondTheLimitAreRefusedByTheFigure) {
  Imf::Header header(40000, 1);  // wide, but only one line
  header.channels().insert("Y", Imf::Channel(Imf::HALF));
  std::vector<half> line(40000);
  {
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(line.data()), sizeof(half), 0));
    Imf::OutputFile wide(file("wide.exr").c_str(), header);
    wide.setFrameBuffer(buffer);
    wide.writePixels(1);
  }
  EXPECT_EQ(errorText([&] { loadHdrImage(file("wide.exr")); }),
            file("wide.exr") + ": is 40000 x 1 pixels; at most 32768 a side are read");
  write("wide.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 30000 +X 30000\n\x02\x02");
  EXPECT_EQ(errorText([&] { loadHdrImage(file("wide.hdr")); }),
            file("wide.hdr") + ": is 30000 x 30000 pixels; at most 134217728 in all are read");
}

TEST_F(ImageFile, OtherKindsOfFileAreRefused) {
  write("a.tiff", "x");
  EXPECT_EQ(errorText([&] { loadHdrImage(file("a.tiff")); }),
            file("a.tiff") + ": has an extension that is not read; use .exr or .hdr");
  EXPECT_EQ(errorText([&] { loadHdrImage(file("gone.exr")); }), file("gone.exr") + ": does not exist; check the path");
  EXPECT_EQ(errorText([&] { loadImage8(file("gone.png")); }), file("gone.png") + ": does not exist; check the path");
}

TEST_F(ImageFile, WritingWhereThereIsNoFolderFails) {
  EXPECT_NE(errorText<WorkError>([&] { saveExr(file("gone/a.exr"), ramp(2, 2)); }), "");
  ImageRgbaF wrong = ramp(2, 2);
  wrong.width = 3;
  EXPECT_NE(errorText<WorkError>([&] { saveExr(file("a.exr"), wrong); }), "");
  EXPECT_EQ(entryCount(), 0u);
}

}  // namespace
}  // namespace boxprobe
