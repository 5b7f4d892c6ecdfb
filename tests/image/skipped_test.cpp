// What captures and filters leave out, counted, and pictures, maps and files that show nothing of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "data/scenes/glb_writer.h"
#include "data/scenes/scenes.h"
#include "filters/io/cube/cube_file.h"
#include "tests/support/scene_picture.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe::test {
namespace {

constexpr int kWidth = 160, kHeight = 90;

ScenePicture shownRoom() {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", kWidth, kHeight);
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
TEST(Skipped, ALevelThatIsMadeLaterIsTheSame) {
  ScenePicture later = shownRoom(), atOnce = ScenePicture::fromFile("scenes/room.boxprobe.json", kWidth, kHeight);
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
  ScenePicture fresh = ScenePicture::fromFile("scenes/room.boxprobe.json", kWidth, kHeight);
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

using SkippedFiles = TemporaryFolder;

TEST_F(SkippedFiles, ABakedFileHoldsEveryLevel) {
  ScenePicture picture = shownRoom();
  ASSERT_GT(picture.renderer->counters().levelsSkipped, 0u);
  const std::string name = picture.scene.probes[0].name;
  const BakedMaps saved = loadBakedProbe(picture.renderer->saveBaked(name, file(""), "test")).maps;
  ScenePicture whole = ScenePicture::fromFile("scenes/room.boxprobe.json", kWidth, kHeight);
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
    picture.renderer->drawGenerally(generally);
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
