#include "tests/support/lamp_truth.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

namespace boxprobe::test {

namespace {

using Real = long double;
using Integrand = std::function<glm::vec<2, Real>(const LongVec&)>;
using Pair = glm::vec<2, Real>;

constexpr Real kPi = 3.14159265358979323846264338L;

struct Triangle {
  LongVec a, b, c;
};

// Radon's rule of seven points, exact for polynomials of degree five (Radon 1948).
Pair rule(const Triangle& t, const Integrand& f) {
  const Real root = std::sqrt(15.0L);
  const Real near = (6.0L - root) / 21.0L, far = (6.0L + root) / 21.0L;
  const Real weightNear = (155.0L - root) / 1200.0L, weightFar = (155.0L + root) / 1200.0L;
  const auto at = [&](Real u, Real v) { return f(t.a + u * (t.b - t.a) + v * (t.c - t.a)); };
  Pair sum = at(1.0L / 3, 1.0L / 3) * (9.0L / 40.0L);
  for (const auto& [place, weight] : {std::pair{near, weightNear}, std::pair{far, weightFar}}) {
    sum += weight * (at(place, place) + at(1.0L - 2.0L * place, place) + at(place, 1.0L - 2.0L * place));
  }
  return sum * (0.5L * glm::length(glm::cross(t.b - t.a, t.c - t.a)));
}

Real sizeOf(const Pair& p) {
  return std::abs(p.x) + std::abs(p.y);
}

Pair integrate(const Triangle& t, const Integrand& f, Real tolerance, int depth) {
  const LongVec ab = 0.5L * (t.a + t.b), bc = 0.5L * (t.b + t.c), ca = 0.5L * (t.c + t.a);
  const Triangle parts[4] = {{t.a, ab, ca}, {ab, t.b, bc}, {ca, bc, t.c}, {ab, bc, ca}};
  const Real longest = std::max({glm::length(t.b - t.a), glm::length(t.c - t.b), glm::length(t.a - t.c)});
  const Real distance = glm::length((t.a + t.b + t.c) / 3.0L);
  Pair sum(0.0L);
  if (depth >= 4 && longest < distance) {
    const Pair whole = rule(t, f);
    for (const Triangle& part : parts) sum += rule(part, f);
    if (sizeOf(sum - whole) <= tolerance || depth >= 14) return sum;
  } else if (depth >= 30) {
    return rule(t, f);
  }
  sum = Pair(0.0L);
  for (const Triangle& part : parts) sum += integrate(part, f, tolerance, depth + 1);
  return sum;
}

// `tolerance`: of a triangle, over the whole.
Pair overPolygon(const std::vector<LongVec>& corners, Real tolerance, const Integrand& radiant) {
  LongVec area(0.0L);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    area += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  const LongVec n = area / glm::length(area);
  // Per area instead of per solid angle.
  const Integrand f = [&](const LongVec& p) {
    const Real r2 = glm::dot(p, p), r = std::sqrt(r2);
    return radiant(p / r) * (std::abs(glm::dot(n, p)) / (r2 * r));
  };
  Pair rough(0.0L), sum(0.0L);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    rough += integrate({corners[0], corners[i], corners[i + 1]}, f, 1.0e-2L, 2);
  }
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += integrate({corners[0], corners[i], corners[i + 1]}, f, tolerance * sizeOf(rough) + 1.0e-15L, 0);
  }
  return sum;
}

// As a polygon holds it: what single precision rounds away is not its light's error.
LongVec rounded(const LongVec& p) {
  return LongVec(glm::vec3(p));
}

LongVec direction(std::mt19937& random) {
  std::normal_distribution<double> gauss;
  const glm::dvec3 d = glm::normalize(glm::dvec3(gauss(random), gauss(random), gauss(random)));
  return glm::normalize(LongVec(d));
}

}  // namespace

LampPolygon LampCase::polygon() const {
  LampPolygon lamp;
  lamp.count = static_cast<int>(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) lamp.corners[i] = glm::vec3(corners[i]);
  return lamp;
}

long double trueFormFactor(const std::vector<LongVec>& corners, const LongVec& normal) {
  return overPolygon(corners, 1.0e-7L,
                     [&](const LongVec& l) { return Pair(std::max(glm::dot(l, normal), 0.0L) / kPi, 0.0L); })
      .x;
}

