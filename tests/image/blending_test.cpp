// Several probes at one place: no seam where they meet, no order, no jump; turned boxes; object modes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <random>

#include "data/scenes/composer.h"
#include "data/scenes/glb_writer.h"
#include "data/scenes/mesh_builder.h"
#include "data/scenes/picture.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/gltf/model_file.h"
#include "filters/reference/light/reference_scene.h"
#include "tests/support/line_chart.h"
#include "tests/support/scene_picture.h"
#include "tests/unit/temporary_folder.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

Probe probeAt(const std::string& name, const glm::dvec3& origin, const Box& box, double blend) {
  Probe probe;
  probe.name = name;
  probe.origin = origin;
  probe.box = box;
  probe.blendDistance = BlendDistance{glm::dvec3(blend), glm::dvec3(blend)};
  probe.faceSize = 64;
  return probe;
}

class Blending : public TemporaryFolder {
 protected:
  /// `building` as only probes see it, and of its own a rough metal sphere in the origin of its model.
  Scene walkThroughBuilding() {
    Scene scene = ScenePicture::fromFile("scenes/building.boxprobe.json", 8, 8).scene;
    for (const Instance& instance : loadModelFile(scene.models[0].file).instances) {
      scene.objects[instance.node].visible = false;
    }
    scenes::Composer composer;
    Material metal = scenes::perfectMirror("walker");
    metal.roughness = 0.35f;
    composer.add("walker", scenes::sphere(0.3, 64), composer.material(metal));
    write("walker.glb", scenes::glbBytes(std::move(composer).finish()));
    scene.models.push_back({file("walker.glb")});
    scene.objects["walker"].seenByProbes = false;
    scene.lights.clear();
    Probe room = scene.probes[0];
    room.faceSize = 64;
    room.bounces = 1;
    room.blendDistance = BlendDistance{glm::dvec3(1.5), glm::dvec3(1.5)};
    scene.probes = {room, probeAt("porch", {5.5, 2.0, 0.0}, {{3.0, -0.5, -4.0}, {8.0, 5.0, 4.0}}, 1.0),
                    probeAt("lawn", {8.0, 1.2, 0.5}, {{4.0, -0.5, -5.0}, {11.0, 4.0, 5.0}}, 1.0)};
    return scene;
  }

  struct Walk {
    std::vector<double> at;
    std::vector<glm::dvec3> color;
    std::vector<std::vector<float>> weights;  ///< of the three probes by the list's order, then the sky
    double largestStep() const {
      double largest = 0.0;
      for (std::size_t i = 1; i < color.size(); ++i) largest = std::max(largest, glm::distance(color[i], color[i - 1]));
      return largest;
    }
  };

  static Walk walk(ScenePicture& picture, int steps) {
    Walk result;
    for (int i = 0; i <= steps; ++i) {
      const glm::dvec3 place(13.0 * i / steps, 1.1, 0.2);
      picture.scene.models[1].translation = place;
      Camera camera;
      camera.position = place + glm::dvec3(1.6, 0.9, 2.2);
      camera.target = place;
      camera.verticalFovDegrees = 20.0;
      if (i == 0) {
        picture.show(camera);
      } else {
        Changes moved;
        moved.models = true;
        picture.renderer->sync(picture.scene, moved);
        picture.renderer->applyCamera(camera);
        picture.renderer->finishWork();
      }
      const Explanation e = picture.renderer->explain(8, 8, 16, 16);
      EXPECT_TRUE(e.hit);
      EXPECT_LT(glm::distance(e.color, e.rendered.value_or(glm::vec3(0.0f))), 2.0e-3f)
          << "the explanation is not what is drawn, at " << place.x;
      std::vector<float> weights(picture.scene.probes.size() + 1, 0.0f);
      float sum = e.skyWeight;
      weights.back() = e.skyWeight;
      for (const ProbeExplanation& p : e.probes) {
        weights[static_cast<std::size_t>(p.index)] = p.weight;
        sum += p.weight;
      }
      EXPECT_NEAR(sum, 1.0f, 1.0e-4f);
      result.at.push_back(place.x);
      result.color.emplace_back(e.rendered.value_or(glm::vec3(0.0f)));
      result.weights.push_back(std::move(weights));
    }
    return result;
  }
};

