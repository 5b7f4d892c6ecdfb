// A thousand probes: what a frame shows is drawn and captured, and nothing else. Counts, never times.
#include <gtest/gtest.h>
#include <vtkOpenGLRenderer.h>

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>
#include <set>

#include "data/scenes/composer.h"
#include "data/scenes/glb_writer.h"
#include "data/scenes/mesh_builder.h"
#include "data/scenes/scenes.h"
#include "filters/fit/rays/triangle_sight.h"
#include "filters/io/gltf/model_file.h"
#include "filters/vtk/scene/vtkCulledRenderer.h"
#include "tests/bench/stock_renderer.h"
#include "tests/support/scene_picture.h"
#include "tests/unit/temporary_folder.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 320, kHeight = 180;

class ManyProbes : public TemporaryFolder {
 protected:
  Scene makeApartments(int rooms) {
    scenes::Apartments made = scenes::apartments(rooms, 1);
    const std::string name = "apartments-" + std::to_string(rooms) + ".glb";
    write(name, scenes::glbBytes(made.model));
    made.scene.models = {{file(name)}};
    for (Probe& probe : made.scene.probes) probe.faceSize = 32;
    return made.scene;
  }
};

std::uint64_t draws(const Counters& counters) {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : counters.drawsByProbeCount) sum += count;
  return sum;
}

int differentPixels(const ImageRgba8& a, const ImageRgba8& b, int tolerance) {
  int different = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a.pixels[i + c] - b.pixels[i + c]));
    different += largest > tolerance ? 1 : 0;
  }
  return different;
}

TEST_F(ManyProbes, TheSameViewCostsTheSameHoweverManyThereAre) {
  ImageRgba8 first;
  std::uint64_t faces = 0, drawn = 0, uploads = 0, sights = 0;
  for (const int rooms : {32, 128, 512}) {
    ScenePicture picture(makeApartments(rooms), kWidth, kHeight);
    EXPECT_EQ(picture.scene.probes.size(), static_cast<std::size_t>(rooms + rooms / 4));
    picture.renderer->setSightLines(traceSightLines);  // else lamps beyond the walls shine into a capture
    picture.show(cameraNamed(picture.scene, "main"));
    const ImageRgba8 image = picture.display();
    const Counters before = picture.renderer->counters();
    picture.display();
    const Counters& counters = picture.renderer->counters();
    std::printf("  %d rooms: %llu faces captured, %llu draws a frame, %llu probes' shadows traced\n", rooms,
                static_cast<unsigned long long>(counters.facesCaptured),
                static_cast<unsigned long long>(draws(counters)),
                static_cast<unsigned long long>(counters.sightsTraced));
    EXPECT_EQ(counters.facesCaptured, before.facesCaptured);
    if (first.pixels.empty()) {
      first = image;
      faces = counters.facesCaptured;
      drawn = draws(counters);
      sights = counters.sightsTraced;
      EXPECT_GE(sights, 2u);
      EXPECT_LE(sights, 6u);
      uploads = counters.uniformUpdates - before.uniformUpdates;
      EXPECT_GE(faces, 12u);
      EXPECT_LE(faces, 30u) << "of the room, its corridor and what is seen through doors";
      continue;
    }
    EXPECT_EQ(counters.facesCaptured, faces);
    EXPECT_EQ(draws(counters), drawn);
    EXPECT_EQ(counters.sightsTraced, sights);
    EXPECT_EQ(counters.uniformUpdates - before.uniformUpdates, uploads);
    // What lies in the view but is hidden moves the far plane, and with it the depth at which two surfaces meet.
    EXPECT_LE(differentPixels(image, first, 1), kWidth * kHeight / 1000);
  }
}

// Against the same picture with nothing left out, from inside, along a corridor and from far outside.
TEST_F(ManyProbes, WhatIsNotDrawnCouldNotBeSeen) {
  ScenePicture picture(makeApartments(64), kWidth, kHeight);
  picture.scene.lamps = LampForm::InMap;  // lattices of rooms that come later lie elsewhere, which rounds otherwise
  Camera outside;
  outside.position = {-30.0, 20.0, -25.0};
  outside.target = {20.0, 5.0, 10.0};
  Camera far = outside;
  far.position = {90.0, 3.0, 60.0};
  const std::vector<Camera> cameras = {cameraNamed(picture.scene, "main"), cameraNamed(picture.scene, "corridor"),
                                       outside, far};
  picture.show(cameras[0]);
  auto* renderer = vtkCulledRenderer::SafeDownCast(picture.renderer->renderer());
  std::vector<ImageRgba8> culled;
  for (const Camera& camera : cameras) {
    picture.renderer->applyCamera(camera);
    picture.renderer->finishWork();
    culled.push_back(picture.display());
    const std::size_t inView = renderer->InView().size(), drawn = renderer->GetDrawn().size();
    std::printf("  %zu of %zu in view drawn, %llu boxes asked for so far\n", drawn, inView,
                static_cast<unsigned long long>(renderer->GetBoxesAsked()));
    EXPECT_LT(drawn, inView);
    const auto asked = renderer->GetBoxesAsked();
    picture.display();
    EXPECT_EQ(renderer->GetBoxesAsked(), asked) << "nothing moved";
  }
  // Everything is captured by now that any of these views needs; from here on the renderer is told to draw all.
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    picture.renderer->applyCamera(cameras[i]);
    picture.renderer->finishWork();
    renderer->SetCulling(false);
    const ImageRgba8 whole = picture.display();
    renderer->SetCulling(true);
    keepPicture(culled[i], "culled_" + std::to_string(i));
    keepPicture(whole, "whole_" + std::to_string(i));
    EXPECT_EQ(differentPixels(whole, culled[i], 0), 0) << "camera " << i;
  }
}

