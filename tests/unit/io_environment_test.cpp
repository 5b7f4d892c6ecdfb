// Pictures of the surroundings as their authors meant them: windows, primaries, suns beyond half floats, values that
// are no numbers. The same picture as a sky and for a custom probe.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "filters/io/cube/sky_picture.h"
#include "filters/io/image/image_file.h"
#include "tests/unit/cube_pictures.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kPi = 3.14159265358979323846;

using Paint = std::function<glm::vec3(int x, int y)>;

struct ExrWish {
  std::string red = "R", green = "G", blue = "B";
  std::function<void(Imf::Header&)> header = [](Imf::Header&) {};
};

/// A float file with `data` in `display`; `paint` has the display window's coordinates.
void writeExr(const std::string& path, const Imath::Box2i& display, const Imath::Box2i& data, const Paint& paint,
              const ExrWish& wish = {}) {
  Imf::Header header(display, data);
  wish.header(header);
  std::vector<float> values[3];
  for (int y = data.min.y; y <= data.max.y; ++y) {
    for (int x = data.min.x; x <= data.max.x; ++x) {
      const glm::vec3 color = paint(x - display.min.x, y - display.min.y);
      for (int c = 0; c < 3; ++c) values[c].push_back(color[c]);
    }
  }
  Imf::FrameBuffer buffer;
  const std::string names[3] = {wish.red, wish.green, wish.blue};
  for (int c = 0; c < 3; ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
    buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, values[c].data(), data));
  }
  Imf::OutputFile out(path.c_str(), header);
  out.setFrameBuffer(buffer);
  out.writePixels(data.max.y - data.min.y + 1);
}

Imath::Box2i window(int x, int y, int width, int height) {
  return {{x, y}, {x + width - 1, y + height - 1}};
}

class Environment : public TemporaryFolder {
 protected:
  std::string made(int width, int height, const Paint& paint, const ExrWish& wish = {}) {
    const Imath::Box2i all = window(0, 0, width, height);
    writeExr(file("a.exr"), all, all, paint, wish);
    return file("a.exr");
  }
};

glm::vec3 at(const ImageRgbaF& image, int x, int y) {
  const float* p = &image.pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                      static_cast<std::size_t>(x))];
  return {p[0], p[1], p[2]};
}

glm::vec3 pattern(int x, int y) {
  return {0.25f + 0.5f * static_cast<float>(x), 1.0f + static_cast<float>(y), 2.0f};
}

ImageRgbaF readSky(const std::string& path, PictureRepairs* repairs = nullptr) {
  SkyPictureNotes notes;
  ImageRgbaF image = loadSkyPicture({path}, &notes);
  if (repairs != nullptr) *repairs = notes.repairs;
  return image;
}

TEST_F(Environment, SkiesStandInTheirDisplayWindow) {
  const Imath::Box2i display = window(100, 50, 16, 8);
  const auto inside = [](const Imath::Box2i& box, int x, int y) {
    return x >= box.min.x && x <= box.max.x && y >= box.min.y && y <= box.max.y;
  };
  // Without its nadir; the right part; itself 2:1; more than is shown; elsewhere altogether.
  for (const Imath::Box2i& data : {window(100, 50, 16, 6), window(107, 50, 9, 8), window(103, 52, 8, 4),
                                   window(98, 49, 21, 12), window(300, 50, 16, 8)}) {
    writeExr(file("a.exr"), display, data, pattern);
    const ImageRgbaF sky = readSky(file("a.exr"));
    ASSERT_EQ(sky.width, 16);
    ASSERT_EQ(sky.height, 8);
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 16; ++x) {
        const glm::vec3 right = inside(data, 100 + x, 50 + y) ? pattern(x, y) : glm::vec3(0.0f);
        ASSERT_EQ(at(sky, x, y), right) << x << " " << y;
      }
    }
    const ImageRgbaF whole = sky;
    saveExr(file("b.exr"), whole);
    const CubeMap cube = loadCube(file("a.exr"), CubeLayout::Automatic, 16).radiance,
                  expected = loadCube(file("b.exr"), CubeLayout::LatLong, 16).radiance;
    for (int i = 0; i < 6 * 256; ++i) {
      ASSERT_EQ(cube.face(0, 0)[4 * i], expected.face(0, 0)[4 * i]);
    }
  }
}

