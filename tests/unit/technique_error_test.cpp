// How far each evaluation is from the integral it stands for, in rooms that are boxes: the order of the techniques, and
// how much light they gain or lose.
#include <gtest/gtest.h>

#include <map>

#include "filters/math/technique_table.h"
#include "tests/unit/box_room.h"

namespace boxprobe {
namespace {

constexpr int kFaceSize = 64;
constexpr int kRays = 2048;
constexpr int kPointsEach = 40;

TEST(TechniqueErrors, InRoomsThatAreBoxes) {
  std::mt19937 random(11);
  const std::vector<test::BoxRoom> rooms = {{{-2.0, -1.6, -3.0}, {4.0, 1.4, 2.0}, 6.0, 0.08, 20.0},
                                            {{-1.5, -1.0, -2.5}, {2.5, 3.0, 1.5}, 4.0, 0.15, 6.0}};
  const std::vector<float> roughnesses = {0.1f, 0.3f, 0.5f, 0.7f, 1.0f};
  std::map<std::string, std::vector<test::ErrorTally>> tallies;
  for (const test::BoxRoom& room : rooms) {
    const CubeMap chain = test::prefilteredRoom(room, kFaceSize);
    shading::ProbeShape probe{};
    probe.boxMin = glm::vec3(room.low);
    probe.boxMax = glm::vec3(room.high);
    probe.maxLevel = chain.maxLevel();
    probe.projection = parseTechnique("box")->projection;
    probe.parameters = standardParameters();
    for (std::size_t r = 0; r < roughnesses.size(); ++r) {
      for (int i = 0; i < kPointsEach; ++i) {
        const shading::ShadingPoint point = test::pointInRoom(room, roughnesses[r], i, random);
        const glm::dvec3 truth = test::reflectedMean(room, chain, point, kRays);
        for (const EvaluationRow& row : evaluationRows()) {
          auto& of = tallies[std::string(row.id)];
          of.resize(roughnesses.size() + 1);
          const glm::dvec3 value(row.evaluate(&chain, probe, point));
          of[r].add(value, truth);
          of.back().add(value, truth);
        }
      }
    }
  }
  std::printf("  %-12s   error  /hdrp  relative  light | at roughness .1 .3 .5 .7 1\n", "");
  const double hdrp = tallies["hdrp"].back().rmse();
  for (const EvaluationRow& row : evaluationRows()) {
    const auto& of = tallies[std::string(row.id)];
    const test::ErrorTally& all = of.back();
    std::printf("  %-12s  %.4f   %.2f   %.3f    %.3f  |", std::string(row.id).c_str(), all.rmse(), all.rmse() / hdrp,
                all.relativeRmse(), all.lightRatio());
    for (std::size_t r = 0; r < roughnesses.size(); ++r) std::printf(" %.4f (%.2f)", of[r].rmse(), of[r].lightRatio());
    std::printf("\n");
  }
  // Over ten times as many points and faces of 256 texels: .89 .67 .56 .43 .32.
  const std::pair<const char*, double> atMost[] = {
      {"footprint1", 0.93}, {"footprint2", 0.75}, {"footprint4", 0.6}, {"footprint8", 0.47}, {"footprint16", 0.38}};
  double before = hdrp;
  for (const auto& [id, ratio] : atMost) {
    const test::ErrorTally& all = tallies[id].back();
    EXPECT_LE(all.rmse(), ratio * hdrp) << id;
    EXPECT_LT(all.rmse(), before) << id << ": more fetches must buy something";
    EXPECT_NEAR(all.lightRatio(), 1.0, 0.03) << id << ": neither gains nor loses light";
    before = all.rmse();
  }
}

}  // namespace
}  // namespace boxprobe
