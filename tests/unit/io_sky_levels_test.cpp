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
