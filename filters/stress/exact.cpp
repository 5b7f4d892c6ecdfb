// See exact.h.
#include "filters/stress/exact.h"

#include <algorithm>
#include <cmath>

namespace boxprobe::stress::exact {

namespace {

constexpr Real kFarthest = 3.0e38L;

Real within(Real x, Real low, Real high) {
  return std::min(std::max(x, low), high);
}

Vec centre(const Vec& low, const Vec& high) {
  return {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
}

Vec minus(const Vec& a, const Vec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// Uses the ray's actual length: a float ray is unit length only up to rounding.
Vec along(const Vec& p, Real t, const Vec& ray) {
  return {p[0] + t * ray[0], p[1] + t * ray[1], p[2] + t * ray[2]};
}

Real bounded(Real t, Real lengthD, Real cosC, Real cosP) {
  const Real d = std::max(lengthD, 1.0e-4L * t);
  return t * t / (d * d) * within(cosC, 0.0L, 1.0e6L) / std::max(cosP, 1.0e-3L);
}

}  // namespace

Vec vec(const glm::vec3& v) {
  return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}

Real dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Real length(const Vec& a) {
  return std::sqrt(dot(a, a));
}

Real farthest(const glm::vec3& a, const Vec& b) {
  Real worst = 0;
  for (int i = 0; i < 3; ++i) {
    const Real off = std::abs(static_cast<Real>(a[i]) - b[static_cast<std::size_t>(i)]);
    if (!(off <= worst)) worst = off;
  }
  return worst;
}

Real slabFactor(Real position, Real direction, Real low, Real high) {
  const Real gap = std::max(direction < 0 ? position - low : high - position, 0.0L);
  return direction == 0 ? kFarthest : std::min(gap / std::abs(direction), kFarthest);
}

BoxExit boxExit(const Vec& position, const Vec& ray, const Vec& low, const Vec& high) {
  BoxExit exit{};
  for (std::size_t i = 0; i < 3; ++i) exit.factors[i] = slabFactor(position[i], ray[i], low[i], high[i]);
  exit.distance = *std::min_element(exit.factors.begin(), exit.factors.end());
  for (std::size_t i = 0; i < 3; ++i) {
    exit.hit[i] = within(position[i] + exit.distance * ray[i], low[i], high[i]);
  }
  return exit;
}

Real roundedBoxExit(const Vec& position, const Vec& ray, const Vec& low, const Vec& high, Real bevel, Real exit) {
  const Vec middle = centre(low, high), p = minus(position, middle);
  Vec half{}, gaps{};
  for (std::size_t i = 0; i < 3; ++i) {
    half[i] = (high[i] - low[i]) / 2;
    gaps[i] = std::max(std::min(position[i] - low[i], high[i] - position[i]), 0.0L);
  }
  std::sort(gaps.begin(), gaps.end());
  const Real r = std::min({bevel, gaps[0] + gaps[1], *std::min_element(half.begin(), half.end())});
  if (!(r > 0) || exit >= kFarthest) return exit;
  const auto outside = [&](Real t) {
    const Vec x = along(p, t, ray);
    Real sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real beyond = std::max(std::abs(x[i]) - (half[i] - r), 0.0L);
      sum += beyond * beyond;
    }
    return sum > r * r;
  };
  if (!outside(exit)) return exit;
  Real in = 0, out = exit;
  for (int i = 0; i < 64; ++i) {  // exhausts the precision
    const Real t = (in + out) / 2;
    (outside(t) ? out : in) = t;
  }
  return in;
}

SphereExit sphereExit(const Vec& position, const Vec& ray, const Vec& low, const Vec& high) {
  SphereExit exit{};
  exit.radius = length(minus(high, low)) / 2;
  const Vec o = minus(position, centre(low, high));
  // |o + t R|² = r², R of any length.
  const Real a = dot(ray, ray), b = dot(o, ray) / a;
  const Vec foot = along(o, -b, ray);
  const Real height2 = dot(foot, foot);
  const Real root2 = (exit.radius * exit.radius - height2) / a;
  const Real root = root2 > 0 ? std::sqrt(root2) : 0;
  exit.distance = std::max(root - b, 0.0L);
  exit.steepness = exit.radius > 0 ? root * std::sqrt(a) / exit.radius : 0;
  exit.hit = along(position, exit.distance, ray);
  return exit;
}

Real solidAngleScaleBox(const Vec& hit, Real t, const Vec& factors, const Vec& ray, const Vec& low, const Vec& high) {
  const Real d = length(hit);
  Real distanceC = 0, cosP = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real share = std::pow(std::min(t / std::max(factors[i], t), 1.0L), 4);
    distanceC += share * (ray[i] < 0 ? -low[i] : high[i]);
    cosP += share * std::abs(ray[i]);
  }
  return bounded(t, d, distanceC / std::max(d, 1.0e-4L * t), cosP);
}

Real solidAngleScaleSphere(const Vec& hit, Real t, const Vec& ray, const Vec& low, const Vec& high) {
  const Vec outwards = minus(hit, centre(low, high));
  const Real size = std::max(length(outwards), 1.0e-9L * t), d = length(hit);
  return bounded(t, d, dot(outwards, hit) / (size * std::max(d, 1.0e-4L * t)), dot(outwards, ray) / size);
}

Real ggxDistribution(const Vec& halfVector, Real alpha) {
  const Real cosine = halfVector[2] / length(halfVector);
  const Real sine2 = (halfVector[0] * halfVector[0] + halfVector[1] * halfVector[1]) / dot(halfVector, halfVector);
  const Real a2 = alpha * alpha;
  const Real q = cosine * cosine * a2 + sine2;
  return a2 / (3.14159265358979323846264338L * q * q);
}

Real ggxMasking(Real cosine, Real alpha) {
  const Real a2 = alpha * alpha;
  return 2 * cosine / (cosine + std::sqrt(a2 + (1 - a2) * cosine * cosine));
}

Real influence(const Vec& position, const Vec& low, const Vec& high, Real rate) {
  Real product = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const Real inside : {position[i] - low[i], high[i] - position[i]}) {
      const Real x = within(inside * rate, 0, 1);
      product *= x * x * (3 - 2 * x);
    }
  }
  return product;
}

