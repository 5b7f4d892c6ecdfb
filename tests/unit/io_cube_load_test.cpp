// Pictures of every layout as cubes and cubes as pictures: exact copies where nothing has to be resampled, energy where
// something has, and one line for what is no cube.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <limits>

#include "filters/io/cube/sky_picture.h"
#include "filters/io/image/image_file.h"
#include "tests/unit/cube_pictures.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class CubeFile : public TemporaryFolder {};

double largestDifference(const CubeMap& a, const CubeMap& b) {
  EXPECT_EQ(a.faceSize(), b.faceSize());
  double worst = 0.0;
  for (int i = 0; i < 6 * 4 * a.faceSize() * a.faceSize(); ++i) {
    worst = std::max(worst, std::fabs(static_cast<double>(a.face(0, 0)[i] - b.face(0, 0)[i])));
  }
  return worst;
}

ImageRgbaF blank(int width, int height, float value = 0.0f) {
  ImageRgbaF image;
  image.width = width;
  image.height = height;
  image.pixels.assign(std::size_t(4) * width * height, value);
  return image;
}

TEST_F(CubeFile, OpenGlTexelsComeBackBitForBit) {
  const CubeMap cube = noisyHalfCube(16, 1);
  saveCubePicture(file("cross.exr"), cube, CubeLayout::Cross);
  saveCubePicture(file("six_%s.exr"), cube, CubeLayout::SixFiles);
  EXPECT_TRUE(sameTexels(loadCube(file("cross.exr")).radiance, cube));
  EXPECT_TRUE(sameTexels(loadCube(file("six_%s.exr")).radiance, cube));
  EXPECT_TRUE(sameTexels(loadCube(file("six_nz.exr")).radiance, cube));
  EXPECT_EQ(loadCube(file("six_py.exr")).layout, CubeLayout::SixFiles);
  EXPECT_EQ(loadCube(file("cross.exr")).layout, CubeLayout::Cross);
}

TEST_F(CubeFile, StripsAndTheTallCrossHoldOpenGlsFaces) {
  constexpr int n = 16;
  const CubeMap cube = noisyHalfCube(n, 1);
  ImageRgbaF row = blank(6 * n, n), column = blank(n, 6 * n), tall = blank(3 * n, 4 * n);
  const auto put = [&](ImageRgbaF& image, int x, int y, const glm::vec4& value) {
    for (int c = 0; c < 4; ++c) image.pixels[4 * (std::size_t(y) * image.width + x) + c] = value[c];
  };
  const int cells[6][2] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}};
  for (int face = 0; face < 6; ++face) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        const glm::vec4 value = cube.texel(0, face, x, y);
        put(row, face * n + x, y, value);
        put(column, x, face * n + y, value);
        const bool turned = face == 5;
        put(tall, cells[face][0] * n + (turned ? n - 1 - x : x), cells[face][1] * n + (turned ? n - 1 - y : y), value);
      }
    }
  }
  saveExr(file("row.exr"), row);
  saveExr(file("column.exr"), column);
  saveExr(file("tall.exr"), tall);
  for (const char* name : {"row.exr", "column.exr", "tall.exr"}) {
    EXPECT_TRUE(sameTexels(loadCube(file(name)).radiance, cube)) << name;
  }
}

TEST_F(CubeFile, NeighboursInACrossMeetAsOnTheCube) {
  // A smooth radiance stays smooth across every fold: the largest step between neighbours is no larger than in a face.
  saveCubePicture(file("cross.exr"), smoothCube(32), CubeLayout::Cross);
  const ImageRgbaF cross = loadHdrImage(file("cross.exr"));
  double worst = 0.0;
  const auto value = [&](int x, int y, int c) { return cross.pixels[4 * (std::size_t(y) * cross.width + x) + c]; };
  const auto step = [&](int x0, int y0, int x1, int y1) {
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::fabs(double(value(x0, y0, c)) - value(x1, y1, c)));
  };
  for (int y = 32; y < 64; ++y) {
    for (int x = 0; x + 1 < 128; ++x) step(x, y, x + 1, y);
  }
  for (int x = 32; x < 64; ++x) {
    for (int y = 0; y + 1 < 96; ++y) step(x, y, x, y + 1);
  }
  EXPECT_LT(worst, 0.15);
}

