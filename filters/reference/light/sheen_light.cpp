#include "filters/reference/light/sheen_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "filters/math/shared/finish_math.h"

namespace boxprobe {

namespace {

constexpr int kSheenCells = 32, kSheenSteps = 96;
constexpr double kPi = 3.14159265358979323846;

bool hasSheen(const SurfacePoint& s) {
  return s.finish && s.finish->hasSheen();
}

double lobe(const glm::dvec3& light, double sine, double cosine, double roughness) {
  const glm::dvec3 h = glm::normalize(light + glm::dvec3(sine, 0.0, cosine));
  return shading::sheenLobe(static_cast<float>(h.z), static_cast<float>(cosine), static_cast<float>(light.z),
                            static_cast<float>(roughness));
}

// Steps are finer near the horizon and near forward scattering, where the lobe is bright.
double integrated(double cosine, double roughness) {
  const double sine = std::sqrt(1.0 - cosine * cosine);
  double sum = 0.0;
  for (int i = 0; i < kSheenSteps; ++i) {
    const double u = (i + 0.5) / kSheenSteps, z = u * u, flat = std::sqrt(1.0 - z * z);
    for (int j = 0; j < kSheenSteps; ++j) {
      const double v = (j + 0.5) / kSheenSteps, turn = kPi * (1.0 - v * v);
      const glm::dvec3 light(flat * std::cos(turn), flat * std::sin(turn), z);
      sum += lobe(light, sine, cosine, roughness) * z * 2.0 * u * 2.0 * v;
    }
  }
  return std::min(2.0 * kPi * sum / (kSheenSteps * kSheenSteps), 1.0);
}

std::vector<double> makeSheenGrid() {
  std::vector<double> grid;
  for (int j = 0; j <= kSheenCells; ++j) {
    for (int i = 0; i <= kSheenCells; ++i) {
      const double x = static_cast<double>(i) / kSheenCells;
      grid.push_back(integrated(std::max(x * x, 1.0e-4), static_cast<double>(j) / kSheenCells));
    }
  }
  return grid;
}

}  // namespace

double sheenShare(double nDotV, double roughness) {
  static const std::vector<double> grid = makeSheenGrid();
  const double x = std::sqrt(std::clamp(nDotV, 0.0, 1.0)) * kSheenCells,
               y = std::clamp(roughness, 0.0, 1.0) * kSheenCells;
  const int i = std::min(static_cast<int>(x), kSheenCells - 1), j = std::min(static_cast<int>(y), kSheenCells - 1);
  const auto at = [&](int column, int row) {
    return grid[static_cast<std::size_t>(row) * (kSheenCells + 1) + static_cast<std::size_t>(column)];
  };
  const double a = x - i, b = y - j;
  return (1.0 - b) * ((1.0 - a) * at(i, j) + a * at(i + 1, j)) + b * ((1.0 - a) * at(i, j + 1) + a * at(i + 1, j + 1));
}

double sheenPasses(const SurfacePoint& s) {
  if (!hasSheen(s)) return 1.0;
  const glm::vec3& c = s.finish->sheenColor;
  const double nDotV = std::max(static_cast<double>(glm::dot(s.normalWorld, s.viewWorld)), 0.0);
  return 1.0 - static_cast<double>(std::max({c.r, c.g, c.b})) *
                   sheenShare(nDotV, static_cast<double>(s.finish->sheenRoughness));
}

glm::dvec3 sheenSent(const SurfacePoint& s, const glm::dvec3& direction) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(s.normalWorld)), view = glm::normalize(glm::dvec3(s.viewWorld));
  const double nDotL = glm::dot(normal, direction), nDotV = std::max(glm::dot(normal, view), 1.0e-5);
  if (!hasSheen(s) || !(nDotL > 0.0)) return glm::dvec3(0.0);
  const glm::dvec3 h = glm::normalize(view + direction);
  const float value =
      shading::sheenLobe(static_cast<float>(std::clamp(glm::dot(normal, h), 0.0, 1.0)), static_cast<float>(nDotV),
                         static_cast<float>(nDotL), s.finish->sheenRoughness);
  return glm::dvec3(s.finish->sheenColor) * (static_cast<double>(value) * nDotL);
}

}  // namespace boxprobe
