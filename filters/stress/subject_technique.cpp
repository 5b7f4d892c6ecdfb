// Techniques under test: the hit against the exact one, the lookups, and finite results.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "filters/math/technique/technique_table.h"
#include "filters/stress/exact.h"
#include "filters/stress/stress_map.h"
#include "filters/stress/stress_subjects.h"

namespace boxprobe::stress {

namespace {

using shading::ProbeHit;

bool held(const StressClass& c) {
  return c.held != Held::Finite;
}

void measureLevel(const EvaluationRow& row, const LocalInput& in, const ProbeHit& hit, const StressMap& map,
                  const StressClass& c, Trial& trial, TrialLog* log) {
  const shading::TechniqueParameters& a = in.probe.parameters;
  // The three-level curve mixes two lookups; a surface's own Fresnel term does not depend on these inputs.
  const bool knowsCurve = std::find(row.parameters.begin(), row.parameters.end(), "curve") != row.parameters.end();
  if (!knowsCurve || a.curve == 5 || a.fresnel != 0 || map.lookups() != 1) return;
  const exact::Real p = in.point.roughness, most = in.probe.maxLevel, d = hit.distance;
  exact::Real level = 0;
  if (row.id == "none") {
    level = exact::levelForRoughness(a.curve, p, most);
  } else if (row.id == "approximate") {
    level = exact::levelApproximate(a.curve, p, most, d, a.hardeningLength);
  } else if (row.id == "hdrp") {
    level = exact::levelHdrp(a.curve, p, most, d, exact::length(exact::vec(hit.direction)));
  } else if (row.id == "godot") {
    // As given: close to N = V, a power of 1 - N.V amplifies the last bit.
    const exact::Real facing = glm::dot(in.point.normal, in.point.view);
    level = exact::levelGodot(a.curve, p, most, d, a.hardeningLength, facing, a.power);
  } else {
    return;
  }
  trial.measure(kLevels, static_cast<double>(std::abs(map.level() - level)), kLevelError, held(c));
  if (log != nullptr) log->add("level", static_cast<double>(map.level()), level);
}

Trial tryTechnique(const Technique& technique, const StressInput& input, const StressClass& c, TrialLog* log) {
  const ProjectionRow& projection = projectionRows()[static_cast<std::size_t>(technique.projection)];
  const EvaluationRow& evaluation = evaluationRows()[static_cast<std::size_t>(technique.evaluation)];
  LocalInput in = localInput(input);
  const StressMap map(in.probe);
  const shading::ProbeData data = map.probeData();
  in.probe.projection = technique.projection;
  in.probe.bevel = 0.0f;
  in.probe.slot = &data;
  Trial trial;
  if (log != nullptr) logLocal(in, *log);

  const ProbeHit hit = projection.project(in.probe, in.point.position, in.point.normal, in.point.reflection);
  trial.require(finite(hit.direction) && std::isfinite(hit.distance) && finite(hit.slabFactors));
  if (projection.id == "box") measureBox(in, c, hit, trial, log);
  if (projection.id == "sphere") measureSphere(in, c, hit, trial, log);
  if (log != nullptr && projection.id != "box" && projection.id != "sphere") {
    log->add("lookup", hit.direction);
    log->add("distance", static_cast<double>(hit.distance));
  }

  const glm::vec4 value = evaluation.evaluate(&map, in.probe, in.point);
  trial.require(finite(glm::vec3(value)) && std::isfinite(value.w), map.usable());
  measureLevel(evaluation, in, hit, map, c, trial, log);
  if (log != nullptr) {
    log->add("lookups", map.lookups());
    log->add("last level", static_cast<double>(map.level()));
    log->add("lookups without direction or outside the chain", map.unusable());
    log->add("value", glm::vec3(value));
  }

  // With rounded edges evaluations get other hits. Tests every second input only, because this takes most of the time.
  if (input.pixel.y % 2 == 0) return trial;
  in.probe.bevel = input.bevel;
  const glm::vec4 rounded = evaluation.evaluate(&map, in.probe, in.point);
  trial.require(finite(glm::vec3(rounded)) && std::isfinite(rounded.w), map.usable());
  if (log != nullptr) log->add("value with rounded edges", glm::vec3(rounded));
  return trial;
}

}  // namespace

shading::ProbeHit boxHit(const LocalInput& in) {
  shading::ProbeShape probe = in.probe;
  probe.projection = parseTechnique("box")->projection;
  probe.bevel = 0.0f;
  return shading::projectRay(probe, in.point.position, in.point.normal, in.point.reflection);
}

double lengthScale(const LocalInput& in, const StressClass& c) {
  const double size = boxSize(in.probe, in.point.position);
  if (c.held != Held::ByReach) return size;
  const glm::dvec3 p(in.point.position), low(in.probe.boxMin), high(in.probe.boxMax);
  const glm::dvec3 off = glm::max(glm::max(low - p, p - high), glm::dvec3(0.0));
  return std::max({size, off.x, off.y, off.z});
}

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double ulpsFrom(float value, long double exact) {
  const float nearest = static_cast<float>(exact);
  if (!std::isfinite(value) || !std::isfinite(nearest)) return std::numeric_limits<double>::infinity();
  const float size = std::abs(nearest);
  const long double ulp = static_cast<long double>(std::nextafter(size, std::numeric_limits<float>::infinity())) - size;
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact) / ulp);
}

