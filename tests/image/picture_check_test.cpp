// What placing tells of its pictures: two closed rooms, one of which has much less light. Errors are computed once
// more, by the words of picture_check.h, from pictures that the test makes itself.
#include "app/session/picture_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "filters/core/scene/bounces.h"
#include "filters/reference/path/reference_path.h"
#include "tests/image/quad_world.h"

namespace boxprobe::test {
namespace {

constexpr int kAcross = 48, kDown = 27;

Material matte(const glm::vec3& color) {
  Material material;
  material.baseColor = glm::vec4(color, 1.0f);
  material.metallic = 0.0f;
  material.roughness = 0.9f;
  return material;
}

void addRoom(Model& model, const std::string& name, const Box& box, const glm::vec3& walls) {
  const glm::vec3 middle(box.center()), half(0.5 * box.size());
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 center = middle, right(0.0f), up(0.0f);
      center[axis] += side * half[axis];
      right[side < 0.0f ? u : v] = half[side < 0.0f ? u : v];  // faces inwards
      up[side < 0.0f ? v : u] = half[side < 0.0f ? v : u];
      const glm::vec3 color = axis == 1 ? glm::vec3(walls.z, walls.y, walls.x) : walls;
      addSquare(model, name + " " + std::to_string(axis) + (side < 0.0f ? "-" : "+"), center, right, up, matte(color));
    }
  }
}

Light bulb(const glm::dvec3& position, float intensity) {
  Light light;
  light.type = LightType::Point;
  light.position = position;
  light.intensity = intensity;
  light.range = 7.0;
  return light;
}

// The small room has a fifth of the large one's light, or less.
LoadedScene twoRooms() {
  Model model;
  addRoom(model, "hall", {{0.3, 0.1, -2.2}, {5.2, 2.8, 2.1}}, {0.7f, 0.55f, 0.5f});
  addRoom(model, "store", {{13.1, 0.2, -1.3}, {16.4, 2.6, 1.5}}, {0.5f, 0.6f, 0.68f});
  LoadedScene loaded;
  loaded.scene = darkScene();
  loaded.scene.lights = {bulb({2.1, 2.2, 0.4}, 9.0f), bulb({15.2, 2.1, -0.2}, 0.8f)};
  loaded.scene.models.push_back({"rooms", {}, {}});
  loaded.models = {std::make_shared<const Model>(std::move(model))};
  return loaded;
}

Placement placed(const LoadedScene& loaded) {
  PlaceSettings settings;
  settings.rays = 512;
  auto placement = placeProbes(loaded.scene, loaded.models, settings);
  EXPECT_TRUE(placement);
  return *std::move(placement);
}

OffscreenSettings offscreen() {
  return {"this test", 16, 16, 1, true, false, Offscreen::Automatic, true};
}

// Squared error of a picture over that of the truth, whatever is above five times the truth's mean counted as that. Of
// two truths with noise of their own, which adds nothing to the mean of the products.
double squaredError(const ImageRgbaF& picture, const ImageRgbaF& truth, const ImageRgbaF& other) {
  const std::size_t pixels = truth.pixels.size() / 4;
  double mean = 0.0, off = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < 3; ++c) mean += static_cast<double>(truth.pixels[4 * i + c]);
  }
  const double most = 5.0 * mean / (3.0 * static_cast<double>(pixels));
  for (std::size_t i = 0; i < 4 * pixels; ++i) {
    if (i % 4 == 3) continue;
    const double p = std::min(static_cast<double>(picture.pixels[i]), most);
    const double t = std::min(static_cast<double>(truth.pixels[i]), most);
    const double u = std::min(static_cast<double>(other.pixels[i]), most);
    off += (p - t) * (p - u);
    whole += t * u;
  }
  return off / whole;
}

