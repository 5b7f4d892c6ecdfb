// What the program of an actor's probes depends on: the key, word by word, and each of the questions that decide it.
#include "filters/vtk/draw/probe_binding.h"

#include <gtest/gtest.h>

#include <functional>

namespace boxprobe {
namespace {

std::shared_ptr<DrawnProbe> probe(const char* technique, double importance) {
  auto made = std::make_shared<DrawnProbe>();
  made->geometry.technique = *parseTechnique(technique);
  made->geometry.importance = importance;
  return made;
}

/// Two of equal importance and one more; each may be edited.
struct Three {
  explicit Three(const char* first = "box", const char* second = "infinite", const char* third = "sphere") {
    parts = {probe(first, 4.0), probe(second, 4.0), probe(third, 2.5)};
    binding.lighting = Lighting::Probes;
    binding.probes = {parts[0], parts[1], parts[2]};
  }
  std::vector<std::shared_ptr<DrawnProbe>> parts;
  ProbeBinding binding;
};

TEST(ProbeBindings, HaveAKeyOfEachThingTheProgramDependsOn) {
  const Three plain;
  EXPECT_EQ(plain.binding.variantKey(), "2wsd 0:box+none/0 0:infinite+none/0 1:sphere+none/0");
  const std::vector<std::pair<std::function<void(Three&)>, std::string>> changes = {
      {[](Three& t) { t.binding.lighting = Lighting::Unlit; }, "1wsd 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.parts[1]->geometry.rotated = true; }, "2rwsd 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.parts[2]->geometry.mapTurned = true; }, "2rwsd 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.binding.weights = false; }, "2sd 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) {
         t.binding.shares = {0.5f, 0.3f, 0.1f};
       },
       "2csd 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.binding.onlyProbes = true; }, "2wpsd 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.binding.onlyProbes = true, t.binding.weights = false; },
       "2sd 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.binding.sky = false; }, "2wd 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.binding.openness = true; }, "2wSd 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.binding.diffuse = false; }, "2ws 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.binding.shapes = true; }, "2wsdl 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.binding.shapes = t.binding.lamps = true; },
       "2wsdL 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.binding.diffuse = false, t.binding.shapes = true; },
       "2ws 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.binding.lampLobes = true; }, "2wsdg 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.binding.firstBounce = true; }, "2wsdk 0:box+none/0 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.parts[1]->geometry.importance = 3.0; }, "2wsd 0:box+none/0 1:infinite+none/0 2:sphere+none/0"},
      {[](Three& t) { t.parts[0]->geometry.bevelled = true; }, "2wsd 0:box+none/0b 0:infinite+none/0 1:sphere+none/0"},
      {[](Three& t) { t.parts[1]->geometry.occluded = true; }, "2wsd 0:box+none/0 0:infinite+none/0o 1:sphere+none/0"},
      {[](Three& t) { t.parts[2]->open = true; }, "2wsd 0:box+none/0 0:infinite+none/0 1:sphere+none/0y"},
      {[](Three& t) {
         t.binding.shadowLights = {3, 5};
       },
       "2wsd 0:box+none/0 0:infinite+none/0 1:sphere+none/0 L3 L5"},
      {[](Three& t) { t.binding.movingLights = {4}; }, "2wsd 0:box+none/0 0:infinite+none/0 1:sphere+none/0 M4"},
      {[](Three& t) {
         t.binding.sunLights = {{6, 1}};
       },
       "2wsd 0:box+none/0 0:infinite+none/0 1:sphere+none/0 S6"},
      {[](Three& t) { t.binding.sightLights = {7}; }, "2wsd 0:box+none/0 0:infinite+none/0 1:sphere+none/0 v V7"},
      {[](Three& t) { t.binding.captureSights = true; }, "2wsd 0:box+none/0 0:infinite+none/0 1:sphere+none/0 v"},
      {[](Three& t) {
         t.binding.techniques = {*parseTechnique("infinite"), *parseTechnique("box"), *parseTechnique("box")};
       },
       "2wsd 0:infinite+none/0 0:box+none/0 1:box+none/0"},
      {[](Three& t) {
         t.binding.lampLobes = true;
         t.parts[1]->shapes = true;
         t.parts[1]->lamps = {2};
       },
       "2wsdg 0:box+none/0 0:infinite+none/0f 1:sphere+none/0"},
  };
  for (const auto& [change, key] : changes) {
    Three three;
    change(three);
    EXPECT_EQ(three.binding.variantKey(), key);
  }
  ProbeBinding none;
  none.captureSights = true;
  EXPECT_FALSE(none.sights()) << "no probe";
  EXPECT_EQ(ProbeBinding().variantKey(), "0wsd");
  // A march has a program of its own; its number of steps is rounded.
  Three marching("impostor", "box", "box");
  const std::string looked = marching.binding.variantKey();
  marching.parts[0]->geometry.parameters.steps = 3.0f;
  const std::string few = marching.binding.variantKey();
  marching.parts[0]->geometry.parameters.steps = 4.0f;
  EXPECT_NE(marching.binding.variantKey(), few);
  EXPECT_EQ(marching.binding.variantKey().find("0:impostor+none"), few.find("0:impostor+none"));
  EXPECT_TRUE(looked == few || looked == marching.binding.variantKey());
}

