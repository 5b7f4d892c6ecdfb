// The flat picture of a filtered chain gives what the cubemap gives, edges, corners and levels included.
#include <gtest/gtest.h>
#include <vtkOpenGLState.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "filters/vtk/gl/full_screen_pass.h"
#include "filters/vtk/gl/gl_objects.h"
#include "filters/vtk/gl/software_driver.h"
#include "filters/vtk/maps/flat_texture.h"
#include "tests/support/gpu_window.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kSide = 256;

// Directions all over, every fourth within a hundredth of an edge or corner; levels from below the first to beyond the
// last, every third a whole one. Writes both values' distance, and the red of each.
constexpr const char* kMain = R"(
uniform samplerCube cube;
uniform sampler2D flatPicture;
uniform float size;
uniform float maxLevel;
in vec2 texCoord;
void main()
{
  uint seed = uint(gl_FragCoord.x) + 65536u * uint(gl_FragCoord.y);
  vec4 u;
  for (int i = 0; i < 4; ++i) { seed = hashed(seed + uint(i)); u[i] = unitNumber(seed); }
  vec3 d = 2.0 * u.xyz - 1.0;
  uint kind = hashed(seed);
  if ((kind & 3u) == 0u)
  {
    d.x = d.x < 0.0 ? -1.0 : 1.0;
    d.y = (d.y < 0.0 ? -1.0 : 1.0) * (0.99 + 0.02 * u.w);
    if ((kind & 4u) == 0u) { d.z = (d.z < 0.0 ? -1.0 : 1.0) * (0.99 + 0.02 * u.x); }
  }
  float level = mix(-1.0, maxLevel + 1.0, u.w);
  if (kind / 8u % 3u == 0u) { level = floor(level); }
  vec4 a = textureLod(cube, d, level);
  // Directions need not be unit. Beyond this some reciprocal or component is below the least normal number, which is 0 here.
  float reach = (kind & 0xe0u) == 0u ? 1.0e-30 : (kind & 0xe0u) == 0x20u ? 3.0e37 : 1.0;
  vec4 b = bpFlatLookup(flatPicture, reach * d, level, size, maxLevel);
  gl_FragData[0] = vec4(max(max(abs(a.r - b.r), abs(a.g - b.g)), max(abs(a.b - b.b), abs(a.a - b.a))), a.r, b.r, 1.0);
}
)";

TEST(FlatLookup, IsTheCubemaps) {
  const auto window = makeWindow();
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  const auto total = std::make_shared<std::size_t>(0);
  for (const int faceSize : {512, 256, 32, 4}) {
    CubeTexture chain;
    int levels = 1;
    for (int size = faceSize; size > 4; size /= 2) ++levels;
    chain.allocate(faceSize, levels, GL_RGBA16F);
    for (int level = 0; level < levels; ++level) {
      const auto size = static_cast<std::size_t>(faceSize >> level);
      std::vector<float> texels(size * size * 4);
      for (int face = 0; face < 6; ++face) {
        for (float& x : texels) x = unit(random);
        chain.writeFace(face, level, texels);
      }
    }
    FlatTexture flat;
    ASSERT_TRUE(FlatTexture::fits(chain));
    const std::size_t expected = flat.bytesToMake(chain);
    ASSERT_TRUE(flat.make(chain, total));
    const GLuint first = flat.handle();
    ASSERT_TRUE(flat.make(chain, total));
    EXPECT_EQ(flat.handle(), first) << "it is made once";
    EXPECT_LE(flat.bytes(), expected);
    EXPECT_EQ(*total, flat.bytes());
    FloatTarget target;
    target.allocate(kSide, kSide);
    FullScreenPass pass("flat lookup", joinShaderSources({"shared/hash.glsl", "gpu/flat_lookup.glsl"}) + kMain);
    std::vector<float> values(4 * static_cast<std::size_t>(kSide) * kSide);
    {
      const PassState saved(window);
      window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
      window->GetState()->vtkglViewport(0, 0, kSide, kSide);
      const BoundTexture cube(window, GL_TEXTURE_CUBE_MAP, chain.handle());
      const BoundTexture picture(window, GL_TEXTURE_2D, flat.handle());
      pass.draw(window, [&](vtkShaderProgram* program) {
        program->SetUniformi("cube", cube.unit());
        program->SetUniformi("flatPicture", picture.unit());
        program->SetUniformf("size", static_cast<float>(faceSize));
        program->SetUniformf("maxLevel", static_cast<float>(levels - 1));
      });
      glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, values.data());
    }
    pass.release();
    double sum = 0.0, sumOfSquares = 0.0;
    float worst = 0.0f;
    for (std::size_t i = 0; i < values.size(); i += 4) {
      ASSERT_TRUE(std::isfinite(values[i]));
      worst = std::max(worst, values[i]);
      sum += values[i + 1];
      sumOfSquares += values[i + 1] * values[i + 1];
    }
    const double count = static_cast<double>(values.size() / 4), mean = sum / count;
    std::printf("  faces of %3d: at most %.2g of texels from 0 to 1\n", faceSize, static_cast<double>(worst));
    EXPECT_LE(worst, drawsOnCpu() ? 1.0e-3f : 1.0e-2f) << "cards interpolate by steps of 1/256";
    EXPECT_GT(sumOfSquares / count - mean * mean, 0.01) << "texels that are all alike test nothing";
    flat.release();
    EXPECT_EQ(*total, 0u);
  }
}

// Sizes that do not halve down to the last level have no such picture, nor have those that would take too much memory.
TEST(FlatLookup, IsNotMadeOfEverySize) {
  const auto window = makeWindow();
  const auto fits = [](int faceSize, int levels) {
    CubeTexture chain;
    chain.allocate(faceSize, levels, GL_RGBA16F);
    return FlatTexture::fits(chain);
  };
  EXPECT_TRUE(fits(64, 5));
  EXPECT_FALSE(fits(48, 4));
  EXPECT_FALSE(fits(1024, 1));
  EXPECT_FALSE(FlatTexture::fits(CubeTexture()));
}

// What is drawn flat is laid out once, again after a level is filtered later, and nothing is while numbers are
// uniforms.
TEST(FlatMaps, AreMadeWhenAProgramNeedsThem) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.scene.lamps = LampForm::InMap;  // rough surfaces look up the probe's own map
  picture.scene.probes.front().faceSize = 32;
  picture.scene.probes.front().bounces = 1;
  picture.show(picture.scene.cameras.front());
  if (!drawsOnCpu()) GTEST_SKIP() << "a graphics card looks its cubemaps up";
  const Counters& counters = picture.renderer->counters();
  picture.display();
  EXPECT_EQ(counters.mapsFlattened, 0u);
  const auto rest = [&picture] {
    picture.renderer->specializePrograms();
    picture.renderer->finishWork();
    picture.display();
  };
  rest();
  const std::uint64_t once = counters.mapsFlattened;
  EXPECT_GE(once, 1u);
  picture.display();
  EXPECT_EQ(counters.mapsFlattened, once) << "frames at rest make nothing";
  const std::uint64_t later = counters.levelsMadeLater;
  MaterialOverride rough;
  rough.roughness = 0.5f;
  picture.scene.materials["floor"] = rough;
  Changes changes;
  changes.materials = true;
  picture.renderer->sync(picture.scene, changes);
  rest();
  EXPECT_GT(counters.levelsMadeLater, later) << "an edit that needs no further level tests nothing";
  EXPECT_GT(counters.mapsFlattened, once);
}

}  // namespace