// A display window of no layout says nothing about a picture that has one; envmap is about the data window.
TEST_F(Environment, TheDataWindowCountsWhereTheDisplayWindowIsNoLayout) {
  writeExr(file("a.exr"), window(0, 0, 50, 37), window(3, 4, 16, 8),
           [](int x, int y) { return pattern(x - 3, y - 4); });
  EXPECT_EQ(at(readSky(file("a.exr")), 5, 2), pattern(5, 2));
  ExrWish wish;
  wish.header = [](Imf::Header& header) { Imf::addEnvmap(header, Imf::ENVMAP_LATLONG); };
  writeExr(
      file("b.exr"), window(0, 0, 32, 16), window(3, 4, 16, 8), [](int x, int y) { return pattern(x - 3, y - 4); },
      wish);
  EXPECT_EQ(at(readSky(file("b.exr")), 5, 2), pattern(5, 2));
}

TEST_F(Environment, ChromaticitiesAreConverted) {
  // Published matrices: the Academy's AP0 to Rec. 709 (OpenColorIO-Configs, Bradford), ITU-R BT.2087.
  struct Row {
    const char* name;
    Imf::Chromaticities c;
    double matrix[3][3];
  };
  const Row rows[] = {
      {"AP0",
       {{.7347f, .2653f}, {0.0f, 1.0f}, {.0001f, -.077f}, {.32168f, .33767f}},
       {{2.521686, -1.134131, -0.387555}, {-0.276480, 1.372719, -0.096239}, {-0.015378, -0.152975, 1.168353}}},
      {"BT.2020",
       {{.708f, .292f}, {.17f, .797f}, {.131f, .046f}, {.3127f, .329f}},
       {{1.660491, -0.587641, -0.072850}, {-0.124550, 1.132900, -0.008349}, {-0.018151, -0.100579, 1.118730}}},
      {"BT.709", {{.64f, .33f}, {.3f, .6f}, {.15f, .06f}, {.3127f, .329f}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  const glm::vec3 stored(0.8f, 1.1f, 1.7f);
  for (const Row& row : rows) {
    ExrWish wish;
    wish.header = [&](Imf::Header& header) { Imf::addChromaticities(header, row.c); };
    const std::string path = made(
        16, 8, [&](int, int) { return stored; }, wish);
    const glm::vec3 sky = at(readSky(path), 3, 2), picture = at(loadHdrImage(path), 3, 2),
                    probe(loadCube(path, CubeLayout::Automatic, 16).radiance.texel(0, 3, 5, 6));
    for (int c = 0; c < 3; ++c) {
      const double right = row.matrix[c][0] * stored.x + row.matrix[c][1] * stored.y + row.matrix[c][2] * stored.z;
      EXPECT_NEAR(sky[c], right, 5e-4) << row.name;
      EXPECT_NEAR(picture[c], right, 5e-4) << row.name;
      EXPECT_NEAR(probe[c], right, 5e-4) << row.name;
    }
    if (std::string(row.name) == "BT.709") {
      EXPECT_EQ(sky, stored);
    }
  }
  ExrWish flagged;
  flagged.header = [](Imf::Header& header) { header.insert("acesImageContainerFlag", Imf::IntAttribute(1)); };
  const ImageRgbaF aces = readSky(made(
      16, 8, [&](int, int) { return stored; }, flagged));
  EXPECT_NEAR(at(aces, 3, 2).x, 2.521686 * 0.8 - 1.134131 * 1.1 - 0.387555 * 1.7, 5e-4);
  ExrWish nonsense;
  nonsense.header = [](Imf::Header& header) { Imf::addChromaticities(header, {{0, 0}, {0, 0}, {0, 0}, {0, 0}}); };
  PictureRepairs repairs;
  EXPECT_EQ(at(readSky(made(
                           16, 8, [&](int, int) { return stored; }, nonsense),
                       &repairs),
               3, 2),
            stored);
  EXPECT_THAT(repairs.sentences(),
              ElementsAre("attribute chromaticities is not followed: its primaries span no colours"));
}

TEST_F(Environment, LayersAreFoundByTheirNames) {
  for (const char* prefix : {"ViewLayer.Combined.", "beauty.", ""}) {
    const bool lower = *prefix == '\0';
    const std::string p = prefix;
    made(16, 8, pattern,
         {p + (lower ? "r" : "R"), p + (lower ? "g" : "G"), p + (lower ? "b" : "B"), [](Imf::Header&) {}});
    EXPECT_EQ(at(readSky(file("a.exr")), 5, 2), pattern(5, 2)) << prefix;
  }
}

// Written by OpenEXR's own class for luminance and chroma, whose filters blur hues by a texel or two: a smooth picture.
TEST_F(Environment, LuminanceAndChromaAreColours) {
  constexpr int kWidth = 64, kHeight = 32;
  const auto paint = [](int x, int y) {
    const double along = 2.0 * kPi * x / kWidth, down = kPi * y / kHeight;
    return glm::vec3(2.0 + std::sin(along), 1.0 + 0.5 * std::cos(along + down), 3.0 - 2.0 * std::sin(down));
  };
  const Imf::Chromaticities rec2020({0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.3290f});
  const Imf::Chromaticities xyz({1.0f, 0.0f}, {0.0f, 1.0f}, {0.0f, 0.0f}, {0.3127f, 0.3290f});
  const glm::dmat3 toRec2020({0.6274, 0.0691, 0.0164}, {0.3293, 0.9195, 0.0880},
                             {0.0433, 0.0114, 0.8956});  // ITU-R BT.2087
  // IEC 61966-2-1, over the white's X and Z: as primaries, each of X, Y and Z is 1 in white.
  const glm::dmat3 toXyz({0.4124 / 0.9505, 0.2126, 0.0193 / 1.0890}, {0.3576 / 0.9505, 0.7152, 0.1192 / 1.0890},
                         {0.1805 / 0.9505, 0.0722, 0.9505 / 1.0890});
  struct Primaries {
    const char* name;
    const Imf::Chromaticities* written;
    glm::dmat3 fromRec709;
  };
  for (const auto& [name, written, fromRec709] :
       {Primaries{"Rec. 709", nullptr, glm::dmat3(1.0)}, Primaries{"Rec. 2020", &rec2020, toRec2020},
        Primaries{"XYZ", &xyz, toXyz}}) {
    std::vector<Imf::Rgba> pixels;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const glm::vec3 color(fromRec709 * glm::dvec3(paint(x, y)));
        pixels.emplace_back(color.x, color.y, color.z);
      }
    }
    {
      Imf::Header header(kWidth, kHeight);
      if (written != nullptr) Imf::addChromaticities(header, *written);
      Imf::RgbaOutputFile out(file("a.exr").c_str(), header, Imf::WRITE_YC);
      out.setFrameBuffer(pixels.data(), 1, kWidth);
      out.writePixels(kHeight);
    }
    const ImageRgbaF sky = readSky(file("a.exr"));
    double worst = 0.0;
    for (int y = 4; y < kHeight - 4; ++y) {
      for (int x = 4; x < kWidth - 4; ++x) {
        const glm::vec3 right = paint(x, y), drawn = at(sky, x, y);
        for (int c = 0; c < 3; ++c) worst = std::max<double>(worst, std::abs(drawn[c] / right[c] - 1.0f));
      }
    }
    EXPECT_LT(worst, 0.02) << name;
  }
}

/// A rendered file of several parts: a depth layer, named by its layer or not, is no picture beside colours.
TEST_F(Environment, ColoursComeBeforeOtherParts) {
  constexpr int kWidth = 8, kHeight = 4;
  const std::vector<std::pair<const char*, float>> color = {
      {"View.Combined.R", 0.25f}, {"View.Combined.G", 0.5f}, {"View.Combined.B", 0.75f}};
  const std::vector<std::vector<std::pair<const char*, float>>> others = {
      {{"View.Depth.Z", 9.0f}}, {{"depth.Z", 9.0f}}, {{"View.Mist.Fog", 9.0f}}, {{"Z", 9.0f}}};
  for (const auto& other : others) {
    for (const bool first : {true, false}) {
      std::vector<std::vector<std::pair<const char*, float>>> parts = {color};
      parts.insert(first ? parts.begin() : parts.end(), other);
      std::vector<Imf::Header> headers;
      for (std::size_t part = 0; part < parts.size(); ++part) {
        Imf::Header header(kWidth, kHeight);
        header.setName("part " + std::to_string(part));
        header.setType(Imf::SCANLINEIMAGE);
        for (const auto& [name, value] : parts[part]) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        headers.push_back(header);
      }
      {
        Imf::MultiPartOutputFile out(file("parts.exr").c_str(), headers.data(), static_cast<int>(headers.size()));
        for (std::size_t part = 0; part < parts.size(); ++part) {
          std::vector<std::vector<float>> values;
          Imf::FrameBuffer buffer;
          for (const auto& [name, value] : parts[part]) {
            values.emplace_back(kWidth * kHeight, value);
            buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.back().data()), sizeof(float),
                                           sizeof(float) * kWidth));
          }
          Imf::OutputPart written(out, static_cast<int>(part));
          written.setFrameBuffer(buffer);
          written.writePixels(kHeight);
        }
      }
      const ImageRgbaF sky = readSky(file("parts.exr"));
      EXPECT_EQ(at(sky, 3, 2), glm::vec3(0.25f, 0.5f, 0.75f)) << other.front().first << (first ? " first" : " last");
    }
  }
}

