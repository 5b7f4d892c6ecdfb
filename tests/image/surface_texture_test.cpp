// How textures of materials are sampled on the driver at hand.
#include <gtest/gtest.h>

#include <cstdlib>

#include "filters/vtk/draw/mip_levels.h"
#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/gl/software_driver.h"
#include "tests/support/gpu_window.h"

namespace {

using namespace boxprobe;

/// GL_TEXTURE_MAX_ANISOTROPY_EXT of a 2 x 2 picture as a material's texture.
float anisotropyOf(bool nearest) {
  TextureUse use;
  auto image = std::make_shared<ImageRgba8>();
  image->width = image->height = 2;
  image->pixels.assign(16, 255);
  use.image = image;
  use.nearest = nearest;
  const SurfaceTexture texture(use, false);
  GLfloat value = 0.0f;
  glBindTexture(GL_TEXTURE_2D, texture.handle());
  glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &value);
  glBindTexture(GL_TEXTURE_2D, 0);
  return value;
}

TEST(SurfaceTexture, SoftwareRenderersGetNoAnisotropicSampling) {
  EXPECT_EQ(textureAnisotropy(), 1.0f) << "without a context nothing is known of the driver";
  const auto window = test::makeWindow();
  const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const bool software = renderer.find("llvmpipe") != std::string::npos;
  EXPECT_EQ(drawsOnCpu(), software) << renderer;
  EXPECT_EQ(anisotropyOf(false), software ? 1.0f : 8.0f);
  EXPECT_EQ(anisotropyOf(true), 1.0f);
}

TEST(MipLevels, AreMeansOfLight) {
  const std::vector<std::uint8_t> halves = {0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0};
  const MipLevel light = nextMipLevel(2, 2, halves, true);
  EXPECT_EQ(light.width, 1);
  EXPECT_EQ(light.height, 1);
  EXPECT_EQ(light.pixels, (std::vector<std::uint8_t>{188, 188, 188, 128})) << "half of white's light";
  EXPECT_EQ(nextMipLevel(2, 2, halves, false).pixels, (std::vector<std::uint8_t>{128, 128, 128, 128}));
  const MipLevel row = nextMipLevel(5, 1, std::vector<std::uint8_t>(20, 77), true);
  EXPECT_EQ(row.width, 2);
  EXPECT_EQ(row.height, 1);
  EXPECT_EQ(row.pixels, std::vector<std::uint8_t>(8, 77)) << "an even picture stays even";
}

/// The largest difference between a level made here and the driver's own.
int offFromDriver(int width, int height, bool srgb) {
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width * height) * 4);
  std::uint32_t bits = 1;
  for (std::uint8_t& byte : pixels) byte = static_cast<std::uint8_t>((bits = bits * 1664525u + 1013904223u) >> 24);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               pixels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  const MipLevel level = nextMipLevel(width, height, pixels, srgb);
  std::vector<std::uint8_t> theirs(level.pixels.size());
  glGetTexImage(GL_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE, theirs.data());
  glDeleteTextures(1, &texture);
  int most = 0;
  for (std::size_t i = 0; i < theirs.size(); ++i) most = std::max(most, std::abs(theirs[i] - level.pixels[i]));
  std::printf("  %d x %d%s: %d of 255\n", width, height, srgb ? " sRGB" : "", most);
  return most;
}

TEST(MipLevels, AreTheDriversButForRounding) {
  const auto window = test::makeWindow();
  for (const bool srgb : {false, true}) {
    EXPECT_LE(offFromDriver(64, 32, srgb), 2);
    EXPECT_LE(offFromDriver(37, 21, srgb), 2);
  }
}

}  // namespace
