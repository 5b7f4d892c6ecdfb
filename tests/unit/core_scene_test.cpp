// Scenes as values: names, what differs between two, remarks on what will not be seen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "filters/core/base/nearest_name.h"
#include "filters/core/base/number_text.h"
#include "filters/core/scene/document.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "tests/unit/two_probes.h"

namespace boxprobe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The kinds of change as a word list, so that a failure shows which one is missing or too many.
std::string kinds(const Changes& c) {
  std::string list;
  const auto add = [&list](bool on, const char* word) { list += on ? std::string(word) + " " : ""; };
  add(c.probeShape, "shape");
  add(c.probeTechnique, "technique");
  add(c.probeCapture, "capture");
  add(c.probeList, "list");
  add(c.materials, "materials");
  add(c.objects, "objects");
  add(c.lights, "lights");
  add(c.sky, "sky");
  add(c.models, "models");
  add(c.cameras, "cameras");
  add(c.exposure, "exposure");
  add(c.selection, "selection");
  add(c.file, "file");
  return list;
}

std::string kindsAfter(const std::function<void(Scene&)>& edit) {
  const Scene before = twoProbes();
  Scene after = before;
  edit(after);
  return kinds(difference(before, after));
}

TEST(Names, FindsProbesAndProposesFreeOnes) {
  Scene scene = twoProbes();
  EXPECT_EQ(findProbe(scene, "hall"), std::optional<std::size_t>(1));
  EXPECT_FALSE(findProbe(scene, "Hall"));
  EXPECT_EQ(unusedProbeName(scene, "attic"), "attic");
  EXPECT_EQ(unusedProbeName(scene, "room"), "room 2");
  scene.probes[1].name = "room 2";
  EXPECT_EQ(unusedProbeName(scene, "room"), "room 3");
  EXPECT_EQ(unusedProbeName(Scene(), ""), "probe");
}

TEST(Names, ManyNewOnesAreEachTheFirstThatIsFree) {
  Scene scene = twoProbes();
  scene.probes[1].name = "room 3";
  ProbeNames names(scene);
  EXPECT_EQ(names.take("room"), "room 2");
  EXPECT_EQ(names.take("room"), "room 4");
  EXPECT_EQ(names.take("attic"), "attic");
  EXPECT_EQ(names.take("room 4"), "room 4 2");
  EXPECT_EQ(names.take("attic"), "attic 2");
  EXPECT_EQ(names.take("room"), "room 5");
  for (int i = 6; i <= 20000; ++i) ASSERT_EQ(names.take("room"), "room " + std::to_string(i));
}

TEST(Names, NearestIsProposedAndWildGuessesAreNot) {
  const std::vector<std::string> names = {"roughness", "metallic", "ior"};
  EXPECT_EQ(nearestName("rougness", names), "roughness");
  EXPECT_EQ(nearestName("ROUGHNESS", names), "roughness");
  EXPECT_EQ(nearestName("metalilc", names), "metallic");
  EXPECT_EQ(nearestName("transmission", names), "");
  EXPECT_EQ(didYouMean("iro", names), "; did you mean \"ior\"?");
  EXPECT_EQ(nameList({"a", "b", "c"}, 2), "a, b and 1 more");
  EXPECT_EQ(nameList({}), "none");
}

TEST(Numbers, ShortestTextReadsBackEqual) {
  EXPECT_EQ(numberText(0.1f), "0.1");
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(-3.0), "-3");
  const double awkward = 0.1 + 0.2;
  EXPECT_EQ(std::stod(numberText(awkward)), awkward);
}

