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

TEST_F(BakeFolderTest, RecordsOfABakeAreLinesAndTheFolderKnowsThem) {
  const BakeRecord record{"key", "view", {"a", "b"}, {"c"}};
  EXPECT_EQ(record.text(), "key view a,b c");
  EXPECT_EQ((BakeRecord{"k", "v", {}, {}}).text(), "k v - -");
  const auto parsed = BakeRecord::parse("key view - c,dd,e");
  ASSERT_TRUE(parsed);
  EXPECT_EQ(parsed->key, "key");
  EXPECT_EQ(parsed->view, "view");
  EXPECT_THAT(parsed->sees, ElementsAre());
  EXPECT_THAT(parsed->known, ElementsAre("c", "dd", "e"));
  for (const char* text : {"", "k", "k v", "k v -", "k v - - x"}) EXPECT_FALSE(BakeRecord::parse(text)) << text;
  const std::pair<const char*, const char*> names[] = {
      {"", "_sky.exr"},       {"room", "room.exr"},       {"_sky", "%5Fsky.exr"},
      {".x", "%2Ex.exr"},     {" x", "%20x.exr"},         {"a_b.c d", "a_b.c d.exr"},
      {"A-Z09", "A-Z09.exr"}, {"a/b~1", "a%2Fb%7E1.exr"}, {"\xc3\xa4", "%C3%A4.exr"}};
  for (const auto& [name, file] : names) EXPECT_EQ(BakeFolder::fileName(name), file);
  EXPECT_EQ(BakeFolder::fileName("a", 2), "a~2.exr");
  for (const char* name : {"a~2.exr", "x/a~10.exr"}) EXPECT_TRUE(BakeFolder::isEarlierBounce(name)) << name;
  for (const char* name : {"a.exr", "a~.exr", "a~2x.exr", "a~b~.exr"}) EXPECT_FALSE(BakeFolder::isEarlierBounce(name));
  const std::pair<const char*, const char*> scenes[] = {
      {"x/a.boxprobe.json", "x/a.probes"}, {"a.json", "a.probes"},   {"a.glb", "a.probes"}, {"a.gltf", "a.probes"},
      {".json", ".json.probes"},           {"a.txt", "a.txt.probes"}};
  for (const auto& [scene, folder] : scenes) EXPECT_EQ(BakeFolder::besideScene(scene), folder);

  BakedMaps maps;
  maps.radiance = noisyHalfCube(4, 1);
  Probe probe;
  probe.name = "hall";
  const std::string folder = file("probes");
  const auto save = [&](const BakeRecord& what, int bounce) {
    return BakeFolder::save(folder, probe, what, maps, {"Boxprobe " + std::to_string(bounce), "r"}, bounce);
  };
  EXPECT_EQ(save({"k1", "view", {}, {}}, 1), folder + "/hall~1.exr");
  EXPECT_EQ(save({"k2", "view", {}, {"a", "b"}}, 2), folder + "/hall~2.exr");
  EXPECT_EQ(save({"k0", "view", {"x"}, {"a"}}, 0), folder + "/hall.exr");
  probe.name = "twin";
  save({"k0", "other", {}, {}}, 3);
  BakeFolder known(folder);
  EXPECT_EQ(known.path(), folder);
  EXPECT_EQ(known.file("k0"), folder + "/hall.exr") << "of the same maps, the one that others look for";
  EXPECT_EQ(known.maker("k2").program, "Boxprobe 2");
  EXPECT_EQ(known.maker("k2").renderer, "r");
  EXPECT_EQ(known.record("view")->key, "k2") << "made when most probes were known";
  EXPECT_FALSE(known.record("nothing"));
  known.forget("k2", "k2 is damaged");
  known.forget("k1");
  EXPECT_THAT(known.damaged(), ElementsAre("k2 is damaged"));
  EXPECT_EQ(known.record("view")->key, "k0");
  EXPECT_FALSE(known.has("k2"));
  EXPECT_TRUE(known.has("k0"));
  EXPECT_THAT(BakeFolder(file("gone")).damaged(), ElementsAre());
  Probe sky;
  sky.name.clear();
  const std::string path = BakeFolder::save(folder, sky, {"s", "v", {}, {}}, maps, {});
  EXPECT_EQ(path, folder + "/_sky.exr");
  EXPECT_EQ(loadBakedProbe(path).info.probe.name, "sky");
}

}  // namespace
}  // namespace boxprobe