TEST(PictureCheck, EachPictureIsJudgedByItsOwnLight) {
  const LoadedScene loaded = twoRooms();
  Placement placement = placed(loaded);
  ASSERT_EQ(placement.rooms.size(), 2u);
  for (PlacedRoom& room : placement.rooms) room.origins.clear();  // captured from where it is: fewer trials
  OffscreenScene shown(offscreen());
  PictureCheckSettings settings;
  settings.paths = 48;
  std::vector<double> told;
  const auto check = checkPictures(
      loaded, placement, shown,
      [&](double done) {
        told.push_back(done);
        return true;
      },
      settings);
  ASSERT_TRUE(check);
  EXPECT_TRUE(check->better);

  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  ASSERT_FALSE(told.empty());
  EXPECT_GE(told.front(), 0.0);
  EXPECT_LE(told.back(), 1.0);
  // Captures take most of the time, and are told of face by face while they are made.
  const std::set<double> steps(std::upper_bound(told.begin(), told.end(), 0.4), told.end());
  EXPECT_GT(steps.size(), 100u);

  const ReferencePath path(loaded.scene, loaded.models, nullptr);
  std::vector<double> before(2, 0.0), after(2, 0.0), light(2, 0.0);
  // Sixteen, of the two rooms in turn.
  std::vector<std::vector<Camera>> eyes(2);
  for (std::size_t i = 0; i < 32; ++i) {
    const std::vector<Camera>& all = placement.rooms[i % 2].eyes;
    if (eyes[0].size() + eyes[1].size() < 16 && i / 2 < all.size()) eyes[i % 2].push_back(all[i / 2]);
  }
  Scene proposed = loaded.scene;
  proposed.probes = placement.all();
  for (std::size_t room = 0; room < 2; ++room) {
    for (const Camera& eye : eyes[room]) {
      PathSettings traced;
      traced.width = kAcross;
      traced.height = kDown;
      traced.raysPerPixel = 64;
      traced.seed = 5;
      const ImageRgbaF truth = path.render(eye, traced).color;
      traced.seed = 6;
      const ImageRgbaF other = path.render(eye, traced).color;
      const auto errorOf = [&](const Scene& scene) {
        shown.show(scene, loaded.models, {eye});
        shown.capture();
        return squaredError(shown.renderer().renderLinear(kAcross, kDown, 4), truth, other) /
               static_cast<double>(eyes[room].size());
      };
      before[room] += errorOf(loaded.scene);
      after[room] += errorOf(proposed);
      for (std::size_t k = 0; k < truth.pixels.size(); k += 4) light[room] += static_cast<double>(truth.pixels[k + 1]);
    }
  }
  ASSERT_EQ(check->eyes, eyes[0].size() + eyes[1].size());
  ASSERT_EQ(check->rooms.size(), 2u);
  const std::size_t dim = light[0] < light[1] ? 0 : 1;
  EXPECT_LT(light[dim], 0.4 * light[1 - dim]);
  for (std::size_t room = 0; room < 2; ++room) {
    EXPECT_NEAR(check->rooms[room].before, std::sqrt(before[room]), 0.03 * std::sqrt(before[room])) << room;
    // Captured at 64 texels a side, where the picture that is drawn here has more.
    EXPECT_NEAR(check->rooms[room].after, std::sqrt(after[room]), 0.03) << room;
  }
  EXPECT_LT(check->after.error, 0.5 * check->before.error);

  // With those as the scene's own nothing is better: they stay, and what is told of angles and bare surfaces is of
  // them.
  LoadedScene again = loaded;
  again.scene.probes = proposed.probes;
  Placement second = placement;
  second.probes.clear();
  second.after = LitErrors{};
  second.bareAfter = 1.0;
  settings.paths = 16;
  const auto same = checkPictures(again, second, shown, {}, settings);
  ASSERT_TRUE(same);
  EXPECT_FALSE(same->better);
  EXPECT_TRUE(second.probes.empty());
  EXPECT_EQ(second.kept, again.scene.probes);
  EXPECT_EQ(second.after.meanDegrees, placement.after.meanDegrees);
  EXPECT_EQ(second.bareAfter, placement.bareAfter);
}

// Of many probes four bounces are captured, of sixteen as many as they ask for. Nothing is placed here.
TEST(PictureCheck, ManyProbesAreCapturedFourTimes) {
  for (const std::size_t count : {std::size_t{16}, std::size_t{17}}) {
    LoadedScene loaded = twoRooms();
    Placement placement = placed(loaded);
    placement.probes.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const auto along = static_cast<double>(i);
      Probe probe = cubeProbe("p" + std::to_string(i), {0.6 + 0.25 * along, 1.4, 0.1 * along - 1.0}, 0.2, 8);
      probe.influence = Box{{0.2, 0.0, -2.3}, {0.5 + 0.28 * along, 2.9, 2.2}};
      probe.bounces = kAllBounces;
      loaded.scene.probes.push_back(probe);
    }
    OffscreenScene shown(offscreen());
    PictureCheckSettings settings;
    settings.paths = 4;
    ASSERT_TRUE(checkPictures(loaded, placement, shown, {}, settings));
    const std::uint64_t faces = shown.renderer().counters().facesCaptured;
    if (count == 16) {
      EXPECT_GT(faces, count * 6 * 4);
    } else {
      EXPECT_LE(faces, count * 6 * 4);
    }
  }
}

}  // namespace
}  // namespace boxprobe::test
