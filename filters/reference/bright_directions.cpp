#include "filters/reference/bright_directions.h"

#include <algorithm>
#include <cmath>

namespace boxprobe {

namespace {

double largest(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

}  // namespace

BrightDirections::BrightDirections(const CubeMap& radiance) {
  const int size = radiance.faceSize();
  cells_ = std::min(kMostCells, size);
  const int block = size / cells_;
  const auto brightness = [&](int face, int column, int row) {
    return largest(glm::dvec3(radiance.texel(0, face, column, row)));
  };
  double sum = 0.0;
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) sum += brightness(face, column, row);
    }
  }
  // Twice the mean: walls stay below it, a lamp or a sunlit patch does not.
  cap_ = 2.0 * sum / (6.0 * size * size);
  std::vector<double> shares;
  double whole = 0.0;
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < cells_; ++row) {
      for (int column = 0; column < cells_; ++column) {
        double cell = 0.0;
        // One texel beyond the cell on each side: interpolation carries its light in.
        for (int y = row * block - 1; y <= (row + 1) * block; ++y) {
          for (int x = column * block - 1; x <= (column + 1) * block; ++x) {
            const double b = brightness(face, std::clamp(x, 0, size - 1), std::clamp(y, 0, size - 1));
            cell += std::max(b - cap_, 0.0);
          }
        }
        const double s0 = 2.0 * column / cells_ - 1.0, t0 = 2.0 * row / cells_ - 1.0, side = 2.0 / cells_;
        shares.push_back(cell * cubeSolidAngle(s0, t0, s0 + side, t0 + side));
        whole += shares.back();
      }
    }
  }
  if (!(whole > 0.0)) return;
  double before = 0.0;
  for (double& share : shares) {
    share /= whole;
    cumulated_.push_back(before);
    before += share;
  }
  shares_ = std::move(shares);
}

glm::dvec3 BrightDirections::excess(const glm::dvec3& radiance) const {
  const double most = largest(radiance);
  return most > cap_ ? radiance * (1.0 - cap_ / most) : glm::dvec3(0.0);
}

glm::dvec3 BrightDirections::sample(const glm::dvec2& u) const {
  // The last cell that begins at or before u; of cells without a share, which begin where the next does, the next.
  const auto after = std::upper_bound(cumulated_.begin(), cumulated_.end(), u.x);
  auto cell = static_cast<std::size_t>(after - cumulated_.begin()) - 1;
  while (cell > 0 && shares_[cell] <= 0.0) --cell;
  const double across = std::clamp((u.x - cumulated_[cell]) / std::max(shares_[cell], 1e-300), 0.0, 1.0);
  const auto index = static_cast<int>(cell), face = index / (cells_ * cells_);
  const int row = index / cells_ % cells_, column = index % cells_;
  const double s = 2.0 * (column + across) / cells_ - 1.0, t = 2.0 * (row + u.y) / cells_ - 1.0;
  return glm::dvec3(shading::cubeDirection(face, static_cast<float>(s), static_cast<float>(t)));
}

double BrightDirections::density(const glm::dvec3& direction) const {
  const CubePoint p = cubePoint(glm::vec3(direction));
  const auto cell = [this](float x) {
    return std::clamp(static_cast<int>((x + 1.0f) * 0.5f * static_cast<float>(cells_)), 0, cells_ - 1);
  };
  const auto index = static_cast<std::size_t>((p.face * cells_ + cell(p.t)) * cells_ + cell(p.s));
  // Even over the cell's square of side 2 / cells at distance 1: a solid angle there is smaller by the cube of the
  // distance.
  const double side = 2.0 / cells_, s = p.s, t = p.t, square = 1.0 + s * s + t * t;
  return shares_[index] / (side * side) * square * std::sqrt(square);
}

}  // namespace boxprobe
