// Light of polygon lamps against quadrature in long double (tests/support/lamp_truth), and what must hold exactly.
#include "filters/math/shared/lamp_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/lamp_truth.h"

namespace {

using namespace boxprobe;
using glm::vec2;
using glm::vec3;
using test::LampCase;
using test::LongVec;

float diffuseOf(const LampCase& lamp) {
  const LampPolygon polygon = lamp.polygon();
  return shading::lampDiffuse(&polygon, vec3(0.0f), vec3(lamp.normal));
}

vec2 glossyOf(const LampPolygon& polygon, const vec3& normal, const vec3& view, float roughness) {
  return shading::lampGlossy(&polygon, vec3(0.0f), shading::lampLobe(normal, view, roughness));
}

LampPolygon polygonOf(const std::vector<vec3>& corners, bool bothSides = false) {
  LampPolygon lamp;
  lamp.count = static_cast<int>(corners.size());
  lamp.bothSides = bothSides;
  std::copy(corners.begin(), corners.end(), lamp.corners.begin());
  return lamp;
}

// Sizes over distance from a speck to a wall that fills nearly all there is to see.
TEST(LampMath, FormFactorsAreThoseOfQuadrature) {
  for (const double size : {0.001, 0.01, 0.1, 1.0, 10.0, 300.0}) {
    std::mt19937 random(static_cast<unsigned>(1000.0 * size));
    double worst = 0.0;
    int cut = 0, hidden = 0, lit = 0;
    for (int i = 0; i < 120; ++i) {
      const LampCase lamp = test::randomPolygon(random, size);
      const double truth = static_cast<double>(test::trueFormFactor(lamp.corners, lamp.normal));
      const double found = static_cast<double>(diffuseOf(lamp));
      const auto above = std::count_if(lamp.corners.begin(), lamp.corners.end(),
                                       [&](const LongVec& c) { return glm::dot(c, lamp.normal) > 0.0L; });
      hidden += above == 0 ? 1 : 0;
      cut += above > 0 && above < static_cast<std::ptrdiff_t>(lamp.corners.size()) ? 1 : 0;
      lit += truth > 0.0 ? 1 : 0;
      worst = std::max(worst, std::abs(found - truth));
      if (above == 0) {
        EXPECT_EQ(found, 0.0) << i;
      }
    }
    std::printf("  size %g: %d lit, %d cut by the horizon, %d below it; worst difference %.1e\n", size, lit, cut,
                hidden, worst);
    EXPECT_GT(lit, 40);
    EXPECT_GT(hidden, 2);
    if (size >= 1.0) {
      EXPECT_GT(cut, 15);
    }
    // Single precision: of the edges' angles; and corners a hundred distances away are rounded out of their plane.
    EXPECT_LT(worst, size > 1.0 ? 5.0e-5 : 1.5e-7 * size);
  }
}

// A lamp close to the surface's own plane, and a surface close to the lamp's: what a wall beside a lamp sees.
TEST(LampMath, GrazingLightIsThatOfQuadrature) {
  const vec3 corners[4] = {{0.4f, 1.3f, -0.7f}, {0.4f, -0.9f, -0.7f}, {0.4f, -0.9f, 1.1f}, {0.4f, 1.3f, 1.1f}};
  for (const float height : {0.3f, 0.03f, 0.003f, 0.0003f}) {
    for (const float turn : {0.0f, 0.4f, 1.2f, 1.55f}) {
      LampCase lamp;
      for (const vec3& c : corners) lamp.corners.emplace_back(height, c.y, c.z);
      // The lamp shines along -x, upon the origin.
      lamp.normal = LongVec(std::cos(turn), std::sin(turn), 0.0f);
      const double truth = static_cast<double>(test::trueFormFactor(lamp.corners, lamp.normal));
      EXPECT_NEAR(static_cast<double>(diffuseOf(lamp)), truth, 3.0e-5) << height << " " << turn;
      EXPECT_GT(truth, 0.0);
    }
  }
}

TEST(LampMath, ALampInPartsGivesTheSameLight) {
  std::mt19937 random(31);
  for (int i = 0; i < 300; ++i) {
    const LampCase lamp = test::randomPolygon(random, 1.7);
    const std::size_t n = lamp.corners.size();
    LampCase first = lamp, second = lamp;
    const LongVec at = 0.37L * lamp.corners[0] + 0.63L * lamp.corners[1];  // cut from an edge to a corner
    first.corners = {at, lamp.corners[1], lamp.corners[2]};
    second.corners = {at};
    for (std::size_t k = 2; k <= n; ++k) second.corners.push_back(lamp.corners[k % n]);
    if (second.corners.size() > shading::kLampCorners) continue;
    EXPECT_NEAR(static_cast<double>(diffuseOf(first) + diffuseOf(second)), static_cast<double>(diffuseOf(lamp)), 1.0e-6)
        << i;
  }
}

TEST(LampMath, SidesAreKept) {
  std::mt19937 random(77);
  int lit = 0;
  for (int i = 0; i < 300; ++i) {
    LampCase lamp = test::randomPolygon(random, 0.9);
    LampPolygon polygon = lamp.polygon(), turned = polygon;
    std::reverse(turned.corners.begin(), turned.corners.begin() + turned.count);
    const vec3 normal(lamp.normal), view(lamp.view);
    const float front = shading::lampDiffuse(&polygon, vec3(0.0f), normal);
    const vec2 glossy = glossyOf(polygon, normal, view, 0.45f);
    EXPECT_EQ(shading::lampDiffuse(&turned, vec3(0.0f), normal), 0.0f);
    EXPECT_EQ(glossyOf(turned, normal, view, 0.45f), vec2(0.0f));
    turned.bothSides = true;
    EXPECT_NEAR(shading::lampDiffuse(&turned, vec3(0.0f), normal), front, 2.0e-7f);
    EXPECT_NEAR(glossyOf(turned, normal, view, 0.45f).x, glossy.x, 0.03f * glossy.x + 1.0e-6f);
    polygon.bothSides = true;
    EXPECT_EQ(shading::lampDiffuse(&polygon, vec3(0.0f), normal), front);
    lit += front > 0.0f ? 1 : 0;
  }
  EXPECT_GT(lit, 100);
}

// Moved along, turned, scaled: the same light.
TEST(LampMath, LightDependsOnDirectionsAlone) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  for (int i = 0; i < 300; ++i) {
    const LampCase lamp = test::randomFloorLamp(random, 0.6);
    const LampPolygon polygon = lamp.polygon();
    const float roughness = 0.3f + 0.5f * unit(random), scale = std::exp(6.0f * unit(random) - 3.0f);
    const vec3 offset(3.1f * unit(random), -2.3f, 1.7f);
    LampPolygon moved = polygon;
    for (vec3& corner : moved.corners) corner = scale * corner + offset;
    const vec3 normal(lamp.normal), view(lamp.view);
    const shading::LampLobe lobe = shading::lampLobe(normal, view, roughness);
    const float diffuse = shading::lampDiffuse(&polygon, vec3(0.0f), normal);
    EXPECT_NEAR(shading::lampDiffuse(&moved, offset, normal), diffuse, 1.0e-5f + 1.0e-3f * diffuse)
        << i << " " << scale;
    const vec2 glossy = shading::lampGlossy(&polygon, vec3(0.0f), lobe);
    EXPECT_NEAR(shading::lampGlossy(&moved, offset, lobe).x, glossy.x, 2.0e-4f + 5.0e-3f * glossy.x) << i;
  }
}

