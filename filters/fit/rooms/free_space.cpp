// See free_space.h.
#include "filters/fit/rooms/free_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <utility>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/fit/box/face_planes.h"
#include "filters/math/sampling/van_der_corput.h"

namespace boxprobe {

namespace {

double quantileOfSorted(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

constexpr int kRegionRays = 8192;

/// The upright surfaces that horizontal rays from within a box along rotated axes meet.
std::vector<MetPoint> uprightHits(const SurfaceRays& rays, const glm::dmat3& worldFromAxes, const Box& within) {
  std::vector<MetPoint> hits;
  for (int i = 1; i <= kRegionRays; ++i) {
    const glm::dvec3 share(vanDerCorput(i, 2), vanDerCorput(i, 3), vanDerCorput(i, 5));
    const double angle = 2.0 * std::acos(-1.0) * vanDerCorput(i, 7);
    const glm::dvec3 from = worldFromAxes * (within.min + share * within.size());
    const glm::dvec3 along(std::cos(angle), 0.0, std::sin(angle));
    const std::optional<SurfaceHit> hit = rays.first(from, along);
    if (hit && std::abs(hit->normalWorld.y) < 0.5) {
      hits.push_back({from + hit->distance * along, hit->normalWorld, 1.0});
    }
  }
  return hits;
}

/// Bounds of all but the outermost few hits.
Box boundsOfHits(const std::vector<MetPoint>& hits, const glm::dmat3& worldFromAxes) {
  Box bounds;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const MetPoint& hit : hits) values.push_back((glm::transpose(worldFromAxes) * hit.position)[axis]);
    std::sort(values.begin(), values.end());
    bounds.min[axis] = quantileOfSorted(values, 0.003);
    bounds.max[axis] = quantileOfSorted(values, 0.997);
  }
  return bounds;
}

}  // namespace

std::optional<WalledRegion> walledRegion(const SurfaceRays& rays) {
  constexpr std::size_t kLeastHits = 24;
  const std::vector<MetPoint> wide = uprightHits(rays, glm::dmat3(1.0), rays.bounds());
  if (wide.size() < kLeastHits) return std::nullopt;
  const std::vector<MetPoint> hits = uprightHits(rays, glm::dmat3(1.0), boundsOfHits(wide, glm::dmat3(1.0)));
  if (hits.size() < kLeastHits) return std::nullopt;
  WalledRegion region;
  region.yaw = uprightYaw(hits).yaw;
  const glm::dmat3 axes = rotationMatrix({0.0, glm::degrees(region.yaw), 0.0});
  region.bounds = boundsOfHits(hits, axes);

  std::vector<double> heights;
  const glm::dvec3 up(0.0, 1.0, 0.0);
  for (int i = 1; i <= kRegionRays / 4; ++i) {
    const glm::dvec3 share(vanDerCorput(i, 2), vanDerCorput(i, 3), vanDerCorput(i, 5));
    const glm::dvec3 from = axes * (region.bounds.min + share * region.bounds.size());
    const std::optional<SurfaceHit> above = rays.first(from, up), below = rays.first(from, -up);
    if (above && below && above->back == below->back) heights.push_back(above->distance + below->distance);
  }
  region.height = region.bounds.size().y;
  if (heights.size() >= kLeastHits) {
    std::sort(heights.begin(), heights.end());
    region.height = quantileOfSorted(heights, 0.5);
  }
  return region.height > 0.0 ? std::optional(region) : std::nullopt;
}

glm::ivec3 FreeSpace::at(std::size_t index) const {
  const int i = static_cast<int>(index);
  return {i % count.x, i / count.x % count.y, i / (count.x * count.y)};
}

std::size_t FreeSpace::index(const glm::ivec3& at) const {
  return static_cast<std::size_t>(at.x) +
         static_cast<std::size_t>(count.x) *
             (static_cast<std::size_t>(at.y) + static_cast<std::size_t>(count.y) * static_cast<std::size_t>(at.z));
}

std::optional<std::size_t> FreeSpace::neighbour(std::size_t index, int axis, bool forward) const {
  glm::ivec3 next = at(index);
  next[axis] += forward ? 1 : -1;
  if (next[axis] < 0 || next[axis] >= count[axis]) return std::nullopt;
  const std::size_t other = this->index(next);
  if ((open[forward ? index : other] >> axis & 1) == 0 || depth[other] == 0.0f) return std::nullopt;
  return other;
}

