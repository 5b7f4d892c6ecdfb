#include "data/scenes/soft_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

namespace boxprobe::scenes {
namespace {

constexpr double kTwoPi = 6.283185307179586;

int next(int axis) {
  return (axis + 1) % 3;
}

/// Texture coordinates of a point on the face across `axis`: u along the face's longer side.
glm::dvec2 faceUv(int axis, glm::dvec3 p, glm::dvec3 size, double metres, glm::dvec2 shift) {
  const int b = next(axis), c = next(b);
  const bool bLonger = size[b] > size[c];
  return glm::dvec2(bLonger ? p[b] : p[c], bLonger ? p[c] : p[b]) / metres + shift;
}

}  // namespace

MeshBuilder bevelBox(glm::dvec3 low, glm::dvec3 high, double bevel, double metres, glm::dvec2 shift) {
  MeshBuilder mesh;
  const glm::dvec3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
  const double r = std::min({bevel, 0.45 * half.x, 0.45 * half.y, 0.45 * half.z});
  // Of the face across each axis, by the signs along that axis and the two after it.
  std::array<std::array<std::uint32_t, 8>, 3> corner{};
  const auto slot = [](int a, int b, int c) {
    return static_cast<std::size_t>((a > 0 ? 1 : 0) + (b > 0 ? 2 : 0) + (c > 0 ? 4 : 0));
  };
  const auto at = [&](int axis, int a, int b, int c) { return corner[static_cast<std::size_t>(axis)][slot(a, b, c)]; };
  for (int axis = 0; axis < 3; ++axis) {
    const int second = next(axis), third = next(second);
    for (int a : {-1, 1}) {
      for (int b : {-1, 1}) {
        for (int c : {-1, 1}) {
          glm::dvec3 p(0.0), n(0.0);
          p[axis] = a * half[axis];
          p[second] = b * (half[second] - r);
          p[third] = c * (half[third] - r);
          n[axis] = a;
          corner[static_cast<std::size_t>(axis)][slot(a, b, c)] =
              mesh.vertex(middle + p, n, faceUv(axis, p, half, metres, shift));
        }
      }
    }
  }
  const auto quad = [&mesh](std::array<std::uint32_t, 4> v, bool outwards) {
    if (!outwards) std::swap(v[1], v[3]);
    mesh.triangle(v[0], v[1], v[2]);
    mesh.triangle(v[0], v[2], v[3]);
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (int a : {-1, 1}) {
      quad({at(axis, a, -1, -1), at(axis, a, 1, -1), at(axis, a, 1, 1), at(axis, a, -1, 1)}, a > 0);
      for (int b : {-1, 1}) {  // the edge between this face and that across the next axis
        const int second = next(axis);
        quad({at(axis, a, b, -1), at(second, b, -1, a), at(second, b, 1, a), at(axis, a, b, 1)}, a * b > 0);
      }
    }
  }
  for (int x : {-1, 1}) {
    for (int y : {-1, 1}) {
      for (int z : {-1, 1}) {
        const std::uint32_t a = at(0, x, y, z), b = at(1, y, z, x), c = at(2, z, x, y);
        x* y* z > 0 ? mesh.triangle(a, b, c) : mesh.triangle(a, c, b);
      }
    }
  }
  return mesh;
}

MeshBuilder cushion(glm::dvec3 low, glm::dvec3 high, double radius, glm::dvec3 bulge, int cells, double metres) {
  const glm::dvec3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
  const double r = std::min({radius, 0.98 * half.x, 0.98 * half.y, 0.98 * half.z});
  struct Point {
    glm::dvec3 position, normal{0.0};
    glm::dvec2 uv;
  };
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (int axis = 0; axis < 3; ++axis) {
    const int second = next(axis), third = next(second);
    for (int side : {-1, 1}) {
      const auto first = static_cast<std::uint32_t>(points.size());
      for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
          // Closer together at the edges, where it bends.
          const auto spread = [cells](int k) { return -std::cos(0.5 * kTwoPi * k / cells); };
          glm::dvec3 unit;
          unit[axis] = side;
          unit[second] = 0.4 * (2.0 * i / cells - 1.0) + 0.6 * spread(i);
          unit[third] = 0.4 * (2.0 * j / cells - 1.0) + 0.6 * spread(j);
          const glm::dvec3 on = unit * half, inner = glm::clamp(on, r - half, half - r);
          glm::dvec3 p = on;
          if (on != inner) p = inner + r * glm::normalize(on - inner);
          const auto arch = [&](int a, int b) { return (1.0 - unit[a] * unit[a]) * (1.0 - unit[b] * unit[b]); };
          p[axis] += side * bulge[axis] * arch(second, third);
          points.push_back({p, glm::dvec3(0.0), faceUv(axis, p, half, metres, {})});
        }
      }
      const auto width = static_cast<std::uint32_t>(cells) + 1;
      for (std::uint32_t j = 0; j + 1 < width; ++j) {
        for (std::uint32_t i = 0; i + 1 < width; ++i) {
          const std::uint32_t a = first + j * width + i;
          std::array<std::uint32_t, 4> v = {a, a + 1, a + width + 1, a + width};
          if (side < 0) std::swap(v[1], v[3]);
          triangles.push_back({v[0], v[1], v[2]});
          triangles.push_back({v[0], v[2], v[3]});
        }
      }
    }
  }
  // One normal for all points of one place, so that the six faces meet without a seam.
  const auto place = [](glm::dvec3 p) {
    return std::tuple(std::lround(1e5 * p.x), std::lround(1e5 * p.y), std::lround(1e5 * p.z));
  };
  std::map<std::tuple<long, long, long>, glm::dvec3> normals;
  const auto area = [&points](const std::array<std::uint32_t, 3>& t) {
    return glm::cross(points[t[1]].position - points[t[0]].position, points[t[2]].position - points[t[0]].position);
  };
  for (const auto& t : triangles)
    for (const std::uint32_t i : t) normals[place(points[i].position)] += area(t);
  MeshBuilder mesh;
  for (const Point& p : points) mesh.vertex(middle + p.position, glm::normalize(normals[place(p.position)]), p.uv);
  for (const auto& t : triangles) {
    const glm::dvec3 across = area(t);
    if (!(glm::length(across) > 1e-8)) continue;
    // A thin cushion's rim turns too far for one normal: its small triangles are flat.
    const bool smooth = std::all_of(t.begin(), t.end(), [&](std::uint32_t i) {
      return glm::dot(glm::normalize(across), glm::normalize(normals[place(points[i].position)])) > 0.35;
    });
    std::array<std::uint32_t, 3> v = t;
    for (std::uint32_t& i : v) {
      if (!smooth) i = mesh.vertex(middle + points[i].position, glm::normalize(across), points[i].uv);
    }
    mesh.triangle(v[0], v[1], v[2]);
  }
  return mesh;
}

