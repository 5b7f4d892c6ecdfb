// The card by itself: what it sets, what it leaves while hidden, and the texels it shows on the cubemap.
#include "app/gui/explain/explain_card.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "app/gui/explain/explanation_html.h"
#include "app/gui/explain/footprint_view.h"
#include "tests/unit/explained_room.h"

namespace boxprobe {
namespace {

class ExplainCardTest : public ::testing::Test {
 protected:
  ExplainCardTest()
      : card_([this](const std::string&) {
          ++read_;
          return room_.captured ? std::make_shared<const BakedMaps>(room_.maps) : nullptr;
        }) {
    card_.resize(420, 700);
  }
  void open() {
    card_.QWidget::show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&card_, 60000));
  }

  ExplainedRoom room_;
  int read_ = 0;
  ExplainCard card_;
};

TEST_F(ExplainCardTest, HiddenItSetsNothingAndShownItCatchesUp) {
  card_.show(room_.explain(), {}, 1.0);
  EXPECT_EQ(read_, 0);
  EXPECT_FALSE(card_.text().contains("floor"));
  open();
  EXPECT_TRUE(card_.text().contains("floor"));
  EXPECT_GT(read_, 0);
}

TEST_F(ExplainCardTest, SaysWhatIsUndefinedFirst) {
  open();
  room_.probe.technique = "infinite";
  card_.show(room_.explain(), {}, 1.0);
  const QString text = card_.text();
  const int note = text.indexOf("has no box to hit");
  EXPECT_GE(note, 0);
  EXPECT_LT(note, text.indexOf("Surface:"));
  room_.captured = false;
  card_.show(room_.explain(), {}, 1.0);
  EXPECT_TRUE(card_.text().contains("not captured yet"));
}

TEST_F(ExplainCardTest, TheVerdictStandsFirstAndItsMendIsAButton) {
  open();
  auto* sentence = card_.findChild<QLabel*>("verdict");
  auto* button = card_.findChild<QPushButton*>("mend");
  EXPECT_FALSE(sentence->isVisible());
  Verdict verdict{Phrase::plain("The sky, because \"room\" ends short."),
                  Mend{Phrase::plain("Widen it"), "room", room_.probe}};
  verdict.mend->after.blendDistance.min.x = 0.25;
  card_.show(room_.explain(), verdict, 1.0);
  EXPECT_EQ(sentence->text(), QString::fromStdString(verdict.sentence.english()) + "\nWiden it.");
  Probe asked;
  QObject::connect(&card_, &ExplainCard::mendRequested, [&](const Mend& mend) { asked = mend.after; });
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_TRUE(asked == verdict.mend->after);
  card_.show(room_.explain(), {Phrase::plain("Probe \"room\", right to 0.2 degrees."), {}}, 1.0);
  EXPECT_FALSE(button->isVisible());
  card_.showHint("E");
  EXPECT_FALSE(sentence->isVisible());
}

TEST_F(ExplainCardTest, OutlinesTheTexelsOnTheFaceThatIsHit) {
  open();
  card_.show(room_.explain(), {}, 1.0);
  auto* footprint = card_.findChild<FootprintView*>();
  ASSERT_NE(footprint, nullptr);
  EXPECT_TRUE(footprint->isVisible());
  const QImage image = footprint->grab().toImage();
  // The cross is as large as fits, in the middle. Parts of it by shares: left, top, right, bottom.
  const double width = std::min<double>(image.width(), image.height() * 4.0 / 3.0);
  const double first = 0.5 * (image.width() - width), height = 0.75 * width;
  const auto marked = [&](double left, double top, double right, double bottom) {
    int count = 0;
    for (int y = static_cast<int>(top * height); y < static_cast<int>(bottom * height); ++y) {
      for (int x = static_cast<int>(first + left * width); x < static_cast<int>(first + right * width); ++x) {
        const QColor at = image.pixelColor(x, y);
        count += at.red() > 200 && at.green() > 120 && at.green() < 210 && at.blue() < 90 ? 1 : 0;
      }
    }
    return count;
  };
  // +X is the leftmost face, in the middle row; the hit is on it.
  EXPECT_GT(marked(0.0, 0.34, 0.24, 0.66), 10);
  EXPECT_EQ(marked(0.27, 0.36, 0.99, 0.64), 0) << "the other faces of the row";
  EXPECT_GT(marked(0.5, 0.0, 0.99, 0.32), 40) << "the magnified texels";
}

TEST(ExplanationHtml, TypesetsColorsAndSymbols) {
  EXPECT_EQ(displayColor(glm::vec3(0.25f), 4.0), QColor(Qt::white));
  EXPECT_EQ(displayColor(glm::vec3(-1.0f), 1.0), QColor(Qt::black));
  EXPECT_TRUE(symbolHtml(Phrase::plain("t_x")).contains("<sub>x</sub>"));
  EXPECT_FALSE(symbolHtml(Phrase::tr("direct")).contains("italic")) << "a word is no symbol";
}

}  // namespace
}  // namespace boxprobe
