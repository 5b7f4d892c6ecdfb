// Hundreds of random edits drawn as they come, with undo and redo, in a small off-screen window: OpenGL has no error
// after any step, pictures stay finite, and memory stops growing once everything has been seen.
#include <gtest/gtest.h>
#include <unistd.h>
#include <vtk_glew.h>

#include <cmath>
#include <fstream>

#include "filters/core/document.h"
#include "tests/stress/random_edits.h"
#include "tests/support/scene_picture.h"

namespace boxprobe::test {
namespace {

constexpr int kEdits = 240;
constexpr std::size_t kMegabyte = std::size_t{1} << 20;

std::size_t residentBytes() {
  std::size_t pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
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

TEST(RendererSoak, DISABLED_HundredsOfEditsLeaveNoErrorAndNoGarbage) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 48, 27);
  for (Probe& probe : picture.scene.probes) probe.faceSize = 16, probe.filterSamples = 8;
  picture.show(cameraNamed(picture.scene, "main"));
  SceneRenderer& renderer = *picture.renderer;
  Document document;
  document.open(picture.scene, "");
  document.addObserver([&](const Changes& changes) { renderer.sync(document.scene(), changes); });
  RandomEdits random(1, smallEdits(picture.scene));
  (void)glErrors();

  // Maps are left out: those kept for undo have a limit of their own.
  const auto withoutMaps = [&] { return residentBytes() - renderer.probeMemoryBytes(); };
  std::size_t warm = 0;
  std::size_t programs = 0;  // compiled, all; then since half-way
  int drawn = 0;
  for (int i = 0; i < kEdits; ++i) {
    const std::size_t kind = random.below(10);
    if (kind < 7) {
      document.commit("edit", random.next(document.scene()));
    } else if (kind < 9) {
      document.undo();
    } else {
      document.redo();
    }
    if (random.oneIn(8)) {  // dragged: captures that an edit overtakes
      renderer.setInteractive(true);
      for (int step = 0; step < 3; ++step) {
        document.preview(random.next(document.scene()));
        picture.window->MakeCurrent();
        renderer.step();
      }
      document.cancel();
      renderer.setInteractive(false);
    }
    // Mostly to the end; sometimes the next edit comes while work is under way. A realtime probe may always have some.
    for (int step = random.oneIn(4) ? 5 : 500; step > 0 && renderer.workPending(); --step) {
      picture.window->MakeCurrent();
      renderer.step();
    }
    ASSERT_EQ(glErrors(), "") << "after the work of edit " << i;
    if (random.oneIn(3)) {
      for (const float value : picture.linear(1).pixels) ASSERT_TRUE(std::isfinite(value)) << "edit " << i;
    } else {
      picture.display();
    }
    ++drawn;
    ASSERT_EQ(glErrors(), "") << "after the picture of edit " << i;
    ASSERT_EQ(renderer.error(), "") << "edit " << i;
    if (i == kEdits / 2) {
      warm = withoutMaps();
      programs = renderer.counters().programsCompiled;
    }
  }
  const std::size_t end = withoutMaps();
  std::cout << drawn << " pictures, resident memory but for maps " << warm / kMegabyte << " MB half-way, "
            << end / kMegabyte << " MB at the end, maps of probes " << renderer.probeMemoryBytes() / kMegabyte
            << " MB, " << renderer.counters().programsCompiled << " programs\n";
  // What the second half may add: programs not met before, some megabytes each in a software driver.
  programs = renderer.counters().programsCompiled - programs;
  EXPECT_LT(end, warm + (64 + 8 * programs) * kMegabyte) << programs << " new programs";
  EXPECT_LT(renderer.probeMemoryBytes(), 300 * kMegabyte);  // 256 are kept for undo, the rest is in use
  while (document.canUndo()) document.undo();
  EXPECT_EQ(document.scene(), picture.scene);
}

}  // namespace
}  // namespace boxprobe::test