TEST_F(Blending, WalkingOutOfTheBuildingIsContinuous) {
  ScenePicture picture(walkThroughBuilding(), 16, 16);
  const Walk coarse = walk(picture, 104), fine = walk(picture, 208);
  const auto faces = picture.renderer->counters().facesCaptured;
  EXPECT_EQ(faces, 18u) << "the walker is not in the pictures, so nothing is made again for it";
  int most[5] = {};
  for (const auto& weights : fine.weights) {
    ++most[std::count_if(weights.begin(), weights.end(), [](float w) { return w > 1.0e-3f; })];
  }
  EXPECT_GT(most[1], 0);
  EXPECT_GT(most[2], 0);
  EXPECT_GT(most[3], 0) << "three at once";
  EXPECT_NEAR(fine.weights.front()[0], 1.0f, 1.0e-6f);
  EXPECT_NEAR(fine.weights.back()[3], 1.0f, 1.0e-6f) << "at the end there is the sky alone";

  for (Probe& probe : picture.scene.probes) probe.blendDistance = BlendDistance{glm::dvec3(0.0), glm::dvec3(0.0)};
  const Walk jumps = walk(picture, 208), finerJumps = walk(picture, 416);
  std::printf(
      "  largest change a step: blended %.4f at 12.5 cm, %.4f at 6.25 cm; not blended %.4f at 6.25 cm, %.4f at 3.125 "
      "cm\n",
      coarse.largestStep(), fine.largestStep(), jumps.largestStep(), finerJumps.largestStep());
  // Half the step, half the change: a derivative exists. A jump stays what it is.
  EXPECT_LT(fine.largestStep(), 0.62 * coarse.largestStep());
  EXPECT_GT(finerJumps.largestStep(), 0.9 * jumps.largestStep());
  EXPECT_LT(fine.largestStep(), 0.25 * jumps.largestStep());

  std::vector<Curve> curves;
  const auto add = [&](const Walk& from, const char* name, glm::ivec3 color) {
    Curve curve{name,
                {},
                {static_cast<unsigned char>(color.x), static_cast<unsigned char>(color.y),
                 static_cast<unsigned char>(color.z)}};
    for (const glm::dvec3& c : from.color) curve.values.push_back((c.x + c.y + c.z) / 3.0);
    curves.push_back(std::move(curve));
  };
  add(fine, "reflected light, blended", {30, 90, 200});
  add(jumps, "blend distance 0", {220, 90, 40});
  const char* names[] = {"weight of room", "of porch", "of lawn", "of the sky"};
  const glm::ivec3 colors[] = {{190, 160, 40}, {60, 160, 80}, {150, 80, 170}, {150, 150, 150}};
  for (std::size_t k = 0; k < 4; ++k) {
    Curve curve{names[k],
                {},
                {static_cast<unsigned char>(colors[k].x), static_cast<unsigned char>(colors[k].y),
                 static_cast<unsigned char>(colors[k].z)}};
    for (const auto& weights : fine.weights) curve.values.push_back(weights[k]);
    curves.push_back(std::move(curve));
  }
  keepPicture(lineChart("A rough metal sphere walks out of building", "x of the sphere, metres", fine.at, curves),
              "walk");
}

TEST_F(Blending, NothingDependsOnTheOrderInTheFile) {
  Scene scene = walkThroughBuilding();
  scene.models[1].translation = glm::dvec3(4.6, 1.1, 0.2);
  scene.probes[1].importance = 2.0;
  scene.probes.push_back(probeAt("over all", {4.0, 1.5, 1.0}, {{2.0, -0.5, -3.0}, {9.0, 4.0, 3.0}}, 2.0));
  ScenePicture picture(scene, 96, 96);
  Camera camera;
  camera.position = scene.models[1].translation + glm::dvec3(0.8, 0.45, 1.1);
  camera.target = scene.models[1].translation;
  picture.show(camera);
  const ImageRgbaF first = picture.linear(1);
  std::mt19937 random(7);
  for (int i = 0; i < 4; ++i) {
    std::shuffle(picture.scene.probes.begin(), picture.scene.probes.end(), random);
    picture.show(camera);
    EXPECT_EQ(picture.linear(1).pixels, first.pixels);
  }
}

