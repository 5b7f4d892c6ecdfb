#include "filters/math/sampling/brdf_integral.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace boxprobe {

namespace {

constexpr double kHalfTurn = 3.14159265358979323846;

struct Node {
  double at, weight;  // within [0, 1]
};

// Zeros of the Legendre polynomial of degree `count`, by Newton's method.
std::vector<Node> gaussLegendre(int count) {
  std::vector<Node> nodes;
  for (int i = 0; i < count; ++i) {
    double x = std::cos(kHalfTurn * (i + 0.75) / (count + 0.5)), slope = 1.0;
    for (int step = 0; step < 50; ++step) {
      double value = 1.0, before = 0.0;
      for (int n = 1; n <= count; ++n) {
        const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
        before = value;
        value = next;
      }
      slope = count * (x * value - before) / (x * x - 1.0);
      const double change = value / slope;
      x -= change;
      if (std::abs(change) < 1.0e-15) break;
    }
    nodes.push_back({0.5 * (x + 1.0), 1.0 / ((1.0 - x * x) * slope * slope)});
  }
  return nodes;
}

}  // namespace

glm::dvec2 integrateBrdf(double cosine, double roughness, int points) {
  static thread_local std::vector<Node> nodes;
  if (static_cast<int>(nodes.size()) != points) nodes = gaussLegendre(points);
  // A mirror's lobe is a point: below this width only rounding changes.
  const double alpha = std::max(roughness * roughness, 1.0e-7), a2 = alpha * alpha;
  const double c = std::clamp(cosine, 1.0e-7, 1.0), sine = std::sqrt(1.0 - c * c);
  const auto root = [a2](double x) { return std::sqrt(a2 + (1.0 - a2) * x * x); };
  const double viewRoot = root(c);
  // Half vectors by s: tan² of the angle to the normal is alpha² u / (1 - u), where u is the share of half vectors
  // within that angle and 1 - u = (1 - s)². From the first limiting angle on, some of the directions mirrored in half
  // vectors lie below the surface; from the second on, all do.
  const auto place = [alpha](double angle) {
    const double t = std::tan(angle) / alpha;
    return 1.0 - 1.0 / std::sqrt(1.0 + t * t);
  };
  const double view = std::acos(c),
               ends[] = {0.0, place(0.25 * kHalfTurn - 0.5 * view), place(0.25 * kHalfTurn + 0.5 * view)};
  glm::dvec2 sum(0.0);
  for (int part = 0; part < 2; ++part) {
    const double width = ends[part + 1] - ends[part];
    for (const Node& out : nodes) {
      const double s = ends[part] + width * out.at, tangent = alpha * std::sqrt(s * (2.0 - s)) / (1.0 - s);
      const double z = 1.0 / std::sqrt(1.0 + tangent * tangent), r = z * tangent;
      // The azimuth up to which the mirrored direction is above the surface; both sides are symmetric.
      const double limit = r * sine > 0.0 ? (0.5 * c / z - z * c) / (r * sine) : -1.0;
      const double most = std::acos(std::clamp(limit, -1.0, 1.0));
      for (const Node& turn : nodes) {
        const double viewHalf = r * sine * std::cos(most * turn.at) + z * c, light = 2.0 * viewHalf * z - c;
        if (!(light > 0.0)) continue;
        // D G2 / (4 N.V) divided by the half vectors' density, D N.H / (4 H.V) per direction.
        const double value = viewHalf / (c * z) * 2.0 * c * light / (c * root(light) + light * viewRoot);
        const double grazing = 1.0 - std::min(viewHalf, 1.0), grazing2 = grazing * grazing;
        const double fresnel = grazing2 * grazing2 * grazing;
        const double weight = width * out.weight * 2.0 * (1.0 - s) * turn.weight * most / kHalfTurn;
        sum += weight * value * glm::dvec2(1.0 - fresnel, fresnel);
      }
    }
  }
  return sum;
}

}  // namespace boxprobe
