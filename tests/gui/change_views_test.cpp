// Views are told of the kinds of change that they show, and of no other.
#include "app/gui/edit/change_views.h"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>

#include "tests/unit/two_probes.h"

namespace boxprobe {
namespace {

class ChangeViewsTest : public ::testing::Test {
 protected:
  ChangeViewsTest() {
    document.open(twoProbes(), "");
    views.emplace(document);
    views->add("lights", {&Changes::lights, &Changes::sky}, [this](const Changes&) { order += 'l'; });
    views->add("probe", selectedProbeKinds(), [this](const Changes& changes) {
      order += 'p';
      last = changes;
    });
    views->add("all", ChangeKinds::all(), [this](const Changes&) { order += 'a'; });
  }
  void edit(const Document::Edit& change) { document.preview(change); }

  Document document;
  std::optional<ChangeViews> views;
  std::string order;
  Changes last;
};

TEST_F(ChangeViewsTest, AViewIsToldOfItsKindsOnly) {
  edit([](Scene& scene) { scene.skyRotationDegrees = 10.0; });
  EXPECT_EQ(order, "la");
  document.cancel();
  order.clear();
  edit([](Scene& scene) { scene.probes[0].box.max.x += 1.0; });
  EXPECT_EQ(order, "pa");
  EXPECT_TRUE(last.probeShape);
  EXPECT_FALSE(last.probeCapture);
  document.selectProbe(1);
  EXPECT_EQ(order, "papa");
  EXPECT_EQ(views->updates("lights"), 2u);
  EXPECT_EQ(views->updates("probe"), 2u);
  EXPECT_EQ(views->updates("all"), 4u);
  EXPECT_EQ(views->updates("nobody"), 0u);
}

TEST_F(ChangeViewsTest, EverythingIsNewToThemOnce) {
  views->updateAll();
  EXPECT_EQ(order, "lpa");
}

TEST_F(ChangeViewsTest, OneThatThrowsLeavesNoOtherWithoutNews) {
  views->add("broken", {&Changes::exposure}, [](const Changes&) { throw std::runtime_error("broken"); });
  views->add("after", {&Changes::exposure}, [this](const Changes&) { order += 'x'; });
  EXPECT_THROW(edit([](Scene& scene) { scene.exposure = 2.0; }), std::runtime_error);
  EXPECT_EQ(order, "ax");
}

TEST_F(ChangeViewsTest, NobodyIsToldAfterTheEnd) {
  views.reset();
  edit([](Scene& scene) { scene.exposure = 2.0; });
  EXPECT_EQ(order, "");
}

}  // namespace
}  // namespace boxprobe
