// See room_fit.h.
#include "filters/fit/room_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "filters/fit/lit_errors.h"
#include "filters/fit/place_influence.h"

namespace boxprobe {

Probe RoomFitter::start(const std::vector<std::size_t>& cells) const {
  const FreeSpace& space = rooms_.space;
  const std::size_t deepest = *std::max_element(
      cells.begin(), cells.end(), [&](std::size_t a, std::size_t b) { return space.depth[a] < space.depth[b]; });
  Probe probe;
  probe.origin = space.worldPosition(deepest);
  const double extent = space.cell * glm::length(glm::dvec3(space.count));
  probe.nearDistance = std::max(std::min(0.01, 0.1 * static_cast<double>(space.depth[deepest])), 1e-6);
  probe.farDistance = std::max(2.0 * extent, 10.0 * probe.nearDistance);
  const double degrees = glm::degrees(rooms_.region.yaw);
  setBoxAbout(probe, space, cells, {0.0, std::abs(degrees) < 0.2 ? 0.0 : degrees, 0.0});
  return probe;
}

/// Far from each other and from surfaces, the deepest first.
std::vector<glm::dvec3> RoomFitter::origins(const std::vector<std::size_t>& cells) const {
  constexpr std::size_t kOrigins = 16;
  const FreeSpace& space = rooms_.space;
  float peak = 0.0f;
  for (const std::size_t cell : cells) peak = std::max(peak, space.depth[cell]);
  std::vector<glm::dvec3> free, chosen;
  for (const std::size_t cell : cells) {
    if (space.depth[cell] >= 0.6f * peak) free.push_back(space.worldPosition(cell));
    if (chosen.empty() && space.depth[cell] == peak) chosen.push_back(space.worldPosition(cell));
  }
  std::vector<double> away(free.size(), 1e300);
  while (chosen.size() < kOrigins) {
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < free.size(); ++i) {
      away[i] = std::min(away[i], glm::length(free[i] - chosen.back()));
      if (away[i] > away[farthest]) farthest = i;
    }
    if (!(away[farthest] > 2.0 * space.cell)) break;
    chosen.push_back(free[farthest]);
  }
  return chosen;
}

std::optional<BoxFit> RoomFitter::fit(const std::vector<std::size_t>& cells, const FitProgress& progress) const {
  constexpr int kOriginRays = 512;
  Probe probe = start(cells);
  const ReflectedRays rays = reflectedRays(fitter_.placeOf(probe), probe, kOriginRays, kScoreTurn);
  double least = 1e300;
  Probe best = probe;
  for (const glm::dvec3& origin : origins(cells)) {
    probe.origin = origin;
    const double cost = litErrors(fitter_, rays, {probe}).meanDegrees;
    if (progress && !progress(0.0)) return std::nullopt;
    if (cost >= 0.98 * least) continue;
    least = cost;
    best = probe;
  }
  BoxFitSettings settings;
  settings.rays = rays_;
  return fitter_.fit(best, settings, progress);
}

}  // namespace boxprobe