// A ceiling without end over the surface: all of the hemisphere shines.
TEST(LampMath, ALampAllAroundGivesTheWholeLobe) {
  const LampPolygon ceiling = polygonOf({{-5000, -7000, 1}, {-5000, 6000, 1}, {8000, 6000, 1}, {8000, -7000, 1}});
  const vec3 up(0.0f, 0.0f, 1.0f);
  EXPECT_NEAR(shading::lampDiffuse(&ceiling, vec3(0.0f), up), 1.0f, 2.0e-4f);
  LampCase lamp;
  lamp.normal = LongVec(up);
  for (int i = 0; i < 4; ++i) lamp.corners.emplace_back(ceiling.corners[static_cast<std::size_t>(i)]);
  // Its edges lie along the horizon, where rough lobes end: what is least like a lamp of a room.
  for (const float roughness : {0.4f, 0.7f, 1.0f}) {
    for (const float elevation : {0.2f, 0.5f, 1.1f}) {
      const vec3 view(std::cos(elevation) * 0.6f, std::cos(elevation) * 0.8f, std::sin(elevation));
      lamp.view = glm::normalize(LongVec(view));
      const glm::dvec2 truth = test::trueGlossy(lamp, static_cast<double>(roughness));
      const vec2 found = glossyOf(ceiling, up, view, roughness);
      EXPECT_NEAR(static_cast<double>(found.x + found.y), truth.x + truth.y, 0.13) << roughness << " " << elevation;
      EXPECT_LE(found.x + found.y, 1.0f + 1.0e-5f);
    }
  }
}