glm::dvec2 trueGlossy(const LampCase& lamp, double roughness) {
  const Real alpha = static_cast<Real>(roughness) * static_cast<Real>(roughness), a2 = alpha * alpha;
  const Real nv = glm::dot(lamp.normal, lamp.view);
  const auto f = [&](const LongVec& l) {
    const Real nl = glm::dot(lamp.normal, l);
    if (nl <= 0.0L || nv <= 0.0L) return Pair(0.0L);
    const LongVec h = glm::normalize(lamp.view + l);
    const Real nh = glm::dot(lamp.normal, h), vh = glm::dot(lamp.view, h);
    const Real d = nh * nh * (a2 - 1.0L) + 1.0L, ggx = a2 / (kPi * d * d);
    const Real visible =
        0.5L / (nl * std::sqrt(nv * nv * (1.0L - a2) + a2) + nv * std::sqrt(nl * nl * (1.0L - a2) + a2));
    const Real edge = std::pow(std::max(1.0L - vh, 0.0L), 5.0L), light = ggx * visible * nl;
    return Pair(light * (1.0L - edge), light * edge);
  };
  return glm::dvec2(overPolygon(lamp.corners, 1.0e-5L, f));
}

LampCase randomFloorLamp(std::mt19937& random, double elevation) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto in = [&](double a, double b) { return a + (b - a) * unit(random); };
  const glm::dvec3 view(std::cos(elevation), 0.0, std::sin(elevation));
  const double width = in(0.2, 1.5), depth = in(0.2, 1.5);
  glm::dvec3 middle, u, v;
  if (unit(random) < 0.5) {  // in the ceiling
    const double height = in(0.6, 2.8);
    middle = {std::max(-height / std::tan(elevation) * in(0.3, 1.8), -8.0), in(-0.75, 0.75) * height, height};
    u = {0.0, width / 2, 0.0};
    v = {depth / 2, 0.0, 0.0};
  } else {  // in a wall
    const double away = in(1.0, 6.0);
    middle = {-away, in(-1.5, 1.5), std::min(2.5, away * std::tan(elevation) * in(0.3, 1.8))};
    u = {0.0, width / 2, 0.0};
    v = {0.0, 0.0, depth / 2};
  }
  // Counterclockwise as the origin sees it, and all of it turned away from the axes.
  const LongVec n = direction(random), t = glm::normalize(glm::cross(n, direction(random))), b = glm::cross(n, t);
  const auto turned = [&](const glm::dvec3& p) {
    return static_cast<Real>(p.x) * t + static_cast<Real>(p.y) * b + static_cast<Real>(p.z) * n;
  };
  if (glm::dot(glm::cross(u, v), middle) > 0.0) std::swap(u, v);
  LampCase lamp;
  for (const glm::dvec3& corner : {middle - u - v, middle + u - v, middle + u + v, middle - u + v}) {
    lamp.corners.push_back(rounded(turned(corner)));
  }
  lamp.normal = n;
  lamp.view = glm::normalize(turned(view));
  return lamp;
}

LampCase randomPolygon(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  LampCase lamp;
  lamp.normal = direction(random);
  lamp.view = direction(random);
  if (glm::dot(lamp.view, lamp.normal) < 0.0L) lamp.view = -lamp.view;
  const LongVec middle = direction(random) * static_cast<Real>(0.7 + 0.6 * unit(random));
  // A plane that does not pass near the origin: its own tests do that.
  LongVec n = direction(random);
  while (std::abs(glm::dot(n, middle)) < 0.05L) n = direction(random);
  if (glm::dot(n, middle) > 0.0L) n = -n;
  const LongVec t = glm::normalize(glm::cross(n, direction(random))), b = glm::cross(n, t);
  const int count = 3 + static_cast<int>(unit(random) * 6.0);
  std::vector<double> angles;
  while (static_cast<int>(angles.size()) < count) {
    const double angle = 2.0 * 3.14159265358979 * unit(random);
    if (std::all_of(angles.begin(), angles.end(), [&](double a) { return std::abs(a - angle) > 0.05; })) {
      angles.push_back(angle);
    }
  }
  std::sort(angles.begin(), angles.end());
  const double flat = 0.2 + 0.8 * unit(random);
  for (const double angle : angles) {
    const Real x = static_cast<Real>(0.5 * size * std::cos(angle)),
               y = static_cast<Real>(0.5 * size * flat * std::sin(angle));
    lamp.corners.push_back(rounded(middle + x * t + y * b));
  }
  return lamp;
}

}  // namespace boxprobe::test
