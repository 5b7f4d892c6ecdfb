// See find_rooms.h.
#include "filters/fit/rooms/find_rooms.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <tuple>
#include <utility>

namespace boxprobe {

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr double kLeastSide = 0.45;   // of the usual height: side of the smallest room, as a cube
constexpr double kLeastDepth = 0.12;  // of the usual height: half of the width of the narrowest room
constexpr double kOneRoom = 0.25;     // open share of the shared wall
constexpr double kDoorArea = 0.32;    // of the usual height squared
constexpr double kLintel = 0.06;      // of the usual height
constexpr double kRipple = 0.95;      // lesser narrowings are ignored
constexpr double kWallReach = 1.0;    // of the usual height, from the opening along its normal

/// Where two basins meet.
struct Opening {
  glm::dvec3 area{0.0};  ///< vector sum, from the first to the second
  glm::dvec3 sum{0.0};   ///< of the positions
  double faces = 0.0;
  double top = -1e300;
};

struct Basin {
  std::vector<std::size_t> cells;
  std::vector<std::size_t> parts;  ///< the basins that it consists of
  std::map<std::size_t, Opening> openings;
  double peak = 0.0;
};

class Watershed {
 public:
  Watershed(const FreeSpace& space, double height) : space_(space), height_(height) {
    flood();
    collect();
    connect();
  }

  void absorbSmall() {
    const double volume = std::pow(kLeastSide * height_, 3.0), each = std::pow(space_.cell, 3.0);
    std::vector<bool> alone(basins_.size(), false);
    for (;;) {
      std::size_t smallest = kNone;
      for (std::size_t i = 0; i < basins_.size(); ++i) {
        const Basin& basin = basins_[i];
        if (basin.cells.empty() || alone[i]) continue;
        const bool small =
            static_cast<double>(basin.cells.size()) * each < volume || basin.peak < kLeastDepth * height_;
        if (small && (smallest == kNone || basin.cells.size() < basins_[smallest].cells.size())) smallest = i;
      }
      if (smallest == kNone) return;
      std::size_t into = kNone;
      double most = 0.0;
      for (const auto& [other, opening] : basins_[smallest].openings) {
        if (opening.faces > most && alikeOutdoors(smallest, other)) into = other, most = opening.faces;
      }
      if (into == kNone) {
        alone[smallest] = true;
      } else {
        merge(into, smallest);
      }
    }
  }

  /// Records the current basins as the parts of rooms.
  void keepParts() {
    for (std::size_t i = 0; i < basins_.size(); ++i) {
      if (basins_[i].cells.empty()) continue;
      parts_[i] = basins_[i].cells;
      basins_[i].parts = {i};
    }
  }

  void mergeRooms() {
    std::map<std::pair<std::size_t, std::size_t>, double> known;
    for (;;) {
      std::pair<std::size_t, std::size_t> widest(kNone, kNone);
      double most = kOneRoom;
      for (std::size_t a = 0; a < basins_.size(); ++a) {
        for (const auto& [b, opening] : basins_[a].openings) {
          if (b < a || !alikeOutdoors(a, b)) continue;
          const auto [share, added] = known.try_emplace({a, b}, 0.0);
          if (added) share->second = isDoor(a, b, opening) ? 0.0 : openShare(a, b, opening);
          if (share->second > most) widest = {a, b}, most = share->second;
        }
      }
      if (widest.first == kNone) return;
      merge(widest.first, widest.second);
      for (auto each = known.begin(); each != known.end();) {
        const auto& [a, b] = each->first;
        const bool changed = a == widest.first || b == widest.first || a == widest.second || b == widest.second;
        each = changed ? known.erase(each) : std::next(each);
      }
    }
  }

