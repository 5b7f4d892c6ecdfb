// The folder of baked files: a damaged file is found, named, and as good as none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "filters/core/base/errors.h"
#include "filters/io/cube/bake_folder.h"
#include "tests/unit/cube_pictures.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class BakeFolderTest : public TemporaryFolder {
 protected:
  std::string bake() const {
    BakedMaps maps;
    maps.radiance = noisyHalfCube(16, 5);
    maps.distance = smoothCube(16);
    Probe probe;
    probe.name = "room";
    return BakeFolder::save(folder_.string(), probe, {"key", "view", {}, {}}, maps, {"Boxprobe test", {}});
  }
};

TEST_F(BakeFolderTest, AWholeFileIsThere) {
  bake();
  const BakeFolder folder(folder_.string());
  EXPECT_TRUE(folder.has("key"));
  EXPECT_FALSE(folder.has("another"));
  EXPECT_THAT(folder.damaged(), IsEmpty());
  EXPECT_TRUE(sameTexels(folder.load("key").radiance, noisyHalfCube(16, 5)));
}

TEST_F(BakeFolderTest, ADamagedByteAtTwoHundredPlacesIsFoundEachTime) {
  const std::string path = bake(), whole = read("room.exr");
  ASSERT_EQ(bakedProbeDamage(path), "");
  const std::size_t places = 200;
  for (std::size_t i = 0; i < places; ++i) {
    const std::size_t at = (2 * i + 1) * whole.size() / (2 * places);
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << i % 8));
    write("room.exr", bytes);
    EXPECT_NE(bakedProbeDamage(path), "") << at;
    EXPECT_NE(errorText([&] { loadBakedProbe(path); }), "") << at;
    EXPECT_FALSE(BakeFolder(folder_.string()).has("key")) << at;
  }
  // The ends of the file, and the checksum's own surroundings, byte by byte.
  const std::size_t seal = whole.find("checksum");
  for (std::size_t at = seal; at < seal + 52; ++at) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    write("room.exr", bytes);
    EXPECT_NE(errorText([&] { loadBakedProbe(path); }), "") << at;
  }
  for (const std::string& bytes : {whole.substr(0, whole.size() - 1), whole + '\0', whole.substr(0, 1000)}) {
    write("room.exr", bytes);
    EXPECT_NE(errorText([&] { loadBakedProbe(path); }), "");
    EXPECT_FALSE(BakeFolder(folder_.string()).has("key"));
  }
}

TEST_F(BakeFolderTest, DamageIsNamedOnce) {
  const std::string path = bake(), whole = read("room.exr");
  std::string bytes = whole;
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  write("room.exr", bytes);
  const BakeFolder damaged(folder_.string());
  EXPECT_FALSE(damaged.has("key"));
  EXPECT_FALSE(damaged.has("key"));
  EXPECT_THAT(damaged.damaged(), ElementsAre(HasSubstr(path + ": is damaged")));
  write("room.exr", whole.substr(0, 5000));
  const BakeFolder cut(folder_.string());
  EXPECT_FALSE(cut.has("key"));
  EXPECT_THAT(cut.damaged(), ElementsAre(HasSubstr(path + ": is ")));
}

TEST_F(BakeFolderTest, APipeInThePlaceOfAFileIsNamedAndHoldsNobody) {
  ASSERT_EQ(::mkfifo(file("room.exr").c_str(), 0600), 0);
  const BakeFolder folder(folder_.string());
  EXPECT_FALSE(folder.has("key"));
  EXPECT_THAT(folder.damaged(), ElementsAre(HasSubstr("is not a file but a pipe or device")));
}

}  // namespace
}  // namespace boxprobe
