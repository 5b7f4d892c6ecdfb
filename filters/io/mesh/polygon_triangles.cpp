#include "filters/io/mesh/polygon_triangles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace boxprobe {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Points of a plane in square cells, about one in each.
class PointGrid {
 public:
  PointGrid(const std::vector<glm::dvec2>& points, const std::vector<std::uint32_t>& chosen) {
    if (chosen.empty()) return;
    glm::dvec2 high = low_ = points[chosen.front()];
    for (const std::uint32_t i : chosen) {
      low_ = glm::min(low_, points[i]);
      high = glm::max(high, points[i]);
    }
    side_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(chosen.size()))));
    size_ = high - low_;
    const auto cellOf = [&](std::uint32_t i) { return side_ * at(points[i].y, 1) + at(points[i].x, 0); };
    first_.assign(side_ * side_ + 1, 0);
    for (const std::uint32_t i : chosen) ++first_[cellOf(i) + 1];
    for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    points_.resize(chosen.size());
    for (const std::uint32_t i : chosen) points_[next[cellOf(i)]++] = i;
  }

  /// Calls `take` with the points of all cells between two corners of a rectangle, until it returns false.
  template <typename Take>
  void within(const glm::dvec2& low, const glm::dvec2& high, const Take& take) const {
    if (points_.empty()) return;
    for (std::size_t y = at(low.y, 1); y <= at(high.y, 1); ++y) {
      // Cells of a row lie behind each other.
      const std::size_t first = side_ * y + at(low.x, 0), last = side_ * y + at(high.x, 0);
      for (std::uint32_t i = first_[first]; i < first_[last + 1]; ++i) {
        if (!take(points_[i])) return;
      }
    }
  }

 private:
  std::size_t at(double value, int axis) const {
    const auto side = static_cast<double>(side_);
    const double cell = size_[axis] > 0.0 ? (value - low_[axis]) / size_[axis] * side : 0.0;
    return static_cast<std::size_t>(std::min(std::max(0.0, cell), side - 1.0));  // NaN is 0
  }

  glm::dvec2 low_{0.0}, size_{0.0};
  std::size_t side_ = 1;
  std::vector<std::uint32_t> first_, points_;  ///< of each cell, its first; points by cell
};

/// Clips ears from a ring of corners in the plane (Meisters 1975). Cutting one changes the two corners beside it alone,
/// so each corner is tested once, and those two again.
class EarClipper {
 public:
  EarClipper(std::vector<glm::dvec2> points, PolygonTests& tests) : points_(std::move(points)), tests_(tests) {
    const auto count = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      next_.push_back(i + 1 == count ? 0 : i + 1);
      previous_.push_back(i == 0 ? count - 1 : i - 1);
    }
    std::vector<std::uint32_t> blocking;
    for (std::uint32_t i = 0; i < count; ++i) {
      blocks_.push_back(turn(i) < 0.0 || isFold(i));
      if (blocks_.back()) blocking.push_back(i);
    }
    convex_ = blocking.empty();
    grid_ = PointGrid(points_, blocking);
  }

  bool convex() const { return convex_; }

  std::vector<std::array<std::uint32_t, 3>> clip() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const auto count = static_cast<std::uint32_t>(points_.size());
    isEar_.assign(count, false);
    for (std::uint32_t i = 0; i < count; ++i) test(i);
    std::uint32_t at = 0;
    for (std::size_t left = count, known = 0; left > 3; --left) {
      while (known < ears_.size() && !isEar_[ears_[known]]) ++known;
      const std::uint32_t ear = known < ears_.size() ? ears_[known] : anyCorner(at, left);
      triangles.push_back({previous_[ear], ear, next_[ear]});
      next_[previous_[ear]] = next_[ear];
      previous_[next_[ear]] = previous_[ear];
      isEar_[ear] = blocks_[ear] = false;
      at = next_[ear];
      for (const std::uint32_t beside : {previous_[ear], next_[ear]}) {
        blocks_[beside] = blocks_[beside] && (turn(beside) < 0.0 || isFold(beside));
        test(beside);
      }
    }
    triangles.push_back({previous_[at], at, next_[at]});
    return triangles;
  }

 private:
  double turn(std::uint32_t i) const { return cross(points_[previous_[i]], points_[i], points_[next_[i]]); }

  /// A corner in the place of its neighbour, or one where the outline turns back on itself: nothing lies within.
  bool isFold(std::uint32_t i) const {
    const glm::dvec2 in = points_[i] - points_[previous_[i]], out = points_[next_[i]] - points_[i];
    return turn(i) == 0.0 && glm::dot(in, out) <= 0.0;
  }

  void test(std::uint32_t i) {
    const bool ear = isFold(i) || (turn(i) > 0.0 && isEmpty(i));
    if (ear && !isEar_[i]) ears_.push_back(i);
    isEar_[i] = ear;
  }

  /// Where there is no ear, as in a polygon that crosses itself: a corner that turns the right way, or any.
  std::uint32_t anyCorner(std::uint32_t from, std::size_t left) {
    std::uint32_t at = from;
    for (std::size_t tried = 0; tried < left && tests_.left > 0; ++tried, --tests_.left, at = next_[at]) {
      if (turn(at) >= 0.0) return at;
    }
    return from;
  }

  /// Does no corner that blocks lie in the triangle at this one? Those in the same place as its own do not count.
  bool isEmpty(std::uint32_t ear) {
    const glm::dvec2 &a = points_[previous_[ear]], &b = points_[ear], &c = points_[next_[ear]];
    bool empty = true;
    grid_.within(glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c), [&](std::uint32_t i) {
      if (tests_.left == 0) return false;
      --tests_.left;
      const glm::dvec2& p = points_[i];
      if (!blocks_[i] || p == a || p == b || p == c) return true;
      empty = !(cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0);
      return empty;
    });
    return empty;
  }

  std::vector<glm::dvec2> points_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<char> blocks_, isEar_;  ///< by corner
  std::vector<std::uint32_t> ears_;   ///< in the order in which they were found
  bool convex_ = false;
  PointGrid grid_{{}, {}};  ///< of corners that block at first
  PolygonTests& tests_;
};

}  // namespace

glm::dvec3 polygonNormal(const std::vector<glm::dvec3>& corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return sum;
}

std::vector<std::array<std::uint32_t, 3>> polygonTriangles(const std::vector<glm::dvec3>& corners,
                                                           PolygonTests& tests) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto count = static_cast<std::uint32_t>(corners.size());
  if (count < 3) return triangles;
  const glm::dvec3 normal = polygonNormal(corners), size = glm::abs(normal);
  // The plane in which the polygon is largest keeps its shape best.
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  if (count > 3 && size[axis] > 0.0) {
    std::vector<glm::dvec2> flat;
    for (const glm::dvec3& p : corners) {
      const glm::dvec2 q(p[(axis + 1) % 3] - corners[0][(axis + 1) % 3],
                         p[(axis + 2) % 3] - corners[0][(axis + 2) % 3]);
      flat.push_back(normal[axis] > 0.0 ? q : glm::dvec2(-q.x, q.y));
    }
    EarClipper clipper(std::move(flat), tests);
    if (!clipper.convex()) return clipper.clip();
  }
  for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

}  // namespace boxprobe