TEST_F(Environment, OneChannelIsGreyWhateverItsName) {
  for (const char* name : {"V", "R", "luma"}) {
    const Imath::Box2i all = window(0, 0, 8, 4);
    Imf::Header header(all, all);
    std::vector<float> values(32);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.25f * static_cast<float>(i);
    Imf::FrameBuffer buffer;
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), all));
    {
      Imf::OutputFile out(file("a.exr").c_str(), header);
      out.setFrameBuffer(buffer);
      out.writePixels(4);
    }
    EXPECT_EQ(at(readSky(file("a.exr")), 5, 2), glm::vec3(0.25f * 21)) << name;
  }
}

TEST_F(Environment, InfinityIsBrightAndNanHasTheHueAround) {
  const glm::vec3 around(0.25f, 1.0f, 2.0f);
  const auto with = [&](const glm::vec3& odd) {
    PictureRepairs repairs;
    const ImageRgbaF sky =
        readSky(made(16, 8, [&](int x, int y) { return x == 0 && y == 5 ? odd : around; }), &repairs);
    EXPECT_EQ(repairs.notFinite, 1u);
    EXPECT_EQ(repairs.sentences().size(), 1u);
    return at(sky, 0, 5);
  };
  EXPECT_EQ(with({kInfinity, kInfinity, 60000.0f}), glm::vec3(65504.0f, 65504.0f, 60000.0f));
  EXPECT_EQ(with({kNan, 1.0f, 2.0f}), around);
  EXPECT_EQ(with({kNan, 10.0f, 20.0f}), glm::vec3(2.5f, 10.0f, 20.0f));
  EXPECT_EQ(with(glm::vec3(kNan)), around);
  EXPECT_EQ(with({1.0f, -kInfinity, 2.0f}), glm::vec3(1.0f, 0.0f, 2.0f));
  // Two of them side by side across the seam: neither counts for the other.
  const ImageRgbaF pair =
      readSky(made(16, 8, [&](int x, int y) { return (x == 0 || x == 15) && y == 5 ? glm::vec3(kNan) : around; }));
  EXPECT_EQ(at(pair, 0, 5), around);
  EXPECT_EQ(at(pair, 15, 5), around);
}

