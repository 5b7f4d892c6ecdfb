// Terms under test: the parts of techniques, each against its definition.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "filters/stress/exact.h"
#include "filters/stress/stress_map.h"
#include "filters/stress/stress_subjects.h"
#include "filters/stress/subject_glass.h"
#include "filters/stress/subject_lamp.h"

namespace boxprobe::stress {

namespace {

using exact::Real;
using shading::ProbeHit;

/// The index of a projection by its id, which must be in the table.
int projectionIndex(const char* id) {
  return parseTechnique(id)->projection;
}

Trial tryFootprintScale(const char* projection, const StressInput& input, const StressClass& c, TrialLog* log) {
  LocalInput in = localInput(input);
  in.probe.projection = projectionIndex(projection);
  in.probe.bevel = 0.0f;
  Trial trial;
  if (log != nullptr) logLocal(in, *log);
  const ProbeHit hit = shading::projectRay(in.probe, in.point.position, in.point.normal, in.point.reflection);
  const float scale = shading::footprintScale(in.probe, hit, in.point.reflection);
  trial.require(std::isfinite(scale));
  measureFootprintScale(in, c, hit, scale, trial, log);
  return trial;
}

Trial tryRoundedBox(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = localInput(input);
  Trial trial;
  if (log != nullptr) logLocal(in, *log);
  const float exit = boxHit(in).distance;
  const float t = shading::roundedBoxExit(in.point.position, in.point.reflection, in.probe.boxMin, in.probe.boxMax,
                                          in.probe.bevel, exit);
  trial.require(std::isfinite(t), t >= 0.0f && t <= exit);
  measureRoundedBox(in, c, t, exit, trial, log);
  return trial;
}

float alphaOf(const LocalInput& in) {
  return in.point.roughness * in.point.roughness;
}

// Half of the half vectors are inside the lobe, the others anywhere: N provides a direction, V two numbers.
Trial tryDistribution(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = localInput(input);
  const float alpha = alphaOf(in);
  Trial trial;
  const glm::vec3 h = (input.pixel.x & 1) != 0 ? shading::ggxHalfVector(lobeNumbers(input), alpha) : in.point.normal;
  const float d = shading::ggxDistribution(h, alpha);
  trial.require(finite(h) && std::isfinite(d));
  if (log != nullptr) log->add("half vector", h);
  // Below this the lobe is narrower than a float's resolution around its axis, and D exceeds float's range.
  if (alpha >= 1.0e-12f) measureTerm(c, "D", d, exact::ggxDistribution(exact::vec(h), alpha), trial, log);
  return trial;
}

Trial tryMasking(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = localInput(input);
  const float alpha = alphaOf(in);
  const float cosine = std::clamp(glm::dot(in.point.normal, in.point.view), 0.0f, 1.0f);
  Trial trial;
  const float g = shading::ggxMasking(cosine, alpha);
  trial.require(std::isfinite(g));
  if (log != nullptr) log->add("cosine", static_cast<double>(cosine));
  if (cosine > 0.0f || alpha > 0.0f) measureTerm(c, "G1", g, exact::ggxMasking(cosine, alpha), trial, log);
  return trial;
}

Trial tryWeight(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = localInput(input);
  const shading::ProbeShape& box = in.probe;
  const float rate = blendRate(input);
  Trial trial;
  const float w = shading::influenceWeight(in.point.position, box.boxMin, box.boxMax, glm::vec3(rate), glm::vec3(rate));
  const float sum = w + 0.5f;
  const float scale = shading::groupScale(sum), rest = shading::remainingAfter(1.0f, sum);
  trial.require(std::isfinite(w) && std::isfinite(scale) && std::isfinite(rest),
                w >= 0.0f && w <= 1.0f && scale * sum <= 1.0f + 1.0e-6f && rest >= 0.0f);
  const Real exactWeight =
      exact::influence(exact::vec(in.point.position), exact::vec(box.boxMin), exact::vec(box.boxMax), rate);
  // A weight is a share of 1.
  trial.measure(kRelative, static_cast<double>(std::abs(w - exactWeight)), kTermRelative, c.held != Held::Finite);
  if (log != nullptr) log->add("weight", static_cast<double>(w), exactWeight);
  return trial;
}

Trial tryReflection(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = localInput(input);
  const glm::vec3 r = shading::reflectedView(in.point.normal, in.point.view);
  Trial trial;
  trial.require(finite(r));
  measureReflection(in, c, r, trial, log);
  return trial;
}

// roughnessForLevel and levelForRoughness must be inverse to each other.
Trial tryLevel(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = localInput(input);
  const float level = in.point.roughness * in.probe.maxLevel;
  const float p = shading::roughnessForLevel(level, in.probe.maxLevel);
  const float back = shading::levelForRoughness(p, in.probe.maxLevel);
  Trial trial;
  trial.require(std::isfinite(p) && std::isfinite(back), back >= 0.0f && back <= in.probe.maxLevel);
  trial.measure(kLevels, static_cast<double>(std::abs(back - level)), kLevelError, c.held != Held::Finite);
  if (log != nullptr) log->add("level", static_cast<double>(back), static_cast<Real>(level));
  return trial;
}

Trial tryFrame(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = localInput(input);
  const glm::vec3 n = in.point.normal, t = shading::lobeTangent(n), b = shading::lobeBitangent(n);
  Trial trial;
  trial.require(finite(t) && finite(b));
  const glm::dvec3 dn(n), dt(t), db(b);
  const double off = std::max({std::abs(glm::dot(dt, dn)), std::abs(glm::dot(db, dn)), std::abs(glm::dot(dt, db)),
                               std::abs(glm::length(dt) - 1.0), std::abs(glm::length(db) - 1.0)});
  trial.measure(kRelative, off, kTermRelative, c.held != Held::Finite);
  if (log != nullptr) {
    log->add("N", n);
    log->add("T", t);
    log->add("B", b);
  }
  return trial;
}

Trial tryTexelCentre(const StressInput& input, const StressClass&, TrialLog* log) {
  const LocalInput in = localInput(input);
  const glm::vec3 centre = shading::cubeTexelCentre(shading::lookupDirection(in.point.position), 256.0f);
  Trial trial;
  const glm::vec3 a = glm::abs(centre);
  trial.require(finite(centre), std::max({a.x, a.y, a.z}) == 1.0f);
  if (log != nullptr) log->add("texel centre", centre);
  return trial;
}

Trial tryTrueHit(const StressInput& input, const StressClass&, TrialLog* log) {
  const LocalInput in = localInput(input);
  const StressMap map(in.probe);
  const float reach = static_cast<float>(std::min(2.0 * boxSize(in.probe, in.point.position), 1.0e30));
  const float t = shading::trueHitDistance(&map, in.probe, 256.0f, in.point.position, in.point.reflection, reach);
  Trial trial;
  trial.require(std::isfinite(t));
  if (log != nullptr) log->add("true hit distance", static_cast<double>(t));
  return trial;
}

}  // namespace

void measureTerm(const StressClass& c, const char* name, float value, long double exact, Trial& trial, TrialLog* log) {
  const long double scale = std::max(std::abs(exact), 1.0e-30L);
  trial.measure(kRelative, static_cast<double>(std::abs(value - exact) / scale), kTermRelative, c.held != Held::Finite);
  if (log != nullptr) log->add(name, static_cast<double>(value), exact);
}

void measureFootprintScale(const LocalInput& in, const StressClass& c, const ProbeHit& hit, float scale, Trial& trial,
                           TrialLog* log) {
  using exact::vec;
  const glm::dvec3 a = glm::abs(glm::dvec3(hit.direction));
  // At the wall itself the definition takes the limit: at least a billionth of the way from C.
  const Real t = std::max<Real>(hit.distance, std::max<Real>(1.0e-9L * std::max({a.x, a.y, a.z}), 1.0e-37L));
  const exact::Vec low = vec(in.probe.boxMin), high = vec(in.probe.boxMax), ray = vec(in.point.reflection);
  Real definition = 0, size = 0;
  if (hit.face >= 0) {
    definition = exact::solidAngleScaleBox(vec(hit.direction), t, vec(hit.slabFactors), ray, low, high);
    // With C outside, walls seen from behind cancel others; the difference is only as accurate as its terms, C's
    // absolute distances from the walls.
    exact::Vec near = low, far = high;
    for (std::size_t i = 0; i < 3; ++i) {
      near[i] = -std::abs(low[i]);
      far[i] = std::abs(high[i]);
    }
    size = exact::solidAngleScaleBox(vec(hit.direction), t, vec(hit.slabFactors), ray, near, far);
  } else {
    definition = exact::solidAngleScaleSphere(vec(hit.direction), t, ray, low, high);
    // At grazing angles the cosines are small differences: measured in units of their rounding errors.
    const exact::Vec p = vec(hit.direction);
    const exact::Vec n = {p[0] - (low[0] + high[0]) / 2, p[1] - (low[1] + high[1]) / 2, p[2] - (low[2] + high[2]) / 2};
    const Real slope = exact::dot(n, p) / exact::length(p) * exact::dot(n, ray) / exact::dot(n, n);
    size = slope > 1.0e-9L ? definition / std::min(slope, 1.0L) : 1.0e30L;
  }
  const Real off = std::abs(scale - definition) / std::max(size, 1.0e-30L);
  trial.measure(kRelative, static_cast<double>(off), kTermRelative, c.held != Held::Finite);
  if (log == nullptr) return;
  log->add("hit", hit.direction);
  log->add("distance", static_cast<double>(hit.distance));
  log->add("slab factors", hit.slabFactors);
  log->add("solid-angle scale", static_cast<double>(scale), definition);
}

void measureRoundedBox(const LocalInput& in, const StressClass& c, float t, float exit, Trial& trial, TrialLog* log) {
  using exact::vec;
  const glm::vec3 p = in.point.position;
  const bool inside =
      glm::all(glm::greaterThanEqual(p, in.probe.boxMin)) && glm::all(glm::lessThanEqual(p, in.probe.boxMax));
  // A ray from outside has no defined exit, only bounds.
  if (!inside) return;
  const Real definition = exact::roundedBoxExit(vec(p), vec(in.point.reflection), vec(in.probe.boxMin),
                                                vec(in.probe.boxMax), in.probe.bevel, exit);
  const Real reach = std::abs(t - definition) * exact::length(vec(in.point.reflection));
  const bool held = c.held != Held::Finite && c.held != Held::Sliding;
  trial.measure(kBoxSizes, definition < 1.0e30L ? static_cast<double>(reach) / lengthScale(in, c) : 0.0,
                kRoundedBoxSizes, held);
  if (log == nullptr) return;
  log->add("bevel", static_cast<double>(in.probe.bevel));
  log->add("sharp exit", static_cast<double>(exit));
  log->add("rounded exit", static_cast<double>(t), definition);
}

void measureReflection(const LocalInput& in, const StressClass& c, const glm::vec3& r, Trial& trial, TrialLog* log) {
  const exact::Vec n = exact::vec(in.point.normal), v = exact::vec(in.point.view), e = exact::vec(r);
  // Mirrored with N at its given length, and not below the surface, whichever way the normal faces.
  const Real facing = std::max(exact::dot(n, v), 0.0L);
  Real off = 0;
  for (std::size_t i = 0; i < 3; ++i) off = std::max(off, std::abs(e[i] - (2 * facing * n[i] - v[i])));
  trial.measure(kRelative, static_cast<double>(off), kTermRelative, c.held != Held::Finite);
  if (log == nullptr) return;
  log->add("N", in.point.normal);
  log->add("V", in.point.view);
  log->add("R", r);
  log->add("R.N", static_cast<double>(exact::dot(e, n)));
}

glm::vec2 lobeNumbers(const StressInput& in) {
  return {static_cast<float>(in.pixel.y) / 4096.0f, static_cast<float>(in.pixel.x) / 4096.0f};
}

// As in filters/core/geometry/probe_geometry: at least 1e-5 of the box.
float blendRate(const StressInput& in) {
  const LocalInput local = unguardedInput(in);
  const double least = std::max(1.0e-5 * boxSize(local.probe, local.point.position), 1.0e-30);
  return static_cast<float>(1.0 / std::max(static_cast<double>(in.blendDistance), least));
}

const std::vector<StressSubject>& termSubjects() {
  using std::placeholders::_1;
  using std::placeholders::_2;
  using std::placeholders::_3;
  static const std::vector<StressSubject> subjects = {
      {"term:footprint-scale", {}, std::bind(tryFootprintScale, "box", _1, _2, _3), nullptr, 0.0, {}},
      {"term:footprint-scale-sphere", {}, std::bind(tryFootprintScale, "sphere", _1, _2, _3), nullptr, 0.0, {}},
      {"term:rounded-box", {}, tryRoundedBox, nullptr, kRoundedMostBoxSizes, {}},
      {"term:ggx-distribution", {}, tryDistribution, nullptr, 0.0, {}},
      {"term:ggx-masking", {}, tryMasking, nullptr, 0.0, {}},
      {"term:blend-weight", {}, tryWeight, nullptr, 0.0, {}},
      {"term:reflection", {}, tryReflection, nullptr, 0.0, {}},
      {"term:level", {}, tryLevel, nullptr, 0.0, {}},
      {"term:lobe-frame", {}, tryFrame, nullptr, 0.0, {}},
      {"term:texel-centre", {}, tryTexelCentre, nullptr, 0.0, {}},
      {"term:glass", {}, tryGlass, nullptr, 0.0, {}},
      {"term:lamp-diffuse", {}, tryLampDiffuse, nullptr, 0.0, {}},
      {"term:lamp-glossy", {}, tryLampGlossy, nullptr, 0.0, {}},
      {"term:lattice", {}, tryLattice, nullptr, 0.0, {}},
      {"term:true-hit", {}, tryTrueHit, nullptr, 0.0, {}},
  };
  return subjects;
}

}  // namespace boxprobe::stress
