// The truth scenes' files are what their generator writes, and light is all that they give: nothing but the floor
// reflects.
#include <gtest/gtest.h>

#include "data/scenes/glb_writer.h"
#include "filters/io/files/read_file.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/scene/scene_file.h"
#include "tests/truth/scenes/truth_scenes.h"

namespace {

using namespace boxprobe;

const std::string kFolder = BOXPROBE_SOURCE_DIR "/tests/truth/scenes/";

TEST(TruthScenes, FilesAreWhatTheGeneratorWrites) {
  const std::string how = "; renew it with build/release/tests/truth/scenes/generate_truth_scenes tests/truth/scenes";
  const std::pair<const char*, std::string> files[] = {{"empty.glb", scenes::glbBytes(scenes::truthEmpty())},
                                                       {"furnished.glb", scenes::glbBytes(scenes::truthFurnished())},
                                                       {"arcade.glb", scenes::glbBytes(scenes::truthArcade())},
                                                       {"arcade-sky.hdr", scenes::truthArcadeSky()}};
  for (const auto& [name, bytes] : files) EXPECT_TRUE(readWholeFile(kFolder + name) == bytes) << name << how;
  // The lesson on the marching impostor has the arcade as well; the program is installed without its tests.
  const std::string lessons = BOXPROBE_SOURCE_DIR "/data/lessons/scenes/";
  for (const char* name : {"arcade.glb", "arcade-sky.hdr"}) {
    EXPECT_TRUE(readWholeFile(lessons + name) == readWholeFile(kFolder + name)) << lessons + name << how;
  }
}

TEST(TruthScenes, OnlyTheFloorReflects) {
  for (const char* name : {"empty", "furnished", "arcade"}) {
    const Scene scene = loadSceneFile(kFolder + name + ".boxprobe.json");
    ASSERT_EQ(scene.probes.size(), 1u) << name;
    EXPECT_TRUE(scene.lights.empty()) << name;
    EXPECT_FALSE(scene.objects.at("floor").seenByProbes) << name;
    const Model model = loadModelFile(kFolder + name + ".glb");
    EXPECT_TRUE(model.lights.empty()) << name;
    for (const Material& material : model.materials) {
      if (material.name == "floor") continue;
      const bool lamp = material.baseColor == glm::vec4(0, 0, 0, 1) && material.metallic == 1.0f;
      EXPECT_TRUE(material.unlit || lamp) << name << ": " << material.name;
    }
  }
}

}  // namespace
