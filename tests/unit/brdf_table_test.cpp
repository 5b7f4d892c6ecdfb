// The split-sum table against integrals that know nothing of how it was made: over half vectors in the textbook forms
// of the terms, and a path tracer's.
#include "filters/math/sampling/brdf_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "filters/math/sampling/brdf_integral.h"

namespace boxprobe {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Walter et al. 2007, equation 33, and height-correlated Smith masking (Heitz 2014, equation 99), summed over half
// vectors in angles that are dense where the distribution is high.
glm::dvec2 textbookAlbedo(double cosine, double roughness, int steps) {
  const double alpha = roughness * roughness, a2 = alpha * alpha;
  const glm::dvec3 v(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
  const auto lambda = [a2](double c) { return 0.5 * (std::sqrt(1.0 + a2 * (1.0 / (c * c) - 1.0)) - 1.0); };
  glm::dvec2 sum(0.0);
  for (int i = 0; i < steps; ++i) {
    // 1 - u = (1 - s)²: what is summed is smooth in s, up to half vectors in the surface.
    const double s = (i + 0.5) / steps, u = s * (2.0 - s), tangent = alpha * std::sqrt(u) / (1.0 - s);
    const double z = 1.0 / std::sqrt(1.0 + tangent * tangent), r = z * tangent;
    for (int j = 0; j < steps; ++j) {
      const double phi = kPi * (j + 0.5) / steps;
      const glm::dvec3 h(r * std::cos(phi), r * std::sin(phi), z);
      const double hDotV = glm::dot(h, v), light = 2.0 * hDotV * z - cosine;
      if (hDotV <= 0.0 || light <= 0.0) continue;
      // D G2 / (4 n.v) over the density D n.h / (4 h.v) of the directions.
      const double value = hDotV / (cosine * z) / (1.0 + lambda(light) + lambda(cosine)) * 2.0 * (1.0 - s);
      const double fresnel = std::pow(1.0 - hDotV, 5.0);
      sum += value * glm::dvec2(1.0 - fresnel, fresnel);
    }
  }
  return sum / (static_cast<double>(steps) * steps);
}

double difference(const glm::dvec2& a, const glm::dvec2& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.x + a.y - b.x - b.y)});
}

TEST(BrdfIntegral, IsTheTextbooks) {
  double worst = 0.0;
  for (const double roughness : {0.1, 0.25, 0.5, 0.75, 1.0}) {
    for (const double cosine : {0.05, 0.17, 0.25, 0.5, 0.9, 1.0}) {
      const double off = difference(integrateBrdf(cosine, roughness), textbookAlbedo(cosine, roughness, 1000));
      worst = std::max(worst, off);
      EXPECT_LT(off, 5.0e-5) << roughness << " at " << cosine;
    }
  }
  std::printf("  worst: %.1e\n", worst);
}

// The furnace of Cycles (Blender 4.3.2, single-scatter GGX), to the three digits it was read off with.
TEST(BrdfIntegral, IsAPathTracers) {
  constexpr double kRoughness[] = {0.25, 0.5, 0.75, 1.0}, kCosine[] = {0.17, 0.25, 0.5, 0.9};
  constexpr double kCycles[4][4] = {{0.934, 0.962, 0.988, 0.995},
                                    {0.857, 0.840, 0.857, 0.907},
                                    {0.791, 0.745, 0.663, 0.627},
                                    {0.672, 0.598, 0.451, 0.328}};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const glm::dvec2 ours = integrateBrdf(kCosine[j], kRoughness[i]);
      EXPECT_NEAR(ours.x + ours.y, kCycles[i][j], 1.0e-3) << kRoughness[i] << " at " << kCosine[j];
      const glm::vec2 table = splitSum(static_cast<float>(kCosine[j]), static_cast<float>(kRoughness[i]));
      EXPECT_NEAR(static_cast<double>(table.x + table.y), kCycles[i][j], 1.2e-3);
    }
  }
}

TEST(BrdfTable, IsOffByLittleBetweenItsTexels) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double worst = 0.0, usual = 0.0, squares = 0.0;
  constexpr int kPlaces = 4000;
  for (int i = 0; i < kPlaces; ++i) {
    const double across = unit(random), cosine = std::max(across * across, 1.0e-4), roughness = unit(random);
    const glm::dvec2 table(splitSum(static_cast<float>(cosine), static_cast<float>(roughness)));
    const double off = difference(table, integrateBrdf(cosine, roughness));
    worst = std::max(worst, off);
    squares += off * off;
    if (cosine > 0.01 && roughness > 0.08) usual = std::max(usual, off);
  }
  std::printf("  %d places: off by at most %.4f, from N.V .01 and roughness .08 on %.4f, root mean square %.5f\n",
              kPlaces, worst, usual, std::sqrt(squares / kPlaces));
  EXPECT_LT(worst, 0.01);
  EXPECT_LT(usual, 0.001);
}

TEST(BrdfTable, EndsAreTheMirrorAndTheEdge) {
  EXPECT_NEAR(splitSum(1.0f, 0.0f).x, 1.0f, 1.0e-4f);
  EXPECT_NEAR(splitSum(1.0f, 0.0f).y, 0.0f, 1.0e-4f);
  EXPECT_NEAR(splitSum(0.5f, 0.0f).x + splitSum(0.5f, 0.0f).y, 1.0f, 1.0e-4f);
  EXPECT_NEAR(splitSum(0.5f, 0.0f).y, 0.03125f, 1.0e-3f) << "Schlick's";
  for (const float bad : {-1.0f, 2.0f}) {
    for (const float other : {-3.0f, 0.4f, 7.0f}) {
      const glm::vec2 e = splitSum(bad, other);
      EXPECT_TRUE(e.x >= 0.0f && e.x + e.y <= 1.001f) << bad << " " << other;
    }
  }
}

}  // namespace
}  // namespace boxprobe