TEST_F(Environment, NegativeRadianceIsNone) {
  PictureRepairs repairs;
  const ImageRgbaF sky = readSky(
      made(16, 8, [](int x, int y) { return x == 4 && y == 2 ? glm::vec3(-1, 1, 2) : pattern(x, y); }), &repairs);
  EXPECT_EQ(at(sky, 4, 2), glm::vec3(0, 1, 2));
  EXPECT_EQ(repairs.negative, 1u);
  EXPECT_EQ(at(loadHdrImage(file("a.exr")), 4, 2), glm::vec3(-1, 1, 2)) << "a picture that is no environment keeps it";
}

/// What a viewer at the origin who faces +Z, head up, sees ahead, to the right and above: a photograph without
/// symmetry.
glm::vec3 photograph(const glm::dvec3& direction) {
  const double ahead = direction.z, right = -direction.x, up = direction.y;
  const double most = std::max({std::fabs(ahead), std::fabs(right), std::fabs(up)});
  const auto part = [most](double v) { return static_cast<float>(1.0 + 0.5 * v / most); };
  return {part(ahead), part(right), part(up)};
}

/// A square of a drawn cross: what is seen at (s, t), -1 to 1 to the right and down, by a camera with these axes.
struct Shot {
  int column, row;
  glm::dvec3 forward, right, down;
};

