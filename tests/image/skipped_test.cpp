// What captures and filters leave out, counted, and pictures, maps and files that show nothing of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "data/scenes/glb_writer.h"
#include "data/scenes/scenes.h"
#include "filters/io/cube/cube_file.h"
#include "filters/vtk/inspect/preview_settings.h"
#include "filters/vtk/maps/probe_maps.h"
#include "tests/support/scene_picture.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe::test {
namespace {

constexpr int kWidth = 160, kHeight = 90;

/// Of one bounce: each capture skips levels of its own.
ScenePicture roomOfOneBounce() {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", kWidth, kHeight);
  picture.scene.probes[0].bounces = 1;
  return picture;
}

ScenePicture shownRoom() {
  ScenePicture picture = roomOfOneBounce();
  picture.show(cameraNamed(picture.scene, "main"));
  return picture;
}

/// With every level of every map.
void filterAll(ScenePicture& picture) {
  for (const Probe& probe : picture.scene.probes) (void)picture.renderer->readMaps(probe.name);
  (void)picture.renderer->readMaps("");
}

int mostDifference(const ImageRgba8& a, const ImageRgba8& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) most = std::max(most, std::abs(a.pixels[i] - b.pixels[i]));
  return most;
}

void edit(ScenePicture& picture, const std::function<void(Scene&)>& change) {
  const Scene before = picture.scene;
  change(picture.scene);
  picture.renderer->sync(picture.scene, difference(before, picture.scene));
  picture.renderer->finishWork();
}

TEST(Skipped, LevelsThatNoMaterialSamplesAreNotFiltered) {
  ScenePicture picture = shownRoom();
  const Counters& counters = picture.renderer->counters();
  EXPECT_GT(counters.levelsSkipped, 0u);
  const std::uint64_t filtered = counters.levelsFiltered, skipped = counters.levelsSkipped;
  const ImageRgba8 before = picture.display();
  EXPECT_EQ(counters.levelsMadeLater, 0u) << "the picture needs no further level";
  filterAll(picture);
  EXPECT_EQ(counters.levelsMadeLater, skipped);
  EXPECT_EQ(counters.levelsFiltered, filtered + skipped);
  EXPECT_LE(mostDifference(before, picture.display()), 1);
}

// Two levels of one capture are far apart only where it has detail: the level made later is compared with one made at
// once, texel for texel.
// So that a window that saves a file goes on answering.
TEST(Skipped, MissingLevelsAreMadeOneAtATime) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 48);
  picture.show(cameraNamed(picture.scene, "main"));
  SceneRenderer& renderer = *picture.renderer;
  const std::uint64_t skipped = renderer.counters().levelsSkipped;
  ASSERT_GT(skipped, 1u);
  std::uint64_t made = 0;
  for (; made < skipped && renderer.filterMissingLevel(picture.scene.probes[0].name); ++made) {
    EXPECT_EQ(renderer.counters().levelsMadeLater, made + 1);
  }
  EXPECT_GT(made, 1u);
  EXPECT_FALSE(renderer.filterMissingLevel(picture.scene.probes[0].name));
}

TEST(Skipped, ALevelThatIsMadeLaterIsTheSame) {
  ScenePicture later = shownRoom(), atOnce = roomOfOneBounce();
  const std::string name = later.scene.probes[0].name;
  atOnce.renderer->setBakeTargets({name});  // files hold every level
  atOnce.show(cameraNamed(atOnce.scene, "main"));
  EXPECT_EQ(atOnce.renderer->counters().levelsSkipped, 0u);
  const BakedMaps a = later.renderer->readMaps(name).value(), b = atOnce.renderer->readMaps(name).value();
  EXPECT_EQ(atOnce.renderer->counters().levelsMadeLater, 0u);
  ASSERT_EQ(a.radiance.levels(), b.radiance.levels());
  for (int level = 0; level < a.radiance.levels(); ++level) {
    const auto count = std::size_t(6) * 4 * a.radiance.levelSize(level) * a.radiance.levelSize(level);
    const float *p = a.radiance.face(level, 0), *q = b.radiance.face(level, 0);
    EXPECT_TRUE(std::equal(p, p + count, q)) << "level " << level;
  }
}

