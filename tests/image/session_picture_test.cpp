// What a run of the program measures on pictures: costs of a frame by a clock that the test winds, a review of a scene
// by one process and by two, and what placing says of its trials. Against files in values.
#include <gtest/gtest.h>
#include <vtkOpenGLRenderWindow.h>

#include <algorithm>
#include <cmath>

#include "app/cli/report/frame_costs.h"
#include "app/cli/report/view_sheet.h"
#include "app/session/picture_check.h"
#include "app/session/reference_box_picture.h"
#include "app/session/scene_review.h"
#include "app/session/shared_work.h"
#include "filters/reference/path/reference_path.h"
#include "tests/image/quad_world.h"
#include "tests/support/kept_values.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe::test {
namespace {

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

/// Two closed rooms, the second one dim with something shiny in it, and a probe of the scene's own.
LoadedScene twoRooms() {
  Model model;
  addBox(model, "hall", {0.3f, 0.1f, -2.2f}, {5.2f, 2.8f, 2.1f}, false, matte({0.5f, 0.4f, 0.3f}));
  addBox(model, "store", {13.1f, 0.2f, -1.3f}, {16.4f, 2.6f, 1.5f}, false, matte({0.3f, 0.4f, 0.5f}));
  Material shiny = matte({0.9f, 0.8f, 0.7f});
  shiny.metallic = 1.0f;
  shiny.roughness = 0.1f;
  addSquare(model, "shiny", {13.2f, 1.3f, 0.2f}, {0, 0, -0.8f}, {0, 0.7f, 0}, shiny);
  LoadedScene loaded;
  loaded.scene = darkScene();
  loaded.scene.lamps = LampForm::InMap;  // a lattice of each trial would take its time
  loaded.scene.lights = {bulb({2.1, 2.2, 0.4}, 9.0f), bulb({15.2, 2.1, -0.2}, 0.8f)};
  loaded.scene.models.push_back({"rooms", {}, {}});
  loaded.models = {std::make_shared<const Model>(std::move(model))};
  Probe own = cubeProbe("own", {3.4, 1.2, 0.4}, 1.0, 32);
  own.box = {{0.0, 0.0, -2.5}, {4.4, 2.5, 2.4}};
  own.influence = Box{{-1.0, -1.0, -3.0}, {18.0, 4.0, 3.0}};
  loaded.scene.probes = {own};
  return loaded;
}

OffscreenSettings offscreen() {
  return {"this test", 16, 16, 1, true, false, Offscreen::Automatic, true};
}

double meanOf(const ImageRgbaF& image) {
  double sum = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) sum += i % 4 == 3 ? 0.0 : image.pixels[i];
  return sum / static_cast<double>(std::max<std::size_t>(image.pixels.size(), 1));
}

void add(test::KeptValues& values, const std::string& name, const PictureErrors& errors) {
  values.add(name, std::vector<double>{errors.error, errors.glossy, errors.light});
}