TEST_F(Environment, APhotographIsTheSameAsLatitudeLongitudeAndAsACrossOrStripFromInside) {
  // The viewer's axes in the world, and the six pictures of a head that turns.
  const glm::dvec3 ahead(0, 0, 1), right(-1, 0, 0), up(0, 1, 0);
  const std::vector<Shot> wide = {{1, 1, ahead, right, -up},  {2, 1, right, -ahead, -up}, {3, 1, -ahead, -right, -up},
                                  {0, 1, -right, ahead, -up}, {1, 0, up, right, ahead},   {1, 2, -up, right, -ahead}};
  std::vector<Shot> tall = wide;
  tall[2] = {1, 3, -ahead, right, up};  // below the floor, upside down
  // Right, left, up, down, ahead, behind.
  const std::vector<Shot> strip = {{0, 0, right, -ahead, -up}, {1, 0, -right, ahead, -up}, {2, 0, up, right, ahead},
                                   {3, 0, -up, right, -ahead}, {4, 0, ahead, right, -up},  {5, 0, -ahead, -right, -up}};
  constexpr int n = 16;
  const auto draw = [&](const std::string& name, int columns, int rows, const std::vector<Shot>& shots) {
    writeExr(file(name), window(0, 0, columns * n, rows * n), window(0, 0, columns * n, rows * n), [&](int x, int y) {
      for (const Shot& shot : shots) {
        if (shot.column != x / n || shot.row != y / n) continue;
        const double s = (2.0 * (x % n) + 1.0) / n - 1.0, t = (2.0 * (y % n) + 1.0) / n - 1.0;
        return photograph(shot.forward + s * shot.right + t * shot.down);
      }
      return glm::vec3(0.0f);
    });
  };
  draw("wide.exr", 4, 3, wide);
  draw("tall.exr", 3, 4, tall);
  draw("strip.exr", 6, 1, strip);
  writeExr(file("map.exr"), window(0, 0, 128, 64), window(0, 0, 128, 64), [&](int x, int y) {
    // Ahead in the middle, the viewer's right to the right of it.
    const double around = ((x + 0.5) / 64 - 1.0) * kPi, above = (0.5 - (y + 0.5) / 64) * kPi;
    return photograph(std::cos(above) * std::cos(around) * ahead + std::cos(above) * std::sin(around) * right +
                      std::sin(above) * up);
  });
  const ImageRgbaF map = readSky(file("map.exr"));
  for (const char* name : {"wide.exr", "tall.exr", "strip.exr"}) {
    SkyPictureNotes notes;
    const ImageRgbaF inside = loadSkyPicture({file(name), CubeView::Inside}, &notes);
    EXPECT_EQ(notes.layout, std::string(name) == "strip.exr" ? CubeLayout::Strip : CubeLayout::Cross);
    const ImageRgbaF outside = loadSkyPicture({file(name)});
    double worst = 0.0, mirrored = 0.0;
    for (int y = 2; y < 62; ++y) {
      for (int x = 0; x < 128; ++x) {
        const auto apart = [&](const ImageRgbaF& cube) {
          // Texels of a resampled cube lie on the edges: x = 0 and x = 63 are the same direction.
          const double longitude = (x + 0.5) / 128 * 63, latitude = (y + 0.5) / 64 * 31;
          const glm::vec3 d =
              at(cube, static_cast<int>(longitude + 0.5), static_cast<int>(latitude + 0.5)) - at(map, x, y);
          return static_cast<double>(std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)}));
        };
        worst = std::max(worst, apart(inside));
        mirrored = std::max(mirrored, apart(outside));
      }
    }
    EXPECT_LT(worst, 0.12) << name;
    EXPECT_GT(mirrored, 0.9) << name << ": from outside right and left are exchanged";
    // The custom probe of the same file, texel by texel.
    Probe probe;
    probe.image = file(name);
    probe.cubeView = CubeView::Inside;
    const CubeMap cube = loadCustomCube(probe, n).radiance;
    for (int face = 0; face < 6; ++face) {
      for (int i = 0; i < n * n; ++i) {
        const auto along = [](int k) { return (2.0f * static_cast<float>(k) + 1.0f) / n - 1.0f; };
        const glm::vec3 expected = photograph(shading::cubeDirection(face, along(i % n), along(i / n)));
        const glm::vec4 texel = cube.texel(0, face, i % n, i / n);
        ASSERT_LT(glm::length(glm::vec3(texel) - expected), 1e-5f) << name << " face " << face << " texel " << i;
      }
    }
  }
  // A file that says how its faces lie is not asked.
  saveCubePicture(file("own.exr"), smoothCube(16), CubeLayout::Strip);
  SkyPictureNotes notes;
  EXPECT_EQ(loadSkyPicture({file("own.exr"), CubeView::Inside}, &notes).pixels,
            loadSkyPicture({file("own.exr")}).pixels);
  EXPECT_THAT(notes.repairs.sentences(), ElementsAre(HasSubstr("cubeView has no effect")));
}

// The sky's rule: 90 degrees take what is at +Z to +X, and so what is at -X to +Z.
TEST_F(Environment, ACustomPictureIsTurnedAboutTheVertical) {
  saveCubePicture(file("faces.exr"), colouredFaces(32), CubeLayout::Cross);
  Probe probe;
  probe.image = file("faces.exr");
  probe.imageRotationDegrees = 90.0;
  const CubeMap cube = loadCustomCube(probe, 32).radiance;
  const int from[6] = {4, 5, 2, 3, 1, 0};  // +X shows the file's +Z, -X its -Z, +Z its -X, -Z its +X
  for (int face = 0; face < 6; ++face) {
    EXPECT_LT(glm::length(glm::vec3(cube.texel(0, face, 13, 18)) - faceColor(from[face])), 1e-5f) << face;
  }
  probe.imageRotationDegrees = 360.0;
  EXPECT_TRUE(sameTexels(loadCustomCube(probe, 32).radiance, colouredFaces(32)));
}

