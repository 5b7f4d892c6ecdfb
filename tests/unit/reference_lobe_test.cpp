// The reference's lobe against an integral over the whole hemisphere that knows nothing of sampling.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "filters/reference/trace/visible_normal_lobe.h"

namespace boxprobe {
namespace {

constexpr double kPi = 3.14159265358979323846;
const glm::dvec3 kNormal(0.0, 0.0, 1.0);

glm::dvec3 viewAt(double degrees) {
  const double a = degrees * kPi / 180.0;
  return {std::sin(a), 0.0, std::cos(a)};
}

// Walter et al. 2007, equation 33, and height-correlated Smith masking (Heitz 2014, equation 99) in their textbook
// forms.
double brdfTimesCosine(const glm::dvec3& l, const glm::dvec3& v, double alpha) {
  const glm::dvec3 h = glm::normalize(l + v);
  const double a2 = alpha * alpha, d = h.z * h.z * (a2 - 1.0) + 1.0;
  const double distribution = a2 / (kPi * d * d);
  const auto lambda = [a2](double c) { return 0.5 * (std::sqrt(1.0 + a2 * (1.0 / (c * c) - 1.0)) - 1.0); };
  const double masking = 1.0 / (1.0 + lambda(l.z) + lambda(v.z));
  return distribution * masking / (4.0 * v.z);
}

// Midpoint rule over half vectors, in angles that are dense where the distribution is high.
double integral(const glm::dvec3& v, double alpha, const std::function<double(const glm::dvec3&)>& f) {
  constexpr int kSteps = 600;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    // 1 - u = (1 - s)²: what is summed is smooth in s, up to half vectors in the surface.
    const double s = (i + 0.5) / kSteps, u = s * (2.0 - s), tangent = alpha * std::sqrt(u) / (1.0 - s);
    const double z = 1.0 / std::sqrt(1.0 + tangent * tangent), r = z * tangent;
    const double a2 = alpha * alpha, d = z * z * (a2 - 1.0) + 1.0;
    const double density = a2 / (kPi * d * d) * z;  // of half vectors drawn so
    for (int j = 0; j < kSteps; ++j) {
      const double phi = 2.0 * kPi * (j + 0.5) / kSteps;
      const glm::dvec3 h(r * std::cos(phi), r * std::sin(phi), z);
      const double hDotV = glm::dot(h, v);
      const glm::dvec3 l = 2.0 * hDotV * h - v;
      if (hDotV <= 0.0 || l.z <= 0.0) continue;
      sum += brdfTimesCosine(l, v, alpha) * f(l) * 4.0 * hDotV / density * 2.0 * (1.0 - s);
    }
  }
  return sum / (static_cast<double>(kSteps) * kSteps);
}

double surroundings(const glm::dvec3& l) {
  return 1.0 + l.x + 3.0 * std::max(l.y, 0.0) + 2.0 * l.z * l.z;
}

TEST(ReferenceLobe, WeightsAreTheBrdf) {
  for (const double roughness : {0.3, 0.6, 1.0}) {
    for (const double degrees : {0.0, 45.0, 80.0}) {
      SCOPED_TRACE("roughness " + std::to_string(roughness) + " at " + std::to_string(degrees));
      const double alpha = roughness * roughness;
      const glm::dvec3 v = viewAt(degrees);
      const VisibleNormalLobe lobe(kNormal, v, alpha);
      const ShiftedPoints points(7);
      constexpr int kRays = 200000;
      double albedo = 0.0, lit = 0.0;
      for (int i = 0; i < kRays; ++i) {
        const VisibleNormalLobe::Sample s = lobe.sample(points[i]);
        if (s.weight <= 0.0) continue;
        EXPECT_NEAR(glm::length(s.direction), 1.0, 1.0e-9);
        albedo += s.weight / kRays;
        lit += s.weight * surroundings(s.direction) / kRays;
      }
      EXPECT_NEAR(albedo, integral(v, alpha, [](const glm::dvec3&) { return 1.0; }), 3.0e-4);
      EXPECT_NEAR(lit, integral(v, alpha, surroundings), 1.0e-3);
    }
  }
}

TEST(ReferenceLobe, AConstantComesBackExactly) {
  const VisibleNormalLobe lobe(kNormal, viewAt(70.0), 1.0);
  const auto constant = [](const glm::dvec3&) { return glm::dvec3(0.25, 4.0, 50.0); };
  for (const int rays : {1, 8}) {
    const glm::dvec3 mean = lobeMean(lobe, glm::dvec3(0.9, 0.5, 0.0), glm::dvec3(1.0, 1.0, 0.0), rays, 3, constant);
    EXPECT_NEAR(mean.x, 0.25, 1e-12);
    EXPECT_NEAR(mean.y, 4.0, 1e-12);
    EXPECT_EQ(mean.z, 0.0) << "reflects no blue";
  }
}

TEST(ReferenceLobe, FresnelDrawsTheMeanTowardsGrazingDirections) {
  const VisibleNormalLobe lobe(kNormal, viewAt(60.0), 0.5);
  const auto low = [](const glm::dvec3& l) { return glm::dvec3(1.0 - l.z); };
  const glm::dvec3 mean = lobeMean(lobe, glm::dvec3(1.0, 0.04, 0.04), glm::dvec3(1.0), 4096, 5, low);
  EXPECT_GT(mean.y, 1.05 * mean.x);
}

TEST(ReferenceLobe, RoughnessZeroIsAMirrorWhateverTheView) {
  for (const glm::dvec3& v : {viewAt(0.0), viewAt(89.0), viewAt(100.0)}) {
    const VisibleNormalLobe lobe(kNormal, v, 0.0);
    EXPECT_TRUE(lobe.mirror());
    // From behind as edge-on: nothing is reflected from below the surface.
    const glm::dvec3 expected = 2.0 * std::max(glm::dot(kNormal, v), 0.0) * kNormal - v;
    EXPECT_LT(glm::distance(lobe.sample({0.3, 0.7}).direction, expected), 1e-15);
  }
}

TEST(ReferenceLobe, SeedsAreIndependent) {
  // Means over independent shifts scatter by what each is off; of equal shifts they would not.
  const VisibleNormalLobe lobe(kNormal, viewAt(60.0), 0.5);
  double sum = 0.0, squares = 0.0;
  constexpr int kSeeds = 400;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const ShiftedPoints points(hashBits(static_cast<std::uint64_t>(seed)));
    sum += points[0].x;
    squares += points[0].x * points[0].x;
  }
  EXPECT_NEAR(sum / kSeeds, 0.5, 4.0 * std::sqrt(1.0 / 12.0 / kSeeds));
  EXPECT_NEAR(squares / kSeeds, 1.0 / 3.0, 4.0 * std::sqrt(4.0 / 45.0 / kSeeds));
}

}  // namespace
}  // namespace boxprobe
