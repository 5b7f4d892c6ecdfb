// The published forms at inputs that harm none of them, against the formulas as they are printed, in double precision.
#include <gtest/gtest.h>

#include <cmath>

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