/// Irradiance on a surface that faces `normal`, by summing a latitude-longitude map.
glm::dvec3 irradianceOf(const ImageRgbaF& sky, const glm::dvec3& normal) {
  glm::dvec3 sum(0.0);
  for (int y = 0; y < sky.height; ++y) {
    const double top = kPi / 2 - kPi * y / sky.height, low = kPi / 2 - kPi * (y + 1) / sky.height,
                 mid = (top + low) / 2;
    for (int x = 0; x < sky.width; ++x) {
      const double longitude = kPi - 2 * kPi * (x + 0.5) / sky.width;
      const glm::dvec3 d(std::cos(mid) * std::sin(longitude), std::sin(mid), std::cos(mid) * std::cos(longitude));
      const double weight = 2 * kPi / sky.width * (std::sin(top) - std::sin(low)) * std::max(glm::dot(d, normal), 0.0);
      sum += weight * glm::dvec3(at(sky, x, y));
    }
  }
  return sum;
}

TEST_F(Environment, ASunBeyondHalfFloatsKeepsItsEnergyAndHue) {
  // (1e6, 8e5, 2e5) in one texel of 64 x 32, elevation 36 degrees.
  const int sunX = 31, sunY = 9;
  const Paint paint = [&](int x, int y) {
    return x == sunX && y == sunY ? glm::vec3(1e6f, 8e5f, 2e5f) : glm::vec3(0.5f);
  };
  const std::string path = made(64, 32, paint);
  PictureRepairs repairs;
  const ImageRgbaF sky = readSky(path, &repairs);
  EXPECT_EQ(repairs.beyondHalf, 1u);
  EXPECT_EQ(repairs.lightLost, 0.0);
  EXPECT_THAT(repairs.sentences(), ElementsAre(HasSubstr("1 texel is above 65504")));
  const double top = kPi / 2 - kPi * sunY / 32, low = kPi / 2 - kPi * (sunY + 1) / 32, mid = (top + low) / 2;
  const double texel = 2 * kPi / 64 * (std::sin(top) - std::sin(low)), longitude = kPi - 2 * kPi * (sunX + 0.5) / 64;
  const glm::dvec3 sun(std::cos(mid) * std::sin(longitude), std::sin(mid), std::cos(mid) * std::cos(longitude));
  for (const glm::dvec3& normal : {glm::dvec3(0, 1, 0), sun, glm::normalize(glm::dvec3(0.5, 0.2, 0.8))}) {
    const glm::dvec3 got = irradianceOf(sky, normal);
    for (int c = 0; c < 3; ++c) {
      const double right =
          kPi * 0.5 + texel * (glm::dvec3(1e6, 8e5, 2e5)[c] - 0.5) * std::max(glm::dot(sun, normal), 0.0);
      EXPECT_NEAR(got[c] / right, 1.0, 0.025) << c << " facing " << normal.x << " " << normal.y << " " << normal.z;
    }
  }
  for (const float value : sky.pixels) ASSERT_LE(value, 65504.0f);
  EXPECT_EQ(at(sky, 50, 20), glm::vec3(0.5f)) << "far from the sun nothing changes";

  // As a custom probe: the energy over the sphere, and no texel beyond.
  const LoadedCube loaded = loadCube(path, CubeLayout::Automatic, 64);
  EXPECT_EQ(loaded.repairs.beyondHalf, 1u);
  const glm::dvec4 all = energy(loaded.radiance);
  EXPECT_NEAR(all.x / (0.5 * 4 * kPi + texel * 1e6), 1.0, 0.01);
  EXPECT_NEAR(all.z / (0.5 * 4 * kPi + texel * 2e5), 1.0, 0.01);
  for (int i = 0; i < 6 * 4 * 64 * 64; ++i) ASSERT_LE(loaded.radiance.face(0, 0)[i], 65504.0f);
}

TEST_F(Environment, LightThatNoDiscTakesIsCutAndTold) {
  PictureRepairs repairs;
  const ImageRgbaF sky = readSky(
      made(64, 32, [](int x, int y) { return x == 40 && y == 12 ? glm::vec3(1e9f, 5e8f, 0.0f) : glm::vec3(1.0f); }),
      &repairs);
  EXPECT_EQ(at(sky, 40, 12), glm::vec3(65504.0f, 32752.0f, 0.0f)) << "its hue stays";
  EXPECT_EQ(at(sky, 41, 12), glm::vec3(1.0f));
  EXPECT_GT(repairs.lightLost, 0.99);
  EXPECT_THAT(repairs.sentences(), ElementsAre(HasSubstr("% of the picture's light is cut off")));
}

