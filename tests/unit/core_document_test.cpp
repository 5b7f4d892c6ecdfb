// Undo, redo, previews, selection and observers of the Document.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/core/scene/document.h"
#include "tests/unit/error_text.h"
#include "tests/unit/two_probes.h"

namespace boxprobe {
namespace {

class DocumentTest : public ::testing::Test {
 protected:
  DocumentTest() {
    document.open(twoProbes(), "two.boxprobe.json");
    document.addObserver([this](const Changes& changes) {
      last = changes;
      ++notified;
    });
  }
  static Document::Edit moveFace(double x) {
    return [x](Scene& scene) { scene.probes[0].box.max.x = x; };
  }
  double face() const { return document.scene().probes[0].box.max.x; }

  Document document;
  Changes last;
  int notified = 0;
};

TEST_F(DocumentTest, CommitIsOneStepThatUndoTakesBackAndRedoBrings) {
  document.commit("Move face", moveFace(5));
  EXPECT_EQ(face(), 5);
  EXPECT_TRUE(last.probeShape);
  EXPECT_FALSE(last.probeCapture);
  EXPECT_TRUE(last.file);  // it has become modified
  EXPECT_EQ(document.undoLabel(), "Move face");
  EXPECT_FALSE(document.canRedo());
  document.undo();
  EXPECT_EQ(face(), 1);
  EXPECT_FALSE(document.canUndo());
  EXPECT_EQ(document.undoLabel(), "");
  EXPECT_EQ(document.redoLabel(), "Move face");
  document.redo();
  EXPECT_EQ(face(), 5);
}

TEST_F(DocumentTest, UndoAndRedoAtTheEndsDoNothing) {
  document.undo();
  document.redo();
  EXPECT_EQ(face(), 1);
  EXPECT_EQ(notified, 0);
}

TEST_F(DocumentTest, CommittingAfterUndoDropsWhatCouldBeRedone) {
  document.commit("first", moveFace(2));
  document.commit("second", moveFace(3));
  document.undo();
  document.commit("third", moveFace(4));
  EXPECT_FALSE(document.canRedo());
  document.undo();
  EXPECT_EQ(face(), 2);
  document.undo();
  EXPECT_EQ(face(), 1);
}

// The history: from any step to any other, as by so many undos and redos.
TEST_F(DocumentTest, GoesToAnyStepOfItsHistory) {
  for (int x = 2; x <= 4; ++x) document.commit("to " + std::to_string(x), moveFace(x));
  EXPECT_EQ(document.stepLabels(), (std::vector<std::string>{"to 2", "to 3", "to 4"}));
  for (const std::size_t position : {1u, 3u, 0u, 2u, 0u, 3u, 1u}) {
    document.goTo(position);
    EXPECT_EQ(document.position(), position);
    EXPECT_EQ(face(), 1.0 + static_cast<double>(position));
    EXPECT_EQ(document.canUndo(), position > 0);
    EXPECT_EQ(document.canRedo(), position < 3);
  }
  EXPECT_EQ(document.redoLabel(), "to 3");
  document.goTo(99);
  EXPECT_EQ(document.position(), 3u);
  EXPECT_EQ(face(), 4);
  document.preview(moveFace(9));
  document.goTo(3);  // where it stands: the preview is cancelled
  EXPECT_EQ(face(), 4);
  document.goTo(0);
  document.commit("anew", moveFace(7));
  EXPECT_EQ(document.stepLabels(), std::vector<std::string>{"anew"});
}

TEST_F(DocumentTest, ADragOfManyPreviewsIsOneStep) {
  for (int i = 2; i <= 50; ++i) EXPECT_TRUE(document.preview(moveFace(i)));
  EXPECT_TRUE(document.previewing());
  EXPECT_EQ(face(), 50);
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.modified());
  document.commitPreview("Drag face");
  EXPECT_FALSE(document.previewing());
  EXPECT_EQ(document.undoLabel(), "Drag face");
  document.undo();
  EXPECT_EQ(face(), 1);
  EXPECT_FALSE(document.canUndo());
}

TEST_F(DocumentTest, PreviewsDoNotPileUp) {
  const Document::Edit grow = [](Scene& scene) { scene.probes[0].box.max.x += 1; };
  document.preview(grow);
  document.preview(grow);
  EXPECT_EQ(face(), 2);
}

TEST_F(DocumentTest, CancelShowsTheCommittedSceneAgain) {
  document.preview(moveFace(9));
  notified = 0;
  document.cancel();
  EXPECT_EQ(face(), 1);
  EXPECT_EQ(notified, 1);
  EXPECT_TRUE(last.probeShape);
  EXPECT_FALSE(document.canUndo());
  document.commitPreview("nothing to commit");
  EXPECT_FALSE(document.canUndo());
}

TEST_F(DocumentTest, UndoDuringAPreviewEndsIt) {
  document.commit("first", moveFace(2));
  document.preview(moveFace(9));
  document.undo();
  EXPECT_EQ(face(), 1);
  EXPECT_FALSE(document.previewing());
  EXPECT_EQ(document.redoLabel(), "first");
}

TEST_F(DocumentTest, AnInvalidCommitThrowsAndShowsTheCommittedScene) {
  document.preview(moveFace(9));
  const std::string text = errorText([&] { document.commit("bad", moveFace(-9)); });
  EXPECT_EQ(text, "probes.room.box: min.x -1 is greater than max.x -9; swap them");
  EXPECT_EQ(face(), 1);
  EXPECT_FALSE(document.previewing());
  EXPECT_FALSE(document.canUndo());
}

TEST_F(DocumentTest, AnInvalidPreviewKeepsWhatIsShown) {
  EXPECT_TRUE(document.preview(moveFace(9)));
  EXPECT_FALSE(document.preview(moveFace(-9)));
  EXPECT_EQ(face(), 9);
  document.commitPreview("Drag");
  EXPECT_EQ(face(), 9);
}

TEST_F(DocumentTest, AnEditThatThrowsLeavesEverythingAsItWas) {
  const Document::Edit broken = [](Scene& scene) {
    scene.probes.clear();
    throw std::runtime_error("broken");
  };
  EXPECT_THROW(document.commit("broken", broken), std::runtime_error);
  EXPECT_THROW(document.preview(broken), std::runtime_error);
  EXPECT_EQ(document.scene(), twoProbes());
  EXPECT_FALSE(document.canUndo());
}

TEST_F(DocumentTest, CommittingNoChangeIsNoStep) {
  document.commit("nothing", [](Scene&) {});
  EXPECT_FALSE(document.canUndo());
  EXPECT_EQ(notified, 0);
  document.preview(moveFace(9));
  document.preview(moveFace(1));  // dragged back to where it was
  document.commitPreview("Drag");
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.previewing());
}

