// OpenEXR pictures of other programs: which channel becomes which, chroma between its samples, windows, primaries.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <gmock/gmock.h>

#include <cstdint>
#include <functional>

#include "filters/io/image/color_primaries.h"
#include "filters/io/image/exr_reader.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::HasSubstr;

struct Stored {
  std::string name;
  Imf::PixelType type = Imf::FLOAT;
  int stepX = 1, stepY = 1;
};

class ExrReader : public TemporaryFolder {
 protected:
  /// Channels in this order hold 2, 3, 4 ..., a quarter more in each sample, row by row.
  std::string made(const std::vector<Stored>& channels, const Imath::Box2i& display, const Imath::Box2i& data,
                   const std::function<void(Imf::Header&)>& change = {}) const {
    Imf::Header header(display, data);
    if (change) change(header);
    Imf::FrameBuffer buffer;
    std::vector<std::vector<float>> floats(channels.size());
    std::vector<std::vector<unsigned>> whole(channels.size());
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const Stored& channel = channels[c];
      const int width = (data.max.x - data.min.x + 1) / channel.stepX,
                height = (data.max.y - data.min.y + 1) / channel.stepY;
      for (int i = 0; i < width * height; ++i) {
        floats[c].push_back(2.0f + static_cast<float>(c) + 0.25f * static_cast<float>(i));
        whole[c].push_back(7);
      }
      header.channels().insert(channel.name, Imf::Channel(channel.type, channel.stepX, channel.stepY));
      void* const values = channel.type == Imf::UINT ? static_cast<void*>(whole[c].data()) : floats[c].data();
      buffer.insert(channel.name, Imf::Slice::Make(channel.type, values, data, 4, 4 * static_cast<std::size_t>(width),
                                                   channel.stepX, channel.stepY));
    }
    Imf::OutputFile out(file("a.exr").c_str(), header);
    out.setFrameBuffer(buffer);
    out.writePixels(data.max.y - data.min.y + 1);
    return file("a.exr");
  }
  ExrPicture readFile(const std::string& path) const {
    ExrPicture picture;
    withExrFile(path, [&](Imf::MultiPartInputFile& exr) { picture = readExrPart(exr, picturePart(exr, path), path); });
    return picture;
  }
  /// Red, green, blue and alpha of the first pixel, "-" for no alpha channel, and the distance if there is one; else
  /// what is said.
  std::string channelsOf(const std::string& names) const {
    std::istringstream words(names);
    std::vector<Stored> channels;
    for (std::string word; words >> word;) channels.push_back({word});
    const Imath::Box2i window({0, 0}, {3, 1});
    made(channels, window, window);
    try {
      const ExrPicture picture = readFile(file("a.exr"));
      std::ostringstream text;
      for (std::size_t c = 0; c < 4; ++c) text << picture.image.pixels[c] << (c < 3 ? " " : "");
      text << (picture.hasAlpha ? "" : "-");
      if (!picture.distance.empty()) text << " d" << picture.distance[0];
      return text.str();
    } catch (const InputError& error) {
      return std::string(error.what()).substr(file("a.exr").size());
    }
  }
};

TEST_F(ExrReader, EachChannelIsFoundByItsName) {
  const std::string needed = "; R, G and B, or luminance Y, alone or with RY and BY, are needed";
  const std::pair<const char*, std::string> rows[] = {
      {"R G B", "2 3 4 1-"},
      {"B G R A", "4 3 2 5"},
      {"r g b a", "2 3 4 5"},
      {"r g b R G B", "5 6 7 1-"},
      {"r g b x.R x.G x.B", "2 3 4 1-"},
      {"R G x.R x.G x.B x.A", "4 5 6 7"},
      {"a.R a.G a.B b.R b.G b.B", "2 3 4 1-"},
      {"a.R a.G a.B Combined.R Combined.G Combined.B", "5 6 7 1-"},
      {"a.R a.G a.B v.Combined.R v.Combined.G v.Combined.B v.Combined.A", "5 6 7 8"},
      {"a.R a.G a.B vCombined.R vCombined.G vCombined.B", "2 3 4 1-"},
      {"v.Combined.x.R v.Combined.x.G v.Combined.x.B b.R b.G b.B", "5 6 7 1-"},
      {"a.R a.G c.R c.G c.B", "4 5 6 1-"},
      {"a.r a.g a.b a.a", "2 3 4 5"},
      {"a.r a.G a.b c.r c.g c.b", "5 6 7 1-"},
      {"R G B Z", "2 3 4 1- d5"},
      {"R G B Z distance", "2 3 4 1- d6"},
      {"R G B distance", "2 3 4 1- d5"},
      {"Y", "2 2 2 1-"},
      {"Y A", "2 2 2 3"},
      {"Y Z V", "2 2 2 1- d3"},
      {"V", "2 2 2 1-"},
      {"x.V", "2 2 2 1-"},
      {"x.y.V", "2 2 2 1-"},
      {"V A", ": part 0 has the channels A, V" + needed},
      {"V W", ": part 0 has the channels V, W" + needed},
      {"Y RY", ": part 0 has the channels RY, Y" + needed},
      {"BY Y", ": part 0 has the channels BY, Y" + needed},
      {"R G", ": part 0 has the channels G, R" + needed},
      {"G B", ": part 0 has the channels B, G" + needed},
      {"R B", ": part 0 has the channels B, R" + needed},
      {"Z", ": part 0 has the channels Z" + needed},
      {"x.Z", ": part 0 has the channels x.Z" + needed},
      {"distance", ": part 0 has the channels distance" + needed},
      {"A", ": part 0 has the channels A" + needed},
      {"x.a", ": part 0 has the channels x.a" + needed}};
  for (const auto& [names, expected] : rows) EXPECT_EQ(channelsOf(names), expected) << names;
}