TEST(SessionPictures, PlacingTriesWhatTheFileSays) {
  LoadedScene loaded = twoRooms();
  PlaceSettings place;
  place.rays = 512;
  auto placement = placeProbes(loaded.scene, loaded.models, place);
  ASSERT_TRUE(placement);
  ASSERT_EQ(placement->rooms.size(), 2u);
  ASSERT_EQ(placement->probes.size(), 2u);
  // Few eyes, and one other origin: each trial takes its time.
  for (PlacedRoom& room : placement->rooms) room.eyes.resize(std::min<std::size_t>(room.eyes.size(), 2));
  placement->rooms[0].origins.resize(1);
  placement->rooms[1].origins.clear();
  PlacedProbe wrong = placement->probes[0];
  wrong.part = true;
  wrong.probe.name = "wrong";
  wrong.probe.influence = Box{wrong.probe.box.center(), wrong.probe.box.max};
  wrong.probe.box.max += 3.0;
  placement->probes.insert(placement->probes.begin() + 1, wrong);
  for (PlacedProbe& each : placement->probes) each.probe.faceSize = 16;

  OffscreenScene shown(offscreen());
  PictureCheckSettings settings;
  settings.paths = 12;
  settings.views = true;
  test::KeptValues values;
  const auto tell = [&](const std::string& name, const PictureCheck& check, const Placement& of) {
    values.part(name);
    for (const Phrase& sentence : check.sentences) values.add(sentence.english());
    values.add("eyes, better, seconds", std::vector<double>{static_cast<double>(check.eyes), check.better ? 1.0 : 0.0,
                                                            check.seconds > 0.0 ? 1.0 : 0.0});
    add(values, "before", check.before);
    add(values, "after", check.after);
    for (const RoomErrors& room : check.rooms) {
      values.add("room", std::vector<double>{room.seen ? 1.0 : 0.0, room.before, room.after});
    }
    for (const EyePictures& view : check.views) {
      values.add("view of room " + std::to_string(view.room),
                 std::vector<double>{view.camera.position.x, view.camera.position.z,
                                     static_cast<double>(view.truth.width), static_cast<double>(view.after.height),
                                     meanOf(view.before), meanOf(view.after), meanOf(view.truth)});
    }
    std::vector<int> viewOf;
    for (const auto& each : check.viewOf) viewOf.push_back(each ? static_cast<int>(*each) : -1);
    values.add("views of probes", viewOf);
    for (const Probe& probe : of.all()) {
      values.add(probe.name, std::vector<double>{probe.origin.x, probe.origin.z, probe.box.min.x, probe.box.max.z,
                                                 static_cast<double>(probe.bounces)});
    }
    for (const PlacedProbe& each : of.probes) values.add(each.reason.english());
  };
  Placement first = *placement;
  std::vector<double> told;
  const auto check = checkPictures(
      loaded, first, shown,
      [&](double done) {
        told.push_back(done);
        return true;
      },
      settings);
  ASSERT_TRUE(check);
  tell("parts and a probe of the scene's own", *check, first);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1.0);
  EXPECT_GT(told.back(), 0.9);

  // Stopped, there is nothing.
  settings.paths = 2;
  Placement stopped = *placement;
  EXPECT_FALSE(checkPictures(
      loaded, stopped, shown, [](double done) { return done < 0.3; }, settings));

  // Nothing to compare.
  const auto said = [&](const LoadedScene& scene, Placement of) {
    const auto checked = checkPictures(scene, of, shown, {}, settings);
    EXPECT_TRUE(checked && checked->better);
    values.add(checked->sentences.front().english());
  };
  values.part("nothing to compare");
  LoadedScene dark = loaded;
  dark.scene.lights.clear();
  said(dark, *placement);
  Placement nobody = *placement;
  for (PlacedRoom& room : nobody.rooms) room.eyes.clear();
  said(loaded, nobody);
  Model unlit = *loaded.models[0];
  for (Material& material : unlit.materials) material.unlit = true;
  LoadedScene flat = loaded;
  flat.models = {std::make_shared<const Model>(unlit)};
  said(flat, *placement);
  values.expect("image/values/picture_check.txt", 0.02);
}

class SessionReviews : public TemporaryFolder {};

