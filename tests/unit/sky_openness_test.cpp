// Ambient occlusion against a quadrature of its own: things of spheres and boxes met by formulas, and the sky's light
// at places of their surfaces summed over many directions.
#include "filters/core/geometry/sky_openness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>

namespace boxprobe {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Ball {
  glm::dvec3 middle;
  double radius;
};

struct Crate {
  glm::dvec3 low, high;
};

/// A handful of solid things; backs are seen from within them.
class Things : public SightLines {
 public:
  std::vector<Ball> balls;
  std::vector<Crate> crates;

  bool empty() const override { return balls.empty() && crates.empty(); }
  bool blocked(const glm::dvec3& from, const glm::dvec3& to, bool) const override {
    const double length = glm::length(to - from);
    const auto met = first(from, (to - from) / length);
    return met && met->distance < length;
  }
  std::optional<Met> first(const glm::dvec3& from, const glm::dvec3& direction) const override {
    Met nearest;
    nearest.distance = 1e300;
    const auto take = [&nearest](double distance, bool back) {
      if (distance <= 1e-9 || distance >= nearest.distance) return;
      nearest.distance = distance;
      nearest.back = back;
    };
    for (const Ball& ball : balls) {
      const glm::dvec3 away = from - ball.middle;
      const double b = glm::dot(away, direction);
      const double root = b * b - glm::dot(away, away) + ball.radius * ball.radius;
      if (root <= 0.0) continue;
      take(-b - std::sqrt(root), false);
      take(-b + std::sqrt(root), true);
    }
    for (const Crate& crate : crates) {
      double enters = -1e300, leaves = 1e300;
      for (int axis = 0; axis < 3; ++axis) {
        double a = (crate.low[axis] - from[axis]) / direction[axis];
        double b = (crate.high[axis] - from[axis]) / direction[axis];
        if (a > b) std::swap(a, b);
        enters = std::max(enters, a);
        leaves = std::min(leaves, b);
      }
      if (enters >= leaves) continue;
      take(enters, false);
      take(leaves, true);
    }
    return nearest.distance < 1e300 ? std::optional(nearest) : std::nullopt;
  }

  bool within(const glm::dvec3& place) const {
    for (const Ball& ball : balls) {
      if (glm::length(place - ball.middle) < ball.radius) return true;
    }
    for (const Crate& crate : crates) {
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis) inside &= place[axis] > crate.low[axis] && place[axis] < crate.high[axis];
      if (inside) return true;
    }
    return false;
  }

  Box bounds() const override {
    Box box{glm::dvec3(1e300), glm::dvec3(-1e300)};
    for (const Ball& ball : balls) {
      box.min = glm::min(box.min, ball.middle - ball.radius);
      box.max = glm::max(box.max, ball.middle + ball.radius);
    }
    for (const Crate& crate : crates) {
      box.min = glm::min(box.min, crate.low);
      box.max = glm::max(box.max, crate.high);
    }
    return box;
  }
};

/// Share of an even sky's light: strata over the hemisphere, weighted by the cosine.
double quadrature(const SightLines& things, const glm::dvec3& place, const glm::dvec3& normal) {
  const glm::dvec3 any = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 across = glm::normalize(glm::cross(any, normal)), along = glm::cross(normal, across);
  constexpr int kRings = 24, kSectors = 48;
  int open = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const double u = (ring + 0.5) / kRings, sine = std::sqrt(u), cosine = std::sqrt(1.0 - u);
    for (int sector = 0; sector < kSectors; ++sector) {
      const double angle = 2.0 * kPi * (sector + 0.5 * (ring % 2)) / kSectors;
      const glm::dvec3 direction = sine * std::cos(angle) * across + sine * std::sin(angle) * along + cosine * normal;
      if (!things.first(place + 1e-6 * normal, direction)) ++open;
    }
  }
  return static_cast<double>(open) / (kRings * kSectors);
}

/// Three sides of a cube from 0 to 2, z = 2, y = 0 and z = 0, as sheets whose backs look inwards. A ray that starts in
/// one meets it, as among triangles.
class Sheets : public SightLines {
 public:
  bool empty() const override { return false; }
  Box bounds() const override { return {glm::dvec3(0.0), glm::dvec3(2.0)}; }
  bool blocked(const glm::dvec3& from, const glm::dvec3& to, bool) const override {
    const double length = glm::length(to - from);
    const auto met = first(from, (to - from) / length);
    return met && met->distance < length;
  }
  std::optional<Met> first(const glm::dvec3& from, const glm::dvec3& direction) const override {
    Met nearest;
    nearest.distance = 1e300;
    for (const auto& [axis, at] : {std::pair{2, 2.0}, {1, 0.0}, {2, 0.0}}) {
      const double distance = (at - from[axis]) / direction[axis];
      if (!(distance >= 0.0) || distance >= nearest.distance) continue;
      const glm::dvec3 place = from + distance * direction;
      bool inside = true;
      for (int other = 0; other < 3; ++other) inside &= other == axis || (place[other] >= 0.0 && place[other] <= 2.0);
      if (!inside) continue;
      nearest.distance = distance;
      nearest.back = (direction[axis] > 0.0) == (at == 2.0);
    }
    return nearest.distance < 1e300 ? std::optional(nearest) : std::nullopt;
  }
};

