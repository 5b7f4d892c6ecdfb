// A baked probe's file: exact for us, whole or refused, and its metadata.
#include <OpenEXR/ImfEnvmap.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTiledInputPart.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <gtest/gtest.h>

#include <limits>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/image/exr_reader.h"
#include "tests/unit/cube_pictures.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class CubeBaked : public TemporaryFolder {};

BakedProbeFile example(int faceSize = 32, int levels = 6) {
  BakedProbeFile file;
  file.maps.radiance = noisyHalfCube(faceSize, levels);
  file.maps.distance = CubeMap(faceSize, 1);
  for (int i = 0; i < 6 * faceSize * faceSize; ++i) file.maps.distance.face(0, 0)[4 * i] = 0.1f * static_cast<float>(i);
  for (std::size_t i = 0; i < 9; ++i)
    file.maps.irradiance[i] = glm::vec3(0.1f, -0.2f, 1e-7f) * static_cast<float>(i + 1);
  file.maps.capturedAt = {0.1, 1e6 + 1e-7, -3.0};
  file.maps.capturedRotation = {0.1, 30.5, -1e-7};
  Probe& probe = file.info.probe;
  probe.name = "true";  // reads like another type
  probe.origin = file.maps.capturedAt;
  probe.box = {{-1.25, -2, -3}, {4, 5, 6.1}};
  probe.influence = Box{{-1, -1, -1}, {1, 1, 1}};
  probe.rotationDegrees = {0, 30.5, 0};
  probe.blendDistance = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
  probe.clear = glm::vec3(0.3f, 0.0f, 1.0f);
  probe.projection = false;
  probe.technique = "sphere";
  probe.parameters = {{"samples", 64.0}, {"animated", true}, {"pattern", std::string("blue")}};
  probe.faceSize = faceSize;
  probe.bounces = 3;
  probe.mode = ProbeMode::Custom;
  probe.image = "room.exr";
  probe.filter = FilterKind::Gaussian;
  probe.hides = {"lamp", "mirror [1]"};
  probe.bevel = Bevel{0.3, 1.0};
  probe.occlusion = BoxOcclusion{2.0, 1.5, 0.5};
  file.info.inputHash = "0123abcd";
  file.info.program = "Boxprobe 0.1.0";
  file.info.renderer = "softpipe";
  return file;
}

TEST_F(CubeBaked, EveryTexelAndValueComesBack) {
  for (const int levels : {1, 4, 6}) {
    BakedProbeFile file = example(32, levels);
    file.info.probe.image = (folder_ / "pictures" / "room.exr").string();  // kept relative to the file
    saveBakedProbe(this->file("a.exr"), file);
    const BakedProbeFile again = loadBakedProbe(this->file("a.exr"));
    EXPECT_TRUE(sameTexels(again.maps.radiance, file.maps.radiance)) << levels;
    EXPECT_TRUE(sameTexels(again.maps.distance, file.maps.distance));
    EXPECT_EQ(again.maps.irradiance, file.maps.irradiance);
    EXPECT_EQ(again.maps.capturedAt, file.maps.capturedAt);
    EXPECT_EQ(again.maps.capturedRotation, file.maps.capturedRotation);
    EXPECT_EQ(again.info.probe, file.info.probe);
    EXPECT_EQ(again.info.inputHash, file.info.inputHash);
    EXPECT_EQ(again.info.program, file.info.program);
    EXPECT_EQ(again.info.renderer, file.info.renderer);
    EXPECT_EQ(bakedProbeMark(this->file("a.exr")).value().inputHash, "0123abcd");
    EXPECT_EQ(bakedProbeMark(this->file("a.exr")).value().renderer, "softpipe");
    EXPECT_EQ(entryCount(), 1u);
  }
}

TEST_F(CubeBaked, ADefaultProbeWithoutDistanceToo) {
  BakedProbeFile file;
  file.maps.radiance = noisyHalfCube(16, 5);
  saveBakedProbe(this->file("a.exr"), file);
  const BakedProbeFile again = loadBakedProbe(this->file("a.exr"));
  EXPECT_TRUE(again.maps.distance.empty());
  EXPECT_EQ(again.info.probe, file.info.probe);
  EXPECT_EQ(bakedProbeMark(this->file("a.exr")).value().inputHash, "");
  EXPECT_EQ(again.info.renderer, "");
}

