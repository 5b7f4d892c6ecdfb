// Cubes for engines: roughness of each level, axes, another centre, latitude-longitude pictures, and the bytes of KTX2
// and DDS at offsets counted by hand from their specifications.
#include <Imath/half.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>

#include "filters/io/engines/cube_container.h"
#include "filters/io/engines/export_cube.h"
#include "filters/math/cube/cube_filter_reference.h"
#include "tests/unit/cube_pictures.h"

namespace boxprobe {
namespace {

glm::vec3 unit(const glm::vec3& d) {
  return glm::normalize(d);
}

double roughnessOf(const char* ladder, int level, int faceSize) {
  const LadderRow* row = findLadder(ladder);
  return row->roughness(level, row->levels(faceSize), faceSize);
}

TEST(EngineLadder, RoughnessIsTheInverseOfWhatEachEngineSamples) {
  for (const LadderRow& row : ladderRows()) {
    for (const int size : {kLeastExportSize, 128, 256, kMostExportSize}) {
      const int levels = row.levels(size);
      ASSERT_GE(levels, 2) << row.id;
      EXPECT_EQ(row.roughness(0, levels, size), 0.0) << row.id;
      for (int level = 0; level < levels; ++level) {
        const double r = row.roughness(level, levels, size), last = levels - 1;
        // The level that the engine's shader samples at that roughness.
        const double sampled = row.id == "three"     ? last * r * (2.0 - r)
                               : row.id == "bevy"    ? last * r
                               : row.id == "babylon" ? (r > 0.0 ? 0.8 * std::log2(size * r * r) : 0.0)
                               : row.id == "unity"
                                   ? 6.0 * r * (1.7 - 0.7 * r)
                                   : shading::levelForRoughness(static_cast<float>(r), static_cast<float>(last));
        if (r < 1.0) {
          EXPECT_NEAR(sampled, level, 1e-4) << row.id << " " << size;
        }
        if (level > 0) {
          EXPECT_GE(r, row.roughness(level - 1, levels, size)) << row.id;
        }
        EXPECT_LE(r, 1.0) << row.id;
      }
      if (row.id != "unity" || levels > 6) {
        EXPECT_NEAR(row.roughness(levels - 1, levels, size), 1.0, 1e-6) << row.id;
      }
    }
  }
}

TEST(EngineLadder, KnownValues) {
  EXPECT_EQ(findLadder("three")->levels(256), 6);  // the last has 8 x 8 texels
  EXPECT_NEAR(roughnessOf("three", 1, 256), 0.105573, 1e-6);
  EXPECT_EQ(findLadder("bevy")->levels(256), 7);
  EXPECT_NEAR(roughnessOf("bevy", 3, 256), 0.5, 1e-12);
  EXPECT_EQ(findLadder("babylon")->levels(256), 9);
  EXPECT_NEAR(std::pow(roughnessOf("babylon", 4, 256), 2), 0.125, 1e-12);
  EXPECT_EQ(findLadder("nonesuch"), nullptr);
}

TEST(EngineCube, TurnedCubeIsFoundByTheEnginesLookup) {
  const CubeMap cube = cubeOf(8, 3, unit);
  for (const LadderRow& row : ladderRows()) {
    const CubeMap turned = turnedCube(cube, row.lookup);
    for (int level = 0; level < 3; ++level) {
      const CubeMap expected = cubeOf(8, 3, [&](const glm::vec3& d) { return unit(d) * row.lookup; });
      const std::size_t values = std::size_t(4) * cube.levelSize(level) * cube.levelSize(level);
      for (int face = 0; face < 6; ++face) {
        EXPECT_EQ(std::memcmp(turned.face(level, face), expected.face(level, face), values * sizeof(float)), 0)
            << row.id << " level " << level << " face " << face;
      }
    }
  }
}

TEST(EngineCube, EveryLevelIsFilteredFromLevel0) {
  const auto lamp = [](const glm::vec3& d) {
    const bool bright = glm::dot(glm::normalize(d), glm::normalize(glm::vec3(1.0f, 0.4f, 0.2f))) > 0.93f;
    return glm::vec3(bright ? 8.0f : 0.5f + 0.3f * glm::normalize(d).y);
  };
  const CubeMap level0 = cubeOf(64, 1, lamp);
  const CubeFilterReference reference(level0);
  for (const LadderRow& row : ladderRows()) {
    const CubeMap chain = ladderChain(level0, row, 128);
    ASSERT_EQ(chain.levels(), row.levels(64)) << row.id;
    for (int level = 1; level < chain.levels(); ++level) {
      const double r = row.roughness(level, chain.levels(), 64);
      const FilterLobe lobe = {FilterLobe::Kind::Ggx, static_cast<float>(r * r)};
      const int size = chain.levelSize(level);
      for (int face = 0; face < 6; face += 2) {
        const auto at = (2.0f * static_cast<float>(size / 2) + 1.0f) / static_cast<float>(size) - 1.0f;
        const glm::vec3 direction = shading::cubeDirection(face, at, at);
        const float exact = reference.value(lobe, glm::normalize(direction)).x;
        EXPECT_NEAR(chain.texel(level, face, size / 2, size / 2).x, exact, 0.04f + 0.03f * exact)
            << row.id << " level " << level << " face " << face;
      }
    }
  }
}

// What a probe at `from` sees of a box whose walls are painted by where they are.
CubeMap boxRoom(int faceSize, const glm::vec3& low, const glm::vec3& high, const glm::vec3& from) {
  return cubeOf(faceSize, 1, [&](const glm::vec3& d) {
    const glm::vec3 t = shading::slabFactors(from, d, low, high);
    return 0.1f * (from + std::min({t.x, t.y, t.z}) * d) + 0.5f;
  });
}

TEST(EngineCube, AnotherCentreSeesTheSameBox) {
  const glm::vec3 low(-4.0f, 0.0f, -3.0f), high(4.0f, 3.0f, 3.0f), origin(0.7f, 1.4f, -0.5f), middle(0.0f, 1.5f, 0.0f);
  const CubeMap moved = recentredCube(boxRoom(128, low, high, origin), low - origin, high - origin, middle - origin);
  const CubeMap expected = boxRoom(128, low, high, middle);
  double worst = 0.0;
  for (int i = 0; i < 6 * 128 * 128 * 4; ++i)
    worst = std::max(worst, std::abs(double(moved.face(0, 0)[i]) - expected.face(0, 0)[i]));
  EXPECT_LT(worst, 0.01);  // a texel's width on the far walls
}

TEST(EngineCube, SmallerIsTheMeanAndTheSameSizeIsTheSame) {
  const CubeMap cube = noisyHalfCube(32, 1);
  EXPECT_TRUE(sameTexels(resizedCube(cube, 32), cube));
  const CubeMap flat = cubeOf(32, 1, [](const glm::vec3&) { return glm::vec3(0.75f); });
  EXPECT_NEAR(resizedCube(flat, 16).texel(0, 4, 3, 5).y, 0.75f, 1e-6f);
}

TEST(EngineCube, LatLongIsUprightAndUnmirroredFromInside) {
  const CubeMap cube = cubeOf(32, 1, unit);
  for (const glm::vec3 centre : {glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 0.0f, 1.0f)}) {
    const ImageRgbaF picture = latLongPicture(cube, centre);
    ASSERT_EQ(picture.width, 128);
    ASSERT_EQ(picture.height, 64);
    const auto pixel = [&](int x, int y) {
      const float* p = picture.pixels.data() + 4 * (std::size_t(y) * 128 + x);
      return glm::vec3(p[0], p[1], p[2]);
    };
    const glm::vec3 right = glm::cross(centre, glm::vec3(0.0f, 1.0f, 0.0f));  // of someone who looks there
    EXPECT_GT(glm::dot(pixel(64, 32), centre), 0.99f);
    EXPECT_GT(glm::dot(pixel(96, 32), right), 0.99f);
    EXPECT_GT(pixel(64, 0).y, 0.99f);
    EXPECT_LT(pixel(64, 63).y, -0.99f);
  }
}

std::uint32_t number(const std::string& bytes, std::size_t at, int size = 4) {
  std::uint32_t value = 0;
  for (int i = size - 1; i >= 0; --i)
    value = value << 8 | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i)));
  return value;
}

