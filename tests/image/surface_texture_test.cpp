// How textures of materials are sampled on the driver at hand.
#include <gtest/gtest.h>

#include <cstdlib>

#include "filters/platform/process.h"
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
  const SurfaceTexture texture(use, false, std::make_shared<MipLevels>());
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

TEST(SurfaceTexture, AnisotropyAndTuningAreAskedFor) {
  const auto window = test::makeWindow();
  setEnvironment("BOXPROBE_ANISOTROPY", "4", true);
  EXPECT_EQ(anisotropyOf(false), 4.0f);
  EXPECT_EQ(anisotropyOf(true), 1.0f);
  ::unsetenv("BOXPROBE_ANISOTROPY");
  for (const char* kind : {"cpu", "gpu", "auto"}) {
    setEnvironment("BOXPROBE_RENDERER_TUNING", kind, true);
    const std::string asked = kind;
    EXPECT_EQ(tunedForCpu(), asked == "cpu" || (asked == "auto" && drawsOnCpu())) << kind;
  }
  ::unsetenv("BOXPROBE_RENDERER_TUNING");
}

}  // namespace
