// Formulas: where the parts of a fraction, a root, scripts and limits stand, and that nothing is lost.
#include <gtest/gtest.h>

#include <QGuiApplication>

#include "app/gui/formula/formula_picture.h"
#include "app/gui/formula/mathml_layout.h"

namespace boxprobe {
namespace {

MathBox math(const char* inside) {
  return layoutMathml(QString("<math>%1</math>").arg(QString::fromUtf8(inside)));
}

/// Is there ink of the outline in that strip of heights (em, up from the baseline)?
bool inked(const MathBox& box, double low, double high) {
  return box.path.intersects(QRectF(-1.0, -high, box.width + 2.0, high - low));
}

TEST(Formula, AFractionHasABarBetweenItsParts) {
  const MathBox box = math("<mfrac><mn>1</mn><mn>2</mn></mfrac>");
  EXPECT_TRUE(inked(box, 0.24, 0.28)) << "the bar";
  EXPECT_FALSE(inked(box, 0.31, 0.35)) << "the gap over it";
  EXPECT_FALSE(inked(box, 0.17, 0.21)) << "the gap under it";
  EXPECT_TRUE(inked(box, 0.5, 0.9));
  EXPECT_TRUE(inked(box, -0.4, 0.0));
  EXPECT_GT(box.width, math("<mn>1</mn>").width);
}

TEST(Formula, ARootCoversItsRadicand) {
  const MathBox inside = math("<mrow><mn>1</mn><mo>-</mo><mi>x</mi></mrow>");
  const MathBox root = math("<msqrt><mn>1</mn><mo>-</mo><mi>x</mi></msqrt>");
  EXPECT_GT(root.ascent, inside.ascent);
  EXPECT_GT(root.width, inside.width + 0.3);
  const QRectF bar(root.width - 0.25, -root.ascent, 0.1, 0.05);
  EXPECT_TRUE(root.path.intersects(bar)) << "the bar goes to the end";
  EXPECT_GT(math("<mroot><mi>x</mi><mn>4</mn></mroot>").path.elementCount(),
            math("<msqrt><mi>x</mi></msqrt>").path.elementCount());
}

TEST(Formula, ScriptsAreSmallerAndOffTheBaseline) {
  const MathBox base = math("<mi>x</mi>");
  const MathBox up = math("<msup><mi>x</mi><mn>2</mn></msup>");
  const MathBox down = math("<msub><mi>x</mi><mn>2</mn></msub>");
  EXPECT_GT(up.ascent, base.ascent + 0.2);
  EXPECT_NEAR(up.descent, base.descent, 1e-9);
  EXPECT_GT(down.descent, base.descent + 0.1);
  EXPECT_LT(up.width - base.width, math("<mn>2</mn>").width);
  EXPECT_LT(up.ascent, base.ascent + 0.5) << "and no farther off it than they need";
  EXPECT_LT(down.descent, base.descent + 0.3);
}

TEST(Formula, LimitsStandUnderTheirOperator) {
  const MathBox min = math("<munder><mo>min</mo><mi>i</mi></munder>");
  EXPECT_NEAR(min.width, math("<mo>min</mo>").width, 1e-9);
  EXPECT_TRUE(inked(min, -min.descent, -0.2));
}

TEST(Formula, FencesGrowWithWhatTheyEncloseAndNoMore) {
  const MathBox plain = math("<mo>(</mo><mi>a</mi><mo>)</mo>");
  const MathBox tall = math("<mo>(</mo><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>)</mo>");
  const MathBox beside = math("<mfrac><mi>a</mi><mi>b</mi></mfrac><mo>(</mo><mi>a</mi><mo>)</mo>");
  EXPECT_GT(tall.ascent, plain.ascent + 0.1);
  EXPECT_LT(beside.path.boundingRect().height(), tall.path.boundingRect().height());
  EXPECT_GT(math("<mfenced><mi>a</mi><mi>b</mi></mfenced>").width, plain.width);
}

TEST(Formula, OperatorsKeepTheirDistance) {
  const MathBox letters = math("<mi>a</mi><mi>b</mi>");
  const MathBox sum = math("<mi>a</mi><mo>+</mo><mi>b</mi>");
  EXPECT_GT(sum.width, letters.width + math("<mo>+</mo>").width + 0.3);
  const MathBox negative = math("<mo>-</mo><mi>b</mi>"), less = math("<mi>a</mi><mo>-</mo><mi>b</mi>");
  EXPECT_LT(negative.width, less.width - math("<mi>a</mi>").width - 0.3) << "a sign stands at its number";
  EXPECT_NEAR(math("<mo>∞</mo><mo>,</mo><mi>b</mi>").width,
              math("<mi mathvariant='normal'>∞</mi><mo>,</mo><mi>b</mi>").width, 1e-9)
      << "infinity is a number here";
  EXPECT_GT(math("<mo>-</mo>").width, mathText("-", MathFont::Upright, 1.0).width) << "a minus sign is no hyphen";
}

TEST(Formula, SingleLettersSlantAndWordsAndCapitalGreekStand) {
  const auto likeVariant = [](const QString& text, const char* variant) {
    const MathBox plain = layoutMathml(QString("<math><mi>%1</mi></math>").arg(text));
    return plain.path == layoutMathml(QString("<math><mi mathvariant=\"%1\">%2</mi></math>").arg(variant, text)).path;
  };
  const QString rho = QString::fromUtf8("ρ"), delta = QString::fromUtf8("Δ");
  for (const QString& slanting : {QString("x"), rho}) {
    EXPECT_TRUE(likeVariant(slanting, "italic")) << slanting.toStdString();
    EXPECT_FALSE(likeVariant(slanting, "normal")) << slanting.toStdString();
  }
  for (const QString& standing : {QString("max"), delta}) {
    EXPECT_TRUE(likeVariant(standing, "normal")) << standing.toStdString();
    EXPECT_FALSE(likeVariant(standing, "italic")) << standing.toStdString();
  }
}

TEST(Formula, WhatIsNoMathmlIsSetAsText) {
  EXPECT_GT(layoutMathml("R = 2").width, 1.0);
  EXPECT_GT(layoutMathml("<math><mi>x</math>").width, 1.0);
  EXPECT_GT(math("<unknown><mi>x</mi></unknown>").width, 0.3);
  EXPECT_FALSE(formulaPicture("", 18.0, Qt::black, 1.0).isNull());
}

TEST(Formula, APictureHasItsColourAndSize) {
  const QString formula = "<math><mi>H</mi><mo>=</mo><mi>P</mi></math>";
  const QColor color(0xff, 0xb3, 0x1a);
  const QImage one = formulaPicture(formula, 18.0, color, 1.0), two = formulaPicture(formula, 18.0, color, 2.0);
  EXPECT_NEAR(two.width(), 2.0 * one.width(), 6.0);
  EXPECT_EQ(two.devicePixelRatio(), 2.0);
  int full = 0;
  for (int y = 0; y < two.height(); ++y) {
    for (int x = 0; x < two.width(); ++x) {
      if (two.pixelColor(x, y) == color) ++full;
    }
  }
  EXPECT_GT(full, 100);
  for (int x = 0; x < two.width(); ++x) {
    ASSERT_EQ(qAlpha(two.pixel(x, 0)), 0) << "cut at the top";
    ASSERT_EQ(qAlpha(two.pixel(x, two.height() - 1)), 0) << "cut at the bottom";
  }
}

}  // namespace
}  // namespace boxprobe

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QGuiApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
