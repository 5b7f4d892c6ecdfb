// Which mirrors of `mirror-hall` have a picture, its texels, what moves in it and what may hide that, for each camera
// and many settings, against mirror_values.txt.
#include <gtest/gtest.h>

#include <functional>

#include "tests/support/kept_values.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

struct Setting {
  const char* what;
  std::function<void(Scene&)> make;
};

TEST(PlanarMirrorValues, OfEachCameraAndSetting) {
  Scene hall = ScenePicture::fromFile("scenes/mirror-hall.boxprobe.json", 8, 8).scene;
  hall.probes[0].bounces = 1;
  hall.probes[0].faceSize = 16;
  hall.probes[0].samplesPerPixel = 1;
  const auto moved = [](const char* node, const glm::dvec3& by) {
    return [node, by](Scene& s) { s.objects[node].translation = by; };
  };
  const std::vector<Setting> settings = {
      {"as it is", [](Scene&) {}},
      {"figure before the mirror", moved("figure", {1.2, 0, 2.4})},
      {"figure near the mirror", moved("figure", {-0.4, 0, -1.9})},
      {"figure behind the pillars", moved("figure", {5.85, 0, 2.69})},
      {"figure above", moved("figure", {0.3, 1.7, 0.2})},
      {"crate beside", moved("crate", {-2.6, 0, -0.2})},
      {"crate behind the mirror", moved("crate", {0, 0, -40})},
      {"ball far to the side", moved("golden ball", {4.0, 0.5, 3.0})},
      {"figure at rest", [](Scene& s) { s.objects["figure"].dynamic = false; }},
      {"crate hidden", [](Scene& s) { s.objects["crate"].visible = false; }},
      {"pillars hidden", [](Scene& s) { s.objects["pillars"].visible = false; }},
      {"all at rest but the ball", [](Scene& s) { s.objects["figure"].dynamic = s.objects["crate"].dynamic = false; }},
      {"finer", [](Scene& s) { s.mirrors["wall mirror"].resolution = 2.0; }},
      {"coarser", [](Scene& s) { s.mirrors["floor"].resolution = 0.4; }},
      {"a smaller budget", [](Scene& s) { s.mirrorBudget = 2600.0; }},
      {"the least budget", [](Scene& s) { s.mirrorBudget = 300.0; }},
      {"rougher", [](Scene& s) { s.materials["wall mirror"].roughness = 0.2f; }},
      {"as rough as allowed",
       [](Scene& s) {
         s.materials["floor"].roughness = 0.3f;
         s.mirrors["floor"].maxRoughness = 0.3;
       }},
      {"rougher than allowed",
       [](Scene& s) {
         s.materials["floor"].roughness = 0.31f;
         s.mirrors["floor"].maxRoughness = 0.3;
       }},
      {"off", [](Scene& s) { s.mirrors["wall mirror"].enabled = false; }},
      {"hidden", [](Scene& s) { s.objects["floor"].visible = false; }},
      {"without probes", [](Scene& s) { s.objects["wall mirror"].probeUsage = ProbeUsage::Off; }},
      {"no mirror", [](Scene& s) { s.mirrors.clear(); }},
  };
  ScenePicture picture(hall, 96, 54);
  picture.show(hall.cameras.front());
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    Scene scene = hall;
    settings[i].make(scene);
    picture.renderer->sync(scene, difference(picture.scene, scene));
    picture.scene = scene;
    picture.renderer->finishWork();
    for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
      if (i >= 4 && k != i % scene.cameras.size() && k != 0) continue;
      picture.renderer->applyCamera(scene.cameras[k]);
      picture.renderer->renderDisplay();
      const MirrorCounters& c = picture.renderer->counters().mirrors;
      const FrameReport report = picture.renderer->frameReport();
      lines.push_back(std::string(settings[i].what) + ", camera " + scene.cameras[k].name + ": counts" +
                      keptNumbers(c.drawn, c.disabled, c.rough, c.facingAway, c.notInView, c.nothingDynamic,
                                  c.overBudget, c.texels) +
                      " bytes" + keptNumbers(report.mirrorBytes));
      for (const FrameReport::MirrorUse& m : report.mirrors) {
        lines.push_back("  " + m.node + keptNumbers(m.drawn, m.width, m.height, m.objects, m.hiding) + " " +
                        m.why.english());
      }
    }
  }
  EXPECT_EQ(picture.renderer->error(), "");
  test::expectKeptValues("image/values/mirror_values.txt", lines);
}

}  // namespace