TEST_F(SessionReviews, AReviewIsThatOfTheFileByOneProcessAndByTwo) {
  LoadedScene loaded = twoRooms();
  loaded.path = "/somewhere/two.rooms.boxprobe.json";
  loaded.warnings = {"a warning"};
  Probe custom = loaded.scene.probes[0];
  custom.name = "second";
  custom.origin = {14.6, 1.1, 0.3};
  custom.box = {{13.0, 0.1, -1.4}, {16.5, 2.7, 1.7}};
  custom.influence = custom.box;
  loaded.scene.probes.push_back(custom);
  ReviewSettings settings;
  settings.width = 24;
  settings.height = 36;
  settings.paths = 8;
  settings.samplesPerPixel = 4;
  Camera hall, store;
  hall.name = "hall";
  hall.position = {1.0, 1.6, 1.4};
  hall.target = {4.6, 1.0, -1.2};
  store.name = "store";
  store.position = {16.0, 1.5, 1.0};
  store.target = {13.5, 1.2, -0.4};
  settings.cameras = {hall, store};
  OffscreenScene shown(offscreen());
  std::vector<double> told;
  const auto tell = [&](double done) {
    told.push_back(done);
    return true;
  };
  const auto review = reviewScene(loaded, shown, settings, tell);
  ASSERT_TRUE(review);
  test::KeptValues values;
  values.part("review of " + review->name);
  values.add("triangles, faces", std::vector<std::uint64_t>{review->triangles, review->faces});
  for (const ReviewedCamera& row : review->cameras) {
    values.part("camera " + row.camera.name);
    values.add("light",
               std::vector<double>{meanOf(row.picture), meanOf(row.truth.color), meanOf(row.truth.standardError)});
    values.add("lookups", std::vector<double>{row.lookups.mean, row.lookups.most});
    for (const PartError& part : row.parts) values.add(part.part, std::vector<double>{part.light, part.relativeRmse});
  }
  for (const ReviewedProbe& row : review->probes) {
    ASSERT_TRUE(row.fit);
    values.part("probe " + row.probe.name);
    values.add("objects", std::vector<std::size_t>{row.objects, row.bytes > 0 ? 1u : 0u});
    values.add("fit", std::vector<double>{row.fit->before.meanDegrees, row.fit->probe.box.max.x});
  }
  for (const std::string& remark : review->remarks) values.add(remark);
  EXPECT_TRUE(review->captureCpuSeconds);
  EXPECT_NE(review->rendererName.find(", anisotropy "), std::string::npos);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1.0);
  EXPECT_GT(told.back(), 0.98);
  EXPECT_LT(told.front(), 0.2);

  std::vector<std::size_t> made;
  for (int index = 1; index <= 2; ++index) {
    const SharedWork shared(folder_.string(), "0123456789abcdef", index, 2);
    ReviewSettings mine = settings;
    mine.shared = &shared;
    told.clear();
    EXPECT_TRUE(reviewShare(loaded, mine, tell));
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_LE(told.back(), 1.0);
    made.push_back(shared.made());
    EXPECT_EQ(shared.found(), 0u);
  }
  values.add("made by each", made);
  const SharedWork merged(folder_.string(), "0123456789abcdef", 0, 1);
  ReviewSettings wanted = settings;
  wanted.shared = &merged;
  const auto again = reviewScene(loaded, shown, wanted, {});
  ASSERT_TRUE(again);
  EXPECT_EQ(merged.made(), 0u);
  EXPECT_EQ(merged.found(), 8u) << "three bands of each camera, and two fits";
  EXPECT_FALSE(again->captureCpuSeconds);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(again->cameras[i].truth.color.pixels == review->cameras[i].truth.color.pixels) << i;
    EXPECT_TRUE(again->cameras[i].truth.standardError.pixels == review->cameras[i].truth.standardError.pixels) << i;
    EXPECT_EQ(again->probes[i].fit->probe.box, review->probes[i].fit->probe.box);
  }
  // Stopped, there is nothing.
  for (const double at : {0.0, 0.5}) {
    EXPECT_FALSE(reviewScene(loaded, shown, settings, [at](double done) { return done < at; })) << at;
  }
  const SharedWork fresh(folder_.string(), "fedcba9876543210", 1, 1);
  wanted.shared = &fresh;
  EXPECT_FALSE(reviewShare(loaded, wanted, [](double) { return false; }));
  EXPECT_FALSE(reviewShare(loaded, wanted, [](double done) { return done < 0.9; }));
  loaded.path.clear();
  loaded.scene.probes.clear();
  settings.cameras.clear();
  const auto bare = reviewScene(loaded, shown, settings, {});
  ASSERT_TRUE(bare);
  EXPECT_EQ(bare->name, "rooms");
  EXPECT_EQ(bare->cameras.size(), 1u);
  EXPECT_TRUE(bare->probes.empty());
  values.expect("image/values/scene_review.txt", 0.01);
}

// Times that no machine has: each frame takes as long as the one before, and a little more or less.
TEST(SessionPictures, CostsAreWorkedOutOfTheFramesTimes) {
  const LoadedScene loaded = twoRooms();
  OffscreenScene shown(offscreen());
  Camera camera;
  camera.position = {1.0, 1.6, 1.4};
  camera.target = {4.6, 0.4, -1.2};
  shown.show(loaded.scene, loaded.models, {camera});
  shown.capture();
  test::KeptValues values;
  for (const int rounds : {2, 3}) {
    std::uint64_t frames = 0;
    std::vector<double> told;
    FrameCosts costs = measureFrameCosts(
        shown.renderer(), rounds,
        [&] {
          if (++frames == 1) shown.window()->Render();
          return 0.001 * static_cast<double>(40 + frames * frames * 7919 % 1009);
        },
        [&](double done) {
          told.push_back(done);
          return true;
        });
    costs.cpuTime = true;
    values.part(std::to_string(rounds) + " rounds");
    values.add(frameCostsText(costs));
    values.add(frameCostsJson(costs).dump(1));
    values.add("frames, steps", std::vector<std::uint64_t>{frames, told.size()});
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_NEAR(told.front() * static_cast<double>(told.size()), 1.0, 1e-9);
    EXPECT_NEAR(told.back(), 1.0, 1e-9);
  }
  const FrameCosts stopped = measureFrameCosts(
      shown.renderer(), 3, [] { return 0.5; }, [](double done) { return done < 0.5; });
  EXPECT_TRUE(stopped.parts.empty());
  EXPECT_EQ(stopped.rounds, 3);
  values.expect("image/values/frame_costs.txt", 1e-5);
}