TEST(Difference, NamesTheKindOfEachProbeField) {
  EXPECT_EQ(kindsAfter([](Scene&) {}), "");
  for (const auto& edit : std::vector<std::function<void(Probe&)>>{
           [](Probe& p) { p.box.max.x = 5; }, [](Probe& p) { p.influence = p.box; },
           [](Probe& p) { p.blendDistance.min.z = 0; }, [](Probe& p) { p.intensity = 2; },
           [](Probe& p) { p.importance = 2; }, [](Probe& p) { p.bevel = Bevel(); },
           [](Probe& p) { p.occlusion = BoxOcclusion(); }, [](Probe& p) { p.lattice = ProbeLattice(); },
           [](Probe& p) { p.lattice = ProbeLattice{false}; }}) {
    EXPECT_EQ(kindsAfter([&](Scene& s) { edit(s.probes[1]); }), "shape ");
  }
  EXPECT_EQ(kindsAfter([](Scene& s) { s.probes[1].rotationDegrees.y = 5; }), "shape capture ");
  for (const auto& edit : std::vector<std::function<void(Probe&)>>{[](Probe& p) { p.technique = "sphere"; },
                                                                   [](Probe& p) { p.parameters["power"] = 3.0; },
                                                                   [](Probe& p) { p.projection = false; }}) {
    EXPECT_EQ(kindsAfter([&](Scene& s) { edit(s.probes[0]); }), "technique ");
  }
  for (const auto& edit : std::vector<std::function<void(Probe&)>>{
           [](Probe& p) { p.origin.x = 1; }, [](Probe& p) { p.nearDistance = 0.1; },
           [](Probe& p) { p.farDistance = 9; }, [](Probe& p) { p.clear = ClearToNone{}; },
           [](Probe& p) { p.clear = glm::vec3(1, 0, 0); }, [](Probe& p) { p.faceSize = 64; },
           [](Probe& p) { p.bounces = 2; }, [](Probe& p) { p.mode = ProbeMode::Realtime; },
           [](Probe& p) { p.image = "a.exr"; }, [](Probe& p) { p.filter = FilterKind::Gaussian; },
           [](Probe& p) { p.samplesPerPixel = 1; }, [](Probe& p) { p.imageLayout = CubeLayout::Strip; },
           [](Probe& p) { p.cubeView = CubeView::Inside; }, [](Probe& p) { p.imageRotationDegrees = 30; },
           [](Probe& p) { p.encoding = ImageEncoding::Rgbm; }, [](Probe& p) { p.decode = glm::dvec2(5, 1); },
           [](Probe& p) { p.hides = {"mirror"}; }}) {
    EXPECT_EQ(kindsAfter([&](Scene& s) { edit(s.probes[0]); }), "capture ");
  }
}

TEST(Difference, NamesTheListAndTheRestOfTheScene) {
  EXPECT_EQ(kindsAfter([](Scene& s) { s.probes.pop_back(); }), "list ");
  EXPECT_EQ(kindsAfter([](Scene& s) { s.probes[0].name = "cellar"; }), "list ");
  EXPECT_EQ(kindsAfter([](Scene& s) { std::swap(s.probes[0], s.probes[1]); }), "list ");
  EXPECT_EQ(kindsAfter([](Scene& s) {
              s.probes.erase(s.probes.begin());
              s.probes[0].origin.y = 7;  // the one that stays has moved, too
            }),
            "capture list ");
  EXPECT_EQ(kindsAfter([](Scene& s) { s.materials["floor"].roughness = 0.5f; }), "materials ");
  EXPECT_EQ(kindsAfter([](Scene& s) { s.objects["mirror"].visible = false; }), "objects ");
  EXPECT_EQ(kindsAfter([](Scene& s) { s.lights.emplace_back(); }), "lights ");
  EXPECT_EQ(kindsAfter([](Scene& s) { s.sky = SkyColor{}; }), "sky ");
  EXPECT_EQ(kindsAfter([](Scene& s) { s.models.push_back({"a.glb", {}, {}, 1.0}); }), "models ");
  EXPECT_EQ(kindsAfter([](Scene& s) { s.cameras.emplace_back(); }), "cameras ");
  EXPECT_EQ(kindsAfter([](Scene& s) { s.exposure = 2; }), "exposure ");
}

TEST(Difference, ChangesAddUp) {
  Changes sum;
  EXPECT_FALSE(sum.any());
  Changes sky, file;
  sky.sky = true;
  file.file = true;
  sum |= sky;
  sum |= file;
  EXPECT_EQ(kinds(sum), "sky file ");
  EXPECT_EQ(kinds(Changes::all()),
            "shape technique capture list materials objects lights sky models cameras exposure selection file ");
}