TEST(Skipped, AMaterialThatComesToNeedALevelGetsIt) {
  ScenePicture edited = shownRoom();
  const Counters& counters = edited.renderer->counters();
  const std::uint64_t faces = counters.facesCaptured;
  edit(edited, [](Scene& s) { s.materials["sphere"].roughness = 0.45f; });
  EXPECT_GT(counters.levelsMadeLater, 0u);
  EXPECT_EQ(counters.facesCaptured, faces) << "filtered from the capture that is there";
  ScenePicture fresh = roomOfOneBounce();
  fresh.scene.materials["sphere"].roughness = 0.45f;
  fresh.show(cameraNamed(fresh.scene, "main"));
  EXPECT_EQ(fresh.renderer->counters().levelsMadeLater, 0u);
  EXPECT_LE(mostDifference(edited.display(), fresh.display()), 1);
  const std::uint64_t made = counters.levelsMadeLater;
  edit(edited, [](Scene& s) { s.probes[0].technique = "footprint4"; });
  EXPECT_GT(counters.levelsMadeLater, made) << "a technique that may look up any level";
  EXPECT_EQ(counters.facesCaptured, faces);
}

// A later bounce looks earlier captures up, which are not on show.
TEST(Skipped, ASecondBounceAfterAnEditIsThatOfAFreshScene) {
  const auto twoBounces = [](float roughness) {
    ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", kWidth, kHeight);
    for (auto& [name, object] : picture.scene.objects) object.seenByProbes = true;
    picture.scene.materials["sphere"].roughness = roughness;
    picture.scene.probes[0].bounces = 2;
    picture.show(cameraNamed(picture.scene, "main"));
    return picture;
  };
  ScenePicture edited = twoBounces(0.0f), fresh = twoBounces(0.45f);
  edit(edited, [](Scene& s) { s.materials["sphere"].roughness = 0.45f; });
  const std::string name = fresh.scene.probes[0].name;
  const BakedMaps a = edited.renderer->readMaps(name).value(), b = fresh.renderer->readMaps(name).value();
  for (int level = 0; level < a.radiance.levels(); ++level) {
    const auto count = std::size_t(6) * 4 * a.radiance.levelSize(level) * a.radiance.levelSize(level);
    const float *p = a.radiance.face(level, 0), *q = b.radiance.face(level, 0);
    EXPECT_TRUE(std::equal(p, p + count, q)) << "level " << level;
  }
}

TEST(Skipped, AnExplanationFiltersNothing) {
  ScenePicture picture = shownRoom();
  ASSERT_GT(picture.renderer->counters().levelsSkipped, 0u);
  for (const glm::ivec2& pixel : {glm::ivec2(80, 75), glm::ivec2(80, 45), glm::ivec2(30, 50)}) {
    const Explanation e = picture.renderer->explain(pixel.x, pixel.y, kWidth, kHeight);
    ASSERT_TRUE(e.rendered);
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(e.color[channel], (*e.rendered)[channel], 0.02 * (1.0 + (*e.rendered)[channel]))
          << pixel.x << ", " << pixel.y;
    }
  }
  (void)picture.renderer->explainedMaps(picture.scene.probes[0].name);
  EXPECT_EQ(picture.renderer->counters().levelsMadeLater, 0u);
}

TEST(Skipped, ThePreviewSphereGetsALevelAStep) {
  ScenePicture picture = shownRoom();
  SceneRenderer& renderer = *picture.renderer;
  EXPECT_EQ(renderer.workProgress(), 1.0);
  std::uint64_t before = renderer.counters().levelsMadeLater;
  for (const float roughness : {0.55f, 0.3f}) {  // the second needs levels that the first did not
    renderer.showPreviewSphere({SphereKind::Rough, picture.scene.probes[0].name, roughness});
    (void)picture.display();
    EXPECT_EQ(renderer.counters().levelsMadeLater, before) << "not within the frame";
    ASSERT_TRUE(renderer.workPending()) << roughness;
    std::uint64_t made = 0;
    while (renderer.workPending()) {
      EXPECT_LT(renderer.workProgress(), 1.0);
      before = renderer.counters().levelsMadeLater;
      renderer.step();
      EXPECT_LE(renderer.counters().levelsMadeLater, before + 1);
      made += renderer.counters().levelsMadeLater - before;
    }
    before = renderer.counters().levelsMadeLater;
    EXPECT_GT(made, 0u) << roughness;
    EXPECT_EQ(renderer.workProgress(), 1.0);
  }
  // Gone, it asks for nothing.
  renderer.showPreviewSphere({});
  (void)picture.display();
  EXPECT_FALSE(renderer.workPending());
}

