// See place_cover.h.
#include "filters/fit/place_cover.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/box/visibility.h"
#include "filters/fit/place_influence.h"
#include "filters/math/shared/shared_math.h"

namespace boxprobe {

namespace {

/// Which places some probes light.
class Lit {
 public:
  explicit Lit(const std::vector<Probe>& probes) {
    for (const Probe& probe : probes) geometries_.push_back(probeGeometry(probe, probe.origin));
  }
  bool operator()(const glm::dvec3& world) const {
    return std::any_of(geometries_.begin(), geometries_.end(), [&](const ProbeGeometry& g) {
      const glm::vec3 p(glm::transpose(g.worldFromProbe) * (world - g.originWorld));
      return shading::influenceWeight(p, g.influenceMin, g.influenceMax, g.rateMin, g.rateMax) > 0.0f;
    });
  }

 private:
  std::vector<ProbeGeometry> geometries_;
};

std::vector<Probe> probesOf(const std::vector<PlacedProbe>& placed) {
  std::vector<Probe> probes;
  for (const PlacedProbe& each : placed) probes.push_back(each.probe);
  return probes;
}

/// Is one above the other, directly or by way of others?
bool isAbove(const std::vector<std::pair<std::size_t, std::size_t>>& above, std::size_t high, std::size_t low) {
  std::vector<std::size_t> reached = {low};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (reached[i] == high) return true;
    for (const auto& [under, over] : above) {
      if (under == reached[i] && std::find(reached.begin(), reached.end(), over) == reached.end()) {
        reached.push_back(over);
      }
    }
  }
  return false;
}

/// The shares of the cells of a room, so that as many are looked from in each.
std::vector<std::size_t> someCells(const Room& room, std::size_t wanted) {
  std::vector<std::size_t> cells;
  const std::size_t stride = std::max<std::size_t>(1, room.cells.size() / wanted);
  for (std::size_t i = stride / 2; i < room.cells.size(); i += stride) cells.push_back(room.cells[i]);
  return cells;
}

}  // namespace

std::vector<SeenPlace> seenFromRooms(const SurfaceRays& rays, const Rooms& rooms) {
  constexpr std::size_t kEyes = 64;
  constexpr int kLooks = 128, kTurns = 16;
  std::vector<SeenPlace> seen;
  std::vector<std::vector<glm::dvec3>> looks;
  for (int i = 0; i < kTurns; ++i) looks.push_back(fibonacciDirections(kLooks, (i + 0.29) / kTurns));
  for (std::size_t room = 0; room < rooms.rooms.size(); ++room) {
    std::size_t turn = 0;
    for (const std::size_t cell : someCells(rooms.rooms[room], kEyes)) {
      const glm::dvec3 eye = rooms.space.worldPosition(cell);
      for (const glm::dvec3& along : looks[turn++ % kTurns]) {
        const std::optional<SurfaceHit> hit = rays.first(eye, along);
        if (hit) seen.push_back({eye + hit->distance * along, hit->normalWorld, room});
      }
    }
  }
  return seen;
}

double bareShare(const std::vector<SeenPlace>& seen, const std::vector<Probe>& probes) {
  const Lit lit(probes);
  const auto bare = std::count_if(seen.begin(), seen.end(), [&](const SeenPlace& p) { return !lit(p.positionWorld); });
  return seen.empty() ? 0.0 : static_cast<double>(bare) / static_cast<double>(seen.size());
}

void growOverSeen(const std::vector<SeenPlace>& seen, const std::vector<Probe>& kept, double height,
                  std::vector<PlacedProbe>& probes, std::vector<std::pair<std::size_t, std::size_t>>& above) {
  const Lit litByKept(kept);
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (probes[i].part) continue;
    const Lit lit(probesOf(probes));
    Probe grown = probes[i].probe;
    bool any = false;
    for (const SeenPlace& place : seen) {
      if (place.room != probes[i].room || litByKept(place.positionWorld) || lit(place.positionWorld)) continue;
      if (influenceDistance(probes[i].probe, place.positionWorld) > height) continue;
      reachOver(grown, place.positionWorld, 0.01 * height);
      any = true;
    }
    if (!any) continue;
    std::vector<std::pair<std::size_t, std::size_t>> with = above;
    bool clash = false;
    for (std::size_t k = 0; k < probes.size() && !clash; ++k) {
      if (k == i || sharedVolume(grown, probes[k].probe) <= 1.001 * sharedVolume(probes[i].probe, probes[k].probe)) {
        continue;
      }
      clash = isAbove(with, i, k);
      with.emplace_back(i, k);
    }
    if (clash) continue;
    probes[i].probe = grown;
    above = std::move(with);
  }
}

std::optional<PlacedProbe> surroundingsProbe(const SurfaceRays& rays, const Rooms& rooms,
                                             const std::vector<SeenPlace>& seen, const std::vector<Probe>& probes) {
  constexpr std::size_t kPlaces = 400, kOrigins = 48;
  const double lift = 0.6 * rooms.region.height;
  const Lit lit(probes);
  std::vector<SeenPlace> bare;
  for (const SeenPlace& place : seen) {
    if (!lit(place.positionWorld)) bare.push_back(place);
  }
  if (bare.empty()) return std::nullopt;
  std::vector<glm::dvec3> places;
  const std::size_t stride = std::max<std::size_t>(1, bare.size() / kPlaces);
  for (std::size_t i = 0; i < bare.size(); i += stride) places.push_back(bare[i].positionWorld);
  std::optional<glm::dvec3> origin;
  std::size_t most = 0, room = 0;
  const std::size_t step = std::max<std::size_t>(1, bare.size() / kOrigins);
  for (std::size_t i = 0; i < bare.size(); i += step) {
    const glm::dvec3 from = bare[i].positionWorld, out = bare[i].normalWorld;
    const std::optional<SurfaceHit> hit = rays.first(from + 1e-3 * lift * out, out);
    if (hit && hit->distance < 1.3 * lift) continue;
    const glm::dvec3 at = from + lift * out;
    const std::optional<SurfaceHit> above = rays.first(at, {0.0, 1.0, 0.0});
    if (above) continue;  // outside is below the sky
    const auto count = static_cast<std::size_t>(
        std::count_if(places.begin(), places.end(), [&](const glm::dvec3& p) { return visibleFrom(rays, at, p); }));
    if (count > most) most = count, origin = at, room = bare[i].room;
  }
  if (!origin) return std::nullopt;
  PlacedProbe placed;
  placed.room = room;
  placed.part = true;
  placed.surroundings = true;
  Probe& probe = placed.probe;
  probe.origin = *origin;
  Box around{*origin - lift, *origin + lift};
  for (const glm::dvec3& along : fibonacciDirections(1024, 0.43)) {
    const std::optional<SurfaceHit> hit = rays.first(*origin, along);
    if (!hit) continue;
    const glm::dvec3 p = *origin + hit->distance * along;
    around = {glm::min(around.min, p), glm::max(around.max, p)};
  }
  const Box& all = rays.bounds();
  const double margin = 1e-3 * glm::length(all.size());
  probe.box = {around.min - margin, around.max + margin};
  probe.influence = Box{glm::min(all.min, probe.box.min) - margin, glm::max(all.max, probe.box.max) + margin};
  probe.blendDistance = {glm::dvec3(0.0), glm::dvec3(0.0)};
  probe.nearDistance = std::max(std::min(0.01, 0.05 * lift), 1e-6);
  probe.farDistance = std::max(2.0 * glm::length(all.size()), 10.0 * probe.nearDistance);
  placed.fit.probe = probe;
  return placed;
}

}  // namespace boxprobe
