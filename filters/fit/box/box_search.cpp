// See box_search.h.
#include "filters/fit/box/box_search.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <queue>
#include <stdexcept>

namespace boxprobe {

namespace {

/// For one ray and one axis: where each offset of the exit face would end the ray, and the error there.
struct Ending {
  float distance, error;
};

constexpr double kFar = 1e30;  ///< a ray parallel to a face never meets it

}  // namespace

std::vector<RatedBox> bestCombinations(const LookupRays& rays, const std::array<std::vector<double>, kFaces>& offsets,
                                       std::size_t count, double yaw) {
  std::size_t most = 0;
  for (const std::vector<double>& each : offsets) {
    if (each.empty()) throw std::logic_error("bestCombinations: a face without an offset");
    most = std::max(most, each.size());
  }
  // Ordered by ray, then axis, then choice. Rays that leave towards -x do not depend on the face at +x and vice versa:
  // with the other four faces fixed, the two are rated separately.
  struct Row {
    std::array<std::uint8_t, 3> faces;
    std::uint32_t first;
  };
  std::vector<Row> rows;
  std::vector<Ending> endings;
  for (const LookupRay& ray : rays.rays) {
    Row row{{}, static_cast<std::uint32_t>(endings.size())};
    for (int axis = 0; axis < 3; ++axis) {
      const bool back = ray.along[axis] < 0.0;
      const int face = 2 * axis + (back ? 0 : 1);
      row.faces[static_cast<std::size_t>(axis)] = static_cast<std::uint8_t>(face);
      const std::vector<double>& choice = offsets[static_cast<std::size_t>(face)];
      for (std::size_t i = 0; i < most; ++i) {
        const double offset = choice[std::min(i, choice.size() - 1)];
        const double gap = std::max(offset - (back ? -1.0 : 1.0) * ray.from[axis], 0.0);
        const double speed = std::abs(ray.along[axis]);
        const double distance = speed * kFar > gap ? gap / speed : kFar;
        const double error = distance < kFar ? ray.weight * lookupError(ray, distance) : 0.0;
        endings.push_back({static_cast<float>(distance), static_cast<float>(error)});
      }
    }
    rows.push_back(row);
  }
  const auto worse = [](const RatedBox& a, const RatedBox& b) { return a.meanDegrees < b.meanDegrees; };
  std::priority_queue<RatedBox, std::vector<RatedBox>, decltype(worse)> best(worse);
  std::array<std::size_t, kFaces> at{};
  const auto rate = [&](double degrees) {
    if (best.size() == count && degrees >= best.top().meanDegrees) return;
    RatedBox rated;
    for (std::size_t face = 0; face < kFaces; ++face) rated.box.offset[face] = offsets[face][at[face]];
    rated.box.yaw = yaw;
    rated.meanDegrees = degrees;
    best.push(rated);
    if (best.size() > count) best.pop();
  };
  std::array<std::vector<double>, 2> sums;  // for the face at -x, at +x
  for (;;) {
    for (std::size_t side = 0; side < 2; ++side) sums[side].assign(offsets[side].size(), 0.0);
    for (const Row& row : rows) {
      const Ending* x = &endings[row.first];
      const Ending& y = x[most + at[row.faces[1]]];
      const Ending& z = x[2 * most + at[row.faces[2]]];
      const Ending& yz = y.distance < z.distance ? y : z;
      std::vector<double>& sum = sums[row.faces[0]];
      for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += x[i].distance < yz.distance ? x[i].error : yz.error;
      }
    }
    for (at[0] = 0; at[0] < offsets[0].size(); ++at[0]) {
      for (at[1] = 0; at[1] < offsets[1].size(); ++at[1]) rate(glm::degrees(sums[0][at[0]] + sums[1][at[1]]));
    }
    std::size_t face = 2;
    while (face < kFaces && ++at[face] == offsets[face].size()) at[face++] = 0;
    if (face == kFaces) break;
  }
  std::vector<RatedBox> sorted(best.size());
  for (std::size_t i = best.size(); i-- > 0; best.pop()) sorted[i] = best.top();
  return sorted;
}

