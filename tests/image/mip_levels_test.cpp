// Mip levels drawn by our own program are the driver's, byte for byte.
#include "filters/vtk/gl/mip_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tests/support/gpu_window.h"

namespace boxprobe {
namespace {

struct Case {
  GLenum format;
  int width, height;
};

class MipLevelsTest : public ::testing::TestWithParam<Case> {};

std::vector<unsigned char> level(GLuint texture, int level, int width, int height) {
  std::vector<unsigned char> texels(std::size_t(4) * width * height);
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  return texels;
}

TEST_P(MipLevelsTest, AreTheDrivers) {
  const auto window = test::makeWindow();
  const auto [format, width, height] = GetParam();
  std::mt19937 random(7);
  std::vector<unsigned char> texels(std::size_t(4) * width * height);
  std::generate(texels.begin(), texels.end(), [&] { return static_cast<unsigned char>(random()); });
  MipLevels mips;
  GLuint textures[2] = {};
  glGenTextures(2, textures);
  for (const GLuint texture : textures) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    if (texture == textures[0]) {
      glGenerateMipmap(GL_TEXTURE_2D);
    } else {
      mips.make(texture, format, width, height);
    }
  }
  for (int l = 0, w = width, h = height; l == 0 || w > 1 || h > 1; ++l) {
    if (l > 0) {
      w = std::max(w / 2, 1);
      h = std::max(h / 2, 1);
    }
    EXPECT_TRUE(level(textures[0], l, w, h) == level(textures[1], l, w, h)) << "level " << l;
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glDeleteTextures(2, textures);
}

INSTANTIATE_TEST_SUITE_P(Sizes, MipLevelsTest,
                         ::testing::Values(Case{GL_RGBA8, 256, 256}, Case{GL_SRGB8_ALPHA8, 256, 256},
                                           Case{GL_RGBA8, 300, 200}, Case{GL_SRGB8_ALPHA8, 300, 200},
                                           Case{GL_RGBA8, 333, 1}, Case{GL_SRGB8_ALPHA8, 1, 5}, Case{GL_RGBA8, 512, 64},
                                           Case{GL_SRGB8_ALPHA8, 1023, 511}));

// Amid a frame of VTK's: what it thinks is bound is bound.
TEST(MipLevels, LeaveTheStateAsItWas) {
  const auto window = test::makeWindow();
  GLuint framebuffer = 0, array = 0, texture = 0;
  glGenFramebuffers(1, &framebuffer);
  glGenVertexArrays(1, &array);
  glGenTextures(1, &texture);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glBindVertexArray(array);
  glViewport(3, 4, 5, 6);
  glEnable(GL_BLEND);
  glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
  glBindTexture(GL_TEXTURE_2D, texture);
  const std::vector<unsigned char> texels(64, 77);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  MipLevels mips;
  mips.make(texture, GL_SRGB8_ALPHA8, 4, 4);
  const auto value = [](GLenum name) {
    GLint v[4] = {};
    glGetIntegerv(name, v);
    return std::vector<GLint>(v, v + 4);
  };
  EXPECT_EQ(value(GL_VIEWPORT), (std::vector<GLint>{3, 4, 5, 6}));
  EXPECT_EQ(value(GL_READ_FRAMEBUFFER_BINDING)[0], static_cast<GLint>(framebuffer));
  EXPECT_EQ(value(GL_VERTEX_ARRAY_BINDING)[0], static_cast<GLint>(array));
  EXPECT_EQ(value(GL_TEXTURE_BINDING_2D)[0], static_cast<GLint>(texture));
  EXPECT_EQ(value(GL_COLOR_WRITEMASK), (std::vector<GLint>{1, 0, 1, 0}));
  EXPECT_TRUE(glIsEnabled(GL_BLEND));
  EXPECT_FALSE(glIsEnabled(GL_FRAMEBUFFER_SRGB));
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteVertexArrays(1, &array);
  glDeleteTextures(1, &texture);
}

}  // namespace
}  // namespace boxprobe
