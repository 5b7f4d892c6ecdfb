#include "tests/bench/ltc_lobe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

namespace boxprobe::test {

namespace {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;

constexpr double kPi = 3.14159265358979323846;
constexpr int kSide = 40;  // samples of each kind: its square

// Height-correlated Smith GGX times the cosine, for F = 1, and the density of its half vectors drawn by D.
struct Ggx {
  double alpha;
  dvec3 view;

  struct Value {
    double light, density, edge;  // of a direction
  };

  Value at(const dvec3& l) const {
    if (l.z <= 0.0) return {0.0, 0.0, 0.0};
    const dvec3 h = glm::normalize(view + l);
    const double a2 = alpha * alpha, nh = h.z, vh = std::max(glm::dot(view, h), 1.0e-12);
    const double d = nh * nh * (a2 - 1.0) + 1.0, ggx = a2 / (kPi * d * d);
    const auto mask = [a2](double z, double other) { return other * std::sqrt(z * z * (1.0 - a2) + a2); };
    const double visible = 0.5 / (mask(view.z, l.z) + mask(l.z, view.z));
    return {ggx * visible * l.z, ggx * nh / (4.0 * vh), std::pow(1.0 - std::min(vh, 1.0), 5.0)};
  }

  dvec3 drawn(double u, double v) const {
    const double phi = 2.0 * kPi * u, r = alpha * std::sqrt(v / (1.0 - v));
    const dvec3 h = glm::normalize(dvec3(r * std::cos(phi), r * std::sin(phi), 1.0));
    return 2.0 * glm::dot(view, h) * h - view;
  }
};

struct Cosine {
  dmat3 matrix{1.0}, inverse{1.0};
  double determinant = 1.0;

  explicit Cosine(const dmat3& m) : matrix(m), inverse(glm::inverse(m)), determinant(std::abs(glm::determinant(m))) {}
  double density(const dvec3& l) const {
    const dvec3 before = inverse * l;
    const double size = glm::length(before);
    return std::max(before.z / size, 0.0) / kPi / (determinant * size * size * size);
  }
  dvec3 drawn(double u, double v) const {
    const double phi = 2.0 * kPi * u, r = std::sqrt(v);
    return glm::normalize(matrix * dvec3(r * std::cos(phi), r * std::sin(phi), std::sqrt(1.0 - v)));
  }
};

void forSamples(const std::function<void(double, double)>& use) {
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) use((i + 0.5) / kSide, (j + 0.5) / kSide);
  }
}

// The paper's: third powers of the difference, over directions drawn by the one and the other.
double errorOf(const Ggx& lobe, double albedo, const Cosine& cosine) {
  double sum = 0.0;
  const auto add = [&](const dvec3& l) {
    const Ggx::Value value = lobe.at(l);
    const double fitted = cosine.density(l), density = value.density + fitted;
    if (density <= 0.0) return;
    const double off = std::abs(value.light / albedo - fitted);
    sum += off * off * off / density;
  };
  forSamples([&](double u, double v) {
    add(cosine.drawn(u, v));
    add(lobe.drawn(u, v));
  });
  return sum / (kSide * kSide);
}

using Point = std::array<double, 3>;

// Nelder and Mead 1965.
Point smallest(const std::function<double(const Point&)>& f, const Point& start, double step) {
  struct Corner {
    Point at;
    double value;
  };
  std::vector<Corner> corners{{start, f(start)}};
  for (std::size_t i = 0; i < start.size(); ++i) {
    Point moved = start;
    moved[i] += step;
    corners.push_back({moved, f(moved)});
  }
  const auto mixed = [](const Point& a, const Point& b, double t) {
    Point result{};
    for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] + t * (b[i] - a[i]);
    return result;
  };
  for (int turn = 0; turn < 150; ++turn) {
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.value < b.value; });
    if (corners.back().value - corners.front().value < 1.0e-9 * corners.front().value) break;
    Point middle{};
    for (std::size_t c = 0; c + 1 < corners.size(); ++c) {
      for (std::size_t i = 0; i < middle.size(); ++i) middle[i] += corners[c].at[i] / 3.0;
    }
    Corner& worst = corners.back();
    const auto tried = [&](double t) {
      const Point at = mixed(middle, worst.at, t);
      return Corner{at, f(at)};
    };
    const Corner mirrored = tried(-1.0);
    if (mirrored.value < corners.front().value) {
      const Corner further = tried(-2.0);
      worst = further.value < mirrored.value ? further : mirrored;
    } else if (mirrored.value < corners[corners.size() - 2].value) {
      worst = mirrored;
    } else {
      const Corner nearer = tried(mirrored.value < worst.value ? -0.5 : 0.5);
      if (nearer.value < worst.value) {
        worst = nearer;
      } else {
        for (std::size_t c = 1; c < corners.size(); ++c) {
          corners[c].at = mixed(corners[0].at, corners[c].at, 0.5);
          corners[c].value = f(corners[c].at);
        }
      }
    }
  }
  return std::min_element(corners.begin(), corners.end(),
                          [](const Corner& a, const Corner& b) { return a.value < b.value; })
      ->at;
}

