#include "filters/core/geometry/flat_polygons.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace boxprobe {

namespace {

constexpr double kOneNormal = 1.0 - 1.5e-6;  // cosine of 0.1 degrees
constexpr double kFlatWithin = 1.0e-4;       // of the size of the whole
constexpr double kStraightWithin = 1.0e-6;   // sine between two edges, and of the size of the whole

using FlatLoop = std::vector<int>;  // vertices
using FlatEdge = std::pair<int, int>;

struct FlatTriangle {
  std::array<int, 3> vertex{};
  glm::dvec3 normal{0.0};  // unit
};

// Equal positions get the same number.
std::vector<int> weldedVertices(const std::vector<glm::dvec3>& positions) {
  std::map<std::array<double, 3>, int> first;
  std::vector<int> same;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec3& p = positions[i];
    same.push_back(first.emplace(std::array{p.x, p.y, p.z}, static_cast<int>(i)).first->second);
  }
  return same;
}

class JoinedVertices {
 public:
  explicit JoinedVertices(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int i) {
    while (parent_[static_cast<std::size_t>(i)] != i) {
      i = parent_[static_cast<std::size_t>(i)] =
          parent_[static_cast<std::size_t>(parent_[static_cast<std::size_t>(i)])];
    }
    return i;
  }
  void join(int a, int b) { parent_[static_cast<std::size_t>(root(a))] = root(b); }

 private:
  std::vector<int> parent_;
};

