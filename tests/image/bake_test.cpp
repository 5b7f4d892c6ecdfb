// What is made again after which edit and in the next run, and probes that are made from a picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "filters/io/cube/bake_folder.h"
#include "filters/io/image/image_file.h"
#include "tests/image/quad_world.h"
#include "tests/support/rgbm_encoder.h"

namespace boxprobe::test {
namespace {

using ::testing::HasSubstr;

class Folder {
 public:
  Folder() { std::filesystem::remove_all(path()); }
  ~Folder() { std::filesystem::remove_all(path()); }
  static std::string path() { return ::testing::TempDir() + "boxprobe-bake-test"; }
};

Model room(const std::string& name, float x) {
  Model model;
  addSquare(model, name + " floor", {x, -1, 0}, {1, 0, 0}, {0, 0, -1}, mirror());
  addSquare(model, name + " wall", {x, 0, -1}, {1, 0, 0}, {0, 1, 0}, glowing({x + 3.0f, 1.0f, 0.5f}));
  return model;
}

/// Two probes that light each other's view, and a third far off that sees as far as its own room.
Scene threeProbes() {
  Scene scene = darkScene();
  scene.probes = {cubeProbe("near", {0.0, 0.0, 0.0}, 1.2), cubeProbe("next", {2.0, 0.0, 0.0}, 1.2),
                  cubeProbe("far", {100.0, 0.0, 0.0}, 1.2)};
  for (Probe& probe : scene.probes) {
    probe.bounces = 2;
    probe.farDistance = 10.0;
  }
  return scene;
}

QuadWorld threeRooms() {
  return QuadWorld(threeProbes(), {room("a", 0.0f), room("b", 2.0f), room("c", 100.0f)});
}

std::vector<std::string> saveAll(QuadWorld& world) {
  std::vector<std::string> files;
  for (const char* name : {"near", "next", "far", ""}) {
    files.push_back(world.renderer->saveBaked(name, Folder::path(), "test"));
  }
  return files;
}

TEST(Bake, AnEditMakesWhatShowsItAgainAndNothingElse) {
  QuadWorld world = threeRooms();
  world.show();
  EXPECT_EQ(world.faces() + world.reused(), 3u * 12u);
  std::uint64_t faces = world.faces(), reused = world.reused(), levels = world.levels();
  world.editAndFinish([](Scene& s) { s.exposure = 2.0; });
  EXPECT_EQ(world.faces() + world.reused(), faces + reused);
  EXPECT_EQ(world.levels(), levels);
  world.editAndFinish([](Scene& s) {
    s.probes[0].box.max.y += 0.3;
    s.probes[0].influence = Box{{-3, -3, -3}, {3, 3, 3}};  // lights what it did not light before
    s.probes[1].blendDistance.min.x = 0.2;
    s.probes[1].technique = "sphere";
    s.probes[2].importance = 3.0;
    s.probes[2].intensity = 0.5;
  });
  EXPECT_EQ(world.faces() + world.reused(), faces + reused + 3u * 6u) << "second bounces alone";
  EXPECT_GT(world.levels(), levels);
  faces = world.faces();
  reused = world.reused();

  world.editAndFinish([](Scene& s) { s.probes[2].rotationDegrees.y = 10.0; });
  EXPECT_EQ(world.faces() + world.reused() - faces - reused, 12u) << "the cube's axes turn with the box";
  faces = world.faces();
  reused = world.reused();
  world.editAndFinish([](Scene& s) { s.probes[2].rotationDegrees.y = 0.0; });
  EXPECT_EQ(world.faces() + world.reused(), faces + reused) << "as it was";

  const auto made = [&](const char* name) { return world.renderer->readMaps(name)->radiance.texel(0, 5, 16, 16); };
  const glm::vec4 far = made("far");
  world.editAndFinish([](Scene& s) { s.probes[2].origin.x += 0.25; });
  EXPECT_EQ(world.faces() + world.reused() - faces - reused, 12u) << "no bounce of another shows it";
  EXPECT_EQ(made("far").y, far.y);
  faces = world.faces();
  reused = world.reused();
  world.editAndFinish([](Scene& s) { s.probes[0].origin.x += 0.25; });
  EXPECT_LE(world.faces() - faces, 12u + 6u) << "its neighbour's first bounce is there";
  EXPECT_EQ(world.faces() + world.reused() - faces - reused, 12u + 6u);

  faces = world.faces();
  world.editAndFinish([](Scene& s) { s.probes[2].name = "renamed"; });
  EXPECT_EQ(world.faces(), faces);
  world.renderer->requestBake({"renamed"});
  EXPECT_NE(world.renderer->bakeState("renamed"), BakeState::UpToDate);
  world.renderer->finishWork();
  EXPECT_EQ(world.renderer->bakeState("renamed"), BakeState::UpToDate);
  EXPECT_EQ(world.faces(), faces + 12) << "asked for although nothing changed";
}

TEST(Bake, FilesStandInForCapturesWhileTheirInputsHold) {
  const Folder folder;
  std::optional<BakedMaps> baked;
  {
    QuadWorld world = threeRooms();
    world.scene.probes[0].rotationDegrees.y = 12.5;
    world.show();
    for (const std::string& file : saveAll(world)) EXPECT_TRUE(std::filesystem::exists(file)) << file;
    baked = world.renderer->readMaps("near");
  }
  QuadWorld world = threeRooms();
  world.renderer->useBakedFiles(Folder::path());
  world.scene.probes[0].rotationDegrees.y = 12.5;
  world.scene.exposure = 0.7;
  world.show();
  EXPECT_EQ(world.faces(), 0u);
  EXPECT_EQ(world.levels(), 0u);
  EXPECT_EQ(world.renderer->counters().skyFacesCaptured, 0u);
  EXPECT_EQ(world.renderer->counters().mapsLoaded, 4u);
  EXPECT_EQ(world.renderer->bakeState("near"), BakeState::FromFile);
  const auto loaded = world.renderer->readMaps("near");
  ASSERT_TRUE(loaded && baked);
  for (int level = 0; level < loaded->radiance.levels(); ++level) {
    EXPECT_EQ(loaded->radiance.texel(level, 5, 1, 2), baked->radiance.texel(level, 5, 1, 2)) << level;
  }
  EXPECT_EQ(loaded->distance.texel(0, 5, 16, 16), baked->distance.texel(0, 5, 16, 16));
  EXPECT_EQ(loaded->irradiance, baked->irradiance);
  EXPECT_EQ(loaded->capturedRotation, glm::dvec3(0.0, 12.5, 0.0));

  world.editAndFinish([](Scene& s) { s.materials["a wall"].emissive = glm::vec3(5.0f); });
  EXPECT_GT(world.faces(), 0u);

  // A file that is damaged behind its header is as good as none.
  QuadWorld third = threeRooms();
  third.scene.probes[0].rotationDegrees.y = 12.5;
  const std::string file = Folder::path() + "/" + BakeFolder::fileName("far");
  third.renderer->useBakedFiles(Folder::path());
  std::filesystem::resize_file(file, std::filesystem::file_size(file) * 2 / 3);
  third.show();
  EXPECT_GT(third.faces(), 0u);
  EXPECT_EQ(third.renderer->counters().mapsLoaded, 3u);
}

TEST(Bake, EveryInputOfACaptureCounts) {
  QuadWorld world(threeProbes(), {room("a", 0.0f)});
  for (Probe& probe : world.scene.probes) probe.bounces = 1;
  world.show();
  const auto recaptures = [&](const auto& change) {
    const std::uint64_t before = world.faces() + world.reused();
    world.editAndFinish(change);
    return world.faces() + world.reused() - before;
  };
  EXPECT_GE(recaptures([](Scene& s) { s.probes[0].nearDistance = 0.5; }), 6u);
  EXPECT_GE(recaptures([](Scene& s) { s.probes[0].rotationDegrees.x = 5.0; }), 6u);
  EXPECT_GE(recaptures([](Scene& s) { s.probes[0].farDistance = 5.0; }), 6u);
  EXPECT_GE(recaptures([](Scene& s) { s.probes[0].clear = glm::vec3(1.0f, 0.0f, 0.0f); }), 6u);
  EXPECT_GE(recaptures([](Scene& s) { s.probes[0].clear = ClearToNone{}; }), 6u);
  EXPECT_GE(recaptures([](Scene& s) { s.probes[0].faceSize = 16; }), 6u);
  EXPECT_GE(recaptures([](Scene& s) { s.probes[0].samplesPerPixel = 16; }), 6u);
  EXPECT_GE(recaptures([](Scene& s) { s.probes[0].hides = {"a wall"}; }), 6u);
  EXPECT_GE(recaptures([](Scene& s) { s.lights.push_back(Light{}); }), 6u);
  EXPECT_GE(recaptures([](Scene& s) { s.sky = SkyColor{{0.1f, 0.2f, 0.3f}}; }), 6u);
  EXPECT_GE(recaptures([](Scene& s) { s.models[0].translation.y = 0.1; }), 6u);
  EXPECT_EQ(recaptures([](Scene& s) { s.cameras.push_back(Camera{}); }), 0u);
}

// Each shows in the texels, or it would be captured again in vain.
TEST(Bake, DepthRangeBackgroundAndHiddenObjectsShow) {
  QuadWorld world(threeProbes(), {room("a", 0.0f)});
  const auto towardsWall = [&](const auto& change) {
    world.scene = threeProbes();
    world.scene.models = {{"model 1", {}, {}}};
    change(world.scene.probes[0]);
    world.show();
    return world.renderer->readMaps("near")->radiance.fetch({0, 0, -1}, 0.0f);
  };
  world.scene.sky = SkyColor{{0.0f, 0.0f, 9.0f}};
  EXPECT_NEAR(towardsWall([](Probe&) {}).x, 3.0f, 0.01f);
  EXPECT_EQ(towardsWall([](Probe& p) { p.nearDistance = 1.5; }).x, 0.0f);
  EXPECT_EQ(towardsWall([](Probe& p) { p.farDistance = 0.5; }).x, 0.0f);
  EXPECT_EQ(towardsWall([](Probe& p) { p.hides = {"a wall"}; }).x, 0.0f);
  const glm::vec4 color = towardsWall([](Probe& p) {
    p.hides = {"a wall"};
    p.clear = glm::vec3(0.25f, 0.5f, 1.0f);
  });
  EXPECT_EQ(glm::vec3(color), glm::vec3(0.25f, 0.5f, 1.0f));
  const glm::vec4 none = towardsWall([](Probe& p) {
    p.hides = {"a wall"};
    p.clear = ClearToNone{};
  });
  EXPECT_EQ(none, glm::vec4(0.0f));
}

TEST(Custom, APictureTakesThePlaceOfACapture) {
  const Folder folder;
  std::filesystem::create_directories(Folder::path());
  const std::string file = Folder::path() + "/blue above.exr";
  ImageRgbaF picture{64, 32, std::vector<float>(64 * 32 * 4, 1.0f)};
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      const glm::vec4 value = y < 16 ? glm::vec4(0, 0, 7, 1) : glm::vec4(2, 0, 0, 1);
      for (int c = 0; c < 4; ++c) picture.pixels[static_cast<std::size_t>((y * 64 + x) * 4 + c)] = value[c];
    }
  }
  saveExr(file, picture);
  Scene scene = darkScene();
  scene.probes = {cubeProbe("hdri", glm::dvec3(0.0), 1.2)};
  scene.probes[0].mode = ProbeMode::Custom;
  scene.probes[0].image = file;
  QuadWorld world(scene, {room("a", 0.0f)}, 9, 9);
  world.show();
  EXPECT_EQ(world.renderer->pictureError(), "");
  EXPECT_EQ(world.faces(), 0u);
  EXPECT_GT(world.levels(), 0u);
  const auto floor = [&] { return world.look({0.0, 1.0, 0.01}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0}); };
  EXPECT_NEAR(floor().z, 7.0f, 0.1f) << "the floor mirrors the upper half";

  // A picture that cannot be read leaves the one before.
  world.editAndFinish([](Scene& s) { s.probes[0].image = Folder::path() + "/missing.exr"; });
  EXPECT_THAT(world.renderer->pictureError(), HasSubstr("probes.hdri.image: "));
  EXPECT_THAT(world.renderer->pictureError(), HasSubstr("missing.exr"));
  EXPECT_NEAR(floor().z, 7.0f, 0.1f);
  std::ofstream(Folder::path() + "/missing.exr") << "no picture";
  world.renderer->requestBake({"hdri"});
  EXPECT_THAT(world.renderer->pictureError(), HasSubstr("missing.exr"));
  world.editAndFinish([&](Scene& s) { s.probes[0].image = file; });
  EXPECT_EQ(world.renderer->pictureError(), "");
  EXPECT_EQ(world.faces(), 0u);
}

