// Programs made for what a scene has against those that work out everything: the same pictures, hardly more programs,
// and a material edited while its facts are folded is shown at once.
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "filters/platform/process.h"
#include "filters/vtk/draw/constants.h"
#include "filters/vtk/draw/program_cache.h"
#include "filters/vtk/draw/surface_facts.h"
#include "filters/vtk/gl/cpu_time.h"
#include "tests/support/scene_names.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

struct Drawn {
  ImageRgba8 picture;
  std::uint64_t programs = 0, switches = 0;  ///< of surfaces, in that frame
};

/// What a window does between two events until all that can be folded is.
struct Rest {
  std::uint64_t compiled = 0;      ///< programs
  std::uint64_t mostAtOnce = 0;    ///< programs in one step, for which the window does not answer
  double longestMilliseconds = 0;  ///< CPU time of one step
};

Rest rest(SceneRenderer& renderer) {
  Rest done;
  const std::uint64_t& compiled = renderer.counters().programsCompiled;
  const std::uint64_t first = compiled;
  renderer.specializePrograms();
  while (renderer.workPending()) {
    const std::uint64_t before = compiled;
    double seconds = 0.0;
    {
      const CpuTimer timer(seconds);
      renderer.step();
    }
    done.mostAtOnce = std::max(done.mostAtOnce, compiled - before);
    done.longestMilliseconds = std::max(done.longestMilliseconds, 1e3 * seconds);
  }
  done.compiled = compiled - first;
  return done;
}

Drawn draw(ScenePicture& picture, bool generally) {
  picture.renderer->useGeneralPrograms(generally);
  if (!generally) {
    picture.renderer->specializePrograms();
    picture.renderer->finishWork();
  }
  Drawn drawn;
  drawn.picture = picture.display();
  drawn.programs = picture.renderer->counters().surfacePrograms;
  drawn.switches = picture.renderer->counters().programSwitches;
  return drawn;
}

/// Largest difference of a channel.
int worst(const ImageRgba8& a, const ImageRgba8& b) {
  EXPECT_EQ(a.pixels.size(), b.pixels.size());
  int most = 0;
  for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
    most = std::max(most, std::abs(int{a.pixels[i]} - int{b.pixels[i]}));
  }
  return most;
}

class Folded : public testing::TestWithParam<std::string> {};

TEST_P(Folded, SamePictureAndHardlyMorePrograms) {
  ScenePicture picture = ScenePicture::fromFile("scenes/" + GetParam() + ".boxprobe.json", 320, 180);
  // Small captures show a wrong calculation as well as large ones.
  for (Probe& probe : picture.scene.probes) {
    probe.faceSize = std::min(probe.faceSize, 64);
    probe.bounces = 1;
  }
  for (const Camera& camera : picture.scene.cameras) {
    picture.show(camera);
    const Rest rested = rest(*picture.renderer);
    const Drawn folded = draw(picture, false), general = draw(picture, true);
    ASSERT_EQ(picture.renderer->error(), "");
    const int off = worst(folded.picture, general.picture);
    std::printf(
        "  %-12s %-8s at most %d/255; programs %d, without folding %d; switches %d, %d; compiled %d, at most %d "
        "at once, the longest %.0f ms\n",
        GetParam().c_str(), camera.name.c_str(), off, static_cast<int>(folded.programs),
        static_cast<int>(general.programs), static_cast<int>(folded.switches), static_cast<int>(general.switches),
        static_cast<int>(rested.compiled), static_cast<int>(rested.mostAtOnce), rested.longestMilliseconds);
    EXPECT_LE(off, 1) << camera.name;
    EXPECT_EQ(picture.renderer->counters().constantsLeft, 0u) << "what rests is the same in every frame";
    EXPECT_LE(2 * folded.programs, 3 * general.programs) << camera.name;
    EXPECT_LE(2 * folded.switches, 3 * general.switches) << camera.name;
    EXPECT_LE(rested.mostAtOnce, 1u) << camera.name << ": the window waits for one program at a time";
    keepPicture(folded.picture, "folded_" + GetParam() + "_" + camera.name);
    keepPicture(general.picture, "general_" + GetParam() + "_" + camera.name);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Folded, testing::ValuesIn(sceneNames()), [](const auto& scene) {
  std::string name = scene.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// The way of a graphics card, on a driver that draws on the CPU: no flat pictures of maps.
TEST(RendererTuning, DrawsTheSameForCpuAndCard) {
  ImageRgba8 pictures[2];
  for (const bool card : {false, true}) {
    setEnvironment("BOXPROBE_RENDERER_TUNING", card ? "gpu" : "cpu", true);
    ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 96, 54);
    picture.scene.probes.front().faceSize = 64;
    picture.scene.probes.front().bounces = 1;
    picture.show(picture.scene.cameras.front());
    pictures[card ? 1 : 0] = draw(picture, false).picture;
    EXPECT_EQ(picture.renderer->counters().mapsFlattened > 0, !card);
    EXPECT_EQ(picture.renderer->error(), "");
  }
  ::unsetenv("BOXPROBE_RENDERER_TUNING");
  EXPECT_LE(worst(pictures[0], pictures[1]), 1);
}

// Each edit leaves or restores what the program was made for; at its end everything is as it was.
TEST(FoldedEdit, IsShownAtOnce) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 160, 90);
  picture.scene.probes.front().faceSize = 32;
  picture.scene.probes.front().bounces = 1;
  picture.show(picture.scene.cameras.front());
  const ImageRgba8 first = draw(picture, false).picture;
  const auto edited = [&](const MaterialOverride& change) {
    picture.scene.materials["floor"] = change;
    Changes changes;
    changes.materials = true;
    picture.renderer->sync(picture.scene, changes);
    const Drawn folded = draw(picture, false);
    const Drawn general = draw(picture, true);
    EXPECT_LE(worst(folded.picture, general.picture), 1);
    return folded.picture;
  };
  MaterialOverride rough, painted, shining;
  rough.roughness = 0.4f;
  painted.metallic = 0.0f;
  painted.roughness = 0.7f;
  shining.emissive = glm::vec3(0.2f, 0.1f, 0.0f);
  for (const MaterialOverride& change : {rough, painted, shining}) {
    EXPECT_GT(worst(edited(change), first), 8) << "an edit that does not show tests nothing";
  }
  const std::uint64_t programs = picture.renderer->counters().programsCompiled;
  // By uniforms: the probe was captured again after its numbers had been folded.
  EXPECT_LE(worst(edited(MaterialOverride{}), first), 1);
  EXPECT_EQ(worst(draw(picture, false).picture, first), 0) << "at rest again";
  EXPECT_EQ(picture.renderer->counters().programsCompiled, programs) << "the first program was kept";
}