// The triangles of one plane.
class FlatRegion {
 public:
  FlatRegion(const std::vector<glm::dvec3>& positions, std::vector<FlatTriangle> triangles, double size)
      : positions_(positions), triangles_(std::move(triangles)), size_(size) {
    const glm::dvec3 n = triangles_.front().normal;
    origin_ = positions[static_cast<std::size_t>(triangles_.front().vertex[0])];
    x_ = glm::normalize(glm::cross(std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), n));
    y_ = glm::cross(n, x_);
  }

  std::vector<FlatLoop> convexLoops() const {
    const FlatLoop outline = onlyOutline();
    if (!outline.empty()) {
      const FlatLoop plain = withoutStraight(outline);
      if (convex(plain)) return {plain};
    }
    std::vector<FlatLoop> loops = mergedTriangles();
    for (FlatLoop& loop : loops) loop = withoutStraight(loop);
    return loops;
  }

 private:
  glm::dvec2 at(int vertex) const {
    const glm::dvec3 p = positions_[static_cast<std::size_t>(vertex)] - origin_;
    return {glm::dot(p, x_), glm::dot(p, y_)};
  }

  static double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

  // The outline if there is exactly one and it does not touch itself; else empty.
  FlatLoop onlyOutline() const {
    std::set<FlatEdge> edges;
    for (const FlatTriangle& t : triangles_) {
      for (std::size_t k = 0; k < 3; ++k) edges.insert({t.vertex[k], t.vertex[(k + 1) % 3]});
    }
    std::map<int, int> next;
    for (const FlatEdge& e : edges) {
      if (edges.count({e.second, e.first}) != 0) continue;
      if (!next.insert(e).second) return {};
    }
    if (next.empty()) return {};
    FlatLoop loop;
    const int start = next.begin()->first;
    int v = start;
    do {
      loop.push_back(v);
      const auto found = next.find(v);
      if (found == next.end() || loop.size() > next.size()) return {};
      v = found->second;
    } while (v != start);
    return loop.size() == next.size() ? loop : FlatLoop{};
  }

  FlatLoop withoutStraight(const FlatLoop& loop) const {
    FlatLoop kept = loop;
    for (std::size_t i = 0; kept.size() > 3 && i < kept.size();) {
      const std::size_t n = kept.size();
      const glm::dvec2 before = at(kept[(i + n - 1) % n]), here = at(kept[i]), after = at(kept[(i + 1) % n]);
      const double chord = glm::length(after - before);
      if (chord > 0.0 && std::abs(cross(here - before, after - before)) <= kStraightWithin * size_ * chord &&
          glm::dot(here - before, after - here) >= 0.0) {
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
    return kept;
  }

  // Is the loop counterclockwise and convex, with one turn?
  bool convex(const FlatLoop& loop) const {
    const std::size_t n = loop.size();
    if (n < 3) return false;
    double turn = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const glm::dvec2 here = at(loop[i]), in = here - at(loop[(i + n - 1) % n]), out = at(loop[(i + 1) % n]) - here;
      const double sine = cross(in, out), cosine = glm::dot(in, out);
      if (sine < -kStraightWithin * glm::length(in) * glm::length(out)) return false;
      turn += std::atan2(sine, cosine);
    }
    return std::abs(turn - 4.0 * std::acos(0.0)) < 1.0e-3;
  }

  // Two loops merged without the edge (a, b) of the first between them, and without the other edges they share next to
  // it.
  static FlatLoop joined(const FlatLoop& first, const FlatLoop& second, int a, int b) {
    const auto from = [](const FlatLoop& loop, int start, int end) {  // along the loop, with both ends
      FlatLoop way;
      auto i = static_cast<std::size_t>(std::find(loop.begin(), loop.end(), start) - loop.begin());
      for (std::size_t k = 0; k < loop.size(); ++k, ++i) {
        way.push_back(loop[i % loop.size()]);
        if (way.back() == end) break;
      }
      return way;
    };
    FlatLoop all = from(first, b, a);
    const FlatLoop other = from(second, a, b);
    all.insert(all.end(), other.begin() + 1, other.end() - 1);
    // Removes spikes, which go to a vertex and straight back.
    for (bool found = true; found && all.size() > 2;) {
      found = false;
      for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t n = all.size(), after = (i + 1) % n;
        if (all[(i + n - 1) % n] != all[after]) continue;
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(std::max(i, after)));
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(std::min(i, after)));
        found = true;
        break;
      }
    }
    return all;
  }

  // Removes edges between two polygons, the longest first, while the result is convex (Hertel and Mehlhorn).
  std::vector<FlatLoop> mergedTriangles() const {
    std::vector<FlatLoop> loops;
    std::map<FlatEdge, int> owner;
    std::vector<std::pair<double, FlatEdge>> edges;
    for (const FlatTriangle& t : triangles_) {
      for (std::size_t k = 0; k < 3; ++k) {
        const FlatEdge edge{t.vertex[k], t.vertex[(k + 1) % 3]};
        owner[edge] = static_cast<int>(loops.size());
        if (owner.count({edge.second, edge.first}) != 0) {
          edges.push_back({glm::length(at(edge.second) - at(edge.first)), edge});
        }
      }
      loops.emplace_back(t.vertex.begin(), t.vertex.end());
    }
    std::stable_sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& entry : edges) {
        const auto [a, b] = entry.second;
        const auto left = owner.find({a, b}), right = owner.find({b, a});
        if (left == owner.end() || right == owner.end() || left->second == right->second) continue;
        const int keep = left->second, gone = right->second;
        FlatLoop all = joined(loops[static_cast<std::size_t>(keep)], loops[static_cast<std::size_t>(gone)], a, b);
        if (!convex(all)) continue;
        for (const int loop : {keep, gone}) {
          const FlatLoop& old = loops[static_cast<std::size_t>(loop)];
          for (std::size_t i = 0; i < old.size(); ++i) owner.erase({old[i], old[(i + 1) % old.size()]});
        }
        for (std::size_t i = 0; i < all.size(); ++i) owner[{all[i], all[(i + 1) % all.size()]}] = keep;
        loops[static_cast<std::size_t>(keep)] = std::move(all);
        loops[static_cast<std::size_t>(gone)].clear();
        changed = true;
      }
    }
    loops.erase(std::remove_if(loops.begin(), loops.end(), [](const FlatLoop& l) { return l.empty(); }), loops.end());
    return loops;
  }

  const std::vector<glm::dvec3>& positions_;
  std::vector<FlatTriangle> triangles_;
  double size_;
  glm::dvec3 origin_{0.0}, x_{0.0}, y_{0.0};
};

}  // namespace

