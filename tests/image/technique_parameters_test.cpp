// A technique's parameters on their way from the scene to the picture: what a new value costs, and what it does not.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "filters/math/technique/technique_table.h"
#include "tests/image/quad_world.h"

namespace boxprobe::test {
namespace {

// A rough floor under a glowing wall, in one probe's box.
QuadWorld roughFloor(const std::string& technique) {
  Model model;
  Material floor = mirror();
  floor.roughness = 0.4f;  // where no two level curves meet
  addSquare(model, "floor", {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, floor);
  addSquare(model, "lamp", {0, -0.7f, -1}, {0.3f, 0, 0}, {0, 0.3f, 0}, glowing({4, 2, 1}));
  Scene scene = darkScene();
  scene.lamps = LampForm::InMap;  // the techniques' lookups are to show it
  scene.probes = {cubeProbe("probe", glm::dvec3(0.0), 1.0, 64)};
  scene.probes[0].technique = technique;
  return QuadWorld(scene, {model});
}

glm::vec3 nearTheLamp(QuadWorld& world) {
  return world.look({0, 0, 2}, {0, -1, -0.6});
}

TEST(TechniqueParameters, ANumberIsAUniform) {
  for (const auto& [technique, name, value] :
       {std::tuple("approximate", "hardeningLength", 0.7), std::tuple("godot", "hardeningLength", 0.7),
        std::tuple("godot", "power", 0.5)}) {
    QuadWorld world = roughFloor(technique);
    world.show();
    const glm::vec3 before = nearTheLamp(world);
    const Counters counted = world.renderer->counters();
    world.editAndFinish([n = name, v = value](Scene& s) { s.probes[0].parameters[n] = v; });
    EXPECT_GT(glm::length(nearTheLamp(world) - before), 0.02f * glm::length(before)) << technique << " " << name;
    EXPECT_EQ(world.renderer->counters().programsCompiled, counted.programsCompiled) << technique << " " << name;
    EXPECT_EQ(world.faces(), counted.facesCaptured) << "what is looked up changes, not what was captured";
    EXPECT_EQ(world.levels(), counted.levelsFiltered);
    world.editAndFinish([](Scene& s) { s.probes[0].parameters.clear(); });
    EXPECT_LT(glm::length(nearTheLamp(world) - before), 1.0e-5f);
  }
}

TEST(TechniqueParameters, AChoiceIsCompiledInOnceAndKept) {
  QuadWorld world = roughFloor("box");
  world.show();
  const glm::vec3 own = nearTheLamp(world);
  const auto programs = [&world] { return world.renderer->counters().programsCompiled; };
  std::uint64_t compiled = programs();
  const auto choose = [&](std::string_view curve) {
    world.editAndFinish([curve](Scene& s) { s.probes[0].parameters["curve"] = std::string(curve); });
    return nearTheLamp(world);
  };
  for (const std::string_view curve : findParameter("curve")->choices) {
    if (curve == "own") continue;
    EXPECT_GT(glm::length(choose(curve) - own), 0.005f * glm::length(own)) << curve;
    EXPECT_GT(programs(), compiled) << curve;
    compiled = programs();
  }
  EXPECT_LT(glm::length(choose("own") - own), 1.0e-5f);
  EXPECT_EQ(programs(), compiled) << "a program made before is used again";
  EXPECT_EQ(world.faces(), 6u);
}

// Ways to the same mean: every pattern, either filter, rays of the lobe alone or towards the lamp, too.
TEST(TechniqueParameters, RaysAgreeHoweverTheyAreDrawn) {
  QuadWorld world = roughFloor("raytraced");
  world.scene.probes[0].parameters["samples"] = 256.0;
  world.show();
  const glm::vec3 plain = nearTheLamp(world);
  ASSERT_GT(plain.x, 0.05f);
  for (const auto& [name, value] : {std::pair<const char*, ParameterValue>("pattern", std::string("white")),
                                    {"pattern", std::string("r2")},
                                    {"pattern", std::string("deterministic")},
                                    {"levelOffset", true},
                                    {"filtered", true},
                                    {"sampling", std::string("luminance")}}) {
    world.editAndFinish([n = name, v = value](Scene& s) { s.probes[0].parameters[n] = v; });
    const glm::vec3 drawn = nearTheLamp(world);
    EXPECT_LT(glm::length(drawn - plain), 0.12f * glm::length(plain)) << name << " " << drawn.x << " " << plain.x;
    EXPECT_NE(drawn, plain) << name;
    world.editAndFinish([n = name](Scene& s) { s.probes[0].parameters.erase(n); });
  }
  EXPECT_EQ(world.renderer->error(), "");
}

TEST(TechniqueParameters, EachProbeOfADrawHasItsOwn) {
  QuadWorld world = roughFloor("godot");
  Probe second = world.scene.probes[0];
  second.name = "second";
  second.importance = 0.0;
  second.parameters = {{"hardeningLength", 0.7}};
  world.scene.probes[0].intensity = 0.0;  // takes its share, gives nothing
  world.scene.probes[0].blendDistance = {glm::dvec3(4.0), glm::dvec3(4.0)};
  world.scene.probes.push_back(second);
  world.show();
  const glm::vec3 before = nearTheLamp(world);
  ASSERT_GT(glm::length(before), 0.0f);
  world.editAndFinish([](Scene& s) { s.probes[0].parameters["hardeningLength"] = 0.1; });
  EXPECT_EQ(nearTheLamp(world), before) << "the first probe's, which gives nothing";
  world.editAndFinish([](Scene& s) { s.probes[1].parameters["hardeningLength"] = 6.0; });
  EXPECT_GT(glm::length(nearTheLamp(world) - before), 0.02f * glm::length(before));
}

// What `auto` draws with follows what the probe itself sees: here a lamp near a floor, there an even glow.
TEST(TechniqueParameters, AutomaticGoesByTheProbesOwnErrors) {
  QuadWorld world = roughFloor("auto");
  world.show();
  const auto measured = [&world] { return world.renderer->counters().errorsMeasured; };
  const auto chosen = [&world] {
    world.look({0, 0, 2}, {0, -1, -0.6});
    return world.renderer->explain(4, 4, 9, 9).probes.at(0).technique;
  };
  EXPECT_EQ(measured(), 1u);
  const std::string besideALamp = chosen();
  EXPECT_NE(besideALamp, "box+none");
  world.editAndFinish([](Scene& s) { s.probes[0].intensity = 0.5; });
  world.look({0, 0, 2}, {0, -1, -0.6});
  EXPECT_EQ(measured(), 1u) << "neither the box nor the picture is another one";
  world.renderer->setInteractive(true);
  for (int i = 1; i <= 4; ++i) world.editAndFinish([i](Scene& s) { s.probes[0].box.max.x = 1.0 + 0.05 * i; });
  EXPECT_EQ(measured(), 1u) << "not while a face is dragged";
  world.renderer->setInteractive(false);
  world.renderer->finishWork();
  EXPECT_EQ(measured(), 2u);
  world.editAndFinish([](Scene& s) { s.objects["lamp"].seenByProbes = false; });
  EXPECT_EQ(measured(), 3u);
  EXPECT_EQ(chosen(), "box+none") << "nothing to see: the cheapest is as good as any";
  world.editAndFinish([](Scene& s) { s.probes[0].technique = "box"; });
  world.editAndFinish([](Scene& s) { s.objects["lamp"].seenByProbes = true; });
  EXPECT_EQ(measured(), 3u) << "nobody asks";
}

}  // namespace
}  // namespace boxprobe::test
