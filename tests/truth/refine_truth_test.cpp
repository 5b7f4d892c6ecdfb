// Pictures that rest, against an independent path tracer: from the technique's own frame through every stage. Prints
// the error over the stages, and keeps charts of it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/session/offscreen_scene.h"
#include "app/session/truth_stage.h"
#include "tests/support/line_chart.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

/// Of `scene`, pictures of every camera, metals and dielectrics; `accept` is asked for each, and told the last row.
/// `chart`: the name of the picture that is kept of it; empty: none.
template <typename Wanted, typename Judge>
void eachPicture(const std::string& scene, const std::string& technique, const std::vector<int>& stages,
                 const std::string& chart, const Wanted& wanted, const Judge& judge) {
  const TruthIndex index = loadTruthIndex(BOXPROBE_SOURCE_DIR "/tests/truth/truth.json");
  OffscreenScene shown({"refine_truth_test", 2 * index.width, 2 * index.height, 1, true});
  TruthStage stage(index, scene, shown);
  const BenchTechnique own = chooseBenchTechniques(technique).at(0);
  const TruthPicture* set = nullptr;
  std::vector<Curve> curves;
  for (const TruthPicture& picture : index.pictures) {
    if (picture.whole || picture.scene != scene || picture.kind == "coat" || !wanted(picture)) continue;
    if (set == nullptr || set->kind != picture.kind || set->roughness != picture.roughness) stage.setFloor(picture);
    set = &picture;
    std::printf("  %-9s %-10s %-6s %.2f ", scene.c_str(), picture.kind.c_str(), picture.camera.c_str(),
                picture.roughness);
    double left = -1.0;
    std::vector<TruthRow> rows;
    Curve curve{picture.kind + " " + picture.camera + " " + std::to_string(picture.roughness).substr(0, 4), {}, {}};
    for (const int rays : stages) {
      rows.push_back(stage.refinedRow(picture, own, rays, &left));
      const TruthRow& row = rows.back();
      const std::string name = rays == 0 ? "own" : std::to_string(rays);
      std::printf(" %s: %.3f/%.4f", name.c_str(), row.meanLight, row.relativeRmse);
      curve.values.push_back(row.relativeRmse);
    }
    std::printf(", estimated %.4f\n", left);
    judge(picture, rows, left);
    const auto i = static_cast<unsigned>(curves.size());
    for (unsigned c = 0; c < 3; ++c)
      curve.color[c] = static_cast<unsigned char>(40 + (i * (57 + 50 * c) + 90 * c) % 180);
    curves.push_back(curve);
  }
  ASSERT_FALSE(curves.empty());
  if (chart.empty()) return;
  std::vector<double> at;
  for (std::size_t i = 0; i < stages.size(); ++i) at.push_back(static_cast<double>(i));
  std::string abscissa = "stage: the technique's own frame";
  for (std::size_t i = 1; i < stages.size(); ++i) abscissa += ", " + std::to_string(stages[i]) + " rays";
  keepPicture(lineChart("relative RMSE of " + scene + " from " + technique, abscissa, at, curves), chart);
}

/// One row of cameras and roughnesses, or with BOXPROBE_TRUTH_ALL all of them.
bool chosen(const TruthPicture& picture) {
  if (picture.roughness == 0.0) return false;
  if (std::getenv("BOXPROBE_TRUTH_ALL") != nullptr) return true;
  return (picture.camera == "low" && picture.roughness == 0.5) ||
         (picture.camera == "slant" && picture.roughness == 0.1) ||
         (picture.camera == "middle" && picture.roughness == 0.25) ||
         (picture.camera == "steep" && picture.roughness == 0.75);
}

TEST(RefinedTruth, TheEmptyRoomIsTheTruthToThreePercentAndItsLightToOne) {
  eachPicture("empty", "footprint8", {0, 64, 256}, "refined_empty", chosen,
              [](const TruthPicture& picture, const std::vector<TruthRow>& rows, double left) {
                const TruthRow& row = rows.back();
                // What the capture's texels cost stays, however many rays there are.
                for (std::size_t i = 1; i < rows.size(); ++i) {
                  EXPECT_LT(rows[i].relativeRmse, rows[i - 1].relativeRmse + 0.001)
                      << picture.camera << " " << picture.roughness;
                }
                const bool grazing = picture.camera == "low" || picture.camera == "slant";
                EXPECT_LE(row.relativeRmse, grazing ? 0.045 : 0.03) << picture.camera << " " << picture.roughness;
                EXPECT_NEAR(row.meanLight, 1.0, 0.016) << picture.camera << " " << picture.roughness;
                EXPECT_LT(left, 2.5 * row.relativeRmse);
              });
}

TEST(RefinedTruth, ImpostorsFollowTheirRays) {
  const auto mirrors = [](const TruthPicture& picture) {
    return picture.roughness == 0.0 && picture.kind != "dielectric" &&
           (std::getenv("BOXPROBE_TRUTH_ALL") != nullptr || picture.camera == "middle");
  };
  eachPicture("furnished", "impostor", {16, 64, 256}, "", mirrors,
              [](const TruthPicture& picture, const std::vector<TruthRow>& rows, double) {
                const TruthRow& row = rows.back();
                EXPECT_LE(row.relativeRmse, 0.10) << picture.camera;
              });
  eachPicture("arcade", "impostor", {16, 64, 256}, "", mirrors,
              [](const TruthPicture& picture, const std::vector<TruthRow>& rows, double) {
                const TruthRow& row = rows.back();
                EXPECT_LE(row.relativeRmse, 0.17) << picture.camera;
              });
}

// A texel is a pixel: what a mirror's own picture lacks most.
TEST(RefinedTruth, MirrorsHaveTheTexelsThatTheirPixelsAskFor) {
  double own = 0.0, sharp = 0.0;
  const auto mirrors = [](const TruthPicture& picture) { return picture.roughness == 0.0 && picture.kind == "metal"; };
  eachPicture("empty", "footprint8", {0, 64}, "", mirrors,
              [&](const TruthPicture&, const std::vector<TruthRow>& rows, double) {
                own += rows[0].relativeRmse * rows[0].relativeRmse;
                sharp += rows[1].relativeRmse * rows[1].relativeRmse;
              });
  std::printf("  %.3f of the own error\n", std::sqrt(sharp / own));
  EXPECT_LE(sharp, 0.6 * 0.6 * own);
}

// Rough floors of rooms that are not boxes: all pictures together gain at every stage. BOXPROBE_TRUTH_ALL has more.
TEST(RefinedTruth, RoughFloorsOfFurnishedRoomsGainAtEveryStage) {
  const auto few = [](const TruthPicture& picture) {
    if (std::getenv("BOXPROBE_TRUTH_ALL") != nullptr) return chosen(picture);
    return picture.kind != "dielectric" && picture.camera == "steep" && picture.roughness == 0.75;
  };
  for (const char* scene : {"furnished", "arcade"}) {
    std::vector<double> squares(3, 0.0);
    eachPicture(scene, "impostor+footprint8", {0, 64, 256}, std::string("refined_") + scene, few,
                [&](const TruthPicture&, const std::vector<TruthRow>& rows, double) {
                  for (std::size_t i = 0; i < 3; ++i) squares[i] += rows[i].relativeRmse * rows[i].relativeRmse;
                });
    EXPECT_LT(squares[1], squares[0]) << scene;
    EXPECT_LT(squares[2], squares[1]) << scene;
  }
}

}  // namespace
