// See fit_origin.h.
#include "filters/fit/box/fit_origin.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/box/visibility.h"

namespace boxprobe {

namespace {

constexpr double kLevelDegrees = 0.25;     // cost of a level that is too coarse by one
constexpr double kPixelDegrees = 0.05;     // a pixel of a picture of 1,000 pixels at 50 degrees
constexpr double kLeastGain = 0.95;        // a new origin must reduce the cost to this share
constexpr double kLeastLookupGain = 0.01;  // degrees: where lookups are nearly right, a relative gain means nothing
constexpr std::size_t kFullFits = 3;
constexpr double kApart = 0.2;  // relative to the box's diagonal

struct Candidate {
  Probe probe;
  double cost = 0.0;
};

/// `probe` captured at `origin`, with its box where it was.
Probe movedOrigin(Probe probe, const glm::dvec3& origin) {
  probe.origin = origin;
  return probe;
}

bool inside(const Probe& probe, const glm::dvec3& position) {
  const OffsetBox box = offsetBox(movedOrigin(probe, position));
  return std::all_of(box.offset.begin(), box.offset.end(), [](double offset) { return offset > 0.0; });
}

double clearance(const SurfaceRays& rays, const glm::dvec3& position) {
  double nearest = 1e300;
  for (const glm::dvec3& direction : fibonacciDirections(96)) {
    if (const std::optional<SurfaceHit> hit = rays.first(position, direction)) {
      nearest = std::min(nearest, hit->distance);
    }
  }
  return nearest;
}

/// A plane that shows many reflections.
struct Mirror {
  glm::dvec3 normal{0.0}, place{0.0}, eyes{0.0};  ///< weighted sums, until divided
  double offset = 0.0, weight = 0.0;
};

std::vector<Mirror> mirrorsOf(const ReflectedRays& reflected, double extent) {
  constexpr double kLeast = 0.1;
  std::vector<Mirror> mirrors;
  for (const ReflectedRay& ray : reflected.rays) {
    if (!ray.seen) continue;
    const double offset = glm::dot(ray.fromNormal, ray.from);
    auto mirror = std::find_if(mirrors.begin(), mirrors.end(), [&](const Mirror& each) {
      return glm::dot(each.normal, ray.fromNormal) > 0.999 && std::abs(each.offset - offset) < 1e-3 * extent;
    });
    if (mirror == mirrors.end()) {
      if (mirrors.size() == 256) continue;  // a curved object has no plane
      mirror = mirrors.insert(mirrors.end(), Mirror{});
      mirror->normal = ray.fromNormal;
      mirror->offset = offset;
    }
    mirror->place += ray.weight * ray.from;
    mirror->eyes += ray.weight * ray.eye;
    mirror->weight += ray.weight;
  }
  mirrors.erase(std::remove_if(mirrors.begin(), mirrors.end(), [](const Mirror& each) { return each.weight < kLeast; }),
                mirrors.end());
  for (Mirror& each : mirrors) {
    each.place /= each.weight;
    each.eyes /= each.weight;
  }
  return mirrors;
}

std::vector<glm::dvec3> placesToTry(const FitPlace& place, const ReflectedRays& reflected, const Probe& probe) {
  constexpr int kAcross = 5, kLayers = 4;
  const glm::dvec3 size = probe.box.size(), pivot = probe.box.center();
  const glm::dmat3 worldFromBox = rotationMatrix(probe.rotationDegrees);
  const double smallest = std::min({size.x, size.y, size.z}), largest = std::max({size.x, size.y, size.z});
  const double wall = std::min(0.15, 0.05 * smallest), mirror = std::min(0.04, 0.02 * smallest);
  std::vector<glm::dvec3> found;
  const auto add = [&](const glm::dvec3& position, double distance) {
    if (!inside(probe, position) || !visibleFrom(place.captured, probe.origin, position)) return;
    if (clearance(place.captured, position) >= distance) found.push_back(position);
  };
  for (int x = 0; x < kAcross; ++x) {
    for (int y = 0; y < kLayers; ++y) {
      for (int z = 0; z < kAcross; ++z) {
        const glm::dvec3 share((x + 0.5) / kAcross, (y + 0.5) / kLayers, (z + 0.5) / kAcross);
        add(pivot + worldFromBox * ((share - 0.5) * size), wall);
      }
    }
  }
  for (const Mirror& each : mirrorsOf(reflected, largest)) {
    for (const double raised : {0.05, 0.12, 0.3, 0.6}) {
      for (const double towards : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const glm::dvec3 over = each.place + towards * (each.eyes - each.place);
        const double off = glm::dot(each.normal, over) - each.offset;
        add(over + (raised * smallest / 2.5 - off) * each.normal, mirror);
      }
    }
  }
  return found;
}

/// The first candidates, each at least `distance` from those before it: neighbours cost about the same before the box
/// is fitted to them, and would displace candidates that gain by the fit.
std::vector<Candidate> apart(const std::vector<Candidate>& candidates, double distance) {
  std::vector<Candidate> chosen;
  for (const Candidate& candidate : candidates) {
    const bool far = std::all_of(chosen.begin(), chosen.end(), [&](const Candidate& other) {
      return glm::length(candidate.probe.origin - other.probe.origin) >= distance;
    });
    if (far) chosen.push_back(candidate);
    if (chosen.size() == kFullFits) break;
  }
  return chosen;
}

/// The part of the cost that does not concern texels: a mean over all rays, degrees.
double lookupCost(const FitPlace& place, const ReflectedRays& reflected, const Probe& probe) {
  const LookupRays lookups = lookupRays(place, reflected, probe.origin, rotationMatrix(probe.rotationDegrees));
  if (lookups.rays.empty()) return kHiddenDegrees;
  const OffsetBox box = offsetBox(probe);
  double off = 0.0;
  for (const LookupRay& ray : lookups.rays) {
    off += ray.weight * std::min(glm::degrees(lookupError(ray, boxExit(ray, box.offset).distance)), kHiddenDegrees);
  }
  return (1.0 - lookups.hidden) * off + lookups.hidden * kHiddenDegrees;
}

}  // namespace

double originCost(const FitPlace& place, const ReflectedRays& reflected, const Probe& probe) {
  const double texel = glm::radians(90.0) / probe.faceSize;
  double coarse = 0.0, seen = 0.0;
  for (const ReflectedRay& ray : reflected.rays) {
    if (!ray.seen) continue;
    const double reflectedPath = glm::length(ray.hit - ray.from);
    const double pixel = glm::radians(kPixelDegrees) * (glm::length(ray.from - ray.eye) + reflectedPath);
    const double lobe = ray.roughness * ray.roughness * reflectedPath;
    const double levels = std::log2(texel * glm::length(ray.hit - probe.origin) / std::max({pixel, lobe, 1e-12}));
    coarse += ray.weight * std::max(levels, 0.0);
    seen += ray.weight;
  }
  return lookupCost(place, reflected, probe) + (seen > 0.0 ? kLevelDegrees * coarse / seen : 0.0);
}

std::optional<BoxFit> proposeOrigin(const FitPlace& place, const Probe& probe, const BoxFitSettings& settings,
                                    const FitProgress& progress) {
  const auto part = [&progress](double from, double to) {
    return [&progress, from, to](double done) { return !progress || progress(from + (to - from) * done); };
  };
  const auto begun = std::chrono::steady_clock::now();
  std::optional<BoxFit> best = fitBox(place, probe, settings, part(0.0, 0.2));
  if (!best || best->outcome == FitOutcome::Open || best->outcome == FitOutcome::Inside) return best;
  const BoxFit stays = *best;

  ReflectedRays reflected = reflectedRays(place, probe, settings.rays / 4);
  std::vector<Candidate> candidates;
  const std::vector<glm::dvec3> places = placesToTry(place, reflected, stays.probe);
  for (const glm::dvec3& origin : places) {
    Candidate candidate{movedOrigin(stays.probe, origin)};
    candidate.cost = originCost(place, reflected, candidate.probe);
    candidates.push_back(candidate);
    const double done = static_cast<double>(candidates.size()) / static_cast<double>(places.size());
    if (!part(0.2, 0.5)(done)) return std::nullopt;
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  candidates = apart(candidates, kApart * glm::length(stays.probe.box.size()));

  reflected = reflectedRays(place, probe, settings.rays);
  double cost = originCost(place, reflected, stays.probe);
  const double lookup = lookupCost(place, reflected, stays.probe);
  const double mostLookup = std::min(kLeastGain * lookup, lookup - kLeastLookupGain);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double from = 0.5 + 0.5 * static_cast<double>(i) / kFullFits;
    const std::optional<BoxFit> fit = fitBox(place, candidates[i].probe, settings, part(from, from + 0.5 / kFullFits));
    if (!fit) return std::nullopt;
    const double fitted = originCost(place, reflected, fit->probe);
    if (fitted >= kLeastGain * cost || fit->outcome == FitOutcome::Inside) continue;
    // Finer texels alone are no reason: approaching one wall means leaving the others.
    if (lookupCost(place, reflected, fit->probe) > mostLookup) continue;
    cost = fitted;
    best = fit;
  }
  best->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  if (best->probe.origin == stays.probe.origin) {
    best->remarks.push_back(Phrase::tr("no better origin was found: it stays"));
    return best;
  }
  if (best->outcome == FitOutcome::Kept) best->remarks.erase(best->remarks.begin());  // the remark that the box stays
  best->outcome = FitOutcome::Fitted;
  best->before = stays.before;
  best->hiddenBefore = stays.hiddenBefore;
  return best;
}

}  // namespace boxprobe