/// A sky without symmetry, and in it an even disc: texels near it have what 8 x 8 points of them see.
struct DiscSky {
  glm::dvec3 sun = glm::normalize(glm::dvec3(0.5, 0.7, 0.9)), radiance{4000.0, 3200.0, 1600.0};
  double radius = 1.1 * kPi / 180.0;

  static glm::dvec3 around(const glm::dvec3& d) { return glm::dvec3(0.5, 0.6, 0.9) * (1.0 + 0.4 * d.x + 0.3 * d.y); }
  static glm::dvec3 direction(double x, double y, int width, int height) {
    const double longitude = kPi - 2 * kPi * x / width, latitude = kPi / 2 - kPi * y / height;
    return {std::cos(latitude) * std::sin(longitude), std::sin(latitude), std::cos(latitude) * std::cos(longitude)};
  }
  glm::vec3 texel(int x, int y, int width, int height) const {
    const glm::dvec3 middle = direction(x + 0.5, y + 0.5, width, height);
    if (glm::length(middle - sun) > radius + 2 * kPi / width) return around(middle);
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 64; ++i) {
      const glm::dvec3 d = direction(x + (i % 8 + 0.5) / 8, y + (i / 8 + 0.5) / 8, width, height);
      sum += around(d) + (glm::length(d - sun) < 2.0 * std::sin(0.5 * radius) ? radiance : glm::dvec3(0.0));
    }
    return sum / 64.0;
  }
  Paint paint(int width, int height) const {
    return [=, *this](int x, int y) { return texel(x, y, width, height); };
  }
};

DrawnSky drawnSky(const std::string& path, SkySunForm form = SkySunForm::Lamp) {
  SkyImage image{path};
  image.sun = form;
  return loadDrawnSky(image);
}

TEST_F(Environment, ASunIsTakenOutAsALightOfItsEnergyDirectionAndWidth) {
  const DiscSky disc;
  const DrawnSky sky = drawnSky(made(720, 360, disc.paint(720, 360)));
  ASSERT_TRUE(sky.sun);
  EXPECT_NEAR(glm::length(sky.sun->towards - disc.sun), 0.0, 0.0005);
  EXPECT_NEAR(sky.sun->angleDegrees, 2.2, 0.1);
  for (const glm::dvec3& normal : {glm::dvec3(0, 1, 0), disc.sun, glm::normalize(glm::dvec3(0.9, 0.2, -0.1)),
                                   glm::normalize(glm::dvec3(-0.5, -0.2, -0.8))}) {
    // Of the whole: a linear sky sheds pi times itself at 2/3 of the normal; a disc its solid angle's share.
    const glm::dvec3 smooth = kPi * glm::dvec3(0.5, 0.6, 0.9) * (1.0 + 2.0 / 3.0 * (0.4 * normal.x + 0.3 * normal.y));
    const double sine = std::sin(disc.radius), cosine = std::max(glm::dot(disc.sun, normal), 0.0);
    const glm::dvec3 right = smooth + kPi * sine * sine * cosine * disc.radiance;
    const Light light = lightOf(*sky.sun, 0.0);
    const double meets = std::max(-glm::dot(glm::normalize(light.direction), normal), 0.0);
    const glm::dvec3 rest = irradianceOf(sky.image, normal);
    const glm::dvec3 got = rest + meets * static_cast<double>(light.intensity) * glm::dvec3(light.color);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(got[c] / right[c], 1.0, 0.01) << c << " facing " << normal.x << " " << normal.y << " " << normal.z;
      EXPECT_NEAR(rest[c] / smooth[c], 1.0, 0.01) << "a part of the sun stays in the sky";
    }
  }
}

TEST_F(Environment, ASunsLightTurnsWithTheSky) {
  // In the middle of the picture, which is +Z, a third of the way up; 90 degrees take +Z to +X.
  DiscSky disc;
  disc.sun = glm::normalize(glm::dvec3(0.0, 1.0, 2.0));
  const DrawnSky sky = drawnSky(made(360, 180, disc.paint(360, 180)));
  ASSERT_TRUE(sky.sun);
  const auto from = [&](double degrees) { return -glm::normalize(lightOf(*sky.sun, degrees).direction); };
  const double high = 1 / std::sqrt(5.0), far = 2 / std::sqrt(5.0);
  EXPECT_NEAR(glm::length(from(0) - glm::dvec3(0, high, far)), 0.0, 0.002);
  EXPECT_NEAR(glm::length(from(90) - glm::dvec3(far, high, 0)), 0.0, 0.002);
  EXPECT_NEAR(glm::length(from(-450) - glm::dvec3(-far, high, 0)), 0.0, 0.002);
}

