// What the library says is said in the window's language: explanations of pixels with all that may stand in them, names
// of rays, remarks on frames. No English word is left in them.
#include <gtest/gtest.h>

#include <QTest>
#include <cstdlib>

#include "app/gui/explain/explain_card.h"
#include "app/gui/explain/ray_panel.h"
#include "app/gui/widgets/phrase_words.h"
#include "app/gui/widgets/window_language.h"
#include "filters/explain/schematic.h"
#include "filters/explain/verdict.h"
#include "filters/vtk/frame/frame_report.h"
#include "tests/gui/translated_texts.h"
#include "tests/unit/explained_room.h"

namespace boxprobe {
namespace {

/// Names that are words in none of the languages.
struct ForeignRoom : ExplainedRoom {
  ForeignRoom() {
    probe.name = "Kammer";
    surface.object = "Platte";
    surface.material = "Kachel";
  }
};

/// As many parts as a pixel may have, at once: no pixel has them all.
Explanation everything() {
  ForeignRoom room;
  room.probe.rotationDegrees.y = 25.0;
  room.surface.occlusion = 0.5f;
  room.surface.opacity = 0.5f;
  Explanation e = room.explain();
  e.lookupNormal = {0.1f, 0.9f, 0.0f};
  e.sheen = e.coat = glm::vec3(0.1f);
  e.skyWeight = 0.25f;
  ProbeExplanation& p = e.probes.at(0);
  p.weight = 0.75f;
  p.intensity = 2.0f;
  p.bevel = 0.2f;
  p.boxDistance = 2.0f;
  p.distanceLookups = 3;
  p.trueDistance = 2.5f;
  p.occlusion = p.coverage = 0.5f;
  p.slabFactors->z = 1e31f;
  p.slabFactors->y = 0.0f;
  while (p.lookups.size() < 20) p.lookups.push_back(p.lookups.front());
  p.lookups.front().roughness = 0.9f;
  p.diffuse.lamps = {{"Leuchte", {0.5f, 0.4f, 0.3f}, 0.0625f}};
  p.diffuse.nodes = {{{2, 0, 1}, {}, 0.75f, true}, {{3, 0, 1}, {}, 0.25f, false}};
  p.diffuse.nodeCount = {5, 4, 7};
  p.diffuse.cutWays = 2;
  GlassExplanation glass;
  glass.form = "two-interface";
  glass.mirrored = 1;
  glass.sources =
      commaList({Phrase::tr("probe \"%1\" %2 %").arg("Kammer").arg("80.0"), Phrase::tr("sky %1 %").arg("20.0")});
  e.glass = glass;
  MirrorExplanation mirror;
  mirror.coverage = 0.3f;
  mirror.share = 0.5f;
  e.mirror = mirror;
  LightShadow shadow;
  shadow.probes.push_back({"Kammer", 1.0f, {}, 2.0f, {}});
  shadow.moving = 0.5f;
  e.shadows = {shadow, {}};
  e.shadows[1].facesAway = true;
  return e;
}

/// Pixels that are unlike each other.
std::vector<Explanation> explanations() {
  std::vector<Explanation> all = {ForeignRoom().explain(), everything()};
  for (const char* technique : {"infinite", "sphere", "impostor", "box+footprint4", "box+raytraced"}) {
    ForeignRoom room;
    room.probe.technique = technique;
    all.push_back(room.explain());
  }
  ForeignRoom outside, beyond, noNormal, uncaptured;
  outside.probe.origin = {0.0, 5.0, 0.0};
  beyond.probe.influence = Box{{-9.0, -9.0, -9.0}, {9.0, 9.0, 9.0}};
  beyond.surface.positionWorld.x += 3.0;
  noNormal.surface.normalWorld = glm::vec3(0.0f);
  uncaptured.captured = false;
  for (const ForeignRoom& room : {outside, beyond, noNormal, uncaptured}) all.push_back(room.explain());
  ExplainInput unlit;
  unlit.surface = ForeignRoom().surface;
  unlit.lighting = ExplainInput::Lighting::Unlit;
  all.push_back(explainPixel(unlit));
  unlit.lighting = ExplainInput::Lighting::Probes;
  all.push_back(explainPixel(unlit));  // without a probe
  all.emplace_back();                  // the background
  return all;
}

/// Verdicts of all kinds: of `e` in scenes that differ, and of `e` changed.
std::vector<Verdict> verdicts() {
  ForeignRoom room;
  Scene scene, none, off, several;
  scene.probes = {room.probe};
  off = scene;
  off.objects["Platte"].probeUsage = ProbeUsage::Off;
  several.probes = {room.probe, room.probe};
  several.probes[1].name = "Nebenraum";
  std::vector<Verdict> all;
  const auto judge = [&](const Explanation& e, const Scene& in) { all.push_back(verdictOf(e, in)); };
  Explanation e = room.explain();
  e.specular = e.color = glm::vec3(0.5f);
  ProbeExplanation& p = e.probes.at(0);
  for (const float trueDistance : {2.1213f, 1.5f, 3.0f}) {
    p.trueDistance = trueDistance;
    judge(e, scene);
  }
  Explanation faceless = e;
  faceless.probes[0].face = -1;
  judge(faceless, scene);
  faceless.probes[0].hitDistance.reset();
  faceless.probes[0].lookupDirection = faceless.probes[0].reflectionProbe;
  judge(faceless, scene);
  p.coverage = 0.1f;
  judge(e, scene);
  p.coverage.reset();
  p.trueDistance.reset();
  judge(e, scene);
  p.captured = false;
  p.weight = 0.7f;
  judge(e, scene);
  for (glm::vec3 Explanation::*part : {&Explanation::direct, &Explanation::emissive, &Explanation::diffuse}) {
    Explanation scattered = e;
    scattered.specular = glm::vec3(0.0f);
    scattered.*part = glm::vec3(0.5f);
    judge(scattered, scene);
  }
  e.skyWeight = 0.7f;
  for (const Scene& in : {none, off, scene, several}) judge(e, in);
  e.surface.positionWorld = {2.1, 0.0, 3.2};
  for (const Scene& in : {scene, several}) judge(e, in);
  e.surface.positionWorld = {1.9, 0.5, 0.0};
  scene.probes[0].blendDistance.max.x = 0.5;
  judge(e, scene);
  e.probes.clear();
  e.dominant = -1;
  judge(e, scene);
  e.mirror = MirrorExplanation();
  e.mirror->coverage = 0.8f;
  judge(e, scene);
  e.glass = GlassExplanation();
  judge(e, scene);
  judge(Explanation(), scene);
  return all;
}

/// A frame with one, or two, of everything that may be left out of it.
FrameReport report(std::size_t count) {
  FrameReport report;
  for (std::size_t i = 0; i < count; ++i) {
    FrameReport::Object seen;
    seen.node = "Platte";
    seen.drawn = true;
    FrameReport::Object unlit = seen, single = seen, crowded = seen, hidden = seen;
    unlit.unlit = true;
    single.probes = {{"Kammer", 1.0}};
    single.sky = 0.0;
    crowded.leftOut = count;
    crowded.givenUp = commaList({Phrase::tr("the sky is not occluded"), Phrase::tr("moving objects throw no shadow")});
    hidden.drawn = false;
    for (const FrameReport::Object& object : {seen, unlit, single, crowded, hidden}) report.objects.push_back(object);
    report.probes.push_back({"Kammer", 0, 0, 0, 5, count == 1 ? 1u : 2u});
    report.probes.push_back({"Nebenraum", 1, 0, 100, 5, 0});
  }
  report.skyCulled = true;
  report.mirrors.push_back({"Platte", true, {}, 320, 200, count, count});
  report.mirrors.push_back({"Platte", false, Phrase::tr("it faces away"), 0, 0, 0, 0});
  return report;
}

class UntranslatedTest : public ::testing::TestWithParam<const char*> {
 protected:
  UntranslatedTest()
      : english_(GetParam(), {"box", "none", "infinite", "sphere", "impostor", "raytraced", "two", "interface"}) {}
  void SetUp() override { ASSERT_EQ(loadLanguage(GetParam()), GetParam()); }
  void TearDown() override { loadLanguage("en"); }