  void moveTo(Rooms& found) {
    const double volume = std::pow(kLeastSide * height_, 3.0), each = std::pow(space_.cell, 3.0);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < basins_.size(); ++i) {
      const Basin& basin = basins_[i];
      if (basin.cells.empty()) continue;
      if (static_cast<double>(basin.cells.size()) * each < volume || basin.peak < kLeastDepth * height_) {
        ++found.hollows;
      } else {
        order.push_back(i);
      }
    }
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return basins_[a].cells.size() > basins_[b].cells.size();
    });
    std::map<std::size_t, std::size_t> roomOf;
    for (const std::size_t i : order) {
      roomOf[i] = found.rooms.size();
      Basin& basin = basins_[i];
      Room room;
      room.extent = extentOf(space_, basin.cells, space_.worldFromGrid);
      room.volume = each * static_cast<double>(basin.cells.size());
      room.outdoors = space_.outdoors(basin.cells.front());
      for (const std::size_t cell : basin.cells) room.roofed += space_.open[cell] >> FreeSpace::kCeilingBit & 1;
      room.roofed /= static_cast<double>(basin.cells.size());
      for (const std::size_t part : basin.parts) room.parts.push_back(std::move(parts_[part]));
      room.cells = std::move(basin.cells);
      found.rooms.push_back(std::move(room));
    }
    for (const std::size_t a : order) {
      for (const auto& [b, opening] : basins_[a].openings) {
        const auto other = roomOf.find(b);
        const double area = glm::length(opening.area);
        if (b > a && other != roomOf.end() && area > 0.0) {
          found.doorways.push_back({roomOf[a], other->second, area, opening.area / area});
        }
      }
    }
  }

 private:
  void flood() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < space_.depth.size(); ++i) {
      if (space_.depth[i] > 0.0f) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t a, std::size_t b) { return space_.depth[a] > space_.depth[b]; });
    label_.assign(space_.depth.size(), kNone);
    std::vector<double> peaks;
    for (const std::size_t cell : order) {
      std::size_t deepest = kNone;
      for (int side = 0; side < 6; ++side) {
        const std::optional<std::size_t> other = space_.neighbour(cell, side / 2, side % 2 == 1);
        if (!other || label_[*other] == kNone || space_.outdoors(*other) != space_.outdoors(cell)) continue;
        if (deepest == kNone || space_.depth[*other] > space_.depth[deepest]) deepest = *other;
      }
      if (deepest == kNone) {
        label_[cell] = peaks.size();
        above_.push_back(peaks.size());
        peaks.push_back(space_.depth[cell]);
        continue;
      }
      label_[cell] = label_[deepest];
      for (int side = 0; side < 6; ++side) {
        const std::optional<std::size_t> other = space_.neighbour(cell, side / 2, side % 2 == 1);
        if (!other || label_[*other] == kNone || space_.outdoors(*other) != space_.outdoors(cell)) continue;
        const std::size_t a = root(label_[cell]), b = root(label_[*other]);
        if (a == b || space_.depth[cell] < kRipple * std::min(peaks[a], peaks[b])) continue;
        above_[std::max(a, b)] = std::min(a, b);  // the older one has the higher peak
      }
    }
  }

  /// All cells of a basin are of one kind.
  bool alikeOutdoors(std::size_t a, std::size_t b) const {
    return space_.outdoors(basins_[a].cells.front()) == space_.outdoors(basins_[b].cells.front());
  }

  std::size_t root(std::size_t label) {
    while (above_[label] != label) label = above_[label] = above_[above_[label]];
    return label;
  }

  void collect() {
    std::vector<std::size_t> numbers(above_.size(), kNone);
    for (std::size_t cell = 0; cell < label_.size(); ++cell) {
      if (label_[cell] == kNone) continue;
      std::size_t& number = numbers[root(label_[cell])];
      if (number == kNone) {
        number = basins_.size();
        basins_.emplace_back();
      }
      label_[cell] = number;
      Basin& basin = basins_[number];
      basin.cells.push_back(cell);
      basin.peak = std::max<double>(basin.peak, space_.depth[cell]);
    }
    parts_.resize(basins_.size());
  }

  void connect() {
    const double area = space_.cell * space_.cell;
    for (std::size_t cell = 0; cell < label_.size(); ++cell) {
      if (label_[cell] == kNone) continue;
      for (int axis = 0; axis < 3; ++axis) {
        const std::optional<std::size_t> other = space_.neighbour(cell, axis, true);
        if (!other || label_[*other] == label_[cell]) continue;
        const std::size_t a = label_[cell], b = label_[*other];
        for (const auto& [from, to, sign] : {std::tuple(a, b, 1.0), std::tuple(b, a, -1.0)}) {
          Opening& opening = basins_[from].openings[to];
          opening.area[axis] += sign * area;
          opening.sum += space_.gridPosition(cell);
          opening.faces += 1.0;
          opening.top = std::max(opening.top, space_.gridPosition(cell).y + 0.5 * space_.cell);
        }
      }
    }
  }

  void merge(std::size_t into, std::size_t from) {
    Basin &a = basins_[into], &b = basins_[from];
    a.cells.insert(a.cells.end(), b.cells.begin(), b.cells.end());
    a.parts.insert(a.parts.end(), b.parts.begin(), b.parts.end());
    a.peak = std::max(a.peak, b.peak);
    a.openings.erase(from);
    for (const auto& [other, opening] : b.openings) {
      if (other == into) continue;
      basins_[other].openings.erase(from);
      for (const bool back : {false, true}) {
        Opening& sum = back ? basins_[other].openings[into] : a.openings[other];
        sum.area += back ? -opening.area : opening.area;
        sum.sum += opening.sum;
        sum.faces += opening.faces;
        sum.top = std::max(sum.top, opening.top);
      }
    }
    b = Basin{};
  }

  /// The highest cells of a basin around a place.
  double ceilingNear(const Basin& basin, const glm::dvec3& place) const {
    double top = -1e300;
    for (const std::size_t cell : basin.cells) {
      const glm::dvec3 p = space_.gridPosition(cell), off = p - place;
      if (std::max(std::abs(off.x), std::abs(off.z)) < 0.4 * height_ + space_.cell) top = std::max(top, p.y);
    }
    return top + 0.5 * space_.cell;
  }

  bool isDoor(std::size_t a, std::size_t b, const Opening& opening) const {
    const double area = glm::length(opening.area);
    if (std::abs(opening.area.y) > 0.7 * area || area > kDoorArea * height_ * height_) return false;
    const glm::dvec3 place = opening.sum / opening.faces;
    const double ceiling = std::min(ceilingNear(basins_[a], place), ceilingNear(basins_[b], place));
    return opening.top < ceiling - std::max(kLintel * height_, 0.5 * space_.cell);
  }

  /// The open share of the wall between two basins, seen along the opening's normal close to it.
  double openShare(std::size_t a, std::size_t b, const Opening& opening) const {
    const double area = glm::length(opening.area);
    if (!(area > 0.0)) return 0.0;
    const glm::dvec3 normal = opening.area / area, place = opening.sum / opening.faces;
    const glm::dvec3 u = glm::normalize(std::abs(normal.y) > 0.9 ? glm::cross(normal, glm::dvec3(1, 0, 0))
                                                                 : glm::cross(normal, glm::dvec3(0, 1, 0)));
    const glm::dvec3 v = glm::cross(normal, u);
    const auto seen = [&](const Basin& basin) {
      std::vector<std::pair<int, int>> spots;
      for (const std::size_t cell : basin.cells) {
        const glm::dvec3 off = space_.gridPosition(cell) - place;
        if (std::abs(glm::dot(off, normal)) > kWallReach * height_) continue;
        spots.emplace_back(static_cast<int>(std::floor(glm::dot(off, u) / space_.cell)),
                           static_cast<int>(std::floor(glm::dot(off, v) / space_.cell)));
      }
      std::sort(spots.begin(), spots.end());
      spots.erase(std::unique(spots.begin(), spots.end()), spots.end());
      return spots;
    };
    const std::vector<std::pair<int, int>> ofA = seen(basins_[a]), ofB = seen(basins_[b]);
    std::vector<std::pair<int, int>> shared;
    std::set_intersection(ofA.begin(), ofA.end(), ofB.begin(), ofB.end(), std::back_inserter(shared));
    const double wall = static_cast<double>(shared.size()) * space_.cell * space_.cell;
    return area / std::max(wall, area);
  }

  const FreeSpace& space_;
  double height_;
  std::vector<std::size_t> label_;  ///< per cell; after collect() its first basin
  std::vector<std::size_t> above_;  ///< per label, during flooding
  std::vector<Basin> basins_;
  std::vector<std::vector<std::size_t>> parts_;
};

}  // namespace