namespace {

/// What the lines of the grid tell about a cell.
struct CellView {
  std::uint8_t met = 0, backs = 0;  ///< of 18 directions
  std::uint8_t near = 0;            ///< of the 18: no farther than the walls of a court are
  std::uint8_t above = 0;           ///< met of the five directions that lead up
  bool floor = false, ceiling = false;
  float nearest = std::numeric_limits<float>::infinity();
};

struct Crossing {
  double at = 0.0;
  bool back = false;  ///< seen from where the line comes from
};

/// Steps between cells, one for each pair of opposite directions.
const std::array<glm::ivec3, 9> kSteps = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, -1}, {1, 1, 0}, {1, -1, 0}, {0, 1, 1}, {0, 1, -1}}};
constexpr int kUnderCeiling = 12, kUnderSky = 14;

class Grid {
 public:
  Grid(const SurfaceRays& rays, const WalledRegion& region, FreeSpace& space) : rays_(rays), space_(space) {
    constexpr double kWanted = 0.2, kMostCells = 3.0e6;
    double cell = std::clamp(kWanted, region.height / 40.0, region.height / 10.0);
    // Floors and ceilings may lie a little beyond the walls.
    const glm::dvec3 margin(0.0, 0.04 * region.height, 0.0);
    const glm::dvec3 size = region.bounds.size() + 2.0 * margin;
    const auto cells = [&size](double each) { return glm::ceil(size / each) + 2.0; };
    const auto cellCount = [&cells](double each) { return cells(each).x * cells(each).y * cells(each).z; };
    while (cellCount(cell) > kMostCells) cell *= 1.1;
    space.worldFromGrid = rotationMatrix({0.0, glm::degrees(region.yaw), 0.0});
    space.cell = cell;
    space.count = glm::ivec3(cells(cell));
    // Avoids the planes on which walls may lie.
    space.first = region.bounds.min - margin - cell * glm::dvec3(0.4142, 0.2679, 0.3473);
    const auto all = static_cast<std::size_t>(cellCount(cell));
    views_.resize(all);
    space.open.assign(all, 0);
    space.depth.assign(all, 0.0f);
    reach_ = glm::length(rays.bounds().size()) + glm::length(size);
    court_ = 6.0 * region.height;
    skin_ = 1e-6 * reach_;
  }

  std::vector<CellView>& views() { return views_; }

  /// False if `progress` stopped it.
  bool look(const std::function<bool(double)>& progress) {
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
      const glm::ivec3 step = kSteps[i], count = space_.count;
      for (int z = 0; z < count.z; ++z) {
        for (int y = 0; y < count.y; ++y) {
          for (int x = 0; x < count.x; ++x) {
            const glm::ivec3 cell(x, y, z);
            if (!within(cell - step)) followLine(cell, step);
          }
        }
        const double done = (static_cast<double>(i) + static_cast<double>(z) / count.z) / kSteps.size();
        if (progress && !progress(done)) return false;
      }
    }
    return true;
  }

 private:
  bool within(const glm::ivec3& cell) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (cell[axis] < 0 || cell[axis] >= space_.count[axis]) return false;
    }
    return true;
  }

  void followLine(const glm::ivec3& begin, const glm::ivec3& step) {
    const glm::dvec3 along = space_.worldFromGrid * glm::normalize(glm::dvec3(step));
    const double pitch = space_.cell * glm::length(glm::dvec3(step));
    const glm::dvec3 start = space_.worldPosition(space_.index(begin));
    crossings_.clear();
    constexpr std::size_t kMost = 1000;  // a hedge or a broken mesh
    for (double at = -reach_; crossings_.size() < kMost;) {
      const std::optional<SurfaceHit> hit = rays_.first(start + at * along, along);
      if (!hit) break;
      at += hit->distance + skin_;
      crossings_.push_back({at, hit->back});
    }
    const bool level = step.y == 0, rising = step.y > 0;
    const int straight = step.x + step.y + step.z == 1 ? (step.x != 0 ? 0 : step.y != 0 ? 1 : 2) : -1;
    std::size_t next = 0;
    double position = 0.0;
    for (glm::ivec3 cell = begin; within(cell); cell += step, position += pitch) {
      while (next < crossings_.size() && crossings_[next].at <= position) ++next;
      const std::size_t index = space_.index(cell);
      CellView& view = views_[index];
      if (next > 0) {  // the space behind was entered from its other side
        const Crossing& behind = crossings_[next - 1];
        ++view.met;
        view.near = static_cast<std::uint8_t>(view.near + (position - behind.at < court_ ? 1 : 0));
        view.backs = static_cast<std::uint8_t>(view.backs + (behind.back ? 0 : 1));
        view.nearest = std::min(view.nearest, static_cast<float>(position - behind.at));
        if (straight == 1) view.floor = true;
        if (!level && !rising) ++view.above;
      }
      const bool more = next < crossings_.size();
      if (more) {
        ++view.met;
        view.near = static_cast<std::uint8_t>(view.near + (crossings_[next].at - position < court_ ? 1 : 0));
        view.backs = static_cast<std::uint8_t>(view.backs + (crossings_[next].back ? 1 : 0));
        view.nearest = std::min(view.nearest, static_cast<float>(crossings_[next].at - position));
        if (straight == 1) view.ceiling = true;
        if (rising) ++view.above;
      }
      if (straight >= 0 && (!more || crossings_[next].at > position + pitch)) {
        space_.open[index] = static_cast<std::uint8_t>(space_.open[index] | 1 << straight);
      }
    }
  }

  const SurfaceRays& rays_;
  FreeSpace& space_;
  std::vector<CellView> views_;
  std::vector<Crossing> crossings_;
  double reach_ = 0.0, skin_ = 0.0;
  double court_ = 0.0;  ///< walls farther away do not make a court
};

