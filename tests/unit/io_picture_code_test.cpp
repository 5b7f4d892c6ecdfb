// RGBM and double LDR pictures as cubes: an encoded file gives the radiance that was encoded, within what eight bits
// cost; a picture that cannot be of its encoding is refused in one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "filters/io/image/image_file.h"
#include "tests/support/rgbm_encoder.h"
#include "tests/unit/cube_pictures.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class PictureCodeFile : public TemporaryFolder {
 protected:
  /// The faces on end, +X first, as RGBM.
  std::string rgbmStrip(const std::string& name, const CubeMap& cube, const RgbmInstruction& instruction) const {
    const int side = cube.faceSize();
    ImageRgba8 strip;
    strip.width = side;
    strip.height = 6 * side;
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
          const RgbmTexel texel = encodeRgbm(glm::vec3(cube.texel(0, face, column, row)), instruction);
          strip.pixels.insert(strip.pixels.end(), texel.begin(), texel.end());
        }
      }
    }
    savePng(file(name), strip);
    return file(name);
  }
};

/// Smooth, from 0.02 to 30: beyond what eight bits hold as they are, within both instructions' range.
CubeMap brightCube() {
  return cubeOf(32, 1, [](const glm::vec3& direction) {
    return 0.02f * glm::pow(glm::vec3(1500.0f), (smoothRadiance(direction) - 0.1f) / 3.0f);
  });
}

/// Largest difference of a texel's component, over the texel's largest.
double worstRelative(const CubeMap& cube, const CubeMap& truth) {
  EXPECT_EQ(cube.faceSize(), truth.faceSize());
  double worst = 0.0;
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < truth.faceSize() * truth.faceSize(); ++i) {
      const glm::vec4 is = cube.texel(0, face, i % truth.faceSize(), i / truth.faceSize());
      const glm::vec4 was = truth.texel(0, face, i % truth.faceSize(), i / truth.faceSize());
      const glm::vec3 off = glm::abs(glm::vec3(is - was));
      worst = std::max(worst, double(std::max({off.x, off.y, off.z}) / std::max({was.x, was.y, was.z})));
      EXPECT_EQ(is.w, 1.0f) << "M is no coverage";
    }
  }
  return worst;
}

TEST_F(PictureCodeFile, RgbmGivesTheRadianceThatWasEncoded) {
  const CubeMap cube = brightCube();
  const std::string engine = rgbmStrip("engine.png", cube, {34.493242f, 2.2f, true});
  const LoadedCube loaded = loadCube(engine, CubeLayout::Automatic, 0, {ImageEncoding::Rgbm, {}});
  EXPECT_EQ(loaded.layout, CubeLayout::Strip);
  EXPECT_LT(worstRelative(loaded.radiance, cube), 0.0045);
  // What says how it is to be read is used, and not what is usual.
  const std::string own = rgbmStrip("own.png", cube, {60.0f, 3.0f, true});
  EXPECT_LT(worstRelative(loadCube(own, CubeLayout::Strip, 0, {ImageEncoding::Rgbm, {{60.0, 3.0}}}).radiance, cube),
            0.006);
  EXPECT_GT(worstRelative(loadCube(own, CubeLayout::Strip, 0, {ImageEncoding::Rgbm, {}}).radiance, cube), 0.3);
  const std::string linear = rgbmStrip("linear.png", cube, {34.493242f, 2.2f, false});
  EXPECT_LT(
      worstRelative(
          loadCube(linear, CubeLayout::Automatic, 0, {ImageEncoding::RgbmLinear, {{34.493242, 2.2}}}).radiance, cube),
      0.0045);
}

TEST_F(PictureCodeFile, UsualInstructionsAreTheEngines) {
  EXPECT_NEAR(usualDecode(ImageEncoding::Rgbm).x, std::pow(5.0, 2.2), 1e-6);
  EXPECT_EQ(usualDecode(ImageEncoding::Rgbm).y, 2.2);
  EXPECT_NEAR(usualDecode(ImageEncoding::Dldr).x, std::pow(2.0, 2.2), 1e-6);
  EXPECT_EQ(usualDecode(ImageEncoding::RgbmLinear), glm::dvec2(5.0, 1.0));
}

