// A million adversarial inputs through the shaders that draw: every result is a number, and C++ agrees.
#include "filters/stress_gpu/stress_gpu.h"

#include <gtest/gtest.h>

#include "filters/stress/stress_subjects.h"
#include "tests/support/gpu_window.h"

namespace boxprobe {
namespace {

using namespace stress;

TEST(StressGpu, AMillionInputsGiveNumbersAndCppAgrees) {
  const auto window = test::makeWindow();
  StressPlan plan;
  plan.count = 1000000;
  for (const StressClass& c : stressClasses()) plan.classes.push_back(&c);
  for (const auto* subjects : {&techniqueSubjects(), &termSubjects()}) {
    for (const StressSubject& s : *subjects) plan.subjects.push_back(&s);
  }
  std::uint64_t count = 0;
  for (const StressCell& cell : runStressGpu(window, plan, [](double) { return true; })) {
    const StressTally& t = cell.tally;
    count += t.count;
    EXPECT_EQ(t.nonFinite, 0u) << cell.inputs->id << " " << cell.subject->id << ": input " << t.worstIndex;
    // Where nothing is special the two sides differ by what a driver's logarithms and roots differ.
    if (cell.inputs->id != "inside") continue;
    const double share = 0.99;
    EXPECT_LE(t.errors[kBoxSizes].quantile(share), 3e-6) << cell.subject->id;
    EXPECT_LE(t.errors[kLevels].quantile(share), 1e-3) << cell.subject->id;
    EXPECT_LE(t.errors[kRelative].quantile(share), 1e-3) << cell.subject->id;
  }
  EXPECT_EQ(count, plan.count);
}

}  // namespace
}  // namespace boxprobe