bool isAir(const CellView& view, bool backsAreFronts) {
  const int backs = backsAreFronts ? view.met - view.backs : view.backs;
  return view.met > 0 && 5 * backs <= 2 * view.met;
}

bool closedIn(const CellView& view) {
  return view.floor && (view.ceiling ? view.met >= kUnderCeiling : view.near >= kUnderSky);
}

/// Fills gaps in the indoor space, where a line of cells sees through door and window at once.
void fillHoles(FreeSpace& space, const std::vector<CellView>& views) {
  constexpr int kRounds = 2, kLeast = 4;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<std::size_t> filled;
    for (std::size_t i = 0; i < views.size(); ++i) {
      if (space.depth[i] > 0.0f || !views[i].floor || !isAir(views[i], space.backsAreFronts)) continue;
      int about = 0;
      for (int side = 0; side < 6; ++side) about += space.neighbour(i, side / 2, side % 2 == 1) ? 1 : 0;
      if (about >= kLeast) filled.push_back(i);
    }
    for (const std::size_t i : filled) space.depth[i] = std::min(views[i].nearest, 1e30f);
  }
}

/// Per cell, the share of the air around it, up to half of the rooms' height away and not behind walls, that has a
/// ceiling: rafters are no roof, and a beam's width of sky is no garden.
std::vector<float> roofShares(const FreeSpace& space, double height) {
  std::vector<float> shares(space.depth.size(), 0.0f);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    shares[i] = static_cast<float>(space.open[i] >> FreeSpace::kCeilingBit & 1);
  }
  const int reach = std::max(1, static_cast<int>(std::lround(0.5 * height / space.cell)));
  for (const int axis : {0, 2}) {
    std::vector<float> mean(shares.size(), 0.0f);
    for (std::size_t i = 0; i < shares.size(); ++i) {
      if (!(space.depth[i] > 0.0f)) continue;
      double sum = shares[i], count = 1.0;
      for (const bool forward : {false, true}) {
        std::size_t at = i;
        for (int step = 0; step < reach; ++step) {
          const std::optional<std::size_t> next = space.neighbour(at, axis, forward);
          if (!next) break;
          at = *next;
          sum += shares[at];
          count += 1.0;
        }
      }
      mean[i] = static_cast<float>(sum / count);
    }
    shares = std::move(mean);
  }
  return shares;
}

