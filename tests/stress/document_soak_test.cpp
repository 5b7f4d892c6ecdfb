// Thousands of random edits, undone, redone, previewed, refused, saved and loaded at random moments: the document is at
// every moment what a plain list of scenes says it should be, and everything can be undone to the beginning.
#include <gtest/gtest.h>

#include "filters/core/base/errors.h"
#include "filters/core/scene/document.h"
#include "filters/io/scene/scene_file.h"
#include "tests/stress/random_edits.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using test::RandomEdits;

/// What undo should be, without any cleverness: all states, and where one stands.
struct History {
  std::vector<Scene> states;
  std::size_t position = 0;
  const Scene& now() const { return states[position]; }
  void record(const Scene& scene) {
    if (scene == now()) return;
    states.resize(position + 1);
    states.push_back(scene);
    ++position;
  }
};

class DocumentSoak : public TemporaryFolder {
 protected:
  void edit(RandomEdits& random) {
    if (random.oneIn(16)) {
      EXPECT_THROW(document.commit("refused", random.nextInvalid(history.now())), InputError);
      EXPECT_FALSE(document.preview(random.nextInvalid(history.now())));
      ++refused;
      return;
    }
    const auto change = random.next(history.now());
    Scene expected = history.now();
    change(expected);
    if (random.oneIn(6)) {  // a drag: given up, or kept
      for (int i = 0; i < 3; ++i) ASSERT_TRUE(document.preview(random.next(history.now())));
      ASSERT_TRUE(document.preview(change));
      ASSERT_EQ(document.scene(), expected);
      if (random.oneIn(2)) return document.cancel();
      document.commitPreview("drag");
    } else {
      document.commit("edit", change);
    }
    history.record(expected);
    ++edits;
  }

  void save() {
    const std::string path = file("scene.boxprobe.json");
    saveSceneFile(history.now(), path);
    document.markSaved(path);
    EXPECT_FALSE(document.modified());
    // parseScene and not loadSceneFile, which wants the files that are named to be there.
    ASSERT_EQ(parseScene(read("scene.boxprobe.json"), path, folder_.string()), history.now());
    EXPECT_EQ(entryCount(), 1u) << "saving left something beside the file";
    ++saves;
  }

  /// From here on the file's scene, as after Open.
  void load() {
    save();
    document.open(parseScene(read("scene.boxprobe.json"), "scene", folder_.string()), file("scene.boxprobe.json"));
    history = {{document.scene()}, 0};
    ++loads;
  }

  void run(unsigned seed, int steps) {
    test::EditLimits limits;
    limits.folder = folder_.string();
    RandomEdits random(seed, limits);
    document.open(Scene(), "");
    history = {{document.scene()}, 0};
    for (int i = 0; i < steps && !HasFatalFailure(); ++i) {
      const std::size_t kind = random.below(100);
      if (kind < 70) {
        edit(random);
      } else if (kind < 85) {
        document.undo();
        if (history.position > 0) --history.position;
      } else if (kind < 95) {
        document.redo();
        if (history.position + 1 < history.states.size()) ++history.position;
      } else if (kind < 99) {
        document.selectProbe(random.below(4));
      } else {
        random.oneIn(8) ? load() : save();
      }
      ASSERT_EQ(document.scene(), history.now()) << "seed " << seed << ", step " << i;
      ASSERT_EQ(document.canUndo(), history.position > 0);
      ASSERT_EQ(document.canRedo(), history.position + 1 < history.states.size());
    }
    const Scene last = document.scene();
    while (document.canUndo()) document.undo();
    EXPECT_EQ(document.scene(), history.states.front());
    while (document.canRedo()) document.redo();
    EXPECT_EQ(document.scene(), history.states.back());
    while (!(document.scene() == last) && document.canUndo()) document.undo();
    EXPECT_EQ(document.scene(), last);
  }

  Document document;
  History history;
  int edits = 0, refused = 0, saves = 0, loads = 0;
};

TEST_F(DocumentSoak, EveryStateIsTheOneItShouldBe) {
  for (unsigned seed = 1; seed <= 10; ++seed) run(seed, 5000);
  std::cout << edits << " edits, " << refused << " refused, " << saves << " saved and read, " << loads << " opened\n";
  EXPECT_GT(edits, 25000);
  EXPECT_GT(refused, 500);
  EXPECT_GT(saves, 100);
  EXPECT_GT(loads, 4);
}

}  // namespace
}  // namespace boxprobe