TEST_F(CubeBaked, FloatKeepsWhatHalfRounds) {
  BakedProbeFile file = example();
  file.maps.radiance.setTexel(0, 3, 5, 6, {0.1f, 1e6f, 1e-9f, 1.0f});
  saveBakedProbe(this->file("f.exr"), file, ExrPrecision::Float);
  EXPECT_TRUE(sameTexels(loadBakedProbe(this->file("f.exr")).maps.radiance, file.maps.radiance));
  saveBakedProbe(this->file("h.exr"), file);
  const glm::vec4 rounded = loadBakedProbe(this->file("h.exr")).maps.radiance.texel(0, 3, 5, 6);
  EXPECT_EQ(rounded.x, static_cast<float>(half(0.1f)));
  EXPECT_EQ(rounded.y, 65504.0f);  // not infinity
}

TEST_F(CubeBaked, EqualInputEqualBytes) {
  saveBakedProbe(file("a.exr"), example());
  saveBakedProbe(file("b.exr"), example());
  EXPECT_EQ(read("a.exr"), read("b.exr"));
}

TEST_F(CubeBaked, OtherProgramsSeeAnEnvironmentMapFirst) {
  saveBakedProbe(file("a.exr"), example());
  Imf::MultiPartInputFile exr(file("a.exr").c_str());
  const Imf::Header& header = exr.header(0);
  ASSERT_TRUE(Imf::hasEnvmap(header));
  EXPECT_EQ(Imf::envmap(header), Imf::ENVMAP_CUBE);
  EXPECT_EQ(header.dataWindow().max, Imath::V2i(31, 191));
  EXPECT_EQ(header.tileDescription().mode, Imf::MIPMAP_LEVELS);
  const auto* origin = header.findTypedAttribute<Imf::V3dAttribute>("probe.origin");
  ASSERT_NE(origin, nullptr);
  EXPECT_EQ(origin->value(), Imath::V3d(0.1, 1e6 + 1e-7, -3.0));
}

// Each level of what other programs read is made from that level, and not from the one before.
TEST_F(CubeBaked, OtherProgramsSeeEachLevelAsItIs) {
  constexpr int kSize = 32, kLevels = 6;
  const auto radianceOf = [](int level) { return 0.25f * static_cast<float>(level * level) + 0.5f; };
  BakedProbeFile probe;
  probe.maps.radiance = CubeMap(kSize, kLevels);
  for (int level = 0; level < kLevels; ++level) {
    const int size = kSize >> level;
    for (int texel = 0; texel < 6 * size * size; ++texel) {
      const float x = radianceOf(level);
      probe.maps.radiance.setTexel(level, texel / (size * size), texel % size, texel / size % size,
                                   {x, 2.0f * x, 4.0f * x, 1.0f});
    }
  }
  saveBakedProbe(file("a.exr"), probe);
  Imf::MultiPartInputFile exr(file("a.exr").c_str());
  Imf::TiledInputPart part(exr, 0);
  for (int level = 0; level < kLevels; ++level) {
    const Imath::Box2i window = part.dataWindowForLevel(level);
    const auto width = static_cast<std::size_t>(window.max.x + 1), height = static_cast<std::size_t>(window.max.y + 1);
    ASSERT_EQ(width, static_cast<std::size_t>(kSize >> level));
    std::vector<float> red(width * height), blue(width * height);
    Imf::FrameBuffer frame;
    for (const auto& [name, values] : {std::pair{"R", &red}, std::pair{"B", &blue}}) {
      frame.insert(
          name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values->data()), sizeof(float), sizeof(float) * width));
    }
    part.setFrameBuffer(frame);
    part.readTiles(0, part.numXTiles(level) - 1, 0, part.numYTiles(level) - 1, level);
    for (std::size_t i = 0; i < red.size(); ++i) {
      ASSERT_NEAR(red[i], radianceOf(level), 0.002f * radianceOf(level)) << "level " << level;
      ASSERT_NEAR(blue[i], 4.0f * radianceOf(level), 0.008f * radianceOf(level)) << "level " << level;
    }
  }
}