TEST(SkyOpenness, InnerSidesOfOpenSheetsSeeTheSkyThatTheySee) {
  const Sheets sheets;
  const SkyOpenness open = tracedSkyOpenness(sheets, {glm::dvec3(0.0), glm::dvec3(2.0)});
  for (const auto& [place, normal] : {std::pair<glm::dvec3, glm::dvec3>{{1.5, 0.7, 0.0}, {0, 0, 1}},
                                      {{0.4, 1.3, 0.0}, {0, 0, 1}},
                                      {{1.2, 0.0, 0.6}, {0, 1, 0}},
                                      {{0.7, 0.0, 1.5}, {0, 1, 0}},
                                      {{1.1, 0.8, 2.0}, {0, 0, -1}},
                                      {{1.1, 0.8, 2.0}, {0, 0, 1}},
                                      {{0.6, 0.0, 1.1}, {0, -1, 0}}}) {
    EXPECT_NEAR(open.at(place, normal), quadrature(sheets, place, normal), 0.15)
        << place.x << " " << place.y << " " << place.z << ", facing " << normal.y << " " << normal.z;
  }
}

TEST(SkyOpenness, IsTheQuadraturesAtSurfaces) {
  std::mt19937 random(5021);
  const auto number = [&](double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<double>()(random);
  };
  double squares = 0.0, without = 0.0, worst = 0.0;
  int count = 0;
  for (int scene = 0; scene < 6; ++scene) {
    Things things;
    things.crates.push_back({{-1.7, -0.31, -1.3}, {1.9, -0.02, 1.5}});  // a slab to stand on
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 low(number(-1.4, 0.7), -0.02, number(-1.1, 0.5));
      things.crates.push_back({low, low + glm::dvec3(number(0.3, 0.9), number(0.3, 1.4), number(0.3, 0.9))});
      const double radius = number(0.15, 0.5);
      things.balls.push_back({{number(-1.3, 1.3), radius - 0.02, number(-1.0, 1.0)}, radius});
    }
    const SkyOpenness open = tracedSkyOpenness(things, things.bounds());
    ASSERT_FALSE(open.empty());
    for (int sample = 0; sample < 300; ++sample) {
      glm::dvec3 place, normal(0.0);
      if (sample % 2 == 0) {
        const Ball& ball = things.balls[static_cast<std::size_t>(sample / 2) % things.balls.size()];
        do {
          normal = {number(-1, 1), number(-1, 1), number(-1, 1)};
        } while (glm::dot(normal, normal) > 1.0 || glm::dot(normal, normal) < 0.01);
        normal = glm::normalize(normal);
        place = ball.middle + ball.radius * normal;
      } else {
        const Crate& crate = things.crates[static_cast<std::size_t>(sample / 2) % things.crates.size()];
        const int axis = static_cast<int>(random() % 3);
        const bool high = random() % 2 == 0;
        for (int i = 0; i < 3; ++i) place[i] = number(crate.low[i], crate.high[i]);
        place[axis] = high ? crate.high[axis] : crate.low[axis];
        normal[axis] = high ? 1.0 : -1.0;
      }
      if (things.within(place + 1e-4 * normal)) continue;
      const double truth = quadrature(things, place, normal);
      const double off = static_cast<double>(open.at(place, glm::vec3(normal))) - truth;
      squares += off * off;
      without += (1.0 - truth) * (1.0 - truth);
      worst = std::max(worst, std::abs(off));
      ++count;
    }
  }
  const double rms = std::sqrt(squares / count);
  std::printf("  rms %.3f of the light at %d places, worst %.2f; without occlusion %.3f\n", rms, count, worst,
              std::sqrt(without / count));
  EXPECT_GT(count, 900);
  EXPECT_LT(rms, 0.1);
}

// What bulges hides nothing from itself.
TEST(SkyOpenness, ABallAloneIsOpenAllOver) {
  Things things;
  things.balls.push_back({{0.4, 1.1, -0.7}, 0.6});
  const SkyOpenness open = tracedSkyOpenness(things, things.bounds());
  ASSERT_FALSE(open.empty());
  double sum = 0.0;
  constexpr int kPlaces = 200;
  for (int i = 0; i < kPlaces; ++i) {
    const double y = 1.0 - (2.0 * i + 1.0) / kPlaces, r = std::sqrt(1.0 - y * y);
    const glm::dvec3 normal(r * std::cos(2.4 * i), y, r * std::sin(2.4 * i));
    const double light = static_cast<double>(open.at(glm::dvec3(0.4, 1.1, -0.7) + 0.6 * normal, glm::vec3(normal)));
    EXPECT_GT(light, 0.85) << i;
    sum += light;
  }
  std::printf("  mean %.3f of a ball that hides nothing\n", sum / kPlaces);
  EXPECT_GT(sum / kPlaces, 0.93);
}

TEST(SkyOpenness, OfNothingIsNone) {
  Things things;
  EXPECT_TRUE(tracedSkyOpenness(things, {glm::dvec3(0.0), glm::dvec3(1.0)}).empty());
  things.balls.push_back({{0.0, 0.0, 0.0}, 1.0});
  EXPECT_TRUE(tracedSkyOpenness(things, {glm::dvec3(0.3), glm::dvec3(0.3)}).empty());
  EXPECT_TRUE(tracedSkyOpenness(things, things.bounds(), [] { return true; }).empty());
}

}  // namespace
}  // namespace boxprobe