namespace {

/// One way to change a box.
struct Move {
  std::array<double, kFaces> faces{};  ///< multiples of the step, scene units
  double yaw = 0.0;                    ///< multiple of the step, radians
  bool aboutMiddle = false;            ///< yaw rotates the box about its middle instead of the origin
};

std::vector<Move> movesOf(const PolishSettings& settings) {
  std::vector<Move> moves;
  for (std::size_t face = 0; face < kFaces; ++face) {
    if (!settings.faces[face]) continue;
    moves.emplace_back().faces[face] = 1.0;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!settings.faces[2 * axis] || !settings.faces[2 * axis + 1]) continue;
    for (const double other : {-1.0, 1.0}) {
      Move& move = moves.emplace_back();
      move.faces[2 * axis] = other;
      move.faces[2 * axis + 1] = 1.0;
    }
  }
  if (settings.yaw) {
    moves.emplace_back().yaw = 1.0;
    if (!(settings.faces[0] && settings.faces[1] && settings.faces[4] && settings.faces[5])) return moves;
    Move& middle = moves.emplace_back();
    middle.yaw = 1.0;
    middle.aboutMiddle = true;
  }
  return moves;
}

OffsetBox movedBox(const OffsetBox& box, const Move& move, double step, double extent, double nearest) {
  OffsetBox moved = box;
  for (std::size_t face = 0; face < kFaces; ++face) {
    moved.offset[face] = std::max(box.offset[face] + step * extent * move.faces[face], nearest);
  }
  moved.yaw += step * move.yaw;
  if (move.aboutMiddle) {
    // In the box's axes its middle rotates the opposite way.
    const double c = std::cos(step), s = std::sin(step);
    const double x = 0.5 * (box.offset[1] - box.offset[0]), z = 0.5 * (box.offset[5] - box.offset[4]);
    const double dx = c * x - s * z - x, dz = s * x + c * z - z;
    moved.offset[0] = std::max(moved.offset[0] - dx, nearest);
    moved.offset[1] = std::max(moved.offset[1] + dx, nearest);
    moved.offset[4] = std::max(moved.offset[4] - dz, nearest);
    moved.offset[5] = std::max(moved.offset[5] + dz, nearest);
  }
  return moved;
}

}  // namespace

RatedBox polished(const LookupRays& rays, const OffsetBox& start, const PolishSettings& settings) {
  constexpr int kMostTries = 3000;
  RatedBox best{start, meanError(rays, start)};
  const std::vector<Move> moves = movesOf(settings);
  std::vector<double> steps(moves.size(), settings.firstStep);
  for (int tries = 0; tries < kMostTries;) {
    bool all = true;  // all steps are small
    for (std::size_t k = 0; k < moves.size(); ++k) {
      if (std::abs(steps[k]) < settings.lastStep) continue;
      all = false;
      const double extent = 0.5 * (best.box.offset[0] + best.box.offset[1] + best.box.offset[4] + best.box.offset[5]);
      bool better = false;
      for (const double sign : {1.0, -1.0}) {
        const OffsetBox moved = movedBox(best.box, moves[k], sign * steps[k], extent, settings.nearest);
        const double error = meanError(rays, moved);
        ++tries;
        if (error >= best.meanDegrees * (1.0 - 1e-5)) continue;
        best = {moved, error};
        steps[k] *= 1.6 * sign;
        better = true;
        break;
      }
      if (!better) steps[k] *= 0.5;
    }
    if (all) break;
  }
  return best;
}

double extentOf(const OffsetBox& box) {
  return std::max({box.offset[0] + box.offset[1], box.offset[2] + box.offset[3], box.offset[4] + box.offset[5]});
}

OffsetBox withMargin(OffsetBox box, const LookupRays& rays, const std::array<bool, kFaces>& faces) {
  constexpr double kMargin = 1e-4, kNear = 0.02;
  const double extent = extentOf(box), allowed = 1.01 * meanError(rays, box) + 0.005;
  std::array<double, kFaces> needed = box.offset;
  for (const LookupRay& ray : turnedBy(rays, box.yaw).rays) {
    for (int face = 0; face < kFaces; ++face) {
      const double out = (face % 2 == 0 ? -1.0 : 1.0) * ray.from[face / 2];
      const auto index = static_cast<std::size_t>(face);
      if (out < box.offset[index] + kNear * extent) needed[index] = std::max(needed[index], out);
    }
  }
  for (std::size_t face = 0; face < kFaces; ++face) {
    if (!faces[face]) continue;
    OffsetBox moved = box;
    moved.offset[face] = needed[face];
    if (meanError(rays, moved) <= allowed) box = moved;
    box.offset[face] += kMargin * extent;
  }
  return box;
}

}  // namespace boxprobe
