// Which panels are updated while something is edited: those that show it, and no other.
#include <gtest/gtest.h>

#include <map>

#include "app/gui/view/viewport.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

using Updates = std::map<std::string, std::size_t>;

class PanelUpdatesTest : public WindowTest {
 protected:
  /// Of every panel, since `before` was counted.
  Updates since(const Updates& before = {}) const {
    Updates now;
    for (const char* panel : {"outliner", "probe panel", "bake panel", "capture panel", "material panel",
                              "object panel", "light panel", "picture panel", "cubemap", "cost panel"}) {
      const auto was = before.find(panel);
      now[panel] = window_->views().updates(panel) - (was == before.end() ? 0 : was->second);
    }
    return now;
  }
  static Updates withoutNone(Updates updates) {
    for (auto it = updates.begin(); it != updates.end();) it = it->second == 0 ? updates.erase(it) : std::next(it);
    return updates;
  }
};

TEST_F(PanelUpdatesTest, DraggingAFaceUpdatesOnlyWhatShowsTheBox) {
  const BoxFace plusX{0, true};
  const QPointF from = facePixel(plusX), to = facePixelAfter(plusX, -1.0);
  press(from);
  move(from + (to - from) * 0.1);
  const Updates before = since();
  constexpr int kMoves = 20;
  for (int i = 3; i < 3 + kMoves; ++i) move(from + (to - from) * i / (2 + kMoves));
  // The bake panel shows whether an object uses the probe, which the box decides.
  EXPECT_EQ(withoutNone(since(before)), (Updates{{"probe panel", kMoves}, {"bake panel", kMoves}}));
  const Updates atEnd = since();
  release(to);
  waitUntilIdle();
  EXPECT_NEAR(probe().box.max.x, 0.5, 0.03);
  // The scene has become another than the one saved: whoever shows the file is told.
  EXPECT_EQ(withoutNone(since(atEnd)), (Updates{{"cost panel", 1}}));
}

TEST_F(PanelUpdatesTest, EachEditReachesThePanelThatShowsIt) {
  const auto updatesOf = [&](const Document::Edit& edit) {
    const Updates before = since();
    document().preview(edit);
    Updates updates = withoutNone(since(before));
    document().cancel();
    return updates;
  };
  EXPECT_EQ(updatesOf([](Scene& scene) { scene.exposure = 2.0; }), (Updates{{"picture panel", 1}, {"cubemap", 1}}));
  EXPECT_EQ(updatesOf([](Scene& scene) { scene.skyRotationDegrees = 30.0; }),
            (Updates{{"light panel", 1}, {"bake panel", 1}}));
  EXPECT_EQ(updatesOf([](Scene& scene) { scene.probes[0].faceSize = 64; }),
            (Updates{{"probe panel", 1}, {"bake panel", 1}, {"capture panel", 1}}));
  EXPECT_EQ(updatesOf([](Scene& scene) { scene.probes[0].technique = "sphere"; }),
            (Updates{{"probe panel", 1}, {"bake panel", 1}, {"cost panel", 1}}));
  EXPECT_EQ(updatesOf([](Scene& scene) { scene.probes[0].name = "other"; }).count("outliner"), 1u);
}

}  // namespace
}  // namespace boxprobe