// Floors seen under 8 to 30 degrees, lamps of that part of their size. rms error of the lamps' light over its rms, and
// mean light over the truth's: the table that build/release/tests/bench/lamp_lobe prints of more lamps.
void expectNearQuadrature(double roughness, double degrees, long double size, double metal, double dielectric) {
  std::mt19937 random(static_cast<unsigned>(100.0 * roughness + degrees));
  double off[2] = {}, whole[2] = {}, light[2] = {}, trueLight[2] = {};
  for (int i = 0; i < 50; ++i) {
    LampCase lamp = test::randomFloorLamp(random, degrees * 3.14159265358979 / 180.0);
    LongVec middle(0.0L);
    for (const LongVec& corner : lamp.corners) middle += corner / static_cast<long double>(lamp.corners.size());
    for (LongVec& corner : lamp.corners) corner = middle + size * (corner - middle);
    const glm::dvec2 truth = test::trueGlossy(lamp, roughness);
    const glm::dvec2 found(glossyOf(lamp.polygon(), vec3(lamp.normal), vec3(lamp.view), static_cast<float>(roughness)));
    for (int kind = 0; kind < 2; ++kind) {  // metal, F0 = F90 = 1; dielectric, F0 = 0.04
      const double f0 = kind == 0 ? 1.0 : 0.04, t = f0 * truth.x + truth.y, f = f0 * found.x + found.y;
      off[kind] += (f - t) * (f - t);
      whole[kind] += t * t;
      light[kind] += f;
      trueLight[kind] += t;
    }
  }
  for (int kind = 0; kind < 2; ++kind) {
    const double error = std::sqrt(off[kind] / whole[kind]), ratio = light[kind] / trueLight[kind];
    std::printf("  size %g, roughness %g, %g degrees, %s: error %.3f, light %.3f\n", static_cast<double>(size),
                roughness, degrees, kind == 0 ? "metal" : "dielectric", error, ratio);
    EXPECT_LT(error, kind == 0 ? metal : dielectric) << roughness << " " << degrees;
    EXPECT_NEAR(ratio, 1.0, 0.03) << roughness << " " << degrees << " " << kind;
  }
}

TEST(LampMath, GlossyLightIsNearThatOfQuadrature) {
  for (const double roughness : {0.25, 0.5, 0.75, 1.0}) {
    for (const double degrees : {8.0, 15.0, 30.0}) expectNearQuadrature(roughness, degrees, 1.0L, 0.05, 0.08);
  }
}

// Most of these are drawn by their corners alone.
TEST(LampMath, SmallLampsGlossyLightIsNearThatOfQuadrature) {
  for (const double roughness : {0.3, 0.5, 0.75, 1.0}) {
    for (const double degrees : {8.0, 15.0, 30.0, 60.0}) expectNearQuadrature(roughness, degrees, 0.2L, 0.03, 0.03);
  }
}

// Corners at the surface, on one line, all the same, a lamp of a kilometre seen from its plane, views from below: no
// light or light within bounds, and never a number that is none.
TEST(LampMath, DegenerateLampsGiveFiniteLight) {
  const vec3 zero(0.0f), up = glm::normalize(vec3(0.2f, 0.3f, 0.9f));
  const std::vector<LampPolygon> dark = {
      polygonOf({zero, zero, zero}), polygonOf({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}),
      polygonOf({{1, 0, 1}, {2, 0, 2}, {3, 0, 3}}, true),
      polygonOf({{-1, -2, 0}, {3, -2, 0}, {0, 4, 0}}, true),  // the surface lies in it
  };
  for (const LampPolygon& lamp : dark) {
    EXPECT_EQ(shading::lampDiffuse(&lamp, zero, up), 0.0f);
    EXPECT_EQ(glossyOf(lamp, up, glm::normalize(vec3(1, 0, 1)), 0.4f), vec2(0.0f));
  }
  const std::vector<LampPolygon> any = {
      polygonOf({zero, {2, 0, 1}, {0, 2, 1}}, true),
      polygonOf({{-1, -1, 1e-7f}, {1, -1, 1e-7f}, {1, 1, 1e-7f}, {-1, 1, 1e-7f}}, true),
      polygonOf({{-1e6f, -1e6f, 1}, {1e6f, -1e6f, 1}, {0, 1e6f, 1}}, true),
      polygonOf({{1e-9f, 0, 1e-9f}, {0, 1e-9f, 1e-9f}, {0, 0, 2e-9f}}, true),
      polygonOf({{1e12f, 0, 1e12f}, {0, 1e12f, 1e12f}, {0, 0, 2e12f}}, true),
      polygonOf({{-3, 0, 0}, {3, 1e-6f, 0}, {0, 2, 1}}, true),
      polygonOf({{-1, 0, -1}, {1, 0, -1}, {1, 1, 1}, {-1, 1, 1}}, true),
  };
  for (std::size_t i = 0; i < any.size(); ++i) {
    for (const vec3& normal : {vec3(0, 0, 1), vec3(0, 0, -1), up, vec3(1, 0, 0), vec3(0, 1, 0)}) {
      const float diffuse = shading::lampDiffuse(&any[i], zero, normal);
      EXPECT_TRUE(diffuse >= 0.0f && diffuse <= 1.0f) << i << " " << diffuse;
      for (const vec3& view : {vec3(0, 0, 1), -up, up, glm::normalize(vec3(1, 1e-5f, 1e-5f)), vec3(0, 0, -1)}) {
        for (const float roughness : {0.0f, 0.001f, 0.2f, 1.0f}) {
          const vec2 glossy = glossyOf(any[i], normal, view, roughness);
          EXPECT_TRUE(glossy.x >= 0.0f && glossy.y >= 0.0f && glossy.x + glossy.y <= 1.00001f)
              << i << " " << roughness << " " << glossy.x << " " << glossy.y;
        }
      }
    }
  }
}

}  // namespace