TEST_F(Environment, ASkyWithoutACompactSunStaysAsItIs) {
  DiscSky wide, faint, dim, pair;
  wide.radius = 5.0 * kPi / 180.0;  // a softbox
  wide.radiance = glm::dvec3(9000.0);
  faint.radiance = glm::dvec3(60.0);  // a bright spot
  dim.radius = 0.4 * kPi / 180.0;     // too little light for a shadow to be seen
  dim.radiance = glm::dvec3(1500.0);
  for (const DiscSky& disc : {wide, faint, dim}) {
    const std::string path = made(360, 180, disc.paint(360, 180));
    const DrawnSky sky = drawnSky(path);
    EXPECT_FALSE(sky.sun) << disc.radius << " " << disc.radiance.x;
    EXPECT_EQ(sky.image.pixels, readSky(path).pixels);
  }
  // Two discs 7 degrees apart are no sun: further than 3.5 degrees from the middle there is light of theirs.
  const glm::dvec3 beside = glm::normalize(pair.sun + glm::dvec3(0.0, 0.16, 0.0));
  DiscSky other = pair;
  other.sun = beside;
  const std::string path =
      made(360, 180, [&](int x, int y) { return glm::max(pair.texel(x, y, 360, 180), other.texel(x, y, 360, 180)); });
  EXPECT_FALSE(drawnSky(path).sun);
  EXPECT_TRUE(drawnSky(made(360, 180, pair.paint(360, 180))).sun);
  const std::string kept = made(360, 180, pair.paint(360, 180));
  const DrawnSky asked = drawnSky(kept, SkySunForm::InPicture);
  EXPECT_FALSE(asked.sun);
  EXPECT_EQ(asked.image.pixels, readSky(kept).pixels);
}

TEST_F(Environment, ASunBeyondHalfFloatsBecomesALight) {
  const int sunX = 31, sunY = 9;
  const DrawnSky sky = drawnSky(made(
      64, 32, [&](int x, int y) { return x == sunX && y == sunY ? glm::vec3(1e6f, 8e5f, 2e5f) : glm::vec3(0.5f); }));
  ASSERT_TRUE(sky.sun);
  EXPECT_TRUE(sky.notes.repairs.sentences().empty()) << "nothing is lost or spread";
  const double top = kPi / 2 - kPi * sunY / 32, low = kPi / 2 - kPi * (sunY + 1) / 32;
  const double texel = 2 * kPi / 64 * (std::sin(top) - std::sin(low));
  EXPECT_NEAR(sky.sun->irradiance.x / (texel * 1e6), 1.0, 0.001);
  EXPECT_NEAR(sky.sun->irradiance.z / (texel * 2e5), 1.0, 0.001);
  for (std::size_t i = 0; i < sky.image.pixels.size(); i += 4) ASSERT_NEAR(sky.image.pixels[i], 0.5f, 1e-6f);
}

TEST_F(Environment, ASunInACrossBecomesALight) {
  constexpr int kFace = 64;
  CubeMap cube(kFace, 1);
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < kFace * kFace; ++i) cube.setTexel(0, face, i % kFace, i / kFace, {0.5f, 0.5f, 0.5f, 1.0f});
  }
  cube.setTexel(0, 0, 20, 45, {2e5f, 1e5f, 4e4f, 1.0f});  // on +X
  CubePictureOptions options;
  options.precision = ExrPrecision::Float;
  saveCubePicture(file("cross.exr"), cube, CubeLayout::Cross, options);
  const DrawnSky sky = drawnSky(file("cross.exr"));
  ASSERT_TRUE(sky.sun);
  // OpenGL: on +X, s grows towards -Z and t towards -Y.
  const double s = 2 * 20.5 / kFace - 1, t = 2 * 45.5 / kFace - 1, square = 1 + s * s + t * t;
  EXPECT_NEAR(glm::length(sky.sun->towards - glm::dvec3(1, -t, -s) / std::sqrt(square)), 0.0, 1e-5);
  const double angle = 4.0 / (kFace * kFace) / (square * std::sqrt(square));
  EXPECT_NEAR(sky.sun->irradiance.x / (angle * 2e5), 1.0, 0.001);
  for (const float value : sky.image.pixels) ASSERT_LE(value, 1.001f);
}

}  // namespace
}  // namespace boxprobe
