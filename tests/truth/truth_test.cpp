// The references against an independent path tracer: Cycles' pictures of the scenes in this folder, see README.md.
// Prints what `boxprobe bench --truth` prints of the references, made at fewer pixels.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "app/session/offscreen_scene.h"
#include "app/session/truth_stage.h"
#include "filters/core/base/errors.h"
#include "filters/io/files/read_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/reference/measure/metrics.h"

namespace {

using namespace boxprobe;

const std::string kFolder = BOXPROBE_SOURCE_DIR "/tests/truth";

OffscreenScene& sharedWindow() {
  static OffscreenScene shown({"truth_test", 64, 36, 1, true});
  return shown;
}

const TruthIndex& truth() {
  static const TruthIndex index = loadTruthIndex(kFolder + "/truth.json");
  return index;
}

// The plan says what is to be there: a picture that was left out would not be missed by a test of those that are.
TEST(Truth, EveryPictureOfThePlanIsThereAndQuiet) {
  const nlohmann::json plan = nlohmann::json::parse(readWholeFile(kFolder + "/plan.json"));
  std::set<std::tuple<std::string, std::string, std::string, double>> made;
  double loudest = 0.0;
  for (const TruthPicture& picture : truth().pictures) {
    EXPECT_NO_THROW(loadTruthPicture(truth(), picture));
    if (picture.whole) continue;
    made.emplace(picture.scene, picture.camera, picture.kind, picture.roughness);
    EXPECT_GT(picture.noise, 0.0) << picture.file << ": two seeds cannot agree exactly";
    EXPECT_LE(picture.noise, plan["noise"].get<double>()) << picture.file;
    loudest = std::max(loudest, picture.noise);
  }
  std::size_t wanted = 0;
  for (const auto& [scene, metal] : plan["scenes"].items()) {
    const std::vector<Camera> cameras = loadSceneFile(truth().scenePath(scene)).cameras;
    for (const char* camera : {"low", "slant", "middle", "steep"}) {
      EXPECT_EQ(std::count_if(cameras.begin(), cameras.end(), [&](const Camera& c) { return c.name == camera; }), 1);
      for (const std::string& kind : {metal.get<std::string>(), std::string("dielectric"), std::string("coat")}) {
        for (const double roughness : plan["roughness"]) {
          ++wanted;
          EXPECT_EQ(made.count({scene, camera, kind, roughness}), 1u)
              << scene << ", " << camera << ", " << kind << ", roughness " << roughness;
        }
      }
    }
  }
  EXPECT_EQ(made.size(), wanted);
  std::printf("  %zu pictures, relative noise %.4f at most\n", made.size(), loudest);
}

ImageRgbaF leftToRight(ImageRgbaF image) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width / 2; ++x) {
      const auto at = [&](int column) { return image.pixels.begin() + 4 * (y * image.width + column); };
      std::swap_ranges(at(x), at(x) + 4, at(image.width - 1 - x));
    }
  }
  return image;
}

// Walls, furniture and sky as the camera sees them: both renderers read the same model and sky the same way round.
TEST(Truth, BothRenderersSeeTheSameScene) {
  for (const TruthPicture& picture : truth().pictures) {
    if (!picture.whole) continue;
    TruthStage stage(truth(), picture.scene, sharedWindow());
    stage.setFloor(picture);
    const ImageRgbaF seen = loadTruthPicture(truth(), picture);
    constexpr int kFineness = 6;  // lamps have hard edges
    ReferenceSettings settings;
    settings.width = kFineness * truth().width;
    settings.height = kFineness * truth().height;
    const ImageRgbaF traced =
        boxAveraged(stage.reference().render(stage.camera(picture.camera), settings).color, kFineness);
    const PictureError same = pictureError(traced, seen), mirrored = pictureError(leftToRight(traced), seen);
    std::printf("  %-10s tone-mapped RMSE %.4f, left and right swapped %.4f; light %.4f\n", picture.scene.c_str(),
                same.toneMappedRmse, mirrored.toneMappedRmse, same.brightnessRatio);
    EXPECT_LT(same.toneMappedRmse, 0.004) << picture.scene;
    EXPECT_GT(mirrored.toneMappedRmse, 20.0 * same.toneMappedRmse) << picture.scene;
    EXPECT_NEAR(same.brightnessRatio, 1.0, 0.005) << picture.scene;
  }
}

