// What `auto` chooses, for any budget and roughness: nothing that costs more than something else that keeps the budget.
#include "filters/math/technique/automatic.h"

#include <gtest/gtest.h>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {
namespace {

double costOf(Technique technique) {
  for (const MeasuredTechnique& row : measuredTechniques()) {
    if (parseTechnique(row.id) == technique) return row.cost;
  }
  return 0.0;
}

TEST(Automatic, TheTableNamesTechniquesByRisingCost) {
  double before = 0.0;
  for (const MeasuredTechnique& row : measuredTechniques()) {
    ASSERT_TRUE(parseTechnique(row.id)) << row.id;
    EXPECT_FALSE(isAutomatic(*parseTechnique(row.id)));
    EXPECT_GE(row.cost, before) << row.id;
    before = row.cost;
  }
}

TEST(Automatic, AMirrorPaysForNothing) {
  const AutomaticChoice choice = chooseAutomatic(0.0, 0.0, 0.01);
  EXPECT_EQ(techniqueId(choice.technique), "box+none");
  EXPECT_TRUE(choice.withinBudget);
}

TEST(Automatic, ALargerBudgetNeverCostsMore) {
  // No technique keeps a budget of 0 at every roughness: the nearest one's error is the least that one keeps.
  const double smallestBudget = chooseAutomatic(0.0, 1.0, 0.0).error;
  for (double roughness = 0.0; roughness <= 1.0; roughness += 0.05) {
    double before = 1.0e9;
    for (double budget = smallestBudget; budget < 0.2; budget += 0.002) {
      const AutomaticChoice choice = chooseAutomatic(roughness, roughness, budget);
      EXPECT_TRUE(choice.withinBudget);
      EXPECT_LE(choice.error, budget);
      EXPECT_LE(costOf(choice.technique), before);
      before = costOf(choice.technique);
    }
  }
}

TEST(Automatic, ARangeIsAsDearAsItsWorstRoughness) {
  for (double high = 0.1; high <= 1.0; high += 0.1) {
    const AutomaticChoice range = chooseAutomatic(0.0, high, 0.05);
    for (double roughness = 0.0; roughness <= high; roughness += 0.05) {
      EXPECT_GE(costOf(range.technique), costOf(chooseAutomatic(roughness, roughness, 0.05).technique));
    }
  }
}

TEST(Automatic, NoTechniqueWithinTheBudgetGivesTheNearestAndSaysSo) {
  const AutomaticChoice choice = chooseAutomatic(0.5, 0.5, 1.0e-6);
  EXPECT_FALSE(choice.withinBudget);
  for (const MeasuredTechnique& row : measuredTechniques()) EXPECT_GE(row.error[3], choice.error) << row.id;
  Scene scene;
  scene.probes.emplace_back();
  scene.probes[0].technique = "auto";
  scene.probes[0].parameters["budget"] = 1.0e-6;
  const auto remarks = featuresNotUsed(scene);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("no technique stays within"), std::string::npos) << remarks[0];
  scene.probes[0].parameters["budget"] = 0.2;
  EXPECT_TRUE(featuresNotUsed(scene).empty());
}

TEST(Automatic, StandsAlone) {
  EXPECT_TRUE(parseTechnique("auto"));
  EXPECT_EQ(techniqueId(*parseTechnique("auto")), "auto");
  EXPECT_EQ(shortTechniqueId(*parseTechnique("auto")), "auto");
  EXPECT_FALSE(parseTechnique("sphere+auto"));
  Probe probe;
  probe.technique = "auto";
  probe.projection = false;
  EXPECT_EQ(techniqueId(probeTechnique(probe)), "infinite+none");
}

}  // namespace
}  // namespace boxprobe
