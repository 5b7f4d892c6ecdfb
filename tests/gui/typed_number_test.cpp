// Numbers are read and shown in one way whatever the locale; sentences of the library lose their flags.
#include "app/gui/widgets/typed_number.h"

#include <gtest/gtest.h>

#include <QLocale>

#include "app/gui/widgets/window_words.h"

namespace boxprobe {
namespace {

const char* const kLocales[] = {"C", "en_US", "de_DE", "de_CH", "fr_FR", "ar_EG", "hi_IN", "fa_IR"};

class InEveryLocale : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { QLocale::setDefault(QLocale(GetParam())); }
  void TearDown() override { QLocale::setDefault(QLocale::c()); }
};

INSTANTIATE_TEST_SUITE_P(TypedNumber, InEveryLocale, ::testing::ValuesIn(kLocales));

TEST_P(InEveryLocale, OneSeparatorIsTheDecimalMark) {
  const std::pair<const char*, double> typed[] = {{"1.5", 1.5},
                                                  {"1,5", 1.5},
                                                  {" -0,25 ", -0.25},
                                                  {"\u2212"
                                                   "3",
                                                   -3.0},
                                                  {"+7.", 7.0},
                                                  {",5", 0.5},
                                                  {"12345.678", 12345.678},
                                                  {"\u0661\u066b\u0665", 1.5},
                                                  {"\u0967.\u096b", 1.5}};
  for (const auto& [text, value] : typed) {
    const TypedNumber number = typedNumber(QString::fromUtf8(text));
    ASSERT_TRUE(number.value) << text << ": " << number.why.toStdString();
    EXPECT_DOUBLE_EQ(*number.value, value) << text;
  }
}

TEST_P(InEveryLocale, WhatCouldMeanTwoNumbersIsRefusedWithALine) {
  for (const char* text : {"1,234.5", "1.234,5", "1.234.567", "1,234,567", "\u0661,234\u066b5"}) {
    const TypedNumber number = typedNumber(QString::fromUtf8(text));
    EXPECT_FALSE(number.value) << text;
    EXPECT_TRUE(number.why.contains("more than one separator")) << number.why.toStdString();
  }
  EXPECT_TRUE(typedNumber(QString::fromUtf8("1\u0662")).why.contains("digits of two scripts"));
  for (const char* text : {"", "-", ".", "-,"}) EXPECT_TRUE(typedNumber(text).unfinished) << text;
  for (const char* text : {"1e5", "nan", "1 000", "0x10", "1-2"}) {
    const TypedNumber number = typedNumber(text);
    EXPECT_FALSE(number.value || number.unfinished) << text;
    EXPECT_TRUE(number.why.contains("is not a number")) << text;
  }
}

TEST_P(InEveryLocale, ShownWithLatinDigitsAndAPoint) {
  EXPECT_EQ(shownNumber(-12345.6789, 3), "-12345.679");
  EXPECT_EQ(shownNumber(8.0, 3), "8.000");
}

TEST(WindowWords, NameMenusAndNoFlags) {
  EXPECT_EQ(windowWords("made.glb: 8000 m wide: is the unit mm? --set models.0.unit=mm"),
            "made.glb: 8000 m wide: is the unit mm? Choose it under Model > Unit and up axis");
  EXPECT_EQ(windowWords("stl files do not say which way is up: if it lies on its side, --set models.0.upAxis=z"),
            "stl files do not say which way is up: if it lies on its side, choose it under Model > Unit and up axis");
  EXPECT_EQ(windowWords("a.glb: 1 mm wide: is it meant to be larger? --set models.0.scale=1000"),
            "a.glb: 1 mm wide: is it meant to be larger?");
  EXPECT_EQ(windowWords("turn them over, or use --as interior"),
            "turn them over, or choose Model > Treat as > Interior");
  EXPECT_EQ(windowWords("a plain sentence - with dashes"), "a plain sentence - with dashes");
}

}  // namespace
}  // namespace boxprobe
