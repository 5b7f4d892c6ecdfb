// The promise over a million inputs, and that the harness notices when it is broken: published forms do break it.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/stress/exact.h"
#include "filters/stress/exact_lamp.h"
#include "filters/stress/stress_run.h"
#include "filters/stress/stress_subjects.h"

namespace boxprobe::stress {
namespace {

const auto kGoOn = [](double) { return true; };

StressPlan planOf(const std::vector<std::string>& subjects, std::uint64_t count) {
  StressPlan plan;
  plan.count = count;
  for (const StressClass& c : stressClasses()) plan.classes.push_back(&c);
  for (const std::string& id : subjects) plan.subjects.push_back(findSubject(id));
  return plan;
}

const StressCell& cellOf(const std::vector<StressCell>& cells, std::string_view inputs, std::string_view subject) {
  for (const StressCell& cell : cells) {
    if (cell.inputs->id == inputs && cell.subject->id == subject) return cell;
  }
  throw std::runtime_error("no such cell");
}

TEST(Stress, AMillionInputsKeepThePromise) {
  StressPlan plan = planOf({}, 1000000);
  for (const auto* subjects : {&techniqueSubjects(), &termSubjects()}) {
    for (const StressSubject& s : *subjects) plan.subjects.push_back(&s);
  }
  std::uint64_t count = 0;
  for (const StressCell& cell : runStress(plan, kGoOn)) {
    count += cell.tally.count;
    EXPECT_EQ(cell.tally.nonFinite, 0u) << cell.inputs->id << " " << cell.subject->id;
    EXPECT_FALSE(cell.broken()) << cell.inputs->id << " " << cell.subject->id << ": input " << cell.tally.worstIndex;
  }
  EXPECT_EQ(count, 1000000u);
}

TEST(Stress, SameForAnyNumberOfThreads) {
  const StressPlan plan = planOf({"box+hdrp", "sphere+footprint4", "term:footprint-scale"}, 400000);
  const auto all = runStress(plan, kGoOn);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto alone = runStress(plan, kGoOn);
  ASSERT_EQ(all.size(), alone.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].tally.worstIndex, alone[i].tally.worstIndex);
    EXPECT_EQ(all[i].tally.worstSeverity, alone[i].tally.worstSeverity);
    for (std::size_t m = 0; m < kMeasures; ++m) {
      EXPECT_EQ(all[i].tally.errors[m].worst(), alone[i].tally.errors[m].worst());
      EXPECT_EQ(all[i].tally.errors[m].quantile(0.9999), alone[i].tally.errors[m].quantile(0.9999));
    }
  }
}

TEST(Stress, StopsWhenAsked) {
  EXPECT_TRUE(runStress(planOf({"box+none"}, 1000000), [](double) { return false; }).empty());
}

// Each published form fails where it is known to fail, so an error in the program's own would be seen.
TEST(Stress, PublishedFormsBreak) {
  StressPlan plan = planOf({}, 400000);
  for (const StressSubject& s : publishedSubjects()) {
    plan.subjects.push_back(&s);
    ASSERT_NE(findSubject(s.counterpart), nullptr) << s.id;
  }
  const auto cells = runStress(plan, kGoOn);
  const auto share = [&](const char* inputs, const char* form, bool numbers) {
    const StressTally& t = cellOf(cells, inputs, form).tally;
    return static_cast<double>(numbers ? t.wrong : t.nonFinite) / static_cast<double>(t.count);
  };
  EXPECT_GT(share("zero-component", "published:box-select", false), 0.3);
  EXPECT_GT(share("sliding", "published:box-max", false), 0.3);
  EXPECT_GT(share("outside", "published:box-max", true), 0.3);
  EXPECT_GT(share("far-1e7", "published:box-world", true), 0.1);
  EXPECT_GT(share("inside", "published:rounded-box", true), 0.05);
  EXPECT_GT(share("tiny", "published:sphere", true), 0.1);
  EXPECT_GT(share("origin-on-wall", "published:distance-ratio", false), 0.1);
  EXPECT_GT(share("tiny", "published:footprint-scale", true), 0.1);
  EXPECT_GT(share("roughness-small", "published:ggx-distribution", true), 0.1);
  EXPECT_GT(share("from-behind", "published:ggx-masking", false), 0.01);
  EXPECT_GT(share("blend-0", "published:blend-weight", false), 0.1);
  EXPECT_GT(share("from-behind", "published:reflection", true), 0.3);
  // And is right where nothing is special.
  EXPECT_EQ(share("inside", "published:box-max", true), 0.0);
  EXPECT_EQ(share("inside", "published:sphere", true), 0.0);
}