float halfAt(const std::string& bytes, std::size_t at) {
  Imath::half h;
  h.setBits(static_cast<std::uint16_t>(number(bytes, at, 2)));
  return h;
}

TEST(EngineContainer, Ktx2HasEveryValueWhereTheSpecificationPutsIt) {
  const CubeMap cube = noisyHalfCube(8, 4);
  const std::string bytes = encodeKtx2(cube, "Boxprobe test");
  EXPECT_EQ(bytes.substr(0, 12), std::string("\xabKTX 20\xbb\r\n\x1a\n"));
  EXPECT_EQ(number(bytes, 12), 97u);  // VK_FORMAT_R16G16B16A16_SFLOAT
  EXPECT_EQ(number(bytes, 16), 2u);   // bytes of a component
  EXPECT_EQ(number(bytes, 20), 8u);
  EXPECT_EQ(number(bytes, 24), 8u);
  EXPECT_EQ(number(bytes, 28), 0u);  // no depth
  EXPECT_EQ(number(bytes, 32), 0u);  // no array
  EXPECT_EQ(number(bytes, 36), 6u);
  EXPECT_EQ(number(bytes, 40), 4u);
  EXPECT_EQ(number(bytes, 44), 0u);            // not compressed
  EXPECT_EQ(number(bytes, 48), 80u + 4 * 24);  // the descriptor follows the index
  EXPECT_EQ(number(bytes, 52), 92u);
  EXPECT_EQ(number(bytes, 48) + 92u, number(bytes, 56));
  EXPECT_NE(bytes.find("KTXorientation"), std::string::npos);
  EXPECT_NE(bytes.find("Boxprobe test"), std::string::npos);
  // Smallest level first: 6, 24, 96 and 384 texels of 8 bytes.
  const std::size_t start = number(bytes, 80 + 3 * 24);
  EXPECT_EQ(start % 8, 0u);
  EXPECT_EQ(number(bytes, 80 + 2 * 24), start + 48);
  EXPECT_EQ(number(bytes, 80 + 1 * 24), start + 48 + 192);
  EXPECT_EQ(number(bytes, 80), start + 48 + 192 + 768);
  EXPECT_EQ(number(bytes, 80 + 8), 3072u);
  EXPECT_EQ(bytes.size(), start + 48 + 192 + 768 + 3072);
  // Level 1, face -Y, column 2, row 1: texel (3 * 16 + 1 * 4 + 2) of the level.
  const glm::vec4 texel = cube.texel(1, 3, 2, 1);
  for (int channel = 0; channel < 4; ++channel) {
    EXPECT_EQ(halfAt(bytes, start + 48 + 192 + (3 * 16 + 1 * 4 + 2) * 8 + 2 * static_cast<std::size_t>(channel)),
              texel[channel]);
  }
}