TEST(Truth, ReferencesHoldToCycles) {
  std::vector<const TruthPicture*> pictures;
  for (const TruthPicture& picture : truth().pictures) {
    if (!picture.whole) pictures.push_back(&picture);
  }
  std::stable_sort(pictures.begin(), pictures.end(), [](const TruthPicture* a, const TruthPicture* b) {
    return std::tie(a->scene, a->kind, a->roughness) < std::tie(b->scene, b->kind, b->roughness);
  });
  std::vector<TruthRow> rows;
  std::unique_ptr<TruthStage> stage;
  std::string scene;
  for (const TruthPicture* picture : pictures) {
    if (picture->scene != scene) stage = std::make_unique<TruthStage>(truth(), scene = picture->scene, sharedWindow());
    // A coat is a dielectric's interface: two roughnesses tell whether it is drawn as one.
    if (picture->kind == "coat" && picture->roughness != 0.25 && picture->roughness != 0.75) continue;
    stage->setFloor(*picture);
    const TruthEffort effort{256, 7};
    rows.push_back(stage->sceneRow(*picture, effort));
    if (truth().isBox(scene)) rows.push_back(stage->boxRow(*picture, effort));
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const TruthRow& a, const TruthRow& b) { return a.technique > b.technique; });
  std::fputs(truthTable(truth(), rows).c_str(), stdout);
  for (const TruthRow& row : rows) {
    const std::string where = row.technique + ", " + row.scene + ", " + row.kind + ", " + row.camera + ", roughness " +
                              std::to_string(row.roughness);
    // Fewer pixels and rays than `bench --truth` takes: their noise comes on top, and is small by itself.
    EXPECT_LE(std::abs(row.meanLight - 1.0), row.largestLightError() + 2.0 * row.lightNoise) << where;
    EXPECT_LT(row.lightNoise, 0.02) << where;
    EXPECT_LE(row.relativeRmse, row.largestRmse()) << where;
  }
}

// Lamps drawn by their shapes, the rest of the room by footprints: nearer than footprints of lamps in the map.
TEST(Truth, FootprintsBesideLampsAsShapes) {
  OffscreenScene shown({"truth_test", kTruthFineness * truth().width, kTruthFineness * truth().height, 1, true});
  const auto errors = [&shown](const char* lamps) {
    TruthStage stage(truth(), "empty", shown, {}, {std::string("lamps=") + lamps});
    std::vector<TruthRow> rows;
    for (const double roughness : {0.25, 0.5, 1.0}) {
      for (const TruthPicture& picture : truth().pictures) {
        const bool floor = picture.kind == "metal" || picture.kind == "dielectric";
        const bool chosen = picture.scene == "empty" && (picture.camera == "low" || picture.camera == "middle");
        if (picture.whole || !chosen || !floor || picture.roughness != roughness) continue;
        stage.setFloor(picture);
        rows.push_back(stage.techniqueRow(picture, chooseBenchTechniques("footprint8").front()));
      }
    }
    std::sort(rows.begin(), rows.end(), [](const TruthRow& a, const TruthRow& b) {
      return std::tie(a.kind, a.camera, a.roughness) < std::tie(b.kind, b.camera, b.roughness);
    });
    return rows;
  };
  const std::vector<TruthRow> shapes = errors("shapes"), inMap = errors("in-map");
  ASSERT_EQ(shapes.size(), 12u);
  ASSERT_EQ(inMap.size(), 12u);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const TruthRow& row = shapes[i];
    std::printf("  %-10s %-6s roughness %.2f: light %.3f, RMSE %.3f; lamps in the map %.3f, %.3f\n", row.kind.c_str(),
                row.camera.c_str(), row.roughness, row.meanLight, row.relativeRmse, inMap[i].meanLight,
                inMap[i].relativeRmse);
    EXPECT_LE(row.relativeRmse, 0.07) << row.kind << ", " << row.camera << ", " << row.roughness;
    EXPECT_NEAR(row.meanLight, 1.0, 0.02) << row.kind << ", " << row.camera << ", " << row.roughness;
    EXPECT_LT(row.relativeRmse, inMap[i].relativeRmse) << row.kind << ", " << row.camera << ", " << row.roughness;
  }
}

TEST(Truth, AMissingFileSaysHowToMakeIt) {
  const auto message = [](const auto& action) -> std::string {
    try {
      action();
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing was thrown";
  };
  EXPECT_EQ(message([] { loadTruthIndex("/nowhere/truth.json"); }),
            "/nowhere/truth.json: there is no such file; make it with tests/truth/make.sh, which needs Blender 4.1 or "
            "later");
  TruthPicture gone = truth().pictures.at(0);
  gone.file = "gone.exr";
  EXPECT_THAT(message([&] { loadTruthPicture(truth(), gone); }),
              ::testing::EndsWith("gone.exr: there is no such picture; make it with tests/truth/make.sh, which needs "
                                  "Blender 4.1 or later"));
  EXPECT_THAT(message([] { loadTruthIndex(kFolder + "/plan.json"); }), ::testing::HasSubstr("not a truth file"));
}

}  // namespace
