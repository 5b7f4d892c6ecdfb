// The editor's gestures: which previews and commits are one undo step, decided by their token and not by what the step
// is called.
#include "app/gui/edit/editor.h"

#include <gtest/gtest.h>

#include "tests/unit/two_probes.h"

namespace boxprobe {
namespace {

class EditorTest : public ::testing::Test {
 protected:
  EditorTest() { document.open(twoProbes(), ""); }

  static Document::Edit exposure(double value) {
    return [value](Scene& scene) { scene.exposure = value; };
  }
  static Editor::ProbeEdit intensity(double value) {
    return [value](Probe& probe) { probe.intensity = value; };
  }
  int undoSteps() {
    int steps = 0;
    for (; document.canUndo(); ++steps) document.undo();
    return steps;
  }

  Document document;
  Editor editor{document};
  const int slider = 0, field = 0;  ///< controls: their addresses count
};

TEST_F(EditorTest, OneGestureIsOneStepWhateverItsPreviewsAreCalled) {
  editor.preview({&slider}, "Set exposure to 2", exposure(2.0));
  editor.preview({&slider}, "Belichtung 3", exposure(3.0));
  editor.commit({&slider}, "Set exposure to 4", exposure(4.0));
  EXPECT_EQ(document.undoLabel(), "Set exposure to 4");
  EXPECT_EQ(document.scene().exposure, 4.0);
  EXPECT_EQ(undoSteps(), 1);
}

TEST_F(EditorTest, TwoControlsAreTwoStepsAlthoughTheirLabelsAreTheSame) {
  editor.preview({&slider}, "Set exposure", exposure(2.0));
  editor.preview({&field}, "Set exposure", exposure(3.0));
  editor.finish();
  EXPECT_EQ(document.scene().exposure, 3.0);
  document.undo();
  EXPECT_EQ(document.scene().exposure, 2.0);
  EXPECT_EQ(undoSteps(), 1);
}

TEST_F(EditorTest, ACommitOfAnotherControlKeepsWhatWasPreviewed) {
  editor.preview({&slider}, "Set exposure", exposure(2.0));
  editor.commit({&field}, "Set exposure", exposure(3.0));
  EXPECT_EQ(undoSteps(), 2);
}

TEST_F(EditorTest, PartsAndTargetsOfOneControlAreStepsOfTheirOwn) {
  editor.preview({&field, 0, "x"}, "Set", exposure(2.0));
  editor.preview({&field, 1, "x"}, "Set", exposure(3.0));
  editor.preview({&field, 1, "y"}, "Set", exposure(4.0));
  editor.finish();
  EXPECT_EQ(undoSteps(), 3);
}

TEST_F(EditorTest, AnEditWithoutGestureNeverGoesOnWithOne) {
  editor.preview({}, "Set exposure", exposure(2.0));
  editor.preview({}, "Set exposure", exposure(3.0));
  editor.commit("Set exposure", exposure(4.0));
  EXPECT_EQ(undoSteps(), 3);
}

TEST_F(EditorTest, TheSameControlOnAnotherProbeIsAnotherStep) {
  editor.selectProbe(0);
  editor.previewProbe({&field}, "Set intensity", intensity(2.0));
  // Not through the editor, which would end the gesture itself.
  document.selectProbe(1);
  editor.previewProbe({&field}, "Set intensity", intensity(3.0));
  editor.finish();
  EXPECT_EQ(document.scene().probes[0].intensity, 2.0);
  EXPECT_EQ(document.scene().probes[1].intensity, 3.0);
  EXPECT_EQ(undoSteps(), 2);
}

TEST_F(EditorTest, AGestureThatEndedIsNotTakenUpAgain) {
  editor.preview({&slider}, "Set exposure", exposure(2.0));
  editor.finish();
  editor.preview({&slider}, "Set exposure", exposure(3.0));
  editor.cancel();
  EXPECT_EQ(document.scene().exposure, 2.0);
  EXPECT_EQ(undoSteps(), 1);
}

}  // namespace
}  // namespace boxprobe