Box extentOf(const FreeSpace& space, const std::vector<std::size_t>& cells, const glm::dmat3& worldFromAxes) {
  constexpr double kLeftOut = 0.005;
  const glm::dmat3 axesFromGrid = glm::transpose(worldFromAxes) * space.worldFromGrid;
  Box extent;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    values.reserve(cells.size());
    for (const std::size_t cell : cells) values.push_back((axesFromGrid * space.gridPosition(cell))[axis]);
    const auto out = static_cast<std::ptrdiff_t>(kLeftOut * static_cast<double>(values.size()));
    std::nth_element(values.begin(), values.begin() + out, values.end());
    extent.min[axis] = *(values.begin() + out) - 0.5 * space.cell;
    std::nth_element(values.begin(), values.end() - 1 - out, values.end());
    extent.max[axis] = *(values.end() - 1 - out) + 0.5 * space.cell;
  }
  return extent;
}

std::optional<Rooms> findRooms(const SurfaceRays& rays, const RoomSettings& settings,
                               const std::function<bool(double)>& progress) {
  Rooms found;
  const std::optional<WalledRegion> region = walledRegion(rays);
  if (!region) return found;
  found.region = *region;
  const auto part = [&progress](double from, double to) {
    return [&progress, from, to](double done) { return !progress || progress(from + (to - from) * done); };
  };
  std::optional<FreeSpace> space = freeSpace(rays, *region, false, part(0.0, 0.5));
  if (!space) return std::nullopt;
  if (settings.inverted) {
    double fronts = 0.0;
    for (const float depth : space->depth) fronts += depth > 0.0f ? std::pow(space->cell, 3.0) : 0.0;
    if (space->backVolume > fronts) space = freeSpace(rays, *region, true, part(0.5, 0.9));
    if (!space) return std::nullopt;
  }
  found.space = std::move(*space);
  Watershed watershed(found.space, region->height);
  if (!part(0.9, 1.0)(0.3)) return std::nullopt;
  watershed.absorbSmall();
  watershed.keepParts();
  watershed.mergeRooms();
  watershed.moveTo(found);
  if (!part(0.9, 1.0)(1.0)) return std::nullopt;
  return found;
}

}  // namespace boxprobe