TEST_F(CubeFile, ResampledRoundTripsStayClose) {
  const CubeMap cube = smoothCube(64);
  for (const CubeLayout layout : {CubeLayout::LatLong, CubeLayout::Strip}) {
    saveCubePicture(file("a.exr"), cube, layout);
    const LoadedCube again = loadCube(file("a.exr"), CubeLayout::Automatic, 64);
    EXPECT_EQ(again.layout, layout);
    EXPECT_LT(largestDifference(again.radiance, cube), 4e-3) << static_cast<int>(layout);  // half's last bit: 2e-3
  }
  saveCubePicture(file("b%.exr"), cube, CubeLayout::SixFiles);
  EXPECT_LT(largestDifference(loadCube(file("b-Y.exr")).radiance, cube), 4e-3);
}

TEST_F(CubeFile, NoEnergyIsLost) {
  // One texel of 50000 among ones, inside a face, at an edge, at a corner: what of it arrives after a round trip
  // through each layout, in pictures of the same and half the size. Coarse faces are the hard case: at 256² it is
  // within 0.3 %.
  const int places[4][3] = {{0, 15, 13}, {2, 0, 7}, {3, 31, 31}, {5, 20, 1}};
  for (const auto& place : places) {
    CubeMap cube = cubeOf(32, 1, [](const glm::vec3&) { return glm::vec3(1.0f); });
    cube.setTexel(0, place[0], place[1], place[2], glm::vec4(50000.0f, 1.0f, 1.0f, 1.0f));
    for (const CubeLayout layout : {CubeLayout::LatLong, CubeLayout::Strip, CubeLayout::Cross}) {
      for (const int size : {32, 16}) {
        CubePictureOptions options;
        options.faceSize = size;
        saveCubePicture(file("a.exr"), cube, layout, options);
        const CubeMap again = loadCube(file("a.exr"), CubeLayout::Automatic, size).radiance;
        const double error = energy(again).x / energy(cube).x - 1.0;
        EXPECT_LT(std::fabs(error), 0.06) << static_cast<int>(layout) << " " << size << " face " << place[0];
        EXPECT_NEAR(energy(again).y, energy(cube).y, 1e-3);
        EXPECT_NEAR(energy(again).w, energy(cube).w, 1e-3);
      }
    }
  }
}

TEST_F(CubeFile, DistanceIsAChannelOfItsOwnAndNotAveraged) {
  const CubeMap cube = smoothCube(16);
  CubeMap distance(16, 1);
  for (int i = 0; i < 6 * 16 * 16; ++i) distance.face(0, 0)[4 * i] = i % 2 == 0 ? 1.0f : 1000.0f;
  CubePictureOptions options;
  options.distance = &distance;
  for (const CubeLayout layout : {CubeLayout::LatLong, CubeLayout::Strip, CubeLayout::Cross}) {
    saveCubePicture(file("a.exr"), cube, layout, options);
    const LoadedCube again = loadCube(file("a.exr"), CubeLayout::Automatic, 16);
    ASSERT_FALSE(again.distance.empty());
    int agree = 0;
    for (int i = 0; i < 6 * 16 * 16; ++i) {
      const float value = again.distance.face(0, 0)[4 * i];
      ASSERT_TRUE(value == 1.0f || value == 1000.0f) << value;
      agree += value == distance.face(0, 0)[4 * i] ? 1 : 0;
    }
    EXPECT_GT(agree, layout == CubeLayout::Cross ? 1535 : 1000);
  }
}

