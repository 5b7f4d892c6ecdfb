// What each edit of a small room has made again: faces, levels, rays, draws, and the memory of the maps, against
// work_values.txt.
#include <gtest/gtest.h>

#include <functional>

#include "tests/image/quad_world.h"
#include "tests/support/kept_values.h"

namespace boxprobe::test {
namespace {

struct WorkEdit {
  const char* what;
  std::function<void(Scene&)> make;
};

/// A room whose walls glow, a mirror, and things in it; three probes that overlap, no two numbers alike.
Model roomModel() {
  Model model;
  addBox(model, "wall", {-2.3f, -1.1f, -1.9f}, {2.7f, 1.4f, 2.2f}, false, glowing({0.4f, 0.3f, 0.2f}));
  addBox(model, "thing", {-0.6f, -1.1f, -0.5f}, {-0.2f, -0.3f, 0.1f}, true, glowing({0.1f, 0.5f, 0.9f}));
  addSquare(model, "plate", {0.9f, -0.7f, 0.3f}, {0.5f, 0.0f, 0.1f}, {0.0f, 0.3f, -0.4f}, mirror());
  addSquare(model, "shield", {1.4f, 0.2f, -0.9f}, {0.3f, 0.1f, 0.0f}, {0.0f, 0.4f, 0.2f}, mirror());
  return model;
}

Scene roomScene() {
  Scene scene;
  scene.sky = SkyColor{{0.2f, 0.1f, 0.05f}};
  scene.lamps = LampForm::InMap;
  Camera camera;
  camera.position = {-1.7, 0.6, 1.5};
  camera.target = {0.9, -0.6, 0.1};
  camera.verticalFovDegrees = 61.0;
  scene.cameras = {camera};
  scene.probes = {cubeProbe("a", {-0.9, 0.2, 0.3}, 1.3, 16), cubeProbe("b", {1.1, 0.1, 0.2}, 1.7, 16),
                  cubeProbe("c", {0.3, 0.3, -0.4}, 0.8, 16)};
  scene.probes[0].blendDistance = {glm::dvec3(0.2), glm::dvec3(0.3)};
  scene.probes[2].importance = 2.0;
  scene.objects["thing3"].dynamic = true;
  return scene;
}

/// Each on what the one before left, until the room is as at first again.
std::vector<WorkEdit> steps(const Scene& first) {
  return {
      {"a wall's glow", [](Scene& s) { s.materials["wall0"].emissive = glm::vec3(0.9f, 0.1f, 0.3f); }},
      {"a roughness", [](Scene& s) { s.materials["plate"].roughness = 0.3f; }},
      {"a thing moved",
       [](Scene& s) {
         s.objects["thing1"].translation = {0.11, 0.0, -0.07};
       }},
      {"what moves moved",
       [](Scene& s) {
         s.objects["thing3"].translation = {-0.21, 0.0, 0.17};
       }},
      {"hidden from probes", [](Scene& s) { s.objects["thing5"].seenByProbes = false; }},
      {"hidden", [](Scene& s) { s.objects["shield"].visible = false; }},
      {"a box", [](Scene& s) { s.probes[0].box.max.x -= 0.31; }},
      {"an influence",
       [](Scene& s) {
         s.probes[1].influence = Box{{-0.3, -1.0, -1.2}, {2.9, 1.4, 1.9}};
       }},
      {"blend distances", [](Scene& s) { s.probes[0].blendDistance.max.y += 0.2; }},
      {"an origin", [](Scene& s) { s.probes[0].origin.z += 0.21; }},
      {"finer faces", [](Scene& s) { s.probes[1].faceSize = 32; }},
      {"two bounces", [](Scene& s) { s.probes[2].bounces = 2; }},
      {"one bounce", [](Scene& s) { s.probes[2].bounces = 1; }},
      {"more samples", [](Scene& s) { s.probes[0].samplesPerPixel = 4; }},
      {"clear", [](Scene& s) { s.probes[2].clear = glm::vec3(0.1f, 0.2f, 0.3f); }},
      {"sky", [](Scene& s) { s.sky = SkyColor{glm::vec3(0.3f, 0.4f, 0.9f)}; }},
      {"no light from around", [](Scene& s) { s.objects["wall2"].probeUsage = ProbeUsage::Off; }},
      {"a name", [](Scene& s) { s.probes[1].name = "renamed"; }},
      {"one fewer", [](Scene& s) { s.probes.erase(s.probes.begin()); }},
      {"one more", [&first](Scene& s) { s.probes.insert(s.probes.begin() + 1, first.probes[0]); }},
      {"camera", [](Scene& s) { s.cameras[0].position.y += 0.2; }},
      {"everything as at first", [&first](Scene& s) { s = first; }},
  };
}

TEST(WorkValues, OfEachEdit) {
  const Scene first = roomScene();
  QuadWorld world(first, {roomModel()}, 48, 27);
  SceneRenderer& renderer = *world.renderer;
  const Scene whole = world.scene;  // with the model's entry
  std::vector<std::string> lines;
  Counters before;
  const auto write = [&](const std::string& what) {
    renderer.applyCamera(world.scene.cameras.front());
    lines.push_back(what + ": left" + keptNumbers(renderer.workPending(), renderer.workProgress()));
    renderer.finishWork();
    renderer.renderDisplay();
    const Counters& c = renderer.counters();
    lines.push_back("  made" +
                    keptNumbers(c.facesCaptured - before.facesCaptured, c.coarseFaces - before.coarseFaces,
                                c.facesReused - before.facesReused, c.skyFacesCaptured - before.skyFacesCaptured,
                                c.levelsFiltered - before.levelsFiltered, c.levelsSkipped - before.levelsSkipped,
                                c.levelsMadeLater - before.levelsMadeLater) +
                    " drawn into them" +
                    keptNumbers(c.objectsCaptured - before.objectsCaptured, c.objectsCulled - before.objectsCulled,
                                c.objectsUnlit - before.objectsUnlit, c.texelsClamped - before.texelsClamped));
    lines.push_back("  draws" + keptNumbers(c.drawsByProbeCount[0], c.drawsByProbeCount[1], c.drawsByProbeCount[2],
                                            c.drawsByProbeCount[3], c.drawsByProbeCount[4], c.drawsWithOpenSky,
                                            c.drawsWithCoverage, c.glassDraws, c.glassPasses));
    before = c;
    const FrameReport report = renderer.frameReport();
    std::string maps = "  maps" + keptNumbers(report.bytes, renderer.probeMemoryBytes());
    for (const FrameReport::ProbeUse& use : report.probes) {
      maps += " " + use.name + keptNumbers(use.objects, use.drawn, use.bytes, use.levels, use.notFiltered);
    }
    lines.push_back(maps);
    std::string objects = "  objects";
    for (const FrameReport::Object& object : report.objects) {
      objects += " " + object.node + keptNumbers(object.drawn, object.weights, object.leftOut, object.sky);
      for (const FrameReport::Share& share : object.probes) objects += " " + share.probe + keptNumbers(share.weight);
    }
    lines.push_back(objects);
  };
  renderer.sync(world.scene, Changes::all());
  write("at first");
  for (const WorkEdit& step : steps(whole)) {
    world.edit(step.make);
    write(step.what);
  }
  // A drag: the first step, and what is made when it ends.
  renderer.setInteractive(true);
  for (const double by : {0.1, 0.2}) {
    world.edit([&whole, by](Scene& s) { s.probes[0].origin.x = whole.probes[0].origin.x + by; });
    write("dragged by " + keptNumber(by));
  }
  renderer.setInteractive(false);
  write("let go");
  renderer.requestBake({"b"});
  write("asked for");
  EXPECT_EQ(renderer.error(), "");
  test::expectKeptValues("image/values/work_values.txt", lines);
}

}  // namespace
}  // namespace boxprobe::test
