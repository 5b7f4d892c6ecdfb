// Glass on its own: Fresnel and Snell against their definitions, the way through a ball and a block against geometry.
#include "filters/math/shared/refraction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "data/scenes/mesh_builder.h"
#include "filters/math/cube/glass_shell.h"

namespace boxprobe {
namespace {

using glm::dvec3;
using glm::vec3;
using shading::GlassObject;
using shading::GlassView;

GlassShell shellOf(scenes::MeshBuilder builder) {
  const Mesh mesh = std::move(builder).finish("glass", 0);
  return GlassShell(mesh.positions, mesh.normals, mesh.indices);
}

GlassObject solid(const GlassShell& shell, float ior) {
  GlassObject glass{};
  glass.ior = ior;
  glass.form = 3;
  glass.radius = shell.radius();
  return glass;
}

// The definition, with Snell's law by angles: n1 sin a = n2 sin b.
double fresnel(double cosine, double n1, double n2) {
  const double a = std::acos(cosine), sine = n1 / n2 * std::sin(a);
  if (sine >= 1.0) return 1.0;
  const double b = std::asin(sine);
  const double s = (n1 * std::cos(a) - n2 * std::cos(b)) / (n1 * std::cos(a) + n2 * std::cos(b));
  const double p = (n1 * std::cos(b) - n2 * std::cos(a)) / (n1 * std::cos(b) + n2 * std::cos(a));
  return 0.5 * (s * s + p * p);
}

TEST(Refraction, ReflectanceIsFresnels) {
  for (const double ior : {1.0, 1.1, 1.33, 1.5, 2.0, 2.4}) {
    for (double cosine = 0.01; cosine <= 1.0; cosine += 0.01) {
      EXPECT_NEAR(shading::dielectricReflectance(float(cosine), float(1.0 / ior)), fresnel(cosine, 1.0, ior), 2e-6);
      // From within, but for the critical angle itself, where the curve is upright.
      const double critical = std::sqrt(1.0 - 1.0 / (ior * ior));
      if (std::abs(cosine - critical) < 0.002) continue;
      EXPECT_NEAR(shading::dielectricReflectance(float(cosine), float(ior)), fresnel(cosine, ior, 1.0), 2e-5) << ior;
    }
  }
  EXPECT_FLOAT_EQ(shading::dielectricReflectance(1.0f, 1.0f / 1.5f), 0.04f);
  // A sheet: R + T R T + T R³ T + ...
  double sum = 0.1, inside = 0.9 * 0.1 * 0.9;
  for (int i = 0; i < 50; ++i, inside *= 0.01) sum += inside;
  EXPECT_NEAR(shading::sheetReflectance(0.1f), sum, 1e-6);
}

TEST(Refraction, DirectionsFollowSnell) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> angle(0.0f, 1.55f);
  for (int i = 0; i < 1000; ++i) {
    const float a = angle(random);
    const vec3 view(std::sin(a), std::cos(a), 0.0f);
    for (const float eta : {1.0f / 1.5f, 1.0f, 1.5f, 1.0f / 2.4f}) {
      const vec3 t = shading::refractedView(vec3(0, 1, 0), view, eta);
      const float sine = eta * std::sin(a);
      if (sine >= 1.0f) {
        EXPECT_EQ(t, vec3(0.0f)) << "totally reflected";
        continue;
      }
      EXPECT_NEAR(glm::length(t), 1.0f, 1e-6f);
      EXPECT_NEAR(-t.x, sine, 2e-6f) << "eta is n1 / n2";
      EXPECT_LT(t.y, 0.0f) << "beyond the surface";
    }
  }
}

TEST(Refraction, BeersLaw) {
  const vec3 half = shading::glassTransmittance(vec3(0.25f, 0.5f, 1.0f), 2.0f, 1.0f);
  EXPECT_NEAR(half.x, 0.5f, 1e-6f);
  EXPECT_NEAR(half.y, std::sqrt(0.5f), 1e-6f);
  EXPECT_EQ(half.z, 1.0f);
  EXPECT_EQ(shading::glassTransmittance(vec3(0.0f), 0.0f, 5.0f), vec3(1.0f)) << "no distance: nothing is absorbed";
  EXPECT_EQ(shading::glassTransmittance(vec3(0.0f), 1.0f, 0.0f), vec3(1.0f)) << "at the surface";
}

// Two refractions by vectors, in double, on the exact ball.
struct BallPath {
  dvec3 direction;
  double distance;
};
BallPath throughBall(const dvec3& point, const dvec3& view, double ior) {
  const dvec3 n = point, in = glm::refract(-view, n, 1.0 / ior);
  const double t = -2.0 * glm::dot(point, in);
  return {glm::refract(in, -(point + t * in), ior), t};
}

TEST(Refraction, ThroughABallAsGeometryHasIt) {
  const GlassShell shell = shellOf(scenes::sphere(1.0, 96));
  ASSERT_TRUE(shell.fits()) << shell.described();
  std::mt19937 random(3);
  std::normal_distribution<double> gauss;
  double worst = 0.0, sum = 0.0;
  int count = 0;
  for (int i = 0; i < 4000; ++i) {
    const dvec3 point = glm::normalize(dvec3(gauss(random), gauss(random), gauss(random)));
    const dvec3 view = glm::normalize(dvec3(gauss(random), gauss(random), gauss(random)));
    if (glm::dot(point, view) < 0.15) continue;
    const float ior = 1.1f + 0.001f * static_cast<float>(i % 1300);
    const GlassView seen =
        shading::lookThroughGlass(&shell, solid(shell, ior), vec3(point), vec3(point), vec3(view), 0.0f, false, 3.0f);
    const BallPath truth = throughBall(point, view, double(ior));
    const double off = glm::length(dvec3(seen.through.direction) - truth.direction);
    worst = std::max(worst, off);
    sum += off;
    ++count;
    EXPECT_NEAR(seen.through.distance, truth.distance, 0.01);
  }
  std::printf("  ball: exit direction off by %.4f rad in the mean, %.4f at worst, of %d\n", sum / count, worst, count);
  EXPECT_LT(sum / count, 2e-3);
  EXPECT_LT(worst, 0.03);
}

TEST(Refraction, ABlockShiftsAndDoesNotTurn) {
  scenes::MeshBuilder builder;
  builder.box({-1.0, -0.7, -0.2}, {1.0, 0.7, 0.2}, scenes::repeating(1.0));
  const GlassShell shell = shellOf(std::move(builder));
  ASSERT_TRUE(shell.fits()) << shell.described();
  for (const float tilt : {0.0f, 0.3f, 0.8f, 1.2f}) {
    const vec3 view(std::sin(tilt), 0.0f, std::cos(tilt));
    const vec3 point(0.1f, -0.2f, 0.2f);
    const GlassView seen =
        shading::lookThroughGlass(&shell, solid(shell, 1.5f), point, vec3(0, 0, 1), view, 0.0f, false, 3.0f);
    EXPECT_LT(glm::length(seen.through.direction + view), 1e-3f) << tilt;
    const float inside = std::asin(std::sin(tilt) / 1.5f);
    EXPECT_NEAR(seen.through.distance, 0.4f / std::cos(inside), 2e-3f) << tilt;
    EXPECT_NEAR(seen.through.position.x, 0.1f - 0.4f * std::tan(inside), 2e-3f) << tilt;
  }
}

TEST(Refraction, WithinABlockTheCriticalAngleDecides) {
  scenes::MeshBuilder builder;
  builder.box(dvec3(-1.0), dvec3(1.0), scenes::repeating(1.0));
  const GlassShell shell = shellOf(std::move(builder));
  const float ior = 1.5f, critical = std::asin(1.0f / ior);
  for (float angle = 0.05f; angle < 0.78f; angle += 0.01f) {
    if (std::abs(angle - critical) < 0.005f) continue;
    // The eye in the middle looks at the face z = -1.
    const vec3 away(std::sin(angle), 0.0f, -std::cos(angle));
    const vec3 point = away / std::cos(angle);
    const GlassView seen = shading::lookThroughGlass(&shell, solid(shell, ior), point, vec3(0, 0, 1), -away, 0.0f, true,
                                                     glm::length(point));
    EXPECT_EQ(seen.reflectance >= 1.0f, angle > critical) << angle;
    EXPECT_TRUE(seen.followed);
    EXPECT_NEAR(seen.through.distance, glm::length(point), 1e-6f);
    if (angle > critical) continue;
    EXPECT_NEAR(seen.through.direction.x, ior * std::sin(angle), 1e-5f);
  }
}

TEST(Refraction, RatioOneChangesNothing) {
  const GlassShell shell = shellOf(scenes::sphere(1.0, 48));
  std::mt19937 random(5);
  std::normal_distribution<float> gauss;
  for (int i = 0; i < 1000; ++i) {
    const vec3 point = glm::normalize(vec3(gauss(random), gauss(random), gauss(random)));
    const vec3 view = glm::normalize(vec3(gauss(random), gauss(random), gauss(random)));
    if (glm::dot(point, view) <= 0.0f) continue;
    const GlassObject glass = solid(shell, 1.0f);
    const GlassView seen = shading::lookThroughGlass(&shell, glass, point, point, view, 0.5f, false, 3.0f);
    EXPECT_LT(seen.reflectance, 1e-5f);
    EXPECT_LT(seen.through.alpha, 1e-5f) << "a rough surface without a step of index scatters nothing";
    EXPECT_LT(glm::length(seen.through.direction + view), 1e-5f);
  }
}

TEST(Refraction, AShellThatItsMiddleDoesNotSeeIsSaidSo) {
  scenes::MeshBuilder ring;
  std::vector<glm::dvec2> profile, normals;
  for (int i = 0; i <= 24; ++i) {
    const double a = -2.0 * 3.14159265358979 * i / 24.0;
    profile.emplace_back(0.7 + 0.2 * std::cos(-a), 0.2 * std::sin(-a));
    normals.emplace_back(std::cos(-a), std::sin(-a));
  }
  ring.lathe(profile, normals, 48);
  EXPECT_FALSE(shellOf(std::move(ring)).fits());
  scenes::MeshBuilder open;
  open.box(dvec3(-1.0), dvec3(1.0), scenes::repeating(1.0), scenes::kAllFaces & ~scenes::kPlusY);
  EXPECT_FALSE(shellOf(std::move(open)).fits());
}

// NaN, infinity and denormal numbers may come as indices, radii and thicknesses; the rest is mended before.
TEST(Refraction, NothingItMakesIsNotFinite) {
  const GlassShell shell = shellOf(scenes::sphere(1.0, 24));
  std::mt19937 random(11);
  std::normal_distribution<float> gauss;
  const float iors[] = {1e-30f, 1e-6f, 0.3f, 1.0f - 1e-7f, 1.0f, 1.0f + 1e-7f, 1.5f, 2.4f, 1e6f, 1e18f};
  const float lengths[] = {0.0f, 1e-38f, 1e-18f, 1.0f, 1e18f};
  std::size_t count = 0;
  for (int i = 0; i < 20000; ++i) {
    vec3 normal = glm::normalize(vec3(gauss(random), gauss(random), gauss(random)));
    vec3 view = glm::normalize(vec3(gauss(random), gauss(random), gauss(random)));
    if (i % 7 == 0) view = normal;
    if (i % 7 == 1) view = -normal;
    if (i % 7 == 2) view = glm::normalize(glm::cross(normal, vec3(0.3f, 0.5f, 0.7f)));
    if (i % 5 == 0) normal = vec3(0, 0, 1);
    GlassObject glass{};
    glass.ior = iors[i % 10];
    glass.form = 1 + i % 3;
    glass.sheet = i % 11 == 0;
    glass.thickness = lengths[i % 5];
    glass.radius = lengths[(i / 5) % 5];
    const vec3 position = vec3(gauss(random), gauss(random), gauss(random)) * lengths[(i / 25) % 5];
    const GlassView seen =
        shading::lookThroughGlass(i % 2 == 0 ? &shell : nullptr, glass, position, normal, view,
                                  static_cast<float>(i % 4) / 3.0f, i % 3 == 0, glm::length(position));
    for (const auto& ray : {seen.through, seen.mirrored}) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_TRUE(std::isfinite(ray.position[c]) && std::isfinite(ray.direction[c])) << i;
      }
      ASSERT_NEAR(glm::length(ray.direction), 1.0f, 1e-4f) << i;
      ASSERT_TRUE(std::isfinite(ray.distance) && ray.alpha >= 0.0f && ray.alpha <= 1.0f) << i;
      const vec3 left = shading::glassTransmittance(vec3(0.0f, 0.5f, 1.0f), lengths[i % 5], ray.distance);
      for (int c = 0; c < 3; ++c) ASSERT_TRUE(left[c] >= 0.0f && left[c] <= 1.0f) << i;
      ASSERT_TRUE(std::isfinite(shading::glassDeviation(glass, ray, position, view))) << i;
    }
    ASSERT_TRUE(seen.reflectance >= 0.0f && seen.reflectance <= 1.0f) << i;
    ++count;
  }
  EXPECT_EQ(count, 20000u);
}

}  // namespace
}  // namespace boxprobe
