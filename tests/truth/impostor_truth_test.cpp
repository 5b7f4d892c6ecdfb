// The impostor against an independent path tracer: mirror floors by a few samples and by rays that are followed, over
// the error that the box leaves. Prints the curve of error over steps.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>

#include "app/session/offscreen_scene.h"
#include "app/session/truth_stage.h"

namespace {

using namespace boxprobe;

/// By technique: the root of the sum over the cameras of squared relative errors, on the floor of metal.
std::map<std::string, double> errors(const std::string& scene, double roughness, const std::string& techniques) {
  const TruthIndex index = loadTruthIndex(BOXPROBE_SOURCE_DIR "/tests/truth/truth.json");
  OffscreenScene shown({"impostor_truth_test", kTruthFineness * index.width, kTruthFineness * index.height, 1, true});
  TruthStage stage(index, scene, shown);
  std::map<std::string, double> squares;
  std::map<std::string, std::string> each;
  bool set = false;
  for (const TruthPicture& picture : index.pictures) {
    const bool metal = picture.kind == "metal" || picture.kind == "brass";
    if (picture.whole || picture.scene != scene || picture.roughness != roughness || !metal) continue;
    if (!set) stage.setFloor(picture);
    set = true;
    for (const BenchTechnique& technique : chooseBenchTechniques(techniques)) {
      const TruthRow row = stage.techniqueRow(picture, technique);
      squares[technique.label()] += row.relativeRmse * row.relativeRmse;
      char text[64];
      std::snprintf(text, sizeof text, "  %s %.3f", picture.camera.c_str(), row.relativeRmse);
      each[technique.label()] += text;
    }
  }
  for (auto& [label, square] : squares) {
    square = std::sqrt(square);
    std::printf("  %-9s %.2f  %-28s%s\n", scene.c_str(), roughness, label.c_str(), each[label].c_str());
  }
  return squares;
}

TEST(Truth, AFollowedRayLeavesAThirdOfTheBoxesErrorInTheArcade) {
  auto error = errors("arcade", 0.0,
                      "impostor,impostor:steps=4,impostor:steps=6,impostor:steps=8,impostor:steps=12,impostor:steps=16,"
                      "impostor:steps=24,impostor:steps=64");
  for (const auto& [label, of] : error)
    std::printf("  arcade, mirror: %-20s %.3f of the box's\n", label.c_str(), of / error["box"]);
  EXPECT_LE(error["impostor steps 64"], error["box"] / 3.0);
  EXPECT_LE(error["impostor steps 24"], error["box"] / 3.0);
}

TEST(Truth, AFollowedRayInTheFurnishedRoom) {
  auto error = errors("furnished", 0.0, "impostor,impostor:steps=8,impostor:steps=24,impostor:steps=64");
  for (const auto& [label, of] : error)
    std::printf("  furnished, mirror: %-20s %.3f of the box's\n", label.c_str(), of / error["box"]);
  EXPECT_LE(error["impostor steps 24"], 0.3 * error["box"]);
}

TEST(Truth, AFollowedRayInTheFurnishedRoomRough) {
  auto error = errors("furnished", 0.25, "footprint8,impostor+footprint8,impostor+footprint8:steps=24");
  for (const auto& [label, of] : error)
    std::printf("  furnished, .25: %-30s %.3f of box+footprint8's\n", label.c_str(), of / error["footprint8"]);
  EXPECT_LE(error["impostor+footprint8 steps 24"], 0.5 * error["footprint8"]);
}

TEST(Truth, AFollowedRayInTheEmptyRoomIsTheBoxes) {
  auto error = errors("empty", 0.0, "impostor:steps=24");
  std::printf("  empty, mirror: %.3f of the box's\n", error["impostor steps 24"] / error["box"]);
  EXPECT_LE(error["impostor steps 24"], 1.02 * error["box"]);
}

}  // namespace