// The floor of `room` as a mirror, the whole turned about the vertical: only the box's rotation tells.
TEST_F(Blending, ATurnedRoomReflectsAsWell) {
  constexpr int kWidth = 480, kHeight = 270;
  const auto turned = [](double degrees) {
    Scene scene = ScenePicture::fromFile("scenes/room.boxprobe.json", 8, 8).scene;
    for (const char* sphere : {"sphere 1", "sphere 2", "sphere 3"}) scene.objects[sphere].visible = false;
    const glm::dmat3 turn = rotationMatrix({0.0, degrees, 0.0});
    scene.models[0].rotationDegrees = {0.0, degrees, 0.0};
    for (Camera& camera : scene.cameras) {
      camera.position = turn * camera.position;
      camera.target = turn * camera.target;
    }
    scene.probes[0].origin = turn * scene.probes[0].origin;  // the box's centre is on the axis
    scene.probes[0].rotationDegrees = {0.0, degrees, 0.0};
    return scene;
  };
  const auto measure = [](Scene scene, const char* name, int faceSize) {
    scene.probes[0].faceSize = faceSize;
    ScenePicture picture(scene, kWidth, kHeight);
    const Camera camera = cameraNamed(scene, name);
    picture.scene.materials["floor"].emissive = glm::vec3(1000.0f);
    picture.show(camera);
    const ImageRgbaF glowing = picture.linear(1);
    std::vector<bool> mask(glowing.pixels.size() / 4);
    for (std::size_t i = 0; i < mask.size(); ++i) {
      mask[i] = true;
      for (const int offset : {0, -1, 1, -kWidth, kWidth}) {
        const long at = std::clamp(static_cast<long>(i) + offset, 0L, static_cast<long>(mask.size()) - 1);
        mask[i] = mask[i] && glowing.pixels[static_cast<std::size_t>(4 * at)] > 500.0f;
      }
    }
    picture.scene = scene;
    picture.show(camera);
    const ImageRgbaF drawn = picture.linear();
    picture.scene.objects["floor"].visible = false;
    picture.show(mirroredInFloor(camera, 0.0));
    return psnr(drawn, flippedTopToBottom(picture.linear()), mask);
  };
  for (const char* name : {"main", "A"}) {
    const double straight = measure(turned(0.0), name, 256), by30 = measure(turned(30.0), name, 256);
    Scene wrong = turned(30.0);
    wrong.probes[0].rotationDegrees = glm::dvec3(0.0);
    const double notTurned = measure(wrong, name, 256);
    std::printf("  camera %s: %.2f dB; turned by 30 degrees %.2f dB; box left as it was %.2f dB\n", name, straight,
                by30, notTurned);
    // The map turns with the box, so that its texels lie along the walls as those of the room as it stands.
    EXPECT_GT(by30, straight - 0.5);
    EXPECT_LT(notTurned, by30 - 10.0);
  }
}