TEST_F(DocumentTest, ModifiedFollowsTheSavedSceneThroughUndo) {
  EXPECT_FALSE(document.modified());
  document.commit("first", moveFace(2));
  EXPECT_TRUE(document.modified());
  document.markSaved("other.boxprobe.json");
  EXPECT_TRUE(last.file);
  EXPECT_EQ(document.path(), "other.boxprobe.json");
  EXPECT_FALSE(document.modified());
  document.undo();
  EXPECT_TRUE(document.modified());
  document.redo();
  EXPECT_FALSE(document.modified());
  EXPECT_TRUE(last.file);
}

TEST_F(DocumentTest, OpeningStartsAnew) {
  document.commit("first", moveFace(2));
  document.selectProbe(1);
  document.open(Scene(), "empty.boxprobe.json");
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.modified());
  EXPECT_FALSE(document.selectedProbe());
  EXPECT_TRUE(last.probeList && last.file && last.models);
  Scene invalid = twoProbes();
  invalid.probes[1].name = "room";
  EXPECT_THROW(document.open(invalid, "bad.json"), InputError);
  EXPECT_EQ(document.path(), "empty.boxprobe.json");
}

TEST_F(DocumentTest, SelectionFollowsTheProbeNotTheRow) {
  document.selectProbe(1);
  EXPECT_TRUE(last.selection);
  EXPECT_EQ(document.selectedProbe(), std::optional<std::size_t>(1));
  document.commit("Swap", [](Scene& scene) { std::swap(scene.probes[0], scene.probes[1]); });
  EXPECT_EQ(document.selectedProbe(), std::optional<std::size_t>(0));
  EXPECT_TRUE(last.selection);
  document.commit("Rename", [](Scene& scene) { scene.probes[0].name = "attic"; });
  EXPECT_EQ(document.selectedProbe(), std::optional<std::size_t>(0));
  document.undo();
  EXPECT_EQ(document.scene().probes[0].name, "hall");
  EXPECT_EQ(document.selectedProbe(), std::optional<std::size_t>(0));
}

