// Texts as patterns and values: in English as they are, in another language by its patterns.
#include <gtest/gtest.h>

#include "filters/core/base/phrase.h"

namespace boxprobe {
namespace {

std::string shouted(const char* pattern) {
  std::string text(pattern);
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

TEST(Phrase, PlacesAreFilledInOrderAndInOnePass) {
  EXPECT_EQ(Phrase().english(), "");
  EXPECT_TRUE(Phrase().empty());
  EXPECT_EQ(Phrase::tr("%1 of %2").arg("%2").arg("100 %1").english(), "%2 of 100 %1") << "values are not patterns";
  EXPECT_EQ(Phrase::tr("50 % of %1, 100 %").arg("all").english(), "50 % of all, 100 %");
  EXPECT_EQ(Phrase::tr("%1 and %2").arg("one").english(), "one and %2");
  EXPECT_EQ(Phrase::plain("%1").arg("one").english(), "%1") << "plain text has no places";
}

TEST(Phrase, EveryPartOfWordsIsTranslatedAndNoValueIs) {
  const Phrase phrase = Phrase::tr("the %1 face of %2").arg("+x").arg(Phrase::tr("box \"%1\"").arg("room"));
  EXPECT_EQ(phrase.english(), "the +x face of box \"room\"");
  EXPECT_EQ(phrase.in(shouted), "THE +x FACE OF BOX \"room\"");
  EXPECT_EQ(phrase.in([](const char*) { return std::string("%2: %1"); }), "%2: room: +x") << "places in any order";
}

TEST(Phrase, ListsAreJoinedByWhatTheLanguageHas) {
  const std::vector<Phrase> parts = {Phrase::plain("a"), Phrase::tr("b"), Phrase::plain("c")};
  EXPECT_EQ(commaList(parts).english(), "a, b, c");
  EXPECT_EQ(commaList(parts).in([](const char* text) { return std::string(text) == "b" ? "b" : "%1+%2"; }), "a+b+c");
  EXPECT_TRUE(commaList({}).empty());
  EXPECT_EQ(english(parts), (std::vector<std::string>{"a", "b", "c"}));
}

}  // namespace
}  // namespace boxprobe