void measureBox(const LocalInput& in, const StressClass& c, const ProbeHit& hit, Trial& trial, TrialLog* log) {
  const exact::BoxExit exit = exact::boxExit(exact::vec(in.point.position), exact::vec(in.point.reflection),
                                             exact::vec(in.probe.boxMin), exact::vec(in.probe.boxMax));
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    trial.measure(kUlp, ulpsFrom(hit.slabFactors[i], exit.factors[axis]), kSlabUlp, held(c));
  }
  trial.measure(kUlp, ulpsFrom(hit.distance, exit.distance), kSlabUlp, held(c));
  trial.measure(kBoxSizes, static_cast<double>(exact::farthest(hit.direction, exit.hit)) / lengthScale(in, c),
                kHitBoxSizes, held(c));
  if (log == nullptr) return;
  log->add("slab factors", hit.slabFactors, exit.factors);
  log->add("distance", static_cast<double>(hit.distance), exit.distance);
  log->add("hit", hit.direction, exit.hit);
}

void measureSphere(const LocalInput& in, const StressClass& c, const ProbeHit& hit, Trial& trial, TrialLog* log) {
  const exact::SphereExit exit = exact::sphereExit(exact::vec(in.point.position), exact::vec(in.point.reflection),
                                                   exact::vec(in.probe.boxMin), exact::vec(in.probe.boxMax));
  // For a tangent ray, rounding the input can move the exit without bound: these units take the conditioning into
  // account.
  const double conditioned =
      static_cast<double>(exact::farthest(hit.direction, exit.hit) * std::min(exit.steepness, 1.0L));
  trial.measure(kBoxSizes, conditioned / lengthScale(in, c), kSphereBoxSizes, held(c));
  if (log == nullptr) return;
  log->add("distance", static_cast<double>(hit.distance), exit.distance);
  log->add("hit", hit.direction, exit.hit);
  log->add("cosine of ray and sphere", static_cast<double>(exit.steepness));
}

const std::vector<StressSubject>& techniqueSubjects() {
  static const std::vector<StressSubject> subjects = [] {
    std::vector<StressSubject> all;
    for (std::size_t p = 0; p < projectionRows().size(); ++p) {
      for (std::size_t e = 0; e < evaluationRows().size(); ++e) {
        const Technique technique{static_cast<int>(p), static_cast<int>(e)};
        all.push_back({techniqueId(technique), parametersOf(technique),
                       [technique](const StressInput& in, const StressClass& c, TrialLog* log) {
                         return tryTechnique(technique, in, c, log);
                       },
                       nullptr, 0.0, technique});
      }
    }
    return all;
  }();
  return subjects;
}

const StressSubject* findSubject(std::string_view id) {
  for (const auto* subjects : {&techniqueSubjects(), &termSubjects(), &publishedSubjects()}) {
    for (const StressSubject& subject : *subjects) {
      if (subject.id == id) return &subject;
    }
  }
  return nullptr;
}

}  // namespace boxprobe::stress