TEST_F(ExrReader, WhatIsNoPictureIsSaid) {
  const Imath::Box2i window({0, 0}, {3, 1});
  const auto said = [&](const std::vector<Stored>& channels, const std::function<void(Imf::Header&)>& change = {}) {
    return errorText([&] { readFile(made(channels, window, window, change)); }).substr(file("a.exr").size());
  };
  for (const std::size_t odd : {0u, 1u, 2u, 3u, 4u}) {
    std::vector<Stored> channels = {{"R"}, {"G"}, {"B"}, {"A"}, {"Z"}};
    for (const bool wide : {true, false}) {
      channels[odd].stepX = wide ? 2 : 1;
      channels[odd].stepY = wide ? 1 : 2;
      EXPECT_EQ(said(channels),
                ": part 0: channel " + channels[odd].name + " is subsampled; save it at full resolution");
    }
  }
  EXPECT_THAT(said({{"id", Imf::UINT}}), HasSubstr("has the channels id; R, G and B"));
  EXPECT_EQ(said({{"Y"}}, [](Imf::Header& header) { Imf::addEnvmap(header, static_cast<Imf::Envmap>(2)); }),
            ": part 0: attribute envmap is 2; 0 (lat-long) and 1 (cube) are known");
}

TEST_F(ExrReader, WindowsAndKindsAreAsInTheHeader) {
  const auto as = [](Imf::Envmap kind) { return [kind](Imf::Header& header) { Imf::addEnvmap(header, kind); }; };
  const ExrPicture cube =
      readFile(made({{"R"}, {"G"}, {"B"}}, {{-4, 3}, {12, 9}}, {{-9, 1}, {20, 11}}, as(Imf::ENVMAP_CUBE)));
  EXPECT_EQ(cube.image.width, 30);
  EXPECT_EQ(cube.image.height, 11);
  EXPECT_EQ(cube.displayWidth, 17);
  EXPECT_EQ(cube.displayHeight, 7);
  EXPECT_EQ(cube.offsetX, -5);
  EXPECT_EQ(cube.offsetY, -2);
  EXPECT_EQ(cube.envmap, EnvmapKind::Cube);
  EXPECT_FALSE(cube.primaries);
  for (std::size_t i = 0; i < 330; ++i) {
    const float wanted = 2.0f + 0.25f * static_cast<float>(i);
    ASSERT_EQ(cube.image.pixels[4 * i], wanted);
    ASSERT_EQ(cube.image.pixels[4 * i + 2], wanted + 2.0f);
    ASSERT_EQ(cube.image.pixels[4 * i + 3], 1.0f);
  }
  const Imath::Box2i window({0, 0}, {3, 1});
  EXPECT_EQ(readFile(made({{"Y"}}, window, window, as(Imf::ENVMAP_LATLONG))).envmap, EnvmapKind::LatLong);
  EXPECT_FALSE(readFile(made({{"Y"}}, window, window)).envmap);
  const auto colours = [](Imf::Header& header) {
    Imf::addChromaticities(header, {{0.61f, 0.31f}, {0.25f, 0.65f}, {0.18f, 0.09f}, {0.4476f, 0.4074f}});
  };
  EXPECT_FALSE(readFile(made({{"Y"}}, window, window, colours)).primaries) << "grey has none";
  const ExrPicture coloured = readFile(made({{"R"}, {"G"}, {"B"}}, window, window, colours));
  ASSERT_TRUE(coloured.primaries);
  EXPECT_NEAR(coloured.primaries->green.y, 0.65, 1e-6);
  EXPECT_NEAR(coloured.primaries->white.x, 0.4476, 1e-6);
  for (const int flag : {0, 1, 2}) {
    const auto aces = [flag](Imf::Header& header) { header.insert("acesImageContainerFlag", Imf::IntAttribute(flag)); };
    EXPECT_EQ(readFile(made({{"R"}, {"G"}, {"B"}}, window, window, aces)).primaries.has_value(), flag == 1);
  }
}

