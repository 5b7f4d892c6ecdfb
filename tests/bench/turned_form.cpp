#include "tests/bench/turned_form.h"

#include <cmath>
#include <cstdio>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "filters/math/shared/footprint_turned.h"

namespace boxprobe::bench {

namespace {

using Constants = std::vector<double>;

// What is fitted are values at these roughnesses, which decide little about each other; the shader has the powers.
constexpr double kFour[] = {0.1, 0.35, 0.65, 1.0}, kThree[] = {0.1, 0.45, 1.0}, kTwo[] = {0.1, 1.0};

// As they stand in the shader; a fit found to more digits than it has is an error of another kind.
double rounded(double x) {
  return std::round(x * 1000.0) / 1000.0;
}

// Lagrange's polynomial through values at nodes: the factors of its powers.
template <std::size_t N>
std::array<double, N> powersThrough(const double (&nodes)[N], const double* values, double scale) {
  std::array<double, N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    std::array<double, N> powers{};
    powers[0] = scale * values[i];
    for (std::size_t j = 0; j < N; ++j) {
      if (j == i) continue;
      for (std::size_t k = N; k-- > 0;) {
        powers[k] = ((k > 0 ? powers[k - 1] : 0.0) - nodes[j] * powers[k]) / (nodes[i] - nodes[j]);
      }
    }
    for (std::size_t k = 0; k < N; ++k) result[k] += powers[k];
  }
  for (double& x : result) x = rounded(x);
  return result;
}

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3ff", x == 0.0 ? 0.0 : x);
  return text;
}

glm::vec4 cubic(const double* values, double scale = 1.0) {
  const auto p = powersThrough(kFour, values, scale);
  return {p[0], p[1], p[2], p[3]};
}

glm::vec3 quadratic(const double* values, double scale = 1.0) {
  const auto p = powersThrough(kThree, values, scale);
  return {p[0], p[1], p[2]};
}

template <typename Vector>
std::string text(const Vector& v) {
  std::string result = "vec" + std::to_string(v.length()) + "(";
  for (int i = 0; i < v.length(); ++i) result += (i > 0 ? ", " : "") + number(static_cast<double>(v[i]));
  return result + ")";
}

// By roughness at four nodes; times eccentricity and times N.V at three.
constexpr std::size_t kConstant = 10;
struct Constant {
  glm::vec4 constants;
  glm::vec3 byAxes, byView;

  explicit Constant(const double* c, double scale = 1.0)
      : constants(cubic(c, scale)), byAxes(quadratic(c + 4, scale)), byView(quadratic(c + 7, scale)) {}
  float at(const shading::FootprintLobe& lobe, const glm::vec3& axes, const glm::vec4& powers) const {
    return shading::footprintConstant(lobe, axes, powers, constants, byAxes, byView);
  }
  std::string shader(const std::string& margin) const {
    return "footprintConstant(lobe, axes, p, " + text(constants) + ",\n" + margin + text(byAxes) + ", " + text(byView) +
           ")";
  }
};

// Logarithms are fitted with base e and stand in the shader with base 2.
const double kBaseTwo = 1.0 / std::log(2.0);

struct Pair {
  Constant x, y;
  glm::vec4 weight, size;
};
constexpr std::size_t kPair = 2 * kConstant + 8;

// Constants: size (its logarithm) and the shorter axis' power at two nodes; shift; nearer; then of each pair x, y,
// weight and size (logarithms).
struct TurnedLookups {
  Constant size;
  float narrowing, narrowingP;
  Constant shift;
  glm::vec4 nearer;
  std::vector<Pair> pairs;