// A sky is drawn from a latitude-longitude map, whatever its file holds: +Z in the middle, +Y on top.
TEST_F(CubeFile, SkiesOfAnyLayoutAreLatitudeLongitude) {
  CubeMap cube(16, 1);
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < 16 * 16; ++i) cube.face(0, face)[4 * i] = static_cast<float>(face + 1);
  }
  for (const CubeLayout layout : {CubeLayout::Strip, CubeLayout::Cross, CubeLayout::LatLong}) {
    saveCubePicture(file("sky.exr"), cube, layout);
    const ImageRgbaF sky = loadSkyPicture({file("sky.exr")});
    ASSERT_EQ(sky.width, 64);
    ASSERT_EQ(sky.height, 32);
    const auto red = [&](int x, int y) { return sky.pixels[4 * (static_cast<std::size_t>(y) * 64 + x)]; };
    EXPECT_NEAR(red(32, 16), 5.0f, 1e-3f) << "+Z";
    EXPECT_NEAR(red(16, 16), 1.0f, 1e-3f) << "+X";
    EXPECT_NEAR(red(48, 16), 2.0f, 1e-3f) << "-X";
    EXPECT_NEAR(red(20, 1), 3.0f, 1e-3f) << "+Y";
    EXPECT_NEAR(red(20, 30), 4.0f, 1e-3f) << "-Y";
  }
}

TEST_F(CubeFile, OurOwnBakedProbeIsReadExactly) {
  BakedProbeFile probe;
  probe.maps.radiance = noisyHalfCube(32, 6);
  probe.maps.distance = smoothCube(32);
  for (int i = 0; i < 6 * 32 * 32; ++i) probe.maps.distance.face(0, 0)[4 * i + 1] = 0.0f;
  saveBakedProbe(file("a.exr"), probe);
  const LoadedCube loaded = loadCube(file("a.exr"));
  ASSERT_EQ(loaded.radiance.faceSize(), 32);
  EXPECT_TRUE(std::equal(loaded.radiance.face(0, 0), loaded.radiance.face(0, 0) + 6 * 4 * 32 * 32,
                         probe.maps.radiance.face(0, 0)));
  EXPECT_EQ(loaded.distance.texel(0, 4, 3, 2).x, probe.maps.distance.texel(0, 4, 3, 2).x);
}

TEST_F(CubeFile, FacesHaveAPowerOfTwoTexels) {
  saveExr(file("l.exr"), blank(200, 100, 1.0f));
  EXPECT_EQ(loadCube(file("l.exr")).radiance.faceSize(), 64);
  EXPECT_EQ(loadCube(file("l.exr"), CubeLayout::Automatic, 16).radiance.faceSize(), 16);
  saveExr(file("s.exr"), blank(600, 100, 1.0f));
  EXPECT_EQ(loadCube(file("s.exr")).radiance.faceSize(), 128);
  saveExr(file("tiny.exr"), blank(12, 2, 1.0f));
  EXPECT_EQ(loadCube(file("tiny.exr")).radiance.faceSize(), 16);
  EXPECT_EQ(errorText([&] { loadCube(file("l.exr"), CubeLayout::Automatic, 100); }),
            file("l.exr") + ": a face size of 100 was asked for; use a power of two up to 4096");
}

TEST_F(CubeFile, ValuesThatAreNoRadianceAreReplacedAndCounted) {
  ImageRgbaF image = blank(64, 32, 1.0f);
  image.pixels[0] = std::numeric_limits<float>::quiet_NaN();
  image.pixels[5] = std::numeric_limits<float>::infinity();
  image.pixels[6] = -std::numeric_limits<float>::infinity();
  image.pixels[4 * 1000] = 1e9f;
  saveExr(file("a.exr"), image);
  const LoadedCube loaded = loadCube(file("a.exr"));
  EXPECT_EQ(loaded.repairs.notFinite, 2u);
  EXPECT_EQ(loaded.repairs.beyondHalf, 1u);
  for (int i = 0; i < 6 * 4 * loaded.radiance.faceSize() * loaded.radiance.faceSize(); ++i) {
    ASSERT_TRUE(std::isfinite(loaded.radiance.face(0, 0)[i]) && loaded.radiance.face(0, 0)[i] <= 65504.0f);
  }
}

TEST_F(CubeFile, WhatIsNoRadianceIsCountedInEachOfSixFiles) {
  const char* const names[6] = {"px", "nx", "py", "ny", "pz", "nz"};
  for (std::size_t face = 0; face < 6; ++face) {
    ImageRgbaF image = blank(16, 16, 1.0f);
    for (std::size_t i = 0; i <= face; ++i) image.pixels[4 * (7 * i + 3)] = 1e9f;  // 1 to 6 of them
    if (face == 2 || face == 5) image.pixels[4 * (face + 100) + 1] = std::numeric_limits<float>::quiet_NaN();
    saveExr(file(std::string(names[face]) + ".exr"), image);
  }
  const LoadedCube loaded = loadCube(file("px.exr"));
  EXPECT_EQ(loaded.repairs.beyondHalf, 21u);
  EXPECT_EQ(loaded.repairs.notFinite, 2u);
}

