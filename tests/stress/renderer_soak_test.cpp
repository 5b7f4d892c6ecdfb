// Hundreds of random edits drawn as they come, with undo and redo, in a small off-screen window: OpenGL has no error
// after any step, pictures stay finite, and the same edits once more need no more memory: what the first round left is
// programs and buffers that the second uses again, and whatever grows is a leak.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cmath>
#include <fstream>
#include <string>

#include "filters/core/scene/document.h"
#include "filters/vtk/gl/opengl.h"
#include "tests/stress/random_edits.h"
#include "tests/support/scene_picture.h"

namespace boxprobe::test {
namespace {

constexpr int kEdits = 100, kRounds = 8;  // edits a round
constexpr std::size_t kMegabyte = std::size_t{1} << 20;

/// Without the pages of files, which the system takes and brings back as it likes. What the allocator merely keeps for
/// later is given back first.
std::size_t residentBytes() {
  ::malloc_trim(0);
  std::ifstream status("/proc/self/status");
  std::size_t kilobytes = 0;
  for (std::string key; status >> key;) {
    std::size_t value = 0;
    if ((key == "RssAnon:" || key == "RssShmem:") && status >> value) kilobytes += value;
  }
  EXPECT_GT(kilobytes, 0u) << "/proc/self/status does not tell";
  return 1024 * kilobytes;
}

/// The names of all errors since the last call.
std::string glErrors() {
  std::string names;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) names += " " + std::to_string(error);
  return names;
}

EditLimits smallEdits(const Scene& scene) {
  EditLimits limits;
  // Every pair of techniques that meets in one object is a program to compile: a few are enough here.
  limits.techniques = {"infinite", "box", "sphere"};
  limits.materials = {"floor", "lamp"};
  limits.nodes = {"sphere 1", "sphere 2", "floor"};
  limits.mostProbes = scene.probes.size() + 2;
  limits.largestFace = 32;
  limits.mostBounces = 2;
  return limits;
}

/// One round, from a document just opened to the same again by undoing all. `edits`: the same for each round.
void soak(ScenePicture& picture, Document& document, RandomEdits edits) {
  SceneRenderer& renderer = *picture.renderer;
  document.open(picture.scene, "");
  for (int i = 0; i < kEdits; ++i) {
    const std::size_t kind = edits.below(10);
    if (kind < 7) {
      document.commit("edit", edits.next(document.scene()));
    } else if (kind < 9) {
      document.undo();
    } else {
      document.redo();
    }
    if (edits.oneIn(8)) {  // dragged: captures that an edit overtakes
      renderer.setInteractive(true);
      for (int step = 0; step < 3; ++step) {
        document.preview(edits.next(document.scene()));
        picture.window->MakeCurrent();
        renderer.step();
      }
      document.cancel();
      renderer.setInteractive(false);
    }
    // Mostly to the end; sometimes the next edit comes while work is under way. A realtime probe may always have some.
    for (int step = edits.oneIn(4) ? 5 : 500; step > 0 && renderer.workPending(); --step) {
      picture.window->MakeCurrent();
      renderer.step();
    }
    ASSERT_EQ(glErrors(), "") << "after the work of edit " << i;
    if (edits.oneIn(3)) {
      for (const float value : picture.linear(1).pixels) ASSERT_TRUE(std::isfinite(value)) << "edit " << i;
    } else {
      picture.display();
    }
    ASSERT_EQ(glErrors(), "") << "after the picture of edit " << i;
    ASSERT_EQ(renderer.error(), "") << "edit " << i;
  }
  while (document.canUndo()) document.undo();
  EXPECT_EQ(document.scene(), picture.scene);
}

TEST(RendererSoak, HundredsOfEditsLeaveNoErrorAndNoGarbage) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 48, 27);
  for (Probe& probe : picture.scene.probes) probe.faceSize = 16, probe.filterSamples = 8;
  picture.show(cameraNamed(picture.scene, "main"));
  SceneRenderer& renderer = *picture.renderer;
  Document document;
  document.addObserver([&](const Changes& changes) { renderer.sync(document.scene(), changes); });
  (void)glErrors();
  // Maps are left out: those kept for undo have a limit of their own.
  const auto withoutMaps = [&] { return residentBytes() - renderer.probeMemoryBytes(); };

  const RandomEdits edits(1, smallEdits(picture.scene));
  std::size_t after[kRounds] = {};
  int programs[kRounds] = {};
  for (int round = 0; round < kRounds; ++round) {
    soak(picture, document, edits);
    ASSERT_FALSE(HasFatalFailure());
    after[round] = withoutMaps();
    programs[round] = renderer.counters().programsCompiled;
    std::cout << "round " << round + 1 << ": " << kEdits << " edits, " << programs[round]
              << " programs, resident memory but for maps " << after[round] / kMegabyte << " MB, maps "
              << renderer.probeMemoryBytes() / kMegabyte << " MB\n";
  }
  EXPECT_EQ(programs[kRounds - 1], programs[1]) << "compiled again although they were there";
  EXPECT_LT(after[kRounds - 1], after[1] + 8 * kMegabyte);  // pages of the driver's come and go
  EXPECT_LT(renderer.probeMemoryBytes(), 300 * kMegabyte);  // 256 are kept for undo, the rest is in use
}

}  // namespace
}  // namespace boxprobe::test