// Lamps as shapes: what nearly all inputs of a class are off by, where the class has no bound for each of them. Along
// the horizon an outline has no digits, and a view that lies there sees it; nobody else does.
TEST(Stress, LampsHaveTheirDigits) {
  for (const StressCell& cell :
       runStress(planOf({"term:lamp-diffuse", "term:lamp-glossy", "term:lattice"}, 240000), kGoOn)) {
    if (cell.inputs->held == Held::Finite) continue;
    const std::string_view id = cell.inputs->id;
    const bool flat = id == "grazing-view" || id == "from-behind";
    const ErrorHistogram& off = cell.tally.errors[kRelative];
    if (id == "point" && cell.subject->id != "term:lattice") continue;  // no lamp
    ASSERT_TRUE(off.measured()) << id << " " << cell.subject->id;
    if (cell.subject->id == "term:lamp-glossy" && flat) {
      EXPECT_LT(off.quantile(0.9), 1.0e-3) << id;
    } else {
      EXPECT_LT(off.quantile(0.99), 2.0e-4) << id << " " << cell.subject->id;
    }
  }
}

// The yardstick of lamps, by hand: a square of half side 1 at height 1 over a floor fills 0.1385 of its cosine from a
// corner's foot (Howell C-11) and four times that from its middle.
TEST(Stress, ExactLamps) {
  exact::Lamp square{{{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}}, false};
  const long double quarter = std::atan(1 / std::sqrt(2.0L)) / (std::sqrt(2.0L) * 3.14159265358979323846L);
  EXPECT_NEAR(static_cast<double>(exact::formFactor(square, {0, 0, 0}, {0, 0, 1})), static_cast<double>(4 * quarter),
              1e-15);
  // Half of it below the horizon of a wall, by symmetry: what its upper half gives.
  exact::Lamp upper{{{0, -1, 1}, {0, 1, 1}, {1, 1, 1}, {1, -1, 1}}, false};
  EXPECT_NEAR(static_cast<double>(exact::formFactor(square, {0, 0, 0}, {1, 0, 0})),
              static_cast<double>(exact::formFactor(upper, {0, 0, 0}, {1, 0, 0})), 1e-15);
  EXPECT_NEAR(static_cast<double>(exact::heightOverLamp(square, {0, 0, 0})), 1 / (1e-5 * (2 + std::sqrt(8.0))), 1e-6);
  // A lamp all around a lobe fills it, but for what great arcs miss along the horizon.
  exact::Lamp wide{{{-900, -900, 1}, {-900, 900, 1}, {900, 900, 1}, {900, -900, 1}}, false};
  const auto share = exact::imageShare(wide, {0, 0, 0}, {0, 0, 1}, {0.6L, 0, 0.8L}, 0.2L, 0);
  EXPECT_NEAR(static_cast<double>(share[0] + share[1]), 1.0, 0.02);
}

TEST(Stress, AnInputIsItsNumbers) {
  const StressSubject& subject = *findSubject("box+godot");
  for (const StressClass& c : stressClasses()) {
    const StressInput in = makeInput(c, subject.id, 7, 3, subject.parameters);
    const std::vector<float> numbers = numbersOf(in, subject.parameters);
    EXPECT_EQ(numbers.size(), numberNames(subject.parameters).size());
    const StressInput back = inputFrom(numbers, subject.parameters);
    const std::vector<float> again = numbersOf(back, subject.parameters);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      EXPECT_TRUE(again[i] == numbers[i] || (std::isnan(again[i]) && std::isnan(numbers[i]))) << c.id << i;
    }
    const Trial a = subject.run(in, c, nullptr), b = subject.run(back, c, nullptr);
    EXPECT_EQ(a.severity, b.severity) << c.id;
  }
  EXPECT_THROW(inputFrom({1.0f, 2.0f}, {}), std::invalid_argument);
}

// The yardstick itself, by hand.
TEST(Stress, ExactValues) {
  const exact::BoxExit exit = exact::boxExit({0, 0, 0}, {0.6L, 0, -0.8L}, {-1, -1, -1}, {3, 1, 2});
  EXPECT_EQ(static_cast<double>(exit.distance), 1.25);
  EXPECT_EQ(static_cast<double>(exit.hit[0]), 0.75);
  EXPECT_EQ(static_cast<double>(exit.hit[2]), -1.0);
  const exact::SphereExit sphere = exact::sphereExit({0, 0, 0}, {1, 0, 0}, {-1, -1, -1}, {1, 1, 1});
  EXPECT_NEAR(static_cast<double>(sphere.distance), std::sqrt(3.0), 1e-15);
  // From the middle of a cube a wall's patch is seen from C as from P.
  const exact::BoxExit up = exact::boxExit({0, 0, 0}, {0, 0, 1}, {-1, -1, -1}, {1, 1, 1});
  EXPECT_NEAR(static_cast<double>(
                  exact::solidAngleScaleBox(up.hit, up.distance, up.factors, {0, 0, 1}, {-1, -1, -1}, {1, 1, 1})),
              1.0, 1e-15);
  EXPECT_NEAR(static_cast<double>(exact::ggxDistribution({0, 0, 1}, 0.5L)), 4.0 / 3.14159265358979, 1e-13);
  EXPECT_NEAR(static_cast<double>(exact::ggxMasking(1, 0.3L)), 1.0, 1e-15);
  EXPECT_EQ(ulpsFrom(std::nextafter(1.0f, 2.0f), 1.0L), 1.0);
}

}  // namespace
}  // namespace boxprobe::stress
