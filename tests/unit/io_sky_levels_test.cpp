// Files of a sky's levels: exact round trip, and anything else told apart or refused in one line.
#include <gtest/gtest.h>

#include "filters/io/cube/sky_levels.h"
#include "tests/unit/cube_pictures.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class SkyLevelsFile : public TemporaryFolder {
 protected:
  const std::string key = std::string(31, 'a') + "b";
  BakedMaps maps() const {
    BakedMaps made;
    made.radiance = noisyHalfCube(16, 3);
    for (std::size_t i = 0; i < 9; ++i) made.irradiance[i] = glm::vec3(0.1f * static_cast<float>(i), 1.0f, -2.0f);
    return made;
  }
  std::string saved(const std::string& name) const {
    saveSkyLevels(file(name), key, maps());
    return file(name);
  }
};

TEST_F(SkyLevelsFile, ReadsBackEqual) {
  const std::string path = saved("a.levels");
  const SkyLevels read = loadSkyLevels(path);
  const BakedMaps made = maps();
  EXPECT_EQ(read.key, key);
  EXPECT_EQ(read.faceSize, 16);
  ASSERT_EQ(read.levels, 3);
  EXPECT_EQ(read.irradiance, made.irradiance);
  for (int level = 0; level < 3; ++level) {
    const std::size_t values = std::size_t(4) * made.radiance.levelSize(level) * made.radiance.levelSize(level);
    for (int face = 0; face < 6; ++face) {
      for (std::size_t i = 0; i < values; ++i) {
        const std::uint16_t bits = half(made.radiance.face(level, face)[i]).bits();
        ASSERT_EQ(read.texels[read.offset(level, face) + i], bits) << level << ' ' << face << ' ' << i;
      }
    }
  }
}

TEST_F(SkyLevelsFile, EachValueHasItsPlace) {
  BakedMaps made;
  made.radiance = CubeMap(4, 3);
  for (int level = 0; level < 3; ++level) {
    const int count = 6 * 4 * made.radiance.levelSize(level) * made.radiance.levelSize(level);
    for (int i = 0; i < count; ++i) made.radiance.face(level, 0)[i] = float(1000 * level + i);
  }
  for (std::size_t i = 0; i < 27; ++i) made.irradiance[i / 3][int(i % 3)] = 0.5f * float(i);
  saveSkyLevels(file("a.levels"), key, made);
  // "SKL1", the key, size and levels, 27 floats, 6 x 4 x (16 + 4 + 1) halves, the hash.
  const std::string bytes = read("a.levels");
  ASSERT_EQ(bytes.size(), 4u + 32 + 8 + 27 * 4 + 2 * 6 * 4 * 21 + 8);
  EXPECT_EQ(bytes.substr(0, 36), "SKL1" + key);
  const auto number = [&](std::size_t at) { return static_cast<unsigned char>(bytes[at]); };
  EXPECT_EQ(number(36), 4);
  EXPECT_EQ(number(40), 3);
  const auto halfAt = [&](std::size_t at) {
    half value;
    value.setBits(static_cast<std::uint16_t>(number(at) | number(at + 1) << 8));
    return static_cast<float>(value);
  };
  const std::size_t texels = 4 + 32 + 8 + 27 * 4;
  EXPECT_EQ(halfAt(texels + 2 * 5), 5.0f);
  EXPECT_EQ(halfAt(texels + 2 * (6 * 4 * 16 + 7)), 1007.0f);
  EXPECT_EQ(halfAt(texels + 2 * (6 * 4 * 20 + 23)), 2023.0f);
  const SkyLevels levels = loadSkyLevels(file("a.levels"));
  EXPECT_EQ(levels.offset(0, 5), 5u * 4 * 16);
  EXPECT_EQ(levels.offset(1, 2), 6u * 4 * 16 + 2 * 4 * 4);
  EXPECT_EQ(levels.offset(2, 1), 6u * 4 * 20 + 4);
  EXPECT_EQ(levels.irradiance[7], glm::vec3(10.5f, 11.0f, 11.5f));
  BakedMaps one;
  one.radiance = CubeMap(1, 1);
  saveSkyLevels(file("b.levels"), key, one);
  EXPECT_EQ(loadSkyLevels(file("b.levels")).levels, 1);
  EXPECT_TRUE(holdsSkyLevels(file("b.levels"), key, 1));
  EXPECT_EQ(errorText<WorkError>([&] { saveSkyLevels(file("c.levels"), "short", one); }),
            file("c.levels") + ": not written: the key has 5 characters");
  // Sizes that no sky has, in an otherwise sound beginning.
  const auto holds = [&](int faceSize, int count) {
    std::string head = bytes.substr(0, texels);
    for (int i = 0; i < 4; ++i) {
      head[36 + std::size_t(i)] = static_cast<char>(faceSize >> (8 * i));
      head[40 + std::size_t(i)] = static_cast<char>(count >> (8 * i));
    }
    return holdsSkyLevels(write("d.levels", head), key, faceSize);
  };
  EXPECT_TRUE(holds(4096, 13));
  EXPECT_TRUE(holds(4, 1));
  EXPECT_FALSE(holds(4096, 14));
  EXPECT_FALSE(holds(8192, 13));
  EXPECT_FALSE(holds(4, 4));
  EXPECT_FALSE(holds(4, 0));
  EXPECT_FALSE(holds(0, 1));
}

TEST_F(SkyLevelsFile, IsKnownByItsKeyAndSize) {
  const std::string path = saved("a.levels");
  EXPECT_TRUE(holdsSkyLevels(path, key, 16));
  EXPECT_FALSE(holdsSkyLevels(path, key, 32));
  EXPECT_FALSE(holdsSkyLevels(path, std::string(32, 'a'), 16));
  EXPECT_FALSE(holdsSkyLevels(file("missing.levels"), key, 16));
  EXPECT_FALSE(holdsSkyLevels(write("other.levels", "no levels"), key, 16));
  EXPECT_EQ(skyLevelsFile("/there/studio.hdr"), "/there/studio.levels");
}

TEST_F(SkyLevelsFile, DamageIsRefusedWhereverItIs) {
  saved("a.levels");
  const std::string whole = read("a.levels");
  for (std::size_t at = 0; at < whole.size(); at += 97) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    EXPECT_THROW(loadSkyLevels(write("damaged.levels", bytes)), InputError) << at;
    EXPECT_THROW(loadSkyLevels(write("short.levels", whole.substr(0, at))), InputError) << at;
  }
  EXPECT_THROW(loadSkyLevels(write("long.levels", whole + "x")), InputError);
  EXPECT_EQ(errorText([&] { loadSkyLevels(write("short.levels", "x")); }),
            file("short.levels") + ": is damaged; install it again");
}

}  // namespace
}  // namespace boxprobe