// What such glass is looked through at is drawn by a pass of its own, with which the renderer culls nothing itself.
TEST_F(ManyProbes, AreThereBesideRoughGlass) {
  ScenePicture picture(makeApartments(32), kWidth, kHeight);
  MaterialOverride& sphere = picture.scene.materials["sphere"];
  sphere.metallic = 0.0f;
  sphere.transmission = 1.0f;
  sphere.roughness = 0.4f;
  picture.show(cameraNamed(picture.scene, "main"));
  const ImageRgba8 glass = picture.display();
  EXPECT_GT(picture.renderer->counters().glassDraws, 0u) << "no glass tests nothing";
  EXPECT_GE(picture.renderer->counters().facesCaptured, 12u);
  picture.scene.materials.clear();
  picture.show(cameraNamed(picture.scene, "main"));
  EXPECT_LT(differentPixels(glass, picture.display(), 32), kWidth * kHeight / 3) << "more than the sphere is gone";
}

TEST_F(ManyProbes, TurningRoundMakesWhatComesIntoView) {
  ScenePicture picture(makeApartments(32), kWidth, kHeight);
  picture.show(cameraNamed(picture.scene, "main"));
  picture.display();
  const auto faces = picture.renderer->counters().facesCaptured;
  Camera other;  // in a room of the module above
  other.position = {1.0, 4.7, 4.6};
  other.target = {2.2, 3.9, 1.0};
  picture.renderer->applyCamera(other);
  picture.display();
  EXPECT_TRUE(picture.renderer->workPending());
  picture.renderer->finishWork();
  const auto more = picture.renderer->counters().facesCaptured;
  EXPECT_GT(more, faces);
  EXPECT_LE(more, 2 * faces + 12);
  picture.renderer->applyCamera(cameraNamed(picture.scene, "main"));
  picture.display();
  EXPECT_FALSE(picture.renderer->workPending()) << "back again: all is there";
}

Scene roomWithFloorOnly() {
  Scene scene = ScenePicture::fromFile("scenes/room.boxprobe.json", 8, 8).scene;
  for (const Instance& instance : loadModelFile(scene.models[0].file).instances) {
    scene.objects[instance.node].visible = instance.node == "floor";
  }
  scene.probes[0].faceSize = 32;
  scene.probes[0].bounces = 1;  // faces are counted
  return scene;
}

TEST_F(ManyProbes, NothingThatReflectsCapturesNothing) {
  Scene scene = roomWithFloorOnly();
  for (auto& [name, object] : scene.objects)
    object.visible = name != "floor" && name != "lamp" && name.find("sphere") != 0;
  ScenePicture picture(scene, 64, 64);  // the walls are unlit
  picture.show(cameraNamed(scene, "main"));
  picture.display();
  EXPECT_EQ(picture.renderer->counters().facesCaptured, 0u);
  EXPECT_EQ(picture.renderer->counters().skyFacesCaptured, 0u);
  EXPECT_EQ(picture.renderer->counters().levelsFiltered, 0u);

  picture.scene = roomWithFloorOnly();
  picture.scene.objects["floor"].probeUsage = ProbeUsage::Off;
  picture.show(cameraNamed(scene, "main"));
  EXPECT_EQ(picture.renderer->counters().facesCaptured, 0u) << "told to use none";
  picture.scene.objects["floor"].probeUsage = ProbeUsage::BlendAndSky;
  picture.show(cameraNamed(scene, "main"));
  EXPECT_EQ(picture.renderer->counters().facesCaptured, 6u);
}

