// See box_gauge.h.
#include "filters/fit/box/box_gauge.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <vector>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

namespace {

constexpr double kSpotSize = 0.06;    ///< of the farthest distance: reflections this close form one spot
constexpr std::size_t kSpotRays = 3;  ///< fewer are noise

LookupRays along(const LookupRays& world, const glm::dmat3& boxFromWorld) {
  LookupRays turned{{}, world.hidden};
  turned.rays.reserve(world.rays.size());
  for (const LookupRay& ray : world.rays) {
    turned.rays.push_back(
        {boxFromWorld * ray.from, boxFromWorld * ray.along, boxFromWorld * ray.target, ray.weight, ray.reflected});
  }
  return turned;
}

std::vector<MetPoint> along(const std::vector<MetPoint>& world, const glm::dmat3& boxFromWorld) {
  std::vector<MetPoint> turned;
  turned.reserve(world.size());
  for (const MetPoint& point : world) {
    turned.push_back({boxFromWorld * point.position, boxFromWorld * point.normal, point.weight});
  }
  return turned;
}

double errorOf(const LookupRay& ray, const OffsetBox& box) {
  return glm::degrees(lookupError(ray, boxExit(ray, box.offset).distance));
}

}  // namespace

double countedGain(double meanDegrees) {
  constexpr double kLeast = 0.02, kShare = 0.02;  // degrees: a seventeenth of a texel of 256² faces; of the mean error
  return std::max(kLeast, kShare * meanDegrees);
}

BoxGauger::BoxGauger(const FitPlace& place, const Probe& probe, int rays)
    : reflected_(reflectedRays(place, probe, rays)),
      lookups_(lookupRays(place, reflected_, probe.origin, glm::dmat3(1.0))),
      points_(metPoints(place, reflected_, probe.origin, glm::dmat3(1.0))) {
  for (const MetPoint& point : points_) reach_ = std::max(reach_, glm::length(point.position));
}

std::optional<BoxGauge> BoxGauger::measure(const Probe& probe, const FitProgress& progress) const {
  if (lookups_.rays.empty()) return std::nullopt;
  const glm::dmat3 boxFromWorld = glm::transpose(rotationMatrix(probe.rotationDegrees));
  const LookupRays rays = along(lookups_, boxFromWorld);
  const OffsetBox box = offsetBox(probe);
  BoxGauge gauge;
  gauge.hidden = rays.hidden;
  gauge.errors = lookupErrors(rays, box);
  for (const LookupRay& ray : rays.rays) {
    FaceGauge& face = gauge.faces[static_cast<std::size_t>(boxExit(ray, box.offset).face)];
    face.share += ray.weight;
    face.meanDegrees += ray.weight * errorOf(ray, box);
  }
  const FacePlanes planes = facePlanes(along(points_, boxFromWorld));
  for (std::size_t face = 0; face < kFaces; ++face) {
    if (progress && !progress(static_cast<double>(face) / kFaces)) return std::nullopt;
    FaceGauge& each = gauge.faces[face];
    const double degrees = each.share > 0.0 ? each.meanDegrees / each.share : 0.0;
    const double share = each.share;
    each = bestOf(face, box, gauge.errors.meanDegrees, rays, planes);
    each.meanDegrees = degrees;
    each.share = share;
    const double most = gauge.worst ? gauge.faces[static_cast<std::size_t>(*gauge.worst)].gainDegrees : 0.0;
    if (each.gainDegrees >= countedGain(gauge.errors.meanDegrees) && each.gainDegrees > most) {
      gauge.worst = static_cast<int>(face);
    }
  }
  gauge.spot = worstSpot(rays, box, gauge.faces);
  return gauge;
}