TEST(ProbeBindings, TellLampFreeMapsOfGgxAlone) {
  const auto lampFree = [](const std::function<void(Three&)>& change) {
    Three three;
    three.binding.lampLobes = true;
    three.parts[0]->shapes = true;
    three.parts[0]->lamps = {2};
    change(three);
    return three.binding.lampFree(0);
  };
  EXPECT_TRUE(lampFree([](Three&) {}));
  EXPECT_FALSE(lampFree([](Three& t) { t.binding.lampLobes = false; }));
  EXPECT_FALSE(lampFree([](Three& t) { t.parts[0]->shapes = false; }));
  EXPECT_FALSE(lampFree([](Three& t) { t.parts[0]->lamps.clear(); }));
  EXPECT_FALSE(lampFree([](Three& t) { t.parts[0]->open = true; }));
  EXPECT_FALSE(lampFree([](Three& t) { t.parts[0]->realtime = true; }));
  EXPECT_FALSE(lampFree([](Three& t) { t.parts[0]->prefilter.filter = FilterLobe::Kind::Gaussian; }));
  ProbeBinding lit;
  EXPECT_FALSE(lit.lampsDrawn());
  lit.shapes = lit.lamps = true;
  EXPECT_TRUE(lit.lampsDrawn());
  lit.diffuse = false;
  EXPECT_FALSE(lit.lampsDrawn());
  lit.lampLobes = true;
  EXPECT_TRUE(lit.lampsDrawn());
}

TEST(ProbeBindings, AnswerForAnyOfTheirProbes) {
  for (std::size_t which = 0; which < 3; ++which) {
    Three three("raytraced", "box", "impostor");
    EXPECT_FALSE(three.binding.rotated() || three.binding.bevelled() || three.binding.occluded() ||
                 three.binding.open());
    three.parts[which]->geometry.rotated = true;
    EXPECT_TRUE(three.binding.rotated());
    three.parts[which]->geometry.bevelled = true;
    EXPECT_TRUE(three.binding.bevelled());
    three.parts[which]->geometry.occluded = true;
    EXPECT_TRUE(three.binding.occluded());
    three.parts[which]->open = true;
    EXPECT_TRUE(three.binding.open());
    for (std::size_t slot = 0; slot < 3; ++slot) {
      EXPECT_EQ(three.binding.openByLookup(slot), slot == which && which == 0) << slot << which;
    }
  }
  EXPECT_TRUE(Three("box", "box", "impostor").binding.distances());
  EXPECT_FALSE(Three("box", "box", "sphere").binding.distances());
  EXPECT_EQ(Three().binding.groups(), (std::vector<int>{0, 0, 1}));
  EXPECT_TRUE(ProbeBinding().groups().empty());
  Three plain;
  EXPECT_FALSE(plain.binding.blueNoise());
  plain.binding.refinedValues.resize(3);
  EXPECT_TRUE(plain.binding.blueNoise());
  Three chosen("raytraced", "box", "box");
  EXPECT_TRUE(chosen.binding.blueNoise()) << "its own choice";
  chosen.binding.refinedValues.resize(3);
  EXPECT_FALSE(chosen.binding.chooses("sampling", "luminance"));
  chosen.binding.refinedValues[0].sampling = 1;
  EXPECT_TRUE(chosen.binding.chooses("sampling", "luminance"));
}