MeshBuilder tube(const std::vector<glm::dvec3>& points, const std::vector<double>& radii, int slices) {
  MeshBuilder mesh;
  const std::size_t count = points.size();
  glm::dvec3 side(0.0);
  double along = 0.0;
  std::vector<std::uint32_t> rings;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 direction = glm::normalize(points[std::min(i + 1, count - 1)] - points[i > 0 ? i - 1 : 0]);
    if (i == 0) side = std::abs(direction.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    side = glm::normalize(side - glm::dot(side, direction) * direction);
    const glm::dvec3 other = glm::cross(direction, side);
    if (i > 0) along += glm::length(points[i] - points[i - 1]);
    for (int end = 0; end < 2; ++end) {  // the ends' faces have vertices of their own
      if ((end == 1) != (i == 0 || i + 1 == count) && end == 1) continue;
      const auto first =
          mesh.vertex(points[i] + radii[i] * side, end == 0 ? side : (i == 0 ? -direction : direction), {0.0, along});
      for (int k = 1; k <= slices; ++k) {
        const double angle = k == slices ? 0.0 : kTwoPi * k / slices;
        const glm::dvec3 out = std::cos(angle) * side + std::sin(angle) * other;
        mesh.vertex(points[i] + radii[i] * out, end == 0 ? out : (i == 0 ? -direction : direction),
                    {static_cast<double>(k) / slices, along});
      }
      if (end == 0) {
        rings.push_back(first);
      } else {
        for (int k = 1; k + 1 < slices; ++k) {
          const auto a = first + static_cast<std::uint32_t>(k), b = a + 1;
          i == 0 ? mesh.triangle(first, b, a) : mesh.triangle(first, a, b);
        }
      }
    }
  }
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    for (int k = 0; k < slices; ++k) {
      const auto a = rings[i] + static_cast<std::uint32_t>(k), b = rings[i + 1] + static_cast<std::uint32_t>(k);
      mesh.triangle(a, a + 1, b + 1);
      mesh.triangle(a, b + 1, b);
    }
  }
  return mesh;
}

