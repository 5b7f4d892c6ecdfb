// The box with rounded edges against the same in double precision, found by halving: inputs from plain to nasty.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "filters/math/shared/shared_math.h"

namespace {

using namespace boxprobe;
using glm::dvec3;
using glm::vec3;

struct Ray {
  vec3 position, direction, low, high;
  float bevel;
};

float sharpExit(const Ray& ray) {
  const vec3 t = shading::slabFactors(ray.position, ray.direction, ray.low, ray.high);
  return std::min({t.x, t.y, t.z});
}

/// The definition: the last point of the ray no farther than r from the inner box.
double exactExit(const Ray& ray) {
  const dvec3 p(ray.position), l(ray.direction), low(ray.low), high(ray.high);
  const dvec3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
  const dvec3 gaps = glm::max(glm::min(p - low, high - p), dvec3(0.0));
  std::array<double, 3> gap = {gaps.x, gaps.y, gaps.z};
  std::sort(gap.begin(), gap.end());
  const double r = std::min({static_cast<double>(ray.bevel), gap[0] + gap[1], half.x, half.y, half.z});
  double inside = 0.0, outside = 1e300;
  for (int i = 0; i < 3; ++i) {
    const double room = std::max(l[i] < 0.0 ? p[i] - low[i] : high[i] - p[i], 0.0);
    if (l[i] != 0.0) outside = std::min(outside, room / std::abs(l[i]));
  }
  for (int i = 0; i < 200; ++i) {
    const double t = 0.5 * (inside + outside);
    const dvec3 o = glm::max(glm::abs(p - middle + t * l) - (half - r), dvec3(0.0));
    (glm::dot(o, o) <= r * r ? inside : outside) = t;
  }
  return inside;
}

enum class Class { Inside, OnFace, AxisZero, NearEdge, FarOrigin, Tiny, Huge, Thin };

Ray randomRay(Class kind, std::mt19937& random) {
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::normal_distribution<double> gauss;
  const float size = kind == Class::Tiny ? 1e-25f : kind == Class::Huge ? 1e15f : 1.0f;
  const auto side = [&] { return size * (0.1f + 5.0f * unit(random)); };
  Ray ray;
  ray.low = -vec3(side(), side(), side());
  ray.high = vec3(side(), side(), side());
  if (kind == Class::Thin) ray.high.y = ray.low.y + 1e-3f * size;
  if (kind == Class::FarOrigin) {
    ray.low += 1000.0f;
    ray.high += 1000.0f;
  }
  ray.position = ray.low + (ray.high - ray.low) * vec3(unit(random), unit(random), unit(random));
  if (kind == Class::OnFace || kind == Class::NearEdge) ray.position.y = ray.low.y;
  if (kind == Class::NearEdge) ray.position.x = ray.low.x + 1e-3f * unit(random);
  dvec3 l(gauss(random), gauss(random), gauss(random));
  if (kind == Class::AxisZero) l.x = 0.0;
  ray.direction = vec3(glm::normalize(l));
  const vec3 half = 0.5f * (ray.high - ray.low);
  ray.bevel = 1.2f * std::min({half.x, half.y, half.z}) * std::pow(10.0f, -4.0f * unit(random));
  return ray;
}

TEST(RoundedBox, IsTheDefinitionWithin2e4OfTheBox) {
  constexpr std::size_t kCount = 20000;
  std::mt19937 random(5);
  const char* names[] = {"inside", "on a face", "axis zero", "near an edge", "far origin", "tiny", "huge", "thin"};
  for (int kind = 0; kind < 8; ++kind) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < kCount; ++i) {
      const Ray ray = randomRay(static_cast<Class>(kind), random);
      const float sharp = sharpExit(ray);
      const float t = shading::roundedBoxExit(ray.position, ray.direction, ray.low, ray.high, ray.bevel, sharp);
      ASSERT_TRUE(t >= 0.0f && t <= sharp) << names[kind] << " " << i;
      const vec3 size = ray.high - ray.low;
      errors.push_back(std::abs(static_cast<double>(t) - exactExit(ray)) /
                       static_cast<double>(std::max({size.x, size.y, size.z})));
    }
    std::sort(errors.begin(), errors.end());
    std::printf("  %-12s median %.1e, 99.99 %% %.1e, worst %.1e of the box\n", names[kind], errors[kCount / 2],
                errors[kCount * 9999 / 10000], errors.back());
    EXPECT_LE(errors[kCount * 9999 / 10000], 2e-4) << names[kind];
    EXPECT_LE(errors.back(), 1e-3) << names[kind];
  }
}

// Dragging the radius to 0 ends at the box, without a jump; a radius of 0 is the box to the bit.
TEST(RoundedBox, TendsToTheBox) {
  std::mt19937 random(6);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    Ray ray = randomRay(Class::Inside, random);
    const float sharp = sharpExit(ray);
    EXPECT_EQ(shading::roundedBoxExit(ray.position, ray.direction, ray.low, ray.high, 0.0f, sharp), sharp);
    ray.bevel = 1e-5f;
    const float t = shading::roundedBoxExit(ray.position, ray.direction, ray.low, ray.high, ray.bevel, sharp);
    worst = std::max(worst, static_cast<double>(glm::length((sharp - t) * ray.direction)));
  }
  // A corner is cut by (sqrt(3) - 1) r, along a slanted ray by more.
  EXPECT_LE(worst, 1e-3);
}

// What a host may hand over all the same: rays that go nowhere, boxes that are points or inside out, starts outside.
TEST(RoundedBox, IsFiniteForAnything) {
  const float values[] = {0.0f, -0.0f, 1e-38f, -1e-20f, 0.3f, -1.0f, 4.0f, 1e20f, -3e38f};
  std::mt19937 random(7);
  const auto any = [&] { return values[random() % 9]; };
  for (int i = 0; i < 200000; ++i) {
    const vec3 low(any(), any(), any()), high(any(), any(), any()), p(any(), any(), any()), l(any(), any(), any());
    const vec3 t = shading::slabFactors(p, l, low, high);
    const float sharp = std::min({t.x, t.y, t.z});
    if (!std::isfinite(sharp)) continue;  // differences beyond what a float holds
    const float exit = shading::roundedBoxExit(p, l, low, high, std::abs(any()), sharp);
    ASSERT_TRUE(exit >= 0.0f && exit <= sharp) << i << ": " << exit << " of " << sharp;
  }
}

}  // namespace