// A hall whose eastern half is half as wide, with a probe for each half: where they overlap each is right on its own
// side. What both give together is nearer the ray-traced picture than what either does alone.
TEST_F(Blending, InTheOverlapBothAreBetterThanEither) {
  constexpr int kWidth = 320, kHeight = 180;
  scenes::Composer hall;
  int number = 0;
  const auto wall = [&](const glm::dvec3& corner, const glm::dvec3& right, const glm::dvec3& up) {
    const int seed = ++number;
    const auto picture = scenes::paint("wall", 256, 256, [seed](double u, double v) {
      const double stripes = scenes::softLines(u, 0.125, 0.03, 0.01);
      const glm::dvec3 base(0.3 + 0.5 * scenes::hash(seed, 0, 1), 0.3 + 0.5 * scenes::hash(seed, 1, 1), 0.2 + 0.6 * v);
      return scenes::blend(base, glm::dvec3(0.05, 0.1, 0.2 + 0.5 * u), stripes);
    });
    scenes::MeshBuilder mesh;
    mesh.quad(corner, right, up);
    const std::string name = "wall " + std::to_string(seed);
    hall.add(name, std::move(mesh), hall.material(scenes::unlit(name, picture)));
  };
  const glm::dvec3 up(0, 3, 0);
  wall({-5, 0, -2}, {5, 0, 0}, up);
  wall({0, 0, -2}, {0, 0, 1}, up);
  wall({0, 0, -1}, {5, 0, 0}, up);
  wall({5, 0, -1}, {0, 0, 2}, up);
  wall({5, 0, 1}, {-5, 0, 0}, up);
  wall({0, 0, 1}, {0, 0, 1}, up);
  wall({0, 0, 2}, {-5, 0, 0}, up);
  wall({-5, 0, 2}, {0, 0, -4}, up);
  wall({-5, 3, -2}, {10, 0, 0}, {0, 0, 4});
  Material metal = scenes::perfectMirror("floor");
  metal.roughness = 0.1f;
  scenes::MeshBuilder floor;
  floor.quad({-5, 0, 2}, {10, 0, 0}, {0, 0, -4});
  hall.add("floor", std::move(floor), hall.material(metal));
  write("hall.glb", scenes::glbBytes(std::move(hall).finish()));

  Scene scene;
  scene.models = {{file("hall.glb")}};
  scene.sky = SkyColor{};
  Camera camera;
  camera.position = {0.0, 2.6, 0.9};
  camera.target = {0.0, 0.0, -0.5};
  camera.verticalFovDegrees = 70.0;
  scene.cameras = {camera};
  Probe west = probeAt("west", {-1.5, 1.5, 0.1}, {{-5, 0, -2}, {0, 3, 2}}, 0.0);
  Probe east = probeAt("east", {1.5, 1.5, 0.1}, {{0, 0, -1}, {5, 3, 1}}, 0.0);
  for (Probe* probe : {&west, &east}) {
    probe->faceSize = 256;
    probe->influence = Box{{-6, -1, -3}, {6, 4, 3}};
  }
  Probe westPart = west, eastPart = east;
  westPart.influence->max.x = 1.0;
  westPart.blendDistance.max.x = 2.0;
  eastPart.influence->min.x = -1.0;
  eastPart.blendDistance.min.x = 2.0;

  const auto drawn = [&](const std::vector<Probe>& probes, const char* view) {
    Scene with = scene;
    with.probes = probes;
    ScenePicture picture(with, kWidth, kHeight);
    picture.show(camera);
    SurfaceViewSettings settings;
    settings.view = *findSurfaceView(view);
    picture.renderer->setView(settings);
    return picture.linear();
  };
  const ImageRgbaF blended = drawn({westPart, eastPart}, "picture"), lookups = drawn({westPart, eastPart}, "lookups");
  const ImageRgbaF onlyWest = drawn({west}, "picture"), onlyEast = drawn({east}, "picture");
  scene.probes = {westPart, eastPart};
  std::vector<std::shared_ptr<const Model>> models = {std::make_shared<Model>(loadModelFile(scene.models[0].file))};
  ReferenceSettings settings;
  settings.width = kWidth;
  settings.height = kHeight;
  settings.raysPerPixel = 64;
  const ImageRgbaF traced = ReferenceScene(scene, models, nullptr).render(camera, settings).color;
  std::vector<bool> overlap(lookups.pixels.size() / 4);
  for (std::size_t i = 0; i < overlap.size(); ++i) overlap[i] = lookups.pixels[4 * i] > 1.99f;
  keepPicture(blended, "overlap_blended");
  keepPicture(onlyWest, "overlap_west");
  keepPicture(onlyEast, "overlap_east");
  keepPicture(traced, "overlap_traced");
  const double both = psnr(blended, traced, overlap), w = psnr(onlyWest, traced, overlap),
               e = psnr(onlyEast, traced, overlap);
  std::printf("  %ld pixels of overlap: blended %.2f dB, west alone %.2f dB, east alone %.2f dB\n",
              std::count(overlap.begin(), overlap.end(), true), both, w, e);
  EXPECT_GT(std::count(overlap.begin(), overlap.end(), true), kWidth * kHeight / 20);
  EXPECT_GT(both, std::max(w, e) + 1.0);
}