  TurnedLookups(int lookups, const Constants& c)
      : size(c.data(), kBaseTwo), shift(&c[kConstant + 2]), nearer(cubic(&c[2 * kConstant + 2], -1.0)) {
    const auto p = powersThrough(kTwo, &c[kConstant], 1.0);
    narrowing = static_cast<float>(p[0]), narrowingP = static_cast<float>(p[1]);
    const double* at = &c[2 * kConstant + 6];
    const double* first = at + 2 * kConstant;  // weights are relative to the first pair's
    for (int i = 0; i < lookups / 2; ++i, at += kPair) {
      double weights[4];
      for (int k = 0; k < 4; ++k) weights[k] = at[2 * kConstant + static_cast<std::size_t>(k)] - first[k];
      pairs.push_back(
          {Constant(at), Constant(at + kConstant), cubic(weights, kBaseTwo), cubic(at + 2 * kConstant + 4, kBaseTwo)});
    }
  }
  glm::dvec3 operator()(const study::RoomPoint& at) const {
    shading::FootprintLobe lobe = shading::footprintLobe(at.point, 1.0f);
    const glm::vec3 axes = shading::footprintAxes(at.probe, at.point, lobe);
    const glm::vec4 p = shading::footprintPowers(at.point);
    lobe.size *= shading::footprintTurnedSize(axes, size.at(lobe, axes, p), narrowing + narrowingP * p.y);
    lobe.shift = lobe.view.x * shift.at(lobe, axes, p);
    const float aimed = lobe.alpha * glm::dot(p, nearer);
    shading::FootprintSum sum = shading::footprintStart();
    for (const Pair& q : pairs) {
      sum = shading::footprintAddTurned(at.chain, at.probe, at.point, lobe, axes, sum, q.x.at(lobe, axes, p),
                                        q.y.at(lobe, axes, p), glm::dot(p, q.weight), glm::dot(p, q.size), aimed);
    }
    return glm::dvec3(sum.value / sum.weight);
  }
  std::string shader() const {
    const std::string margin(10, ' ');
    std::string all =
        "  FootprintLobe lobe = footprintLobe(point, 1.0f);\n"
        "  vec3 axes = footprintAxes(probe, point, lobe);\n"
        "  vec4 p = footprintPowers(point);\n"
        "  float size = " +
        size.shader(margin) + ";\n  lobe.size = lobe.size * footprintTurnedSize(axes, size, " +
        number(static_cast<double>(narrowing)) + " + (" + number(static_cast<double>(narrowingP)) +
        ") * p.y);\n  lobe.shift = lobe.view.x * " + shift.shader(margin) + ";\n  float nearer = lobe.alpha * dot(p, " +
        text(nearer) + ");\n  FootprintSum sum = footprintStart();\n";
    for (const Pair& q : pairs) {
      all += "  sum = footprintAddTurned(map, probe, point, lobe, axes, sum,\n" + margin + q.x.shader(margin) + ",\n" +
             margin + q.y.shader(margin) + ",\n" + margin + "dot(p, " + text(q.weight) + "), dot(p, " + text(q.size) +
             "), nearer);\n";
    }
    return all + "  return sum.value / sum.weight;\n";
  }
};

// What the data does not decide stays at 0.
Constants plainOf(const Constants& c) {
  constexpr double kNodes = 0.0015, kSlopes = 0.004;
  Constants result;
  const auto add = [&](std::size_t count, double weight) {
    for (std::size_t i = 0; i < count; ++i) result.push_back(weight * c[result.size()]);
  };
  add(4, kNodes), add(8, kSlopes);
  add(4, kNodes), add(6, kSlopes);
  add(4, kNodes);
  while (result.size() < c.size()) {
    for (int i = 0; i < 2; ++i) add(4, kNodes), add(6, kSlopes);
    add(8, kNodes);
  }
  return result;
}

}  // namespace

FootprintForm turnedForm(int lookups) {
  return {turnedStart(lookups), [lookups](const Constants& c) { return study::Technique(TurnedLookups(lookups, c)); },
          plainOf, [lookups](const Constants& c) { return TurnedLookups(lookups, c).shader(); }};
}

}  // namespace boxprobe::bench