TEST_F(PictureCodeFile, DoubleLdrNeedsNoAlphaAndHeedsNone) {
  ImageRgba8 map;
  map.width = 64;
  map.height = 32;
  for (int i = 0; i < 64 * 32; ++i)
    map.pixels.insert(map.pixels.end(), {255, 128, 0, static_cast<std::uint8_t>(i % 256)});
  savePng(file("a.png"), map);
  const glm::vec4 texel =
      loadCube(file("a.png"), CubeLayout::Automatic, 0, {ImageEncoding::Dldr, {}}).radiance.texel(0, 2, 3, 4);
  EXPECT_NEAR(texel.r, 4.594793, 1e-5);
  EXPECT_NEAR(texel.g, 4.594793 * 0.2158605, 1e-5);
  EXPECT_EQ(texel.b, 0.0f);
  EXPECT_EQ(texel.a, 1.0f);
  const PictureCode twice{ImageEncoding::Dldr, {{9.189586, 1.0}}};
  EXPECT_NEAR(loadCube(file("a.png"), CubeLayout::Automatic, 0, twice).radiance.texel(0, 2, 3, 4).r, 9.189586, 1e-5);
}

TEST_F(PictureCodeFile, WhatIsBeyondHalfFloatIsBroughtDownAndCounted) {
  const std::string strip = rgbmStrip("a.png", brightCube(), {34.493242f, 2.2f, true});
  const LoadedCube loaded = loadCube(strip, CubeLayout::Automatic, 0, {ImageEncoding::Rgbm, {{1e18, 2.2}}});
  // 1e18 M^2.2 c is beyond a half float for any bytes but 0.
  const ImageRgba8 picture = loadImage8(strip);
  std::size_t bright = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
    const bool light = picture.pixels[i] > 0 || picture.pixels[i + 1] > 0 || picture.pixels[i + 2] > 0;
    bright += light && picture.pixels[i + 3] > 0 ? 1 : 0;
  }
  EXPECT_GT(bright, 0u);
  EXPECT_EQ(loaded.repairs.beyondHalf, bright);
  EXPECT_EQ(loaded.repairs.notFinite, 0u);
  for (int i = 0; i < 6 * 4 * 32 * 32; ++i) EXPECT_LE(loaded.radiance.face(0, 0)[i], 65504.0f);
}

TEST_F(PictureCodeFile, WhatCannotBeOfTheEncodingIsRefusedByName) {
  const CubeMap cube = brightCube();
  const auto problem = [&](const std::string& path, ImageEncoding encoding) {
    return errorText([&] { loadCube(path, CubeLayout::Automatic, 0, {encoding, {}}); });
  };
  saveCubePicture(file("a.exr"), cube, CubeLayout::Strip);
  EXPECT_EQ(problem(file("a.exr"), ImageEncoding::Rgbm),
            file("a.exr") + ": holds radiance as it is; take \"encoding\" away, or name the PNG that is encoded");
  EXPECT_NE(problem(file("a.exr"), ImageEncoding::Dldr), "");
  // A baked probe of ours is an .exr like others: read without its encoding it would be taken for what it is.
  BakedProbeFile baked;
  baked.maps.radiance = smoothCube(16, 2);
  saveBakedProbe(file("baked.exr"), baked);
  EXPECT_NE(problem(file("baked.exr"), ImageEncoding::Rgbm), "");

  const std::string strip = rgbmStrip("a.png", cube, {});
  EXPECT_EQ(problem(strip, ImageEncoding::Linear),
            strip +
                ": has eight bits, which hold no radiance as it is; say how they are to be read with \"encoding\": "
                "\"rgbm\", \"dldr\" or \"rgbmLinear\", or use an EXR or HDR picture");
  EXPECT_EQ(problem(write("cut.png", "no picture"), ImageEncoding::Rgbm),
            file("cut.png") + ": is not a PNG, JPEG or WebP picture; save it as one of these");
  const unsigned char noAlpha[] = {// a PNG of 2 x 1 white pixels, RGB
                                   0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
                                   0x44, 0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00,
                                   0x00, 0x7b, 0x40, 0xe8, 0xdd, 0x00, 0x00, 0x00, 0x0b, 0x49, 0x44, 0x41, 0x54, 0x78,
                                   0xda, 0x63, 0xf8, 0x0f, 0x06, 0x00, 0x14, 0xf2, 0x05, 0xfb, 0x37, 0xa9, 0x0b, 0xb9,
                                   0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  const std::string rgb(noAlpha, noAlpha + sizeof(noAlpha));
  EXPECT_NE(problem(write("rgb.png", rgb), ImageEncoding::Rgbm).find("has no alpha channel"), std::string::npos);
  EXPECT_NO_THROW(loadCube(file("rgb.png"), CubeLayout::Automatic, 0, {ImageEncoding::Dldr, {}}));
}

}  // namespace
}  // namespace boxprobe