// What a realtime probe sees in a drag may lack levels, which are made once that has ended.
TEST(Skipped, ARealtimeProbeSeesTheLevelsThatADragPutOff) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", kWidth, kHeight);
  for (auto& [name, object] : picture.scene.objects) object.seenByProbes = true;
  Probe live = picture.scene.probes[0];
  // The baked one shows none of what is edited, and so stays: it lacks the levels.
  for (const auto& [name, object] : picture.scene.objects) picture.scene.probes[0].hides.push_back(name);
  live.name = "live";
  live.mode = ProbeMode::Realtime;
  live.bounces = 2;
  picture.scene.probes.push_back(live);
  picture.show(cameraNamed(picture.scene, "main"));
  SceneRenderer& renderer = *picture.renderer;
  renderer.setInteractive(true);
  const std::uint64_t made = renderer.counters().levelsMadeLater;
  edit(picture, [](Scene& s) { s.materials["sphere"].roughness = 0.45f; });
  EXPECT_EQ(renderer.counters().levelsMadeLater, made) << "a drag changes uniforms and no more";
  const std::uint64_t faces = renderer.counters().facesCaptured;
  renderer.setInteractive(false);
  renderer.finishWork();
  EXPECT_GT(renderer.counters().levelsMadeLater, made);
  EXPECT_GE(renderer.counters().facesCaptured, faces + 12) << "as many rounds as it has bounces";
}

/// Texels a side of the room's map once its mirrors are as sharp as a picture of `rows` asks for.
int texelsFor(ScenePicture& picture, int rows) {
  picture.renderer->sharpenMirrors(rows);
  picture.renderer->finishWork();
  return picture.renderer->shownMaps(picture.scene.probes[0].name)->radiance.faceSize();
}

TEST(Skipped, MirrorsGetATexelAPixelAndNoMore) {
  ScenePicture picture = roomOfOneBounce();
  picture.scene.probes[0].faceSize = 16;
  Camera camera = cameraNamed(picture.scene, "main");
  camera.verticalFovDegrees = 60.0;  // a face has as many texels as 1.73 times the rows have pixels
  picture.show(camera);
  const std::pair<int, int> wanted[] = {{9, 16}, {10, 32}, {18, 32}, {19, 64}, {500, 64}};
  for (const auto& [rows, texels] : wanted) EXPECT_EQ(texelsFor(picture, rows), texels) << rows;
  camera.verticalFovDegrees = 30.0;  // 3.73 times
  picture.show(camera);
  for (const auto& [rows, texels] : {std::pair(4, 16), {5, 32}, {8, 32}, {9, 64}}) {
    EXPECT_EQ(texelsFor(picture, rows), texels) << rows;
  }
  camera.parallelHeight = 3.0;  // twice
  picture.show(camera);
  for (const auto& [rows, texels] : {std::pair(8, 16), {9, 32}, {16, 32}, {17, 64}}) {
    EXPECT_EQ(texelsFor(picture, rows), texels) << rows;
  }
  EXPECT_EQ(texelsFor(picture, 0), 16) << "none are asked for";
  // Where nothing shows a mirror of it, the map stays.
  const auto with = [&picture](const std::function<void(Scene&)>& change) {
    const Scene before = picture.scene;
    edit(picture, change);
    const int texels = texelsFor(picture, 17);
    edit(picture, [&](Scene& scene) { scene = before; });
    return texels;
  };
  const auto roughness = [](float value, const char* but) {
    return [value, but](Scene& scene) {
      for (const char* name :
           {"floor", "ceiling", "lamp", "sphere", "wall north", "wall south", "wall east", "wall west"}) {
        scene.materials[name].roughness = std::string(name) == but ? 0.09f : value;
      }
    };
  };
  EXPECT_EQ(with(roughness(0.1f, "")), 16);
  EXPECT_EQ(with(roughness(0.1f, "floor")), 64);
  EXPECT_EQ(with([&](Scene& scene) {
              roughness(0.1f, "floor")(scene);
              scene.objects["floor"].visible = false;
            }),
            16);
  EXPECT_EQ(with([](Scene& scene) { scene.probes[0].technique = "impostor"; }), 16)
      << "its steps are for the distances of the scene's own size";
}