FaceGauge BoxGauger::bestOf(std::size_t face, const OffsetBox& box, double meanDegrees, const LookupRays& rays,
                            const FacePlanes& planes) const {
  const double nearest = 1e-3 * reach_;
  PolishSettings settings;
  settings.faces.fill(false);
  settings.faces[face] = true;
  settings.yaw = false;
  // A face that the origin lies behind stays where it is while another one is tried.
  settings.nearest = std::min(nearest, *std::min_element(box.offset.begin(), box.offset.end()));
  const LookupRays few = someOf(rays, 512);
  std::optional<RatedBox> best;
  std::vector<double> tried = planes.offsets[face];
  tried.push_back(std::max(box.offset[face], nearest));
  // For an origin outside the box: a face must not pass the opposite one.
  const auto isBox = [&](const OffsetBox& each) { return each.offset[face] + each.offset[face ^ 1] > nearest; };
  for (const double offset : tried) {
    OffsetBox moved = box;
    moved.offset[face] = offset;
    if (!isBox(moved)) continue;
    const double error = meanError(few, moved);
    if (!best || error < best->meanDegrees) best = RatedBox{moved, error};
  }
  FaceGauge gauge;
  gauge.offset = box.offset[face];
  if (!best) return gauge;
  settings.firstStep = 0.02;
  settings.lastStep = 0.001;
  OffsetBox found = polished(rays, best->box, settings).box;
  found.offset[face] = std::max(found.offset[face], nearest);
  // On a nearby plane if that costs nothing: it is the wall's true position, without the rays' noise.
  const double least = meanError(rays, found);
  for (const double offset : planes.offsets[face]) {
    OffsetBox moved = found;
    moved.offset[face] = offset;
    if (!isBox(moved)) continue;
    if (std::abs(offset - found.offset[face]) < 0.02 * extentOf(box) &&
        meanError(rays, moved) <= 1.003 * least + 0.001) {
      found = moved;
      break;
    }
  }
  found = withMargin(found, rays, settings.faces);
  if (!isBox(found)) return gauge;
  gauge.offset = found.offset[face];
  gauge.gainDegrees = std::max(meanDegrees - meanError(rays, found), 0.0);
  return gauge;
}

std::optional<WorstSpot> BoxGauger::worstSpot(const LookupRays& rays, const OffsetBox& box,
                                              const std::array<FaceGauge, kFaces>& faces) const {
  struct Seen {
    const ReflectedRay* ray;
    double degrees, weight;
  };
  // What leaves through other faces is another reflection, though it starts at the same place.
  const double near = kSpotSize * reach_;
  std::map<std::array<int, 4>, std::vector<Seen>> cells;
  const auto cellOf = [near](const glm::dvec3& from, int face) {
    const glm::dvec3 cell = glm::clamp(glm::floor(from / near), -1e8, 1e8);
    return std::array<int, 4>{static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z), face};
  };
  if (!(near > 0.0)) return std::nullopt;
  std::size_t seen = 0;
  for (const LookupRay& ray : rays.rays) {
    const ReflectedRay& reflected = reflected_.rays[ray.reflected];
    if (!reflected.seen) continue;
    cells[cellOf(reflected.from, boxExit(ray, box.offset).face)].push_back(
        {&reflected, errorOf(ray, box), reflected.weight});
    ++seen;
  }
  std::optional<WorstSpot> worst;
  const auto consider = [&worst](double sum, double weight, const Seen& most) {
    if (!(weight > 0.0) || (worst && sum / weight <= worst->degrees)) return;
    worst = WorstSpot{most.ray->from, most.ray->eye, sum / weight};
  };
  for (const auto& [place, middles] : cells) {
    std::vector<const std::vector<Seen>*> around;
    for (int i = 0; i < 27; ++i) {
      const auto found = cells.find({place[0] + i % 3 - 1, place[1] + i / 3 % 3 - 1, place[2] + i / 9 - 1, place[3]});
      if (found != cells.end()) around.push_back(&found->second);
    }
    for (const Seen& middle : middles) {
      double sum = 0.0, weight = 0.0;
      std::size_t count = 0;
      const Seen* most = &middle;
      for (const std::vector<Seen>* cell : around) {
        for (const Seen& each : *cell) {
          const glm::dvec3 off = each.ray->from - middle.ray->from;
          if (glm::dot(off, off) > near * near) continue;
          sum += each.weight * each.degrees;
          weight += each.weight;
          ++count;
          if (each.degrees > most->degrees) most = &each;
        }
      }
      if (count >= std::min(kSpotRays, seen)) consider(sum, weight, *most);
    }
  }
  // A face is worse than every spot where few see it, and from afar: then the spot is where it is seen the worst.
  for (int face = 0; face < kFaces; ++face) {
    const Seen* most = nullptr;
    for (const auto& [place, all] : cells) {
      for (const Seen& each : all) {
        if (place[3] == face && (most == nullptr || each.degrees > most->degrees)) most = &each;
      }
    }
    const FaceGauge& whole = faces[static_cast<std::size_t>(face)];
    if (most != nullptr) consider(whole.share * whole.meanDegrees, whole.share, *most);
  }
  return worst;
}

Probe withFaceAt(const Probe& probe, int face, double offset) {
  OffsetBox box = offsetBox(probe);
  box.offset[static_cast<std::size_t>(face)] = offset;
  return withOffsetBox(probe, box, probe.rotationDegrees);
}

}  // namespace boxprobe