// A map along a turned box's axes is to others what the same along the world's is.
TEST_F(CubeBaked, OtherProgramsSeeTheWorldsAxes) {
  constexpr int kSize = 64;
  BakedProbeFile straight, turned;
  straight.maps.radiance = smoothCube(kSize);
  turned.maps.capturedRotation = {10.0, 30.0, -20.0};
  turned.maps.radiance = CubeMap(kSize, straight.maps.radiance.levels());
  const glm::mat3 worldFromMap(rotationMatrix(turned.maps.capturedRotation));
  for (int level = 0; level < straight.maps.radiance.levels(); ++level) {
    const int size = straight.maps.radiance.levelSize(level);
    const auto at = [&](int i) { return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size) - 1.0f; };
    for (int texel = 0; texel < 6 * size * size; ++texel) {
      const int face = texel / (size * size), row = texel / size % size, column = texel % size;
      const glm::vec3 direction = worldFromMap * shading::cubeDirection(face, at(column), at(row));
      turned.maps.radiance.setTexel(level, face, column, row,
                                    straight.maps.radiance.fetch(direction, static_cast<float>(level)));
    }
  }
  const auto environment = [&](const BakedProbeFile& probe, const char* name) {
    saveBakedProbe(file(name), probe);
    ExrPicture picture;
    withExrFile(file(name), [&](Imf::MultiPartInputFile& exr) { picture = readExrPart(exr, 0, file(name)); });
    return picture.image.pixels;
  };
  const auto apart = [](const float* a, const float* b, std::size_t count) {
    float most = 0.0f;
    for (std::size_t i = 0; i < count; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
  };
  const auto a = environment(straight, "straight.exr"), b = environment(turned, "turned.exr");
  ASSERT_EQ(a.size(), b.size());
  const std::size_t count = std::size_t(6) * kSize * kSize * 4;
  EXPECT_LT(apart(a.data(), b.data(), count), 0.02f);
  EXPECT_GT(apart(straight.maps.radiance.face(0, 0), turned.maps.radiance.face(0, 0), count), 0.2f);
  const CubeMap c = loadCube(file("straight.exr")).radiance, d = loadCube(file("turned.exr")).radiance;
  EXPECT_LT(apart(c.face(0, 0), d.face(0, 0), count), 0.02f);
}

TEST_F(CubeBaked, CompressionFollowsTheContent) {
  BakedProbeFile probe;
  probe.maps.radiance = smoothCube(64);
  saveBakedProbe(file("even.exr"), probe);
  const CubeMap noise = noisyHalfCube(64, 1);
  for (int i = 0; i < 6 * 64 * 64 * 4; ++i) {  // grain of a few percent, as of a photograph
    float& value = probe.maps.radiance.face(0, 0)[i];
    if (i % 4 != 3) value = half(value * (1.0f + 0.004f * std::log(noise.face(0, 0)[i])));
  }
  saveBakedProbe(file("grain.exr"), probe);
  const auto compression = [&](const char* name) {
    return Imf::MultiPartInputFile(file(name).c_str()).header(1).compression();
  };
  EXPECT_EQ(compression("even.exr"), Imf::ZIP_COMPRESSION);
  EXPECT_EQ(compression("grain.exr"), Imf::PIZ_COMPRESSION);
}

TEST_F(CubeBaked, WhatIsNoProbeIsSaidToBeNone) {
  saveBakedProbe(file("a.exr"), example());
  EXPECT_FALSE(bakedProbeMark(file("gone.exr")));
  EXPECT_FALSE(bakedProbeMark(folder_.string()));
  EXPECT_FALSE(bakedProbeMark(write("empty.exr", "")));
  EXPECT_EQ(errorText([&] { loadBakedProbe(file("gone.exr")); }),
            file("gone.exr") + ": does not exist; check the path");
  BakedProbeFile odd;
  odd.maps.radiance = CubeMap(24, 1);
  EXPECT_NE(errorText<WorkError>([&] { saveBakedProbe(file("odd.exr"), odd); }).find("power of two"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("odd.exr")));
}

TEST_F(CubeBaked, AMissingAttributeIsNamedAfterItsFile) {
  saveBakedProbe(file("a.exr"), example());
  std::ifstream in(file("a.exr"), std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  // As a file of version 1, which has no checksum.
  const std::string version("boxprobe\0int\0\4\0\0\0\2", 18);
  for (const std::string& name : {std::string("irradiance"), std::string("checksum"), version}) {
    const std::size_t at = bytes.find(name);
    ASSERT_NE(at, std::string::npos) << name;
    name == version ? bytes[at + 17] = 1 : bytes[at] = 'o';
  }
  const std::string path = write("other.exr", bytes);
  EXPECT_EQ(errorText([&] { loadBakedProbe(path); }),
            path + ": part 0: attribute irradiance is missing: this is not a probe that was baked; bake it again");
}

TEST_F(CubeBaked, AttributesOutOfRangeAreNamed) {
  BakedProbeFile bad = example();
  bad.info.probe.blendDistance.max.y = std::numeric_limits<double>::quiet_NaN();
  saveBakedProbe(file("a.exr"), bad);
  const std::string text = errorText([&] { loadBakedProbe(file("a.exr")); });
  EXPECT_EQ(text.rfind(file("a.exr") + ": part 0: attributes: probes.true.blendDistance.max", 0), 0u) << text;
}

}  // namespace
}  // namespace boxprobe
