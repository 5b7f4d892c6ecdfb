#include "filters/io/mesh/polygon_triangles.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace boxprobe {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Clips ears from a ring of corners in the plane (Meisters 1975).
class EarClipper {
 public:
  explicit EarClipper(std::vector<glm::dvec2> points) : points_(std::move(points)) {
    const auto count = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      next_.push_back(i + 1 == count ? 0 : i + 1);
      previous_.push_back(i == 0 ? count - 1 : i - 1);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      if (turn(i) < 0.0) reflex_.push_back(i);
    }
    testsLeft_ = 8 * points_.size() * points_.size();
  }

  bool convex() const { return reflex_.empty(); }

  std::vector<std::array<std::uint32_t, 3>> clip() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::uint32_t at = 0;
    for (std::size_t left = points_.size(); left > 3; --left) {
      const std::uint32_t ear = findEar(at, left);
      triangles.push_back({previous_[ear], ear, next_[ear]});
      next_[previous_[ear]] = next_[ear];
      previous_[next_[ear]] = previous_[ear];
      at = next_[ear];
    }
    triangles.push_back({previous_[at], at, next_[at]});
    return triangles;
  }

 private:
  double turn(std::uint32_t i) const { return cross(points_[previous_[i]], points_[i], points_[next_[i]]); }

  /// Where there is none, as in a polygon that crosses itself, a corner that turns the right way, or any.
  std::uint32_t findEar(std::uint32_t from, std::size_t left) {
    std::uint32_t at = from, flat = from;
    bool found = false;
    for (std::size_t tried = 0; tried < left; ++tried, at = next_[at]) {
      const double turned = turn(at);
      if (turned > 0.0 && isEmpty(at)) return at;
      if (!found && turned >= 0.0) {
        flat = at;
        found = true;
      }
    }
    return flat;
  }

  /// Does no reflex corner lie in the triangle at this corner? Corners in the same place as its own do not count.
  bool isEmpty(std::uint32_t ear) {
    const glm::dvec2 &a = points_[previous_[ear]], &b = points_[ear], &c = points_[next_[ear]];
    for (const std::uint32_t i : reflex_) {
      if (testsLeft_ == 0) return true;
      --testsLeft_;
      const glm::dvec2& p = points_[i];
      if (p == a || p == b || p == c || next_[previous_[i]] != i) continue;  // the last: clipped already
      if (cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  std::vector<glm::dvec2> points_;
  std::vector<std::uint32_t> next_, previous_, reflex_;
  std::size_t testsLeft_ = 0;  ///< bounds the time of polygons that cross themselves
};

}  // namespace

glm::dvec3 polygonNormal(const std::vector<glm::dvec3>& corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return sum;
}

std::vector<std::array<std::uint32_t, 3>> polygonTriangles(const std::vector<glm::dvec3>& corners) {
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
    EarClipper clipper(std::move(flat));
    if (!clipper.convex()) return clipper.clip();
  }
  for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

}  // namespace boxprobe
