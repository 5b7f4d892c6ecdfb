// Published forms in the same test as the program's own. They have no guard, so they get broken pixels unrepaired.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/math/published/published_math.h"
#include "filters/stress/exact.h"
#include "filters/stress/stress_map.h"
#include "filters/stress/stress_subjects.h"

namespace boxprobe::stress {

namespace {

using shading::ProbeHit;

LocalInput published(const StressInput& input, TrialLog* log) {
  const LocalInput in = unguardedInput(input);
  if (log != nullptr) logLocal(in, *log);
  return in;
}

template <typename Project>
Trial tryBox(const Project& project, const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = published(input, log);
  const ProbeHit hit = project(in);
  Trial trial;
  trial.require(finite(hit.direction) && std::isfinite(hit.distance));
  // Their slab factors are those of the far planes; the smallest can be compared.
  const exact::BoxExit exit = exact::boxExit(exact::vec(in.point.position), exact::vec(in.point.reflection),
                                             exact::vec(in.probe.boxMin), exact::vec(in.probe.boxMax));
  ProbeHit compared = hit;
  for (int i = 0; i < 3; ++i) compared.slabFactors[i] = static_cast<float>(exit.factors[static_cast<std::size_t>(i)]);
  measureBox(in, c, compared, trial, log);
  return trial;
}

Trial tryBoxSelect(const StressInput& input, const StressClass& c, TrialLog* log) {
  return tryBox(
      [](const LocalInput& in) {
        return shading::publishedBoxSelect(in.probe, in.point.position, in.point.reflection);
      },
      input, c, log);
}

Trial tryBoxMax(const StressInput& input, const StressClass& c, TrialLog* log) {
  return tryBox(
      [](const LocalInput& in) { return shading::publishedBoxMax(in.probe, in.point.position, in.point.reflection); },
      input, c, log);
}

Trial tryBoxWorld(const StressInput& input, const StressClass& c, TrialLog* log) {
  return tryBox(
      [&input](const LocalInput& in) {
        shading::ProbeShape world = in.probe;
        world.boxMin = input.boxMinWorld;
        world.boxMax = input.boxMaxWorld;
        // A rotated box is not far away: its point is the rotated one.
        const bool turned = input.turn != glm::vec3(0.0f);
        const glm::vec3 position = turned ? in.point.position : input.positionWorld;
        return shading::publishedBoxWorld(world, input.originWorld, position, in.point.reflection);
      },
      input, c, log);
}

Trial tryPublishedRoundedBox(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = published(input, log);
  const ProbeHit hit = shading::publishedRoundedBox(in.probe, in.point.position, in.point.reflection);
  Trial trial;
  trial.require(finite(hit.direction) && std::isfinite(hit.distance));
  measureRoundedBox(in, c, hit.distance, boxHit(in).distance, trial, log);
  return trial;
}

Trial trySphere(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = published(input, log);
  const ProbeHit hit = shading::publishedSphere(in.probe, in.point.position, in.point.reflection);
  Trial trial;
  trial.require(finite(hit.direction) && std::isfinite(hit.distance));
  measureSphere(in, c, hit, trial, log);
  return trial;
}

// Uses the program's own hit, to test the quotient alone.
Trial tryDistanceRatio(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput guarded = localInput(input);
  const ProbeHit hit = boxHit(guarded);
  const float p = guarded.point.roughness, most = guarded.probe.maxLevel;
  const float level =
      shading::levelForRoughness(shading::publishedDistanceRoughness(hit.distance, hit.direction, p), most);
  const exact::Real definition = exact::levelHdrp(0, p, most, hit.distance, exact::length(exact::vec(hit.direction)));
  Trial trial;
  trial.require(std::isfinite(level), level >= 0.0f && level <= most);
  trial.measure(kLevels, static_cast<double>(std::abs(level - definition)), kLevelError, c.held != Held::Finite);
  if (log == nullptr) return trial;
  log->add("hit", hit.direction);
  log->add("distance", static_cast<double>(hit.distance));
  log->add("level", static_cast<double>(level), definition);
  return trial;
}

Trial tryPublishedFootprintScale(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = localInput(input);
  const ProbeHit hit = boxHit(in);
  const float scale = shading::publishedFootprintScale(in.probe, hit, in.point.reflection);
  Trial trial;
  trial.require(std::isfinite(scale));
  measureFootprintScale(in, c, hit, scale, trial, log);
  return trial;
}

Trial tryPublishedDistribution(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = published(input, nullptr);
  const float alpha = in.point.roughness * in.point.roughness;
  const float within = std::min(alpha, 1.0f);
  const glm::vec3 h = (input.pixel.x & 1) != 0 ? shading::ggxHalfVector(lobeNumbers(input), within) : in.point.normal;
  const float d = shading::publishedDistribution(h.z, alpha);
  Trial trial;
  trial.require(std::isfinite(d));
  if (log != nullptr) log->add("half vector", h);
  if (alpha >= 1.0e-12f && alpha <= 1.0f) {
    measureTerm(c, "D", d, exact::ggxDistribution(exact::vec(h), alpha), trial, log);
  }
  return trial;
}

Trial tryPublishedMasking(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = published(input, nullptr);
  const float alpha = in.point.roughness * in.point.roughness;
  const float cosine = std::clamp(glm::dot(in.point.normal, in.point.view), 0.0f, 1.0f);
  const float g = shading::publishedMasking(cosine, alpha);
  Trial trial;
  trial.require(std::isfinite(g));
  if (log != nullptr) log->add("cosine", static_cast<double>(cosine));
  const bool defined = (cosine > 0.0f || alpha > 0.0f) && alpha <= 1.0f;
  if (defined) measureTerm(c, "G1", g, exact::ggxMasking(cosine, alpha), trial, log);
  return trial;
}

Trial tryPublishedWeight(const StressInput& input, const StressClass&, TrialLog* log) {
  const LocalInput in = published(input, log);
  const float w = shading::publishedInfluence(in.point.position, in.probe.boxMin, in.probe.boxMax, input.blendDistance);
  Trial trial;
  trial.require(std::isfinite(w), w >= 0.0f && w <= 1.0f);
  if (log != nullptr) log->add("weight", static_cast<double>(w));
  return trial;
}

Trial tryPublishedReflection(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = published(input, nullptr);
  const glm::vec3 r = glm::reflect(-in.point.view, in.point.normal);
  Trial trial;
  trial.require(finite(r));
  measureReflection(in, c, r, trial, log);
  return trial;
}

}  // namespace

const std::vector<StressSubject>& publishedSubjects() {
  static const std::vector<StressSubject> subjects = {
      {"published:box-select", {}, tryBoxSelect, "box+none", 0.0, {}},
      {"published:box-max", {}, tryBoxMax, "box+none", 0.0, {}},
      {"published:box-world", {}, tryBoxWorld, "box+none", 0.0, {}},
      {"published:rounded-box", {}, tryPublishedRoundedBox, "term:rounded-box", 0.0, {}},
      {"published:sphere", {}, trySphere, "sphere+none", 0.0, {}},
      {"published:distance-ratio", {}, tryDistanceRatio, "box+hdrp", 0.0, {}},
      {"published:footprint-scale", {}, tryPublishedFootprintScale, "term:footprint-scale", 0.0, {}},
      {"published:ggx-distribution", {}, tryPublishedDistribution, "term:ggx-distribution", 0.0, {}},
      {"published:ggx-masking", {}, tryPublishedMasking, "term:ggx-masking", 0.0, {}},
      {"published:blend-weight", {}, tryPublishedWeight, "term:blend-weight", 0.0, {}},
      {"published:reflection", {}, tryPublishedReflection, "term:reflection", 0.0, {}},
  };
  return subjects;
}

}  // namespace boxprobe::stress
