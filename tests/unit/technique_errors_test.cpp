// Probes that measure their techniques' errors themselves: in rooms made up by chance, against the integral at other
// points than those they measure at.
#include "filters/math/technique/technique_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "filters/reference/study/study_tally.h"

namespace boxprobe {
namespace {

using study::RoomPoint;

constexpr int kRooms = 24, kPointsEach = 64;
constexpr double kBudget = 0.04;

const study::RoomPoints& rooms() {
  static const study::RoomPoints points = study::randomPoints(311, kRooms, kPointsEach, 64, 2048);
  return points;
}

double squareAt(const RoomPoint& at, std::size_t candidate) {
  const Technique technique = parseTechnique(measuredTechniques()[candidate].id).value();
  shading::ProbeShape probe = at.probe;
  probe.projection = technique.projection;
  const glm::vec4 value =
      evaluationRows()[static_cast<std::size_t>(technique.evaluation)].evaluate(at.chain, probe, at.point);
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    sum += std::pow(study::displayValue(static_cast<double>(value[k])) - study::displayValue(at.truth[k]), 2.0) / 3.0;
  }
  return sum;
}

std::size_t candidateOf(const AutomaticChoice& choice) {
  std::size_t i = 0;
  while (!(parseTechnique(measuredTechniques()[i].id).value() == choice.technique)) ++i;
  return i;
}

struct Outcome {
  int beyond = 0;  // rooms and roughnesses where the budget is not kept
  double cost = 0.0;
};

TEST(OwnErrors, KeepTheBudgetInRoomsThatTheTableDoesNotKnow) {
  Outcome own, table, hindsight;
  double measured = 0.0, integral = 0.0;
  const std::size_t candidates = measuredTechniques().size();
  for (const auto& chain : rooms().chains) {
    std::vector<std::vector<const RoomPoint*>> byRoughness(study::kRoughnesses);
    for (const RoomPoint& at : rooms().points) {
      if (at.chain == chain.get()) byRoughness[static_cast<std::size_t>(at.roughness)].push_back(&at);
    }
    const TechniqueErrors errors = measureTechniqueErrors(*chain, byRoughness[0].front()->probe);
    for (const auto& points : byRoughness) {
      std::vector<double> square(candidates);
      double ofOwn = 0.0, ofTable = 0.0;
      const auto count = static_cast<double>(points.size());
      for (const RoomPoint* at : points) {
        std::vector<double> here(candidates);
        for (std::size_t k = 0; k < candidates; ++k) here[k] = squareAt(*at, k);
        for (std::size_t k = 0; k < candidates; ++k) square[k] += here[k] / count;
        const double r = static_cast<double>(at->point.roughness);
        const std::size_t byOwn = candidateOf(chooseAutomatic(r, r, kBudget, &errors));
        const std::size_t byTable = candidateOf(chooseAutomatic(r, r, kBudget));
        ofOwn += here[byOwn] / count;
        ofTable += here[byTable] / count;
        own.cost += measuredTechniques()[byOwn].cost / count;
        table.cost += measuredTechniques()[byTable].cost / count;
      }
      own.beyond += std::sqrt(ofOwn) > kBudget ? 1 : 0;
      table.beyond += std::sqrt(ofTable) > kBudget ? 1 : 0;
      std::size_t least = 0;
      while (least + 1 < candidates && std::sqrt(square[least]) > kBudget) ++least;
      hindsight.beyond += std::sqrt(square[least]) > kBudget ? 1 : 0;
      hindsight.cost += measuredTechniques()[least].cost;
      const auto node = static_cast<std::size_t>(&points - byRoughness.data());
      for (std::size_t k = 0; node >= 2 && k < candidates; ++k) {  // the rooms' lower roughnesses are not the nodes'
        integral += square[k];
        measured += errors[k][node] * errors[k][node];
      }
    }
  }
  const int cells = kRooms * study::kRoughnesses;
  std::printf(
      "  beyond a budget of %g: %d of %d by the table at a cost of %.2f, %d by own errors at %.2f, %d by the best "
      "choice in hindsight at %.2f\n",
      kBudget, table.beyond, cells, table.cost / cells, own.beyond, own.cost / cells, hindsight.beyond,
      hindsight.cost / cells);
  std::printf("  measured over the integral's: %.3f\n", std::sqrt(measured / integral));
  EXPECT_LE(own.beyond, table.beyond / 2);
  EXPECT_LE(own.cost, 1.25 * hindsight.cost);
  EXPECT_NEAR(std::sqrt(measured / integral), 1.1, 0.1) << "a tenth is added for what a view may show more of";
}

TEST(OwnErrors, AreTheSameEachTimeAndNoneForAMirror) {
  const RoomPoint& at = rooms().points.front();
  const TechniqueErrors errors = measureTechniqueErrors(*at.chain, at.probe);
  EXPECT_EQ(errors, measureTechniqueErrors(*at.chain, at.probe));
  for (const auto& error : errors) EXPECT_EQ(error.front(), 0.0);
}

}  // namespace
}  // namespace boxprobe