TEST_F(CubeFile, SixFilesUnderEveryCommonName) {
  const CubeMap cube = colouredFaces(16);
  saveCubePicture(file("t_%s.exr"), cube, CubeLayout::SixFiles);
  const std::vector<std::vector<std::string>> schemes = {
      {"posx", "negx", "posy", "negy", "posz", "negz"},
      {"room-Right", "room-Left", "room-Top", "room-Bottom", "room-Front", "room-Back"},
      {"a.PX", "a.NX", "a.PY", "a.NY", "a.PZ", "a.NZ"}};
  const char* const own[6] = {"px", "nx", "py", "ny", "pz", "nz"};
  for (const auto& scheme : schemes) {
    for (std::size_t i = 0; i < 6; ++i) {
      std::filesystem::copy_file(file(std::string("t_") + own[i] + ".exr"), file(scheme[i] + ".exr"));
    }
    for (const std::string& name : scheme) {
      EXPECT_TRUE(sameTexels(loadCube(file(name + ".exr")).radiance, cube)) << name;
    }
  }
  EXPECT_TRUE(sameTexels(loadCube(file("room-%s.exr")).radiance, cube));
  std::filesystem::remove(file("posz.exr"));
  EXPECT_NE(errorText([&] { loadCube(file("posx.exr")); }).find("six files"), std::string::npos);
  saveExr(file("t_ny.exr"), blank(8, 8));
  EXPECT_EQ(errorText([&] { loadCube(file("t_px.exr")); }),
            file("t_ny.exr") + ": is 8 x 8 pixels and " + file("t_px.exr") +
                " is 16 x 16 pixels; the six faces must be equal in size");
  saveExr(file("t_ny.exr"), blank(16, 8));
  EXPECT_EQ(errorText([&] { loadCube(file("t_px.exr")); }),
            file("t_ny.exr") + ": is 16 x 8 pixels; a face must be square");
}

/// What other programs write: `type` channels of value 3, tiled or not, a window off the origin.
void writeOther(const std::string& path, const Imath::Box2i& window, const Imath::Box2i& display, Imf::PixelType type,
                const std::vector<std::string>& channels, bool tiled) {
  Imf::Header header(display, window);
  Imf::FrameBuffer buffer;
  const auto width = static_cast<std::size_t>(window.size().x + 1),
             height = static_cast<std::size_t>(window.size().y + 1);
  std::vector<half> halves(width * height, half(3.0f));
  std::vector<float> floats(width * height, 3.0f);
  std::vector<unsigned> whole(width * height, 3u);
  void* const values = type == Imf::HALF ? static_cast<void*>(halves.data())
                                         : (type == Imf::FLOAT ? static_cast<void*>(floats.data()) : whole.data());
  for (const std::string& channel : channels) {
    header.channels().insert(channel, Imf::Channel(type));
    buffer.insert(channel, Imf::Slice::Make(type, values, window));
  }
  if (tiled) {
    header.setTileDescription(Imf::TileDescription(8, 8, Imf::ONE_LEVEL));
    Imf::TiledOutputFile out(path.c_str(), header);
    out.setFrameBuffer(buffer);
    out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
  } else {
    Imf::OutputFile out(path.c_str(), header);
    out.setFrameBuffer(buffer);
    out.writePixels(static_cast<int>(height));
  }
}

TEST_F(CubeFile, EveryPixelTypeChannelSetAndWindow) {
  const Imath::Box2i window({-5, 7}, {-5 + 31, 7 + 15});
  for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT, Imf::UINT}) {
    for (const bool tiled : {false, true}) {
      for (const auto& channels : std::vector<std::vector<std::string>>{{"R", "G", "B"}, {"R", "G", "B", "A"}, {"Y"}}) {
        writeOther(file("a.exr"), window, window, type, channels, tiled);
        const glm::vec4 texel = loadCube(file("a.exr")).radiance.texel(0, 3, 1, 2);
        EXPECT_EQ(texel, glm::vec4(3, 3, 3, channels.size() == 4 ? 3 : 1));
      }
    }
  }
}