std::vector<FlatPolygon> flatPolygons(const std::vector<glm::dvec3>& positions,
                                      const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const std::vector<int> same = weldedVertices(positions);
  std::vector<FlatTriangle> all;
  std::set<std::array<int, 3>> seen;
  glm::dvec3 low(1.0e300), high(-1.0e300);
  for (const auto& t : triangles) {
    FlatTriangle corners;
    glm::dvec3 p[3];
    for (std::size_t k = 0; k < 3; ++k) {
      corners.vertex[k] = same[t[k]];
      p[k] = positions[t[k]];
    }
    const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double area = glm::length(n), longest = std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[0])});
    // Rejects areas that are rounding errors, and NaN.
    if (!(area > 1.0e-12 * longest * longest) || !std::isfinite(area)) continue;
    std::rotate(corners.vertex.begin(), std::min_element(corners.vertex.begin(), corners.vertex.end()),
                corners.vertex.end());
    if (!seen.insert(corners.vertex).second) continue;
    corners.normal = n / area;
    for (const glm::dvec3& corner : p) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    all.push_back(corners);
  }
  if (all.empty()) return {};
  const double size = glm::length(high - low);

  JoinedVertices components(positions.size());
  std::map<FlatEdge, int> owner;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = all[i].vertex[k], b = all[i].vertex[(k + 1) % 3];
      components.join(a, b);
      owner.emplace(FlatEdge{a, b}, static_cast<int>(i));
    }
  }
  std::vector<FlatPolygon> polygons;
  std::vector<bool> taken(all.size(), false);
  for (std::size_t seed = 0; seed < all.size(); ++seed) {
    if (taken[seed]) continue;
    const glm::dvec3 normal = all[seed].normal, point = positions[static_cast<std::size_t>(all[seed].vertex[0])];
    std::vector<FlatTriangle> plane;
    std::vector<std::size_t> open = {seed};
    taken[seed] = true;
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      plane.push_back(all[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto found = owner.find({all[i].vertex[(k + 1) % 3], all[i].vertex[k]});
        if (found == owner.end()) continue;
        const auto other = static_cast<std::size_t>(found->second);
        if (taken[other] || glm::dot(all[other].normal, normal) < kOneNormal) continue;
        bool flat = true;
        for (const int v : all[other].vertex) {
          flat &= std::abs(glm::dot(positions[static_cast<std::size_t>(v)] - point, normal)) <= kFlatWithin * size;
        }
        if (!flat) continue;
        taken[other] = true;
        open.push_back(other);
      }
    }
    const auto component = static_cast<std::size_t>(components.root(plane.front().vertex[0]));
    for (const FlatLoop& loop : FlatRegion(positions, std::move(plane), size).convexLoops()) {
      FlatPolygon polygon;
      polygon.component = component;
      for (const int v : loop) polygon.corners.push_back(positions[static_cast<std::size_t>(v)]);
      polygons.push_back(std::move(polygon));
    }
  }
  return polygons;
}

glm::dvec3 areaVector(const std::vector<glm::dvec3>& corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += 0.5 * glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return sum;
}

glm::dvec3 polygonCentroid(const std::vector<glm::dvec3>& corners) {
  const glm::dvec3 whole = areaVector(corners);
  const double size2 = glm::dot(whole, whole);
  if (corners.empty() || !(size2 > 0.0)) return corners.empty() ? glm::dvec3(0.0) : corners.front();
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const glm::dvec3 a = corners[i] - corners[0], b = corners[i + 1] - corners[0];
    sum += glm::dot(0.5 * glm::cross(a, b), whole) / size2 * (a + b) / 3.0;
  }
  return corners[0] + sum;
}

std::vector<glm::dvec3> withFewerCorners(std::vector<glm::dvec3> corners, std::size_t most) {
  most = std::max<std::size_t>(most, 3);
  if (corners.size() <= most) return corners;
  const double area = glm::length(areaVector(corners));
  const glm::dvec3 middle = polygonCentroid(corners);
  while (corners.size() > most) {
    const std::size_t n = corners.size();
    std::size_t least = 0;
    double smallest = 1.0e300;
    for (std::size_t i = 0; i < n; ++i) {
      const glm::dvec3 before = corners[(i + n - 1) % n], after = corners[(i + 1) % n];
      const double lost = glm::length(glm::cross(corners[i] - before, after - before));
      if (lost < smallest) {
        smallest = lost;
        least = i;
      }
    }
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(least));
  }
  const double left = glm::length(areaVector(corners));
  const double scale = left > 0.0 ? std::sqrt(area / left) : 1.0;
  const glm::dvec3 now = polygonCentroid(corners);
  for (glm::dvec3& corner : corners) corner = middle + scale * (corner - now);
  return corners;
}

}  // namespace boxprobe