// Each rest makes programs with its own numbers. Those of long ago are given back; what was drawn with them is drawn
// the same when it comes again, lamps included.
TEST(FoldedConstants, OfLongAgoAreGivenBack) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.scene.probes.front().faceSize = 16;
  picture.scene.probes.front().bounces = 1;
  Light lamp;
  lamp.position = {0.5, 2.0, 0.5};
  lamp.type = LightType::Point;
  picture.scene.lights.push_back(lamp);
  picture.show(picture.scene.cameras.front());
  const Counters& counters = picture.renderer->counters();
  const double widest = picture.scene.probes.front().box.max.x;
  const auto rest = [&](int edit) {
    picture.scene.probes.front().box.max.x = widest + 0.01 * edit;
    Changes changes;
    changes.probeShape = true;
    picture.renderer->sync(picture.scene, changes);
    picture.renderer->finishWork();
    return draw(picture, false).picture;
  };
  const ImageRgba8 first = rest(0);
  const std::uint64_t before = counters.programsCompiled;
  int edits = 1;
  for (; edits < 200 && counters.programsReleased < 20; ++edits) rest(edits);
  ASSERT_GE(counters.programsReleased, 20u) << "after " << edits << " edits nothing was given back";
  EXPECT_LE(counters.programsCompiled - before - counters.programsReleased,
            ProgramCache::kMost + counters.surfacePrograms);
  EXPECT_EQ(worst(rest(0), first), 0);
  EXPECT_EQ(picture.renderer->error(), "");
}

// An edit is drawn at once, by the programs that have numbers as uniforms; those with constants come with the next
// rest.
TEST(FoldedConstants, GiveWayToAnEdit) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 160, 90);
  picture.scene.probes.front().faceSize = 32;
  picture.scene.probes.front().bounces = 1;
  picture.show(picture.scene.cameras.front());
  const Drawn first = draw(picture, false);
  const Counters& counters = picture.renderer->counters();
  EXPECT_GT(counters.constantsFolded, 0u);
  EXPECT_EQ(counters.constantsLeft, 0u);

  const auto shows = [&](const Changes& changes) {
    const std::uint64_t left = counters.constantsLeft, programs = counters.programsCompiled;
    picture.renderer->sync(picture.scene, changes);
    const ImageRgba8 edited = picture.display();
    EXPECT_GT(counters.constantsLeft, left) << "not counted";
    EXPECT_EQ(counters.programsCompiled, programs) << "an edit that waits for a program";
    EXPECT_GT(worst(edited, first.picture), 8) << "an edit that does not show tests nothing";
    EXPECT_LE(worst(edited, draw(picture, true).picture), 1);
    EXPECT_LE(worst(edited, draw(picture, false).picture), 1) << "with the new numbers as constants";
  };
  Changes materials, shape;
  materials.materials = shape.probeShape = true;
  picture.scene.materials["floor"].baseColor = glm::vec4(0.9f, 0.2f, 0.1f, 1.0f);
  shows(materials);
  picture.scene.materials.clear();
  picture.scene.probes.front().box.max.x += 1.5;
  shows(shape);
}