// Around the lobe's mean direction: widths along and across, and a shear.
dmat3 matrixOf(const dvec3& mean, const Point& p) {
  const dmat3 turned(dvec3(mean.z, 0.0, -mean.x), dvec3(0.0, 1.0, 0.0), mean);
  const dmat3 shape(dvec3(std::max(p[0], 1.0e-5), 0.0, 0.0), dvec3(0.0, std::max(p[1], 1.0e-5), 0.0),
                    dvec3(p[2], 0.0, 1.0));
  return turned * shape;
}

}  // namespace

dvec2 LtcLobe::glossy(const LampCase& lamp) const {
  const dvec3 normal(lamp.normal), view(lamp.view);
  const dvec3 tangent = glm::normalize(view - normal * glm::dot(normal, view)), other = glm::cross(normal, tangent);
  std::vector<dvec3> corners, kept;
  for (const LongVec& corner : lamp.corners) {
    const dvec3 p(corner);
    corners.push_back(inverse * dvec3(glm::dot(p, tangent), glm::dot(p, other), glm::dot(p, normal)));
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if (a.z >= 0.0) kept.push_back(a);
    if ((a.z >= 0.0) != (b.z >= 0.0)) kept.push_back(a + (b - a) * (a.z / (a.z - b.z)));
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const dvec3 &a = kept[i], &b = kept[(i + 1) % kept.size()], c = glm::cross(a, b);
    const double sine = glm::length(c);
    if (sine > 0.0) sum += std::atan2(sine, glm::dot(a, b)) * c.z / sine;
  }
  return std::abs(sum) / (2.0 * kPi) * albedo;
}

LtcLobe fitLtc(double roughness, double elevation) {
  const double alpha = roughness * roughness, last = 0.5 * kPi - elevation;
  const int steps = std::max(1, static_cast<int>(std::ceil(last / 0.06)));
  Point shape{std::max(alpha, 0.01), std::max(alpha, 0.01), 0.0};
  LtcLobe result;
  // From straight above to the angle asked for, each fit beginning with the one before, as the paper fits its table.
  for (int i = 0; i <= steps; ++i) {
    const double angle = last * i / steps;
    const Ggx lobe{alpha, {std::sin(angle), 0.0, std::cos(angle)}};
    dvec2 albedo(0.0);
    dvec3 mean(0.0);
    forSamples([&](double u, double v) {
      const dvec3 l = lobe.drawn(u, v);
      const Ggx::Value value = lobe.at(l);
      if (value.density <= 0.0) return;
      const double weight = value.light / value.density / (kSide * kSide);
      albedo += weight * dvec2(1.0 - value.edge, value.edge);
      mean += weight * l;
    });
    mean.y = 0.0;
    mean = i == 0 ? dvec3(0.0, 0.0, 1.0) : glm::normalize(mean);
    const auto error = [&](const Point& p) { return errorOf(lobe, albedo.x + albedo.y, Cosine(matrixOf(mean, p))); };
    shape = smallest(error, shape, 0.05);
    if (i == 0) {
      shape[0] = shape[1] = 0.5 * (shape[0] + shape[1]);
      shape[2] = 0.0;
    }
    result = {glm::inverse(matrixOf(mean, shape)), albedo, error(shape)};
  }
  return result;
}

}  // namespace boxprobe::test
