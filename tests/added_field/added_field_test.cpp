// A field added as the README says is known everywhere by its row alone: to scene files, to `--set`, to equality and
// changes, to validation, forms and the reference.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "filters/core/scene/scene_fields.h"
#include "filters/io/scene/scene_file.h"
#include "filters/io/scene/scene_reference.h"
#include "tests/unit/error_text.h"

namespace boxprobe {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Scene parsed(const std::string& probeFields) {
  return parseScene(R"({"format": "boxprobe-scene", "version": 1, "probes": [{"name": "room")" + probeFields + "}]}",
                    "scene.json", "");
}

TEST(AddedField, IsReadAndWritten) {
  EXPECT_EQ(parsed("").probes[0].fadeSeconds, 0.25);
  const Scene scene = parsed(R"(, "fadeSeconds": 2, "hides": ["lamp"], "filterSamples": 32)");
  EXPECT_EQ(scene.probes[0].fadeSeconds, 2.0);
  EXPECT_EQ(scene.probes[0].hides, std::vector<std::string>{"lamp"});
  const std::string text = sceneText(scene, "");
  EXPECT_THAT(text, HasSubstr("\"filterSamples\": 32,\n      \"fadeSeconds\": 2,\n      \"hides\": [\"lamp\"]"));
  EXPECT_EQ(parseScene(text, "again", ""), scene);
  EXPECT_THAT(sceneText(parsed(""), ""), Not(HasSubstr("fadeSeconds"))) << "the default is left out";
}

TEST(AddedField, TellsScenesApart) {
  const Scene before = parsed("");
  Scene after = before;
  EXPECT_EQ(after, before);
  after.probes[0].fadeSeconds = 1.0;
  EXPECT_FALSE(after == before);
  const Changes changes = difference(before, after);
  for (const ChangeRow& row : changeRows()) {
    EXPECT_EQ(changes.*row.member, row.member == &Changes::probeShape) << row.id;
  }
}

TEST(AddedField, IsSetFromTheCommandLine) {
  Scene scene = parsed("");
  setSceneFields(scene, {"probes.room.fadeSeconds=3"});
  EXPECT_EQ(scene.probes[0].fadeSeconds, 3.0);
  EXPECT_EQ(sceneNumber(scene, "probes.room.fadeSeconds"), 3.0);
  EXPECT_EQ(errorText([&] { setSceneFields(scene, {"probes.room.fadeSecond=3"}); }),
            "--set probes.room.fadeSecond=3: probes.room.fadeSecond: unknown key; did you mean \"fadeSeconds\"?");
}

TEST(AddedField, IsRefusedOutOfItsRangeAndOfAnotherType) {
  EXPECT_EQ(errorText([] { parsed(R"(, "fadeSeconds": 11)"); }),
            "scene.json:1:77: probes.room.fadeSeconds: is 11 and must be from 0 to 10");
  EXPECT_EQ(errorText([] { parsed(R"(, "fadeSeconds": "slow")"); }),
            "scene.json:1:77: probes.room.fadeSeconds: must be a number, not \"slow\"");
}

TEST(AddedField, IsInFormsAndInTheReference) {
  EXPECT_EQ(probeField("fadeSeconds").unit, "s");
  EXPECT_EQ(formRange(probeField("fadeSeconds")).highest, 10.0);
  EXPECT_THAT(sceneReferenceMarkdown(),
              HasSubstr("| `fadeSeconds` | number from 0 to 10, s | `0.25` | shape | Time over "
                        "which a new capture replaces the one that is shown. |\n"));
}

}  // namespace
}  // namespace boxprobe
