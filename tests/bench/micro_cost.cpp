// bench_micro: nanoseconds of the projection mathematics on the CPU, by Google Benchmark: each of the program's own
// forms beside the published one, compiled alike into this file, and every technique of the table. For a ratio with its
// interval of two forms run it with --benchmark_enable_random_interleaving=true --benchmark_repetitions=20, or
// bench_robust for frames.
#include <benchmark/benchmark.h>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "filters/math/technique/technique_table.h"
#include "filters/stress/stress_map.h"
#include "filters/stress/stress_subjects.h"

// Both sides inlined, or a call's own cost would hide what is measured.
namespace boxprobe::shading::inlined {

using glm::abs;
using glm::clamp;
using glm::cos;
using glm::dot;
using glm::length;
using glm::max;
using glm::min;
using glm::mix;
using glm::sin;
using glm::sqrt;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-function"
namespace {
#include "shaders/published/blend.glsl"
#include "shaders/published/box_max.glsl"
#include "shaders/published/box_select.glsl"
#include "shaders/published/distance_ratio.glsl"
#include "shaders/published/ggx.glsl"
#include "shaders/published/rounded_box.glsl"
#include "shaders/published/sphere.glsl"
#include "shaders/shared/finite.glsl"
#include "shaders/shared/ggx.glsl"
#include "shaders/shared/rounded_box.glsl"
#include "shaders/shared/slab.glsl"
#include "shaders/shared/weights.glsl"
#include "shaders/technique/projection_box.glsl"
#include "shaders/technique/projection_sphere.glsl"
}  // namespace
#pragma GCC diagnostic pop

}  // namespace boxprobe::shading::inlined

namespace {

using namespace boxprobe;
using namespace boxprobe::stress;
namespace forms = shading::inlined;

constexpr std::size_t kInputs = 4096;  // 1 MB: stays in the second-level cache

const std::vector<LocalInput>& inputs() {
  static const std::vector<LocalInput> all = [] {
    std::vector<LocalInput> made;
    for (std::size_t i = 0; i < kInputs; ++i)
      made.push_back(localInput(makeInput(stressClasses().front(), "bench", 1, i, {})));
    return made;
  }();
  return all;
}

template <typename Form>
void overInputs(benchmark::State& state, const Form& form) {
  const std::vector<LocalInput>& all = inputs();
  for (auto _ : state) {
    for (const LocalInput& in : all) benchmark::DoNotOptimize(form(in));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kInputs));
}

template <typename Form>
void add(const std::string& name, const Form& form) {
  benchmark::RegisterBenchmark(name.c_str(), [form](benchmark::State& state) { overInputs(state, form); });
}

glm::vec4 hitOf(const shading::ProbeHit& hit) {
  return {hit.direction, hit.distance};
}

void addForms() {
  add("box/own", [](const LocalInput& in) {
    return hitOf(forms::projectBox(in.probe, in.point.position, in.point.normal, in.point.reflection));
  });
  add("box/published max", [](const LocalInput& in) {
    return hitOf(forms::publishedBoxMax(in.probe, in.point.position, in.point.reflection));
  });
  add("box/published select", [](const LocalInput& in) {
    return hitOf(forms::publishedBoxSelect(in.probe, in.point.position, in.point.reflection));
  });
  add("rounded box/own", [](const LocalInput& in) {
    const glm::vec3 f = forms::slabFactors(in.point.position, in.point.reflection, in.probe.boxMin, in.probe.boxMax);
    return forms::roundedBoxExit(in.point.position, in.point.reflection, in.probe.boxMin, in.probe.boxMax,
                                 in.probe.bevel, glm::min(glm::min(f.x, f.y), f.z));
  });
  add("rounded box/published", [](const LocalInput& in) {
    return hitOf(forms::publishedRoundedBox(in.probe, in.point.position, in.point.reflection));
  });
  add("sphere/own", [](const LocalInput& in) {
    return hitOf(forms::projectSphere(in.probe, in.point.position, in.point.normal, in.point.reflection));
  });
  add("sphere/published", [](const LocalInput& in) {
    return hitOf(forms::publishedSphere(in.probe, in.point.position, in.point.reflection));
  });
  add("distribution/own", [](const LocalInput& in) {
    return forms::ggxDistribution(in.point.normal, in.point.roughness * in.point.roughness);
  });
  add("distribution/published", [](const LocalInput& in) {
    return forms::publishedDistribution(in.point.normal.z, in.point.roughness * in.point.roughness);
  });
  add("masking/own", [](const LocalInput& in) {
    return forms::ggxMasking(in.point.normal.z, in.point.roughness * in.point.roughness);
  });
  add("masking/published", [](const LocalInput& in) {
    return forms::publishedMasking(in.point.normal.z, in.point.roughness * in.point.roughness);
  });
  add("reflection/own", [](const LocalInput& in) { return forms::reflectedView(in.point.normal, in.point.view); });
  add("reflection/published", [](const LocalInput& in) { return glm::reflect(-in.point.view, in.point.normal); });
}

void addTechniques() {
  for (const StressSubject& subject : techniqueSubjects()) {
    const Technique technique = *subject.technique;
    const auto evaluate = evaluationRows()[static_cast<std::size_t>(technique.evaluation)].evaluate;
    add("technique/" + subject.id, [technique, evaluate](const LocalInput& input) {
      LocalInput in = input;
      const StressMap map(in.probe);
      const shading::ProbeData data = map.probeData();
      in.probe.projection = technique.projection;
      in.probe.bevel = 0.0f;
      in.probe.slot = &data;
      return evaluate(&map, in.probe, in.point);
    });
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  addForms();
  addTechniques();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