using SkippedFiles = TemporaryFolder;

TEST_F(SkippedFiles, ABakedFileHoldsEveryLevel) {
  ScenePicture picture = shownRoom();
  ASSERT_GT(picture.renderer->counters().levelsSkipped, 0u);
  const std::string name = picture.scene.probes[0].name;
  const BakedMaps saved = loadBakedProbe(picture.renderer->saveBaked(name, file(""), "test")).maps;
  ScenePicture whole = roomOfOneBounce();
  whole.renderer->setBakeTargets({name});
  whole.show(cameraNamed(whole.scene, "main"));
  const BakedMaps expected = whole.renderer->readMaps(name).value();
  ASSERT_EQ(saved.radiance.levels(), expected.radiance.levels());
  for (int level = 0; level < saved.radiance.levels(); ++level) {
    const int size = saved.radiance.levelSize(level);
    const auto count = 24 * size * size;
    EXPECT_TRUE(std::equal(saved.radiance.face(level, 0), saved.radiance.face(level, 0) + count,
                           expected.radiance.face(level, 0)))
        << "level " << level;
  }
}

/// All probes of sixteen rooms, as a bake makes them.
class SkippedRooms : public TemporaryFolder {
 protected:
  ScenePicture baked(bool generally) {
    scenes::Apartments made = scenes::apartments(16, 1);
    write("apartments.glb", scenes::glbBytes(made.model));
    made.scene.models = {{file("apartments.glb")}};
    names_.clear();
    for (Probe& probe : made.scene.probes) {
      probe.faceSize = 32;
      names_.push_back(probe.name);
    }
    ScenePicture picture(made.scene, kWidth, kHeight);
    picture.renderer->useGeneralPrograms(generally);
    picture.renderer->setBakeTargets(names_);
    picture.show(cameraNamed(picture.scene, "main"));
    return picture;
  }
  std::vector<std::string> names_;
};

// In a first capture probes reflect nothing. Programs that look nothing up give the same light.
TEST_F(SkippedRooms, FirstCapturesLookNothingUp) {
  ScenePicture cheap = baked(false), general = baked(true);
  const Counters& counters = cheap.renderer->counters();
  EXPECT_GT(counters.objectsUnlit, counters.facesCaptured) << "most of what a face shows";
  EXPECT_LE(counters.objectsUnlit, counters.objectsCaptured);
  EXPECT_EQ(general.renderer->counters().objectsUnlit, 0u);
  int compared = 0;
  for (const std::string& name : names_) {
    const BakedMaps a = cheap.renderer->readMaps(name).value(), b = general.renderer->readMaps(name).value();
    const float *p = a.radiance.face(0, 0), *q = b.radiance.face(0, 0);
    for (int i = 0; i < 24 * 32 * 32; ++i) {
      ASSERT_LE(std::abs(p[i] - q[i]), 1.0f / 255.0f * std::max(std::abs(q[i]), 0.05f)) << name << ", value " << i;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 20 * 24 * 32 * 32);
}

TEST_F(SkippedRooms, ObjectsOutsideOfAFaceAreNotDrawn) {
  ScenePicture picture = baked(false);
  const Counters& counters = picture.renderer->counters();
  const std::uint64_t all = counters.facesCaptured * picture.renderer->frameReport().objects.size();
  EXPECT_EQ(counters.facesCaptured, 120u);
  EXPECT_EQ(counters.objectsCaptured + counters.objectsCulled, all);
  EXPECT_LT(counters.objectsCaptured, all / 5) << "each probe sees its room and little else";
}

// A single probe's programs are those of the picture: further ones would take longer to compile than they spare.
TEST(Skipped, FewFacesAreCapturedByThePicturesPrograms) {
  ScenePicture picture = shownRoom();
  EXPECT_EQ(picture.renderer->counters().objectsUnlit, 0u);
}

}  // namespace
}  // namespace boxprobe::test