TEST_F(Blending, ObjectModesAndWeightsOfAnObject) {
  Scene scene = walkThroughBuilding();
  const glm::dvec3 place(10.2, 1.1, 0.2);  // partly lawn, partly sky
  scene.models[1].translation = place;
  ScenePicture picture(scene, 64, 64);
  Camera camera;
  camera.position = place + glm::dvec3(1.6, 0.9, 2.2);
  camera.target = place;
  camera.verticalFovDegrees = 20.0;
  const auto explained = [&](ProbeUsage mode, WeightMode weights) {
    picture.scene.objects["walker"].probeUsage = mode;
    picture.scene.objects["walker"].weights = weights;
    picture.show(camera);
    double drawn = 0.0, worst = 0.0;
    Explanation middle;
    for (const Explanation& e : picture.renderer->explain({{32, 32}, {26, 30}, {38, 34}, {32, 40}}, 64, 64)) {
      worst = std::max<double>(worst, glm::distance(e.color, e.rendered.value_or(glm::vec3(0.0f))));
      drawn += e.rendered.value_or(glm::vec3(0.0f)).x;
      if (e.x == 32 && e.y == 32) middle = e;
    }
    EXPECT_GT(drawn, 0.0);
    EXPECT_LT(worst, 2.0e-3) << "explained as drawn, mode " << static_cast<int>(mode);
    return middle;
  };
  const auto weightOf = [](const Explanation& e, const std::string& name) {
    for (const ProbeExplanation& p : e.probes) {
      if (p.name == name) return p.weight;
    }
    return 0.0f;
  };
  const Explanation usual = explained(ProbeUsage::BlendAndSky, WeightMode::Pixel);
  const float lawn = weightOf(usual, "lawn");
  EXPECT_GT(lawn, 0.2f);
  EXPECT_LT(lawn, 0.99f);
  EXPECT_NEAR(usual.skyWeight, 1.0f - lawn, 1.0e-4f);
  EXPECT_EQ(explained(ProbeUsage::Off, WeightMode::Pixel).skyWeight, 1.0f);
  const Explanation simple = explained(ProbeUsage::Simple, WeightMode::Pixel);
  EXPECT_EQ(weightOf(simple, "lawn"), 1.0f);
  EXPECT_EQ(simple.skyWeight, 0.0f);
  EXPECT_EQ(simple.lookupCount, 1);
  const Explanation blend = explained(ProbeUsage::Blend, WeightMode::Pixel);
  EXPECT_NEAR(weightOf(blend, "lawn"), 1.0f, 1.0e-5f);
  EXPECT_EQ(blend.skyWeight, 0.0f);
  // All of the sphere lies inside the influence box, so that is its weight, whatever the blend distance.
  EXPECT_NEAR(weightOf(explained(ProbeUsage::BlendAndSky, WeightMode::Object), "lawn"), 1.0f, 1.0e-6f);
  picture.scene.models[1].translation.x += 0.8;  // centre on the box's face: 0.5, of which groupScale makes 0.625
  camera.position.x += 0.8;
  camera.target.x += 0.8;
  const Explanation half = explained(ProbeUsage::BlendAndSky, WeightMode::Object);
  EXPECT_NEAR(weightOf(half, "lawn"), 0.625f, 1.0e-3f);
  EXPECT_NEAR(half.skyWeight, 0.375f, 1.0e-3f);
}

}  // namespace
