#include "filters/reference/trace/bright_directions.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

double largest(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

}  // namespace

BrightDirections::BrightDirections(const CubeMap& radiance) {
  const int size = radiance.faceSize();
  if (size < kGroupsAcross) return;
  cells_ = std::min(kMostCells, size);
  across_ = cells_ / kGroupsAcross;
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
  // Twice the mean: walls are below it; lamps and sunlit patches are above.
  cap_ = 2.0 * sum / (6.0 * size * size);
  const auto cellLight = [&](int face, int column, int row) {
    double light = 0.0;
    // With one texel beyond the cell on each side, because interpolation carries its light in.
    for (int y = row * block - 1; y <= (row + 1) * block; ++y) {
      for (int x = column * block - 1; x <= (column + 1) * block; ++x) {
        const double b = brightness(face, std::clamp(x, 0, size - 1), std::clamp(y, 0, size - 1));
        light += std::max(b - cap_, 0.0);
      }
    }
    const double s = 2.0 * column / cells_ - 1.0, t = 2.0 * row / cells_ - 1.0, side = 2.0 / cells_;
    return light * cubeSolidAngle(s, t, s + side, t + side);
  };
  double whole = 0.0;
  for (int square = 0; square < 6 * kGroupsAcross * kGroupsAcross; ++square) {
    const int face = square / (kGroupsAcross * kGroupsAcross);
    const int top = square / kGroupsAcross % kGroupsAcross * across_, left = square % kGroupsAcross * across_;
    Group group;
    for (int k = 0; k < across_ * across_; ++k) {
      const int column = left + k % across_, row = top + k / across_;
      const double light = cellLight(face, column, row);
      const double s = (2.0 * column + 1.0) / cells_ - 1.0, t = (2.0 * row + 1.0) / cells_ - 1.0;
      const glm::vec3 towards = shading::cubeDirection(face, static_cast<float>(s), static_cast<float>(t));
      group.share += light;
      group.middle += light * glm::normalize(glm::dvec3(towards));
      group.cumulated.push_back(group.share);
    }
    groupOf_.push_back(group.share > 0.0 ? static_cast<int>(groups_.size()) : -1);
    if (!(group.share > 0.0)) continue;
    for (double& c : group.cumulated) c /= group.share;
    group.square = static_cast<std::size_t>(square);
    whole += group.share;
    groups_.push_back(std::move(group));
  }
  for (Group& group : groups_) group.share /= whole;
}

glm::dvec3 BrightDirections::excess(const glm::dvec3& radiance) const {
  const double most = largest(radiance);
  return most > cap_ ? radiance * (1.0 - cap_ / most) : glm::dvec3(0.0);
}

glm::dvec3 BrightDirections::sample(std::size_t index, const glm::dvec2& u) const {
  const Group& group = groups_[index];
  const auto cell =
      std::min(static_cast<std::size_t>(std::upper_bound(group.cumulated.begin(), group.cumulated.end(), u.x) -
                                        group.cumulated.begin()),
               group.cumulated.size() - 1);
  const double before = cell > 0 ? group.cumulated[cell - 1] : 0.0, part = group.cumulated[cell] - before;
  const double across = part > 0.0 ? std::clamp((u.x - before) / part, 0.0, 1.0) : 0.5;
  const auto square = static_cast<int>(group.square);
  const int face = square / (kGroupsAcross * kGroupsAcross);
  const int row = square / kGroupsAcross % kGroupsAcross * across_ + static_cast<int>(cell) / across_;
  const int column = square % kGroupsAcross * across_ + static_cast<int>(cell) % across_;
  const double s = 2.0 * (column + across) / cells_ - 1.0, t = 2.0 * (row + u.y) / cells_ - 1.0;
  return glm::dvec3(shading::cubeDirection(face, static_cast<float>(s), static_cast<float>(t)));
}

BrightDirections::Place BrightDirections::at(const glm::dvec3& direction) const {
  const CubePoint p = cubePoint(glm::vec3(direction));
  const auto cell = [this](float x) {
    return std::clamp(static_cast<int>((x + 1.0f) * 0.5f * static_cast<float>(cells_)), 0, cells_ - 1);
  };
  const int column = cell(p.s), row = cell(p.t);
  const int square = (p.face * kGroupsAcross + row / across_) * kGroupsAcross + column / across_;
  const int index = groupOf_[static_cast<std::size_t>(square)];
  if (index < 0) return {};
  const Group& group = groups_[static_cast<std::size_t>(index)];
  const auto k = static_cast<std::size_t>(row % across_ * across_ + column % across_);
  const double share = group.cumulated[k] - (k > 0 ? group.cumulated[k - 1] : 0.0);
  // Uniform over the cell's square of side 2 / cells at distance 1; its solid angle decreases with the cube of the
  // distance.
  const double side = 2.0 / cells_, s = p.s, t = p.t, squared = 1.0 + s * s + t * t;
  return {static_cast<std::size_t>(index), share / (side * side) * squared * std::sqrt(squared)};
}

}  // namespace boxprobe