TEST(EngineContainer, DdsHasEveryValueWhereDirect3dPutsIt) {
  const CubeMap cube = noisyHalfCube(8, 4);
  const std::string bytes = encodeDds(cube);
  EXPECT_EQ(bytes.substr(0, 4), "DDS ");
  EXPECT_EQ(number(bytes, 4), 124u);
  EXPECT_EQ(number(bytes, 12), 8u);
  EXPECT_EQ(number(bytes, 16), 8u);
  EXPECT_EQ(number(bytes, 28), 4u);
  EXPECT_EQ(number(bytes, 76), 32u);
  EXPECT_EQ(bytes.substr(84, 4), "DX10");
  EXPECT_EQ(number(bytes, 112), 0xfe00u);  // a cube of six faces
  EXPECT_EQ(number(bytes, 128), 10u);      // DXGI_FORMAT_R16G16B16A16_FLOAT
  EXPECT_EQ(number(bytes, 136), 4u);       // D3D11_RESOURCE_MISC_TEXTURECUBE
  // A face with its levels: 64 + 16 + 4 + 1 texels of 8 bytes.
  EXPECT_EQ(bytes.size(), 148u + 6 * 85 * 8);
  const glm::vec4 texel = cube.texel(2, 5, 1, 0);
  for (int channel = 0; channel < 4; ++channel) {
    EXPECT_EQ(halfAt(bytes, 148 + (5 * 85 + 64 + 16 + 1) * 8 + 2 * static_cast<std::size_t>(channel)), texel[channel]);
  }
}

TEST(EngineContainer, WhatAHalfDoesNotHoldIsCounted) {
  CubeMap cube = cubeOf(4, 1, [](const glm::vec3&) { return glm::vec3(1.0f); });
  EXPECT_FALSE(halfLoss(cube).any());
  cube.setTexel(0, 2, 1, 1, {1e6f, 0.0f, 0.0f, 1.0f});
  cube.setTexel(0, 3, 0, 0, {65504.0f, 0.0f, 0.0f, 1.0f});
  cube.setTexel(0, 4, 0, 0, {std::nanf(""), 0.0f, 0.0f, 1.0f});
  EXPECT_EQ(halfLoss(cube).texelsAtLimit, 2u);
  EXPECT_EQ(halfLoss(cube).texelsNotFinite, 1u);
  const std::string bytes = encodeDds(cube);
  EXPECT_EQ(halfAt(bytes, 148 + (2 * 16 + 1 * 4 + 1) * 8), 65504.0f);
  EXPECT_EQ(halfAt(bytes, 148 + 4 * 16 * 8), 0.0f);
  EXPECT_FALSE(coversPartly(cube));
  cube.setTexel(0, 0, 0, 0, glm::vec4(0.5f));
  EXPECT_TRUE(coversPartly(cube));
}

}  // namespace
}  // namespace boxprobe
