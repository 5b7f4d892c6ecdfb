// Polygons as triangles: no area is lost or counted twice, whatever the shape, and none takes longer than a file may.
#include "filters/io/mesh/polygon_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace boxprobe {
namespace {

using Points = std::vector<glm::dvec3>;

/// By the shoelace formula, and as the sum over the triangles, each of which turns as the polygon does.
void expectTiled(const Points& points, std::uint64_t most) {
  PolygonTests tests;
  const std::uint64_t before = tests.left;
  const auto triangles = polygonTriangles(points, tests);
  EXPECT_EQ(triangles.size(), points.size() - 2);
  EXPECT_LT(before - tests.left, most);
  double area = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 &a = points[i], &b = points[(i + 1) % points.size()];
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  for (const auto& [a, b, c] : triangles) {
    const double part = 0.5 * glm::cross(points[b] - points[a], points[c] - points[a]).z;
    EXPECT_GE(part * area, -1e-9 * area * area);
    sum += part;
  }
  EXPECT_NEAR(sum, area, 1e-9 * std::abs(area));
}

Points spiral(int count) {
  Points points;
  const auto at = [&](int i, double out) {
    const double angle = 40.0 * i / count, radius = 1.0 + angle + out;
    return glm::dvec3(radius * std::cos(angle), 1.3 * radius * std::sin(angle), 0.0);
  };
  for (int i = 0; i < count; ++i) points.push_back(at(i, 0.0));
  for (int i = count; i-- > 0;) points.push_back(at(i, 2.0));
  return points;
}

TEST(PolygonTriangles, LongConcaveOnesAreTiledInFewTests) {
  expectTiled(spiral(2048), 1000000);
  Points zigzag;  // a slanted band, along which each ear is found behind the one before
  const auto add = [&](int i, double side) {
    const double y = i % 2 * 1000.0 + side;
    zigzag.emplace_back(i + y, y, 0.0);
  };
  for (int i = 0; i <= 2046; ++i) add(i, -200.0);
  for (int i = 2046; i >= 0; --i) add(i, 200.0);
  expectTiled(zigzag, 40000000);
  Points star, comb;
  for (int i = 0; i < 4096; ++i) {
    const double angle = 6.283185307179586 * i / 4096, radius = 2.0 + std::sin(37.0 * angle) + 0.1 * (i * 7919 % 13);
    star.emplace_back(radius * std::cos(angle), 0.7 * radius * std::sin(angle), 0.0);
  }
  for (int i = 0; i < 1024; ++i) comb.insert(comb.end(), {{i, 0.0, 0.0}, {i + 0.4, 90.0, 0.0}});
  comb.insert(comb.end(), {{1024.0, 0.0, 0.0}, {1024.0, -1.0, 0.0}, {0.0, -1.5, 0.0}});
  expectTiled(star, 1000000);
  expectTiled(comb, 1000000);
  std::reverse(star.begin(), star.end());
  expectTiled(star, 1000000);
}

TEST(PolygonTriangles, DoubledCornersAndSlitsTakeNoPlace) {
  const Points bent = {{0, 0, 0}, {5, 0, 0}, {5, 1, 0}, {1.5, 1, 0}, {1, 4, 0}, {0, 3.5, 0}};
  for (std::size_t first = 0; first < bent.size(); ++first) {
    for (std::size_t doubled = 0; doubled < bent.size(); ++doubled) {
      for (const int times : {2, 3}) {
        Points points;
        for (std::size_t i = 0; i < bent.size(); ++i) {
          const std::size_t corner = (first + i) % bent.size();
          for (int k = 0; k < (corner == doubled ? times : 1); ++k) points.push_back(bent[corner]);
        }
        expectTiled(points, 1000);
      }
    }
    // There and back again, from a corner into the middle and out of the outline's.
    for (const glm::dvec3& tip : {glm::dvec3(0.5, 0.6, 0.0), glm::dvec3(-2.0, -3.0, 0.0)}) {
      Points points = {bent[0], tip};
      points.insert(points.end(), bent.begin(), bent.end());
      std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
      expectTiled(points, 1000);
    }
  }
}

TEST(PolygonTriangles, OnesThatCrossThemselvesShareTheFilesTests) {
  std::mt19937 random(5);
  Points points;
  for (int i = 0; i < 300; ++i) points.emplace_back(random() % 1000, random() % 700, 0.0);
  PolygonTests tests{40000};
  for (int polygon = 0; polygon < 20; ++polygon) {
    const auto triangles = polygonTriangles(points, tests);
    EXPECT_EQ(triangles.size(), points.size() - 2);
    for (const auto& triangle : triangles) EXPECT_LT(std::max({triangle[0], triangle[1], triangle[2]}), points.size());
  }
  EXPECT_EQ(tests.left, 0u);
}

TEST(PolygonTriangles, FlatAndTinyOnesAreNoTrouble) {
  PolygonTests tests;
  const double small = 1e-310;
  for (const Points& points : {Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}},
                               Points{{0, 0, 0}, {small, 0, 0}, {small, small, 0}, {small / 2, small / 8, 0}},
                               Points{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}, {1, 1, 0}}}) {
    EXPECT_EQ(polygonTriangles(points, tests).size(), points.size() - 2);
  }
}

}  // namespace
}  // namespace boxprobe