TEST(Custom, ACodedPictureGivesTheProbeThatItsRadianceGives) {
  const Folder folder;
  std::filesystem::create_directories(Folder::path());
  const std::string plain = Folder::path() + "/light.exr", coded = Folder::path() + "/light.png";
  ImageRgbaF radiance{64, 32, {}};
  ImageRgba8 rgbm;
  rgbm.width = 64;
  rgbm.height = 32;
  for (int i = 0; i < 64 * 32; ++i) {
    const float up = 1.0f - static_cast<float>(i / 64) / 31.0f, around = static_cast<float>(i % 64) / 63.0f;
    const glm::vec3 value = glm::vec3(0.2f + 20.0f * up * up, 0.5f + 4.0f * up, 0.4f + 3.0f * around * (1.0f - around));
    radiance.pixels.insert(radiance.pixels.end(), {value.r, value.g, value.b, 1.0f});
    const RgbmTexel texel = encodeRgbm(value, {34.493242f, 2.2f, true});
    rgbm.pixels.insert(rgbm.pixels.end(), texel.begin(), texel.end());
  }
  saveExr(plain, radiance);
  savePng(coded, rgbm);
  Scene scene = darkScene();
  scene.probes = {cubeProbe("hdri", glm::dvec3(0.0), 1.2)};
  scene.probes[0].mode = ProbeMode::Custom;
  scene.probes[0].image = plain;
  QuadWorld world(scene, {room("a", 0.0f)}, 9, 9);
  world.show();
  const auto floor = [&] { return glm::vec3(world.look({0.0, 1.0, 0.01}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0})); };
  const glm::vec3 truth = floor();
  ASSERT_GT(truth.r, 5.0f) << "brighter than eight bits hold as they are";

  world.editAndFinish([&](Scene& s) {
    s.probes[0].image = coded;
    s.probes[0].encoding = ImageEncoding::Rgbm;
  });
  EXPECT_EQ(world.renderer->pictureError(), "");
  const glm::vec3 decoded = floor();
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(decoded[c], truth[c], 0.0045f * truth.r);

  // Another instruction is another radiance: the probe is filtered again, without a capture.
  const std::uint64_t levels = world.levels();
  world.editAndFinish([](Scene& s) { s.probes[0].decode = glm::dvec2(2.0 * 34.493242, 2.2); });
  EXPECT_GT(world.levels(), levels);
  EXPECT_EQ(world.faces(), 0u);
  const glm::vec3 doubled = floor();
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(doubled[c], 2.0f * decoded[c], 2e-3f * doubled[c]);

  // An encoding that the file cannot have leaves the picture and says so.
  world.editAndFinish([&](Scene& s) { s.probes[0].image = plain; });
  EXPECT_THAT(world.renderer->pictureError(), HasSubstr("light.exr: holds radiance as it is"));
  EXPECT_EQ(floor(), doubled);
}

TEST(BakeFolder, NamesOfAnyProbeAreNamesOfFiles) {
  EXPECT_EQ(BakeFolder::fileName("room 2"), "room 2.exr");
  EXPECT_EQ(BakeFolder::fileName("../a/b"), "%2E.%2Fa%2Fb.exr");
  EXPECT_EQ(BakeFolder::fileName("_sky"), "%5Fsky.exr");
  EXPECT_EQ(BakeFolder::fileName(""), "_sky.exr");
  EXPECT_EQ(BakeFolder::besideScene("a/room.boxprobe.json"), "a/room.probes");
  EXPECT_EQ(BakeFolder::besideScene("a/room.glb"), "a/room.probes");
}

}  // namespace
}  // namespace boxprobe::test