MeshBuilder turned(const std::vector<std::vector<glm::dvec2>>& runs, int slices) {
  MeshBuilder mesh;
  const auto addRun = [&](const std::vector<glm::dvec2>& run) {
    std::vector<glm::dvec2> normals;
    for (std::size_t i = 0; i < run.size(); ++i) {
      const glm::dvec2 step = run[std::min(i + 1, run.size() - 1)] - run[i > 0 ? i - 1 : 0];
      normals.push_back(glm::normalize(glm::dvec2(step.y, -step.x)));
    }
    MeshBuilder part;
    part.lathe(run, normals, slices);
    mesh.add(part, glm::dmat4(1.0));
  };
  for (const auto& run : runs) {
    // Where a profile turns by more than 50 degrees it has an edge.
    std::vector<glm::dvec2> smooth = {run.front()};
    for (std::size_t i = 1; i < run.size(); ++i) {
      smooth.push_back(run[i]);
      const bool last = i + 1 == run.size();
      if (last || glm::dot(glm::normalize(run[i] - run[i - 1]), glm::normalize(run[i + 1] - run[i])) < 0.64) {
        addRun(smooth);
        smooth = {run[i]};
      }
    }
  }
  return mesh;
}

MeshBuilder leaf(glm::dvec3 base, glm::dvec3 along, glm::dvec3 down, double length, double width, double bend) {
  MeshBuilder mesh;
  constexpr int kRows = 7;
  glm::dvec3 at = base, direction = glm::normalize(along);
  const glm::dvec3 side = glm::normalize(glm::cross(direction, down));
  std::uint32_t previous = 0;
  for (int row = 0; row <= kRows; ++row) {
    const double t = static_cast<double>(row) / kRows;
    const double half = 0.5 * width * (0.04 + std::pow(std::sin(0.5 * kTwoPi * std::pow(0.02 + 0.95 * t, 0.75)), 0.9));
    const glm::dvec3 up = glm::normalize(glm::cross(direction, side));
    const glm::dvec3 fold = 0.25 * half * up;  // the halves rise to both sides of the middle
    const auto a = mesh.vertex(at - half * side + fold, glm::normalize(up + 0.25 * side), {0.0, 1.0 - t});
    mesh.vertex(at, up, {0.5, 1.0 - t});
    mesh.vertex(at + half * side + fold, glm::normalize(up - 0.25 * side), {1.0, 1.0 - t});
    if (row > 0) {
      for (std::uint32_t k = 0; k < 2; ++k) {
        mesh.triangle(previous + k, a + k + 1, previous + k + 1);
        mesh.triangle(previous + k, a + k, a + k + 1);
      }
    }
    previous = a;
    direction = glm::normalize(direction + bend / kRows * down);
    at += length / kRows * direction;
  }
  return mesh;
}

}  // namespace boxprobe::scenes