TEST_F(ManyProbes, OneObjectInOneProbeIsOneLookupAPixel) {
  ScenePicture picture(roomWithFloorOnly(), 64, 64);
  const auto lookups = [&] {
    picture.show(cameraNamed(picture.scene, "main"));
    SurfaceViewSettings settings;
    settings.view = *findSurfaceView("lookups");
    picture.renderer->setView(settings);
    const ImageRgbaF image = picture.linear(1);
    float largest = 0.0f;
    int seen = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
      if (image.pixels[i + 3] < 0.5f) continue;
      ++seen;
      largest = std::max(largest, image.pixels[i]);
      EXPECT_GE(image.pixels[i], 1.0f);
    }
    EXPECT_GT(seen, 500);
    picture.renderer->setView({});
    return largest;
  };
  EXPECT_EQ(lookups(), 1.0f);
  // More of them than a draw can have: the least important are left out, none of them is captured.
  const Probe room = picture.scene.probes[0];
  for (int i = 0; i < 6; ++i) {
    picture.scene.probes.push_back(room);
    picture.scene.probes.back().name = "copy " + std::to_string(i);
  }
  const auto faces = picture.renderer->counters().facesCaptured;
  EXPECT_EQ(lookups(), 4.0f);
  EXPECT_EQ(picture.renderer->counters().facesCaptured, faces) << "copies show what is there already";
}

// Without probes every object has VTK's own lighting: the picture is that of VTK's own mapper. Not where this program
// mends it: unlit materials, emission without a texture, a perfect mirror's highlight; lamps' masking is set to VTK's.
TEST_F(ManyProbes, ProbesOffIsStockVtk) {
  Scene scene = ScenePicture::fromFile("scenes/building.boxprobe.json", 8, 8).scene;
  for (const char* mirror : {"mirror", "sphere"}) scene.materials[mirror].roughness = 0.3f;
  for (const char* glowing : {"lawn", "cypress", "stone", "wood"}) {
    scene.materials[glowing].emissive = glm::vec3(0.0f);
  }
  for (const char* unlit : {"near hills", "far hills"}) scene.objects[unlit].visible = false;
  ScenePicture picture(scene, kWidth, kHeight);
  picture.renderer->useVtkLighting(1, 1, {glm::vec2(0.0f)});  // the table is not read without probes
  picture.renderer->setProbesEnabled(false);
  // VTK draws its actors as they were added: of two equally far away the first one shows.
  auto* culled = vtkCulledRenderer::SafeDownCast(picture.renderer->renderer());
  ASSERT_NE(culled, nullptr);
  culled->SetNearestFirst(false);
  picture.show(cameraNamed(scene, "main"));
  const ImageRgba8 ours = picture.display();
  const Counters& counters = picture.renderer->counters();
  EXPECT_EQ(counters.facesCaptured + counters.skyFacesCaptured + counters.levelsFiltered + counters.uniformUpdates, 0u);
  const ImageRgbaF coverage = picture.linear();
  const auto stock =
      bench::makeStockRenderer(picture.renderer->renderer(), bench::gradientSky(std::get<SkyGradient>(scene.sky)));
  stock->UseImageBasedLightingOff();
  picture.window->AddRenderer(stock);
  picture.renderer->renderer()->DrawOff();
  const ImageRgba8 theirs = picture.display();
  picture.window->RemoveRenderer(stock);
  keepPicture(ours, "off_ours");
  keepPicture(theirs, "off_stock");
  int surfaces = 0, different = 0, most = 0;
  for (std::size_t i = 0; i < ours.pixels.size(); i += 4) {
    if (coverage.pixels[i + 3] < 1.0f) continue;
    ++surfaces;
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(ours.pixels[i + c] - theirs.pixels[i + c]));
    different += largest > 0 ? 1 : 0;
    most = std::max(most, largest);
  }
  std::printf("  %d of %d pixels differ, by at most %d/255\n", different, surfaces, most);
  EXPECT_GT(surfaces, kWidth * kHeight / 3);
  EXPECT_LE(most, 1);
}

TEST_F(ManyProbes, OddListsOfProbesAreDrawn) {
  ScenePicture picture(roomWithFloorOnly(), 64, 64);
  const Camera camera = cameraNamed(picture.scene, "main");
  const Probe room = picture.scene.probes[0];
  picture.scene.probes.clear();
  picture.show(camera);
  picture.display();
  EXPECT_EQ(picture.renderer->counters().drawsByProbeCount[0], 1u) << "no probe: the sky";
  // A box without volume weighs nothing but on itself; blend distances beyond the box leave less than full weight.
  Probe flat = room, wide = room;
  flat.name = "flat";
  flat.box.max = flat.box.min;
  flat.influence.reset();
  wide.name = "wide";
  wide.blendDistance = BlendDistance{glm::dvec3(100.0), glm::dvec3(100.0)};
  picture.scene.probes = {flat, wide};
  picture.show(camera);
  for (const float x : picture.linear(1).pixels) ASSERT_TRUE(std::isfinite(x));
  const Explanation e = picture.renderer->explain(32, 50, 64, 64);
  ASSERT_TRUE(e.hit);
  for (const ProbeExplanation& p : e.probes) {
    EXPECT_GE(p.weight, 0.0f);
    EXPECT_LT(p.weight, 0.5f) << p.name;
  }
  EXPECT_GT(e.skyWeight, 0.5f);
}