/// Marks what is outdoors: spaces without a ceiling from which much of the sky is seen. A space that opens to roofed
/// ones all around, and is smaller than they are, is a part of them below a hole in the roof or a skylight.
void markOutdoors(FreeSpace& space, const std::vector<CellView>& views, double height) {
  constexpr double kSky = 0.4, kHole = 0.5;  // of the upward directions; of the sides
  constexpr int kUpward = 5;
  constexpr std::size_t kNoPart = static_cast<std::size_t>(-1);
  const std::vector<float> shares = roofShares(space, height);
  const auto roofed = [&](std::size_t i) { return shares[i] >= 0.5f; };
  struct Part {
    std::vector<std::size_t> cells;
    double sky = 0.0, sides = 0.0;
    std::vector<std::size_t> beside;  // roofed cells
  };
  // Connected cells that are alike in having a ceiling.
  std::vector<std::size_t> partOf(views.size(), kNoPart);
  std::vector<Part> parts;
  for (std::size_t first = 0; first < views.size(); ++first) {
    if (!(space.depth[first] > 0.0f) || partOf[first] != kNoPart) continue;
    const std::size_t number = parts.size();
    Part part;
    part.cells.push_back(first);
    partOf[first] = number;
    for (std::size_t k = 0; k < part.cells.size(); ++k) {
      const std::size_t cell = part.cells[k];
      part.sky += 1.0 - static_cast<double>(views[cell].above) / kUpward;
      for (int side = 0; side < 6; ++side) {
        const std::optional<std::size_t> other = space.neighbour(cell, side / 2, side % 2 == 1);
        const bool alike = other && roofed(*other) == roofed(first);
        if (alike && partOf[*other] == kNoPart) {
          partOf[*other] = number;
          part.cells.push_back(*other);
        }
        if (alike || side / 2 == 1) continue;
        part.sides += 1.0;
        if (other) part.beside.push_back(*other);
      }
    }
    parts.push_back(std::move(part));
  }
  for (const Part& part : parts) {
    const auto cells = static_cast<double>(part.cells.size());
    if (roofed(part.cells.front()) || part.sky < kSky * cells) continue;
    std::vector<std::size_t> numbers;
    for (const std::size_t cell : part.beside) numbers.push_back(partOf[cell]);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    double around = 0.0;
    for (const std::size_t number : numbers) around += static_cast<double>(parts[number].cells.size());
    if (static_cast<double>(part.beside.size()) > kHole * part.sides && around > cells) continue;
    for (const std::size_t cell : part.cells) {
      space.open[cell] = static_cast<std::uint8_t>(space.open[cell] | 1 << FreeSpace::kOutdoorsBit);
    }
  }
}

/// Limits each depth to that of a neighbour plus the distance between them.
void relaxDepths(FreeSpace& space) {
  const auto pass = [&space](bool forward) {
    const glm::ivec3 n = space.count;
    for (std::size_t k = 0; k < space.depth.size(); ++k) {
      const std::size_t i = forward ? k : space.depth.size() - 1 - k;
      if (space.depth[i] == 0.0f) continue;
      const glm::ivec3 here = space.at(i);
      for (int dz = -1; dz <= 1; ++dz) {
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            const glm::ivec3 step(dx, dy, dz), there = here + step;
            if (step == glm::ivec3(0) || glm::any(glm::lessThan(there, glm::ivec3(0))) ||
                glm::any(glm::greaterThanEqual(there, n))) {
              continue;
            }
            const float other = space.depth[space.index(there)];
            const auto length = static_cast<float>(space.cell * glm::length(glm::dvec3(step)));
            if (other > 0.0f) space.depth[i] = std::min(space.depth[i], other + length);
          }
        }
      }
    }
  };
  pass(true);
  pass(false);
}

}  // namespace

std::optional<FreeSpace> freeSpace(const SurfaceRays& rays, const WalledRegion& region, bool backsAreFronts,
                                   const std::function<bool(double)>& progress) {
  FreeSpace space;
  Grid grid(rays, region, space);
  if (!grid.look(progress)) return std::nullopt;
  space.backsAreFronts = backsAreFronts;
  const std::vector<CellView>& views = grid.views();
  const double volume = space.cell * space.cell * space.cell;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!closedIn(views[i])) continue;
    if (isAir(views[i], backsAreFronts)) {
      space.depth[i] = std::clamp(views[i].nearest, 1e-6f, 1e30f);
    } else {
      space.backVolume += volume;
    }
  }
  fillHoles(space, views);
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i].ceiling) space.open[i] = static_cast<std::uint8_t>(space.open[i] | 1 << FreeSpace::kCeilingBit);
  }
  markOutdoors(space, views, region.height);
  // What is not indoors counts as being as near as a cell's own size, and so does the sky's side from below a roof.
  std::vector<std::size_t> edges;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (space.depth[i] == 0.0f) continue;
    for (int side = 0; side < 6; ++side) {
      glm::ivec3 there = space.at(i);
      const int axis = side / 2;
      there[axis] += side % 2 == 1 ? 1 : -1;
      const bool outside = there[axis] < 0 || there[axis] >= space.count[axis];
      const std::size_t other = outside ? i : space.index(there);
      const bool blocked = !outside && (space.open[side % 2 == 1 ? i : other] >> axis & 1) == 0;
      const bool sky = !outside && space.outdoors(other) != space.outdoors(i);
      if (outside || (!blocked && (space.depth[other] == 0.0f || sky))) edges.push_back(i);
    }
  }
  for (const std::size_t i : edges) space.depth[i] = std::min(space.depth[i], static_cast<float>(space.cell));
  relaxDepths(space);
  return space;
}

}  // namespace boxprobe
