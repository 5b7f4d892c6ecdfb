// See fit_box.h.
#include "filters/fit/box/fit_box.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/box/face_planes.h"
#include "filters/fit/box/place_check.h"

namespace boxprobe {

namespace {

constexpr double kLeastWalls = 0.3;  // share of the horizon; with fewer walls there is nothing to fit to
constexpr double kWeakYaw = 0.2;     // below it no direction stands out, and several yaws are tried
constexpr double kSameYaw = 0.5;     // degrees
constexpr double kNoGain = 0.005;    // degrees, a seventieth of a texel of 256² faces: smaller gains change no box
constexpr double kFree = 0.05;       // degrees of mean error per half box: faces with less influence are free
constexpr std::size_t kStarts = 8, kFinalists = 2;

/// Axes along which a box is searched.
struct Frame {
  glm::dvec3 rotationDegrees{0.0};
  bool turns = false;
};

class Search {
 public:
  Search(const FitPlace& place, const ReflectedRays& reflected, const Probe& probe, const BoxFitSettings& settings,
         const Frame& frame, bool current)
      : settings_(settings), frame_(frame), old_(offsetBox(probe)), current_(current) {
    const glm::dmat3 axes = rotationMatrix(frame.rotationDegrees);
    rays_ = lookupRays(place, reflected, probe.origin, axes);
    points_ = metPoints(place, reflected, probe.origin, axes);
    double nearest = 0.0;
    for (const MetPoint& point : points_) nearest = std::max(nearest, glm::length(point.position));
    polish_.faces = settings.faces;
    polish_.yaw = frame.turns;
    polish_.nearest = 1e-3 * nearest;
  }

  const LookupRays& rays() const { return rays_; }
  double yawStrength() const { return uprightYaw(points_).strength; }

  /// Empty if `progress` stopped it.
  std::optional<RatedBox> best(const FitProgress& progress) {
    const LookupRays few = someOf(rays_, 1024);
    PolishSettings rough = polish_;
    rough.lastStep = 0.004;
    std::vector<RatedBox> found;
    const std::vector<double> yaws = yawsToTry();
    double done = 0.0;
    const auto go = [&](double more) { return done += more, !progress || progress(std::min(done, 1.0)); };
    for (const double yaw : yaws) {
      for (const RatedBox& start : starts(yaw, yaws.size() > 2 ? 2 : kStarts)) {
        found.push_back(polished(few, start.box, rough));
        if (!go(0.05 / static_cast<double>(yaws.size()))) return std::nullopt;
      }
      if (!go(0.2 / static_cast<double>(yaws.size()))) return std::nullopt;
    }
    if (current_) found.push_back(polished(few, inside(old_), rough));
    const auto better = [](const RatedBox& a, const RatedBox& b) { return a.meanDegrees < b.meanDegrees; };
    std::stable_sort(found.begin(), found.end(), better);
    if (found.size() > kFinalists) found.resize(kFinalists);
    PolishSettings fine = polish_;
    fine.firstStep = 0.01;
    for (RatedBox& each : found) {
      each = polished(rays_, each.box, fine);
      if (!go(0.1)) return std::nullopt;
    }
    RatedBox best = *std::min_element(found.begin(), found.end(), better);
    if (frame_.turns) best = keepYawIfAsGood(best, fine);
    return onPlanes(best);
  }

 private:
  OffsetBox inside(OffsetBox box) const {
    for (std::size_t face = 0; face < kFaces; ++face) {
      if (settings_.faces[face]) box.offset[face] = std::max(box.offset[face], polish_.nearest);
    }
    return box;
  }

  std::vector<double> yawsToTry() const {
    if (!frame_.turns) return {0.0};
    const UprightYaw upright = uprightYaw(points_);
    if (upright.strength >= kWeakYaw) {
      if (std::abs(glm::degrees(upright.yaw)) < kSameYaw) return {upright.yaw};
      return {upright.yaw, 0.0};
    }
    std::vector<double> yaws;
    for (int i = -8; i < 8; ++i) yaws.push_back(glm::radians(90.0 * i / 16.0));
    return yaws;
  }

  FacePlanes planesAt(double yaw) const {
    FacePlanes planes = facePlanes(turnedBy(points_, yaw));
    for (std::size_t face = 0; face < kFaces; ++face) {
      std::vector<double>& offsets = planes.offsets[face];
      if (!settings_.faces[face]) offsets = {old_.offset[face]};
      if (offsets.empty()) {  // nothing was met on this side
        planes.likeliest[face] = current_ ? std::max(old_.offset[face], polish_.nearest) : polish_.nearest;
        offsets = {planes.likeliest[face]};
      }
    }
    return planes;
  }

  std::vector<RatedBox> starts(double yaw, std::size_t count) const {
    const FacePlanes planes = planesAt(yaw);
    double combinations = 1.0;
    for (const std::vector<double>& offsets : planes.offsets) combinations *= static_cast<double>(offsets.size());
    const double rays = std::clamp(5.0e7 / combinations, 192.0, 1024.0);
    const LookupRays turned = turnedBy(someOf(rays_, static_cast<std::size_t>(rays)), yaw);
    return bestCombinations(turned, planes.offsets, count, yaw);
  }

  /// Keeps the previous axes unless turning the box pays.
  RatedBox keepYawIfAsGood(const RatedBox& best, const PolishSettings& fine) const {
    if (std::abs(glm::degrees(best.box.yaw)) > 5.0) return best;
    PolishSettings unturned = fine;
    unturned.yaw = false;
    OffsetBox start = best.box;
    start.yaw = 0.0;
    const RatedBox kept = polished(rays_, start, unturned);
    return kept.meanDegrees <= 1.01 * best.meanDegrees + 0.005 ? kept : best;
  }