// A floor that twelve probes share, four of them at most at any place: cut into pieces that each have the right ones.
TEST_F(ManyProbes, ALongFloorHasAllItsProbes) {
  scenes::Composer composer;
  Material metal = scenes::perfectMirror("floor");
  metal.roughness = 0.3f;
  scenes::MeshBuilder floor;
  floor.quad({-50, 0, 2}, {100, 0, 0}, {0, 0, -4});
  composer.add("floor", std::move(floor), composer.material(metal));
  write("floor.glb", scenes::glbBytes(std::move(composer).finish()));
  Scene scene;
  scene.models = {{file("floor.glb")}};
  constexpr double kPitch = 100.0 / 12.0, kBlend = 4.0;
  for (int i = 0; i < 12; ++i) {
    const double x = -50.0 + kPitch * i;
    Probe probe;
    probe.name = "probe " + std::to_string(i);
    probe.box = Box{{x - 3.0, -1.0, -3.0}, {x + kPitch + 3.0, 4.0, 3.0}};
    probe.origin = probe.box.center();
    probe.blendDistance = BlendDistance{{kBlend, 0.5, 0.5}, {kBlend, 0.5, 0.5}};
    probe.faceSize = 16;
    scene.probes.push_back(std::move(probe));
  }
  ScenePicture picture(scene, 1600, 32);
  Camera camera;
  camera.position = {0.0, 60.0, 0.1};
  camera.target = {0.0, 0.0, 0.0};
  camera.up = {0.0, 0.0, -1.0};
  camera.verticalFovDegrees = 1.9;
  picture.show(camera);
  picture.display();
  const FrameReport report = picture.renderer->frameReport();
  EXPECT_GT(report.objects.size(), 2u);
  for (const auto& object : report.objects) {
    EXPECT_EQ(object.node, "floor");
    EXPECT_EQ(object.leftOut, 0u);
    EXPECT_LE(object.probes.size(), 4u);
  }
  EXPECT_EQ(picture.renderer->counters().facesCaptured, 72u);
  std::vector<glm::ivec2> line;
  for (int x = 4; x < 1600; x += 4) line.emplace_back(x, 16);
  std::vector<float> before;
  double last = 0.0;
  int hits = 0;
  std::set<int> used;
  for (const Explanation& e : picture.renderer->explain(line, 1600, 32)) {
    if (!e.hit) continue;
    ++hits;
    std::vector<float> now(12, 0.0f);
    float sum = e.skyWeight;
    for (const ProbeExplanation& p : e.probes) {
      now[static_cast<std::size_t>(p.index)] = p.weight;
      sum += p.weight;
      if (p.weight > 0.5f) used.insert(p.index);
    }
    EXPECT_NEAR(sum, 1.0f, 1.0e-4f);
    EXPECT_LT(glm::distance(e.color, e.rendered.value_or(glm::vec3(-1.0f))), 2.0e-3f);
    const double step = std::abs(e.surface.positionWorld.x - last);
    for (std::size_t i = 0; i < 12 && !before.empty(); ++i) {
      // A smooth step's slope is 1.5 over its length; sharing out steepens it to twice that at most.
      EXPECT_LT(std::abs(now[i] - before[i]), 3.2 * step / kBlend)
          << "probe " << i << " at " << e.surface.positionWorld.x;
    }
    before = std::move(now);
    last = e.surface.positionWorld.x;
  }
  EXPECT_GT(hits, 300);
  EXPECT_GE(used.size(), 10u);
}

TEST_F(ManyProbes, TenThousandOverOneFloor) {
  Scene scene = roomWithFloorOnly();
  const Probe room = scene.probes[0];
  scene.probes.clear();
  for (int i = 0; i < 10000; ++i) {
    Probe probe = room;
    probe.name = "probe " + std::to_string(i);
    probe.importance = i == 4711 ? 2.0 : 1.0;
    probe.origin.x += 1.0e-4 * i;
    scene.probes.push_back(std::move(probe));
  }
  ScenePicture picture(scene, 64, 64);
  picture.show(cameraNamed(scene, "main"));
  picture.display();
  // One of them has all of the floor at the highest importance.
  EXPECT_EQ(picture.renderer->counters().facesCaptured, 6u);
  EXPECT_EQ(picture.renderer->counters().drawsByProbeCount[1], 1u);
}

}  // namespace