TEST(SessionPictures, ASheetHasEveryViewInItsPlace) {
  const LoadedScene loaded = twoRooms();
  OffscreenScene shown(offscreen());
  Camera camera;
  camera.position = {1.0, 1.6, 1.4};
  camera.target = {4.6, 0.4, -1.2};
  shown.show(loaded.scene, loaded.models, {camera});
  shown.capture();
  std::size_t asked = 0;
  const ImageRgba8 sheet = renderViewSheet(shown.renderer(), [&] { ++asked; });
  const std::size_t views = surfaceViews().size(), rows = (views + 3) / 4;
  EXPECT_EQ(asked, views);
  EXPECT_EQ(shown.renderer().view().view, 0);
  ASSERT_EQ(sheet.width, 4 * 20 - 4);
  ASSERT_EQ(sheet.height, static_cast<int>(rows) * 20 - 4);
  std::size_t white = 0;
  for (std::size_t i = 0; i < sheet.pixels.size(); i += 4) {
    const std::size_t x = i / 4 % 76, y = i / 4 / 76;
    const bool gap = x % 20 >= 16 || y % 20 >= 16 || y / 20 * 4 + x / 20 >= views;
    for (std::size_t c = 0; c < 4 && gap; ++c) white += sheet.pixels[i + c] == 255 ? 0 : 1;
  }
  EXPECT_EQ(white, 0u) << "between them";
  for (std::size_t view = 0; view < views; view += 5) {
    shown.renderer().setView({static_cast<int>(view), {}, {}});
    const ImageRgba8 own = shown.renderer().renderDisplay();
    std::size_t wrong = 0;
    for (std::size_t y = 0; y < 16; ++y) {
      for (std::size_t x = 0; x < 16; ++x) {
        const std::size_t at = 4 * ((view / 4 * 20 + y) * 76 + view % 4 * 20 + x);
        wrong +=
            std::equal(&own.pixels[4 * (16 * y + x)], &own.pixels[4 * (16 * y + x)] + 4, &sheet.pixels[at]) ? 0 : 1;
      }
    }
    EXPECT_EQ(wrong, 0u) << view;
  }
}

TEST(SessionPictures, APartOfTheIntegralOverTheBoxIsThatOfTheWhole) {
  LoadedScene loaded = twoRooms();
  OffscreenScene shown(offscreen());
  Camera camera;
  camera.position = {1.0, 1.6, 1.4};
  camera.target = {4.6, 0.4, -1.2};
  shown.show(loaded.scene, loaded.models, {camera});
  shown.capture();
  const ReferenceBoxMaps maps = boxMaps(shown.renderer(), loaded.scene);
  ASSERT_EQ(maps.probes.size(), 1u);
  std::vector<double> told;
  const auto progress = [&](double done) {
    told.push_back(done);
    return true;
  };
  const ReferencePicture whole = integrateBox(shown.renderer(), maps, {15, 10, 4, 32, {}}, progress);
  ASSERT_TRUE(whole.complete);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_NEAR(told.back(), 1.0, 1e-9);
  const ReferencePicture part = integrateBox(shown.renderer(), maps, {15, 10, 4, 32, {3, 2, 11, 7}}, {});
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 15; ++x) {
      const auto at = 4 * static_cast<std::size_t>(15 * y + x);
      const bool within = x >= 3 && x < 11 && y >= 2 && y < 7;
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(part.color.pixels[at + c], within ? whole.color.pixels[at + c] : 0.0f) << x << ", " << y;
      }
    }
  }
  test::KeptValues values;
  values.part("integral over the box");
  for (int y = 0; y < 10; ++y) {
    const float* row = &whole.color.pixels[4 * static_cast<std::size_t>(15 * y)];
    values.add("row " + std::to_string(y), std::vector<float>(row, row + 60));
  }
  values.expect("image/values/box_integral.txt", 0.01);
}

}  // namespace
}  // namespace boxprobe::test