  /// Moves faces to better planes, or to nearby planes if that costs nothing; free faces go to the likeliest planes.
  RatedBox onPlanes(RatedBox best) const {
    const FacePlanes planes = planesAt(best.box.yaw);
    // A plane that the refinement could not reach through worse positions: the wall behind furniture.
    for (std::size_t face = 0; face < kFaces; ++face) {
      for (const double offset : planes.offsets[face]) {
        OffsetBox moved = best.box;
        moved.offset[face] = offset;
        const double error = meanError(rays_, moved);
        if (error < best.meanDegrees) best = {moved, error};
      }
    }
    const double extent = extentOf(best.box), allowed = 1.003 * best.meanDegrees + 0.001;
    const std::array<double, kFaces> sensitivities = faceSensitivities(rays_, best.box);
    const auto accept = [&](std::size_t face, double offset) {
      OffsetBox moved = best.box;
      moved.offset[face] = offset;
      const double error = meanError(rays_, moved);
      if (error <= allowed) best = {moved, error};
    };
    for (std::size_t face = 0; face < kFaces; ++face) {
      if (!settings_.faces[face]) continue;
      const double here = best.box.offset[face];
      if (0.5 * extent * sensitivities[face] < kFree) {
        accept(face, planes.likeliest[face]);
        continue;
      }
      const std::vector<double>& offsets = planes.offsets[face];
      const double nearest = *std::min_element(offsets.begin(), offsets.end(), [here](double a, double b) {
        return std::abs(a - here) < std::abs(b - here);
      });
      if (std::abs(nearest - here) < 0.02 * extent) accept(face, nearest);
    }
    return best;
  }

  const BoxFitSettings& settings_;
  Frame frame_;
  OffsetBox old_;
  bool current_;
  LookupRays rays_;
  std::vector<MetPoint> points_;
  PolishSettings polish_;
};

std::array<FaceFit, kFaces> faceFits(const LookupRays& rays, const OffsetBox& box, const OffsetBox& old,
                                     bool sameAxes) {
  std::array<FaceFit, kFaces> faces;
  const std::array<double, kFaces> sensitivities = faceSensitivities(rays, box);
  const double after = meanError(rays, box), extent = extentOf(box);
  for (std::size_t face = 0; face < kFaces; ++face) {
    OffsetBox back = box;
    back.offset[face] = old.offset[face];
    faces[face].gainDegrees = sameAxes ? meanError(rays, back) - after : 0.0;
    faces[face].sensitivity = sensitivities[face];
    faces[face].free = 0.5 * extent * sensitivities[face] < kFree;
  }
  return faces;
}

}  // namespace

std::optional<BoxFit> fitBox(const FitPlace& place, const Probe& probe, const BoxFitSettings& settings,
                             const FitProgress& progress) {
  const auto begun = std::chrono::steady_clock::now();
  BoxFit fit;
  fit.probe = probe;
  if (insideOfSolid(place.captured, probe.origin)) {
    fit.outcome = FitOutcome::Inside;
    fit.remarks.push_back(
        Phrase::tr("the origin is inside of a wall: nothing is fitted; move the origin into the room"));
    return fit;
  }
  const ReflectedRays reflected = reflectedRays(place, probe, settings.rays);
  fit.open = reflected.open;
  const OffsetBox old = offsetBox(probe);
  const LookupRays before = lookupRays(place, reflected, probe.origin, rotationMatrix(probe.rotationDegrees));
  fit.hidden = fit.hiddenBefore = before.hidden;
  if (before.rays.empty() || walledAround(place.captured, probe.origin) < kLeastWalls) {
    fit.outcome = FitOutcome::Open;
    fit.remarks.push_back(Phrase::tr("open: nothing to fit to; the box stays"));
    return fit;
  }
  fit.before = fit.after = lookupErrors(before, old);

  const bool tilted = probe.rotationDegrees.x != 0.0 || probe.rotationDegrees.z != 0.0;
  std::vector<Frame> frames = {{probe.rotationDegrees, settings.yaw && !tilted}};
  if (tilted && settings.yaw) frames.push_back({glm::dvec3(0.0), true});
  std::optional<RatedBox> best;
  Frame chosen;
  LookupRays rays;
  double strength = 1.0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto share = [&](double done) {
      return !progress || progress((static_cast<double>(i) + done) / static_cast<double>(frames.size()));
    };
    Search search(place, reflected, probe, settings, frames[i], i == 0);
    const std::optional<RatedBox> found = search.best(share);
    if (!found) return std::nullopt;
    if (best && found->meanDegrees >= best->meanDegrees) continue;
    best = found;
    chosen = frames[i];
    rays = search.rays();
    strength = search.yawStrength();
  }
  const OffsetBox box = withMargin(best->box, rays, settings.faces);
  const LookupErrors after = lookupErrors(rays, box);
  const bool sameAxes = chosen.rotationDegrees == probe.rotationDegrees;
  if (after.meanDegrees < fit.before.meanDegrees - kNoGain) {
    fit.outcome = FitOutcome::Fitted;
    fit.after = after;
    fit.probe = withOffsetBox(probe, box, chosen.rotationDegrees);
    fit.faces = faceFits(rays, box, old, sameAxes);
  } else {
    fit.faces = faceFits(before, old, old, true);
    fit.remarks.push_back(Phrase::tr("no better box was found: it stays"));
  }
  if (strength < kWeakYaw) fit.remarks.push_back(Phrase::tr("the place is not rectangular"));
  fit.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  if (fit.after.above5 > 0.25) {
    fit.remarks.push_back(
        Phrase::tr("a quarter of the reflections and more stay off by over 5 degrees: use the technique impostor, or "
                   "more probes"));
  }
  return fit;
}

}  // namespace boxprobe