TEST_F(DocumentTest, SelectionIsGoneWithItsProbeAndBackWithIt) {
  document.selectProbe(1);
  document.commit("Delete", [](Scene& scene) { scene.probes.pop_back(); });
  EXPECT_FALSE(document.selectedProbe());
  EXPECT_TRUE(last.selection);
  document.undo();
  EXPECT_EQ(document.selectedProbe(), std::optional<std::size_t>(1));
  document.selectProbe(7);  // beyond the list: nothing
  EXPECT_FALSE(document.selectedProbe());
}

TEST_F(DocumentTest, ObserversAreCalledInOrderAndCanLeave) {
  std::string calls;
  std::size_t second = 0;
  document.addObserver([&](const Changes&) {
    calls += 'a';
    document.removeObserver(second);
  });
  second = document.addObserver([&](const Changes&) { calls += 'b'; });
  document.addObserver([&](const Changes&) { calls += 'c'; });
  document.commit("first", moveFace(2));
  EXPECT_EQ(calls, "ac");
}

TEST_F(DocumentTest, AThrowingObserverNeitherCorruptsNorSilencesTheOthers) {
  document.addObserver([](const Changes&) { throw std::runtime_error("observer"); });
  int after = 0;
  document.addObserver([&](const Changes&) { ++after; });
  EXPECT_THROW(document.commit("first", moveFace(2)), std::runtime_error);
  EXPECT_EQ(after, 1);
  EXPECT_EQ(face(), 2);
  EXPECT_EQ(document.undoLabel(), "first");
  EXPECT_THROW(document.undo(), std::runtime_error);
  EXPECT_EQ(face(), 1);
  EXPECT_TRUE(document.canRedo());
}

TEST_F(DocumentTest, AnObserverMayEdit) {
  document.addObserver([&](const Changes& changes) {
    if (changes.probeShape && face() > 3) document.commit("clamp", moveFace(3));
  });
  document.commit("first", moveFace(5));
  EXPECT_EQ(face(), 3);
  EXPECT_EQ(document.undoLabel(), "clamp");
  document.undo();  // back to 5, which the observer does not leave standing
  EXPECT_EQ(face(), 3);
}

TEST(DocumentState, ComesBackWholeAfterAnotherSceneWasShown) {
  Document document;
  document.open(twoProbes(), "mine.boxprobe.json");
  document.selectProbe(1);
  document.commit("One", [](Scene& scene) { scene.probes[1].intensity = 2.0; });
  document.commit("Two", [](Scene& scene) { scene.probes[1].intensity = 3.0; });
  document.undo();
  const Document::State mine = document.state();

  Scene other = twoProbes();
  other.probes.pop_back();
  document.restore(Document::State::opened(other, "", other.probes.front().name));
  EXPECT_EQ(document.selectedProbe(), std::optional<std::size_t>(0));
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.modified());
  document.commit("Theirs", [](Scene& scene) { scene.probes[0].intensity = 9.0; });

  document.restore(mine);
  EXPECT_EQ(document.path(), "mine.boxprobe.json");
  EXPECT_EQ(document.scene().probes[1].intensity, 2.0);
  EXPECT_EQ(document.selectedProbe(), std::optional<std::size_t>(1));
  EXPECT_TRUE(document.modified());
  EXPECT_EQ(document.undoLabel(), "One");
  EXPECT_EQ(document.redoLabel(), "Two");
  document.redo();
  EXPECT_EQ(document.scene().probes[1].intensity, 3.0);
}

TEST(DocumentState, ObserversAreToldWhatDiffersAndNoMore) {
  Document document;
  document.open(twoProbes(), "");
  Scene other = twoProbes();
  other.probes[0].intensity = 2.0;
  Changes seen;
  document.addObserver([&seen](const Changes& changes) { seen = changes; });
  document.restore(Document::State::opened(other, ""));
  EXPECT_TRUE(seen.probeShape);
  EXPECT_TRUE(seen.file);
  EXPECT_FALSE(seen.models);
  EXPECT_FALSE(seen.probeCapture);
  Changes also;
  also.models = true;
  document.restore(Document::State::opened(other, ""), also);
  EXPECT_TRUE(seen.models);
}

TEST(DocumentState, AnInvalidSceneIsNone) {
  Scene broken = twoProbes();
  broken.probes[1].name = broken.probes[0].name;
  EXPECT_THROW(Document::State::opened(broken, ""), InputError);
}

}  // namespace
}  // namespace boxprobe
