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

Light bulb(const glm::dvec3& position, float intensity) {
  Light light;
  light.type = LightType::Point;
  light.position = position;
  light.intensity = intensity;
  light.range = 7.0;
  return light;
}

// The small room has much less light than the large one.
LoadedScene twoRooms() {
  Model model;
  addBox(model, "hall", {0.3f, 0.1f, -2.2f}, {5.2f, 2.8f, 2.1f}, false, matte({0.7f, 0.55f, 0.5f}));
  addBox(model, "store", {13.1f, 0.2f, -1.3f}, {16.4f, 2.6f, 1.5f}, false, matte({0.5f, 0.6f, 0.68f}));
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

// Squared error of a picture over the squared truth. What is above five times the truth's mean counts as that. The two
// truths have noise of their own, which adds nothing to the mean of their products.
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

TEST(PictureCheck, EachPictureIsJudgedByItsOwnLightAndWhatIsBestStays) {
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

// Of more than 16 probes at most four bounces are captured, whether they are the scene's own or placed.
TEST(PictureCheck, ManyProbesAreCapturedFourTimes) {
  const LoadedScene loaded = twoRooms();
  Placement nothing = placed(loaded);
  nothing.probes.clear();
  for (PlacedRoom& room : nothing.rooms) room.origins.clear();
  const auto probes = [](std::size_t count) {
    std::vector<Probe> made;
    for (std::size_t i = 0; i < count; ++i) {
      const auto along = static_cast<double>(i);
      Probe probe = cubeProbe("p" + std::to_string(i), {0.6 + 0.25 * along, 1.4, 0.1 * along - 1.0}, 0.2, 8);
      probe.influence = Box{{0.2, 0.0, -2.3}, {0.5 + 0.28 * along, 2.9, 2.2}};
      probe.bounces = kAllBounces;
      made.push_back(probe);
    }
    return made;
  };
  const auto faces = [](const LoadedScene& scene, Placement placement, std::string* said = nullptr) {
    OffscreenScene shown(offscreen());
    PictureCheckSettings settings;
    settings.paths = 4;
    const auto check = checkPictures(scene, placement, shown, {}, settings);
    EXPECT_TRUE(check);
    if (said != nullptr) *said = check->sentences.front().english();
    return shown.renderer().counters().facesCaptured;
  };
  LoadedScene own = loaded;
  own.scene.probes = probes(16);
  EXPECT_GT(faces(own, nothing), 16u * 6u * 4u);
  own.scene.probes = probes(17);
  std::string said;
  const std::uint64_t ofOwn = faces(own, nothing, &said);
  EXPECT_GT(ofOwn, 16u * 6u * 3u);
  EXPECT_LE(ofOwn, 17u * 6u * 4u);
  EXPECT_EQ(said, "pictures of more than 16 probes were compared with at most 4 bounces of light");

  Placement many = nothing;
  for (const Probe& probe : probes(17)) {
    PlacedProbe each;
    each.probe = probe;
    many.probes.push_back(each);
  }
  const std::uint64_t ofPlaced = faces(loaded, many);
  EXPECT_GT(ofPlaced, 16u * 6u * 3u);
  EXPECT_LE(ofPlaced, (17u + 2u) * 6u * 4u) << "and of one box around all rooms, and of one around the model";
}

}  // namespace
}  // namespace boxprobe::test
