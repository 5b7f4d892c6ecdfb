// The prefilter on the graphics side: equal to the CPU's, whatever the face size and the filter; and that a probe's
// filter reaches its maps.
#include "filters/vtk/capture/prefilter.h"

#include <gtest/gtest.h>

#include "filters/math/cube/cube_filter.h"
#include "filters/vtk/gl/software_driver.h"
#include "filters/vtk/maps/cube_transfer.h"
#include "tests/support/gpu_window.h"
#include "tests/support/scene_picture.h"
#include "tests/unit/filter_cubes.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

class GpuPrefilter : public ::testing::Test {
 protected:
  CubeMap filter(const CubeMap& capture, const PrefilterSettings& settings) {
    const int faceSize = capture.faceSize();
    CubeTexture source, chain;
    source.allocate(faceSize, fullLevels(faceSize), GL_RGBA16F);
    chain.allocate(faceSize, prefilterLevels(faceSize), GL_RGBA16F);
    uploadLevel0(capture, source);
    prefilter.begin(source, chain, settings);
    CubeMap result(faceSize, chain.levels());
    for (int level = 0; level < chain.levels(); ++level) {
      if (level > 0) prefilter.filterLevel(source, chain, level, settings);
      for (int face = 0; face < 6; ++face) {
        const std::vector<float> rgba = chain.readFace(face, level);
        std::copy(rgba.begin(), rgba.end(), result.face(level, face));
      }
    }
    return result;
  }
  vtkSmartPointer<vtkOpenGLRenderWindow> window = makeWindow();
  Counters counters;
  Prefilter prefilter{window, &counters};
};

// A flat picture of the source is made where a level has lookups enough to be worth it, once, and by processors alone.
TEST_F(GpuPrefilter, LaysTheSourceOutFlatForFineLevelsAlone) {
  PrefilterSettings few;
  few.samples = 8;
  const CubeMap capture = skyWithLamp(64, 0.97f, 0.3f);
  filter(capture, few);
  EXPECT_EQ(counters.sourcesFlattened, 0u);
  filter(capture, {});
  EXPECT_EQ(counters.sourcesFlattened, tunedForCpu() ? 1u : 0u);
}

// The GPU's chain is of half floats, source levels included: each rounding is 2^-11 of a texel's own value, which for
// the sum stays below 1e-3 of it; the CPU's is of floats.
TEST_F(GpuPrefilter, EqualsTheCpu) {
  PrefilterSettings frosty, many;
  frosty.filter = FilterLobe::Kind::Gaussian;
  frosty.gaussian.edgeFixupWidth = 4;
  many.samples = 300;
  const struct {
    int faceSize;
    PrefilterSettings settings;
  } cases[] = {{16, {}}, {64, {}}, {64, frosty}, {32, many}};
  for (const auto& [faceSize, settings] : cases) {
    const CubeMap capture = skyWithLamp(faceSize, 0.97f, 0.3f, 3.0e4f);
    const CubeMap gpu = filter(capture, settings), cpu = prefilterCube(capture, settings);
    for (int level = 0; level < gpu.levels(); ++level) {
      float brightest = 0.0f, worst = 0.0f, worstShare = 0.0f;
      forEachTexel(gpu.levelSize(level), [&](int face, int column, int row) {
        const glm::vec4 a = gpu.texel(level, face, column, row), b = cpu.texel(level, face, column, row);
        for (int c = 0; c < 4; ++c) {
          brightest = std::max(brightest, b[c]);
          worst = std::max(worst, std::abs(a[c] - b[c]));
          worstShare = std::max(worstShare, std::abs(a[c] - b[c]) / std::max(b[c], 1e-3f));
        }
      });
      EXPECT_LT(worst / brightest, 1e-3f) << faceSize << " level " << level;
      EXPECT_LT(worstShare, 0.02f) << faceSize << " level " << level;
    }
  }
}

TEST_F(GpuPrefilter, AConstantStaysConstantUpToLargeFaces) {
  const CubeMap white = cubeOf(512, [](const glm::vec3&) { return glm::vec3(0.7f); });
  PrefilterSettings settings;
  settings.samples = kMinSamples;
  const CubeMap chain = filter(white, settings);
  for (int level = 0; level < chain.levels(); ++level) {
    for (int face = 0; face < 6; ++face) {
      const int floats = 4 * chain.levelSize(level) * chain.levelSize(level);
      for (int i = 0; i < floats; i += 4) ASSERT_NEAR(chain.face(level, face)[i], 0.7f, 7e-4f) << "level " << level;
    }
  }
}

// As a scene asks for it. The frosty filter blurs level 0 as well, so its maps must not lend faces to another capture.
TEST(ProbeFilter, ReachesTheMapsAndBack) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.scene.probes[0].faceSize = 64;
  picture.scene.probes[0].bounces = 1;
  picture.show(cameraNamed(picture.scene, "main"));
  const std::string name = picture.scene.probes[0].name;
  const auto maps = [&](FilterKind filter) {
    const Scene before = picture.scene;
    picture.scene.probes[0].filter = filter;
    picture.renderer->sync(picture.scene, difference(before, picture.scene));
    picture.renderer->finishWork();
    return picture.renderer->readMaps(name)->radiance;
  };
  const CubeMap sharp = maps(FilterKind::Ggx), blurred = maps(FilterKind::Gaussian);
  PrefilterSettings settings;
  settings.filter = FilterLobe::Kind::Gaussian;
  const CubeMap expected = prefilterCube(sharp, settings);
  double worst = 0.0, apart = 0.0, brightest = 0.0;
  forEachTexel(64, [&](int face, int column, int row) {
    const float value = blurred.texel(0, face, column, row).y;
    brightest = std::max<double>(brightest, value);
    worst = std::max<double>(worst, std::abs(value - expected.texel(0, face, column, row).y));
    apart = std::max<double>(apart, std::abs(value - sharp.texel(0, face, column, row).y));
  });
  EXPECT_LT(worst / brightest, 2e-3);
  EXPECT_GT(apart / brightest, 0.1);
  picture.scene.probes[0].origin.x += 0.25;
  maps(FilterKind::Gaussian);
  picture.scene.probes[0].origin.x -= 0.25;
  const CubeMap again = maps(FilterKind::Ggx);
  forEachTexel(64, [&](int face, int column, int row) {
    ASSERT_EQ(again.texel(0, face, column, row), sharp.texel(0, face, column, row));
  });
}

}  // namespace