// What lights beyond those with code of their own go without.
TEST(Remarks, ManyLightsShineThroughEverything) {
  Scene scene = twoProbes();
  scene.lights.resize(32);
  EXPECT_THAT(featuresNotUsed(scene), IsEmpty());
  scene.lights.resize(33);
  EXPECT_THAT(featuresNotUsed(scene),
              ElementsAre(AllOf(HasSubstr("lights: are 33"), HasSubstr("31 can have shadows"))));
}

TEST(Remarks, PlainScenesHaveNone) {
  EXPECT_THAT(featuresNotUsed(twoProbes()), IsEmpty());
}

TEST(Remarks, EachFeatureThatIsNotUsedIsNamedWithItsKey) {
  Scene scene = twoProbes();
  scene.objects["car"].dynamic = true;  // is used, as is all else of objects and the probe's mode
  scene.objects["car"].probeUsage = ProbeUsage::Simple;
  scene.objects["car"].weights = WeightMode::Object;
  Probe& probe = scene.probes[0];
  probe.mode = ProbeMode::Realtime;
  probe.filter = FilterKind::Gaussian;
  probe.parameters["power"] = 4.0;
  probe.bevel = Bevel{0.1, 0.0};     // is used
  probe.occlusion = BoxOcclusion();  // is used
  probe.lattice = ProbeLattice{true, 0.05};
  probe.box.max.y = probe.box.min.y;
  probe.decode = glm::dvec2(5, 1);
  EXPECT_THAT(featuresNotUsed(scene),
              ElementsAre(HasSubstr("probes.room.box: is flat"),
                          HasSubstr("probes.room.decode: is not used by encoding linear"),
                          HasSubstr("probes.room.lattice.spacing: is 0.05: along an axis there are at most 16 nodes"),
                          HasSubstr("probes.room.parameters.power: is not used by technique box+none")));
}

TEST(Remarks, ALatticeIsOfLampsAsShapes) {
  Scene scene = twoProbes();
  for (Probe& probe : scene.probes) probe.lattice = ProbeLattice{true, 0.7};
  EXPECT_THAT(featuresNotUsed(scene), IsEmpty());
  scene.lamps = LampForm::InMap;
  scene.probes[0].lattice = ProbeLattice{false};
  EXPECT_THAT(featuresNotUsed(scene),
              ElementsAre(HasSubstr("probes.hall.lattice: is not used where lamps are in-map")));
}

TEST(Remarks, OverridesOfWhatTheModelsLackAreNamedWithTheNearest) {
  Model model;
  model.materials.resize(2);
  model.materials[0].name = "floor";
  model.materials[1].name = "wall";
  model.meshes.resize(1);
  model.instances.push_back({"mirror", 0, glm::dmat4(1.0)});
  Scene scene = twoProbes();
  scene.materials["floor"].roughness = 0.5f;
  scene.objects["mirror"].visible = false;
  EXPECT_THAT(unmatchedOverrides(scene, {&model}), IsEmpty());
  scene.materials["flor"].roughness = 0.5f;
  scene.objects["teapot"].visible = false;
  scene.probes[1].hides = {"mirror", "miror"};
  EXPECT_THAT(unmatchedOverrides(scene, {&model}),
              ElementsAre("materials.flor: no material of the models is called \"flor\"; did you mean \"floor\"?",
                          "objects.teapot: no node of the models is called \"teapot\"; they are mirror.",
                          "probes.hall.hides[1]: no node of the models is called \"miror\"; did you mean \"mirror\"?"));
}

TEST(Models, TrianglesAreCountedOverInstances) {
  Model model;
  model.meshes.resize(2);
  model.meshes[0].indices = {0, 1, 2, 2, 1, 0};
  model.meshes[1].indices = {0, 1, 2};
  model.instances = {{"a", 0, glm::dmat4(1.0)}, {"b", 0, glm::dmat4(1.0)}, {"c", 1, glm::dmat4(1.0)}};
  EXPECT_EQ(model.triangleCount(), 5u);
}

}  // namespace
}  // namespace boxprobe
