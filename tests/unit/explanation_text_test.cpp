// What is said of a pixel: the numbers of the calculation, in columns, and what is undefined where it is.
#include "filters/explain/explanation_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "filters/core/base/fixed_text.h"
#include "tests/unit/explained_room.h"

namespace boxprobe {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

std::string lineOf(const std::string& text, const std::string& symbol) {
  for (const std::string& line : lines(text)) {
    if (line.substr(std::min<std::size_t>(4, line.size())).rfind(symbol + " ", 0) == 0) return line;
  }
  return "no line of " + symbol;
}

TEST(FixedText, KeepsWhatCountsAndStaysReadable) {
  EXPECT_EQ(fixedText(1.23456), "1.2346");
  EXPECT_EQ(fixedText(-0.00001), "-1.00e-05");
  EXPECT_EQ(fixedText(-0.0), "0.0000");
  EXPECT_EQ(fixedText(3e9), "3.00e+09");
  EXPECT_EQ(fixedText(99.95, 1), "100.0");
  EXPECT_EQ(fixedText(std::nan("")), "undefined");
  EXPECT_EQ(fixedText(-INFINITY), "-infinite");
}

// From (0.5, 0, 0) upwards along (1, 1, 0)/sqrt 2 in a box to x = 2 and y = 3: x is met first, after 1.5 sqrt 2.
TEST(ExplanationText, ShowsTheSlabFactorsAndMarksTheSmallest) {
  const std::string text = explanationText(ExplainedRoom().explain());
  EXPECT_THAT(lineOf(text, "t_x"),
              ContainsRegex("^  > t_x +2\\.1213 .*\\(2\\.0000 - 0\\.5000\\) / 0\\.7071.*smallest"));
  EXPECT_THAT(lineOf(text, "t_y"), ContainsRegex("^    t_y +4\\.2426 "));
  EXPECT_THAT(lineOf(text, "t_z"), ContainsRegex("infinite.*never met"));
  EXPECT_THAT(lineOf(text, "d"), ContainsRegex("2\\.1213 .*scene units.*face \\+x"));
  EXPECT_THAT(lineOf(text, "H"), ContainsRegex("2\\.0000 +1\\.5000 +0\\.0000"));
  EXPECT_THAT(lineOf(text, "H - C"), ContainsRegex("2\\.0000 +0\\.5000 +0\\.0000"));
}

TEST(ExplanationText, NamesLampsAndNodesOfDiffuseLight) {
  Explanation e = ExplainedRoom().explain();
  e.diffuse = {0.3f, 0.2f, 0.1f};
  e.color = {0.5f, 0.4f, 0.3f};
  DiffuseExplanation& d = e.probes[0].diffuse;
  d.lamps = {{"ceiling lamp", {0.5f, 0.4f, 0.3f}, 0.0625f}};
  d.nodes = {{{2, 0, 1}, {0.1f, -0.9f, 0.7f}, 0.75f}, {{3, 0, 1}, {1.1f, -0.9f, 0.7f}, 0.25f}};
  d.nodeCount = {5, 4, 7};
  const std::string text = explanationText(e);
  // Half of the last digit: C libraries round it either way.
  EXPECT_THAT(lineOf(text, "E_lamp"), AllOf(ContainsRegex("0\\.5000 +0\\.4000 +0\\.3000 .*\"ceiling lamp\""),
                                            AnyOf(HasSubstr(" 6.2 %"), HasSubstr(" 6.3 %"))));
  EXPECT_THAT(lineOf(text, "E_lattice"), ContainsRegex("5 x 4 x 7 nodes: 2, 0, 1 by 75\\.0 %; 3, 0, 1 by 25\\.0 %"));
  EXPECT_THAT(lineOf(text, "diffuse"), HasSubstr("50.0 % of the pixel"));
}

TEST(ExplanationText, NumbersStandUnderEachOther) {
  const std::string text = explanationText(ExplainedRoom().explain());
  const auto column = [&](const std::string& symbol) { return lineOf(text, symbol).find("  scene units"); };
  EXPECT_NE(column("P"), std::string::npos);
  for (const char* symbol : {"P - C", "t_x", "t_y", "d", "H"}) EXPECT_EQ(column(symbol), column("P")) << text;
  for (const std::string& line : lines(text)) EXPECT_TRUE(line.empty() || line.back() != ' ') << "'" << line << "'";
}

TEST(ExplanationText, TheSumIsWhatItsPartsAddUpTo) {
  const Explanation e = ExplainedRoom().explain();
  const auto sections = explanationSections(e);
  const ExplanationSection& sum = sections.back();
  glm::dvec3 total(0.0);
  bool reached = false;
  for (const ExplanationRow& row : sum.rows) {
    ASSERT_EQ(row.numbers.size(), 3u);
    for (int i = 0; i < 3; ++i) {
      const double value = std::stod(row.numbers[static_cast<std::size_t>(i)]);
      if (row.sum) {
        EXPECT_NEAR(value, total[i], 3e-4);
      }
      total[i] += reached ? 0.0 : value;
    }
    reached = reached || row.sum;
  }
  EXPECT_TRUE(reached);
  EXPECT_THAT(lineOf(explanationText(e), "rendered"), HasSubstr("of the brightest texel"));
}

TEST(ExplanationText, SharesOfTexelsAddUpAndLongListsAreSummedUp) {
  ExplainedRoom room;
  room.surface.roughness = 0.4f;  // between two levels: up to eight texels
  const Explanation e = room.explain();
  const auto shares = [](const std::vector<ExplanationSection>& sections) {
    double sum = 0.0;
    for (const auto& section : sections) {
      for (const auto& row : section.rows)
        sum += row.detail && row.symbol.english().front() != '<' ? std::stod(row.symbol.english()) : 0.0;
    }
    return sum;
  };
  EXPECT_NEAR(shares(explanationSections(e)), 100.0, 0.5);
  ExplanationDetail detail;
  detail.texelsPerLookup = 2;
  detail.texelValue = [&](const ProbeExplanation&, const TexelShare& t) -> std::optional<glm::vec3> {
    return glm::vec3(room.maps.radiance.texel(t.level, t.face, t.column, t.row));
  };
  const auto sections = explanationSections(e, detail);
  EXPECT_NEAR(shares(sections), 100.0, 0.5);
  const std::string text = explanationText(e, detail);
  EXPECT_THAT(text, HasSubstr("more texels"));
  EXPECT_THAT(text, ContainsRegex("% +0\\.1000 +0\\.5000 +0\\.2500 +texel 1, 1 of face \\+X")) << text;
}

TEST(ExplanationText, ABackgroundPixelHasNothingButItsColor) {
  Explanation e;
  e.x = 3;
  e.y = 4;
  e.color = {0.1f, 0.2f, 0.3f};
  e.notes = {Phrase::plain("No surface: the pixel shows the sky.")};
  const std::string text = explanationText(e);
  EXPECT_THAT(text, HasSubstr("Pixel 3, 4: the background\n  ! No surface"));
  EXPECT_EQ(lines(text).size(), 3u) << text;
}

TEST(ExplanationText, SaysWhatIsUndefinedAndWhy) {
  ExplainedRoom noNormal;
  noNormal.surface.normalWorld = glm::vec3(0.0f);
  std::string text = explanationText(noNormal.explain());
  EXPECT_THAT(text, HasSubstr("! The surface has no normal here"));
  EXPECT_THAT(lineOf(text, "N"), HasSubstr("undefined"));
  EXPECT_THAT(lineOf(text, "R"), HasSubstr("no line"));

  ExplainedRoom infinite;
  infinite.probe.technique = "infinite";
  text = explanationText(infinite.explain());
  EXPECT_THAT(text, HasSubstr("has no box to hit"));
  EXPECT_THAT(lineOf(text, "t_x"), HasSubstr("no line"));
  EXPECT_THAT(lineOf(text, "L"), HasSubstr("nothing is hit"));

  ExplainedRoom outside;
  outside.probe.origin = {0.0, 5.0, 0.0};
  EXPECT_THAT(explanationText(outside.explain()), HasSubstr("capture origin lies outside the projection box"));

  ExplainedRoom beyond;
  beyond.probe.influence = Box{{-9.0, -9.0, -9.0}, {9.0, 9.0, 9.0}};
  beyond.surface.positionWorld.x += 3.0;
  beyond.surface.eyeWorld.x += 3.0;
  EXPECT_THAT(lineOf(explanationText(beyond.explain()), "t_x"), HasSubstr("P lies beyond that plane"));

  ExplainedRoom uncaptured;
  uncaptured.captured = false;
  EXPECT_THAT(lineOf(explanationText(uncaptured.explain()), "fetch"), HasSubstr("not captured yet"));
  uncaptured.probe.technique = "impostor";  // which looks for the distances of what is not there
  EXPECT_THAT(lineOf(explanationText(uncaptured.explain()), "fetch"), HasSubstr("not captured yet"));
}

TEST(ExplanationText, AProbeThatKnowsNoShadowsShadowsNoLight) {
  const ExplainedRoom room;
  ExplainInput input;
  input.surface = room.surface;
  input.probes.push_back({room.probe.name, 0, 0, probeGeometry(room.probe, room.probe.origin), &room.maps});
  Light light;
  light.position = {0.3, 2.1, -0.4};
  light.intensity = 17.0f;
  input.lights = {light};
  const glm::vec3 alone = explainPixel(input).direct;
  EXPECT_GT(alone.x, 0.01f);
  input.sightLights = {0};  // another probe's box has places that do not see it
  EXPECT_EQ(explainPixel(input).direct, alone);
}

TEST(ExplanationText, NamesOfFilesStayOnTheirLine) {
  ExplainedRoom room;
  room.surface.object = "two\nlines";
  EXPECT_THAT(explanationText(room.explain()), Not(HasSubstr("two\nlines")));
}

}  // namespace
}  // namespace boxprobe
