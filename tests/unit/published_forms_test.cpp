// The published forms at inputs that harm none of them, against the formulas as they are printed, in double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "filters/math/published/published_math.h"

namespace boxprobe {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(PublishedForms, DistributionAndMaskingAreThoseOfWalter2007) {
  for (const double alpha : {0.04, 0.23, 0.61, 1.0}) {
    for (const double degrees : {0.0, 7.0, 31.0, 62.0, 84.0}) {
      const double cosine = std::cos(degrees * kPi / 180.0), tangent = std::tan(degrees * kPi / 180.0);
      const double spread = alpha * alpha + tangent * tangent;
      const double distribution = alpha * alpha / (kPi * std::pow(cosine, 4.0) * spread * spread);
      const double masking = 2.0 / (1.0 + std::sqrt(1.0 + alpha * alpha * tangent * tangent));
      const auto x = static_cast<float>(cosine), a = static_cast<float>(alpha);
      EXPECT_NEAR(shading::publishedDistribution(x, a) / distribution, 1.0, 2e-4) << alpha << " " << degrees;
      EXPECT_NEAR(shading::publishedMasking(x, a) / masking, 1.0, 1e-5) << alpha << " " << degrees;
    }
  }
}

// Share of the light that a white metal gives back in one reflection, seen at `cosine`: D of Walter et al. 2007
// (equation 33) over half vectors, by their own density, under a masking term of the view's and the light's cosine.
template <class Masking>
double sharesOneReflection(double cosine, double alpha, const Masking& masking) {
  constexpr int kSteps = 600;
  const double sine = std::sqrt(1.0 - cosine * cosine);
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    // As many half vectors far from the normal as near it: 1 - u = (1 - s)^2.
    const double s = (i + 0.5) / kSteps, tangent = alpha * std::sqrt(s * (2.0 - s)) / (1.0 - s);
    const double z = 1.0 / std::sqrt(1.0 + tangent * tangent);
    for (int j = 0; j < kSteps; ++j) {
      const double x = z * tangent * std::cos(kPi * (j + 0.5) / kSteps), hDotV = x * sine + z * cosine;
      const double light = 2.0 * hDotV * z - cosine;
      if (hDotV > 0.0 && light > 0.0) sum += 2.0 * (1.0 - s) * masking(cosine, light) * hDotV / (cosine * z);
    }
  }
  return sum / (static_cast<double>(kSteps) * kSteps);
}

// The three shares that the lesson lobe names. The fit is to blame, not that it takes view and light apart.
TEST(PublishedForms, TheFitSwallowsLightThatSmithsTermLeaves) {
  constexpr double kAlpha = 0.25, kCosine = 0.5;
  const auto fit = [](double c) { return c / (c * (1.0 - 0.5 * kAlpha) + 0.5 * kAlpha); };  // Karis 2013
  const auto lambda = [](double c) {                                                        // Heitz 2014, equation 72
    return 0.5 * (std::sqrt(1.0 + kAlpha * kAlpha * (1.0 / (c * c) - 1.0)) - 1.0);
  };
  const double fitted = sharesOneReflection(kCosine, kAlpha, [&](double v, double l) { return fit(v) * fit(l); });
  const double apart = sharesOneReflection(
      kCosine, kAlpha, [&](double v, double l) { return 1.0 / ((1.0 + lambda(v)) * (1.0 + lambda(l))); });
  const double together =
      sharesOneReflection(kCosine, kAlpha, [&](double v, double l) { return 1.0 / (1.0 + lambda(v) + lambda(l)); });
  std::printf("  of the light: %.4f by the fit, %.4f by Smith's term apart, %.4f together\n", fitted, apart, together);
  EXPECT_NEAR(fitted, 0.747, 5e-4);
  EXPECT_NEAR(apart, 0.855, 5e-4);
  EXPECT_NEAR(together, 0.857, 5e-4);
  const glm::vec2 printed =
      shading::publishedSplitSum(static_cast<float>(kCosine), static_cast<float>(std::sqrt(kAlpha)));
  EXPECT_NEAR(printed.x + printed.y, fitted, 0.004) << "the form that the lesson draws";
}

// GGX's projected area is 1: the integral of D cos over the hemisphere.
TEST(PublishedForms, DistributionCoversItsSurfaceOnce) {
  constexpr int kSteps = 20000;
  for (const float alpha : {0.17f, 0.45f, 0.9f}) {
    double area = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double cosine = (i + 0.5) / kSteps;
      area += 2.0 * kPi * cosine * shading::publishedDistribution(static_cast<float>(cosine), alpha) / kSteps;
    }
    EXPECT_NEAR(area, 1.0, 1e-3) << alpha;
  }
}

// The size of what a solid angle from P covers, seen from the capture origin: of a patch of the wall that is hit, both
// angles as they are.
TEST(PublishedForms, FootprintScaleIsTheQuotientOfTheSolidAngles) {
  shading::ProbeShape box{};
  box.boxMin = glm::vec3(-2.3f, -1.1f, -3.7f);
  box.boxMax = glm::vec3(1.9f, 2.6f, 4.2f);
  const glm::vec3 position(0.4f, -0.3f, 0.9f);
  const glm::vec3 directions[] = {{0.95f, 0.21f, -0.1f}, {-0.9f, 0.05f, 0.2f},  {0.15f, 0.98f, 0.07f},
                                  {0.05f, -0.97f, 0.2f}, {0.03f, 0.04f, 0.99f}, {0.1f, -0.05f, -0.98f}};
  for (const glm::vec3& given : directions) {
    const glm::vec3 direction = glm::normalize(given);
    const shading::ProbeHit hit = shading::publishedBoxSelect(box, position, direction);
    int axis = 0;
    double t = 1e30;
    for (int a = 0; a < 3; ++a) {
      const double plane = direction[a] < 0.0f ? box.boxMin[a] : box.boxMax[a];
      const double there = (plane - static_cast<double>(position[a])) / static_cast<double>(direction[a]);
      if (there < t) t = there, axis = a;
    }
    const glm::dvec3 point = glm::dvec3(position) + t * glm::dvec3(direction);
    const double distance = glm::length(point);
    const double cosineAtP = std::abs(static_cast<double>(direction[axis]));
    const double cosineAtC = std::abs(point[axis]) / distance;
    const double scale = t * t / (distance * distance) * cosineAtC / cosineAtP;
    EXPECT_NEAR(shading::publishedFootprintScale(box, hit, direction) / scale, 1.0, 0.02) << axis << " " << given.y;
  }
}

}  // namespace
}  // namespace boxprobe
