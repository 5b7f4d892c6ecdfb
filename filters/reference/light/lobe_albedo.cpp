#include "filters/reference/light/lobe_albedo.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "filters/reference/trace/visible_normal_lobe.h"

namespace boxprobe {

namespace {

constexpr int kCells = 64, kRays = 512;

// Over the root of N.V and roughness, including both ends.
std::vector<glm::dvec2> makeGrid() {
  std::vector<glm::dvec2> grid;
  const ShiftedPoints points(1);
  for (int j = 0; j <= kCells; ++j) {
    const double roughness = static_cast<double>(j) / kCells;
    for (int i = 0; i <= kCells; ++i) {
      const double across = static_cast<double>(i) / kCells, c = std::max(across * across, 1.0e-6);
      const VisibleNormalLobe lobe({0.0, 0.0, 1.0}, {std::sqrt(1.0 - c * c), 0.0, c}, roughness * roughness);
      glm::dvec2 sum(0.0);
      for (int k = 0; k < kRays; ++k) {
        const VisibleNormalLobe::Sample s = lobe.sample(points[k]);
        const double fresnel = std::pow(1.0 - s.hDotV, 5.0);
        if (s.weight > 0.0) sum += s.weight * glm::dvec2(1.0 - fresnel, fresnel);
      }
      grid.push_back(sum / static_cast<double>(kRays));
    }
  }
  return grid;
}

}  // namespace

glm::dvec2 lobeAlbedo(double nDotV, double roughness) {
  static const std::vector<glm::dvec2> grid = makeGrid();
  const double x = std::sqrt(std::clamp(nDotV, 0.0, 1.0)) * kCells, y = std::clamp(roughness, 0.0, 1.0) * kCells;
  const int i = std::min(static_cast<int>(x), kCells - 1), j = std::min(static_cast<int>(y), kCells - 1);
  const double a = x - i, b = y - j;
  const auto at = [&](int column, int row) {
    return grid[static_cast<std::size_t>(row) * (kCells + 1) + static_cast<std::size_t>(column)];
  };
  return (1.0 - b) * ((1.0 - a) * at(i, j) + a * at(i + 1, j)) + b * ((1.0 - a) * at(i, j + 1) + a * at(i + 1, j + 1));
}

glm::dvec3 multipleScatteringFactor(const glm::dvec3& f0, double nDotV, double roughness) {
  const glm::dvec2 white = lobeAlbedo(std::max(nDotV, 1.0e-5), roughness);
  return 1.0 + f0 * (1.0 / (white.x + white.y) - 1.0);
}

}  // namespace boxprobe
