// Formulas: where the parts of a fraction, a root, scripts and limits stand, and that nothing is lost. The last test
// compares sizes and outlines with formulas.txt.
#include <gtest/gtest.h>

#include <QFont>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <cmath>

#include "app/gui/formula/formula_picture.h"
#include "app/gui/formula/mathml_layout.h"
#include "tests/support/kept_values.h"

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

TEST(Formula, AQuadIsAnEmOfRoom) {
  const double letters = math("<mi>a</mi>").width + math("<mi>b</mi>").width;
  EXPECT_NEAR(math("<mi>a</mi><mo>\u2003</mo><mi>b</mi>").width, letters + 1.0, 0.03);
  EXPECT_NEAR(math("<mn>1</mn><mo>,</mo><mo>\u2003</mo><mo>-</mo><mn>2</mn>").width,
              math("<mn>1</mn><mo>,</mo><mo>-</mo><mn>2</mn>").width + 1.0, 1e-6);
  EXPECT_NEAR(math("<mtext> two \n words </mtext>").width, math("<mtext>two words</mtext>").width, 1e-9);
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

/// A box of one rectangle, which no font has a say in.
MathBox block(double width, double ascent, double descent, double slant) {
  MathBox box;
  box.path.addRect(0.03, -ascent, width - 0.05, ascent + descent);
  box.width = width;
  box.ascent = ascent;
  box.descent = descent;
  box.slant = slant;
  return box;
}

/// Sizes, the outline's bounds, and means over its points that no two ways to place its parts have alike.
std::string numbersOf(const MathBox& box) {
  const QRectF ink = box.path.boundingRect();
  const int count = box.path.elementCount();
  double x = 0.0, y = 0.0, product = 0.0, late = 0.0;
  for (int i = 0; i < count; ++i) {
    const QPainterPath::Element at = box.path.elementAt(i);
    x += at.x / count;
    y += at.y / count;
    product += at.x * at.y / count;
    late += (at.x - 2.0 * at.y) * i / (0.5 * count * count);
  }
  std::string text = std::to_string(count) + (box.path.fillRule() == Qt::WindingFill ? " winding" : " odd-even");
  for (const double number : {box.width, box.ascent, box.descent, box.slant, ink.left(), ink.top(), ink.right(),
                              ink.bottom(), x, y, product, late}) {
    text += " " + QString::number(number, 'f', 5).toStdString();
  }
  return text;
}

/// Letters of other fonts have other widths.
std::string fontsNow() {
  std::string text;
  for (const bool slanting : {false, true}) {
    QFont font("DejaVu Serif");
    font.setPixelSize(200);
    font.setItalic(slanting);
    for (const bool heavy : {false, true}) {
      font.setBold(heavy);
      text += " " + std::to_string(std::lround(QFontMetricsF(font).horizontalAdvance("Mxg\u03b8\u2211")));
    }
  }
  return text.substr(1) + " " + qVersion();  // another Debian slants letters otherwise
}

std::vector<std::string> linesOfBlocks() {
  const MathBox small = block(0.41, 0.53, 0.07, 0.02), wide = block(1.37, 0.31, 0.23, 0.11),
                tall = block(0.79, 1.13, 0.47, 0.05);
  std::vector<std::string> lines;
  const auto keep = [&lines](const char* name, const MathBox& box) {
    lines.push_back("block " + std::string(name) + ": " + numbersOf(box));
  };
  MathBox row = small;
  appendBox(row, wide, 0.17);
  appendBox(row, mathSpace(0.6));
  appendBox(row, tall, 0.29);
  keep("row", row);
  keep("fraction small", mathFraction(small, wide, 0.9));
  keep("fraction tall", mathFraction(tall, small, 1.0));
  keep("root", mathRoot(wide, std::nullopt, 1.0));
  keep("root tall", mathRoot(tall, std::nullopt, 0.7));
  keep("root degree", mathRoot(tall, small, 1.0));
  keep("root degree wide", mathRoot(small, wide, 0.8));
  for (const MathBox* base : {&small, &wide, &tall}) {
    const char* name = base == &small ? "small" : base == &wide ? "wide" : "tall";
    const std::string of = std::string(" of ") + name;
    keep(("above" + of).c_str(), mathScripts(*base, std::nullopt, small, 1.0));
    keep(("below" + of).c_str(), mathScripts(*base, wide, std::nullopt, 0.8));
    keep(("both" + of).c_str(), mathScripts(*base, small, wide, 1.0));
    keep(("both tall" + of).c_str(), mathScripts(*base, tall, tall, 1.0));
    for (const bool accent : {false, true}) {
      const std::string kind = accent ? "accent" : "limit";
      keep((kind + " above" + of).c_str(), mathLimits(*base, std::nullopt, wide, 1.0, accent));
      keep((kind + " below" + of).c_str(), mathLimits(*base, small, std::nullopt, 0.9, accent));
      keep((kind + " both" + of).c_str(), mathLimits(*base, tall, small, 1.0, accent));
    }
  }
  keep("table", mathTable({{small, wide}, {tall}, {wide, small, small}}, 0.9));
  keep("table of none", mathTable({}, 1.0));
  return lines;
}

/// Every element, operator and way to space it. A blank in them is not looked at.
const char* const kFormulas[] = {
    "<mi>x</mi>",
    "<mi>max</mi>",
    "<mi>\u0394</mi><mi>\u03b8</mi>",
    "<mi mathvariant='bold'>v</mi><mi mathvariant='bold-italic'>w</mi><mi mathvariant='normal'>u</mi>",
    "<mn>12</mn><mtext>of it</mtext><ms>s</ms>",
    "<mn mathvariant='bold'>7</mn><mo mathvariant='bold'>+</mo>",
    "<mi>a</mi><mo>+</mo><mi>b</mi><mo>-</mo><mi>c</mi><mo>=</mo><mi>d</mi>",
    "<mi>a</mi><mo>\u00b7</mo><mi>b</mi><mo>\u00d7</mo><mi>c</mi><mo>/</mo><mi>d</mi>",
    "<mi>a</mi><mo>&lt;=</mo><mi>b</mi><mo>&gt;=</mo><mi>c</mi><mo>\u2208</mo><mi>d</mi>",
    "<mi>a</mi><mo>,</mo><mi>b</mi><mo>;</mo><mi>c</mi><mo>:</mo><mi>d</mi>",
    "<mi>f</mi><mo>\u2061</mo><mi>x</mi><mi>y</mi><mo>\u2032</mo><mi>z</mi>",
    "<mi>sin</mi><mi>x</mi><mi>cos</mi><mo>(</mo><mi>y</mi><mo>)</mo>",
    "<mn>2</mn><mi>log</mi><mi>x</mi>",
    "<mi>a</mi><mo>mod</mo><mi>b</mi>",
    "<mi>a</mi><mo>,</mo><mo>\u2003</mo><mi>b</mi><mo>\u2003</mo><mo>-</mo><mi>c</mi>",
    "<mo>-</mo><mi>b</mi>",
    "<mo>(</mo><mo>-</mo><mi>b</mi><mo>)</mo><mo>-</mo><mi>c</mi>",
    "<mo>\u2211</mo><mi>x</mi><mo>\u222b</mo><mi>y</mi>",
    "<munderover><mo>\u2211</mo><mrow><mi>i</mi><mo>=</mo><mn>0</mn></mrow><mi>n</mi></munderover><mi>x</mi>",
    "<munder><mo>min</mo><mi>i</mi></munder><mi>t</mi>",
    "<mover><mi>x</mi><mo>^</mo></mover><mover><mi>AB</mi><mo>\u00af</mo></mover><mover><mi>i</mi><mo>\u00af</mo></"
    "mover>",
    "<mover><mi>v</mi><mo>\u2192</mo></mover><mover><mi>v</mi><mi>n</mi></mover>",
    "<mover><mi>x</mi></mover>",
    "<msup><mi>x</mi><mn>2</mn></msup><msub><mi>y</mi><mi>i</mi></msub><msubsup><mi>z</mi><mi>i</mi><mn>2</mn></"
    "msubsup>",
    "<msup><mi>e</mi><msup><mi>x</mi><msup><mn>2</mn><mn>3</mn></msup></msup></msup>",
    "<msup><mrow><mo>(</mo><mi>x</mi><mo>)</mo></mrow><mrow><mi>a</mi><mo>+</mo><mn>1</mn></mrow></msup>",
    "<mfrac><mi>a</mi><mrow><mi>b</mi><mo>+</mo><mn>1</mn></mrow></mfrac>",
    "<mfrac><mfrac><mi>a</mi><mi>b</mi></mfrac><mi>c</mi></mfrac>",
    "<msup><mi>x</mi><mfrac><mn>1</mn><mn>2</mn></mfrac></msup>",
    "<mfrac><mi>a</mi></mfrac>",
    "<msqrt><mi>x</mi><mo>+</mo><mn>1</mn></msqrt>",
    "<mroot><mfrac><mi>x</mi><mi>y</mi></mfrac><mn>3</mn></mroot>",
    "<mo>(</mo><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>)</mo><mo>[</mo><mi>c</mi><mo>]</mo>",
    "<mo>{</mo><mfrac><mi>a</mi><mi>b</mi></mfrac>",
    "<mo>|</mo><mi>a</mi><mo>|</mo><mo>+</mo><mo>\u2016</mo><msup><mi>b</mi><mn>2</mn></msup><mo>\u2016</mo>",
    "<mo>\u27e8</mo><mi>a</mi><mo>\u27e9</mo><mo>\u230a</mo><mi>b</mi><mo>\u230b</mo>",
    "<mi>b</mi><mo>)</mo><mi>x</mi>",
    "<mo>(</mo><mo>(</mo><mi>x</mi><mo>)</mo><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>)</mo>",
    "<mfenced><mi>a</mi><mi>b</mi><mi>c</mi></mfenced>",
    "<mfenced open='[' close='}' separators=';,'><mi>a</mi><mi>b</mi><mi>c</mi><mi>d</mi></mfenced>",
    "<mfenced separators=''><mi>a</mi><mi>b</mi></mfenced>",
    "<mi>a</mi><mspace width='0.7em'/><mo>=</mo><mi>b</mi><mspace/><mspace width='wide'/><mspace "
    "width='0.5'/><mn>1</mn>",
    "<mtable><mtr><mtd><mi>a</mi></mtd><mtd><mn>10</mn></mtd></mtr><mtr><mtd><mfrac><mi>b</mi><mi>c</mi></mfrac></"
    "mtd></mtr></mtable>",
    "<semantics><mi>x</mi><annotation>x</annotation></semantics>",
    "<mrow><mo>=</mo></mrow><mi>a</mi><msub><mo>=</mo><mn>1</mn></msub><mi>b</mi>",
    "<mi>a</mi><mo>\u221e</mo><mo>\u2026</mo><mo>!</mo><mo>+</mo><mi>b</mi>",
    "<unknown>text of it</unknown>",
};

TEST(Formula, PartsStandAsBefore) {
  test::expectKeptValues("gui/values/formula_blocks.txt", linesOfBlocks());
}

TEST(Formula, SizesAndOutlinesAreAsBefore) {
  const std::string file = "gui/values/formulas.txt";
  std::vector<std::string> lines = {"fonts: " + fontsNow()};
  for (const char* formula : kFormulas) {
    const std::string name = QString::fromUtf8(formula).remove(' ').toStdString();
    lines.push_back(name + ": " + numbersOf(math(formula)));
    // As a page has it: the frame, without the outlines.
    const QString svg = formulaSvg(QString("<math>%1</math>").arg(QString::fromUtf8(formula)));
    lines.push_back(name + " svg: " + svg.left(svg.indexOf("<path")).toStdString());
  }
  for (const double ascent : {0.1, 0.9, 2.1}) {
    lines.push_back("fence: " + numbersOf(mathFence("(", ascent, 0.4 * ascent, 0.9)));
  }
  lines.push_back("no-MathML: " + numbersOf(layoutMathml("R = 2")));
  lines.push_back("svg: " + formulaSvg("<math><mo>-</mo><msqrt><mi>l</mi></msqrt></math>").toStdString());
  if (test::writesKept(file, lines)) return;
  if (test::keptLines(file).at(0) != lines[0]) GTEST_SKIP() << "other fonts than the file was written with";
  test::expectKeptValues(file, lines);
}

}  // namespace
}  // namespace boxprobe

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QGuiApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
