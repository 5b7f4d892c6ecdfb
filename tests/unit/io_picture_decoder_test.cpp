// PNG and JPEG of every kind: the same texels as from stb, which read them before and stands for any other decoder.
#include <gtest/gtest.h>
#include <stdio.h>
// jpeglib.h needs FILE of <stdio.h>.
#include <jpeglib.h>
#include <png.h>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "filters/io/image/image_detail.h"
#include "filters/io/image/image_file.h"
#include "tests/unit/error_text.h"

namespace boxprobe {
namespace {

void append(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

struct Kind {
  int colorType, bits;
  bool interlaced, transparent;
};

/// 13 x 9 random texels. `transparent`: with a tRNS chunk.
std::string randomPng(const Kind& kind) {
  constexpr int kWidth = 13, kHeight = 9;
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_IHDR(png, info, kWidth, kHeight, kind.bits, kind.colorType,
               kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  std::mt19937 random(3);
  png_color palette[256];
  png_byte alphas[256];
  for (int i = 0; i < 256; ++i) {
    palette[i] = {static_cast<png_byte>(random()), static_cast<png_byte>(random()), static_cast<png_byte>(random())};
    alphas[i] = static_cast<png_byte>(random());
  }
  if (kind.colorType == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 1 << kind.bits);
  png_color_16 key = {};
  if (kind.transparent) png_set_tRNS(png, info, alphas, kind.colorType == PNG_COLOR_TYPE_PALETTE ? 2 : 1, &key);
  png_set_gAMA(png, info, 1.0);  // not to be applied
  png_write_info(png, info);
  std::vector<std::vector<png_byte>> rows(kHeight, std::vector<png_byte>(png_get_rowbytes(png, info)));
  std::vector<png_bytep> pointers;
  for (auto& row : rows) {
    for (png_byte& byte : row) byte = random() % 3 == 0 ? png_byte(0) : static_cast<png_byte>(random());
    pointers.push_back(row.data());
  }
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

std::vector<std::uint8_t> byStb(const std::string& bytes, int& channels) {
  int width = 0, height = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> pixels(
      stbi_load_from_memory(reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()),
                            &width, &height, &channels, 4),
      stbi_image_free);
  if (!pixels) return {};
  return {pixels.get(), pixels.get() + std::size_t(4) * width * height};
}

ImageRgba8 decoded(const std::string& bytes, bool* hasAlpha = nullptr) {
  return decodeImage8(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), "picture", hasAlpha);
}

class PngKind : public ::testing::TestWithParam<Kind> {};

TEST_P(PngKind, IsReadAsByStb) {
  const std::string bytes = randomPng(GetParam());
  int channels = 0;
  const std::vector<std::uint8_t> wanted = byStb(bytes, channels);
  ASSERT_FALSE(wanted.empty());
  bool alpha = false;
  EXPECT_EQ(decoded(bytes, &alpha).pixels, wanted);
  EXPECT_EQ(alpha, channels == 2 || channels == 4);
}

INSTANTIATE_TEST_SUITE_P(
    All, PngKind,
    ::testing::Values(Kind{PNG_COLOR_TYPE_GRAY, 1, false, false}, Kind{PNG_COLOR_TYPE_GRAY, 2, true, false},
                      Kind{PNG_COLOR_TYPE_GRAY, 4, false, true}, Kind{PNG_COLOR_TYPE_GRAY, 8, false, true},
                      Kind{PNG_COLOR_TYPE_GRAY, 16, true, false}, Kind{PNG_COLOR_TYPE_GRAY_ALPHA, 8, false, false},
                      Kind{PNG_COLOR_TYPE_GRAY_ALPHA, 16, false, false}, Kind{PNG_COLOR_TYPE_RGB, 8, true, false},
                      Kind{PNG_COLOR_TYPE_RGB, 8, false, true}, Kind{PNG_COLOR_TYPE_RGB, 16, false, true},
                      Kind{PNG_COLOR_TYPE_RGBA, 8, true, false}, Kind{PNG_COLOR_TYPE_RGBA, 16, false, false},
                      Kind{PNG_COLOR_TYPE_PALETTE, 1, false, true}, Kind{PNG_COLOR_TYPE_PALETTE, 4, true, false},
                      Kind{PNG_COLOR_TYPE_PALETTE, 8, false, true}));

TEST(PngDecoder, WhatEndsEarlyIsDamaged) {
  const std::string whole = randomPng({PNG_COLOR_TYPE_RGBA, 8, false, false});
  for (std::size_t length = 34; length + 30 < whole.size(); length += 7) {
    EXPECT_THROW(decoded(whole.substr(0, length)), InputError) << length;
  }
}

std::string jpeg(int components) {
  std::string bytes;
  std::vector<unsigned char> texels;
  for (int i = 0; i < 64 * 48 * components; ++i)
    texels.push_back(static_cast<unsigned char>(128 + 100 * std::sin(0.01 * i)));
  stbi_write_jpg_to_func(
      [](void* target, void* data, int size) {
        static_cast<std::string*>(target)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
      },
      &bytes, 64, 48, components, texels.data(), 90);
  return bytes;
}

// The standard leaves rounding to the decoder.
TEST(JpegDecoder, ReadsAsStbToAFewSteps) {
  for (const int components : {1, 3}) {
    const std::string bytes = jpeg(components);
    int channels = 0;
    const std::vector<std::uint8_t> wanted = byStb(bytes, channels);
    bool alpha = true;
    const ImageRgba8 read = decoded(bytes, &alpha);
    ASSERT_EQ(read.pixels.size(), wanted.size());
    EXPECT_FALSE(alpha);
    for (std::size_t i = 0; i < wanted.size(); ++i) ASSERT_NEAR(read.pixels[i], wanted[i], 4) << i;
  }
}

/// 16 x 16 texels of inks; libjpeg marks such files as Adobe's programs do unless told otherwise.
std::string inkJpeg(const std::array<JSAMPLE, 4>& inks, bool ycck, bool adobe) {
  jpeg_compress_struct jpeg;
  jpeg_error_mgr errors;
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  constexpr JDIMENSION kSide = 16;
  jpeg.image_width = jpeg.image_height = kSide;
  jpeg.input_components = 4;
  jpeg.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_set_colorspace(&jpeg, ycck ? JCS_YCCK : JCS_CMYK);
  jpeg_set_quality(&jpeg, 100, TRUE);
  jpeg.write_Adobe_marker = adobe ? TRUE : FALSE;
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<JSAMPLE> row;
  for (JDIMENSION x = 0; x < kSide; ++x) row.insert(row.end(), inks.begin(), inks.end());
  for (JDIMENSION y = 0; y < kSide; ++y) {
    JSAMPROW at = row.data();
    jpeg_write_scanlines(&jpeg, &at, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string result(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  free(bytes);
  return result;
}

// The same colour as inks, without black and with: 200, 100, 50 is 250, 125, 62.5 by a black that lets 0.8 through.
TEST(JpegDecoder, InksAreShown) {
  struct {
    std::array<JSAMPLE, 4> inks;
    bool ycck, adobe;
  } const cases[] = {{{200, 100, 50, 255}, false, true},
                     {{200, 100, 50, 255}, true, true},
                     {{250, 125, 63, 204}, false, true},
                     {{55, 155, 205, 0}, false, false},
                     {{5, 130, 192, 51}, false, false}};
  for (const auto& [inks, ycck, adobe] : cases) {
    const std::string bytes = inkJpeg(inks, ycck, adobe);
    const ImageRgba8 image =
        decodeImage8(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), "ink.jpg");
    const int right[4] = {200, 100, 50, 255};
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(image.pixels[c], right[c], 2) << int(inks[0]) << " " << c;
  }
}

TEST(JpegDecoder, WhatEndsEarlyIsDamaged) {
  const std::string whole = jpeg(3);
  EXPECT_NO_THROW(decoded(whole));
  for (const std::size_t length : {whole.size() / 2, whole.size() * 3 / 4}) {
    EXPECT_THROW(decoded(whole.substr(0, length)), InputError) << length;
  }
}

}  // namespace
}  // namespace boxprobe