TEST_F(CubeFile, ACroppedPictureIsFilledUpToItsDisplayWindow) {
  // The lower half of a lat-long map is all the writer kept.
  writeOther(file("a.exr"), Imath::Box2i({0, 16}, {63, 30}), Imath::Box2i({0, 0}, {63, 31}), Imf::HALF, {"R", "G", "B"},
             false);
  const CubeMap cube = loadCube(file("a.exr")).radiance;
  EXPECT_EQ(cube.texel(0, 2, 8, 8), glm::vec4(0.0f));
  EXPECT_EQ(cube.texel(0, 4, 8, 15).x, 3.0f);
}

// A writer left out five black columns, and rendered more than is shown on the right and below.
TEST_F(CubeFile, APictureBeyondItsDisplayWindowIsCutToIt) {
  writeOther(file("a.exr"), Imath::Box2i({5, 0}, {100, 17}), Imath::Box2i({0, 0}, {95, 15}), Imf::HALF, {"R", "G", "B"},
             false);
  const CubeMap cube = loadCube(file("a.exr")).radiance;
  ImageRgbaF shown = blank(96, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 96; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        shown.pixels[4 * (static_cast<std::size_t>(y) * 96 + static_cast<std::size_t>(x)) + c] = x < 5 ? 0.0f : 3.0f;
      }
    }
  }
  saveExr(file("b.exr"), shown);
  const CubeMap expected = loadCube(file("b.exr"), CubeLayout::Strip).radiance;
  for (int face = 0; face < 6; ++face) {
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        ASSERT_EQ(glm::vec3(cube.texel(0, face, x, y)), glm::vec3(expected.texel(0, face, x, y)))
            << face << " " << x << " " << y;
      }
    }
  }
}

TEST_F(CubeFile, WhatIsNoCubeIsToldInOneLine) {
  saveExr(file("odd.exr"), blank(50, 37));
  EXPECT_EQ(errorText([&] { loadCube(file("odd.exr")); }),
            file("odd.exr") +
                ": is 50 x 37 pixels, which is no layout of a cube; use a 2:1 latitude-longitude map, a "
                "6:1 or 1:6 strip, a 4:3 or 3:4 cross, or six square files");
  EXPECT_EQ(errorText([&] { loadCube(file("odd.exr"), CubeLayout::LatLong); }),
            file("odd.exr") + ": is 50 x 37 pixels; a latitude-longitude map is twice as wide as high");
  saveRadiance(file("odd.hdr"), blank(50, 37));
  EXPECT_EQ(errorText([&] { loadCube(file("odd.hdr"), CubeLayout::LatLong); }),
            file("odd.hdr") + ": is 50 x 37 pixels; a latitude-longitude map is twice as wide as high");
  EXPECT_NE(errorText([&] { loadCube(file("odd.exr"), CubeLayout::Strip); }).find("six times"), std::string::npos);
  EXPECT_NE(errorText([&] { loadCube(file("odd.exr"), CubeLayout::Cross); }).find("4:3"), std::string::npos);
  Imf::Header wrong(64, 64);
  Imf::addEnvmap(wrong, Imf::ENVMAP_CUBE);
  wrong.channels().insert("Y", Imf::Channel(Imf::HALF));
  {
    std::vector<half> values(64 * 64);
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice::Make(Imf::HALF, values.data(), wrong.dataWindow()));
    Imf::OutputFile out(file("w.exr").c_str(), wrong);
    out.setFrameBuffer(buffer);
    out.writePixels(64);
  }
  EXPECT_NE(errorText([&] { loadCube(file("w.exr")); }).find("envmap says cube"), std::string::npos);
  EXPECT_NE(errorText([&] { loadCube(file("gone.exr")); }).find("does not exist"), std::string::npos);
  EXPECT_NE(errorText([&] { loadCube(write("empty.exr", "")); }).find("empty.exr: is not an OpenEXR"),
            std::string::npos);
  EXPECT_NE(errorText([&] { loadCube(folder_.string()); }), "");
}

}  // namespace
}  // namespace boxprobe