Real levelForRoughness(int curve, Real roughness, Real maxLevel) {
  const Real p = within(roughness, 0, 1);
  const Real alpha = p * p;
  switch (curve) {
    case 1:
      return p * (1.7L - 0.7L * p) * maxLevel;
    case 2:
    case 5:
      return p * maxLevel;
    case 3: {
      if (p == 0) return 0;
      const Real exponent = 2 / (alpha * alpha) - 2;  // Blinn-Phong's
      return std::min(std::pow(2 / (exponent / 4 + 2), 0.25L), 1.0L) * maxLevel;
    }
    case 4:
      return std::pow(p, 0.75L) * maxLevel;
    default:
      return std::log2(1 + alpha * (std::exp2(maxLevel) - 1));
  }
}

Real levelApproximate(int curve, Real roughness, Real maxLevel, Real distance, Real hardeningLength) {
  return levelForRoughness(curve, roughness, maxLevel) * within(distance / hardeningLength, 0, 1);
}

Real levelHdrp(int curve, Real roughness, Real maxLevel, Real distance, Real distanceFromOrigin) {
  const Real p = within(roughness, 0, 1);
  const Real ratio = distance < distanceFromOrigin ? distance / distanceFromOrigin : 1;
  const Real sharper = ratio * p;
  return levelForRoughness(curve, sharper + (p - sharper) * p, maxLevel);
}

Real levelGodot(int curve, Real roughness, Real maxLevel, Real distance, Real hardeningLength, Real facing,
                Real power) {
  const Real p = within(roughness, 0, 1);
  const Real fresnel = std::pow(1 - within(facing, 0, 1), power);
  // At most a million lengths: a ray without a hit also has a distance.
  const Real lengths = std::min(distance / hardeningLength, 1.0e6L);
  const Real q = within(lengths * (1 - fresnel) + (1 - fresnel) * p, 0, 1);
  const Real alpha = p * p;
  return alpha * alpha * maxLevel * (1 - q) + levelForRoughness(curve, p, maxLevel) * q;
}

}  // namespace boxprobe::stress::exact
