// More objects than the machine has memory for are refused before any of them is made.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "filters/core/base/errors.h"
#include "filters/platform/process.h"
#include "filters/vtk/scene/object_memory.h"

namespace boxprobe {
namespace {

TEST(ManyObjects, MoreThanMemoryHoldsAreOneLineThatNamesTheFile) {
  const std::uint64_t memory = physicalMemoryBytes();
  if (memory == 0 || memory > (std::uint64_t(200) << 30u)) GTEST_SKIP() << "the list itself would be large";
  Scene scene;
  scene.models = {ModelFile{"few.glb"}, ModelFile{"many.glb"}};
  const auto few = std::make_shared<Model>(), many = std::make_shared<Model>();
  few->instances.resize(3);
  requireMemoryForObjects(scene, {few, few});
  many->instances.resize(memory / 2 / 40000 + 1);
  try {
    requireMemoryForObjects(scene, {few, many});
    FAIL() << "not refused";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind("many.glb: places meshes " + std::to_string(many->instances.size()) + " times", 0), 0u)
        << text;
    EXPECT_NE(text.find(std::to_string(many->instances.size() + 3) + " objects"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace boxprobe
