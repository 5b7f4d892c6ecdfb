// Cubes to and from OpenEXR's own tools: exrenvmap converts ours both ways and we read what it, exrmaketiled and
// exrmultipart write. Faces of one colour each tell which face is where; a radiance that is different in every
// direction tells turned and mirrored ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/unit/cube_pictures.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class OpenExrTools : public TemporaryFolder {
 protected:
  void run(const std::string& command) const {
    const std::string inFolder = "cd '" + folder_.string() + "' && " + command + " >tool.log 2>&1";
    ASSERT_EQ(std::system(inFolder.c_str()), 0) << command << "\n" << read("tool.log");
  }
};

/// The largest difference from the faces' colours, relative to a half's last bit, at least `margin` of a face from its
/// edges.
double worstFaceError(const CubeMap& cube, double margin) {
  const int size = cube.faceSize();
  const int from = static_cast<int>(std::ceil(margin * size)), to = size - from;
  double worst = 0.0;
  for (int face = 0; face < 6; ++face) {
    for (int row = from; row < to; ++row) {
      for (int column = from; column < to; ++column) {
        const glm::vec3 difference = glm::vec3(cube.texel(0, face, column, row)) - faceColor(face);
        for (int c = 0; c < 3; ++c) {
          worst = std::max(worst, std::fabs(static_cast<double>(difference[c])) / (faceColor(face)[c] * HALF_EPSILON));
        }
      }
    }
  }
  return worst;
}

double worstSmoothError(const CubeMap& cube) {
  const CubeMap wanted = smoothCube(cube.faceSize());
  double worst = 0.0;
  for (int i = 0; i < 6 * 4 * cube.faceSize() * cube.faceSize(); ++i) {
    if (i % 4 == 3) continue;
    worst = std::max(worst, std::fabs(static_cast<double>(cube.face(0, 0)[i] - wanted.face(0, 0)[i])));
  }
  return worst;
}

// exrenvmap's tent filter is two texels wide, and the two conversions of a round trip each blur once.
constexpr double kMargin = 0.1;
constexpr double kBlurredSmooth = 0.03;  // of values up to 3.1

TEST_F(OpenExrTools, ExrenvmapTurnsOurBakedProbeIntoALatLongMap) {
  BakedProbeFile probe;
  probe.maps.radiance = colouredFaces(64);
  saveBakedProbe(file("faces.exr"), probe);
  run("exrenvmap -l -w 256 faces.exr out.exr");
  const LoadedCube faces = loadCube(file("out.exr"), CubeLayout::Automatic, 64);
  EXPECT_EQ(faces.layout, CubeLayout::LatLong);
  EXPECT_LE(worstFaceError(faces.radiance, kMargin), 1.0);
  probe.maps.radiance = smoothCube(64, 7);
  saveBakedProbe(file("smooth.exr"), probe);
  run("exrenvmap -l -w 256 smooth.exr out.exr");
  EXPECT_LE(worstSmoothError(loadCube(file("out.exr"), CubeLayout::Automatic, 64).radiance), kBlurredSmooth);
}

TEST_F(OpenExrTools, ExrenvmapTurnsOurLatLongMapIntoACubeAndBack) {
  saveCubePicture(file("faces.exr"), colouredFaces(64), CubeLayout::LatLong);
  saveCubePicture(file("smooth.exr"), smoothCube(64), CubeLayout::LatLong);
  for (const char* name : {"faces", "smooth"}) {
    const std::string n = name;
    run("exrenvmap -c -w 64 " + n + ".exr " + n + "_cube.exr && exrenvmap -c -m -w 64 " + n + ".exr " + n +
        "_mip.exr && exrenvmap -l -w 256 " + n + "_cube.exr " + n + "_again.exr && exrenvmap -c -w 64 " + n + ".exr " +
        n + "%.exr");
    for (const char* kind : {"_cube", "_mip", "_again", "%", "+X"}) {
      const LoadedCube loaded = loadCube(file(n + kind + ".exr"), CubeLayout::Automatic, 64);
      if (n == "faces") {
        EXPECT_LE(worstFaceError(loaded.radiance, kMargin), 1.0) << kind;
      } else {
        EXPECT_LE(worstSmoothError(loaded.radiance), kBlurredSmooth) << kind;
      }
    }
  }
}

TEST_F(OpenExrTools, ExrenvmapReadsOurSixFiles) {
  saveCubePicture(file("face%.exr"), smoothCube(64), CubeLayout::SixFiles);
  run("exrenvmap -l -w 256 'face%.exr' out.exr");
  EXPECT_LE(worstSmoothError(loadCube(file("out.exr"), CubeLayout::Automatic, 64).radiance), kBlurredSmooth);
}

TEST_F(OpenExrTools, WeReadWhatExrmaketiledAndExrmultipartWrite) {
  const CubeMap cube = noisyHalfCube(32, 1);
  saveCubePicture(file("cube.exr"), cube, CubeLayout::Strip);
  saveCubePicture(file("cross.exr"), cube, CubeLayout::Cross);
  // Levels and piz for the cross: exrmaketiled makes none of a file that says it is an environment map.
  run("exrmaketiled -o -t 16 16 cube.exr tiled.exr && exrmaketiled -m -t 16 16 cross.exr mip.exr && "
      "exrmaketiled -r -u -z piz cross.exr rip.exr && exrmultipart -combine -i cross.exr cube.exr -o parts.exr "
      "-override 1");
  const CubeMap direct = loadCube(file("cube.exr")).radiance;
  EXPECT_TRUE(sameTexels(loadCube(file("tiled.exr")).radiance, direct));
  EXPECT_TRUE(sameTexels(loadCube(file("parts.exr")).radiance, direct));  // the part that says envmap, not the first
  EXPECT_TRUE(sameTexels(loadCube(file("mip.exr")).radiance, cube));
  EXPECT_TRUE(sameTexels(loadCube(file("rip.exr")).radiance, cube));
}

TEST_F(OpenExrTools, ExrheaderShowsWhereAndHowItWasBaked) {
  BakedProbeFile probe;
  probe.maps.radiance = smoothCube(16, 5);
  probe.info.probe.origin = {0.5, 1.6, -3};
  probe.info.probe.technique = "sphere";
  probe.info.program = "Boxprobe 0.1.0";
  saveBakedProbe(file("probe.exr"), probe);
  run("exrheader probe.exr");
  const std::string text = read("tool.log");
  for (const char* line : {"envmap (type envmap): cube-face map", "probe.origin (type v3f): (0.5 1.6 -3)",
                           "probe.technique (type string): \"sphere\"", "software (type string): \"Boxprobe 0.1.0\"",
                           "probe.box.min (type v3f): (-1 -1 -1)"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
  }
  run("exrmultipart -separate -i probe.exr -o part");  // the file is sound to a reader that knows every part
}

}  // namespace
}  // namespace boxprobe