  void expectNoneIn(const QString& text, const std::string& where) const {
    const std::string words = english_.in(text);
    EXPECT_TRUE(words.empty()) << where << ": " << words;
  }
  void expectNoneIn(const Phrase& phrase) const {
    expectNoneIn(phraseWords(phrase), phrase.english());
    EXPECT_TRUE(phrase.empty() || phraseWords(phrase) != QString::fromStdString(phrase.english()))
        << phrase.english() << " is the same in English";
  }

  EnglishWords english_;
};

TEST_P(UntranslatedTest, TheExplainCard) {
  const ForeignRoom room;
  ExplainCard card([&](const std::string&) { return std::make_shared<const BakedMaps>(room.maps); });
  card.resize(420, 700);
  card.QWidget::show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&card, 60000));
  int count = 0;
  for (const Explanation& e : explanations()) {
    card.show(e, {}, 1.0);
    if (const char* out = std::getenv("BOXPROBE_TEST_OUTPUT")) {
      card.grab().save(QString(out) + QString("/card-%1-%2.png").arg(GetParam()).arg(++count));
    }
    for (const QString& text : shownTexts(card)) {
      for (const QString& line : text.split('\n')) expectNoneIn(line, "card");
    }
    for (const Phrase& note : e.notes) expectNoneIn(note);
    for (const ExplanationSection& section : explanationSections(e)) expectNoneIn(phraseWords(section.title), "title");
  }
}

TEST_P(UntranslatedTest, VerdictsAndTheirMends) {
  int mends = 0;
  for (const Verdict& verdict : verdicts()) {
    expectNoneIn(verdict.sentence);
    if (!verdict.mend) continue;
    ++mends;
    expectNoneIn(verdict.mend->words);
  }
  EXPECT_GE(mends, 4);
}

TEST_P(UntranslatedTest, PlanAndElevation) {
  for (const Explanation& e : explanations()) {
    const std::optional<Schematic> drawn = schematic(e);
    if (!drawn) continue;
    for (const SchematicView& view : {drawn->plan, drawn->elevation}) expectNoneIn(view.title);
    expectNoneIn(phraseWords(drawn->caption), "caption");
    const std::optional<SchematicView> inset = insetView(e, false);
    ASSERT_TRUE(inset);
    for (const SchematicView::Point& point : inset->points) expectNoneIn(phraseWords(point.label), "label");
  }
}

TEST_P(UntranslatedTest, KindsOfRays) {
  RayPanel panel;
  for (const QString& text : shownTexts(panel)) expectNoneIn(text, "ray panel");
}

TEST_P(UntranslatedTest, WhatAFrameLeavesOut) {
  for (const std::size_t count : {1u, 2u}) {
    const FrameReport frame = report(count);
    for (const auto& lines : {skippedLines(frame), leftOutLines(frame), mirrorLines(frame)}) {
      EXPECT_FALSE(lines.empty());
      for (const Phrase& line : lines) expectNoneIn(line);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, UntranslatedTest, ::testing::Values("de", "zh_CN"));

}  // namespace
}  // namespace boxprobe