// Not told of by anybody: the draw itself sees that a number is another one.
TEST(FoldedConstants, HoldOnlyForTheirNumbers) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 160, 90);
  picture.scene.probes.front().faceSize = 32;
  picture.show(picture.scene.cameras.front());
  draw(picture, false);
  vtkActorCollection* actors = picture.renderer->renderer()->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor()) actor->GetProperty()->SetEmissiveFactor(0.3, 0.2, 0.1);
  const ImageRgba8 edited = picture.display();
  EXPECT_GT(picture.renderer->counters().constantsLeft, 0u);
  picture.renderer->useGeneralPrograms(true);
  EXPECT_LE(worst(edited, picture.display()), 1);
}

// A driver, or a memory, that refuses a program with constants: what is on show stays.
TEST(FoldedConstants, AreDoneWithoutWhereTheyAreRefused) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 160, 90);
  picture.scene.probes.front().faceSize = 32;
  picture.show(picture.scene.cameras.front());
  const ImageRgba8 before = picture.display();
  setenv("BOXPROBE_BREAK_SHADER", "constants", 1);
  const ImageRgba8 after = draw(picture, false).picture;
  unsetenv("BOXPROBE_BREAK_SHADER");
  EXPECT_EQ(worst(before, after), 0);
  EXPECT_EQ(picture.renderer->counters().constantsFolded, 0u);
  EXPECT_EQ(picture.renderer->error(), "");
}

TEST(FoldConstants, TurnsDeclarationsIntoConstants) {
  Constants values;
  values.read("a", 0.1f);
  values.read("b", glm::vec3(1.0f, -2.5f, 1e30f));
  const float c[] = {1.0f, 2.0f, 3.0f, 4.0f};
  values.read("c", 2, c, 2);
  values.read("infinite", std::numeric_limits<float>::infinity());
  values.read("absent", 1.0f);
  std::string text =
      "uniform float ab;\nuniform float a; // first\nuniform vec3 b;\nuniform vec2 c[SLOTS];\nuniform float "
      "infinite;\n";
  EXPECT_EQ(writeConstants(text, values), 3);
  EXPECT_EQ(text,
            "uniform float ab;\nconst float a = 0.1f; // first\nconst vec3 b = vec3(1.0f, -2.5f, 1e+30f);\n"
            "const vec2[2] c = vec2[2](vec2(1.0f, 2.0f), vec2(3.0f, 4.0f));\nuniform float infinite;\n");
}

Constants numbers(float shared, float own) {
  Constants values;
  values.read("bpShared", shared);
  values.read("bpOwn", own);
  return values;
}

TEST(FoldConstants, AreSharedByValue) {
  std::vector<ConstantUse> uses;
  for (int i = 0; i < 5; ++i) uses.push_back({"a", numbers(1.0f, 2.0f)});
  for (int i = 0; i < 40; ++i) uses.push_back({"a", numbers(1.0f, static_cast<float>(3 + i))});
  auto plans = planConstants(uses, 0);
  for (const auto& plan : plans) {
    EXPECT_EQ(plan, plans.front()) << "no further program";
    EXPECT_NE(plan->find("bpShared"), nullptr);
    EXPECT_EQ(plan->find("bpOwn"), nullptr) << "many that differ keep it as a uniform";
  }
  plans = planConstants(uses, 1);
  EXPECT_NE(plans[0]->find("bpOwn"), nullptr) << "most objects gain here";
  EXPECT_EQ(plans[0], plans[4]);
  EXPECT_EQ(plans[5]->find("bpOwn"), nullptr);
  EXPECT_EQ(plans[5], plans.back());
  EXPECT_TRUE(planConstants({}, 3).empty());
}

// What all objects of a program share is free; dividing programs is not, and goes where it pays.
TEST(FoldableFacts, AreBoughtWithAtMostHalfAsManyProgramsAgain) {
  std::vector<FactUse> uses;
  for (int i = 0; i < 5; ++i) uses.push_back({"a", kNoMetal | kNoEmission});
  uses.push_back({"a", kAllMetal | kSmooth | kNoEmission});
  std::vector<SurfaceFacts> facts = planFacts(uses);
  for (const SurfaceFacts f : facts) EXPECT_EQ(f, kNoEmission) << "one program cannot be one and a half";

  uses.push_back({"b", kNoMetal});
  facts = planFacts(uses);
  EXPECT_EQ(facts[0], kNoMetal | kNoEmission);
  EXPECT_EQ(facts[5], kAllMetal | kSmooth | kNoEmission);
  EXPECT_EQ(facts[6], SurfaceFacts{kNoMetal});

  uses.push_back({"b", kSmooth});
  facts = planFacts(uses);
  EXPECT_EQ(facts[0], kNoMetal | kNoEmission) << "more objects gain here";
  EXPECT_EQ(facts[6], 0u);
  EXPECT_EQ(facts[7], 0u);
  EXPECT_TRUE(planFacts({}).empty());
}

}  // namespace