// RY and BY between their samples, by hand: the last sample counts beyond it.
TEST_F(ExrReader, ChromaIsLinearBetweenItsSamples) {
  const Imath::Box2i window({-6, 4}, {-6 + 11, 4 + 7});  // 12 x 8
  const ExrPicture picture =
      readFile(made({{"Y"}, {"RY", Imf::FLOAT, 2, 2}, {"BY", Imf::FLOAT, 3, 4}}, window, window));
  const auto between = [](double first, int columns, int rows, double column, double row) {
    const int left = std::min(static_cast<int>(column), columns - 1), top = std::min(static_cast<int>(row), rows - 1);
    const int right = std::min(left + 1, columns - 1), bottom = std::min(top + 1, rows - 1);
    const auto sample = [&](int c, int r) { return first + 0.25 * (r * columns + c); };
    const double s = column - left, t = row - top;
    return (1 - t) * ((1 - s) * sample(left, top) + s * sample(right, top)) +
           t * ((1 - s) * sample(left, bottom) + s * sample(right, bottom));
  };
  // IEC 61966-2-1's luminance.
  const double inRed = 0.2126, inGreen = 0.7152, inBlue = 0.0722;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 12; ++x) {
      const double luminance = 2.0 + 0.25 * (y * 12 + x);
      const double red = (between(3.0, 6, 4, x / 2.0, y / 2.0) + 1.0) * luminance;
      const double blue = (between(4.0, 4, 2, x / 3.0, y / 4.0) + 1.0) * luminance;
      const double green = (luminance - inRed * red - inBlue * blue) / inGreen;
      const float* rgba = &picture.image.pixels[4 * static_cast<std::size_t>(y * 12 + x)];
      ASSERT_NEAR(rgba[0], red, 1e-4 * red) << x << " " << y;
      ASSERT_NEAR(rgba[1], green, 2e-3 * std::abs(green)) << x << " " << y;
      ASSERT_NEAR(rgba[2], blue, 1e-4 * blue) << x << " " << y;
      ASSERT_EQ(rgba[3], 1.0f);
    }
  }
}

// From Lindbloom's formulas in exact fractions: ROMM (D50); primaries and a white of no standard.
TEST(ColorPrimaries, AreConvertedByTheirWhitesToo) {
  const auto apart = [](const glm::dmat3& columns, const double(&rows)[3][3]) {
    double most = 0.0;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(columns[c][r] - rows[r][c]));
    }
    return most;
  };
  const double fromRomm[3][3] = {{2.034367543, -0.727634474, -0.306733069},
                                 {-0.228826798, 1.231753396, -0.002926598},
                                 {-0.008558424, -0.153268204, 1.161826628}};
  const double fromOdd[3][3] = {{1.541294651, -0.534578949, -0.006715702},
                                {0.029835645, 0.970670973, -0.000506618},
                                {0.348449187, 0.112794523, 0.538756290}};
  const double fromXyz[3][3] = {{3.240969942, -1.537383178, -0.498610760},
                                {-0.969243636, 1.875967502, 0.041555057},
                                {0.055630080, -0.203976959, 1.056971514}};
  const ColorPrimaries romm{{0.7347, 0.2653}, {0.1596, 0.8404}, {0.0366, 0.0001}, {0.3457, 0.3585}};
  const ColorPrimaries odd{{0.61, 0.31}, {0.25, 0.65}, {0.18, 0.09}, {0.4476, 0.4074}};
  EXPECT_LT(apart(*rec709From(romm), fromRomm), 1e-8);
  EXPECT_LT(apart(*rec709From(odd), fromOdd), 1e-8);
  EXPECT_LT(apart(rec709FromXyz(), fromXyz), 1e-8);
  // What differs by rounding alone is not converted, in any of the eight numbers.
  for (int i = 0; i < 8; ++i) {
    ColorPrimaries rounded, other;
    double* const at[] = {&rounded.red.x,  &rounded.red.y,  &rounded.green.x, &rounded.green.y,
                          &rounded.blue.x, &rounded.blue.y, &rounded.white.x, &rounded.white.y};
    *at[i] += 1.9e-4;
    EXPECT_EQ(*rec709From(rounded), glm::dmat3(1.0)) << i;
    *at[i] -= 1.9e-4 + 2.1e-4;
    EXPECT_NE(*rec709From(rounded), glm::dmat3(1.0)) << i;
    *at[i] = std::nan("");
    EXPECT_FALSE(rec709From(rounded)) << i;
  }
  EXPECT_FALSE(rec709From({{0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.3127, 0.0009}}));
  EXPECT_TRUE(rec709From({{0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.3127, 0.0011}}));
  EXPECT_FALSE(rec709From({{0.64, 0.33}, {0.3, 0.6}, {0.47, 0.465}, {0.3127, 0.329}})) << "in one line";
  const ColorPrimaries aces = acesPrimaries();
  EXPECT_EQ(aces.red, glm::dvec2(0.7347, 0.2653));
  EXPECT_EQ(aces.green, glm::dvec2(0.0, 1.0));
  EXPECT_EQ(aces.blue, glm::dvec2(0.0001, -0.077));
  EXPECT_EQ(aces.white, glm::dvec2(0.32168, 0.33767));
}

}  // namespace
}  // namespace boxprobe