TEST(ProbeBindings, CountTheRaysOfWhatIsAveragedOrSmoothed) {
  Three three("raytraced", "raytraced", "box");
  EXPECT_EQ(three.binding.animatedSamples(), 0);
  EXPECT_EQ(three.binding.blurredSamples(), 0);
  three.parts[0]->geometry.parameters.samples = 6.0f;
  three.parts[1]->geometry.parameters.samples = 9.0f;
  three.parts[2]->geometry.parameters.samples = 40.0f;
  three.parts[0]->geometry.animated = three.parts[0]->geometry.blurred = true;
  EXPECT_EQ(three.binding.animatedSamples(), 6);
  EXPECT_EQ(three.binding.blurredSamples(), 6);
  three.parts[1]->geometry.animated = three.parts[1]->geometry.blurred = true;
  EXPECT_EQ(three.binding.animatedSamples(), 9);
  EXPECT_EQ(three.binding.blurredSamples(), 9);
  EXPECT_TRUE(three.binding.blurred(1));
  EXPECT_FALSE(three.binding.blurred(2));
  EXPECT_NE(three.binding.variantKey().find("0:box+raytraced~"), std::string::npos);
  // Drawn by another technique for the time being, or refined: neither.
  three.binding.techniques = {*parseTechnique("raytraced"), *parseTechnique("box"), *parseTechnique("box")};
  EXPECT_EQ(three.binding.animatedSamples(), 6);
  EXPECT_EQ(three.binding.blurredSamples(), 6);
  three.binding.refinedValues.resize(3);
  EXPECT_EQ(three.binding.animatedSamples(), 0);
  EXPECT_EQ(three.binding.blurredSamples(), 0);
}

TEST(ProbeBindings, AreRefinedByRaysOfTheWholeLobe) {
  Three three("box", "impostor+footprint4", "normal");
  three.parts[1]->geometry.parameters.steps = 3.0f;
  three.parts[0]->geometry.parameters.levelOffset = 1;
  const auto refined = three.binding.refined(8, 200);
  ASSERT_NE(refined, nullptr);
  ASSERT_EQ(refined->techniques.size(), 3u);
  EXPECT_EQ(techniqueId(refined->technique(0)), "box+raytraced");
  EXPECT_EQ(techniqueId(refined->technique(1)), "impostor+raytraced");
  EXPECT_EQ(techniqueId(refined->technique(2)), "normal+none") << "all its rays are one";
  for (const std::size_t slot : {0u, 1u}) {
    EXPECT_EQ(refined->values(slot).samples, 8.0f);
    EXPECT_EQ(refined->values(slot).total, 200.0f);
    EXPECT_EQ(refined->values(slot).pattern, 4);
    EXPECT_EQ(refined->values(slot).filtered, 1);
    EXPECT_EQ(refined->values(slot).levelOffset, 0);
    EXPECT_EQ(refined->values(slot).sampling, 0);
  }
  EXPECT_EQ(refined->values(1).steps, 24.0f);
  EXPECT_EQ(refined->values(0).steps, three.parts[0]->geometry.parameters.steps);
  EXPECT_TRUE(refined->marches(1));
  three.parts[1]->geometry.parameters.steps = 40.0f;
  EXPECT_EQ(three.binding.refined(8, 200)->values(1).steps, 40.0f);
  three.binding.roughnessMax = 0.0f;
  EXPECT_EQ(three.binding.refined(8, 200), nullptr) << "a mirror has one ray, and it is followed already";
  three.parts[1]->geometry.parameters.steps = 3.0f;
  EXPECT_NE(three.binding.refined(8, 200), nullptr) << "an impostor follows its ray";
  three.binding.firstBounce = true;
  EXPECT_EQ(three.binding.refined(8, 200), nullptr);
  three.binding.firstBounce = false;
  three.binding.lighting = Lighting::Unlit;
  EXPECT_EQ(three.binding.refined(8, 200), nullptr);
}

TEST(ProbeBindings, HaveCheapStandInsAndAFirstBounce) {
  EXPECT_EQ(Three().binding.standIn(), nullptr) << "nothing cheaper";
  const auto cheap = Three("raytraced", "box", "box").binding.standIn();
  ASSERT_NE(cheap, nullptr);
  EXPECT_NE(techniqueId(cheap->technique(0)), "box+raytraced");
  EXPECT_EQ(techniqueId(cheap->technique(1)), "box+none");

  Three three;
  three.binding.lampLobes = true;
  const auto first = three.binding.forFirstBounce();
  ASSERT_NE(first, nullptr);
  EXPECT_TRUE(first->firstBounce);
  EXPECT_FALSE(first->lampLobes);
  three.parts[1]->open = true;
  EXPECT_EQ(three.binding.forFirstBounce(), nullptr);
  three.parts[1]->open = false;
  three.binding.lighting = Lighting::Unlit;
  EXPECT_EQ(three.binding.forFirstBounce(), nullptr);
  ProbeBinding none;
  none.lighting = Lighting::Probes;
  EXPECT_EQ(none.forFirstBounce(), nullptr);
}

}  // namespace
}  // namespace boxprobe
