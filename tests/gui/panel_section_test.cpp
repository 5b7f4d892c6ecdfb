// Sections of the panels fold by a click on their title, are found by a word, and open for the keyboard.
#include "app/gui/widgets/panel_section.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QTest>

#include "app/gui/widgets/preferences.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class PanelSectionTest : public WindowTest {
 protected:
  PanelSection* section(const QString& title) {
    for (PanelSection* each : window_->findChildren<PanelSection*>()) {
      if (each->title().endsWith(title)) return each;
    }
    return nullptr;
  }
  QLineEdit* search() { return window_->findChild<QLineEdit*>("search"); }
};

TEST_F(PanelSectionTest, AClickOnTheTitleFoldsAndTheNextRunRemembers) {
  PanelSection* influence = section("Influence");
  ASSERT_TRUE(influence != nullptr && influence->isVisible());
  waitUntilIdle();  // the scene that was on show before had other rows
  QTest::qWait(50);
  const int height = influence->height();
  QTest::mouseClick(influence, Qt::LeftButton, {}, QPoint(30, 8));
  QCoreApplication::processEvents();
  EXPECT_LT(influence->height(), height / 2);
  EXPECT_TRUE(sectionIsFolded("Influence"));
  EXPECT_TRUE(PanelSection("Influence", nullptr).folded());
  // A click beside the title is none.
  QTest::mouseClick(section("Probe"), Qt::LeftButton, {}, QPoint(30, section("Probe")->height() - 3));
  EXPECT_FALSE(section("Probe")->folded());
  // What the keyboard comes to is shown.
  influence->findChild<QWidget*>("blendDistance")->setFocus();
  QCoreApplication::processEvents();
  EXPECT_FALSE(influence->folded());
  EXPECT_EQ(influence->height(), height);
  EXPECT_FALSE(sectionIsFolded("Influence"));
}

TEST_F(PanelSectionTest, AWordFindsTheSectionsThatHaveIt) {
  section("Influence")->setFolded(true);
  type(search(), "blend dist");
  EXPECT_TRUE(section("Influence")->isVisible());
  EXPECT_GT(section("Influence")->height(), 60) << "found, it is unfolded";
  EXPECT_TRUE(section("Picture")->isHidden());
  QTest::keyClick(search(), Qt::Key_Escape);
  EXPECT_EQ(search()->text(), "");
  EXPECT_FALSE(section("Picture")->isHidden());
  EXPECT_TRUE(section("Influence")->folded()) << "as it was";
  type(search(), "texels per pixel");
  EXPECT_TRUE(section("Planar mirror")->isVisible()) << "its page is turned to: on the first, nothing is found";
  QTest::keyClick(search(), Qt::Key_Escape);
  section("Influence")->setFolded(false);
}

}  // namespace
}  // namespace boxprobe
